"""A layout as equations for Newton's method: blades closed between bodies, bodies in equilibrium.

One row of unknowns per design: rotations at the nodes of all blades, then force and end moment of
each blade (scaled by the blade), then (x, y, φ) of each body (lengths in a unit of the design).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.beam import Condensed, Sections, condense, paired, turning
from flexcli.mechanics.demand import Demand
from flexcli.mechanics.element import Attachment, Ends, element
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.mesh import Effects, Mesh, chosen, column, drawn, meshes, pick, refined
from flexcli.mechanics.outer_forces import apply_force, apply_spring
from flexcli.numerics.collocation import refining_matrix
from flexcli.numerics.stack import solve_stack

__all__ = ["FORCE", "Assembly", "Linearised", "assemble", "at_nodes", "finer"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Integers = NDArray[np.intp]


class Linearised(NamedTuple):
    """The equations of the designs about a state, rotations at the nodes eliminated.

    ``residual`` and the symmetric ``matrix`` are of forces and ends of the blades, then of the
    bodies; ``row_scale`` (designs or 1, …) brings each row to order one before it is solved.
    ``frames`` and ``local`` are directions and forces n_x + i n_y of the blades of each mesh in the
    frames of their starts, the designs their last axis.
    """

    residual: Floats
    matrix: Floats
    row_scale: Floats
    blades: tuple[Condensed, ...]
    frames: tuple[Complexes, ...]
    local: tuple[Complexes, ...]


class Bound(NamedTuple):
    """The blades of a mesh between their bodies, as the equations take them, designs last.

    ``blades`` chooses them among all, ``first`` and ``second`` are their bodies, ``slots`` the rows
    that the 9 rows of a blade's element go to, ``on`` (bodies, 2 · blades) tells which end of which
    blade is on which body.
    """

    blades: slice | Integers
    first: Integers
    second: Integers
    slots: Integers
    on: Floats
    sections: Sections
    ends: Ends


@dataclass(frozen=True, eq=False)
class Assembly:
    """A layout ready to be solved; ``length`` [m] and ``force`` [N] are the units of each design.

    ``first`` and ``second`` are the bodies of each blade, the ground being the last, which never
    moves; ``weights`` are the energy units of blades over that of the design, ``turns`` is the
    number of rotations at nodes in a row of unknowns, ``slenderness`` the least thickness over
    length of any blade. ``other`` is the same layout at other nodes, if it is there.
    """

    layout: Layout
    effects: Effects
    nodes: int
    meshes: tuple[Mesh, ...]
    places: tuple[Attachment, ...]
    weights: tuple[Floats, ...]
    first: Integers
    second: Integers
    length: Floats
    force: Floats
    turns: int
    designs: int
    slenderness: float
    other: "Assembly | None" = None

    @cached_property
    def bound(self) -> tuple[Bound, ...]:
        """Return the blades of each mesh between their bodies."""
        if self.other is not None:
            alike = zip(self.other.bound, self.meshes, strict=True)
            return tuple(at._replace(sections=Sections.of(mesh)) for at, mesh in alike)
        drawn = zip(self.meshes, self.places, self.weights, strict=True)
        return tuple(_bound(*each, self.first, self.second, self.bodies) for each in drawn)

    @cached_property
    def row_scale(self) -> Floats:
        """Return what brings the equations to order one (rows, designs or 1)."""
        if self.other is not None:
            return self.other.row_scale
        found = np.ones((3 * (self.blades + self.bodies), _designs(self.weights)))
        for mesh, weight in zip(self.meshes, self.weights, strict=True):
            rows = found[: 3 * self.blades].reshape(self.blades, 3, -1)
            rows[list(mesh.blades)] = 1.0 / weight.T[:, None]
        return found

    @property
    def bodies(self) -> int:
        """Return the number of bodies that may move."""
        return len(self.layout.bodies)

    @property
    def blades(self) -> int:
        """Return the number of blades."""
        return len(self.layout.blades)

    @property
    def size(self) -> int:
        """Return the number of unknowns of a design."""
        return self.turns + 3 * (self.blades + self.bodies)

    def split(self, x: Floats) -> tuple[list[Floats], Floats, Floats]:
        """Return rotations of each mesh, blade forces and body motions (designs, …, 3)."""
        first, rotations = 0, []
        for mesh in self.meshes:
            last = first + mesh.nodes * len(mesh.blades)
            rotations.append(x[:, first:last].reshape(-1, len(mesh.blades), mesh.nodes))
            first = last
        forces = x[:, first : first + 3 * self.blades].reshape(-1, self.blades, 3)
        return rotations, forces, x[:, first + 3 * self.blades :].reshape(-1, self.bodies, 3)

    def forces_and_motions(self, x: Floats) -> tuple[Floats, Floats]:
        """Return blade forces and body motions, each in a row of its design."""
        bodies = self.turns + 3 * self.blades
        return x[:, self.turns : bodies], x[:, bodies:]

    def local_forces(self, forces: Floats, motions: Floats, k: int, rows: Integers) -> Floats:
        """Return the forces of the blades of mesh k in the frames of their starts."""
        at = self.bound[k]
        found = forces[:, at.blades]
        phi = np.concatenate([motions[..., 2], np.zeros((len(motions), 1))], axis=1)[:, at.first]
        frame = pick(self.places[k].along, rows) * (1.0 + turning(phi))
        q = paired(found[..., 0], found[..., 1]) * frame.conj()
        return np.stack([q.real, q.imag, found[..., 2]], axis=-1)

    def linearise(self, x: Floats, share: Floats, rows: Integers, demand: Demand) -> Linearised:
        """Return the equations of the designs ``rows`` about x at the share λ of the way.

        Their arrays may not be written to: a single design keeps those at rest.
        """
        layout, k_f = self.layout, 3 * self.blades
        kept: dict[Any, Linearised] | None = None
        if self.designs == 1 == len(x) and not x.any():
            grown = bool(layout.body_growth or layout.blade_growth)
            kept = None if grown else layout.prepared
        key = Linearised, self.effects, self.nodes
        at = None if kept is None else kept.get(key)
        if at is None:
            at = self._about(x, rows, demand.warmth(share))
            if kept is not None:
                kept[key] = at
        if not demand.forces and not demand.springs:
            return at
        if kept is not None:
            at = at._replace(residual=at.residual.copy(), matrix=at.matrix.copy())
        motions, residual, matrix = self.split(x)[2], at.residual[:, k_f:], at.matrix[:, k_f:, k_f:]
        for force in demand.forces:
            before, after = pick(force.before, rows), pick(force.after, rows)
            size = before + share * (after - before)
            apply_force(force, motions, size, rows, residual, matrix)
        for spring in demand.springs:
            apply_spring(spring, motions, rows, residual, matrix)
        return at

    def _about(self, x: Floats, rows: Integers, warmth: Floats) -> Linearised:
        """Return the equations about x without forces and springs on the bodies."""
        designs, k_f = x.shape[0], 3 * self.blades
        total, bodies = k_f + 3 * self.bodies, self.bodies
        # designs last: what loops over them runs through memory; the ground behind the bodies
        rotations, forces, poses = self._across(x)
        residual = np.zeros((total + 3, designs))
        matrix = np.zeros((total + 3, total + 3, designs))
        nu, turns = paired(forces[:, 0], forces[:, 1]), turning(poses[:, 2])
        gaps = residual[:k_f].reshape(self.blades, 3, designs)
        on = np.zeros((bodies, 4, designs))
        condensed, frames, local = [], [], []
        for at, psi in zip(self.bound, rotations, strict=True):
            ends, force = at.ends.chosen(rows), (nu[at.blades], forces[at.blades, 2])
            turn = turns.take([at.first, at.second], axis=0)
            frame = ends.along * (1.0 + turn[0])
            q = force[0] * frame.conj()
            blade = condense(at.sections.chosen(rows), psi, q, force[1])
            apart = poses.take(at.second, axis=0) - poses.take(at.first, axis=0)
            found = element(ends, blade, frame, force, apart, turn, warmth)
            gaps[at.blades] = found.gap
            matrix[at.slots[:, :3, None], at.slots[:, None]] = found.closing
            matrix[at.slots[:, None, 3:], at.slots[:, :3, None]] = found.closing[:, :, 3:]
            on += np.einsum("ij,jkn->ikn", at.on, found.on.reshape(at.on.shape[1], 4, designs))
            condensed.append(blade)
            frames.append(frame)
            local.append(q)
        residual[k_f:-3] = on[:, :3].reshape(3 * bodies, designs)
        turned = np.arange(k_f + 2, total, 3)
        matrix[turned, turned] = on[:, 3]
        residual, matrix = residual[:-3].T, matrix[:-3, :-3].transpose(2, 0, 1)
        return Linearised(
            residual=residual,
            matrix=matrix,
            row_scale=chosen(self.row_scale, rows).T,
            blades=tuple(condensed),
            frames=tuple(frames),
            local=tuple(local),
        )

    def _across(self, x: Floats) -> tuple[list[Floats], Floats, Floats]:
        """Return rotations of each mesh, blade forces and poses of bodies and ground (…, 3, n)."""
        designs = x.shape[0]
        across = np.zeros((x.shape[1] + 3, designs))
        across[:-3] = x.T
        first, rotations = 0, []
        for mesh in self.meshes:
            last = first + mesh.nodes * len(mesh.blades)
            rotations.append(across[first:last].reshape(len(mesh.blades), mesh.nodes, designs))
            first = last
        last = first + 3 * self.blades
        return (
            rotations,
            across[first:last].reshape(self.blades, 3, designs),
            across[last:].reshape(self.bodies + 1, 3, designs),
        )

    def step(self, x: Floats, share: Floats, rows: Integers, demand: Demand) -> Floats:
        """Return Newton's steps; the held coordinates go where they shall be."""
        found = np.empty_like(x)
        for first in range(0, len(x), _AT_ONCE):
            some = slice(first, first + _AT_ONCE)
            y, of, way = x[some], rows[some], share[some]
            at = self.linearise(y, way, of, demand)
            found[some] = self._answer(at, -at.residual, self._astray(y, way, of, demand), demand)
        return found

    def steps(
        self, x: Floats, share: Floats, rows: Integers, demand: Demand
    ) -> tuple[Floats, Floats]:
        """Return Newton's steps at constant share λ, and dx/dλ of the path."""
        at = self.linearise(x, share, rows, demand)
        step = self._answer(at, -at.residual, self._astray(x, share, rows, demand), demand)
        pushed, unused = np.zeros_like(at.residual), np.zeros_like(at.matrix)
        motions = self.split(x)[2]
        for force in demand.forces:
            grows = pick(force.after, rows) - pick(force.before, rows)
            apply_force(force, motions, grows, rows, pushed[:, 3 * self.blades :], unused)
        if not demand.grown:
            for mesh, place, weights in zip(self.meshes, self.places, self.weights, strict=True):
                misfit = pick(place.misfit, rows) * pick(weights, rows)
                for a, b in enumerate(mesh.blades):
                    opens = misfit[:, min(a, misfit.shape[1] - 1)]
                    pushed[:, 3 * b] += opens.real
                    pushed[:, 3 * b + 1] += opens.imag
        drive = np.broadcast_to(
            pick(demand.after, rows) - pick(demand.before, rows), (x.shape[0], demand.held.size)
        )
        settled = at._replace(blades=tuple(b._replace(free=b.free * 0.0) for b in at.blades))
        return step, self._answer(settled, -pushed, drive, demand)

    def _astray(self, x: Floats, share: Floats, rows: Integers, demand: Demand) -> Floats:
        """Return how far the held coordinates are from where they shall be."""
        before, after = pick(demand.before, rows), pick(demand.after, rows)
        now = x[:, self.turns + 3 * self.blades + demand.held]
        return np.asarray(before + share[:, None] * (after - before) - now)

    def _answer(
        self,
        at: Linearised,
        right: Floats,
        drive: Floats,
        demand: Demand,
    ) -> Floats:
        """Return the change of all unknowns for right-hand sides and motions of the held."""
        k_f, turns = 3 * self.blades, self.turns
        matrix, scale = at.matrix.transpose(1, 2, 0), at.row_scale.T
        designs = right.shape[0]
        step = np.zeros((turns + right.shape[1] + 3, designs))
        change = step[turns:-3]
        held, free = k_f + demand.held, np.concatenate([np.arange(k_f), k_f + demand.free])
        change[held] = drive.T
        rows, scale = matrix[free], scale[free]
        load = right.T[free] - np.einsum("ijn,jn->in", rows[:, held], drive.T)
        square = rows[:, free] * scale[:, None]
        found = solve_stack(square.transpose(2, 0, 1), (load * scale).T[..., None])
        change[free] = found[..., 0].T
        # the blades' forces follow the bodies in their own frames, the rotations follow the forces
        forces = step[turns : turns + k_f].reshape(self.blades, 3, designs)
        d_nu, d_phi = paired(forces[:, 0], forces[:, 1]), step[turns + k_f + 2 :: 3]
        first = 0
        for bound, blade, frame, q in zip(self.bound, at.blades, at.frames, at.local, strict=True):
            d_q = frame.conj() * d_nu[bound.blades] - 1j * q * d_phi[bound.first]
            d_local = forces[bound.blades].copy()
            d_local[:, 0], d_local[:, 1] = d_q.real, d_q.imag
            d_psi = blade.free + np.einsum("bkjn,bjn->bkn", blade.follow, d_local)
            last = first + d_psi.shape[0] * d_psi.shape[1]
            step[first:last] = d_psi.reshape(last - first, designs)
            first = last
        return step[:-3].T

    def length_of(self, x: Floats, step: Floats) -> Floats:
        """Return the length of a step: rotations, motions, and forces over those they add to."""
        k_f = slice(self.turns, self.turns + 3 * self.blades)
        size = np.abs(step)
        forces = size[:, k_f] if x is step else np.abs(x[:, k_f])
        size[:, k_f] /= FORCE + forces.max(axis=1, initial=0.0, keepdims=True)
        return np.asarray(size.max(axis=1))


