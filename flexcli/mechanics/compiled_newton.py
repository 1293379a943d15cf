"""Newton's method of a batch, compiled: design by design, with no array of the batch in between.

The same equations as :mod:`flexcli.mechanics.beam`, :mod:`~flexcli.mechanics.element`,
:mod:`~flexcli.mechanics.outer_forces` and :mod:`~flexcli.mechanics.assembly`, and the same rules as
:mod:`flexcli.numerics.newton`, which derive them and are the reference: names and order are theirs.
Numba (extra ``fast``) compiles them once and keeps the machine code in its cache. Layouts are taken
whose blades all have the same pieces (one mesh).
"""

from collections.abc import Callable, Sequence
from functools import partial
from importlib import import_module
from math import cos, sin
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.assembly import FORCE, Assembly
from flexcli.mechanics.demand import Demand
from flexcli.numerics.newton import (
    BENDS,
    CONTRACTION,
    FLOOR,
    REACH,
    RESTLESS,
    NewtonEnd,
    NewtonResult,
)

__all__ = ["Compiled"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Integers = NDArray[np.intp]
Function = TypeVar("Function", bound=Callable[..., Any])


def _jit(function: Function) -> Function:
    """Compile a function. Sums may be taken in another order; what is no number stays none."""
    njit = partial(
        import_module("numba").njit, error_model="numpy", nogil=True,
        fastmath={"contract", "reassoc", "nsz", "arcp"},
    )  # fmt: skip
    try:
        compiled: Function = njit(cache=True)(function)
    except RuntimeError:  # there is no folder to keep the machine code in
        compiled = njit()(function)
    return compiled


_ENDS = tuple(NewtonEnd)
_CONVERGED, _SINGULAR, _DIVERGED, _FAR = (
    _ENDS.index(end)
    for end in (NewtonEnd.CONVERGED, NewtonEnd.SINGULAR, NewtonEnd.DIVERGED, NewtonEnd.FAR)
)


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


class Compiled:
    """Newton's method for a layout of one mesh under a demand."""

    def __init__(self, assembly: Assembly, demand: Demand) -> None:
        (mesh,), (place,), (weight,) = assembly.meshes, assembly.places, assembly.weights
        shape, bound = (assembly.blades, 1), list(mesh.blades)
        closing = np.arange(3 * assembly.blades)
        forces = [
            (f.arm, f.force, f.moment[:, None], f.before[:, None], f.after[:, None])
            for f in demand.forces
        ]
        springs = [(spring.arm, spring.stiffness) for spring in demand.springs]
        at_nodes = (mesh.w, mesh.axial, mesh.shear, mesh.rho, mesh.turn, mesh.far_turn)
        self._tables = _Tables(
            ends=_of_blades((place.start, place.end, place.along, place.misfit), shape)[..., 0],
            scales=_of_blades((place.scale, place.reach, weight), shape)[..., 0],
            nodes=_of_blades(at_nodes, (assembly.blades, mesh.nodes)),
            A=mesh.A,
            end_turn=mesh.end_turn,
            first=assembly.first[bound],
            second=assembly.second[bound],
            held=demand.held,
            unknown=np.concatenate([closing, 3 * assembly.blades + demand.free]),
            before=np.ascontiguousarray(demand.before),
            after=np.ascontiguousarray(demand.after),
            grown=demand.grown,
            forced=np.array([force.body for force in demand.forces], dtype=np.intp),
            follow=np.array([force.follows for force in demand.forces], dtype=np.bool_),
            forces=_side_by_side(forces, 7),
            sprung=np.array([spring.body for spring in demand.springs], dtype=np.intp),
            springs=_side_by_side(springs, 5),
        )

    def step(self, x: Floats, share: Floats, rows: Integers) -> Floats:
        """Return Newton's steps of the designs ``rows`` at x and shares λ (designs, unknowns)."""
        nothing = np.zeros(len(x))
        return _newton(x.copy(), share, rows, nothing, nothing, 0.0, np.inf, 1, self._tables)[0]

    def newton(
        self,
        x: Floats,
        share: Floats,
        rows: Integers,
        *,
        scale: Floats,
        tolerance: float,
        bends: Floats | None = None,
        trust: float = np.inf,
        most: int = 30,
    ) -> NewtonResult:
        """Return where Newton's method leads from x, as :func:`flexcli.numerics.newton.newton`."""
        y = x.copy()
        bends = np.full(len(x), BENDS) if bends is None else bends.copy()
        _, end, iterations, last, bend = _newton(
            y, share, rows, scale, bends, tolerance, trust, most, self._tables
        )
        ends = np.array(_ENDS, dtype=object)[end]
        return NewtonResult(y, ends, iterations, last, bend, bends)


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
        M[k, k] = inverse
    for k in range(n - 1, -1, -1):
        for j in range(n, width):
            M[k, j] *= M[k, k]
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
    q_x: float,
    q_y: float,
    m: float,
    made: Floats,
    M: Floats,
    motion: Floats,
    F: Floats,
) -> None:
    """Condense one blade: ends' motion and flexibility; M keeps how the rotations follow."""
    K = psi.size
    x = y = turned = F_xx = F_yy = F_xy = F_mx = F_my = 0.0
    for k in range(K):
        w, axial, shear, rho, far_turn = (
            nodes[0, k], nodes[1, k], nodes[2, k], nodes[3, k], nodes[5, k]
        )  # fmt: skip
        half = sin(0.5 * psi[k])
        versine, s = 2.0 * half * half, sin(psi[k])
        c = 1.0 - versine
        N, Q = q_x * c + q_y * s, q_y * c - q_x * s
        stretch, slide = 1.0 + rho * N, rho * Q
        elongation, shear_angle = axial * N, shear * Q
        f = Q * stretch
        f_x, f_y = slide * c - s * stretch, c * stretch + slide * s
        made[0, k], made[1, k], made[2, k] = f, f_x, f_y
        made[3, k] = slide * Q - N * stretch
        F_xx += w * (axial - rho * s * s)
        F_yy += w * (shear + rho * s * s)
        F_xy += w * rho * s * c
        F_mx += far_turn * f_x
        F_my += far_turn * f_y
        x += w * (elongation * c - shear_angle * s - versine)
        y += w * (s + elongation * s + shear_angle * c)
        turned += far_turn * f
    for i in range(K):
        turn = nodes[4, i]
        own, by_x, by_y = turn * m - psi[i], 0.0, 0.0
        for k in range(K):
            each = A[i, k]
            own += each * made[0, k]
            by_x += each * made[1, k]
            by_y += each * made[2, k]
            M[i, k] = -each * made[3, k]
        M[i, i] += 1.0
        M[i, K], M[i, K + 1], M[i, K + 2], M[i, K + 3] = own, by_x, by_y, turn
    _solve(M, K)
    motion[0], motion[1], motion[2] = x, y, turned + end_turn * m
    F[0, 0], F[0, 1], F[0, 2] = F_xx, F_xy, 0.0
    F[1, 0], F[1, 1], F[1, 2] = F_xy, F_yy, 0.0
    F[2, 0], F[2, 1], F[2, 2] = F_mx, F_my, end_turn
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
def _add_element(
    rows: tuple[int, int, int],
    ends: Complexes,
    scales: Floats,
    misfit: complex,
    nu: complex,
    m: float,
    turn_i: complex,
    turn_j: complex,
    apart: tuple[float, float, float],
    motion: Floats,
    F: Floats,
    r: Floats,
    matrix: Floats,
) -> None:
    """Add gradient and second derivative of one blade; ``rows`` are its first and its bodies'.

    ``apart`` is by how much the body at its end moved more than that at its start.
    """
    e, i, j = rows
    start, end, along0 = ends[0], ends[1], ends[2]
    scale, reach, weight = scales[0], scales[1], scales[2]
    along_moved, a_j_moved = along0 * turn_i, end * turn_j
    along = along0 + along_moved
    bent = along * complex(motion[0], motion[1])
    lever = start * (1.0 + turn_i) + reach * along + bent
    a_j = end + a_j_moved
    pull, moment = weight * scale * nu, lever.conjugate() * nu
    far = a_j.conjugate() * nu
    gap = scale * complex(apart[0], apart[1]) + misfit + a_j_moved - bent
    gap -= start * turn_i + reach * along_moved
    r[e] = weight * gap.real
    r[e + 1] = weight * gap.imag
    r[e + 2] = weight * (apart[2] - motion[2])
    r[i] -= pull.real
    r[i + 1] -= pull.imag
    r[i + 2] -= weight * (m + moment.imag)
    r[j] += pull.real
    r[j + 1] += pull.imag
    r[j + 2] += weight * (m + far.imag)
    # flexibility in global axes: T F Tᵀ
    c, s = along.real, along.imag
    for k in range(3):
        F[0, k], F[1, k] = c * F[0, k] - s * F[1, k], s * F[0, k] + c * F[1, k]
    for k in range(3):
        F[k, 0], F[k, 1] = c * F[k, 0] - s * F[k, 1], s * F[k, 0] + c * F[k, 1]
    p_x, p_y = weight * nu.imag, -weight * nu.real
    bend_x, bend_y = F[0, 0] * p_x + F[0, 1] * p_y, F[1, 0] * p_x + F[1, 1] * p_y
    for k in range(3):
        for n in range(3):
            matrix[e + k, e + n] = -weight * F[k, n]
    size = weight * scale
    matrix[e, i] -= size
    matrix[e + 1, i + 1] -= size
    matrix[e, j] += size
    matrix[e + 1, j + 1] += size
    matrix[e, i + 2] += weight * lever.imag - bend_x
    matrix[e + 1, i + 2] -= weight * lever.real + bend_y
    matrix[e + 2, i + 2] -= weight + F[2, 0] * p_x + F[2, 1] * p_y
    matrix[e, j + 2] -= weight * a_j.imag
    matrix[e + 1, j + 2] += weight * a_j.real
    matrix[e + 2, j + 2] += weight
    matrix[i + 2, i + 2] += weight * moment.real - (bend_x * nu.imag - bend_y * nu.real)
    matrix[j + 2, j + 2] -= weight * far.real


