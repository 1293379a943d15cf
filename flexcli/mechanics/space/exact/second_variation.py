"""Second variation of the energy about an equilibrium in space: stability and tangent stiffness.

Sections and bodies turn on by rotation vectors about where they are, η along the axes of each
section. With the complementary energy of forces and moments beside it,

    ∫ M·δ²κ + 2 δM·(η' + κ × η) − δM·C δM − 2 δM_x δτ − 2 κ_τ δM_z δτ + T_τ δτ² + EΓ δ(τ/a)'²
    + 2 ρ² τ δτ δN_x ds
    − ∫ δ²N·(e_x + Γ) + δN·C δN ds + n·δ²Δ + 2 δn·δΔ,

    δ²κ = η × (η × κ) − η × η',  δN = N × η + Rᵀ δn,  δ²N = η × (η × N) − 2 η × Rᵀ δn,

Δ being the vector between the ends. It is symmetric whatever the loads, and no stiffness ratio
stands in it.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.exact.assembly import Assembly, Linearised
from flexcli.mechanics.space.exact.blade import Along
from flexcli.mechanics.space.exact.demand import Demand
from flexcli.mechanics.space.exact.mesh import Mesh
from flexcli.mechanics.space.exact.outer_forces import apply_force, apply_spring
from flexcli.mechanics.space.exact.rotation import matrix_of, moved, skew
from flexcli.mechanics.space.exact.section_law import Curled
from flexcli.numerics.symmetric import solved_and_counted

__all__ = [
    "BeamVariation",
    "SecondVariation",
    "beam_variation",
    "inertia_count",
    "second_variation",
    "swing",
]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


class SecondVariation(NamedTuple):
    """The matrix of blade forces and body coordinates, and what the blades are by themselves.

    ``matrix`` is that of the forces (δn, and the moments that close the rotations) of all blades,
    then of the bodies, sections eliminated. ``unstable`` counts the negative directions of the
    blades with their ends free, at constant end forces.
    """

    matrix: Floats
    unstable: int

    def of(self, free: Integers, blades: int) -> Floats:
        """Return the matrix of the blades' forces and the coordinates ``free`` of the bodies."""
        rows = np.concatenate([np.arange(6 * blades), 6 * blades + free])
        return np.asarray(self.matrix[rows[:, None], rows])


class BeamVariation(NamedTuple):
    """Second variation of a blade: its sections eliminated, and their negative directions."""

    matrix: Floats
    unstable: int


def second_variation(
    assembly: Assembly, demand: Demand, at: Linearised, x: Floats, share: float
) -> SecondVariation:
    """Return the second variation about an equilibrium x at the share λ."""
    assembly, state = assembly.on_the_way(demand, share), assembly.at(x)
    blades, bodies = assembly.blades, assembly.bodies
    k_f = 6 * blades
    H = np.zeros((k_f + 6 * bodies + 6,) * 2)
    turn = np.concatenate([state.turn, [[1.0, 0.0, 0.0, 0.0]]])
    both = state.forces.reshape(-1, 2, 3) @ np.swapaxes(at.axes, -1, -2)
    members = assembly.members.variation(state.inside, both.reshape(-1, 6))
    for i in range(blades):
        first, second = assembly.first[i], assembly.second[i]
        S, n = at.axes[i], state.forces[i, :3]
        # its unknowns: δn, the closing moments and the turn of its start, along its axes
        own = np.zeros((18, 18))
        rows = np.zeros((9, 18))
        rows[0:3, 0:3], rows[3:6, 3:6], rows[6:9, 9:12] = S, np.eye(3), S
        own += rows.T @ members.matrix[i] @ rows
        a_i = assembly.start[i] + moved(turn[first], assembly.start[i])
        a_j = assembly.end[i] + moved(turn[second], assembly.end[i])
        scale = assembly.scale[i] * np.eye(3)
        closing = np.zeros((6, 18))
        closing[:3, 6:9], closing[:3, 9:12] = -scale, skew(a_i)
        closing[:3, 12:15], closing[:3, 15:18] = scale, -skew(a_j)
        closing[3:, 15:18] = matrix_of(at.blades.turn[i]).T @ S
        own[:6] += closing
        own[:, :6] += closing.T
        own[9:12, 9:12] -= swing(n, a_i)
        own[15:18, 15:18] += swing(n, a_j)
        slot = np.concatenate(
            [
                np.arange(6) + 6 * i,
                np.arange(6) + k_f + 6 * first,
                np.arange(6) + k_f + 6 * second,
            ]
        )
        H[slot[:, None], slot] += assembly.weight[i] * own
    H = H[:-6, :-6]
    loads, K = np.zeros(6 * bodies), np.zeros((6 * bodies, 6 * bodies))
    for force in demand.forces:
        apply_force(force, state.turn, force.size(share), loads, K)
    for spring in demand.springs:
        apply_spring(spring, state.shift, state.turn, loads, K)
    H[k_f:, k_f:] += (K + K.T) / 2.0
    for i in range(bodies):
        own_rows = slice(k_f + 6 * i, k_f + 6 * i + 6)
        basis = at.basis[i]
        H[:, own_rows] = H[:, own_rows] @ basis
        H[own_rows] = basis.T @ H[own_rows]
        load = np.linalg.solve(basis.T, at.residual[own_rows])
        curved = assembly.coordinate_stiffness(i, state.turn[i], load, demand)
        H[own_rows, own_rows] += (curved + curved.T) / 2.0
    return SecondVariation((H + H.T) / 2.0, members.unstable)


