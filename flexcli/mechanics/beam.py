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

from flexcli.mechanics.mesh import Mesh, across, pick
from flexcli.numerics.stack import solve_across

__all__ = ["Condensed", "Local", "condense", "local", "section_forces"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


class Local(NamedTuple):
    """What the sections feel at the nodes: N, Q, f, ∂f/∂(ψ, n_x, n_y), motion rates."""

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

    ``motion`` (blades, 3, designs) is (x − 1, y, ψ) of the end once ψ has followed, ``F`` (blades,
    3, 3, designs) its derivative by (n_x, n_y, m), symmetric; ψ changes by
    ``free + follow δ(n_x, n_y, m)``.
    """

    motion: Floats
    F: Floats
    free: Floats
    follow: Floats


def local(mesh: Mesh, rows: Integers, psi: Floats, q: Floats) -> Local:
    """Return forces and motion rates of the sections at the nodes, (designs, blades, K)."""
    axial, shear, rho = (pick(a, rows) for a in (mesh.axial, mesh.shear, mesh.rho))
    return _local(axial, shear, rho, psi, q[..., 0, None], q[..., 1, None])


def _local(
    axial: Floats, shear: Floats, rho: Floats, psi: Floats, n_x: Floats, n_y: Floats
) -> Local:
    """Return forces and motion rates of sections, x' as x' − 1."""
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
        The designs that the last axes of psi and q belong to.
    psi : array, shape (blades, K, designs)
        Rotations at the nodes [rad].
    q : array, shape (blades, 3, designs)
        Forces (n_x, n_y) [EI/l²] in the frame of the start and moments m at the end [EI/l].

    Returns
    -------
    Condensed
        End motions, flexibilities and how the rotations follow.

    """
    w, A, turn, far_turn, end_turn = (
        across(a, rows) for a in (mesh.w, mesh.A, mesh.turn, mesh.far_turn, mesh.end_turn)
    )
    axial, shear, rho = (across(a, rows) for a in (mesh.axial, mesh.shear, mesh.rho))
    m = q[:, 2, None]
    at = _local(axial, shear, rho, psi, q[:, 0, None], q[:, 1, None])
    blades, K, designs = psi.shape
    made = _together(at.f, at.f_x, at.f_y)
    right = np.empty((blades, K, 4, designs))
    right[:, :, :3] = np.einsum("bikn,bkjn->bijn", A, made)
    right[:, :, 0] += turn * m - psi
    right[:, :, 3] = turn
    matrix = np.empty((blades, K, K, designs))
    np.multiply(A, -at.f_psi[:, None], out=matrix)
    matrix.reshape(blades, K * K, designs)[:, :: K + 1] += 1.0
    solution = solve_across(matrix, right)
    effect = _together(w * at.f_x, w * at.f_y, far_turn * at.f_psi)
    through = np.einsum("bkin,bkjn->bijn", effect, solution)
    # what the forces do with the rotations held: all sums over the nodes at once
    bent = rho * at.sin**2
    held = _together(axial - bent, shear + bent, rho * at.sin * at.cos, at.shortening, at.rise)
    held_sum = np.einsum("bkn,bkjn->bjn", w, held)
    made_sum = np.einsum("bkn,bkjn->bjn", far_turn, made)
    motion, F = through[:, :, 0], through[:, :, 1:]
    motion[:, :2] += held_sum[:, 3:]
    motion[:, 2] += end_turn * q[:, 2] + made_sum[:, 0]
    F[:, 0, 0] += held_sum[:, 0]
    F[:, 1, 1] += held_sum[:, 1]
    F[:, 0, 1] += held_sum[:, 2]
    F[:, 1, 0] += held_sum[:, 2]
    F[:, 2, :2] += made_sum[:, 1:]
    F[:, 2, 2] += end_turn
    return Condensed(motion, F, solution[:, :, 0], solution[:, :, 1:])


def _together(*parts: Floats) -> Floats:
    """Return arrays (blades, K, designs) as one (blades, K, parts, designs)."""
    blades, K, designs = parts[0].shape
    found = np.empty((blades, K, len(parts), designs))
    for i, part in enumerate(parts):
        found[:, :, i] = part
    return found


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
    inner = m + np.sum(back * at.f[..., None, :], axis=-1)
    start = m + np.sum(w * at.f, axis=-1, keepdims=True)
    end = end_turn[..., None] * m + np.sum(far_turn * at.f, axis=-1, keepdims=True)
    M = np.concatenate([start, inner, m], axis=-1)
    all_psi = np.concatenate([np.zeros_like(m), psi, end], axis=-1)
    n_x, n_y = q[..., 0, None], q[..., 1, None]
    cos, sin = np.cos(all_psi), np.sin(all_psi)
    return n_x * cos + n_y * sin, n_y * cos - n_x * sin, M
