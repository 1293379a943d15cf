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
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import Outcome
from flexcli.mechanics.assembly import FORCE, Assembly
from flexcli.mechanics.demand import Demand
from flexcli.numerics.lanes import (
    LANES,
    Lanes,
    any_above,
    at,
    larger,
    put,
    size_of,
    splat,
    versed,
    where_above,
)
from flexcli.numerics.newton import (
    BENDS,
    CONTRACTION,
    FLOOR,
    REACH,
    RESTLESS,
    NewtonResult,
)
from flexcli.numerics.stack import PIVOT

__all__ = ["Compiled"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Integers = NDArray[np.intp]
Function = TypeVar("Function", bound=Callable[..., Any])


def _jit(function: Function, *, allocates: bool = False) -> Function:
    """Compile a function; nothing is reordered.

    What allocates nothing counts no references to its arrays, which would take a third of its time.
    """
    njit = partial(import_module("numba").njit, error_model="numpy", nogil=True, _nrt=allocates)
    try:
        compiled: Function = njit(cache=True)(function)
    except RuntimeError:  # there is no folder to keep the machine code in
        compiled = njit()(function)
    return compiled


_ENDS = (Outcome.CONVERGED, Outcome.SINGULAR, Outcome.STALLED, Outcome.OFF_PATH)
_CONVERGED, _SINGULAR, _DIVERGED, _FAR = range(len(_ENDS))


class _Blades(NamedTuple):
    """What of the tables of an assembly hangs on no demand; names as in ``_Tables``."""

    ends: Floats
    scales: Floats
    w: Floats
    axial: Floats
    shear: Floats
    rho: Floats
    turn: Floats
    far_turn: Floats
    A: Floats
    end_turn: Floats
    first: Integers
    second: Integers


class _Tables(NamedTuple):
    """An assembly and its demand as plain arrays; the first axis is the design (or 1), then blades.

    ``ends`` are start, end, along and misfit of each blade, ``scales`` scale, reach and weight,
    ``nodes`` w, axial, shear, rho, turn and far_turn at the nodes; ``unknown`` the rows of closing
    and balance that are solved. ``forces`` are arm, force, moment, share before and after on the
    bodies ``forced``, of which those that ``follow`` turn with them; ``springs`` arm and stiffness
    at the bodies ``sprung``.
    """

    ends: Floats
    scales: Floats
    w: Floats
    axial: Floats
    shear: Floats
    rho: Floats
    turn: Floats
    far_turn: Floats
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


class _Work(NamedTuple):
    """Arrays of eight designs, the lanes the last axis, that Newton's method works in.

    First what does not change: the tables of the designs. ``y`` are the unknowns, ``s`` a step;
    ``r`` and ``matrix`` the equations of blades and bodies, the ground, which never moves, the last
    of the bodies; ``frames`` direction and local force of the blades, ``turned`` and ``poses`` of
    the bodies; ``share`` is λ, ``goes`` the share of its step that a design goes, zero where it has
    ended, ``lengths`` those of the step and of y.
    """

    ends: Floats
    scales: Floats
    nodes: Floats
    A: Floats
    end_turn: Floats
    before: Floats
    after: Floats
    forces: Floats
    springs: Floats
    y: Floats
    s: Floats
    r: Floats
    matrix: Floats
    square: Floats
    made: Floats
    M: Floats
    motion: Floats
    F: Floats
    frames: Floats
    turned: Floats
    poses: Floats
    share: Floats
    goes: Floats
    lengths: Floats
    restless: Integers


class _Ends(NamedTuple):
    """How each design ended, its iterations, lengths of last and second steps and of itself."""

    end: Integers
    iterations: Integers
    last: Floats
    bend: Floats
    length: Floats
    bends: Floats


class Compiled:
    """Newton's method for a layout of one mesh under a demand."""

    def __init__(self, assembly: Assembly, demand: Demand) -> None:
        closing = np.arange(3 * assembly.blades)
        forces = [
            (f.arm, f.force, f.moment[:, None], f.before[:, None], f.after[:, None])
            for f in demand.forces
        ]
        springs = [(spring.arm, spring.stiffness) for spring in demand.springs]
        self._tables = _Tables(
            *_blades_of(assembly),
            held=demand.held,
            unknown=np.concatenate([closing, 3 * assembly.blades + demand.free]),
            before=np.ascontiguousarray(demand.before[:, None]),
            after=np.ascontiguousarray(demand.after[:, None]),
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
        return _newton(
            x.copy(), share, rows, nothing, nothing.copy(), 0.0, np.inf, 1, self._tables
        )[0]

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
        _, at = _newton(y, share, rows, scale, bends, tolerance, trust, most, self._tables)
        end = np.array(_ENDS, dtype=object)[at.end]
        return NewtonResult(y, end, at.iterations, at.last, at.bend, bends, at.length)


def _blades_of(assembly: Assembly) -> _Blades:
    """Return the tables of the blades; a single design keeps them."""
    key = Compiled, assembly.effects, assembly.nodes
    found: _Blades | None = assembly.layout.prepared.get(key)
    if found is not None:
        return found
    (mesh,), (place,), (weight,) = assembly.meshes, assembly.places, assembly.weights
    bound = list(mesh.blades)
    found = _Blades(
        ends=_of_blades(place.start, place.end, place.along, place.misfit).view(np.float64),
        scales=_of_blades(place.scale, place.reach, weight),
        w=mesh.w,
        axial=mesh.axial,
        shear=mesh.shear,
        rho=mesh.rho,
        turn=mesh.turn,
        far_turn=mesh.far_turn,
        A=np.ascontiguousarray(mesh.A.reshape(*mesh.A.shape[:2], -1)),
        end_turn=mesh.end_turn[..., None],
        first=assembly.first[bound],
        second=assembly.second[bound],
    )
    if assembly.designs == 1:
        assembly.layout.prepared[key] = found
    return found


def _of_blades(*values: NDArray[Any]) -> NDArray[Any]:
    """Return arrays (designs or 1, blades or 1) as one, (designs or 1, blades, n)."""
    return np.ascontiguousarray(np.stack(np.broadcast_arrays(*values), axis=-1))


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
def _read(values: Floats, rows: Integers, first: int, found: Floats) -> None:
    """Read eight designs of values (designs or 1, blades or 1, n) to lanes (blades, n, LANES)."""
    if values.shape[0] == 1 and first > 0:
        return
    for lane in range(LANES):
        d = rows[min(first + lane, rows.size - 1)] if values.shape[0] > 1 else 0
        for b in range(found.shape[0]):
            a = b if values.shape[1] > 1 else 0
            for k in range(found.shape[1]):
                found[b, k, lane] = values[d, a, k if values.shape[2] > 1 else 0]


@_jit
def _add(values: Floats, index: Any, more: Lanes) -> None:
    """Add lanes to those of an array."""
    put(values, index, at(values, index) + more)


@_jit
def _times(a: Lanes, b: Lanes, c: Lanes, d: Lanes) -> tuple[Lanes, Lanes]:
    """Return (a + ib)(c + id)."""
    return a * c - b * d, a * d + b * c


@_jit
def _eliminate(M: Floats, b: int, n: int) -> None:
    """Solve M_b[:, :n] x = M_b[:, n:] in place, x in the last columns; no number where singular.

    A lane exchanges rows where its pivot is small beside another below it.
    """
    width = M.shape[2]
    for k in range(n):
        most = splat(0.0)
        for i in range(k + 1, n):
            most = larger(most, size_of(at(M, (b, i, k))))
        lack = PIVOT * most - size_of(at(M, (b, k, k)))
        if any_above(lack, splat(0.0)):
            for i in range(k + 1, n):
                own, other = size_of(at(M, (b, k, k))), size_of(at(M, (b, i, k)))
                gain = where_above(lack, splat(0.0), other - own, splat(-1.0))
                if any_above(gain, splat(0.0)):
                    for j in range(k, width):
                        upper, lower = at(M, (b, k, j)), at(M, (b, i, j))
                        put(M, (b, k, j), where_above(gain, splat(0.0), lower, upper))
                        put(M, (b, i, j), where_above(gain, splat(0.0), upper, lower))
        inverse = 1.0 / at(M, (b, k, k))
        put(M, (b, k, k), inverse)
        for i in range(k + 1, n):
            factor = at(M, (b, i, k)) * inverse
            for j in range(k + 1, width):
                put(M, (b, i, j), at(M, (b, i, j)) - factor * at(M, (b, k, j)))
    for k in range(n - 1, -1, -1):
        inverse = at(M, (b, k, k))
        for j in range(n, width):
            found = at(M, (b, k, j)) * inverse
            put(M, (b, k, j), found)
            for i in range(k):
                put(M, (b, i, j), at(M, (b, i, j)) - at(M, (b, i, k)) * found)


@_jit
def _condense(b: int, q_x: Lanes, q_y: Lanes, m: Lanes, work: _Work) -> None:
    """Condense blade b: ends' motion and flexibility; M keeps how its rotations follow."""
    nodes, A, made, M, F, y = work.nodes, work.A, work.made, work.M, work.F, work.y
    K, end_turn = nodes.shape[2], at(work.end_turn, (b, 0))
    first, of_A = b * K, b if A.shape[0] > 1 else 0
    x = z = turned = F_xx = F_yy = F_xy = F_mx = F_my = splat(0.0)
    for k in range(K):
        w, axial, shear, rho, far_turn = (
            at(nodes, (0, b, k)), at(nodes, (1, b, k)), at(nodes, (2, b, k)), at(nodes, (3, b, k)),
            at(nodes, (5, b, k)),
        )  # fmt: skip
        versine, s = versed(at(y, first + k))
        c = 1.0 - versine
        N, Q = q_x * c + q_y * s, q_y * c - q_x * s
        stretch, slide = 1.0 + rho * N, rho * Q
        elongation, shear_angle = axial * N, shear * Q
        f = Q * stretch
        f_x, f_y = slide * c - s * stretch, c * stretch + slide * s
        f_psi = slide * Q - N * stretch
        put(made, (0, k), f)
        put(made, (1, k), f_x)
        put(made, (2, k), f_y)
        put(made, (3, k), f_psi)
        F_xx = F_xx + w * (axial - rho * s * s)
        F_yy = F_yy + w * (shear + rho * s * s)
        F_xy = F_xy + w * rho * s * c
        F_mx = F_mx + far_turn * f_x
        F_my = F_my + far_turn * f_y
        x = x + w * (elongation * c - shear_angle * s - versine)
        z = z + w * (s + elongation * s + shear_angle * c)
        turned = turned + far_turn * f
    for i in range(K):
        turn = at(nodes, (4, b, i))
        own, by_x, by_y = turn * m - at(y, first + i), splat(0.0), splat(0.0)
        for k in range(K):
            each = at(A, (of_A, i * K + k))
            own = own + each * at(made, (0, k))
            by_x = by_x + each * at(made, (1, k))
            by_y = by_y + each * at(made, (2, k))
            put(M, (b, i, k), (1.0 if i == k else 0.0) - each * at(made, (3, k)))
        put(M, (b, i, K), own)
        put(M, (b, i, K + 1), by_x)
        put(M, (b, i, K + 2), by_y)
        put(M, (b, i, K + 3), turn)
    _eliminate(M, b, K)
    motion_x, motion_y, motion_m = x, z, turned + end_turn * m
    put(F, (0, 0), F_xx)
    put(F, (0, 1), F_xy)
    put(F, (0, 2), splat(0.0))
    put(F, (1, 0), F_xy)
    put(F, (1, 1), F_yy)
    put(F, (1, 2), splat(0.0))
    put(F, (2, 0), F_mx)
    put(F, (2, 1), F_my)
    put(F, (2, 2), end_turn)
    for k in range(K):
        e_x, e_y = at(nodes, (0, b, k)) * at(made, (1, k)), at(nodes, (0, b, k)) * at(made, (2, k))
        e_m = at(nodes, (5, b, k)) * at(made, (3, k))
        own = at(M, (b, k, K))
        motion_x, motion_y = motion_x + e_x * own, motion_y + e_y * own
        motion_m = motion_m + e_m * own
        for j in range(3):
            follow = at(M, (b, k, K + 1 + j))
            _add(F, (0, j), e_x * follow)
            _add(F, (1, j), e_y * follow)
            _add(F, (2, j), e_m * follow)
    put(work.motion, 0, motion_x)
    put(work.motion, 1, motion_y)
    put(work.motion, 2, motion_m)


@_jit
def _add_element(
    rows: tuple[int, int, int, int],
    grown: Lanes,
    force: tuple[Lanes, Lanes, Lanes],
    turn_i: tuple[Lanes, Lanes],
    turn_j: tuple[Lanes, Lanes],
    apart: tuple[Lanes, Lanes, Lanes],
    work: _Work,
) -> None:
    """Add gradient and second derivative of a blade, whose number leads its ``rows``.

    ``apart`` is by how much the body at its end moved more than that at its start.
    """
    b, e, i, j = rows
    ends, scales, motion, F = work.ends, work.scales, work.motion, work.F
    r, matrix = work.r, work.matrix
    nu_x, nu_y, m = force
    start_x, start_y, end_x, end_y = (
        at(ends, (b, 0)),
        at(ends, (b, 1)),
        at(ends, (b, 2)),
        at(ends, (b, 3)),
    )
    along_x, along_y = at(ends, (b, 4)), at(ends, (b, 5))
    scale, reach, weight = at(scales, (b, 0)), at(scales, (b, 1)), at(scales, (b, 2))
    along_moved_x, along_moved_y = _times(along_x, along_y, *turn_i)
    start_moved_x, start_moved_y = _times(start_x, start_y, *turn_i)
    end_moved_x, end_moved_y = _times(end_x, end_y, *turn_j)
    c, s = along_x + along_moved_x, along_y + along_moved_y
    bent_x, bent_y = _times(c, s, at(motion, 0), at(motion, 1))
    lever_x = start_x + start_moved_x + reach * c + bent_x
    lever_y = start_y + start_moved_y + reach * s + bent_y
    a_x, a_y = end_x + end_moved_x, end_y + end_moved_y
    size = weight * scale
    pull_x, pull_y = size * nu_x, size * nu_y
    moment_x, moment_y = _times(lever_x, -1.0 * lever_y, nu_x, nu_y)
    far_x, far_y = _times(a_x, -1.0 * a_y, nu_x, nu_y)
    gap_x = scale * apart[0] + grown * at(ends, (b, 6)) + end_moved_x - bent_x
    gap_y = scale * apart[1] + grown * at(ends, (b, 7)) + end_moved_y - bent_y
    put(r, e, weight * (gap_x - (start_moved_x + reach * along_moved_x)))
    put(r, e + 1, weight * (gap_y - (start_moved_y + reach * along_moved_y)))
    put(r, e + 2, weight * (apart[2] - at(motion, 2)))
    _add(r, i, -1.0 * pull_x)
    _add(r, i + 1, -1.0 * pull_y)
    _add(r, i + 2, -1.0 * (weight * (m + moment_y)))
    _add(r, j, pull_x)
    _add(r, j + 1, pull_y)
    _add(r, j + 2, weight * (m + far_y))
    # flexibility in global axes: T F Tᵀ
    for k in range(3):
        upper, lower = at(F, (0, k)), at(F, (1, k))
        put(F, (0, k), c * upper - s * lower)
        put(F, (1, k), s * upper + c * lower)
    for k in range(3):
        upper, lower = at(F, (k, 0)), at(F, (k, 1))
        put(F, (k, 0), c * upper - s * lower)
        put(F, (k, 1), s * upper + c * lower)
    p_x, p_y = weight * nu_y, -1.0 * (weight * nu_x)
    bend_x = at(F, (0, 0)) * p_x + at(F, (0, 1)) * p_y
    bend_y = at(F, (1, 0)) * p_x + at(F, (1, 1)) * p_y
    bend_m = at(F, (2, 0)) * p_x + at(F, (2, 1)) * p_y
    for k in range(3):
        for n in range(3):
            put(matrix, (e + k, e + n), -1.0 * (weight * at(F, (k, n))))
    _add(matrix, (e, i), -1.0 * size)
    _add(matrix, (e + 1, i + 1), -1.0 * size)
    _add(matrix, (e, j), size)
    _add(matrix, (e + 1, j + 1), size)
    _add(matrix, (e, i + 2), weight * lever_y - bend_x)
    _add(matrix, (e + 1, i + 2), -1.0 * (weight * lever_x + bend_y))
    _add(matrix, (e + 2, i + 2), -1.0 * (weight + bend_m))
    _add(matrix, (e, j + 2), -1.0 * (weight * a_y))
    _add(matrix, (e + 1, j + 2), weight * a_x)
    _add(matrix, (e + 2, j + 2), weight)
    _add(matrix, (i + 2, i + 2), weight * moment_x - (bend_x * nu_y - bend_y * nu_x))
    _add(matrix, (j + 2, j + 2), -1.0 * (weight * far_x))


@_jit
def _apply_forces(
    bodies: Integers, follow: NDArray[np.bool_], share: Lanes, first: int, work: _Work
) -> None:
    """Subtract forces on bodies from their balance, and their stiffness from its derivative."""
    forces, turns, r, matrix = work.forces, work.turned, work.r, work.matrix
    for a in range(bodies.size):
        i = first + 3 * bodies[a]
        turn_x, turn_y = 1.0 + at(turns, (bodies[a], 0)), at(turns, (bodies[a], 1))
        before = at(forces, (a, 5))
        size = before + share * (at(forces, (a, 6)) - before)
        arm_x, arm_y = _times(at(forces, (a, 0)), at(forces, (a, 1)), turn_x, turn_y)
        P_x, P_y = size * at(forces, (a, 2)), size * at(forces, (a, 3))
        if follow[a]:
            P_x, P_y = _times(P_x, P_y, turn_x, turn_y)
            _add(matrix, (i, i + 2), P_y)
            _add(matrix, (i + 1, i + 2), -1.0 * P_x)
        else:
            _add(matrix, (i + 2, i + 2), arm_x * P_x + arm_y * P_y)
        _add(r, i, -1.0 * P_x)
        _add(r, i + 1, -1.0 * P_y)
        _add(r, i + 2, -1.0 * (size * at(forces, (a, 4)) + arm_x * P_y - arm_y * P_x))


@_jit
def _apply_springs(bodies: Integers, first: int, work: _Work) -> None:
    """Add springs on bodies to their balance and its derivative."""
    springs, turns, y, r = work.springs, work.turned, work.poses, work.r
    matrix = work.matrix
    for a in range(bodies.size):
        body = 3 * bodies[a]
        i = first + body
        x_0, y_0 = at(springs, (a, 0)), at(springs, (a, 1))
        k_x, k_y, k_phi = at(springs, (a, 2)), at(springs, (a, 3)), at(springs, (a, 4))
        moved_x, moved_y = _times(x_0, y_0, at(turns, (bodies[a], 0)), at(turns, (bodies[a], 1)))
        arm_x, arm_y = x_0 + moved_x, y_0 + moved_y
        pull_x, pull_y = k_x * (at(y, body) + moved_x), k_y * (at(y, body + 1) + moved_y)
        _add(r, i, pull_x)
        _add(r, i + 1, pull_y)
        _add(r, i + 2, k_phi * at(y, body + 2) - pull_x * arm_y + pull_y * arm_x)
        _add(matrix, (i, i), k_x)
        _add(matrix, (i + 1, i + 1), k_y)
        _add(matrix, (i, i + 2), -1.0 * (k_x * arm_y))
        _add(matrix, (i + 2, i), -1.0 * (k_x * arm_y))
        _add(matrix, (i + 1, i + 2), k_y * arm_x)
        _add(matrix, (i + 2, i + 1), k_y * arm_x)
        stiffness = k_phi + k_x * arm_y * arm_y + k_y * arm_x * arm_x
        _add(matrix, (i + 2, i + 2), stiffness - (pull_x * arm_x + pull_y * arm_y))


@_jit
def _length(s: Floats, y: Floats, turns: int, k_f: int) -> Lanes:
    """Return the lengths of steps at y, not finite where one of their numbers is not."""
    force = rest = pull = finite = splat(0.0)
    for i in range(s.shape[0]):
        each = at(s, i)
        finite = finite + 0.0 * each
        if i < turns or i >= turns + k_f:
            rest = larger(rest, size_of(each))
        else:
            force, pull = larger(force, size_of(each)), larger(pull, size_of(at(y, i)))
    return larger(rest, force / (FORCE + pull)) + finite


@_jit
def _read_eight(
    first: int, x: Floats, share: Floats, rows: Integers, t: _Tables, work: _Work
) -> None:
    """Read the tables and unknowns of the eight designs from the ``first`` on."""
    _read(t.ends, rows, first, work.ends)
    _read(t.scales, rows, first, work.scales)
    _read(t.w, rows, first, work.nodes[0])
    _read(t.axial, rows, first, work.nodes[1])
    _read(t.shear, rows, first, work.nodes[2])
    _read(t.rho, rows, first, work.nodes[3])
    _read(t.turn, rows, first, work.nodes[4])
    _read(t.far_turn, rows, first, work.nodes[5])
    _read(t.A, rows, first, work.A)
    _read(t.end_turn, rows, first, work.end_turn)
    _read(t.before, rows, first, work.before)
    _read(t.after, rows, first, work.after)
    _read(t.forces, rows, first, work.forces)
    _read(t.springs, rows, first, work.springs)
    for lane in range(LANES):
        # lanes without a design of their own go with the last one
        p = min(first + lane, x.shape[0] - 1)
        work.share[0, lane] = share[p]
        for i in range(x.shape[1]):
            work.y[i, lane] = x[p, i]


@_jit
def _linearise(t: _Tables, work: _Work) -> None:
    """Find residual and derivative of the equations of eight designs at their unknowns y."""
    B, K = t.first.size, work.nodes.shape[2]
    y, poses, turned = work.y, work.poses, work.turned
    k_f, m_f = 3 * B, B * K + 3 * B
    share = at(work.share, 0)
    grown = splat(1.0) if t.grown else share
    for i in range(work.r.shape[0]):
        put(work.r, i, splat(0.0))
        for j in range(work.r.shape[0]):
            put(work.matrix, (i, j), splat(0.0))
    for i in range(y.shape[0] - m_f):
        put(poses, i, at(y, m_f + i))
    for i in range(turned.shape[0]):
        versine, sine = versed(at(poses, 3 * i + 2))
        put(turned, (i, 0), -1.0 * versine)
        put(turned, (i, 1), sine)
    for b in range(B):
        i, j, e = t.first[b], t.second[b], B * K + 3 * b
        nu_x, nu_y, m = at(y, e), at(y, e + 1), at(y, e + 2)
        turn_i = at(turned, (i, 0)), at(turned, (i, 1))
        turn_j = at(turned, (j, 0)), at(turned, (j, 1))
        along = at(work.ends, (b, 4)), at(work.ends, (b, 5))
        c, s = _times(along[0], along[1], 1.0 + turn_i[0], turn_i[1])
        q_x, q_y = _times(c, -1.0 * s, nu_x, nu_y)
        put(work.frames, (b, 0), c)
        put(work.frames, (b, 1), s)
        put(work.frames, (b, 2), q_x)
        put(work.frames, (b, 3), q_y)
        _condense(b, q_x, q_y, m, work)
        apart = (
            at(poses, 3 * j) - at(poses, 3 * i),
            at(poses, 3 * j + 1) - at(poses, 3 * i + 1),
            at(poses, 3 * j + 2) - at(poses, 3 * i + 2),
        )
        rows = b, 3 * b, k_f + 3 * i, k_f + 3 * j
        _add_element(rows, grown, (nu_x, nu_y, m), turn_i, turn_j, apart, work)
    for a in range(k_f):
        for i in range(k_f, work.r.shape[0]):
            put(work.matrix, (i, a), at(work.matrix, (a, i)))
    _apply_forces(t.forced, t.follow, share, k_f, work)
    _apply_springs(t.sprung, k_f, work)


@_jit
def _find_step(t: _Tables, work: _Work) -> None:
    """Find Newton's steps s of eight designs; the held coordinates go where they shall be."""
    B, K, n = t.first.size, work.nodes.shape[2], t.unknown.size
    k_f, turns = 3 * B, B * K
    total = work.y.shape[0] - turns
    share, s, square = at(work.share, 0), work.s, work.square
    for a in range(t.held.size):
        i, before = k_f + t.held[a], at(work.before, (0, a))
        there = before + share * (at(work.after, (0, a)) - before)
        moved = there - at(work.y, turns + i)
        put(s, turns + i, moved)
        for c in range(total):
            _add(work.r, c, at(work.matrix, (c, i)) * moved)
    for a in range(n):
        i = t.unknown[a]
        scale = 1.0 / at(work.scales, (i // 3, 2)) if i < k_f else splat(1.0)
        for c in range(n):
            put(square, (0, a, c), at(work.matrix, (i, t.unknown[c])) * scale)
        put(square, (0, a, n), -1.0 * (at(work.r, i) * scale))
    _eliminate(square, 0, n)
    for a in range(n):
        put(s, turns + t.unknown[a], at(square, (0, a, n)))
    for b in range(B):
        e, i = turns + 3 * b, turns + k_f + 3 * t.first[b]
        c, d = at(work.frames, (b, 0)), at(work.frames, (b, 1))
        d_x, d_y = _times(c, -1.0 * d, at(s, e), at(s, e + 1))
        d_m = at(s, e + 2)
        if i < s.shape[0]:
            turned = at(s, i + 2)
            d_x = d_x + at(work.frames, (b, 3)) * turned
            d_y = d_y - at(work.frames, (b, 2)) * turned
        for k in range(K):
            by_x, by_y = at(work.M, (b, k, K + 1)), at(work.M, (b, k, K + 2))
            follow = by_x * d_x + by_y * d_y + at(work.M, (b, k, K + 3)) * d_m
            put(s, b * K + k, at(work.M, (b, k, K)) + follow)


@_jit
def _solve_eight(
    first: int,
    scale: Floats,
    tolerance: float,
    trust: float,
    most: int,
    t: _Tables,
    work: _Work,
    ends: _Ends,
) -> None:
    """Go at most so many of Newton's steps from y with the eight designs from the ``first`` on."""
    k_f, turns = 3 * t.first.size, t.first.size * work.nodes.shape[2]
    y, s, goes, lengths = work.y, work.s, work.goes, work.lengths
    restless = work.restless
    for lane in range(LANES):
        goes[0, lane] = 1.0 if first + lane < scale.size else 0.0
        restless[lane] = 0
    for count in range(most):
        _linearise(t, work)
        _find_step(t, work)
        put(lengths, 0, _length(s, y, turns, k_f))
        for lane in range(LANES):
            if goes[0, lane] == 0.0:
                continue
            p, length = first + lane, lengths[0, lane]
            ends.iterations[p] += 1
            if count == 1:
                ends.bend[p] = length
            sure = min(trust, max(CONTRACTION * ends.last[p], FLOOR)) if trust < np.inf else np.inf
            goes[0, lane] = min(1.0, REACH / max(length, REACH))
            if not length < np.inf:
                ends.end[p], goes[0, lane] = _SINGULAR, 0.0
            elif count > 0 and length > sure:
                ends.end[p], goes[0, lane] = _FAR, 0.0
        share = at(goes, 0)
        for i in range(y.shape[0]):
            here = at(y, i)
            put(y, i, where_above(share, splat(0.0), here + share * at(s, i), here))
        put(lengths, 1, _length(y, y, turns, k_f))
        left = False
        for lane in range(LANES):
            if goes[0, lane] == 0.0:
                continue
            p, length = first + lane, lengths[0, lane]
            ratio = length / (ends.last[p] if ends.last[p] > 0.0 else 1.0)
            ends.last[p], ends.length[p] = length, lengths[1, lane]
            unit = min(1.0, max(scale[p], lengths[1, lane]))
            if count > 0:
                ends.bends[p] = min(ratio, 1.0) ** 2 / (length if length > 0.0 else 1.0)
            restless[lane] = restless[lane] + 1 if ratio > 1.0 else 0
            ahead = ends.bends[p] * length**2
            if ahead <= tolerance * unit or (length <= FLOOR * unit and ratio > 0.5):
                ends.end[p], goes[0, lane] = _CONVERGED, 0.0
            elif restless[lane] >= RESTLESS:
                goes[0, lane] = 0.0
            left = left or goes[0, lane] > 0.0
        if not left:
            break


@partial(_jit, allocates=True)
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
) -> tuple[Floats, _Ends]:
    """Move the designs ``rows`` from x at shares λ by Newton's method, at most so many steps.

    Return the last steps and how each design ended; x and ``bends`` are written to.
    """
    designs, size = x.shape
    B, K = t.first.size, t.w.shape[2]
    total = size - B * K
    bodies = total // 3 - B
    n = t.unknown.size
    steps = np.zeros((designs, size))
    ends = _Ends(
        np.full(designs, _DIVERGED), np.zeros(designs, np.int64), np.full(designs, np.inf),
        np.zeros(designs), np.zeros(designs), bends,
    )  # fmt: skip
    work = _Work(
        ends=np.empty((B, 8, LANES)),
        scales=np.empty((B, 3, LANES)),
        nodes=np.empty((6, B, K, LANES)),
        A=np.empty((t.A.shape[1], K * K, LANES)),
        end_turn=np.empty((B, 1, LANES)),
        before=np.empty((1, t.held.size, LANES)),
        after=np.empty((1, t.held.size, LANES)),
        forces=np.empty((t.forced.size, 7, LANES)),
        springs=np.empty((t.sprung.size, 5, LANES)),
        y=np.empty((size, LANES)),
        s=np.empty((size, LANES)),
        r=np.empty((total + 3, LANES)),
        matrix=np.empty((total + 3, total + 3, LANES)),
        square=np.empty((1, n, n + 1, LANES)),
        made=np.empty((4, K, LANES)),
        M=np.empty((B, K, K + 4, LANES)),
        motion=np.empty((3, LANES)),
        F=np.empty((3, 3, LANES)),
        frames=np.empty((B, 4, LANES)),
        turned=np.empty((bodies + 1, 2, LANES)),
        poses=np.zeros((3 * bodies + 3, LANES)),
        share=np.empty((1, LANES)),
        goes=np.empty((1, LANES)),
        lengths=np.empty((2, LANES)),
        restless=np.empty(LANES, np.int64),
    )
    for first in range(0, designs, LANES):
        _read_eight(first, x, share, rows, t, work)
        _solve_eight(first, scale, tolerance, trust, most, t, work, ends)
        for lane in range(min(LANES, designs - first)):
            for i in range(size):
                x[first + lane, i] = work.y[i, lane]
                steps[first + lane, i] = work.s[i, lane]
    return steps, ends