FORCE = 10.0
"""Scaled force [EI/l²] that counts as one in the length of a step: that of an Euler column."""

_AT_ONCE = 1024
"""Designs of a step at a time: what it works on stays in the cache of a core."""


def assemble(layout: Layout, effects: Effects, nodes: int) -> Assembly:
    """Return the layout at ``nodes`` Gauss nodes on each piece of each blade.

    A single design keeps what it is at each number of nodes, for its next equilibrium.
    """
    known: dict[int, Assembly] = layout.prepared.setdefault(effects, {})
    found = known.get(nodes)
    if found is None:
        coarse = next(iter(known.values()), None)
        found = _assembled(layout, effects, nodes) if coarse is None else _refined(coarse, nodes)
        if found.designs == 1:
            known[nodes] = found
    return found


def at_nodes(assembly: Assembly, nodes: int) -> Assembly:
    """Return the same layout at another number of Gauss nodes on each piece."""
    if assembly.designs == 1:
        return assemble(assembly.layout, assembly.effects, nodes)
    return _refined(assembly, nodes)


def _refined(assembly: Assembly, nodes: int) -> Assembly:
    layout, effects = assembly.layout, assembly.effects
    found = tuple(refined(mesh, layout, effects, nodes) for mesh in assembly.meshes)
    return replace(assembly, nodes=nodes, meshes=found, turns=_turns(found), other=assembly)


