"""Blades as geometrically exact beams in space (Simo & Reissner): end motions from end forces.

A blade lies in the frame of its start, x along it at rest. Nothing loads it between its ends: its
force n is constant, and its moment is that at the end, m, and ``(r(1) − r(s)) × n``. With the
rotation R of a section (quaternion q), the forces ``N = Rᵀ n`` and moments ``M = Rᵀ m(s)`` that it
feels and its twist rate τ,

    q' = ½ q ∘ κ,  κ = (τ, c_y M_y, κ_z(M_z, τ)),
    r' = R (e_x + Γ),  Γ = (c_x N_x − ½ ρ² τ², c_sy N_y, c_sz N_z),
    M_x = GJ τ + ρ² N_x τ + W τ³ + T(M_z, τ) − (EΓ τ')',  τ = 0 at clamps,

with κ_z and T of a section that curls (:mod:`flexcli.mechanics.space.exact.section_law`).

All is scaled as in :mod:`flexcli.mechanics.space.exact.section`; q and τ sit at Gauss nodes
(collocation, order twice their number at the end). The compliances c stand on top of no fraction
bar: wide, thin and inextensible blades lose no digits.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.exact.mesh import Mesh
from flexcli.mechanics.space.exact.rotation import conjugate, cross, matrix_of, moved, skew, spun
from flexcli.mechanics.space.exact.section_law import Curled, curled
from flexcli.numerics.stack import solve_stack

__all__ = ["Along", "Condensed", "along", "condense", "moments"]

Floats = NDArray[np.float64]

_E_X = np.array([1.0, 0.0, 0.0])


class Along(NamedTuple):
    """What the sections feel at the nodes (blades, K, …): R, N, Γ, m, M, κ and how they curl."""

    R: Floats
    N: Floats
    strain: Floats
    rate: Floats
    m: Floats
    M: Floats
    kappa: Floats
    law: Curled


class Condensed(NamedTuple):
    """Blades after q and τ at the nodes are eliminated from the linearised equations.

    ``motion`` (blades, 3) is r(1) − e_x and ``turn`` (blades, 4) the rotation of the end, once the
    nodes have followed; ``F`` (blades, 6, 6) takes (δn, δm) to δr(1) and the spin of the end. The
    nodes change by ``free + follow δ(n, m)``.
    """

    motion: Floats
    turn: Floats
    F: Floats
    free: Floats
    follow: Floats


def along(mesh: Mesh, z: Floats, f: Floats) -> Along:
    """Return what the sections feel, of nodes z (blades, K, 5) = (q, τ) and forces f (blades, 6).

    ``rate`` is r' − e_x.
    """
    q, tau = z[..., :4], z[..., 4]
    n = f[:, None, :3]
    N = n + moved(conjugate(q), n)
    strain = mesh.C * N
    strain[..., 0] += mesh.grown - 0.5 * mesh.polar * tau**2
    R = matrix_of(q)
    rate = moved(q, _E_X) + (R @ strain[..., None])[..., 0]
    m = moments(mesh, rate, f)
    M = m + moved(conjugate(q), m)
    law = curled(M[..., 2], tau, mesh.clamped, mesh.curl, mesh.nu)
    law = Curled(*(np.where(mesh.flexible > 0.0, each, 0.0) for each in law))
    kappa = np.stack([tau + mesh.spin * M[..., 0], mesh.bend_y * M[..., 1], law.kappa], axis=-1)
    return Along(R, N, strain, rate, m, M, kappa, law)


def moments(mesh: Mesh, rate: Floats, f: Floats) -> Floats:
    """Return the moments at the nodes in the frame of the start (blades, K, 3)."""
    lever = mesh.back @ (rate + _E_X)
    return np.asarray(f[:, None, 3:] + cross(lever, f[:, None, :3]))


def condense(mesh: Mesh, z: Floats, f: Floats) -> Condensed:
    """Return the blades' end motions and flexibilities about nodes z and forces f.

    Parameters
    ----------
    mesh : Mesh
        The blades.
    z : array, shape (blades, K, 5)
        Rotations (unit quaternions) and twist rates at the nodes.
    f : array, shape (blades, 6)
        Force [EI/l²] and moment at the end [EI/l] in the frame of the start.

    Returns
    -------
    Condensed
        End motions, flexibilities and how the nodes follow.

    Notes
    -----
    Linearised in spins θ of the sections, ``θ' = R (δκ + κ − κ(q))`` and ``δM = Rᵀ (δm + m × θ)``,
    with κ(q) the curvature of the nodes as they are: the flexibilities are then those of a
    conservative blade even where the nodes are no solution yet, without which Newton's method
    loses its way among blades that are stiff along themselves.

    """
    at = along(mesh, z, f)
    B, K = mesh.w.shape
    q, tau, polar = z[..., :4], z[..., 4], mesh.polar * z[..., 4]
    n = skew(f[:, None, :3])
    R_t = np.swapaxes(at.R, -1, -2)
    axis = at.R[..., 0]
    rate = at.rate + _E_X
    # r' by (θ, τ) and by n; the forces are those of the frame of the start
    Q = (at.R * mesh.C[..., None, :]) @ R_t
    P = np.empty((B, K, 3, 4))
    P[..., :3] = Q @ n - skew(rate)
    P[..., 3] = -polar[..., None] * axis
    # Φ = (θ', T − M_x) by δm, by (θ, τ) and by n at the same node
    by_m = np.empty((B, K, 4, 3))
    across, law = at.R[..., 2], at.law
    bend = np.stack([mesh.spin, mesh.bend_y, law.compliance], axis=-1)
    by_m[..., :3, :] = (at.R * bend[..., None, :]) @ R_t
    by_m[..., 3, :] = -axis - law.coupling[..., None] * across
    by_z = np.empty((B, K, 4, 4))
    by_z[..., :3] = by_m @ skew(at.m)
    by_z[..., 3, :3] += polar[..., None] * (axis[..., None, :] @ n)[..., 0, :]
    by_z[..., :3, 3] = axis + law.coupling[..., None] * across
    by_z[..., 3, 3] = mesh.torsion + mesh.polar * at.N[..., 0] + 3.0 * mesh.fibres * tau**2
    by_z[..., 3, 3] += law.stiffness
    # m = m(1) + lever × n, the lever being what integrates r' to the end
    by_lever = -by_m @ n
    far = (mesh.back @ Q.reshape(B, K, 9)).reshape(B, K, 3, 3)
    by_f = np.concatenate([by_m @ skew(mesh.back @ rate) + by_lever @ far, by_m], axis=-1)
    by_f[..., 3, :3] += polar[..., None] * axis
    # rows (component, node), columns (node, component)
    ahead = np.ascontiguousarray(np.moveaxis(P, 2, 1)).reshape(B, 3, 4 * K)
    levers = np.moveaxis(by_lever, 2, 1).reshape(B, 4 * K, 3)
    through = (levers @ ahead).reshape(B, 4, K, K, 4)
    through *= mesh.back[:, None, :, :, None]
    j = np.arange(K)
    through[:, :, j, j] += np.moveaxis(by_z, 2, 1)
    rows = through.reshape(B, 4, K, 4 * K)
    pushed = np.moveaxis(by_f, 2, 1)
    bent, end = mesh.kinematics(q, at.kappa)
    torque = (mesh.torsion + mesh.polar * at.N[..., 0] + mesh.fibres * tau**2) * tau - at.M[..., 0]
    torque += law.torque
    matrix, right = np.empty((B, 4, K, 4 * K)), np.empty((B, 4, K, 7))
    matrix[:, :3], matrix[:, 3] = -(mesh.J[:, None] @ rows[:, :3]), mesh.twist @ rows[:, 3]
    right[:, :3, :, 1:] = mesh.J[:, None] @ pushed[:, :3]
    right[:, 3, :, 1:] = -(mesh.twist @ pushed[:, 3])
    right[:, :3, :, 0] = np.swapaxes(mesh.along @ bent, 1, 2)
    right[:, 3, :, 0] = -mesh.hold * tau - (mesh.twist @ torque[..., None])[..., 0]
    square = matrix.reshape(B, 4, K, K, 4)
    for a in range(3):
        square[:, a, j, j, a] += 1.0
    square[:, 3, j, j, 3] += mesh.hold
    followed = solve_stack(matrix.reshape(B, 4 * K, 4 * K), right.reshape(B, 4 * K, 7))
    # the end: r(1) = Σ w r', its spin Σ w θ'
    weights = mesh.w[:, None]
    shift = (np.repeat(mesh.w, 4, axis=1)[:, None] * ahead) @ followed
    shift[..., 1:4] += (weights @ Q.reshape(B, K, 9)).reshape(B, 3, 3)
    spin = (weights[:, None] @ rows[:, :3])[:, :, 0] @ followed
    spin[..., 1:] += (weights[:, None] @ pushed[:, :3])[:, :, 0]
    spin[..., 0] += mesh.across @ bent
    turn = end / np.linalg.norm(end, axis=-1, keepdims=True)
    turn = turn + spun(turn, spin[..., 0])
    by_node = followed.reshape(B, K, 4, 7)
    turned = spun(q[..., None, :], np.swapaxes(by_node[..., :3, :], -1, -2))
    changes = np.concatenate([np.swapaxes(turned, -1, -2), by_node[..., 3:, :]], axis=-2)
    return Condensed(
        motion=(weights @ at.rate)[:, 0] + shift[..., 0],
        turn=turn / np.linalg.norm(turn, axis=-1, keepdims=True),
        F=np.concatenate([shift[..., 1:], spin[..., 1:]], axis=1),
        free=changes[..., 0],
        follow=changes[..., 1:],
    )
