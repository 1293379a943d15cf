"""Euler loads against the characteristic equation of each way to hold the ends."""

from math import cos, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq

from flexcli.formulas.buckling import EFFECTIVE_LENGTH, euler_load
from flexcli.formulas.section import second_moment

ROOT = 1e-10  # brentq's own tolerance on the root, and the tabulated 0.699… has 16 digits

# Conditions at an end on w = A sin kx + B cos kx + C x + D with k = √(N/EI): rows of the system.
CONDITIONS = {
    "deflection": lambda k, x: [sin(k * x), cos(k * x), x, 1.0],
    "slope": lambda k, x: [k * cos(k * x), -k * sin(k * x), 1.0, 0.0],
    "moment": lambda k, x: [-(k**2) * sin(k * x), -(k**2) * cos(k * x), 0.0, 0.0],
    # w''' + k² w' leaves the straight line's part alone
    "shear": lambda k, x: [0.0, 0.0, k**2, 0.0],
}
HELD = {
    "clamped": ("deflection", "slope"),
    "pinned": ("deflection", "moment"),
    "guided": ("slope", "shear"),
    "free": ("moment", "shear"),
}


def characteristic(k, ends):
    first, second = ends.split("-")
    rows = [CONDITIONS[c](k, x) for x, hold in ((0.0, first), (1.0, second)) for c in HELD[hold]]
    return np.linalg.det(np.array(rows)) / k**2


def first_root(ends):
    """Return the first load parameter at which the determinant vanishes, touching or crossing."""
    grid = np.linspace(0.5, 7.0, 1301)
    values = np.array([characteristic(k, ends) for k in grid])
    (crossings,) = np.nonzero(values[:-1] * values[1:] < 0)
    first = crossings[0]
    return brentq(characteristic, grid[first], grid[first + 1], args=(ends,), xtol=1e-14)


@pytest.mark.parametrize("ends", sorted(EFFECTIVE_LENGTH))
def test_load_is_the_first_root_of_the_characteristic_equation(ends):
    found = euler_load(E=1.0, I=1.0, l=1.0, ends=ends)
    assert found == pytest.approx(first_root(ends) ** 2, rel=ROOT)


def test_the_rocket_pivots_load_is_the_printed_formula():
    # exercise 9 part II, equation (2): N_cr = π² E b h³/(12 (0.5 l)²)
    E, h, l, b = 114e9, 637e-6, 17.5e-3, 10e-3
    printed = pi**2 * E * b * h**3 / (12 * (0.5 * l) ** 2)
    found = euler_load(E=E, I=second_moment(b, h), l=l, ends="clamped-clamped")
    assert found == pytest.approx(printed, rel=1e-12)


def test_better_held_ends_bear_more():
    order = ["clamped-free", "clamped-guided", "clamped-pinned", "clamped-clamped"]
    loads = [euler_load(E=1.0, I=1.0, l=1.0, ends=ends) for ends in order]
    assert loads == sorted(loads)
    assert len(set(loads)) == len(loads)


@given(E=st.floats(1e9, 1e12), l=st.floats(1e-3, 1.0), scale=st.sampled_from([1e-3, 1e3]))
def test_load_scales_with_the_unit_of_length(E, l, scale):
    in_metres = euler_load(E=E, I=1e-12, l=l, ends="clamped-pinned")
    scaled = euler_load(E=E / scale**2, I=1e-12 * scale**4, l=l * scale, ends="clamped-pinned")
    assert scaled == pytest.approx(in_metres, rel=1e-12)


def test_arrays_agree_with_element_wise_calls():
    l = np.array([0.01, 0.1, 1.0])
    whole = euler_load(E=2.0, I=3.0, l=l, ends="pinned-pinned")
    single = [euler_load(E=2.0, I=3.0, l=x, ends="pinned-pinned") for x in l]
    assert whole == pytest.approx(single, rel=1e-15)


def test_an_unknown_hold_is_refused():
    with pytest.raises(KeyError):
        euler_load(E=1.0, I=1.0, l=1.0, ends="glued")
