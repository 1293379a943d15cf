"""A layout as equations for Newton's method: blades closed between bodies, bodies in equilibrium.

One row of unknowns per design: rotations at the nodes of all blades, then force and end moment of
each blade (scaled by the blade), then (x, y, φ) of each body (lengths in a unit of the design).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.beam import Condensed, condense
from flexcli.mechanics.demand import Demand
from flexcli.mechanics.element import Attachment, element, turning
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.mesh import Effects, Mesh, across, column, meshes, pick, refined
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
    bodies; ``row_scale`` brings each row to order one before it is solved. ``frames`` and ``local``
    are directions and forces of the blades of each mesh in the frames of their starts, the designs
    their last axis.
    """

    residual: Floats
    matrix: Floats
    row_scale: Floats
    blades: tuple[Condensed, ...]
    frames: tuple[Complexes, ...]
    local: tuple[Floats, ...]


class Assembly(NamedTuple):
    """A layout ready to be solved; ``length`` [m] and ``force`` [N] are the units of each design.

    ``first`` and ``second`` are the bodies of each blade, the ground being the last, which never
    moves; ``weights`` are the energy units of blades over that of the design, ``slots`` the
    rows that the 9 rows of a blade's element go to.
    """

    layout: Layout
    effects: Effects
    nodes: int
    meshes: tuple[Mesh, ...]
    places: tuple[Attachment, ...]
    weights: tuple[Floats, ...]
    first: Integers
    second: Integers
    slots: tuple[Integers, ...]
    length: Floats
    force: Floats

    @property
    def bodies(self) -> int:
        """Return the number of bodies that may move."""
        return len(self.layout.bodies)

    @property
    def blades(self) -> int:
        """Return the number of blades."""
        return len(self.layout.blades)

    @property
    def turns(self) -> int:
        """Return the number of rotations at nodes in a row of unknowns."""
        return sum(mesh.nodes * len(mesh.blades) for mesh in self.meshes)

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

    def local_forces(self, forces: Floats, motions: Floats, k: int, rows: Integers) -> Floats:
        """Return the forces of the blades of mesh k in the frames of their starts."""
        index = list(self.meshes[k].blades)
        phi = self.poses(motions.transpose(1, 2, 0))[self.first[index], 2]
        frame = across(self.places[k].along, rows) * (1.0 + turning(phi))
        return _in_frame(frame, forces[:, index].transpose(1, 2, 0)).transpose(2, 0, 1)

    def poses(self, motions: Floats) -> Floats:
        """Return motions (bodies, 3, designs) with the ground's behind."""
        return np.concatenate([motions, np.zeros((1, *motions.shape[1:]))])

    def linearise(self, x: Floats, share: Floats, rows: Integers, demand: Demand) -> Linearised:
        """Return the equations of the designs ``rows`` about x at the share λ of the way."""
        designs, k_f = x.shape[0], 3 * self.blades
        total = k_f + 3 * self.bodies + 3
        # designs last: what loops over them runs through memory
        rotations, forces, motions = self._across(np.ascontiguousarray(x.T))
        residual = np.zeros((total, designs))
        matrix = np.zeros((total, total, designs))
        scale = np.ones((total, designs))
        poses = self.poses(motions)
        turns = turning(poses[:, 2])
        condensed, frames, local = [], [], []
        for k, mesh in enumerate(self.meshes):
            index, slots = list(mesh.blades), self.slots[k]
            i, j = self.first[index], self.second[index]
            place = self.places[k].across(rows)
            place = place._replace(misfit=demand.warmth(share) * place.misfit)
            frames.append(place.along * (1.0 + turns[i]))
            local.append(_in_frame(frames[k], forces[index]))
            blade = condense(mesh, rows, rotations[k], local[k])
            condensed.append(blade)
            found = element(place, blade, forces[index], poses[j] - poses[i], turns[i], turns[j])
            weight = across(self.weights[k], rows)
            closing = found.closing * weight[:, None, None]
            matrix[slots[:, :3, None], slots[:, None]] = closing
            matrix[slots[:, None, 3:], slots[:, :3, None]] = closing[:, :, 3:]
            scale[slots[:, :3]] = 1.0 / weight[:, None]
            gradient = found.gradient * weight[:, None]
            turned_i, turned_j = found.turned_i * weight, found.turned_j * weight
            for a, slot in enumerate(slots):
                residual[slot] += gradient[a]
                matrix[slot[5], slot[5]] += turned_i[a]
                matrix[slot[8], slot[8]] += turned_j[a]
        residual, matrix = residual[:-3].T, matrix[:-3, :-3].transpose(2, 0, 1)
        motions = motions.transpose(2, 0, 1)
        for force in demand.forces:
            before, after = pick(force.before, rows), pick(force.after, rows)
            size = before + share * (after - before)
            apply_force(force, motions, size, rows, residual[:, k_f:], matrix[:, k_f:, k_f:])
        for spring in demand.springs:
            apply_spring(spring, motions, rows, residual[:, k_f:], matrix[:, k_f:, k_f:])
        return Linearised(
            residual=residual,
            matrix=matrix,
            row_scale=scale[:-3].T,
            blades=tuple(condensed),
            frames=tuple(frames),
            local=tuple(local),
        )

    def _across(self, x: Floats) -> tuple[list[Floats], Floats, Floats]:
        """Return rotations of each mesh, blade forces and body motions (…, 3, designs)."""
        first, rotations = 0, []
        for mesh in self.meshes:
            last = first + mesh.nodes * len(mesh.blades)
            rotations.append(x[first:last].reshape(len(mesh.blades), mesh.nodes, -1))
            first = last
        last = first + 3 * self.blades
        forces, motions = x[first:last], x[last:]
        return (
            rotations,
            forces.reshape(self.blades, 3, -1),
            motions.reshape(self.bodies, 3, -1),
        )

    def step(self, x: Floats, share: Floats, rows: Integers, demand: Demand) -> Floats:
        """Return Newton's steps; the held coordinates go where they shall be."""
        at = self.linearise(x, share, rows, demand)
        return self._answer(at, -at.residual, self._astray(x, share, rows, demand), demand)

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
        there = before + share[:, None] * (after - before)
        return np.asarray(there - x[:, self.turns + 3 * self.blades + demand.held])

    def _answer(
        self,
        at: Linearised,
        right: Floats,
        drive: Floats,
        demand: Demand,
    ) -> Floats:
        """Return the change of all unknowns for right-hand sides and motions of the held."""
        k_f = 3 * self.blades
        matrix, scale = at.matrix.transpose(1, 2, 0), at.row_scale.T
        change = np.zeros(right.T.shape)
        held, free = k_f + demand.held, np.concatenate([np.arange(k_f), k_f + demand.free])
        change[held] = drive.T
        load = right.T - np.einsum("ijn,jn->in", matrix[:, held], drive.T)
        square = matrix[free[:, None], free] * scale[free][:, None]
        found = solve_stack(square.transpose(2, 0, 1), (load[free] * scale[free]).T[..., None])
        change[free] = found[..., 0].T
        # the blades' forces follow the bodies in their own frames, the rotations follow the forces
        follow = [self._follow(at, change, k) for k in range(len(self.meshes))]
        return np.concatenate([*follow, change]).T

    def _follow(self, at: Linearised, change: Floats, k: int) -> Floats:
        """Return the change of the rotations of mesh k, (rotations, designs)."""
        index, k_f = list(self.meshes[k].blades), 3 * self.blades
        d_forces = change[:k_f].reshape(self.blades, 3, -1)
        d_motions = change[k_f:].reshape(self.bodies, 3, -1)
        q, blade = at.local[k], at.blades[k]
        dq = _in_frame(at.frames[k], d_forces[index])
        d_phi = self.poses(d_motions)[self.first[index], 2]
        dq[:, 0] += q[:, 1] * d_phi
        dq[:, 1] -= q[:, 0] * d_phi
        d_psi = blade.free + np.einsum("bkjn,bjn->bkn", blade.follow, dq)
        return np.asarray(d_psi.reshape(-1, change.shape[1]))

    def length_of(self, x: Floats, step: Floats) -> Floats:
        """Return the length of a step: rotations, motions, and forces over those they add to."""
        k_f = slice(self.turns, self.turns + 3 * self.blades)
        forces = np.max(np.abs(x[:, k_f]), axis=1, initial=0.0)
        size = np.abs(step)
        size[:, k_f] /= (FORCE + forces)[:, None]
        return np.asarray(np.max(size, axis=1))