@_jit
def _apply_forces(
    bodies: Integers,
    follow: NDArray[np.bool_],
    forces: Floats,
    share: float,
    poses: Floats,
    first: int,
    r: Floats,
    matrix: Floats,
) -> None:
    """Subtract forces on bodies from their balance, and their stiffness from its derivative."""
    for a in range(bodies.size):
        v = forces[a]
        i = first + 3 * bodies[a]
        phi = poses[bodies[a], 2]
        size = v[5] + share * (v[6] - v[5])
        turn = complex(cos(phi), sin(phi))
        arm = complex(v[0], v[1]) * turn
        P = size * complex(v[2], v[3])
        if follow[a]:
            P *= turn
            matrix[i, i + 2] += P.imag
            matrix[i + 1, i + 2] -= P.real
        else:
            matrix[i + 2, i + 2] += arm.real * P.real + arm.imag * P.imag
        r[i] -= P.real
        r[i + 1] -= P.imag
        r[i + 2] -= size * v[4] + arm.real * P.imag - arm.imag * P.real


@_jit
def _apply_springs(
    bodies: Integers, springs: Floats, poses: Floats, first: int, r: Floats, matrix: Floats
) -> None:
    """Add springs on bodies to their balance and its derivative."""
    for a in range(bodies.size):
        v = springs[a]
        i = first + 3 * bodies[a]
        x, y, phi = poses[bodies[a]]
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
def _length(s: Floats, y: Floats, turns: int, k_f: int) -> float:
    """Return the length of a step at y, not finite where one of its numbers is not."""
    force = rest = pull = finite = 0.0
    for i in range(s.size):
        finite += 0.0 * s[i]
        if i < turns or i >= turns + k_f:
            rest = max(rest, abs(s[i]))
        else:
            force, pull = max(force, abs(s[i])), max(pull, abs(y[i]))
    return max(rest, force / (FORCE + pull)) + finite


