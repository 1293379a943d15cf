"""Pi terms: printed screen, and that they do not see the units."""

from math import sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.handbook.stop_numbers import pi_terms

positive = st.floats(1e-3, 1e3)
CASE = {"m": 9.96e-3, "k_free": 22.9e3, "k_contact": 229e3, "delta_G": 1e-5}
CASE |= {"f_D": 100.0, "delta_D": 1e-6, "f_O": 101.0, "delta_O": 5e-5}
DIMENSIONS = {  # exponents of mass, length, time
    "m": (1, 0, 0), "k_free": (1, 0, -2), "k_contact": (1, 0, -2), "delta_G": (0, 1, 0),
    "f_D": (0, 0, -1), "delta_D": (0, 1, 0), "f_O": (0, 0, -1), "delta_O": (0, 1, 0),
}  # fmt: skip


@given(positive, positive, positive)
def test_terms_do_not_see_the_units(mass, length, time):
    scaled = {
        name: value * mass**p * length**q * time**r
        for (name, value), (p, q, r) in zip(CASE.items(), DIMENSIONS.values(), strict=True)
    }
    assert pi_terms(**scaled) == pytest.approx(pi_terms(**CASE), rel=1e-12)


def test_screen_of_the_test_bench_mixes_units():
    # section 7.2: π4/π2 is f_O/f_D; √(m/k) is 1.821e-3 s in SI and 1.821 in √(g mm/N)
    screen = sqrt(15.35 / 4.62933)
    ours = pi_terms(**{**CASE, "m": 15.35e-3, "k_free": 4629.33})
    assert screen / (ours.pi_2 / CASE["f_D"]) == pytest.approx(1000.0, rel=1e-12)
