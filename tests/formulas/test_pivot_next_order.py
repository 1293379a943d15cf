"""Next-order formulas of pivots against the exact solver: remainders fall with the next power."""

import numpy as np
import pytest
from mechanisms_for_tests import E, G, pivot

from flexcli.formulas import pivot as closed
from flexcli.formulas import pivot_next_order as following
from flexcli.formulas import pivot_next_order as shifts
from flexcli.formulas import thick_blades
from flexcli.formulas.handbook import large_stroke, thick_pivot
from flexcli.formulas.pivot import LIMITS, WITTRICK
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.linear import linear
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.stresses import greatest_stress
from flexcli.mechanics.tangent import held_stiffness

H, L, B = 1e-4, 20e-3, 10e-3
NONE = 60.0  # degrees: no such angle up to there
SLENDER = Effects(extension=False, shear=False)
CASES = [(0.0, 45.0), (-0.5, 30.0), (0.8, 60.0), (-0.8, 40.0), (WITTRICK, 50.0)]
ANGLES = 0.02 * 2.0 ** np.arange(3)
POISSON = E / (2.0 * G) - 1.0


def aimed(delta, alpha, h=H):
    """A pivot whose inner ends are on the ground: seen from behind, the centre lies at −1 − δ."""
    return pivot(h=h, l=L, b=B, delta=-1.0 - delta, alpha=alpha, angle=np.pi)


def turned(delta, degrees, theta=ANGLES):
    found = solve(
        aimed(delta, np.radians(degrees)),
        {"out": (None, None, theta)},
        effects=SLENDER,
        tolerance=1e-12,
    ).checked()
    sizes = {"l": L, "p": delta * L, "theta": theta, "half_angle": np.radians(degrees)}
    return found, sizes


def orders(remainder):
    """Return the observed powers of θ from step to step."""
    return np.log2(np.abs(remainder[1:] / remainder[:-1]))


@pytest.mark.parametrize(("delta", "degrees"), CASES)
def test_moment_and_tangent_are_right_to_the_second_power_of_the_rotation(delta, degrees):
    found, at = turned(delta, degrees)
    K = closed.rotational_stiffness(E=E, h=H, l=L, b=B, p=delta * L)
    secant = found.reactions[:, 0, 2] / (K * ANGLES) - 1.0
    tangent = held_stiffness(found)[:, 0, 0] / K - 1.0
    assert orders(secant - following.moment_change(**at)) == pytest.approx([4, 4], abs=0.2)
    assert orders(tangent - large_stroke.pivot_stiffness_change(**at)) == pytest.approx(
        [4, 4], abs=0.2
    )


@pytest.mark.parametrize(("delta", "degrees"), CASES)
def test_stress_is_right_to_the_second_power_of_the_rotation(delta, degrees):
    found, at = turned(delta, degrees)
    ends = closed.end_stresses(E=E, h=H, l=L, p=delta * L, theta=ANGLES)
    change = greatest_stress(found).bending.max(axis=1) / np.abs(ends).max(axis=0) - 1.0
    assert np.all(orders(change - following.stress_change(**at)) > 2.8)
    assert np.all(change > 0.0)


@pytest.mark.parametrize(("delta", "degrees"), CASES)
def test_shift_is_right_to_the_fourth_power_of_the_rotation(delta, degrees):
    found, at = turned(delta, degrees)
    x, y, _ = found.motions[:, 0].T
    shift = closed.parasitic_shift(**at) + shifts.next_shift(**at)
    assert orders(x + shift) == pytest.approx([6, 6], abs=0.3)
    assert orders(y - shifts.shift_across(**at)) == pytest.approx([5, 5], abs=0.3)


def test_at_wittricks_crossing_the_fourth_power_is_the_whole_shift():
    found, at = turned(WITTRICK, 45.0, np.array([0.05, 0.2]))
    shift = -found.motions[:, 0, 0]
    assert shift == pytest.approx(shifts.next_shift(**at), rel=0.03)


