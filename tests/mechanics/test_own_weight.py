"""Blades between held ends under their own weight."""

import numpy as np
import pytest

from flexcli.formulas.profile import Constant, Filleted, Notch
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.own_weight import POINTS, blade_places, held_blade, weights_on_bodies

H, L, B, DENSITY = 0.3e-3, 20e-3, 5e-3, 4430.0
W = DENSITY * B * H
"""Mass of a uniform blade per length [kg/m]."""


def blade(profile, angle=0.0):
    end = (L * np.cos(angle), L * np.sin(angle))
    return Blade("blade", "ground", "moving", (0.0, 0.0), end, profile, B)


def test_a_uniform_blade_has_the_moments_and_forces_of_a_clamped_beam():
    held = held_blade(blade(Constant(H)), DENSITY)
    end, middle = W * L**2 / 12.0, -W * L**2 / 24.0
    assert held.moment[0, 0] == pytest.approx(end, rel=1e-4)
    assert held.moment[0, -1] == pytest.approx(end, rel=1e-4)
    assert held.moment[0, POINTS // 2] == pytest.approx(middle, rel=1e-4)
    assert held.pull[0, [0, -1]] == pytest.approx([W * L / 2.0, -W * L / 2.0], rel=1e-9)
    assert held.across[0] == pytest.approx(
        np.array([[W * L / 2.0, end], [W * L / 2.0, -end]]), rel=1e-4
    )
    assert held.along[0] == pytest.approx([W * L / 2.0, W * L / 2.0], rel=1e-9)
    euler = np.pi**2 * B * H**3 / 12.0 / (L / 2.0) ** 2
    assert held.softness[0] == pytest.approx(1.0 / euler, rel=1e-9)


@pytest.mark.parametrize("profile", [Constant(H), Notch(0.1e-3, 1e-3), Filleted(H, 0.4e-3)])
def test_what_holds_a_blade_bears_its_weight_and_the_moment_of_it(profile):
    held = held_blade(blade(profile), DENSITY)
    s, h = blade_places(blade(profile), L)
    mass = np.trapezoid(DENSITY * B * h, s)
    about_start = np.trapezoid(DENSITY * B * h * s, s)
    (first, turn), (second, other) = held.across[0]
    assert first + second == pytest.approx(mass, rel=1e-4)
    assert turn + other + second * L == pytest.approx(about_start, rel=1e-4)
    assert held.along[0].sum() == pytest.approx(mass, rel=1e-4)


def test_the_curvature_by_its_weight_leaves_the_ends_of_a_notch_where_they_are():
    notch = Notch(0.1e-3, 1e-3)
    held = held_blade(blade(notch), DENSITY)
    s, h = np.broadcast_arrays(*blade_places(blade(notch), L))
    curvature = held.moment[0] / h**3
    size = np.trapezoid(np.abs(curvature), s)
    assert abs(np.trapezoid(curvature, s)) < 1e-6 * size
    assert abs(np.trapezoid(curvature * s, s)) < 1e-6 * size * L
    assert abs(np.trapezoid(held.pull[0] / h, s)) < 1e-6 * np.trapezoid(np.abs(held.pull[0]) / h, s)


@pytest.mark.parametrize("angle", [0.0, 0.7, 2.5])
def test_only_bodies_that_may_move_are_loaded_along_the_acceleration(angle):
    one = blade(Constant(H), angle)
    layout = Layout((Body("moving", one.end),), (one,), 114e9)
    x, y = np.array([3.0, -3.0]), np.array([4.0, 1.0])
    (load,) = weights_on_bodies(layout, DENSITY, x, y)
    assert (load.body, load.point) == ("moving", one.end)
    assert load.force[0] == pytest.approx(W * L / 2.0 * x, rel=1e-9)
    assert load.force[1] == pytest.approx(W * L / 2.0 * y, rel=1e-9)
    left = np.cos(angle) * y - np.sin(angle) * x
    assert load.moment == pytest.approx(-W * L**2 / 12.0 * left, rel=1e-4)
