from math import cos, pi, radians, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from planar_joint import joint_stiffness, stress_rows

from flexcli.formulas.pivot import axial_share, end_stresses, rotational_stiffness
from flexcli.formulas.stage import end_stress, translational_stiffness

E, h, l, b = 114e9, 637e-6, 17.5e-3, 10e-3
PAIR = (radians(45), -radians(45))

ROUNDING = 1e-12
"""Relative: a few products and sums of like size."""


@given(delta=st.floats(-1.5, 1.5), half_angle=st.floats(15, 75))
def test_turning_stiffness_is_that_of_the_pivot(delta, half_angle):
    angles = (radians(half_angle), -radians(half_angle))
    K = joint_stiffness(E=E, h=h, l=l, b=b, p=delta * l, angles=angles)
    expected = rotational_stiffness(E=E, h=h, l=l, b=b, p=delta * l)
    assert K[2, 2] == pytest.approx(expected, rel=1e-9)  # near δ = −½ the sum is a difference


@given(delta=st.floats(-1.5, 1.5), half_angle=st.floats(15, 75))
def test_stiffness_is_symmetric_and_positive_definite(delta, half_angle):
    angles = (radians(half_angle), -radians(half_angle))
    K = joint_stiffness(E=E, h=h, l=l, b=b, p=delta * l, angles=angles)
    np.testing.assert_allclose(K, K.T, rtol=ROUNDING)
    scale = 1.0 / np.sqrt(np.diagonal(K))
    assert np.linalg.eigvalsh(K * np.outer(scale, scale)).min() > 0.0


def test_a_single_parallel_pair_is_the_leaf_spring_stage_across_and_two_rods_along():
    K = joint_stiffness(E=E, h=h, l=l, b=b, p=0.0, angles=(0.0, 0.0))
    assert K[1, 1] == pytest.approx(translational_stiffness(E=E, h=h, l=l, b=b), rel=ROUNDING)
    assert K[0, 0] == pytest.approx(2 * E * h * b / l, rel=ROUNDING)


def test_stress_of_a_rotation_is_that_of_the_pivot():
    θ = 0.02
    _, faces = stress_rows(E=E, h=h, l=l, p=2e-3, angles=PAIR)
    inner, outer = end_stresses(E=E, h=h, l=l, p=2e-3, theta=θ)
    stress = faces @ np.array([0.0, 0.0, θ])
    np.testing.assert_allclose(np.abs(stress[:4]), np.abs([inner, inner, outer, outer]), rtol=1e-9)
    np.testing.assert_allclose(stress[0], -stress[1], rtol=ROUNDING)


def test_stress_of_a_translation_is_that_of_the_stage():
    x = 1e-4
    _, faces = stress_rows(E=E, h=h, l=l, p=0.0, angles=(0.0,))
    stress = faces @ np.array([0.0, x, 0.0])
    np.testing.assert_allclose(np.abs(stress), end_stress(E=E, h=h, l=l, x=x), rtol=ROUNDING)


@pytest.mark.parametrize("direction", [0.0, 0.3, pi / 2])
def test_a_slender_blade_carries_its_share_of_a_force_as_axial_force(direction):
    thin = 1e-5
    K = joint_stiffness(E=E, h=thin, l=l, b=b, p=2e-3, angles=PAIR)
    force = np.array([cos(direction), sin(direction), 0.0])
    axial, _ = stress_rows(E=E, h=thin, l=l, p=2e-3, angles=PAIR)
    carried = axial @ np.linalg.solve(K, force) * thin * b
    # what bending carries instead is of the order (h/l)², 3e-7
    np.testing.assert_allclose(carried, axial_share(PAIR, direction), rtol=1e-5, atol=1e-6)