FORCE = 10.0
"""Scaled force [EI/l²] that counts as one in the length of a step: that of an Euler column."""


def assemble(layout: Layout, effects: Effects, nodes: int) -> Assembly:
    """Return the layout at ``nodes`` Gauss nodes on each piece of each blade."""
    found = meshes(layout, effects, nodes)
    names = {body.name: i for i, body in enumerate(layout.bodies)}
    ground = len(names)
    first = np.array([names.get(blade.first, ground) for blade in layout.blades])
    second = np.array([names.get(blade.second, ground) for blade in layout.blades])
    length = sum(m.l.sum(axis=1) for m in found) / len(layout.blades)
    force = sum((m.EI / m.l).sum(axis=1) for m in found) / len(layout.blades) / length
    points = [body.point for body in layout.bodies] + [(0.0, 0.0)]
    k_f, three = 3 * len(layout.blades), np.arange(3)
    slots = tuple(
        np.array(
            [
                [*three + 3 * b, *three + k_f + 3 * first[b], *three + k_f + 3 * second[b]]
                for b in mesh.blades
            ]
        )
        for mesh in found
    )
    places, weights = [], []
    for mesh in found:
        rows: list[Complexes] = []
        for b in mesh.blades:
            blade = layout.blades[b]
            start, end, origin, to = (
                column(x) + 1j * column(y)
                for x, y in (blade.start, blade.end, points[first[b]], points[second[b]])
            )
            rows += [start - origin, end - to, end - start]
        arms = np.stack(np.broadcast_arrays(*rows)).T.reshape(-1, len(mesh.blades), 3)
        arms /= mesh.l[..., None]
        scale = length[:, None] / mesh.l
        places.append(_attached(arms, scale, layout, mesh))
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
        slots=slots,
        length=length,
        force=force,
    )


