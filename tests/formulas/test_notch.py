"""Notch hinges: published closed forms, the integral, the blade as a limit."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from flexcli.formulas.notch import (
    admissible_rotation,
    circular_stiffness,
    elliptic_stiffness,
    throat_stress,
)

ROUNDING = 1e-12
HINGE = {"E": 210e9, "b": 10e-3, "e": 100e-6, "r": 4e-3}  # lecture, example of the stage
ratios = st.floats(1e-6, 10.0)


def wu_zhou(e, r):
    """Return 1/K of a right-circular hinge, E = b = 1 (Wu & Zhou 2002, s = r/e)."""
    s = r / e
    first = 2 * s**3 * (6 * s**2 + 4 * s + 1) / ((2 * s + 1) * (4 * s + 1) ** 2)
    second = 12 * s**4 * (2 * s + 1) / (4 * s + 1) ** 2.5 * np.arctan(np.sqrt(4 * s + 1))
    return 12 / r**2 * (first + second)


def paros_weisbord(e, r):
    """Return 1/K of a right-circular hinge, E = b = 1 (Paros & Weisbord 1965, full form)."""
    beta = e / (2 * r)
    q = 2 * beta + beta**2
    curve = 1 / (1 + beta) + (3 + q) / ((1 + beta) * q)
    angle = 6 * (1 + beta) / q**1.5 * np.arctan(np.sqrt((2 + beta) / beta))
    return 3 / (2 * r**2) / q * (curve + angle)


@given(ratios)
def test_the_closed_form_is_that_of_paros_and_weisbord_and_of_wu_and_zhou(ratio):
    K = circular_stiffness(E=1.0, b=1.0, e=ratio, r=1.0)
    assert K * paros_weisbord(ratio, 1.0) == pytest.approx(1.0, rel=ROUNDING)
    assert K * wu_zhou(ratio, 1.0) == pytest.approx(1.0, rel=ROUNDING)


@pytest.mark.parametrize("ratio", [1e-4, 1e-2, 1.0])
@pytest.mark.parametrize("flat", [0.1, 1.0, 5.0])
def test_the_elliptic_stiffness_is_the_integral_along_the_notch(ratio, flat):
    def bend(s):
        return 12 / (ratio + 2 * flat * (1 - np.sqrt(1 - s**2))) ** 3

    throat = min(5 * np.sqrt(ratio / flat), 0.5)  # adaptive quadrature must not miss it
    turn = sum(
        quad(bend, low, high, epsabs=0, epsrel=1e-11, limit=200)[0]
        for low, high in pairwise((0.0, throat, 1.0))
    )
    K = elliptic_stiffness(E=1.0, b=1.0, e=ratio, l=2.0, depth=flat)
    assert 2 * turn * K == pytest.approx(1.0, rel=1e-9)


def test_a_notch_without_depth_is_a_blade():
    blade = 12.0 * 1.0 * 0.1**3 / 12 / 2.0  # EI/l
    flat = elliptic_stiffness(E=12.0, b=1.0, e=0.1, l=2.0, depth=0.0)
    assert flat == pytest.approx(blade, rel=ROUNDING)
    # to first order the mean thickness of the notch, e + 2d(1 − π/4), cubed
    d = 1e-7
    nearly = elliptic_stiffness(E=12.0, b=1.0, e=0.1, l=2.0, depth=d)
    assert nearly / blade - 1 == pytest.approx(3 * 2 * d * (1 - np.pi / 4) / 0.1, rel=1e-5)


def test_a_circular_notch_is_the_ellipse_with_equal_half_axes():
    K = elliptic_stiffness(E=210e9, b=10e-3, e=100e-6, l=8e-3, depth=4e-3)
    assert circular_stiffness(**HINGE) == pytest.approx(K, rel=ROUNDING)


def test_a_flat_notch_of_equal_throat_curvature_tends_to_the_same_stiffness():
    # for a thin throat only its radius of curvature (l/2)²/d counts
    e, r = 1e-7, 1.0
    d = 0.1
    K = elliptic_stiffness(E=1.0, b=1.0, e=e, l=2 * np.sqrt(r * d), depth=d)
    assert circular_stiffness(E=1.0, b=1.0, e=e, r=r) == pytest.approx(K, rel=1e-5)


def test_stress_and_rotation_are_inverse_of_each_other():
    K = circular_stiffness(**HINGE)
    throat = {"K": K, "b": 10e-3, "e": 100e-6, "factor": 1.05}
    gamma = admissible_rotation(sigma=800e6, **throat)
    assert throat_stress(theta=gamma, **throat) == pytest.approx(800e6, rel=ROUNDING)
    # nominal: 6M/(b e²)
    nominal = throat_stress(theta=0.01, **(throat | {"factor": 1.0}))
    assert nominal == pytest.approx(6 * K * 0.01 / (10e-3 * 100e-6**2), rel=ROUNDING)


def test_the_stress_of_a_shallow_notch_is_that_of_a_bent_blade():
    # σ = E e θ/(2 l)
    K = elliptic_stiffness(E=210e9, b=1e-2, e=1e-4, l=5e-3, depth=0.0)
    stress = throat_stress(K=K, b=1e-2, e=1e-4, theta=0.02, factor=1.0)
    assert stress == pytest.approx(210e9 * 1e-4 * 0.02 / (2 * 5e-3), rel=ROUNDING)


@given(st.lists(st.tuples(ratios, st.floats(0.1, 10)), min_size=1, max_size=5))
def test_arrays_agree_with_element_wise_calls(rows):
    e, r = np.array(rows).T
    whole = circular_stiffness(E=2.0, b=3.0, e=e, r=r)
    single = [circular_stiffness(E=2.0, b=3.0, e=x, r=y) for x, y in rows]
    assert whole == pytest.approx(single, rel=ROUNDING)


@given(ratios, st.sampled_from([1e-6, 1e3]))
def test_a_change_of_the_unit_of_length_changes_no_digits(ratio, unit):
    # E b e^2.5/√r is a pressure times a volume
    K = circular_stiffness(E=1.0, b=1.0, e=ratio, r=1.0)
    scaled = circular_stiffness(E=1.0 / unit**3, b=unit, e=ratio * unit, r=unit)
    assert scaled == pytest.approx(K, rel=ROUNDING)
