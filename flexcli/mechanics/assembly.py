"""A layout as equations for Newton's method: blades closed between bodies, bodies in equilibrium.

One row of unknowns per design: rotations at the nodes of all blades, then force and end moment of
each blade (scaled by the blade), then (x, y, φ) of each body (lengths in a unit of the design).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.beam import Condensed, condense
from flexcli.mechanics.demand import Demand
from flexcli.mechanics.element import Attachment, element
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.mesh import Effects, Mesh, column, meshes, pick, refined
from flexcli.mechanics.outer_forces import apply_force, apply_spring
from flexcli.numerics.collocation import gauss_nodes, interpolation_matrix
from flexcli.numerics.stack import solve_stack

__all__ = ["FORCE", "Assembly", "Linearised", "assemble", "at_nodes", "finer"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Integers = NDArray[np.intp]


class Linearised(NamedTuple):
    """The equations of the designs about a state, rotations at the nodes eliminated.

    ``residual`` and the symmetric ``matrix`` are of forces and ends of the blades, then of the
    bodies; ``row_scale`` brings each row to order one before it is solved. ``frames`` and ``local``
    are directions and forces of the blades of each mesh in the frames of their starts.
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
        return _in_frame(self.frame(motions, k, rows), forces[:, list(self.meshes[k].blades)])

    def frame(self, motions: Floats, k: int, rows: Integers) -> Complexes:
        """Return the directions of the blades of mesh k, turned with the bodies at their starts."""
        phi = self.poses(motions)[:, self.first[list(self.meshes[k].blades)], 2]
        return np.asarray(pick(self.places[k].along, rows) * np.exp(1j * phi))

    def poses(self, motions: Floats) -> Floats:
        """Return the motions with the ground's behind."""
        return np.concatenate([motions, np.zeros_like(motions[:, :1])], axis=1)

    def linearise(self, x: Floats, share: Floats, rows: Integers, demand: Demand) -> Linearised:
        """Return the equations of the designs ``rows`` about x at the share λ of the way."""
        rotations, forces, motions = self.split(x)
        designs, k_f = x.shape[0], 3 * self.blades
        total = k_f + 3 * self.bodies + 3
        residual = np.zeros((designs, total))
        matrix = np.zeros((designs, total, total))
        scale = np.ones((designs, total))
        poses = self.poses(motions)
        condensed, frames, local = [], [], []
        for k, mesh in enumerate(self.meshes):
            index = list(mesh.blades)
            frames.append(self.frame(motions, k, rows))
            local.append(_in_frame(frames[k], forces[:, index]))
            blade = condense(mesh, rows, rotations[k], local[k])
            condensed.append(blade)
            place = self.places[k].of(rows)
            place = place._replace(misfit=demand.warmth(share)[:, None] * place.misfit)
            i, j = self.first[index], self.second[index]
            gradient, H = element(place, blade, forces[:, index], poses[:, i], poses[:, j])
            weight = np.broadcast_to(pick(self.weights[k], rows), gradient.shape[:2])
            gradient *= weight[..., None]
            H *= weight[..., None, None]
            for a, slot in enumerate(self.slots[k]):
                residual[:, slot] += gradient[:, a]
                matrix[:, slot[:, None], slot] += H[:, a]
                scale[:, slot[:3]] = 1.0 / weight[:, a, None]
        body_r, body_m = residual[:, k_f:-3], matrix[:, k_f:-3, k_f:-3]
        for force in demand.forces:
            before, after = pick(force.before, rows), pick(force.after, rows)
            size = before + share * (after - before)
            apply_force(force, motions, size, rows, body_r, body_m)
        for spring in demand.springs:
            apply_spring(spring, motions, rows, body_r, body_m)
        return Linearised(
            residual=residual[:, :-3],
            matrix=matrix[:, :-3, :-3],
            row_scale=scale[:, :-3],
            blades=tuple(condensed),
            frames=tuple(frames),
            local=tuple(local),
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
        change = np.zeros_like(right)
        held, free = k_f + demand.held, np.concatenate([np.arange(k_f), k_f + demand.free])
        change[:, held] = drive
        load = right - np.einsum("nij,nj->ni", at.matrix[:, :, held], drive)
        scale = at.row_scale[:, free]
        square = at.matrix[:, free[:, None], free] * scale[..., None]
        change[:, free] = solve_stack(square, (load[:, free] * scale)[..., None])[..., 0]
        # the blades' forces follow the bodies in their own frames, the rotations follow the forces
        follow = [self._follow(at, change, k) for k in range(len(self.meshes))]
        return np.concatenate([*follow, change], axis=1)

    def _follow(self, at: Linearised, change: Floats, k: int) -> Floats:
        """Return the change of the rotations of mesh k."""
        index, k_f = list(self.meshes[k].blades), 3 * self.blades
        d_forces = change[:, :k_f].reshape(-1, self.blades, 3)
        d_motions = change[:, k_f:].reshape(-1, self.bodies, 3)
        q, blade = at.local[k], at.blades[k]
        dq = _in_frame(at.frames[k], d_forces[:, index])
        d_phi = self.poses(d_motions)[:, self.first[index], 2]
        dq[..., 0] += q[..., 1] * d_phi
        dq[..., 1] -= q[..., 0] * d_phi
        d_psi = blade.free + np.sum(blade.follow * dq[..., None, :], axis=-1)
        return np.asarray(d_psi.reshape(change.shape[0], -1))

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
        rows = []
        for b in mesh.blades:
            blade = layout.blades[b]
            s_x, s_y, e_x, e_y = map(column, (*blade.start, *blade.end))
            o_x, o_y = map(column, points[first[b]])
            t_x, t_y = map(column, points[second[b]])
            l = np.hypot(e_x - s_x, e_y - s_y)
            values = (s_x - o_x, s_y - o_y, e_x - t_x, e_y - t_y, e_x - s_x, e_y - s_y)
            rows.append(np.stack(np.broadcast_arrays(*values), axis=-1) / l[:, None])
        table = np.stack(np.broadcast_arrays(*rows), axis=1)
        scale = length[:, None] / mesh.l
        arms = table[..., ::2] + 1j * table[..., 1::2]
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
    """Return forces and end moments with the forces resolved along and across the direction."""
    turned = np.conj(along) * (force[..., 0] + 1j * force[..., 1])
    return np.stack([turned.real, turned.imag, force[..., 2]], axis=-1)


def finer(coarse: Assembly, fine: Assembly, x: Floats) -> Floats:
    """Return the unknowns of a coarse assembly interpolated to the nodes of a finer one."""
    rotations, _, _ = coarse.split(x)
    matrix = interpolation_matrix(coarse.nodes, gauss_nodes(fine.nodes)[0])
    columns = []
    for mesh, psi in zip(coarse.meshes, rotations, strict=True):
        parts = []
        for piece, first, count in mesh.segments[0]:
            here = psi[..., first : first + count]
            parts.append(here if piece is None else here @ matrix.T)
        columns.append(np.concatenate(parts, axis=-1).reshape(x.shape[0], -1))
    return np.concatenate([*columns, x[:, coarse.turns :]], axis=1)
