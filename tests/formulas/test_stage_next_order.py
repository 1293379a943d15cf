"""Next-order formulas of stages against the exact solver and the kinematics of pins."""

import numpy as np
import pytest
from mechanisms_for_tests import E, G, cantilever, parallelogram

from flexcli.formulas import necked_stage, stage
from flexcli.formulas import stage_next_order as following
from flexcli.formulas.handbook import large_stroke
from flexcli.formulas.handbook.large_stroke import hinged_stage_force_change
from flexcli.formulas.hinged_next_order import stage_shift_change, stage_turn_change
from flexcli.formulas.profile import NeckedDown
from flexcli.formulas.single_blade import force_stiffness, force_stress
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.stresses import greatest_stress
from flexcli.mechanics.tangent import held_stiffness

H, L, B = 1e-4, 20e-3, 10e-3
SLENDER = Effects(extension=False, shear=False)
STROKES = 0.03 * L * 2.0 ** np.arange(3)


def orders(remainder):
    return np.log2(np.abs(remainder[1:] / remainder[:-1]))


def remainders(found, xi, K, stress, shift):
    """Return what is left of force, tangent, stress and shift after the next order."""
    at = {"l": L, "x": STROKES, "xi": xi}
    tangent = held_stiffness(found)[:, 0, 0]
    true = (
        (found.reactions[:, 0, 1] / (K * STROKES), large_stroke.stage_force_change(**at)),
        (tangent / K, large_stroke.stage_stiffness_change(**at)),
        (greatest_stress(found).bending.max(axis=1) / stress, following.stress_change(**at)),
        (-found.motions[:, 0, 0] / shift, following.shift_change(**at)),
    )
    return [value - 1.0 - change for value, change in true]


@pytest.mark.parametrize("xi", [1.0, 0.6, 0.2])
def test_guided_blades_are_right_to_the_second_power_of_the_stroke(xi):
    profile = None if xi == 1.0 else NeckedDown(H, xi * L / 2.0)
    layout = cantilever(h=H, l=L, b=B, profile=profile)
    held = {"tip": (None, STROKES, 0.0)}
    found = solve(layout, held, effects=SLENDER, tolerance=1e-12).checked()
    K = necked_stage.translational_stiffness(E=E, h=H, l=L, b=B, xi=xi, blades=1)
    stress = necked_stage.end_stress(E=E, h=H, l=L, x=STROKES, xi=xi)
    shift = necked_stage.shortening(l=L, x=STROKES, xi=xi)
    for remainder in remainders(found, xi, K, stress, shift):
        assert orders(remainder) == pytest.approx([4, 4], abs=0.25)


def test_a_cantilever_changes_by_the_same_terms_as_a_guided_blade():
    layout = cantilever(h=H, l=L, b=B)
    found = solve(layout, {"tip": (None, STROKES, None)}, effects=SLENDER, tolerance=1e-12)
    K = force_stiffness(E=E, h=H, l=L, b=B)
    stress = force_stress(E=E, h=H, l=L, x=STROKES, s=0.0)
    shift = stage.shortening(l=L, x=STROKES)
    for remainder in remainders(found.checked(), 1.0, K, stress, shift):
        assert orders(remainder) == pytest.approx([4, 4], abs=0.25)


def test_a_stage_of_two_blades_held_straight_changes_as_one_blade():
    effects = Effects(extension=True, shear=False)
    layout = parallelogram(h=H, l=L, b=B)
    found = solve(layout, {"table": (None, STROKES, 0.0)}, effects=effects, tolerance=1e-12)
    K = stage.translational_stiffness(E=E, h=H, l=L, b=B)
    change = found.checked().reactions[:, 0, 1] / (K * STROKES) - 1.0
    # what is left over is the blades' stretching, of order (h/l)²
    assert change == pytest.approx(
        large_stroke.stage_force_change(l=L, x=STROKES), rel=0.02, abs=3e-5
    )


def test_short_hinges_tend_to_pins():
    at = {"l": L, "x": 0.01 * L}
    pairs = (
        (large_stroke.stage_force_change, hinged_stage_force_change),
        (following.stress_change, stage_turn_change),
        (following.shift_change, stage_shift_change),
    )
    for blade, pin in pairs:
        assert blade(**at, xi=1e-9) == pytest.approx(pin(**at), rel=1e-4)


def test_estimates_hold_over_random_strokes_of_guided_blades():
    rng, n = np.random.default_rng(7), 60
    x, h = L * rng.uniform(0.02, 0.35, n), L * 10.0 ** rng.uniform(-4.0, -2.0, n)
    found = solve(cantilever(h=h[:, None], l=L, b=B), {"tip": (None, x, 0.0)}).checked()
    K = stage.translational_stiffness(E=E, h=h, l=L, b=B, blades=1)
    nu = E / (2.0 * G) - 1.0
    softer = -2.4 * (1.0 + nu) * (h / L) ** 2
    ratio = (large_stroke.stage_force_change(l=L, x=x) + softer) / (
        found.reactions[:, 0, 1] / K / x - 1.0
    )
    assert 0.8 < np.median(ratio) < 1.2
    assert np.all((ratio > 0.5) & (ratio < 3.0))