@pytest.mark.parametrize("delta", [-0.9, -0.5, 0.0, 0.7])
@pytest.mark.parametrize("degrees", [20.0, 60.0])
def test_thick_blades_give_way_as_the_linear_beams_of_timoshenko(delta, degrees):
    h, theta, alpha = 2e-3, 1e-3, np.radians(degrees)
    found = linear(aimed(delta, alpha, h), {"out": (None, None, theta)})
    thick = {"h": h, "l": L, "p": delta * L, "half_angle": alpha, "poisson_ratio": POISSON}
    K = closed.rotational_stiffness(E=E, h=h, l=L, b=B, p=delta * L)
    moment = K * theta * (1.0 + thick_pivot.stiffness_change(**thick))
    assert found.reactions[0, 0, 2] == pytest.approx(moment, rel=1e-10)
    across = thick_blades.pivot_shift_across(**thick, theta=theta)
    assert found.motions[0, 0, 1] == pytest.approx(across, rel=1e-9, abs=1e-18)


@pytest.mark.parametrize("delta", [-0.9, 0.0, 0.7])
def test_stress_of_thick_blades_follows_their_s_bending_at_small_rotation(delta):
    h, theta, alpha = 2e-3, 1e-5, np.radians(50.0)
    found = solve(aimed(delta, alpha, h), {"out": (None, None, theta)}).checked()
    ends = closed.end_stresses(E=E, h=h, l=L, p=delta * L, theta=theta)
    change = thick_pivot.stress_change(
        h=h, l=L, p=delta * L, half_angle=alpha, poisson_ratio=POISSON
    )
    stress = greatest_stress(found).bending.max()
    assert stress == pytest.approx(np.abs(ends).max() * (1.0 + change), rel=1e-4)


def test_bound_by_magnitudes_is_never_below_the_term_itself():
    delta, theta = np.linspace(-1.0, 1.0, 41), 0.2
    at = {"l": L, "p": delta * L, "theta": theta, "half_angle": 0.9}
    for of in (following.moment_parts, shifts.shift_parts):
        assert np.all(of(**at).bound >= np.abs(of(**at).total))
    assert np.all(following.stress_bound(**at) >= following.stress_change(**at))


def test_arrays_give_what_single_designs_give():
    delta, alpha = np.array([-0.7, 0.1]), np.array([0.5, 1.0])
    both = following.stress_change(l=L, p=delta * L, theta=0.2, half_angle=alpha)
    single = [
        following.stress_change(l=L, p=d * L, theta=0.2, half_angle=a)
        for d, a in zip(delta, alpha, strict=True)
    ]
    assert both == pytest.approx(single, rel=1e-14)


