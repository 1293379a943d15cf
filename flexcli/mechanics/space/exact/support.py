"""Support stiffness of a body at an equilibrium in space, its drive locked or free.

A small test load finds a small displacement and a small rotation (as a vector) from the pose; the
moment that works on them is that about axes fixed in space. Everything that the equilibrium does
not hold is free to follow, under loads that keep their size and direction.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.rigid_motion import motion_at
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.rotation import matrix_of, moved
from flexcli.mechanics.space.exact.second_variation import inertia_count
from flexcli.mechanics.space.layout import Vector
from flexcli.numerics.modes import Vibration, vibration_of
from flexcli.numerics.stack import solve_stack

__all__ = [
    "PointMass",
    "driven_stiffness",
    "support_compliance",
    "unstable_when_free",
    "vibration",
]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


def support_compliance(
    state: SpaceEquilibrium, body: str, point: Vector, *, free: Sequence[int] = ()
) -> Floats:
    """Return ∂(shift, rotation)/∂(force, moment) of a point of a body about an equilibrium.

    Parameters
    ----------
    state : SpaceEquilibrium
        The mechanism in equilibrium.
    body : str
        Name of the body.
    point : tuple of float
        The point of the body as it is at rest [m]; it moved with the body.
    free : sequence of int
        Coordinates (6 body + 0…5, in the bodies' frames) that the equilibrium holds and the test
        load does not: the drive, where it is to be free under a force that keeps its size.

    Returns
    -------
    array, shape (6, 6)
        Compliance along the axes of the drawing [m/N, 1/N, rad/(N·m)], symmetric. With nothing
        freed, the drive is locked. The support stiffness along an axis, all other motions free,
        is one over the diagonal; the diagonal is negative where the equilibrium is unstable.

    """
    part, assembly = state.part, state.part.assembly
    follow = _with(part.demand.free, free)
    G = _compliance(state, follow)
    i = state.layout.index(body)
    own = np.zeros((6, follow.size))
    at = np.flatnonzero(follow // 6 == i)
    own[follow[at] % 6, at] = 1.0
    arm = _arm(state, i, point)
    Y = motion_at(arm) @ state.linearised.basis[i] @ own
    unit = np.repeat([assembly.length, 1.0], 3)
    C = Y @ G @ Y.T
    return np.asarray(C * np.outer(unit, unit) / (assembly.force * assembly.length))


def driven_stiffness(state: SpaceEquilibrium, coordinate: int) -> float:
    """Return the tangent of the effort in a coordinate that is held, all others free as they are.

    ``coordinate`` is 6 body + 0…5; the stiffness is in N/m or N·m/rad.
    """
    assembly = state.part.assembly
    follow = _with(state.part.demand.free, (coordinate,))
    own = int(np.searchsorted(follow, coordinate))
    unit = assembly.length if coordinate % 6 < 3 else 1.0
    stiffness = 1.0 / _compliance(state, follow)[own, own]
    return float(stiffness * assembly.force * assembly.length / unit**2)


def unstable_when_free(state: SpaceEquilibrium, free: Sequence[int]) -> int:
    """Return in how many directions it is unstable when coordinates that it holds are freed.

    What held them is taken for an effort that keeps its size.
    """
    follow = _with(state.part.demand.free, free)
    return inertia_count(state.variation, follow, state.part.assembly.blades)


class PointMass(NamedTuple):
    """A mass [kg] that moves with a body, its place at rest, its inertia about any axis [kg m²]."""

    body: str
    place: Vector
    mass: float
    inertia: float


def vibration(
    state: SpaceEquilibrium, *, free: Sequence[int] = (), besides: Sequence[PointMass] = ()
) -> Vibration:
    """Return the small vibrations of the bodies about an equilibrium, blades without mass.

    Parameters
    ----------
    state : SpaceEquilibrium
        The mechanism in equilibrium, its bodies with mass.
    free : sequence of int
        Coordinates freed, as in :func:`support_compliance`; none of them: drive locked.
    besides : sequence of PointMass
        What moves with the bodies besides their own mass, such as halves of blades.

    Returns
    -------
    Vibration
        One design: frequencies, and shapes in the free coordinates.

    """
    assembly = state.part.assembly
    follow = _with(state.part.demand.free, free)
    unit = np.tile(np.repeat([assembly.length, 1.0], 3), assembly.bodies)[follow]
    G = _compliance(state, follow) * np.outer(unit, unit) / (assembly.force * assembly.length)
    M = np.zeros((6 * assembly.bodies, 6 * assembly.bodies))
    for i, body in enumerate(state.layout.bodies):
        R = matrix_of(assembly.at(state.part.x).turn[i])
        own = np.zeros((6, 6))
        own[:3, :3] = body.mass * np.eye(3)
        own[3:, 3:] = R @ np.asarray(body.inertia) @ R.T
        if body.mass > 0.0:
            at = motion_at(_arm(state, i, body.com) * assembly.length)
            own = at.T @ own @ at
        for point in besides:
            if point.body == body.name:
                at = motion_at(_arm(state, i, point.place) * assembly.length)
                own += at.T @ np.diag([point.mass] * 3 + [point.inertia] * 3) @ at
        rows = slice(6 * i, 6 * i + 6)
        basis = state.linearised.basis[i]
        M[rows, rows] = basis.T @ own @ basis
    return vibration_of(M[follow[:, None], follow][None], G[None])


def _with(free: Integers, more: Sequence[int]) -> Integers:
    return np.union1d(free, np.asarray(more, dtype=np.intp)).astype(np.intp)


def _compliance(state: SpaceEquilibrium, follow: Integers) -> Floats:
    """Return the scaled compliance of coordinates, all blades following."""
    k_f = 6 * state.part.assembly.blades
    unknown = np.concatenate([np.arange(k_f), k_f + follow])
    H, scale = state.variation.matrix, state.linearised.row_scale[unknown]
    unit = np.zeros((unknown.size, follow.size))
    unit[k_f:] = np.eye(follow.size)
    found = solve_stack(H[unknown[:, None], unknown] * scale[:, None], unit)[k_f:]
    return np.asarray((found + found.T) / 2.0)


def _arm(state: SpaceEquilibrium, body: int, point: Vector) -> Floats:
    """Return the arm to a point of a body, turned with it, in scaled lengths."""
    assembly = state.part.assembly
    arm = np.asarray(point) / assembly.length - assembly.points[body]
    return np.asarray(arm + moved(assembly.at(state.part.x).turn[body], arm))
