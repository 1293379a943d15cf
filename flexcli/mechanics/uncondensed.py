"""Newton's steps of one small design: all unknowns at once, no blade condensed.

The equations are those of :mod:`flexcli.mechanics.beam` and :mod:`flexcli.mechanics.element`, and
so are the steps, to the second order of what rotations and forces are apart. NumPy takes about a
microsecond a call, however little it is called for, so that one design is solved fastest by few
calls on one full matrix. Rotations θ = ψ + φ of sections are from the global axes: then a turn of
the body at its start changes a blade by nothing but where it begins. With the direction T of a
section and the force ν, F = T* ν = N + iQ,

    f = Im(F + ρ F²/2),  ∂f/∂θ = −Re(F + ρ F²),  ∂f/∂ν = ∂r'/∂θ = i (1 + ρ F*) T.

Unknowns and equations are in this order: rotations at the nodes, end moments of the blades,
rotations of the bodies; forces of the blades, positions of the bodies, x and y of each in turn.
"""

import functools
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.assembly import FORCE, Assembly
from flexcli.mechanics.demand import Demand, Force, Spring
from flexcli.numerics.newton import NewtonResult, newton
from flexcli.numerics.stack import solve_stack

__all__ = ["Uncondensed", "uncondensed"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Integers = NDArray[np.intp]

_MOST = 120
"""Unknowns up to which one full matrix is faster than blades condensed."""


class _Ends(NamedTuple):
    """What hangs on no node: one number a blade, or ``arm`` (bodies, blades) where these are held.

    ``begins`` (bodies, blades) is one where a blade starts on a body; ``first`` is that body, the
    ground the last; ``linear`` are the equations of moments, forces and bodies as far as linear.
    """

    first: Integers
    begins: Floats
    weight: Floats
    along: Complexes
    reach: Complexes
    misfit: Complexes
    arm: Complexes
    linear: Floats


class _Nodes(NamedTuple):
    """What the nodes are, those of all blades side by side, and what no step changes.

    ``of`` is the blade of a node, ``spread`` (nodes, blades) is one there; ``sums`` (nodes, blades)
    integrate along each blade, ``by_f`` is what f does: it turns nodes and ends, and its moment is
    on the bodies at the starts. ``chord`` is a blade at rest as its nodes integrate it, ``arm``
    where it is held and, at its start, what is left of its length. ``linear`` times the unknowns
    and ``still`` are the constant parts of the equations and of their derivative.
    """

    of: Integers
    axial: Floats
    shear: Complexes
    rho: Floats
    spread: Complexes
    sums: Floats
    by_f: Floats
    chord: Complexes
    arm: Complexes
    linear: Floats
    still: Floats
    order: Integers
    back: Integers


class Uncondensed:
    """Newton's steps of one design under a demand."""

    def __init__(self, assembly: Assembly, demand: Demand) -> None:
        self._turns, self._blades, self._bodies = assembly.turns, assembly.blades, assembly.bodies
        prepared, kind = assembly.layout.prepared, (Uncondensed, assembly.effects)
        ends = prepared.get(kind)
        if ends is None:
            ends = prepared[kind] = _ends_of(assembly)
        nodes = prepared.get((*kind, assembly.nodes))
        if nodes is None:
            nodes = prepared[(*kind, assembly.nodes)] = _nodes_of(assembly, ends)
        self._ends: _Ends = ends
        self._nodes: _Nodes = nodes
        self._demand = demand
        self._held = nodes.back[assembly.size - 3 * assembly.bodies + demand.held]

    def step(self, x: Floats, share: Floats, rows: Integers) -> Floats:
        """Return Newton's step of the design, (1, unknowns), at the share λ (1,) of the way."""
        J, r, _ = self._equations(x[0], float(share[0]))
        return self._change(solve_stack(J, r[:, None]))

    def steps(self, x: Floats, share: float) -> tuple[Floats, Floats]:
        """Return Newton's step at constant share λ, and dx/dλ of the path, (unknowns,) both."""
        J, r, moved = self._equations(x, share)
        step, rate = self._change(solve_stack(J, np.stack([r, self._growth(moved)], axis=1)))
        return step, rate

    def _change(self, solved: Floats) -> Floats:
        """Return the changes of the unknowns (columns, unknowns) that undo what is left."""
        turns, top = self._turns, self._turns + self._blades + self._bodies
        change = -solved
        change[:turns] += (
            self._nodes.still[:turns, top - self._bodies : top] @ change[top - self._bodies : top]
        )
        return np.asarray(change[self._nodes.back].T)

    def _equations(self, x: Floats, share: float) -> tuple[Floats, Floats, Complexes]:
        """Return derivative and left-overs of the equations, and how far bodies have turned."""
        of, axial, shear, rho, spread, sums, by_f, chord, arm, linear, still, order, _ = self._nodes
        ends, demand = self._ends, self._demand
        turns, top, size = self._turns, self._turns + self._blades + self._bodies, order.size
        phi, nu = slice(top - self._bodies, top), slice(top, top + 2 * self._blades)
        z = x[order]
        J, r = still.copy(), linear @ z
        force = z[nu].view(np.complex128)
        e = np.exp(0.5j * z[:top])
        moved = 2j * e.imag * e
        of_body = np.zeros(self._bodies + 1, dtype=np.complex128)
        of_body[:-1] = moved[phi]
        start, moved = of_body[ends.first], moved[:turns]
        frame = (ends.along * (1.0 + start))[of]
        T = frame * (1.0 + moved)
        F = force[of] * T.conj()
        more = rho * F
        G = 1j * (1.0 + more.conj()) * T
        more *= F
        rate = frame * moved + (axial * F.real + shear * F.imag) * T
        # rotations at the nodes and ends, moments at the starts
        r[:top] -= by_f @ (F + 0.5 * more).imag
        J[:top, :turns] += by_f * (F + more).real
        J[:top, nu] -= ((by_f * G) @ spread).view(np.float64)
        # where the ends of blades and bodies are apart
        gap = r[nu].view(np.complex128)
        gap += of_body[:-1] @ arm - chord * start - rate @ sums
        gap += (1.0 if demand.grown else share) * ends.misfit
        J[nu, :turns] = -(sums * G[:, None]).view(np.float64).T
        bent = (0.5 * rho * T * T) @ sums
        flat, below, last = J.reshape(-1), 2 * size + 2, nu.stop * (size + 1)
        first = top * (size + 1)
        flat[first:last:below] -= bent.real
        flat[first + size + 1 : last : below] += bent.real
        flat[first + 1 : last : below] = flat[first + size : last : below] = -bent.imag
        lever = 1j * arm * (1.0 + of_body[:-1, None])
        J[nu, phi] = lever.view(np.float64).T
        # moments of the blades' forces about the bodies
        lever *= ends.weight
        J[phi, nu] += lever.view(np.float64)
        moment = lever.conj() @ force
        r[phi] += moment.real
        flat[(top - self._bodies) * (size + 1) : first : size + 1] = moment.imag
        for each in demand.forces:
            self._apply_force(each, share, of_body, r, J)
        for spring in demand.springs:
            self._apply_spring(spring, z, of_body, r, J)
        before, after = demand.before[0], demand.after[0]
        J[self._held] = 0.0
        J[self._held, self._held] = 1.0
        r[self._held] = z[self._held] - (before + share * (after - before))
        return J, r, of_body

    def newton(self, x: Floats, share: Floats, rows: Integers, **how: Any) -> NewtonResult:
        """Return where Newton's method leads from x."""
        return newton(lambda y, _: self.step(y, share, rows), self._length, x, **how)

    def _length(self, x: Floats, step: Floats) -> Floats:
        """Return the length of a step [-] (``Assembly.length_of``)."""
        k_f = slice(self._turns, self._turns + 3 * self._blades)
        size = np.abs(step[0])
        pulled = size[k_f] if x is step else np.abs(x[0, k_f])
        size[k_f] /= FORCE + np.maximum.reduce(pulled)
        return np.maximum.reduce(size, keepdims=True)

    def _growth(self, moved: Complexes) -> Floats:
        """Return the derivative of the left-overs by λ."""
        demand, top = self._demand, self._turns + self._blades + self._bodies
        r = np.zeros(self._nodes.order.size)
        if not demand.grown:
            r[top : top + 2 * self._blades] = self._ends.misfit.view(np.float64)
        for force in demand.forces:
            self._pull(force, force.after[0] - force.before[0], moved, r)
        r[self._held] = demand.before[0] - demand.after[0]
        return r

    def _pull(
        self, force: Force, size: float, moved: Complexes, r: Floats
    ) -> tuple[complex, complex]:
        """Subtract a force of a size on a body from its balance; return it, and it by its arm."""
        x, phi = self._rows_of(force.body)
        turn = 1.0 + moved[force.body]
        arm, P = complex(*force.arm[0]) * turn, size * complex(*force.force[0])
        if force.follows:
            P *= turn
        moment = arm.conjugate() * P
        r[x] -= P.real
        r[x + 1] -= P.imag
        r[phi] -= size * force.moment[0] + moment.imag
        return P, moment

    def _apply_force(
        self, force: Force, share: float, moved: Complexes, r: Floats, J: Floats
    ) -> None:
        """Subtract a force on a body from its balance (``outer_forces.apply_force``)."""
        x, phi = self._rows_of(force.body)
        before = force.before[0]
        P, moment = self._pull(force, before + share * (force.after[0] - before), moved, r)
        if force.follows:
            J[x, phi] += P.imag
            J[x + 1, phi] -= P.real
        else:
            J[phi, phi] += moment.real

    def _apply_spring(
        self, spring: Spring, z: Floats, moved: Complexes, r: Floats, J: Floats
    ) -> None:
        """Add springs on a body to its balance (``outer_forces.apply_spring``)."""
        x, phi = self._rows_of(spring.body)
        k_x, k_y, k_phi = spring.stiffness[0]
        rest = complex(*spring.arm[0])
        arm, way = rest * (1.0 + moved[spring.body]), rest * moved[spring.body]
        pull_x, pull_y = k_x * (z[x] + way.real), k_y * (z[x + 1] + way.imag)
        r[x] += pull_x
        r[x + 1] += pull_y
        r[phi] += k_phi * z[phi] - pull_x * arm.imag + pull_y * arm.real
        for row, k, lever in ((x, k_x, -arm.imag), (x + 1, k_y, arm.real)):
            J[row, row] += k
            J[row, phi] += k * lever
            J[phi, row] += k * lever
            J[phi, phi] += k * lever**2
        J[phi, phi] += k_phi - pull_x * arm.real - pull_y * arm.imag

    def _rows_of(self, body: int) -> tuple[int, int]:
        """Return the rows of the x, before that of y, and of the rotation of a body."""
        turns = self._turns + self._blades
        return turns + self._bodies + 2 * (self._blades + body), turns + body


def uncondensed(assembly: Assembly, demand: Demand) -> Uncondensed | None:
    """Return Newton's steps of one design where they are faster than by blades condensed."""
    return Uncondensed(assembly, demand) if assembly.size <= _MOST else None


def _ends_of(assembly: Assembly) -> _Ends:
    """Return what of a layout's equations hangs on no node."""
    B, n = assembly.blades, assembly.bodies
    ends, scales = np.empty((5, B), complex), np.empty((2, B))
    for mesh, place, weight in zip(assembly.meshes, assembly.places, assembly.weights, strict=True):
        some = list(mesh.blades)
        ends[0, some], ends[1, some], ends[2, some] = place.start[0], place.end[0], place.along[0]
        ends[3, some], ends[4, some] = (place.reach * place.along)[0], place.misfit[0]
        scales[0, some], scales[1, some] = place.scale[0], weight[0]
    start, end, along, reach, misfit = ends
    scale, weight = scales
    bodies = np.arange(n)[:, None]
    begins = (bodies == assembly.first).astype(np.float64)
    stops = (bodies == assembly.second).astype(np.float64)
    apart = stops - begins
    linear = np.zeros((3 * (B + n), 3 * (B + n)))
    m, phi = slice(0, B), slice(B, B + n)
    linear[m, phi] = apart.T
    linear[phi, m] = apart * weight
    for axis in (0, 1):
        nu, place_of = slice(B + n + axis, 3 * B + n, 2), slice(3 * B + n + axis, None, 2)
        linear[nu, place_of] = (apart * scale).T
        linear[place_of, nu] = apart * scale * weight
    arm = stops * end - begins * start
    return _Ends(assembly.first, begins, weight, along, reach, misfit, arm, linear)


class _Pattern(NamedTuple):
    """Which blade each node is ``of``, as a matrix too, and where x stands: names as in _Nodes."""

    of: Integers
    one: Floats
    spread: Complexes
    order: Integers
    back: Integers


@functools.cache
def _pattern(counts: tuple[tuple[tuple[int, ...], int], ...], n: int) -> _Pattern:
    """Return that of n bodies and of blades, mesh by mesh, with so many nodes each."""
    of = np.concatenate([np.repeat(blades, K) for blades, K in counts])
    B, turns = sum(len(blades) for blades, _ in counts), of.size
    blades, bodies = np.arange(B), np.arange(n)
    one = (of[:, None] == blades).astype(np.float64)
    force = turns + B + n + 2 * blades
    place = turns + 3 * B + n + 2 * bodies
    back = [
        np.arange(turns),
        np.stack([force, force + 1, turns + blades], axis=1).ravel(),
        np.stack([place, place + 1, turns + B + bodies], axis=1).ravel(),
    ]
    to = np.concatenate(back)
    return _Pattern(of, one, one.astype(complex), np.argsort(to), to)


def _nodes_of(assembly: Assembly, ends: _Ends) -> _Nodes:
    """Return the nodes of a layout's blades and the constant parts of its equations."""
    B, n, turns, size = assembly.blades, assembly.bodies, assembly.turns, assembly.size
    top = turns + B + n
    counts = tuple((mesh.blades, mesh.nodes) for mesh in assembly.meshes)
    of, one, spread, order, back = _pattern(counts, n)
    nodes, by_f, end_turn = np.empty((6, turns)), np.zeros((top, turns)), np.empty(B)
    last = 0
    for mesh in assembly.meshes:
        K, first = mesh.nodes, last
        last += K * len(mesh.blades)
        each = (mesh.w, mesh.axial, mesh.shear, mesh.rho, mesh.turn, mesh.far_turn)
        for row, values in zip(nodes, each, strict=True):
            row[first:last].reshape(-1, K)[...] = values[0]
        for i in range(len(mesh.blades)):
            here = slice(first + i * K, first + (i + 1) * K)
            by_f[here, here] = mesh.A[0, min(i, mesh.A.shape[1] - 1)]
        end_turn[list(mesh.blades)] = mesh.end_turn[0]
    w, axial, shear, rho, turn, far_turn = nodes
    sums = one * w[:, None]
    chord = ends.along * sums.sum(axis=0)
    by_f[turns : turns + B] = one.T * far_turn
    by_f[turns + B :] = (ends.begins * ends.weight) @ sums.T
    linear = np.zeros((size, size))
    linear[turns:, turns:] = ends.linear
    diagonal = linear.reshape(-1)[:: size + 1]
    diagonal[:turns], diagonal[turns : turns + B] = 1.0, -end_turn
    linear[:turns, turns : turns + B] = -turn[:, None] * one
    still = linear.copy()
    still[:turns, turns + B : top] = -one @ ends.begins.T
    soft = still.reshape(-1)[:: size + 1][top : top + 2 * B].reshape(B, 2)
    soft[...] = -0.5 * ((axial + shear) @ sums)[:, None]
    return _Nodes(
        of=of,
        axial=axial,
        shear=np.asarray(1j * shear, complex),
        rho=rho,
        spread=spread,
        sums=sums,
        by_f=by_f,
        chord=chord,
        arm=ends.arm - ends.begins * (ends.reach - chord),
        linear=linear,
        still=still,
        order=order,
        back=back,
    )
