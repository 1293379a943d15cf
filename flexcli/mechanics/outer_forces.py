"""Forces and springs on bodies: their part of the balance of forces and of its derivative."""

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.demand import Force, Spring
from flexcli.mechanics.element import turned
from flexcli.mechanics.mesh import pick

__all__ = ["apply_force", "apply_spring"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


def apply_force(
    force: Force, motions: Floats, size: Floats, rows: Integers, residual: Floats, K: Floats
) -> None:
    """Subtract ``size`` times a force from the residual, and its stiffness from the matrix."""
    first = 3 * force.body
    phi = motions[:, force.body, 2]
    arm, _ = turned(np.broadcast_to(pick(force.arm, rows), (phi.size, 2)), phi)
    P = size[:, None] * pick(force.force, rows)
    if force.follows:
        P, _ = turned(P, phi)
        K[:, first, first + 2] += P[:, 1]
        K[:, first + 1, first + 2] -= P[:, 0]
    else:
        K[:, first + 2, first + 2] += arm[:, 0] * P[:, 0] + arm[:, 1] * P[:, 1]
    residual[:, first : first + 2] -= P
    moment = size * pick(force.moment, rows)
    residual[:, first + 2] -= moment + arm[:, 0] * P[:, 1] - arm[:, 1] * P[:, 0]


def apply_spring(
    spring: Spring, motions: Floats, rows: Integers, residual: Floats, K: Floats
) -> None:
    """Add the forces of springs to the residual and their stiffness to the matrix."""
    first = 3 * spring.body
    d = motions[:, spring.body]
    arm, moved = turned(np.broadcast_to(pick(spring.arm, rows), (d.shape[0], 2)), d[:, 2])
    k = pick(spring.stiffness, rows)
    pull = k[:, :2] * (d[:, :2] + moved)
    lever = np.stack([-arm[:, 1], arm[:, 0]], axis=-1)
    residual[:, first : first + 2] += pull
    residual[:, first + 2] += k[:, 2] * d[:, 2] + np.sum(pull * lever, axis=-1)
    for i in (0, 1):
        K[:, first + i, first + i] += k[:, i]
        K[:, first + i, first + 2] += k[:, i] * lever[:, i]
        K[:, first + 2, first + i] += k[:, i] * lever[:, i]
    K[:, first + 2, first + 2] += (
        k[:, 2] + np.sum(k[:, :2] * lever**2, axis=-1) - np.sum(pull * arm, axis=-1)
    )
