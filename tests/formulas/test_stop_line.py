"""The operating line at work: the worked example's gaps and heights, and its wrong intersection."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq

from flexcli.formulas.pi_law import contact_threshold, operating_line
from flexcli.formulas.stop_line import REACHED, allowed_travel, line_gap, line_height
from flexcli.formulas.stop_stiffness import (
    bent_shape,
    contact_stiffness,
    free_stiffness,
    stiffness_ratio,
)

# Monti (2014), section 9.1: L and E are printed; b and h are found from the printed 27.7 MPa,
# 56.3 N·mm and 9.87 N/mm
L, E, WIDTH, THICKNESS = 28.5e-3, 60e9, 7.8e-3, 1.25e-3
I = WIDTH * THICKNESS**3 / 12
RANGE = 200e-6


def gap_at(L_a):
    return line_gap(L_a=L_a, L_b=L - L_a, delta_O=RANGE)


def test_travel_and_stiffness_are_the_printed_ones():
    # 200 µm, 9.87 N/mm
    travel = allowed_travel(E=E, h=THICKNESS, L=L, sigma=27.7e6)
    assert travel == pytest.approx(200e-6, abs=0.5e-6)
    assert free_stiffness(E=E, I=I, L=L) == pytest.approx(9870.0, abs=5.0)


def test_smallest_gap_and_its_height_are_the_printed_ones():
    # δ_G = 0.02 mm, k_c = 9.98 N/mm, L_a = 0.13 mm
    height = line_height(d=20e-6, L=L, delta_O=RANGE)
    assert height == pytest.approx(0.13e-3, abs=0.005e-3)
    assert contact_stiffness(E=E, I=I, L_a=height, L_b=L - height) == pytest.approx(9980.0, abs=5.0)


def test_gap_of_the_highest_stop_is_the_printed_one():
    # 87.3 µm is 200/2.29; unrounded π5 gives 87.36 µm
    assert gap_at(0.9 * L) == pytest.approx(200e-6 / 2.29, rel=0.0005)


def test_printed_lowest_height_comes_from_the_misprinted_shape():
    # 3L³ − x for 3L − x is not only printed but computed with: L_a = 0.26 mm, k_c = 10.08 N/mm
    def misprinted(x, F=1.94):
        return F * x**2 * (3 * (L * 1e3) ** 3 - x) / (6 * E * 1e-6 * I * 1e12)  # mm, N

    height = brentq(lambda x: misprinted(x) - gap_at(x * 1e-3) * 1e3, 0.05, 5.0) * 1e-3
    assert height == pytest.approx(0.26e-3, abs=0.005e-3)
    k_c = contact_stiffness(E=E, I=I, L_a=height, L_b=L - height)
    assert k_c == pytest.approx(10080.0, abs=5.0)
    assert gap_at(height) == pytest.approx(0.02e-3, abs=0.0005e-3)


@pytest.mark.parametrize(("travel", "lowest"), [(RANGE, 8.78e-3), (RANGE / 2, 14.41e-3)])
def test_lowest_height_by_the_true_shape_is_a_third_to_a_half_of_the_blade(travel, lowest):
    # 200 µm taken as a deflection, as section 9.1.1 does, or as a range, as π5 is defined
    height = brentq(lambda x: travel * bent_shape(x / L) - gap_at(x), 1e-3, 0.6 * L)
    assert height == pytest.approx(lowest, abs=0.005e-3)


def test_heights_reached_are_those_where_the_line_clears_the_threshold():
    for end in (REACHED.least, REACHED.most):
        line = operating_line(stiffness_ratio(L_a=end, L_b=1.0 - end))
        assert line == pytest.approx(contact_threshold(end), rel=2e-3)


@given(st.floats(1e-3, 0.99), st.floats(1e-6, 1e-2))
def test_height_of_the_gap_of_a_height_is_that_height(a, delta_O):
    gap = line_gap(L_a=a, L_b=1.0 - a, delta_O=delta_O)
    assert line_height(d=gap, L=1.0, delta_O=delta_O) == pytest.approx(a, abs=1e-10)


def test_a_gap_that_no_stop_could_have_is_refused():
    with pytest.raises(ValueError, match="only stiffens"):
        line_height(d=19e-6, L=L, delta_O=RANGE)


def test_arrays_equal_elements():
    gaps = np.array([25e-6, 50e-6, 90e-6])
    together = line_height(d=gaps, L=L, delta_O=RANGE)
    single = [line_height(d=gap, L=L, delta_O=RANGE) for gap in gaps]
    assert together == pytest.approx(np.array(single), rel=1e-15)
    assert gap_at(together) == pytest.approx(gaps, rel=1e-10)
