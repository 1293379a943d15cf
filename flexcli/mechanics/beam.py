"""One blade as a geometrically exact beam (Reissner): end motion and flexibility from its forces.

The blade lies in the frame of its start, x along it at rest. The force (n_x, n_y) is constant
along it (nothing loads it between its ends) and m is the moment at its end; with the rotation ψ(s)
of the section, ``N = n_x cos ψ + n_y sin ψ`` and ``Q = n_y cos ψ − n_x sin ψ``,

    ψ' = c M,  M(s) = m + ∫_s^1 f,  f = Q (1 + ρ N),  ρ = 1/EA − 1/κGA,
    x' = (1 + N/EA) cos ψ − (Q/κGA) sin ψ,  y' = (1 + N/EA) sin ψ + (Q/κGA) cos ψ.

All is scaled as in :mod:`flexcli.mechanics.mesh`. The compliances 1/EA and 1/κGA stand on top of no
fraction bar, so that they may vanish: slender and inextensible blades lose no digits.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.mesh import Mesh, pick
from flexcli.numerics.stack import solve_stack

__all__ = ["Condensed", "Local", "condense", "local", "section_forces"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


class Local(NamedTuple):
    """What the sections feel (designs, blades, K): N, Q, f, ∂f/∂(ψ, n_x, n_y), motion rates."""

    N: Floats
    Q: Floats
    f: Floats
    f_psi: Floats
    f_x: Floats
    f_y: Floats
    cos: Floats
    sin: Floats
    shortening: Floats
    rise: Floats


class Condensed(NamedTuple):
    """A blade after its rotations ψ are eliminated from the linearised equations.

    ``motion`` (designs, blades, 3) is (x − 1, y, ψ) of the end once ψ has followed, ``F`` its
    derivative by (n_x, n_y, m), symmetric; ψ changes by ``free + follow δ(n_x, n_y, m)``.
    """

    motion: Floats
    F: Floats
    free: Floats
    follow: Floats


def local(mesh: Mesh, rows: Integers, psi: Floats, q: Floats) -> Local:
    """Return forces and motion rates of the sections at the nodes, x' as x' − 1."""
    axial, shear, rho = (pick(a, rows) for a in (mesh.axial, mesh.shear, mesh.rho))
    n_x, n_y = q[..., 0, None], q[..., 1, None]
    # 1 − cos by the half angle: small strokes keep their digits
    versine = 2.0 * np.sin(psi / 2.0) ** 2
    sin, cos = np.sin(psi), 1.0 - versine
    N, Q = n_x * cos + n_y * sin, n_y * cos - n_x * sin
    stretch, slide = 1.0 + rho * N, rho * Q
    elongation, shear_angle = axial * N, shear * Q
    return Local(
        N=N,
        Q=Q,
        f=Q * stretch,
        f_psi=slide * Q - N * stretch,
        f_x=slide * cos - sin * stretch,
        f_y=cos * stretch + slide * sin,
        cos=cos,
        sin=sin,
        shortening=elongation * cos - shear_angle * sin - versine,
        rise=sin + elongation * sin + shear_angle * cos,
    )


def condense(mesh: Mesh, rows: Integers, psi: Floats, q: Floats) -> Condensed:
    """Return the blades' end motions and flexibilities about rotations psi and forces q.

    Parameters
    ----------
    mesh : Mesh
        The blades.
    rows : array of int
        The designs that the first axes of psi and q belong to.
    psi : array, shape (designs, blades, K)
        Rotations at the nodes [rad].
    q : array, shape (designs, blades, 3)
        Forces (n_x, n_y) [EI/l²] in the frame of the start and moments m at the end [EI/l].

    Returns
    -------
    Condensed
        End motions, flexibilities and how the rotations follow.

    """
    at = local(mesh, rows, psi, q)
    w, A, turn, far_turn = (pick(a, rows) for a in (mesh.w, mesh.A, mesh.turn, mesh.far_turn))
    axial, shear, rho = (pick(a, rows) for a in (mesh.axial, mesh.shear, mesh.rho))
    K = mesh.nodes
    made = _times(np.stack([at.f, at.f_x, at.f_y], axis=-2), A)
    right = np.empty((*psi.shape, 4))
    right[..., 0] = made[..., 0, :] + turn * q[..., 2, None] - psi
    right[..., 1] = made[..., 1, :]
    right[..., 2] = made[..., 2, :]
    right[..., 3] = turn
    matrix = A * -at.f_psi[..., None, :]
    matrix[..., np.arange(K), np.arange(K)] += 1.0
    solution = solve_stack(matrix, right)
    effect = np.empty((*psi.shape[:-1], 3, K))
    effect[..., 0, :] = w * at.f_x
    effect[..., 1, :] = w * at.f_y
    effect[..., 2, :] = far_turn * at.f_psi
    through = effect @ solution
    # what the forces do with the rotations held: all sums over the nodes at once
    sums = np.empty((*psi.shape[:-1], 8, K))
    sums[..., 0, :] = axial - rho * at.sin**2
    sums[..., 1, :] = shear + rho * at.sin**2
    sums[..., 2, :] = rho * at.sin * at.cos
    sums[..., 3, :], sums[..., 4, :] = at.shortening, at.rise
    sums[..., 5, :], sums[..., 6, :], sums[..., 7, :] = at.f, at.f_x, at.f_y
    weights = np.stack(np.broadcast_arrays(w, far_turn), axis=-1)
    total = sums @ weights
    F, end_turn = through[..., 1:].copy(), pick(mesh.end_turn, rows)
    F[..., 0, 0] += total[..., 0, 0]
    F[..., 1, 1] += total[..., 1, 0]
    F[..., 0, 1] += total[..., 2, 0]
    F[..., 1, 0] += total[..., 2, 0]
    F[..., 2, :2] += total[..., 6:, 1]
    F[..., 2, 2] += end_turn
    motion = through[..., 0].copy()
    motion[..., :2] += total[..., 3:5, 0]
    motion[..., 2] += end_turn * q[..., 2] + total[..., 5, 1]
    return Condensed(motion, F, solution[..., 0], solution[..., 1:])


def section_forces(
    mesh: Mesh, rows: Integers, psi: Floats, q: Floats
) -> tuple[Floats, Floats, Floats]:
    """Return N, Q [EI/l²] and M [EI/l] with the ends' M first and last, (designs, blades, K + 2).

    N and Q at the start belong to ψ = 0; those at the end to the rotation of the end.
    """
    at = local(mesh, rows, psi, q)
    w, back, end_turn, far_turn = (
        pick(a, rows) for a in (mesh.w, mesh.back, mesh.end_turn, mesh.far_turn)
    )
    m = q[..., 2, None]
    inner = m + _times(at.f[..., None, :], back)[..., 0, :]
    start = m + np.sum(w * at.f, axis=-1, keepdims=True)
    end = end_turn[..., None] * m + np.sum(far_turn * at.f, axis=-1, keepdims=True)
    M = np.concatenate([start, inner, m], axis=-1)
    all_psi = np.concatenate([np.zeros_like(m), psi, end], axis=-1)
    n_x, n_y = q[..., 0, None], q[..., 1, None]
    cos, sin = np.cos(all_psi), np.sin(all_psi)
    return n_x * cos + n_y * sin, n_y * cos - n_x * sin, M


def _times(vectors: Floats, matrix: Floats) -> Floats:
    """Return matrix @ vector for vectors (designs, blades, m, K), in one product if all agree."""
    if matrix.shape[:2] == (1, 1):
        flat = vectors.reshape(-1, vectors.shape[-1]) @ matrix[0, 0].T
        return np.asarray(flat.reshape(vectors.shape))
    return np.asarray(vectors @ np.swapaxes(matrix, -1, -2))