def inertia_count(variation: SecondVariation, free: Integers, blades: int) -> int:
    """Return in how many directions an equilibrium is unstable, sections and bodies alike.

    ``Σ n(blade with its end free) + n(S) − 6 blades``, S the matrix of blade forces and free
    coordinates: the inertia of a matrix is that of its Schur complements, so that blades that
    buckle between bodies at rest are counted as well.

    References
    ----------
    Haynsworth (1968), Determination of the inertia of a partitioned Hermitian matrix.

    """
    S = variation.of(free, blades)
    size = np.max(np.abs(S), axis=-1)
    unit = 1.0 / np.sqrt(np.where(size > 0.0, size, 1.0))
    negative = int(np.sum(np.linalg.eigvalsh(S * np.outer(unit, unit)) < 0.0))
    return negative - 6 * blades + variation.unstable


def beam_variation(mesh: Mesh, i: int, at: Along) -> BeamVariation:
    """Return the second variation of blade i by δn, closing moments and turn of the start.

    Its own unknowns are η' (3), δM (3) and δ(τ/a)', or δτ where it warps freely, at the nodes.
    """
    used = np.flatnonzero(mesh.w[i] > 0.0)
    K = used.size
    w, J = mesh.w[i, used], mesh.J[i][used[:, None], used]
    R, N, kappa, M = (a[i, used] for a in (at.R, at.N, at.kappa, at.M))
    G = np.array([1.0, 0.0, 0.0]) + at.strain[i, used]
    C, law = mesh.C[i, used], Curled(*(each[i, used] for each in at.law))
    spin, polar = mesh.spin[i, used], mesh.polar[i, used]
    tau = kappa[:, 0] - spin * M[:, 0]
    runs = [np.flatnonzero((used >= run.start) & (used < run.stop)) for run in mesh.runs[i]]
    R_t = np.swapaxes(R, -1, -2)
    # per unit length: η η, η η', η δn, and so on
    M_k, NG = M[:, :, None] * kappa[:, None, :], N[:, :, None] * G[:, None, :]
    N_s = skew(N)
    CN = C[:, :, None] * N_s
    turn_turn = _symmetric(M_k) - _trace(M_k) - _symmetric(NG) + _trace(NG)
    turn_turn -= np.swapaxes(N_s, -1, -2) @ CN
    turn_force = -skew(G) @ R_t - np.swapaxes(CN, -1, -2) @ R_t
    force_force = -R @ (C[:, :, None] * R_t)
    rate_turn = -skew(M) / 2.0
    moment_turn = skew(kappa)
    warping, apart = mesh.warping[i, used], mesh.apart[i, used]
    warped = bool(np.any(warping > 0.0))
    torsion = mesh.torsion[i, used] + polar * N[:, 0] + 3.0 * mesh.fibres[i, used] * tau**2
    torsion += law.stiffness
    # δτ = a J δ(τ/a)' on each flexible stretch; δN_x = (N × η)_x + (Rᵀ δn)_x
    T = np.zeros((K, K))
    for run in runs:
        T[run[:, None], run] = (
            apart[run, None] * J[run[:, None], run] if warped else np.eye(run.size)
        )
    size = 7 * K + len(runs) * warped
    # columns: η', δM, δ(τ/a)' (node by node), closing of δτ; then δn, closing moments, start's turn
    half = np.zeros((size + 9, size + 9))
    rate, moment, twist = slice(0, 3 * K), slice(3 * K, 6 * K), slice(6 * K, 7 * K)
    across, along = slice(3 * K + 2, 6 * K, 3), slice(3 * K, 6 * K, 3)
    force, close, start = (slice(size + 3 * k, size + 3 * k + 3) for k in range(3))
    # η at the nodes by η' and by the turn of the start
    turn = np.column_stack([J, np.ones(K)])

    def add(rows: slice, blocks: Floats) -> None:
        """Add a block whose columns are those of η at the nodes."""
        half[rows, rate] += blocks[:, : 3 * K]
        half[rows, start] += blocks[:, 3 * K :]

    turns = _weighted(turn, w, turn_turn, turn) / 2.0
    forced = _weighted(turn, w, turn_force, np.ones((K, 1)))
    for rows, own in ((rate, slice(0, 3 * K)), (start, slice(3 * K, None))):
        add(rows, turns[own])
        half[rows, force] += forced[own]
    half[force, force] += np.tensordot(w, force_force, axes=(0, 0)) / 2.0
    add(rate, _weighted(None, w, rate_turn, turn))
    add(moment, _weighted(None, w, moment_turn, turn))
    half[moment, rate] += np.diag(np.repeat(w, 3))
    compliant = np.stack([spin, mesh.bend_y[i, used], law.compliance], axis=-1)
    half[moment, moment] -= np.diag((w[:, None] * compliant).ravel() / 2.0)
    half[along, twist] -= w[:, None] * T
    half[across, twist] -= (w * law.coupling)[:, None] * T
    half[twist, twist] += T.T @ ((w * torsion)[:, None] * T) / 2.0
    pull = w * polar * tau
    add(twist, _weighted(T, pull, N_s[:, :1], turn))
    half[twist, force] += _weighted(T, pull, R_t[:, :1], np.ones((K, 1)))
    if warped:
        half[twist, twist] += np.diag(warping * w / 2.0)
        for k, run in enumerate(runs):
            half[7 * K + k, 6 * K + run] = w[run]
    # closing: η(1) − η(0) − ∫ η' = 0
    for k in range(3):
        half[size + 3 + k, k : 3 * K : 3] -= w
    half[close, start] -= np.eye(3)
    H = half + half.T
    # a rigid stretch has no twist of its own
    kept = np.ones(size, dtype=bool)
    kept[twist] = False
    for run in runs:
        kept[6 * K + run] = True
    inner = slice(0, size) if kept.all() else np.flatnonzero(kept)
    A, B = H[inner][:, inner], H[inner, size:]
    unit = 1.0 / np.sqrt(np.maximum(A.max(axis=1), -A.min(axis=1)))
    A *= unit[:, None]
    A *= unit
    B = unit[:, None] * B
    # the moments take part with minus their compliance, the closing of δτ with none
    concave = 3 * K - int(np.sum(law.compliance < 0.0)) + len(runs) * warped
    followed, negative = solved_and_counted(A, B)
    return BeamVariation(H[size:, size:] - B.T @ followed, negative - concave)


def _weighted(left: Floats | None, w: Floats, blocks: Floats, right: Floats) -> Floats:
    """Return ``Σ w left_p block_ab right_q`` of the nodes, its rows p a and its columns q b.

    Without a left side each node has a row of its own.
    """
    K, a, _ = blocks.shape
    of_nodes = (w[:, None, None] * blocks)[:, :, None, :] * right[:, None, :, None]
    if left is None:
        return np.asarray(of_nodes.reshape(K * a, -1))
    return np.asarray((left.T @ of_nodes.reshape(K, -1)).reshape(left.shape[1] * a, -1))


def _symmetric(a: Floats) -> Floats:
    return np.asarray((a + np.swapaxes(a, -1, -2)) / 2.0)


def _trace(a: Floats) -> Floats:
    return np.asarray(np.trace(a, axis1=-2, axis2=-1)[:, None, None] * np.eye(3))


def swing(n: Floats, a: Floats) -> Floats:
    """Return the Hessian of ``n·(θ × (θ × a))``."""
    return np.asarray((np.outer(n, a) + np.outer(a, n)) / 2.0 - (n @ a) * np.eye(3))