def _attached(arms: Complexes, scale: Floats, layout: Layout, mesh: Mesh) -> Attachment:
    """Return where blades sit, with bodies and blades grown by a temperature."""
    start, end, along = arms[..., 0], arms[..., 1], arms[..., 2]
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


def at_nodes(assembly: Assembly, nodes: int) -> Assembly:
    """Return the same layout at another number of Gauss nodes on each piece."""
    layout, effects = assembly.layout, assembly.effects
    found = tuple(refined(mesh, layout, effects, nodes) for mesh in assembly.meshes)
    return assembly._replace(nodes=nodes, meshes=found)


def _in_frame(along: Complexes, force: Floats) -> Floats:
    """Return forces and end moments with the forces resolved along and across the direction.

    ``along`` is (blades, designs), ``force`` (blades, 3, designs).
    """
    turned, found = np.conj(along) * (force[:, 0] + 1j * force[:, 1]), force.copy()
    found[:, 0], found[:, 1] = turned.real, turned.imag
    return found


def finer(coarse: Assembly, fine: Assembly, x: Floats) -> Floats:
    """Return the unknowns of a coarse assembly interpolated to the nodes of a finer one."""
    rotations, _, _ = coarse.split(x)
    matrix = refining_matrix(coarse.nodes, fine.nodes)
    columns = []
    for mesh, psi in zip(coarse.meshes, rotations, strict=True):
        parts = []
        for piece, first, count in mesh.segments[0]:
            here = psi[..., first : first + count]
            parts.append(here if piece is None else here @ matrix.T)
        columns.append(np.concatenate(parts, axis=-1).reshape(x.shape[0], -1))
    return np.concatenate([*columns, x[:, coarse.turns :]], axis=1)
