"""Next-order formulas of limbs on pins against the exact kinematics of a four-bar linkage."""

import numpy as np
import pytest

from flexcli.formulas import hinged_next_order as following
from flexcli.formulas import hinged_pivot as closed
from flexcli.formulas.handbook import large_stroke

ANGLES = 0.02 * 2.0 ** np.arange(3)
CASES = [(0.3, 0.7), (-0.5, 0.5), (-0.8, 1.1), (0.9, 0.9)]


def limbs_of(delta, alpha, theta):
    """Return the turns ψ of both limbs and the shift of the centre, limbs of length 1."""
    e = np.array([[np.cos(a), np.sin(a)] for a in (alpha, -alpha)])
    turn = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])

    def limb(d):
        return d + (1.0 + delta) * e @ turn.T - delta * e

    d = np.zeros(2)
    for _ in range(8):
        d = d - np.linalg.solve(2.0 * limb(d), np.sum(limb(d) ** 2, axis=1) - 1.0)
    now = limb(d)
    psi = np.arctan2(e[:, 0] * now[:, 1] - e[:, 1] * now[:, 0], np.sum(e * now, axis=1))
    return psi, d


def moment(delta, alpha, theta):
    """Return dU/dθ of springs of unit stiffness by a five-point rule."""
    step = 1e-3

    def energy(angle):
        psi, _ = limbs_of(delta, alpha, angle)
        return np.sum(psi**2 + (angle - psi) ** 2) / 2.0

    u = [energy(theta + k * step) for k in (-2, -1, 1, 2)]
    return (u[0] - 8.0 * u[1] + 8.0 * u[2] - u[3]) / (12.0 * step)


def orders(remainder):
    return np.log2(np.abs(remainder[1:] / remainder[:-1]))


@pytest.mark.parametrize(("delta", "alpha"), CASES)
def test_hinged_pivot_is_right_to_the_next_power_of_the_rotation(delta, alpha):
    at = {"l": 1.0, "p": delta, "theta": ANGLES, "half_angle": alpha}
    psi = np.array([limbs_of(delta, alpha, t)[0] for t in ANGLES])
    x = np.array([limbs_of(delta, alpha, t)[1][0] for t in ANGLES])
    largest = np.maximum(np.abs(psi), np.abs(ANGLES[:, None] - psi)).max(axis=1)
    first = np.max(np.abs(closed.hinge_rotations(l=1.0, p=delta, theta=ANGLES)), axis=0)
    turn = largest / first - 1.0 - following.pivot_turn_change(**at)
    assert np.all(orders(turn) > 2.7)
    shift = -x / closed.parasitic_shift(**at) - 1.0 - following.pivot_shift_change(**at)
    assert orders(shift) == pytest.approx([4, 4], abs=0.4)
    K = closed.rotational_stiffness(K=1.0, l=1.0, p=delta, c=0.0)
    M = np.array([moment(delta, alpha, t) for t in ANGLES])
    change = M / (K * ANGLES) - 1.0
    assert change == pytest.approx(
        large_stroke.hinged_pivot_moment_change(**at), rel=0.06, abs=1e-9
    )


def test_hinged_stage_follows_the_parallelogram():
    x = np.array([1e-6, 0.3])
    psi = np.arcsin(x)
    at = {"l": 1.0, "x": x}
    step = 1e-4
    force = (np.arcsin(x + step) ** 2 - np.arcsin(x - step) ** 2) / (4.0 * step)
    assert 1.0 + large_stroke.hinged_stage_force_change(**at) == pytest.approx(force / x, rel=1e-6)
    assert 1.0 + following.stage_turn_change(**at) == pytest.approx(psi / x, rel=1e-12)
    assert following.stage_shift_change(**at)[1] == pytest.approx(
        (1.0 - np.cos(psi[1])) / (x[1] ** 2 / 2.0) - 1.0, rel=1e-12
    )
