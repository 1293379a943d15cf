"""Scaled unknowns of an assembly as motions [m, rad], blade forces and reactions [N, N·m]."""

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.assembly import Assembly
from flexcli.mechanics.mesh import pick

__all__ = ["blade_forces", "body_forces", "body_motions"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


def body_motions(assembly: Assembly, x: Floats, rows: Integers) -> Floats:
    """Return (x [m], y [m], φ [rad]) of the reference point of each body (designs, bodies, 3)."""
    motions = assembly.split(x)[2].copy()
    motions[..., :2] *= pick(assembly.length, rows)[:, None, None]
    return motions


def blade_forces(assembly: Assembly, x: Floats, rows: Integers) -> Floats:
    """Return force (x, y) [N] and moment [N·m] on the end of each blade (designs, blades, 3)."""
    forces = assembly.split(x)[1].copy()
    for mesh in assembly.meshes:
        index = list(mesh.blades)
        l = pick(mesh.l, rows)
        moment = pick(mesh.EI, rows) / l
        forces[:, index, :2] *= (moment / l)[..., None]
        forces[:, index, 2] *= moment
    return forces


def body_forces(assembly: Assembly, held: Integers, left: Floats, rows: Integers) -> Floats:
    """Return what is left on the held coordinates as forces on bodies (designs, bodies, 3)."""
    row = np.zeros_like(left)
    row[:, held] = left[:, held]
    reaction = row.reshape(len(left), -1, 3)
    reaction *= pick(assembly.force, rows)[:, None, None]
    reaction[..., 2] *= pick(assembly.length, rows)[:, None]
    return reaction
