"""Tangent stiffness and compliance at an equilibrium, all blades and free bodies following."""

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.mesh import pick
from flexcli.mechanics.state import Equilibrium, Part
from flexcli.numerics.stack import solve_stack

__all__ = ["body_stiffness", "free_compliance", "held_stiffness"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


def body_stiffness(state: Equilibrium, body: str) -> Floats:
    """Return the tangent stiffness of a body at its reference point.

    ``K = ∂(F_x, F_y, M)/∂(x, y, φ)`` with dead loads; bodies that are free follow, what else is
    held stays, and the body's own coordinates are moved whether held or free.

    Parameters
    ----------
    state : Equilibrium
        The designs in equilibrium.
    body : str
        Name of the body.

    Returns
    -------
    array, shape (designs, 3, 3)
        Stiffness [N/m, N/rad, N·m/rad], symmetric under dead loads.

    Notes
    -----
    Blades must be extensible: between inextensible ones a body has no finite stiffness along
    them, and the array holds NaN; its compliance is always there.

    """
    index = state.layout.index(body)
    own = 3 * index + np.arange(3)
    values = []
    for part in state.parts:
        others = np.setdiff1d(part.demand.free, own)
        values.append(_condensed(state, part, own, others))
    return state.scatter(values)


def held_stiffness(state: Equilibrium) -> Floats:
    """Return ∂(reactions)/∂(held motions), free bodies following (designs, held, held) [SI].

    The order is that of the bodies, and x, y, φ within one.
    """
    values = [_condensed(state, p, p.demand.held, p.demand.free) for p in state.parts]
    return state.scatter(values)


def free_compliance(state: Equilibrium) -> Floats:
    """Return ∂(free motions)/∂(forces on them) at an equilibrium.

    Parameters
    ----------
    state : Equilibrium
        The designs in equilibrium.

    Returns
    -------
    array, shape (designs, free, free)
        Compliance [m/N, rad/N, rad/(N·m)] by body, and x, y, φ within one; zero along what
        inextensible blades hold, negative where the equilibrium is unstable.

    """
    values = []
    for part, at in zip(state.parts, state.linearised, strict=True):
        k_f = 3 * part.assembly.blades
        unknown = np.concatenate([np.arange(k_f), k_f + part.demand.free])
        matrix = at.matrix[:, unknown[:, None], unknown] * at.row_scale[:, unknown, None]
        unit = np.zeros((unknown.size, part.demand.free.size))
        unit[k_f:] = np.eye(part.demand.free.size)
        compliance = solve_stack(matrix, np.broadcast_to(unit, (matrix.shape[0], *unit.shape)))
        size = _units(part, part.demand.free)
        compliance = compliance[:, k_f:]
        energy = pick(part.assembly.length * part.assembly.force, part.rows)[:, None, None]
        values.append(compliance * size[:, :, None] * size[:, None, :] / energy)
    return state.scatter(values)


def _condensed(state: Equilibrium, part: Part, keep: Integers, free: Integers) -> Floats:
    """Return the stiffness on the coordinates kept, blades and the free coordinates following."""
    at = state.linearised[[p is part for p in state.parts].index(True)]
    k_f = 3 * part.assembly.blades
    gone = np.concatenate([np.arange(k_f), k_f + free])
    kept = k_f + keep
    square = at.matrix[:, gone[:, None], gone] * at.row_scale[:, gone, None]
    coupling = at.matrix[:, gone[:, None], kept] * at.row_scale[:, gone, None]
    follow = solve_stack(square, coupling)
    K = at.matrix[:, kept[:, None], kept] - at.matrix[:, kept[:, None], gone] @ follow
    size = _units(part, keep)
    energy = pick(part.assembly.length * part.assembly.force, part.rows)[:, None, None]
    return np.asarray(K * energy / (size[:, :, None] * size[:, None, :]))


def _units(part: Part, coordinates: Integers) -> Floats:
    """Return the units [m] or [rad] of the scaled coordinates (designs, n)."""
    length = np.broadcast_to(pick(part.assembly.length, part.rows), (part.rows.size,))
    return np.where(coordinates % 3 == 2, 1.0, length[:, None])
