"""Freedoms and over-constraints of a mechanism of ideal blades, and what a misfit of one costs.

An ideal blade is rigid along itself, across its width and in bending of its width, a rod along
itself alone; both are free in the rest.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.blade_spring import deformation_rows
from flexcli.formulas.rigid_motion import motion_along
from flexcli.mechanics.space.linear import SpaceAssembly

__all__ = ["Freedoms", "freedoms", "misfit"]

Floats = NDArray[np.float64]

RANK = 1e-7
"""Share of the largest singular value from which a combination of constraints is one."""


class Freedoms(NamedTuple):
    """How many motions ideal blades leave, and how many constraints they have too many.

    ``of_moving`` are those of the moving body alone. ``weakest`` is the least singular value that
    counts as a constraint, ``none`` the largest that does not, both over the largest: lengths are
    in units of the mean length of a blade.
    """

    of_all: int
    of_moving: int
    overconstraints: int
    weakest: float
    none: float


def freedoms(assembly: SpaceAssembly) -> Freedoms:
    """Return the freedoms and over-constraints of ideal blades and rods.

    The rank of their constraints is that of the singular values of ``J d = 0``.

    Parameters
    ----------
    assembly : SpaceAssembly
        The mechanism; springs to the ground are no constraints.

    Returns
    -------
    Freedoms
        Their numbers, and how clear they are.

    Notes
    -----
    For the pose of the drawing and small motion; the drive is free.

    """
    length = float(np.mean([member.l for member in assembly.members]))
    units = np.tile([1.0, 1.0, 1.0, 1.0 / length, 1.0 / length, 1.0 / length], assembly.size // 6)
    J = []
    for k, member in enumerate(assembly.members):
        for spring in member.constrains:
            lengths = 1.0 if spring < 3 else length
            J.append(lengths * assembly.rows[6 * k + spring] * units)
    # rows of nothing, so that the free directions are there where the constraints are few
    rows = np.pad(np.array(J), [(0, max(assembly.size - len(J), 0)), (0, 0)])
    _, values, Vt = np.linalg.svd(rows, full_matrices=False)
    rank = int(np.sum(values > RANK * values[0]))
    free = Vt[rank:].T[assembly.moving]
    own = np.linalg.svd(free, compute_uv=False) if free.shape[1] else np.zeros(0)
    return Freedoms(
        of_all=assembly.size - rank,
        of_moving=int(np.sum(own > RANK)),
        overconstraints=len(J) - rank,
        weakest=float(values[rank - 1] / values[0]),
        none=float(values[rank] / values[0]) if rank < len(values) else 0.0,
    )


def misfit(assembly: SpaceAssembly, blade: int, motions: Floats) -> Floats:
    """Return the deformations of the springs of a blade whose end misses its seat.

    Parameters
    ----------
    assembly : SpaceAssembly
        The mechanism.
    blade : int
        Which of its blades.
    motions : array, shape (6, columns)
        How far its seat on the second body is off, at the blade's end along the axes of the
        drawing [m, rad].

    Returns
    -------
    array, shape (rows, columns)
        Deformations where nothing moves, as :meth:`SpaceAssembly.moved` takes them.

    """
    member = assembly.members[blade]
    found = np.zeros((len(assembly.rows), motions.shape[1]))
    end = deformation_rows(member.springs, np.array([member.l, 0.0, 0.0]))
    found[6 * blade : 6 * blade + 6] = end @ motion_along(member.axes) @ motions
    return found
