"""Section forces of a blade: axial force, shear and moment at any place of a flexible piece."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.beam import local, paired
from flexcli.mechanics.mesh import Segment, column, pick
from flexcli.mechanics.state import Equilibrium, Part
from flexcli.numerics.collocation import gauss_nodes, integration_to, interpolation_matrix

__all__ = ["Section", "along_piece", "applied", "flexible_pieces", "section_forces"]

Floats = NDArray[np.float64]


class Section(NamedTuple):
    """Sections of a blade (designs, points): place [m], thickness, width [m], ψ [rad], N, Q, M."""

    s: Floats
    h: Floats
    b: Floats
    psi: Floats
    N: Floats
    Q: Floats
    M: Floats


def flexible_pieces(part: Part, blade: int) -> tuple[Segment, ...]:
    """Return the flexible segments of a blade, from its start."""
    k, a = _place(part, blade)
    return tuple(s for s in part.assembly.meshes[k].segments[a] if s.piece is not None)


def section_forces(
    state: Equilibrium, part: Part, blade: int, segment: Segment, u: Floats
) -> Section:
    """Return rotation from the start, forces [N] and moment [N·m] at u of a flexible segment.

    Parameters
    ----------
    state : Equilibrium
        The designs in equilibrium.
    part : Part
        Those of its designs that are asked for.
    blade : int
        Number of the blade.
    segment : Segment
        One of ``flexible_pieces``.
    u : array, shape (designs of the part or 1, points)
        Places on the segment, from −1 to 1.

    Returns
    -------
    Section
        Rotation is interpolated; the moment is integrated from the end, so that statics holds.

    """
    if segment.piece is None:
        raise ValueError("a rigid segment has no stress")
    k, a = _place(part, blade)
    assembly, mesh, rows = part.assembly, part.assembly.meshes[k], part.rows
    rotations, forces, motions = assembly.split(part.x)
    q = assembly.local_forces(forces, motions, k, rows)
    f = local(mesh, rows, rotations[k], paired(q[..., 0], q[..., 1])).f[:, a]
    q, psi_at, w = q[:, a], rotations[k][:, a], _of_blade(mesh.w, a, part)
    nodes = slice(segment.first, segment.first + segment.nodes)
    psi = applied(interpolation_matrix(segment.nodes, u), psi_at[:, nodes])
    weights = gauss_nodes(segment.nodes)[1]
    rest = (weights - integration_to(segment.nodes, u)) / weights
    f_ds = w * f
    M = q[:, 2, None] + applied(rest, f_ds[:, nodes])
    M += np.sum(f_ds[:, nodes.stop :], axis=-1, keepdims=True)
    n_x, n_y = q[:, 0, None], q[:, 1, None]
    l, EI = (_of_blade(v[..., None], a, part) for v in (mesh.l, mesh.EI))
    s, h = (
        along_piece(function, state, part, u)
        for function in (segment.piece.position, segment.piece.thickness)
    )
    b = pick(column(assembly.layout.blades[blade].b), rows)[:, None]
    return Section(
        s=s,
        h=h,
        b=np.broadcast_to(b, s.shape),
        psi=psi,
        N=(n_x * np.cos(psi) + n_y * np.sin(psi)) * EI / l**2,
        Q=(n_y * np.cos(psi) - n_x * np.sin(psi)) * EI / l**2,
        M=M * EI / l,
    )


def applied(matrices: Floats, values: Floats) -> Floats:
    """Return matrices (designs or 1, points, n) times values (designs, n), (designs, points)."""
    if matrices.shape[0] == 1:
        # no BLAS: a design has the same digits alone and among others
        return np.asarray(np.einsum("pk,nk->np", matrices[0], values))
    return np.asarray(np.sum(matrices * values[:, None], axis=-1))


def along_piece(
    function: Callable[[Floats], Floats], state: Equilibrium, part: Part, u: Floats
) -> Floats:
    """Return a function of a piece at u (designs of a part or 1, points), for those designs."""
    # a piece knows the numbers of all designs
    everywhere = u
    if u.shape[0] > 1:
        everywhere = np.zeros((state.designs, u.shape[1]))
        everywhere[part.rows] = u
    return np.broadcast_to(function(everywhere), (state.designs, u.shape[1]))[part.rows]


def _place(part: Part, blade: int) -> tuple[int, int]:
    """Return the mesh of a blade and its number in it."""
    for k, mesh in enumerate(part.assembly.meshes):
        if blade in mesh.blades:
            return k, mesh.blades.index(blade)
    raise IndexError(f"no blade {blade}")


def _of_blade(values: Floats, a: int, part: Part) -> Floats:
    """Return the numbers of one blade for the designs of a part."""
    return pick(values, part.rows)[:, min(a, values.shape[1] - 1)]