def _assembled(layout: Layout, effects: Effects, nodes: int) -> Assembly:
    found = meshes(layout, effects, nodes)
    names = {body.name: i for i, body in enumerate(layout.bodies)}
    ground, blades = len(names), len(layout.blades)
    first = np.array([names.get(blade.first, ground) for blade in layout.blades])
    second = np.array([names.get(blade.second, ground) for blade in layout.blades])
    length = sum(m.l.sum(axis=1) for m in found) / blades
    force = sum((m.EI / m.l).sum(axis=1) for m in found) / blades / length
    starts = drawn([blade.start for blade in layout.blades])
    ends = drawn([blade.end for blade in layout.blades])
    points = drawn([*(body.point for body in layout.bodies), (0.0, 0.0)])
    arms = starts - points[:, first], ends - points[:, second], ends - starts
    places, weights = [], []
    for mesh in found:
        index = list(mesh.blades)
        start, end, along = (np.asarray(arm[:, index] / mesh.l, complex) for arm in arms)
        scale = length[:, None] / mesh.l
        places.append(_attached(start, end, along, scale, layout, mesh))
        weights.append(mesh.EI / mesh.l / (force * length)[:, None])
    return Assembly(
        layout=layout,
        effects=effects,
        nodes=nodes,
        meshes=found,
        places=tuple(places),
        weights=tuple(weights),
        first=first,
        second=second,
        length=length,
        force=force,
        turns=_turns(found),
        designs=_designs([length, force, *weights, *(values for at in places for values in at)]),
        slenderness=min(float(np.min(mesh.thinnest / mesh.l)) for mesh in found),
    )


