"""Buckling of a necked-down blade: Euler at ξ = 1, springs at ξ → 0, and a beam assembly."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq

from flexcli.formulas.buckling import euler_load
from flexcli.formulas.necked_buckling import guided_critical_load, locked_critical_load

ROUNDING = 1e-12
BLADE = {"E": 12.0, "h": 1.0, "l": 1.0, "b": 1.0}  # EI = 1
shares = st.floats(1e-6, 1.0)


def euler(ends):
    return euler_load(E=1.0, I=1.0, l=1.0, ends=ends)


def test_a_full_blade_buckles_at_eulers_load():
    guided, locked = (f(xi=1.0, **BLADE) for f in (guided_critical_load, locked_critical_load))
    assert guided == pytest.approx(euler("clamped-guided"), rel=ROUNDING)
    assert locked == pytest.approx(euler("clamped-clamped"), rel=ROUNDING)


def test_short_hinges_buckle_as_a_rigid_link_between_springs():
    # link of length l on two springs k = EI/l_c: P = 2k/l
    xi = 1e-9
    assert guided_critical_load(xi=xi, **BLADE) == pytest.approx(2 / (xi / 2), rel=10 * xi)


@given(shares)
def test_the_guided_root_solves_its_equation(xi):
    u = np.sqrt(guided_critical_load(xi=xi, **BLADE)) * xi / 2
    assert 0 < u <= np.pi / 2 * (1 + ROUNDING)
    assert (1 - xi) * u * np.sin(u) == pytest.approx(xi * np.cos(u), rel=1e-12, abs=1e-15)


def stability(P, l_c):
    """Return exact stiffness over the shift and tilt (w, φ) of the rigid middle, EI = l = 1.

    Two hinges as beam-columns (stability functions), the middle of length 1 − 2 l_c under P,
    the upper body free to shift by 2w in the guided case: see the callers.
    """
    k = np.sqrt(P)
    u = k * l_c
    d = 2 - 2 * np.cos(u) - u * np.sin(u)
    shear = u**3 * np.sin(u) / d / l_c**3
    mixed = u**2 * (1 - np.cos(u)) / d / l_c**2
    bend = u * (np.sin(u) - u * np.cos(u)) / d / l_c
    return np.array([[shear, -mixed], [-mixed, bend]])


def tilted(P, xi):
    """Return the stiffness against tilt of the middle about its mid-length, both ends held."""
    a = (1 - xi) / 2
    end = np.array([-a, 1.0])  # a hinge's far end: shift and slope per tilt
    return 2 * end @ stability(P, xi / 2) @ end - P * 2 * a


def shifted(P, xi):
    """Return the stiffness of the guided stage: half a blade, its top a shear-free inflection."""
    a = (1 - xi) / 2
    K = stability(P, xi / 2)
    # the shift follows freely; the slope carries P over the rigid half-length
    return K[1, 1] - K[0, 1] ** 2 / K[0, 0] - P * a


@pytest.mark.parametrize("xi", [0.05, 0.2, 0.5, 0.8, 0.99])
def test_the_guided_load_is_where_beam_columns_lose_their_stiffness(xi):
    P = float(guided_critical_load(xi=xi, **BLADE))
    assert shifted(0.99 * P, xi) > 0 > shifted(1.01 * P, xi)
    assert brentq(shifted, 0.9 * P, 1.1 * P, args=(xi,), rtol=1e-13) == pytest.approx(P, rel=1e-10)


@pytest.mark.parametrize("xi", [0.05, 0.2, 0.5, 0.8, 0.99])
def test_a_locked_blade_buckles_without_turning_its_middle(xi):
    P = locked_critical_load(xi=xi, **BLADE)
    below, above = (stability(share * P, xi / 2)[0, 0] for share in (0.99, 1.01))
    assert below > 0 > above
    loads = np.linspace(0.01, 1.0, 200) * P
    assert all(tilted(load, xi) > 0 for load in loads)


def test_at_equal_stroke_the_locked_load_is_greatest_at_the_stated_share():
    # load ∝ g³/ξ²; its derivative vanishes where 7ξ² − 12ξ + 3 = 0
    xi = np.linspace(0.05, 1.0, 2000)
    load = locked_critical_load(E=1.0, h=xi * (3 - 3 * xi + xi**2), l=1.0, b=1.0, xi=xi)
    assert xi[np.argmax(load)] == pytest.approx((6 - np.sqrt(15)) / 7, abs=1e-3)


@pytest.mark.parametrize("xi", [0.0, -0.1, 1.0 + 1e-9, np.nan])
def test_a_share_outside_its_range_is_refused(xi):
    with pytest.raises(ValueError, match="xi must be"):
        guided_critical_load(xi=xi, **BLADE)


@given(st.lists(shares, min_size=1, max_size=5))
def test_arrays_agree_with_element_wise_calls(rows):
    for function in (guided_critical_load, locked_critical_load):
        whole = function(xi=np.array(rows), **BLADE)
        assert whole == pytest.approx([function(xi=xi, **BLADE) for xi in rows], rel=ROUNDING)
