"""Parallel leaf-spring stage: printed numbers and a beam assembly."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.stage import end_stress, shortening, translational_stiffness

ROUNDING = 1e-12
STEEL = {"E": 200e9, "h": 300e-6, "l": 50e-3}  # exercise 12 A
sizes = st.floats(1e-5, 1.0)


def test_stiffness_frequency_and_sag_of_exercise_12_a_are_the_printed_ones():
    K = translational_stiffness(b=10e-3, **STEEL)
    assert pytest.approx(864.0, abs=0.5) == K
    assert np.sqrt(K / 1.0) / (2 * np.pi) == pytest.approx(4.68, abs=0.005)
    assert pytest.approx(11.4, abs=0.05) == 9.81 / K * 1e3


def test_stroke_at_the_admissible_stress_is_the_lectures():
    # lecture, admissible stroke calculation: x = σ l²/(3 E h)
    sigma = 400e6
    stroke = sigma * STEEL["l"] ** 2 / (3 * STEEL["E"] * STEEL["h"])
    assert end_stress(x=stroke, **STEEL) == pytest.approx(sigma, rel=ROUNDING)


def test_a_clamped_guided_beam_gives_the_stiffness_and_the_end_moment():
    # slope-deflection: the guided end shifts by x without turning, so M = 6EIx/l², F = 2M/l
    E, h, l, b, x = 200e9, 3e-4, 0.05, 0.01, 1e-3
    bending = E * b * h**3 / 12
    K = bending / l**3 * np.array([[12, 6 * l], [6 * l, 4 * l**2]])
    force, moment = K @ np.array([x, 0.0])
    assert 2 * force / x == pytest.approx(translational_stiffness(E=E, h=h, l=l, b=b), rel=ROUNDING)
    assert end_stress(E=E, h=h, l=l, x=x) == pytest.approx(moment / (b * h**2 / 6), rel=ROUNDING)


def test_shortening_is_the_integral_of_half_the_slope_squared():
    # the blade is the cubic x(3s² − 2s³); three-point Gauss is exact for its squared slope
    nodes, weights = np.polynomial.legendre.leggauss(3)
    s, w = (nodes + 1) / 2, weights / 2
    l, x = 0.05, 2e-3
    slope = x / l * (6 * s - 6 * s**2)
    assert shortening(l=l, x=x) == pytest.approx(l * (w @ slope**2) / 2, rel=ROUNDING)


@given(st.lists(st.tuples(sizes, sizes, sizes), min_size=1, max_size=5))
def test_arrays_agree_with_element_wise_calls(rows):
    h, l, b = np.array(rows).T
    whole = translational_stiffness(E=1.0, h=h, l=l, b=b, blades=4)
    single = [translational_stiffness(E=1.0, h=x, l=y, b=z, blades=4) for x, y, z in rows]
    assert whole == pytest.approx(single, rel=ROUNDING)


@given(n=st.integers(1, 100), h=sizes, l=sizes, b=sizes)
def test_stiffness_is_that_of_one_blade_times_their_number(n, h, l, b):
    one = translational_stiffness(E=1.0, h=h, l=l, b=b, blades=1)
    many = translational_stiffness(E=1.0, h=h, l=l, b=b, blades=n)
    assert many == pytest.approx(n * one, rel=ROUNDING)
