"""Stress concentration of notch hinges: limits, the rule of five throats, two sources."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.notch import bending_factor, fitted_bending_factor


def neuber(a):
    """Return the deep-notch factor as printed, which loses digits for small a = e/(2r)."""
    return 4 * a**1.5 / (3 * (np.sqrt(a) + (a - 1) * np.arctan(np.sqrt(a))))


@given(st.floats(0.05, 10.0))
def test_the_factor_is_neubers_closed_form(ratio):
    assert bending_factor(e=ratio, r=1.0) == pytest.approx(neuber(ratio / 2), rel=1e-12)


def test_the_factor_tends_to_one_with_slope_one_fifth():
    for ratio in (1e-3, 1e-6, 1e-9):
        assert bending_factor(e=ratio, r=1.0) - 1 == pytest.approx(ratio / 5, rel=ratio, abs=1e-15)


def test_a_radius_of_five_throats_makes_the_concentration_negligible():
    # the lecture prints "r < 5 h_min"; the factor falls with r, so it must read r > 5 h_min
    r = np.geomspace(0.5, 500.0, 200)
    for factor in (bending_factor, fitted_bending_factor):
        values = factor(e=1.0, r=r)
        assert (np.diff(values) < 0).all()
        assert factor(e=1.0, r=5.0) < 1.05
        assert factor(e=1.0, r=1.0) > 1.15


def test_a_plane_stress_finite_element_model_gives_the_factor():
    # quarter model of a right-circular hinge in pure bending, nine-node elements:
    # tests/benchmarks/notch_plane_stress.py
    for ratio, computed in ((0.025, 1.0050), (0.1, 1.0198), (0.2, 1.0392), (0.5, 1.0952)):
        assert bending_factor(e=ratio, r=1.0) == pytest.approx(computed, abs=1e-3)


def test_the_fitted_factor_is_on_the_safe_side_and_close():
    ratio = np.linspace(1e-3, 1.0, 100)
    exact, fit = (f(e=ratio, r=1.0) for f in (bending_factor, fitted_bending_factor))
    assert (fit > exact).all()
    assert (fit < 1.04 * exact).all()


@given(st.lists(st.tuples(st.floats(1e-6, 5.0), st.floats(0.5, 10)), min_size=1, max_size=5))
def test_arrays_agree_with_element_wise_calls(rows):
    e, r = np.array(rows).T
    for factor in (bending_factor, fitted_bending_factor):
        single = [factor(e=x, r=y) for x, y in rows]
        assert factor(e=e, r=r) == pytest.approx(single, rel=1e-14)