def _designs(arrays: Sequence[NDArray[Any]]) -> int:
    return max(len(values) for values in arrays)


def _turns(found: Sequence[Mesh]) -> int:
    return sum(mesh.nodes * len(mesh.blades) for mesh in found)


def _bound(
    mesh: Mesh, place: Attachment, weight: Floats, first: Integers, second: Integers, bodies: int
) -> Bound:
    """Return the blades of a mesh between their bodies."""
    index, three, k_f = np.array(mesh.blades), np.arange(3), 3 * first.size
    sides = np.concatenate([first[index], second[index]])
    starts = [3 * index, k_f + 3 * first[index], k_f + 3 * second[index]]
    return Bound(
        blades=slice(None) if index.size == first.size else index,
        first=first[index],
        second=second[index],
        slots=np.concatenate([start[:, None] + three for start in starts], axis=1),
        on=(np.arange(bodies)[:, None] == sides).astype(np.float64),
        sections=Sections.of(mesh),
        ends=Ends.of(place, weight),
    )


def _attached(
    start: Complexes, end: Complexes, along: Complexes, scale: Floats, layout: Layout, mesh: Mesh
) -> Attachment:
    """Return where blades sit, with bodies and blades grown by a temperature."""
    if not layout.body_growth and not layout.blade_growth:
        return Attachment(start, end, along, scale, np.ones((1, 1)), np.zeros((1, 1), complex))
    blades = [layout.blades[b] for b in mesh.blades]
    growth = [
        [layout.body_growth.get(blade.first, 0.0) for blade in blades],
        [layout.body_growth.get(blade.second, 0.0) for blade in blades],
        [layout.blade_growth.get(blade.name, 0.0) for blade in blades],
    ]
    first, second, own = (
        np.stack(np.broadcast_arrays(*map(column, each)), axis=1) for each in growth
    )
    return Attachment(
        start=start * (1.0 + first),
        end=end * (1.0 + second),
        along=along,
        scale=scale,
        reach=1.0 + own,
        misfit=end * second - start * first - along * own,
    )


def finer(coarse: Assembly, fine: Assembly, x: Floats) -> Floats:
    """Return the unknowns of a coarse assembly interpolated to the nodes of a finer one."""
    found = np.zeros((x.shape[0], fine.size))
    if not x.any():
        return found
    matrix = refining_matrix(coarse.nodes, fine.nodes).T
    found[:, fine.turns :] = x[:, coarse.turns :]
    rotations, to = coarse.split(x)[0], fine.split(found)[0]
    for mesh, finer_mesh, psi, into in zip(coarse.meshes, fine.meshes, rotations, to, strict=True):
        pieces = zip(mesh.segments[0], finer_mesh.segments[0], strict=True)
        for (piece, first, count), (_, start, more) in pieces:
            here = psi[..., first : first + count]
            into[..., start : start + more] = here if piece is None else here @ matrix
    return found
