"""Tension of overconstrained pivots against the exact solver."""

import numpy as np
import pytest
from mechanisms_for_tests import E, G

from flexcli.formulas import star_next_order as star
from flexcli.formulas.handbook import large_stroke
from flexcli.formulas.pivot import end_stresses, rotational_stiffness
from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.stresses import greatest_stress

L, B = 80e-3, 30e-3
EVEN = (0.0, 2.0 * np.pi / 3.0, 4.0 * np.pi / 3.0)


def three_blades(delta, h):
    blades = []
    for index, angle in enumerate(EVEN):
        start, end = ((r * L * np.cos(angle), r * L * np.sin(angle)) for r in (delta, 1.0 + delta))
        blades.append(Blade(f"{index}", "ground", "out", start, end, Constant(h[:, None]), B))
    return Layout((Body("out", (0.0, 0.0)),), tuple(blades), E, G)


def test_two_blades_leave_no_misfit_and_even_blades_all_of_it():
    assert star.held_shares((0.3, -0.9)) == pytest.approx((0.0, 0.0), abs=1e-14)
    assert star.held_shares(EVEN) == pytest.approx((1.0, 1.0, 1.0), rel=1e-14)
    assert star.held_shares((0.0, np.pi / 2, np.pi)) == pytest.approx((1.0, 0.0, 1.0), abs=1e-14)


@pytest.mark.parametrize("delta", [0.0, 0.3, -0.3])
def test_moment_stress_and_tension_grow_with_the_square_of_rotation_over_thickness(delta):
    h = L * np.array([1e-3, 3e-3])
    theta = 0.3 * h / L
    found = solve(three_blades(delta, h), {"out": (None, None, theta)}).checked()
    at = {"h": h, "l": L, "p": delta * L, "theta": theta}
    K = rotational_stiffness(E=E, h=h, l=L, b=B, p=delta * L, blades=3)
    moment = found.reactions[:, 0, 2] / (K * theta) - 1.0
    assert moment == pytest.approx(large_stroke.star_moment_change(**at, angles=EVEN), rel=0.05)
    unit = E * B * h**3 / 12.0 / L**2
    pull = found.end_forces[:, 0, 0] / unit
    assert pull == pytest.approx(star.tension(**at), rel=0.02)
    stress = np.abs(end_stresses(E=E, h=h, l=L, p=delta * L, theta=theta)).max(axis=0)
    change = greatest_stress(found).bending.max(axis=1) / stress - 1.0
    assert change == pytest.approx(star.stress_change(**at, angles=EVEN), rel=0.05)


def test_estimates_hold_over_random_pivots_of_three_blades_in_tension():
    rng, n = np.random.default_rng(8), 60
    delta, h = rng.uniform(0.0, 0.5, n), L * 10.0 ** rng.uniform(-3.5, -2.0, n)
    theta = h / L * rng.uniform(0.3, 4.0, n)
    at = {"h": h, "l": L, "p": delta * L, "theta": theta}
    within = star.tension(**at) < 30.0
    found = solve(three_blades(delta, h), {"out": (None, None, theta)}, tolerance=1e-8).checked()
    K = rotational_stiffness(E=E, h=h, l=L, b=B, p=delta * L, blades=3)
    true = found.reactions[:, 0, 2] / (K * theta) - 1.0
    ratio = (large_stroke.star_moment_change(**at, angles=EVEN) / true)[within]
    assert ratio.size > 30
    assert np.all((ratio > 0.8) & (ratio < 1.1))
