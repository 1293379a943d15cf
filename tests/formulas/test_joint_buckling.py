"""A joint buckles where its body turns away or a blade bows: limits, other routes, invariants."""

from math import cos, pi, radians, tanh

import numpy as np
import pytest
from scipy.optimize import brentq

from flexcli.formulas.buckling import EFFECTIVE_LENGTH, johnson_stress, thick_load
from flexcli.formulas.handbook.loaded_pivot import loaded_stiffness
from flexcli.formulas.joint_buckling import held_load, shares, sway, turning_load, turning_stiffness

ROUNDING = 1e-9


def test_a_symmetric_cross_spring_that_is_pulled_turns_where_x_tanh_x_is_one():
    """Both blades bend evenly, k = x/tanh x against n/4 = x²; on two blades at ±45° F = √2 n."""
    x = brentq(lambda x: x * tanh(x) - 1.0, 1.0, 1.5)
    tensions = shares(angles=(pi / 4, -pi / 4), direction=0.0, across=False)
    found = turning_load(tensions=tensions, delta=-0.5)
    assert found == pytest.approx(4.0 * x**2 * 2**0.5, rel=ROUNDING)
    assert found == pytest.approx(8.1415, abs=5e-5)


@pytest.mark.parametrize("delta", [-1.3, -0.5, 0.0, 0.7])
@pytest.mark.parametrize("n", [-35.0, -9.0, -1e-3, 0.0, 1e-3, 4.0, 300.0])
def test_without_shear_it_is_the_stiffness_of_a_slender_pivot_under_load(n, delta):
    slender = loaded_stiffness(E=12.0, h=1.0, l=1.0, b=1.0, p=delta, tensions=(n,))
    assert turning_stiffness(n, delta=delta) == pytest.approx(slender, rel=1e-8)


@pytest.mark.parametrize("direction", [0.0, 40.0, 90.0, 170.0])
def test_a_mirrored_force_buckles_a_mirrored_pivot_alike(direction):
    angles = (radians(35.0), radians(-35.0))
    one, other = (
        turning_load(
            tensions=shares(angles=angles, direction=radians(sign * direction), across=False),
            delta=0.2,
            axial=1e-4,
            shear=3e-4,
        )
        for sign in (1.0, -1.0)
    )
    assert one == pytest.approx(other, rel=ROUNDING)


def test_a_pivot_never_bears_more_than_its_blade_between_ends_that_stand_still():
    for delta in np.linspace(-1.5, 1.0, 11):
        tensions = shares(angles=(0.6, -0.6), direction=pi, across=False)
        held = held_load(tensions=tensions, ends="clamped-clamped")
        assert turning_load(tensions=tensions, delta=float(delta)) <= held * (1.0 + ROUNDING)


def test_an_s_shape_leaves_the_even_bow_of_a_blade_to_buckle_it():
    """Far from the centre (δ → ∞) the turning is all S-shaped; the bow still comes at 4π²."""
    tensions = (-1.0, -1.0)
    found = turning_load(tensions=tensions, delta=30.0)
    assert found <= 4.0 * pi**2 * (1.0 + 1e-6)


@pytest.mark.parametrize("ends", EFFECTIVE_LENGTH)
def test_a_slender_blade_buckles_at_eulers_load(ends):
    euler = (pi / EFFECTIVE_LENGTH[ends]) ** 2
    assert thick_load(ends=ends, axial=0.0, shear=0.0) == pytest.approx(euler, rel=1e-12)


@pytest.mark.parametrize("ends", EFFECTIVE_LENGTH)
def test_shear_lowers_a_critical_load_by_engessers_first_term_and_stretching_raises_it(ends):
    """P/P_E − 1 = ∓u at first, u = P_E/κGA or P_E/EA; clamped–pinned the end's force adds."""
    small, euler = 1e-7, (pi / EFFECTIVE_LENGTH[ends]) ** 2
    sheared = thick_load(ends=ends, axial=0.0, shear=small) / euler - 1.0
    assert sheared < 0.0
    if ends != "clamped-pinned":
        assert sheared == pytest.approx(-small * euler, rel=1e-3)
    stretched = thick_load(ends=ends, axial=small, shear=0.0) / euler - 1.0
    assert stretched == pytest.approx(small * euler, rel=1e-3)


def test_johnsons_parabola_meets_eulers_curve_at_half_the_strength_without_a_corner():
    strength, step = 800.0, 1e-5
    at = johnson_stress(400.0 * np.array([1.0 - step, 1.0, 1.0 + step]), strength)
    assert at[1] == pytest.approx(400.0, rel=1e-12)
    slopes = np.diff(at) / (400.0 * step)
    # the error of a one-sided difference is of the order of its step
    assert slopes == pytest.approx([1.0, 1.0], abs=10 * step)


def test_johnsons_stress_rises_with_eulers_to_the_strength():
    critical = np.geomspace(1.0, 1e9, 200)
    borne = johnson_stress(critical, 800.0)
    assert (np.diff(borne) > 0.0).all()
    assert (borne <= np.minimum(critical, 800.0)).all()
    assert johnson_stress(np.inf, 800.0) == 800.0


def test_a_body_held_across_an_oblique_force_takes_it_along_its_line_alone():
    """One blade along the force carries all of it when the body cannot give way across."""
    angles = (radians(45.0), radians(-45.0))
    assert shares(angles=angles, direction=radians(45.0), across=True) == pytest.approx((1.0, 0.0))
    along, across = shares(angles=angles, direction=radians(20.0), across=True)
    assert along / across == pytest.approx(cos(radians(25.0)) / cos(radians(65.0)))


@pytest.mark.parametrize("degrees", [(20.0, 100.0), (-35.0, 10.0), (45.0, -45.0)])
def test_what_a_blade_does_not_stretch_of_the_body_s_motion_it_sways(degrees):
    """Two blades alone say how the body moves: d² = (u·d)² + (u × d)² for each."""
    angles, stretches = np.deg2rad(degrees), np.array([0.3, -0.8])
    d = np.linalg.solve(np.column_stack([np.cos(angles), np.sin(angles)]), stretches)
    expected = np.sqrt((d @ d - stretches**2).max()) / 0.8
    assert sway(angles=tuple(angles), shares=tuple(stretches)) == pytest.approx(expected, rel=1e-9)
