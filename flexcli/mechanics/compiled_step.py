"""Newton's steps of a batch, compiled: design by design, with no array of the batch in between.

The same equations as :mod:`flexcli.mechanics.beam`, :mod:`~flexcli.mechanics.element`,
:mod:`~flexcli.mechanics.outer_forces` and :mod:`~flexcli.mechanics.assembly`, which derive them and
are the reference: names and order are theirs. Numba (extra ``fast``) compiles them once and keeps
the machine code in its cache. Layouts are taken whose blades all have the same pieces (one mesh).
"""

from collections.abc import Callable, Sequence
from importlib import import_module
from math import cos, sin
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.assembly import Assembly
from flexcli.mechanics.demand import Demand

__all__ = ["steps_of"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Integers = NDArray[np.intp]
Function = TypeVar("Function", bound=Callable[..., Any])

_jit: Callable[[Function], Function] = import_module("numba").njit(
    cache=True, error_model="numpy", nogil=True, fastmath={"contract", "reassoc", "nsz", "arcp"}
)
"""Sums may be taken in another order; what is no number stays none."""


class _Tables(NamedTuple):
    """An assembly and its demand as plain arrays; the first axis is the design (or 1), then blades.

    ``ends`` are start, end, along and misfit of each blade, ``scales`` scale, reach and weight,
    ``nodes`` w, axial, shear, rho, turn and far_turn at the nodes; ``unknown`` the rows of closing
    and balance that are solved. ``forces`` are arm, force, moment, share before and after on the
    bodies ``forced``, of which those that ``follow`` turn with them; ``springs`` arm and stiffness
    at the bodies ``sprung``.
    """

    ends: Complexes
    scales: Floats
    nodes: Floats
    A: Floats
    end_turn: Floats
    first: Integers
    second: Integers
    held: Integers
    unknown: Integers
    before: Floats
    after: Floats
    grown: bool
    forced: Integers
    follow: NDArray[np.bool_]
    forces: Floats
    sprung: Integers
    springs: Floats


def steps_of(assembly: Assembly, demand: Demand) -> Callable[[Floats, Floats, Integers], Floats]:
    """Return what gives Newton's steps of a layout of one mesh, as ``Assembly.step`` does."""
    (mesh,), (place,), (weight,) = assembly.meshes, assembly.places, assembly.weights
    shape, bound = (assembly.blades, 1), list(mesh.blades)
    forces = [
        (f.arm, f.force, f.moment[:, None], f.before[:, None], f.after[:, None])
        for f in demand.forces
    ]
    springs = [(spring.arm, spring.stiffness) for spring in demand.springs]
    at_nodes = (mesh.w, mesh.axial, mesh.shear, mesh.rho, mesh.turn, mesh.far_turn)
    tables = _Tables(
        ends=_of_blades((place.start, place.end, place.along, place.misfit), shape)[..., 0],
        scales=_of_blades((place.scale, place.reach, weight), shape)[..., 0],
        nodes=_of_blades(at_nodes, (assembly.blades, mesh.nodes)),
        A=mesh.A,
        end_turn=mesh.end_turn,
        first=assembly.first[bound],
        second=assembly.second[bound],
        held=demand.held,
        unknown=np.concatenate([np.arange(3 * assembly.blades), 3 * assembly.blades + demand.free]),
        before=np.ascontiguousarray(demand.before),
        after=np.ascontiguousarray(demand.after),
        grown=demand.grown,
        forced=np.array([force.body for force in demand.forces], dtype=np.intp),
        follow=np.array([force.follows for force in demand.forces], dtype=np.bool_),
        forces=_side_by_side(forces, 7),
        sprung=np.array([spring.body for spring in demand.springs], dtype=np.intp),
        springs=_side_by_side(springs, 5),
    )
    return lambda x, share, rows: _steps(x, share, rows, tables)


def _of_blades(values: Sequence[NDArray[Any]], shape: tuple[int, int]) -> NDArray[Any]:
    """Return arrays (designs or 1, blades or 1, nodes or none) as one, (designs, blades, n, K)."""
    designs = max(each.shape[0] for each in values)
    found = np.empty((designs, shape[0], len(values), shape[1]), dtype=values[0].dtype)
    for i, each in enumerate(values):
        found[:, :, i] = each.reshape(*each.shape[:2], -1)
    return found


def _side_by_side(values: Sequence[Sequence[Floats]], width: int) -> Floats:
    """Return the numbers of forces or springs, each some arrays (designs or 1, n), as one."""
    designs = max((part.shape[0] for each in values for part in each), default=1)
    found = np.zeros((designs, len(values), width))
    for i, each in enumerate(values):
        found[:, i] = np.concatenate(
            [np.broadcast_to(part, (designs, part.shape[1])) for part in each], axis=1
        )
    return found


@_jit
def _solve(M: Floats, n: int) -> None:
    """Solve M[:, :n] x = M[:, n:] in place, x in the last columns; NaN where singular."""
    width = M.shape[1]
    for k in range(n):
        p = k
        for i in range(k + 1, n):
            if abs(M[i, k]) > abs(M[p, k]):
                p = i
        if not abs(M[p, k]) > 0.0:
            M[:, n:] = np.nan
            return
        if p != k:
            for j in range(k, width):
                M[k, j], M[p, j] = M[p, j], M[k, j]
        inverse = 1.0 / M[k, k]
        for i in range(k + 1, n):
            factor = M[i, k] * inverse
            for j in range(k + 1, width):
                M[i, j] -= factor * M[k, j]
    for k in range(n - 1, -1, -1):
        for j in range(n, width):
            M[k, j] /= M[k, k]
        for i in range(k):
            factor = M[i, k]
            for j in range(n, width):
                M[i, j] -= factor * M[k, j]


@_jit
def _condense(
    nodes: Floats,
    A: Floats,
    end_turn: float,
    psi: Floats,
    q: Floats,
    made: Floats,
    M: Floats,
    motion: Floats,
    F: Floats,
) -> None:
    """Condense one blade: ends' motion and flexibility; M keeps how the rotations follow."""
    K = psi.size
    q_x, q_y, m = q[0], q[1], q[2]
    motion[0] = motion[1] = 0.0
    motion[2] = end_turn * m
    F[:] = 0.0
    F[2, 2] = end_turn
    for k in range(K):
        w, axial, shear, rho, _, far_turn = nodes[:, k]
        half = sin(psi[k] / 2.0)
        versine = 2.0 * half * half
        s, c = sin(psi[k]), 1.0 - versine
        N, Q = q_x * c + q_y * s, q_y * c - q_x * s
        stretch, slide = 1.0 + rho * N, rho * Q
        elongation, shear_angle = axial * N, shear * Q
        f = Q * stretch
        f_x, f_y = slide * c - s * stretch, c * stretch + slide * s
        made[0, k], made[1, k], made[2, k] = f, f_x, f_y
        made[3, k] = slide * Q - N * stretch
        F[0, 0] += w * (axial - rho * s * s)
        F[1, 1] += w * (shear + rho * s * s)
        F[0, 1] += w * rho * s * c
        F[2, 0] += far_turn * f_x
        F[2, 1] += far_turn * f_y
        motion[0] += w * (elongation * c - shear_angle * s - versine)
        motion[1] += w * (s + elongation * s + shear_angle * c)
        motion[2] += far_turn * f
    F[1, 0] = F[0, 1]
    for i in range(K):
        a = b = c = 0.0
        for k in range(K):
            a += A[i, k] * made[0, k]
            b += A[i, k] * made[1, k]
            c += A[i, k] * made[2, k]
            M[i, k] = -A[i, k] * made[3, k]
        M[i, i] += 1.0
        turn = nodes[4, i]
        M[i, K], M[i, K + 1], M[i, K + 2], M[i, K + 3] = a + turn * m - psi[i], b, c, turn
    _solve(M, K)
    for k in range(K):
        e_x, e_y = nodes[0, k] * made[1, k], nodes[0, k] * made[2, k]
        e_m = nodes[5, k] * made[3, k]
        motion[0] += e_x * M[k, K]
        motion[1] += e_y * M[k, K]
        motion[2] += e_m * M[k, K]
        for j in range(3):
            F[0, j] += e_x * M[k, K + 1 + j]
            F[1, j] += e_y * M[k, K + 1 + j]
            F[2, j] += e_m * M[k, K + 1 + j]


@_jit
def _element(
    ends: Complexes,
    scales: Floats,
    misfit: complex,
    motion: Floats,
    F: Floats,
    nu: complex,
    m: float,
    pose_i: Floats,
    pose_j: Floats,
    g: Floats,
    H: Floats,
) -> None:
    """Fill gradient and second derivative of one blade between its bodies."""
    start, end, along0 = ends[0], ends[1], ends[2]
    scale, reach = scales[0], scales[1]
    half_i, half_j = sin(pose_i[2] / 2.0), sin(pose_j[2] / 2.0)
    turn_i = complex(-2.0 * half_i * half_i, sin(pose_i[2]))
    turn_j = complex(-2.0 * half_j * half_j, sin(pose_j[2]))
    along_moved, a_j_moved = along0 * turn_i, end * turn_j
    along = along0 + along_moved
    bent = along * complex(motion[0], motion[1])
    lever = start * (1.0 + turn_i) + reach * along + bent
    a_j = end + a_j_moved
    c, s = along.real, along.imag
    H[:] = 0.0
    # flexibility in global axes: T F Tᵀ
    for j in range(3):
        F[0, j], F[1, j] = c * F[0, j] - s * F[1, j], s * F[0, j] + c * F[1, j]
    for i in range(3):
        H[i, 0] = s * F[i, 1] - c * F[i, 0]
        H[i, 1] = -s * F[i, 0] - c * F[i, 1]
        H[i, 2] = -F[i, 2]
    p_x, p_y = nu.imag, -nu.real
    pull, moment = scale * nu, lever.conjugate() * nu
    far = a_j.conjugate() * nu
    gap = scale * complex(pose_j[0] - pose_i[0], pose_j[1] - pose_i[1]) + misfit + a_j_moved - bent
    gap -= start * turn_i + reach * along_moved
    g[0], g[1], g[2] = gap.real, gap.imag, pose_j[2] - pose_i[2] - motion[2]
    g[3], g[4], g[5] = -pull.real, -pull.imag, -m - moment.imag
    g[6], g[7], g[8] = pull.real, pull.imag, m + far.imag
    H[0, 6] = H[1, 7] = scale
    H[0, 3] = H[1, 4] = -scale
    for i in range(3):
        H[i, 5] = H[i, 0] * p_x + H[i, 1] * p_y
    bend = H[0, 5] * p_x + H[1, 5] * p_y
    H[0, 5] += lever.imag
    H[1, 5] -= lever.real
    H[2, 5] -= 1.0
    H[0, 8], H[1, 8], H[2, 8] = -a_j.imag, a_j.real, 1.0
    for i in range(3):
        for j in range(3, 9):
            H[j, i] = H[i, j]
    H[5, 5] = moment.real + bend
    H[8, 8] = -far.real


@_jit
def _apply_forces(
    t: _Tables, d: int, share: float, poses: Floats, r: Floats, matrix: Floats
) -> None:
    """Subtract forces on bodies from their balance, and their stiffness from its derivative."""
    for a in range(t.forced.size):
        v = t.forces[d if t.forces.shape[0] > 1 else 0, a]
        i = 3 * t.forced[a]
        phi = poses[t.forced[a], 2]
        size = v[5] + share * (v[6] - v[5])
        turn = complex(cos(phi), sin(phi))
        arm = complex(v[0], v[1]) * turn
        P = size * complex(v[2], v[3])
        if t.follow[a]:
            P *= turn
            matrix[i, i + 2] += P.imag
            matrix[i + 1, i + 2] -= P.real
        else:
            matrix[i + 2, i + 2] += arm.real * P.real + arm.imag * P.imag
        r[i] -= P.real
        r[i + 1] -= P.imag
        r[i + 2] -= size * v[4] + arm.real * P.imag - arm.imag * P.real


@_jit
def _apply_springs(t: _Tables, d: int, poses: Floats, r: Floats, matrix: Floats) -> None:
    """Add springs on bodies to their balance and its derivative."""
    for a in range(t.sprung.size):
        v = t.springs[d if t.springs.shape[0] > 1 else 0, a]
        i = 3 * t.sprung[a]
        x, y, phi = poses[t.sprung[a]]
        half = sin(phi / 2.0)
        moved = complex(v[0], v[1]) * complex(-2.0 * half * half, sin(phi))
        arm = complex(v[0], v[1]) + moved
        pull_x, pull_y = v[2] * (x + moved.real), v[3] * (y + moved.imag)
        r[i] += pull_x
        r[i + 1] += pull_y
        r[i + 2] += v[4] * phi - pull_x * arm.imag + pull_y * arm.real
        matrix[i, i] += v[2]
        matrix[i + 1, i + 1] += v[3]
        matrix[i, i + 2] -= v[2] * arm.imag
        matrix[i + 2, i] -= v[2] * arm.imag
        matrix[i + 1, i + 2] += v[3] * arm.real
        matrix[i + 2, i + 1] += v[3] * arm.real
        matrix[i + 2, i + 2] += (
            v[4]
            + v[2] * arm.imag * arm.imag
            + v[3] * arm.real * arm.real
            - (pull_x * arm.real + pull_y * arm.imag)
        )


@_jit
def _steps(x: Floats, share: Floats, rows: Integers, t: _Tables) -> Floats:
    """Return Newton's steps of the designs ``rows`` at x and shares λ (designs, unknowns)."""
    designs, size = x.shape
    B, K = t.first.size, t.nodes.shape[-1]
    turns, k_f = B * K, 3 * B
    total = size - turns
    bodies = (total - k_f) // 3
    n = t.unknown.size
    steps = np.empty((designs, size))
    r, matrix = np.empty(total), np.empty((total, total))
    square, change = np.empty((n, n + 1)), np.empty(total)
    made, M, motion = np.empty((4, K)), np.empty((B, K, K + 4)), np.empty(3)
    F, g, H = np.empty((3, 3)), np.empty(9), np.empty((9, 9))
    slot, q, poses = np.empty(9, np.int64), np.empty((B, 3)), np.zeros((bodies + 1, 3))
    frames, row_scale = np.empty(B, np.complex128), np.ones(total)
    for p in range(designs):
        d = rows[p]
        ends = t.ends[d if t.ends.shape[0] > 1 else 0]
        scales = t.scales[d if t.scales.shape[0] > 1 else 0]
        nodes = t.nodes[d if t.nodes.shape[0] > 1 else 0]
        A = t.A[d if t.A.shape[0] > 1 else 0]
        end_turn = t.end_turn[d if t.end_turn.shape[0] > 1 else 0]
        r[:] = 0.0
        matrix[:] = 0.0
        for i in range(bodies):
            for j in range(3):
                poses[i, j] = x[p, turns + k_f + 3 * i + j]
        for b in range(B):
            i, j = t.first[b], t.second[b]
            nu = complex(x[p, turns + 3 * b], x[p, turns + 3 * b + 1])
            m = x[p, turns + 3 * b + 2]
            frame = ends[b, 2] * complex(cos(poses[i, 2]), sin(poses[i, 2]))
            local = frame.conjugate() * nu
            q[b, 0], q[b, 1], q[b, 2] = local.real, local.imag, m
            frames[b] = frame
            _condense(
                nodes[b],
                A[b if A.shape[0] > 1 else 0],
                end_turn[b if end_turn.shape[0] > 1 else 0],
                x[p, b * K : b * K + K],
                q[b],
                made,
                M[b],
                motion,
                F,
            )
            misfit = ends[b, 3] * (1.0 if t.grown else share[p])
            _element(ends[b], scales[b], misfit, motion, F, nu, m, poses[i], poses[j], g, H)
            weight = scales[b, 2]
            for a in range(3):
                slot[a], slot[3 + a], slot[6 + a] = 3 * b + a, k_f + 3 * i + a, k_f + 3 * j + a
                row_scale[3 * b + a] = 1.0 / weight
            for a in range(9):
                if slot[a] < total:
                    r[slot[a]] += weight * g[a]
                    for c in range(9):
                        if slot[c] < total:
                            matrix[slot[a], slot[c]] += weight * H[a, c]
        _apply_forces(t, d, share[p], poses, r[k_f:], matrix[k_f:, k_f:])
        _apply_springs(t, d, poses, r[k_f:], matrix[k_f:, k_f:])
        change[:] = 0.0
        before = t.before[d if t.before.shape[0] > 1 else 0]
        after = t.after[d if t.after.shape[0] > 1 else 0]
        for a in range(t.held.size):
            there = before[a] + share[p] * (after[a] - before[a])
            drive = there - x[p, turns + k_f + t.held[a]]
            change[k_f + t.held[a]] = drive
            for i in range(total):
                r[i] += matrix[i, k_f + t.held[a]] * drive
        for a in range(n):
            i = t.unknown[a]
            for c in range(n):
                square[a, c] = matrix[i, t.unknown[c]] * row_scale[i]
            square[a, n] = -r[i] * row_scale[i]
        _solve(square, n)
        for a in range(n):
            change[t.unknown[a]] = square[a, n]
        for i in range(total):
            steps[p, turns + i] = change[i]
        for b in range(B):
            local = frames[b].conjugate() * complex(change[3 * b], change[3 * b + 1])
            turned = change[k_f + 3 * t.first[b] + 2] if t.first[b] < bodies else 0.0
            d_x, d_y = local.real + q[b, 1] * turned, local.imag - q[b, 0] * turned
            d_m = change[3 * b + 2]
            for k in range(K):
                follow = M[b, k]
                steps[p, b * K + k] = (
                    follow[K] + follow[K + 1] * d_x + follow[K + 2] * d_y + follow[K + 3] * d_m
                )
    return steps