@_jit
def _newton(
    x: Floats,
    share: Floats,
    rows: Integers,
    scale: Floats,
    bends: Floats,
    tolerance: float,
    trust: float,
    most: int,
    t: _Tables,
) -> tuple[Floats, Integers, Integers, Floats, Floats]:
    """Move the designs ``rows`` from x at shares λ by Newton's method, at most so many steps.

    ``bends``, a step over the square of the one before, is written to. Return the last steps, how
    each design ended, iterations, lengths of last and second steps.
    """
    designs, size = x.shape
    B, K = t.first.size, t.nodes.shape[-1]
    turns, k_f = B * K, 3 * B
    total = size - turns
    bodies = (total - k_f) // 3
    n = t.unknown.size
    steps = np.zeros((designs, size))
    end = np.full(designs, _DIVERGED)
    iterations = np.zeros(designs, np.int64)
    last, bend = np.full(designs, np.inf), np.zeros(designs)
    # the ground, which never moves, is the last of the bodies
    r, matrix = np.empty(total + 3), np.empty((total + 3, total + 3))
    square, change = np.empty((n, n + 1)), np.empty(total + 3)
    made, M, motion = np.empty((4, K)), np.empty((B, K, K + 4)), np.empty(3)
    F, q, poses = np.empty((3, 3)), np.empty((B, 2)), np.zeros((bodies + 1, 3))
    frames, body_turns = np.empty(B, np.complex128), np.zeros(bodies + 1, np.complex128)
    row_scale = np.ones(total)
    for p in range(designs):
        d = rows[p]
        y, s = x[p], steps[p]
        ends = t.ends[d if t.ends.shape[0] > 1 else 0]
        scales = t.scales[d if t.scales.shape[0] > 1 else 0]
        nodes = t.nodes[d if t.nodes.shape[0] > 1 else 0]
        A = t.A[d if t.A.shape[0] > 1 else 0]
        end_turn = t.end_turn[d if t.end_turn.shape[0] > 1 else 0]
        before = t.before[d if t.before.shape[0] > 1 else 0]
        after = t.after[d if t.after.shape[0] > 1 else 0]
        grown = 1.0 if t.grown else share[p]
        for b in range(B):
            for a in range(3):
                row_scale[3 * b + a] = 1.0 / scales[b, 2]
        restless = 0
        for count in range(most):
            r[:] = 0.0
            matrix[:] = 0.0
            for i in range(bodies):
                for j in range(3):
                    poses[i, j] = y[turns + k_f + 3 * i + j]
                half = sin(0.5 * poses[i, 2])
                body_turns[i] = complex(-2.0 * half * half, sin(poses[i, 2]))
            for b in range(B):
                i, j = t.first[b], t.second[b]
                nu = complex(y[turns + 3 * b], y[turns + 3 * b + 1])
                m = y[turns + 3 * b + 2]
                frames[b] = ends[b, 2] * (1.0 + body_turns[i])
                local = frames[b].conjugate() * nu
                q[b, 0], q[b, 1] = local.real, local.imag
                _condense(
                    nodes[b],
                    A[b if A.shape[0] > 1 else 0],
                    end_turn[b if end_turn.shape[0] > 1 else 0],
                    y[b * K : b * K + K],
                    local.real,
                    local.imag,
                    m,
                    made,
                    M[b],
                    motion,
                    F,
                )
                _add_element(
                    (3 * b, k_f + 3 * i, k_f + 3 * j),
                    ends[b],
                    scales[b],
                    grown * ends[b, 3],
                    nu,
                    m,
                    body_turns[i],
                    body_turns[j],
                    (
                        poses[j, 0] - poses[i, 0],
                        poses[j, 1] - poses[i, 1],
                        poses[j, 2] - poses[i, 2],
                    ),
                    motion,
                    F,
                    r,
                    matrix,
                )
            for a in range(k_f):
                for c in range(k_f, total):
                    matrix[c, a] = matrix[a, c]
            if t.forced.size > 0:
                forces = t.forces[d if t.forces.shape[0] > 1 else 0]
                _apply_forces(t.forced, t.follow, forces, share[p], poses, k_f, r, matrix)
            if t.sprung.size > 0:
                springs = t.springs[d if t.springs.shape[0] > 1 else 0]
                _apply_springs(t.sprung, springs, poses, k_f, r, matrix)
            change[:] = 0.0
            for a in range(t.held.size):
                i = k_f + t.held[a]
                there = before[a] + share[p] * (after[a] - before[a])
                change[i] = there - y[turns + i]
                for c in range(total):
                    r[c] += matrix[c, i] * change[i]
            for a in range(n):
                i = t.unknown[a]
                for c in range(n):
                    square[a, c] = matrix[i, t.unknown[c]] * row_scale[i]
                square[a, n] = -r[i] * row_scale[i]
            _solve(square, n)
            for a in range(n):
                change[t.unknown[a]] = square[a, n]
            for i in range(total):
                s[turns + i] = change[i]
            for b in range(B):
                local = frames[b].conjugate() * complex(change[3 * b], change[3 * b + 1])
                turned = change[k_f + 3 * t.first[b] + 2]
                d_x, d_y = local.real + q[b, 1] * turned, local.imag - q[b, 0] * turned
                d_m = change[3 * b + 2]
                for k in range(K):
                    s[b * K + k] = (
                        M[b, k, K] + M[b, k, K + 1] * d_x + M[b, k, K + 2] * d_y
                        + M[b, k, K + 3] * d_m
                    )  # fmt: skip
            length = _length(s, y, turns, k_f)
            iterations[p] += 1
            if not length < np.inf:  # np.isfinite takes all for finite where sums are reordered
                end[p] = _SINGULAR
                break
            if count == 1:
                bend[p] = length
            sure = min(trust, max(CONTRACTION * last[p], FLOOR)) if trust < np.inf else np.inf
            if count > 0 and length > sure:
                end[p] = _FAR
                break
            share_of = min(1.0, REACH / max(length, REACH))
            for i in range(size):
                y[i] += share_of * s[i]
            ratio = length / (last[p] if last[p] > 0.0 else 1.0)
            last[p] = length
            unit = min(1.0, max(scale[p], _length(y, y, turns, k_f)))
            if count > 0:
                bends[p] = min(ratio, 1.0) ** 2 / (length if length > 0.0 else 1.0)
            ahead = bends[p] * length**2
            if ahead <= tolerance * unit or (length <= FLOOR * unit and ratio > 0.5):
                end[p] = _CONVERGED
                break
            restless = restless + 1 if ratio > 1.0 else 0
            if restless >= RESTLESS:
                break
    return steps, end, iterations, last, bend