def test_next_order_estimates_what_the_closed_forms_leave_out_over_random_designs():
    """Median within a few per cent of truth; the spread is that of the terms after."""
    rng, n = np.random.default_rng(6), 120
    delta, alpha = rng.uniform(-1.0, 1.0, n), np.radians(rng.uniform(15.0, 75.0, n))
    h, theta = L * 10.0 ** rng.uniform(-4.0, -1.0, n), rng.uniform(0.01, 0.35, n)
    found = solve(aimed(delta, alpha, h), {"out": (None, None, theta)}, tolerance=1e-8).checked()
    at = {"l": L, "p": delta * L, "theta": theta, "half_angle": alpha}
    thick = {"h": h, "l": L, "p": delta * L, "half_angle": alpha, "poisson_ratio": POISSON}
    K = closed.rotational_stiffness(E=E, h=h, l=L, b=B, p=delta * L)
    ends = closed.end_stresses(E=E, h=h, l=L, p=delta * L, theta=theta)
    truth = {
        "moment": found.reactions[:, 0, 2] / (K * theta) - 1.0,
        "tangent": held_stiffness(found)[:, 0, 0] / K - 1.0,
        "stress": greatest_stress(found).bending.max(axis=1) / np.abs(ends).max(axis=0) - 1.0,
    }
    softer = thick_pivot.stiffness_change(**thick)
    estimate = {
        "moment": following.moment_change(**at) + softer,
        "tangent": large_stroke.pivot_stiffness_change(**at) + softer,
        "stress": following.stress_change(**at) + thick_pivot.stress_change(**thick),
    }
    for name, true in truth.items():
        ratio = np.abs(estimate[name] / true)
        assert 0.9 < np.median(ratio) < 1.2, name
        assert np.mean((ratio > 0.5) & (ratio < 3.0)) > 0.85, name
    softest = 3.0 * following.moment_parts(**at).bound + np.abs(softer)
    most = following.stress_bound(**at) + np.abs(thick_pivot.stress_change(**thick))
    assert np.mean(softest < np.abs(truth["tangent"])) < 0.1
    assert np.mean(most < np.abs(truth["stress"])) < 0.1
    across = shifts.shift_across(**at) + thick_blades.pivot_shift_across(**thick, theta=theta)
    along = shifts.shift_parts(**at).bound
    x, y, _ = found.motions[:, 0].T
    leading = (9.0 * delta**2 + 9.0 * delta + 1.0) * L * theta**2 / (15.0 * np.cos(alpha))
    ratio = np.hypot(along, across) / np.hypot(x + leading, y)
    assert 0.95 < np.median(ratio) < 1.1
    assert np.mean(ratio < 0.9) < 0.05


@pytest.mark.parametrize(("delta", "degrees"), [(0.0, 45.0), (-0.8, 40.0), (WITTRICK, 50.0)])
def test_the_stress_has_both_coefficients_of_the_exact_solution(delta, degrees):
    # a polynomial through what is left over: of θ and θ² nothing is
    theta = np.array([0.01, 0.015, 0.02, 0.03, 0.04, 0.05, 0.06])
    found, at = turned(delta, degrees, theta)
    ends = closed.end_stresses(E=E, h=H, l=L, p=delta * L, theta=theta)
    change = greatest_stress(found).bending.max(axis=1) / np.abs(ends).max(axis=0) - 1.0
    powers = theta[:, None] ** np.arange(1, 6)
    first, second, *_ = np.linalg.lstsq(powers, change - following.stress_change(**at))[0]
    assert abs(first) < 1e-9
    assert abs(second) < 1e-6


@pytest.mark.parametrize("delta", LIMITS)
def test_closed_forms_are_off_by_what_is_printed_at_the_angles_that_are_printed(delta):
    printed = np.array(LIMITS[delta])
    theta, place = np.unique(np.radians(printed), return_inverse=True)
    # h/l and h²/(l² θ²) are out of it
    thin = aimed(delta, np.pi / 4.0, h=2e-6)
    found = solve(thin, {"out": (None, None, theta)}, effects=SLENDER, tolerance=1e-10).checked()
    K = closed.rotational_stiffness(E=E, h=2e-6, l=L, b=B, p=delta * L)
    ends = closed.end_stresses(E=E, h=2e-6, l=L, p=delta * L, theta=theta)
    shift = closed.parasitic_shift(l=L, p=delta * L, theta=theta, half_angle=np.pi / 4.0)
    of = (
        held_stiffness(found)[:, 0, 0] / K,
        greatest_stress(found).bending.max(axis=1) / np.abs(ends).max(axis=0),
        -found.motions[:, 0, 0] / shift,
    )
    for number, ratios in enumerate(of):
        for share, at, angle in zip(
            (0.01, 0.05), place.reshape(printed.shape)[number], printed[number], strict=True
        ):
            off = abs(ratios[at] - 1.0)
            if angle == NONE:
                assert off < share
            else:
                # three digits of the angle, of whose square or more it grows
                assert off == pytest.approx(share, rel=0.03)
