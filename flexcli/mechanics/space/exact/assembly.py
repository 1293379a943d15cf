"""A layout in space as equations for Newton's method: blades closed, bodies in equilibrium.

One row of unknowns: what is inside the blades, force and end moment of each blade (along the axes
of the drawing, scaled by the blade), shift and quaternion of each body.
"""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.exact.demand import Demand, Frame
from flexcli.mechanics.space.exact.members import EndMotions, Members, MembersOf
from flexcli.mechanics.space.exact.outer_forces import apply_force, apply_spring
from flexcli.mechanics.space.exact.rotation import (
    conjugate,
    cross,
    matrix_of,
    moved,
    product,
    quaternion_of,
    skew,
    spin_slope,
    spin_tangent,
    spun,
    vector_of,
)
from flexcli.mechanics.space.layout import BeamEffects, SpaceLayout, seats_grown
from flexcli.numerics.stack import solve_stack

__all__ = ["UNTURNED", "Assembly", "Linearised", "Unknowns", "assemble", "at_nodes", "finer"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

UNTURNED = np.array([1.0, 0.0, 0.0, 0.0])
"""Quaternion of no rotation."""

_FORCE = 10.0
"""Scaled force [EI/l²] that counts as one in the length of a step: that of an Euler column."""


class Unknowns(NamedTuple):
    """Inside of blades (…,), blade forces (blades, 6), shifts (bodies, 3), quaternions (…, 4)."""

    inside: Floats
    forces: Floats
    shift: Floats
    turn: Floats


class Linearised(NamedTuple):
    """The equations about a state: of forces and ends of blades, then of bodies.

    The bodies' unknowns are changes of their coordinates. ``row_scale`` brings each row to order
    one; ``basis`` (bodies, 6, 6) takes coordinates to shift and spin, ``axes`` (blades, 3, 3) are
    those of the blades at their starts (rows), ``blades`` what they became.
    """

    residual: Floats
    matrix: Floats
    row_scale: Floats
    basis: Floats
    axes: Floats
    blades: EndMotions


class Assembly(NamedTuple):
    """A layout ready to be solved; ``length`` [m] and ``force`` [N] are its units.

    ``inside`` is the number of unknowns inside the blades, ``points`` (bodies + 1, 3) and
    ``frames`` (bodies + 1, 3, 3) are those of the bodies, the last being the ground; ``first`` and
    ``second`` the bodies of each blade, ``start`` and ``end`` the ends from their points in
    lengths of the blade, ``axes`` those of the blades at rest, ``scale`` the length over the
    blade's, ``weight`` its unit of energy over that of the whole. ``growth`` (blades, 7) is how far
    a temperature moves the seats of both ends, and strains the blade; ``turned`` (blades, 4) is
    how far the seats of the ends are turned on their bodies, where one is.
    """

    layout: SpaceLayout
    effects: BeamEffects
    members: Members
    inside: int
    points: Floats
    frames: Floats
    first: Integers
    second: Integers
    start: Floats
    end: Floats
    axes: Floats
    scale: Floats
    weight: Floats
    growth: Floats
    length: float
    force: float
    turned: Floats | None = None

    def on_the_way(self, demand: Demand, share: float) -> "Assembly":
        """Return it with its blades and the seats of their ends as they are at the share λ.

        They have grown by a share of the growth; the seat that is missed is off.
        """
        found = self
        if self.growth.any():
            growth = demand.warmth(share) * self.growth
            start, end, own = np.split(growth, (3, 6), axis=1)
            found = found._replace(
                members=self.members.grown(own), start=self.start + start, end=self.end + end
            )
        missed = demand.off(share)
        if missed is None:
            return found
        end, turned = found.end.copy(), np.tile(UNTURNED, (self.blades, 1))
        end[missed.blade] += missed.offset[:3] / self.members.lengths[missed.blade]
        turned[missed.blade] = quaternion_of(missed.offset[3:])
        return found._replace(end=end, turned=turned)

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
        """Return the number of unknowns."""
        return self.inside + 6 * self.blades + 7 * self.bodies

    def rest(self) -> Floats:
        """Return the unknowns of the pose in which nothing is strained."""
        at_rest = self.members.rest()
        x = np.concatenate([at_rest, np.zeros(6 * self.blades + 7 * self.bodies)])
        self.split(x).turn[:, 0] = 1.0
        return x

    def at(self, x: Floats) -> Unknowns:
        """Return one row of unknowns with all rotations of unit length."""
        found = self.split(x)
        length = np.sqrt(np.sum(found.turn**2, axis=-1, keepdims=True))
        return found._replace(inside=self.members.unit(found.inside), turn=found.turn / length)

    def split(self, x: Floats) -> Unknowns:
        """Return views of one row of unknowns."""
        forces = self.inside + 6 * self.blades
        shifts = forces + 3 * self.bodies
        return Unknowns(
            x[: self.inside],
            x[self.inside : forces].reshape(-1, 6),
            x[forces:shifts].reshape(-1, 3),
            x[shifts:].reshape(-1, 4),
        )

    def coordinates(self, x: Floats) -> Floats:
        """Return shift and rotation vector of the bodies along their axes (6 bodies,)."""
        at, axes = self.split(x), self.frames[:-1]
        shift = (axes @ at.shift[..., None])[..., 0]
        turn = (axes @ vector_of(at.turn)[..., None])[..., 0]
        return np.concatenate([shift, turn], axis=-1).ravel()

    def linearise(self, x: Floats, share: float, demand: Demand) -> Linearised:
        """Return the equations about x at the share λ of the way."""
        at = self.at(x)
        B, nb = self.blades, self.bodies
        shift = np.concatenate([at.shift, np.zeros((1, 3))])
        turn = np.concatenate([at.turn, [[1.0, 0.0, 0.0, 0.0]]])
        q_i, q_j = turn[self.first], turn[self.second]
        # rows of the blades' axes, turned with the bodies at their starts
        S = self.axes @ np.swapaxes(matrix_of(q_i), -1, -2)
        S_t = np.swapaxes(S, -1, -2)
        n, m = at.forces[:, :3], at.forces[:, 3:]
        local = np.concatenate([_times(S, n), _times(S, m)], axis=-1)
        here = self.on_the_way(demand, share)
        blade = here.members.condense(at.inside, local)
        F = np.zeros((B, 6, 6))
        for a in (slice(0, 3), slice(3, 6)):
            for b in (slice(0, 3), slice(3, 6)):
                F[:, a, b] = S_t @ blade.F[:, a, b] @ S
        # a turn of the start turns the forces in its frame by −θ × (n, m)
        by_turn = F @ np.concatenate([skew(n), skew(m)], axis=1)
        bent = _times(S_t, blade.motion)
        straight = moved(q_i, self.axes[:, 0])
        a_i, a_j = here.start + moved(q_i, here.start), here.end + moved(q_j, here.end)
        lever = a_i + self.axes[:, 0] + straight + bent
        gap = self.scale[:, None] * (shift[self.second] - shift[self.first])
        gap += a_j - self.end - (a_i - self.start) - straight - bent
        vector = _times(np.swapaxes(self.axes, -1, -2), blade.turn[:, 1:])
        there = product(q_i, np.concatenate([blade.turn[:, :1], vector], axis=-1))
        seat = q_j if here.turned is None else product(q_j, here.turned)
        apart = product(seat, conjugate(there))
        apart = np.where(apart[:, :1] < 0.0, -apart, apart)
        w, V = apart[:, :1, None] * np.eye(3), skew(apart[:, 1:])
        near, far = w - V, w + V
        N, scale = skew(n), self.scale[:, None, None] * np.eye(3)
        H = np.zeros((B, 18, 18))
        H[:, 0:3, 0:6] = -F[:, :3]
        H[:, 3:6, 0:6] = -far @ F[:, 3:]
        H[:, 0:3, 6:9], H[:, 0:3, 12:15] = -scale, scale
        H[:, 0:3, 9:12] = skew(lever) - by_turn[:, :3]
        H[:, 0:3, 15:18] = -skew(a_j)
        H[:, 3:6, 9:12] = -far @ (np.eye(3) + by_turn[:, 3:])
        H[:, 3:6, 15:18] = near
        # the body at the start bears −n, −m − lever × n; that at the end n, m + a_j × n
        H[:, 6:9, 0:3], H[:, 12:15, 0:3] = -scale, scale
        H[:, 9:12, 0:6] = N @ F[:, :3]
        H[:, 9:12, 0:3] -= skew(lever)
        H[:, 9:12, 3:6] -= np.eye(3)
        H[:, 9:12, 9:12] = N @ (by_turn[:, :3] - skew(lever))
        H[:, 15:18, 0:3], H[:, 15:18, 3:6] = skew(a_j), np.eye(3)
        H[:, 15:18, 15:18] = N @ skew(a_j)
        gradient = np.concatenate(
            [
                gap,
                2.0 * apart[:, 1:],
                -self.scale[:, None] * n,
                -m - cross(lever, n),
                self.scale[:, None] * n,
                m + cross(a_j, n),
            ],
            axis=-1,
        )
        k_f = 6 * B
        total = k_f + 6 * nb + 6
        residual, matrix = np.zeros(total), np.zeros((total, total))
        row_scale = np.ones(total)
        for i in range(B):
            slot = np.concatenate(
                [
                    np.arange(6) + 6 * i,
                    np.arange(6) + k_f + 6 * self.first[i],
                    np.arange(6) + k_f + 6 * self.second[i],
                ]
            )
            residual[slot] += self.weight[i] * gradient[i]
            matrix[slot[:, None], slot] += self.weight[i] * H[i]
            row_scale[slot[:6]] = 1.0 / self.weight[i]
        body_r, body_m = residual[k_f:-6], matrix[k_f:-6, k_f:-6]
        for force in demand.forces:
            apply_force(force, at.turn, force.size(share), body_r, body_m)
        for spring in demand.springs:
            apply_spring(spring, at.shift, at.turn, body_r, body_m)
        basis = self.basis(x, demand)
        residual, matrix = residual[:-6], matrix[:-6, :-6]
        for i in range(nb):
            own = slice(k_f + 6 * i, k_f + 6 * i + 6)
            matrix[:, own] = matrix[:, own] @ basis[i]
            matrix[own] = basis[i].T @ matrix[own]
            matrix[own, own] += self.coordinate_stiffness(i, at.turn[i], residual[own], demand)
            residual[own] = basis[i].T @ residual[own]
        return Linearised(residual, matrix, row_scale[:-6], basis, S, blade)

    def basis(self, x: Floats, demand: Demand) -> Floats:
        """Return the matrices (bodies, 6, 6) that take coordinates to shift and spin."""
        basis = np.zeros((self.bodies, 6, 6))
        back = np.swapaxes(self.frames[:-1], -1, -2)
        basis[:, :3, :3] = back
        T = spin_tangent(vector_of(self.split(x).turn))
        basis[:, 3:, 3:] = np.where(demand.turned[:, None, None], T, np.eye(3)) @ back
        return basis

    def coordinate_stiffness(self, body: int, turn: Floats, load: Floats, demand: Demand) -> Floats:
        """Return what a load on a body adds where its coordinates are a rotation vector (6, 6)."""
        K = np.zeros((6, 6))
        if demand.turned[body]:
            E = self.frames[body]
            K[3:, 3:] = E @ spin_slope(vector_of(turn), load[3:]) @ E.T
        return K

    def step(self, x: Floats, share: float, demand: Demand) -> Floats:
        """Return Newton's step; the held coordinates go where they shall be."""
        at = self.linearise(x, share, demand)
        there = demand.before + share * (demand.after - demand.before)
        drive = there - self.coordinates(x)[demand.held]
        return self._change(x, at, -at.residual, drive, demand, settled=False)

    def steps(self, x: Floats, share: float, demand: Demand) -> tuple[Floats, Floats]:
        """Return Newton's step at constant share λ, and dx/dλ of the path."""
        at = self.linearise(x, share, demand)
        there = demand.before + share * (demand.after - demand.before)
        drive = there - self.coordinates(x)[demand.held]
        step = self._change(x, at, -at.residual, drive, demand, settled=False)
        k_f = 6 * self.blades
        pushed, unused = np.zeros(6 * self.bodies), np.zeros((6 * self.bodies,) * 2)
        for force in demand.forces:
            apply_force(force, self.at(x).turn, force.after - force.before, pushed, unused)
        right = np.zeros_like(at.residual)
        for i in range(self.bodies):
            right[k_f + 6 * i : k_f + 6 * i + 6] = -at.basis[i].T @ pushed[6 * i : 6 * i + 6]
        if (self.growth.any() or demand.missed is not None) and not demand.grown:
            still = demand._replace(forces=())
            right += self.linearise(x, 0.0, still).residual - self.linearise(x, 1.0, still).residual
        rate = self._change(x, at, right, demand.after - demand.before, demand, settled=True)
        return step, rate

    def _change(
        self,
        x: Floats,
        at: Linearised,
        right: Floats,
        drive: Floats,
        demand: Demand,
        *,
        settled: bool,
    ) -> Floats:
        """Return the change of all unknowns for right-hand sides and motions of the held."""
        k_f = 6 * self.blades
        change = np.zeros_like(right)
        held, free = k_f + demand.held, np.concatenate([np.arange(k_f), k_f + demand.free])
        change[held] = drive
        load = right - at.matrix[:, held] @ drive
        scale = at.row_scale[free]
        square = at.matrix[free[:, None], free] * scale[:, None]
        change[free] = solve_stack(square, (load[free] * scale)[:, None])[:, 0]
        here, was = self.at(x), self.split(x)
        body = (at.basis @ change[k_f:].reshape(-1, 6, 1))[..., 0]
        d_turn = spun(here.turn, body[:, 3:])
        forces = change[:k_f].reshape(-1, 6)
        theta = np.concatenate([body[:, 3:], np.zeros((1, 3))])[self.first]
        n, m = here.forces[:, :3], here.forces[:, 3:]
        local = np.concatenate(
            [
                _times(at.axes, forces[:, :3] - cross(theta, n)),
                _times(at.axes, forces[:, 3:] - cross(theta, m)),
            ],
            axis=-1,
        )
        inside = at.blades.follow(local)
        if not settled:
            # and back to unit length
            inside += at.blades.free + here.inside - was.inside
            d_turn += here.turn - was.turn
        return np.concatenate([inside, forces.ravel(), body[:, :3].ravel(), d_turn.ravel()])

    def length_of(self, x: Floats, step: Floats) -> Floats:
        """Return the length of steps: rotations, motions, forces over those they add to."""
        k_f = slice(self.inside, self.inside + 6 * self.blades)
        forces = np.max(np.abs(x[:, k_f]), axis=1, initial=0.0)
        size = np.abs(step)
        size[:, k_f] /= (_FORCE + forces)[:, None]
        return np.asarray(np.max(size, axis=1))


def _times(A: Floats, x: Floats) -> Floats:
    """Return the products of matrices and vectors of all blades."""
    return np.asarray((A @ x[..., None])[..., 0])


def assemble(
    layout: SpaceLayout,
    effects: BeamEffects,
    level: int,
    frames: Mapping[str, Frame],
    made: MembersOf,
) -> Assembly:
    """Return the layout with its blades made at a level.

    ``frames`` are the points and axes by which the motion of some bodies is stated; that of the
    others is stated at their own points, along the axes of the drawing.
    """
    members = made(layout, effects, level)
    names = {body.name: i for i, body in enumerate(layout.bodies)}
    ground = len(names)
    own = [frames.get(body.name, Frame(body.point, np.eye(3))) for body in layout.bodies]
    points = np.array([*(frame.point for frame in own), (0.0, 0.0, 0.0)], dtype=np.float64)
    first = np.array([names.get(blade.first, ground) for blade in layout.blades])
    second = np.array([names.get(blade.second, ground) for blade in layout.blades])
    l, EI = members.lengths, members.bending
    length = float(np.mean(l))
    force = float(np.mean(EI / l)) / length
    starts, ends = (np.array([getattr(b, e) for b in layout.blades]) for e in ("start", "end"))
    return Assembly(
        layout=layout,
        effects=effects,
        members=members,
        inside=members.rest().size,
        points=points / length,
        frames=np.array([*(frame.axes for frame in own), np.eye(3)], dtype=np.float64),
        first=first,
        second=second,
        start=(starts - points[first]) / l[:, None],
        end=(ends - points[second]) / l[:, None],
        axes=np.array([blade.axes for blade in layout.blades]),
        scale=length / l,
        weight=EI / l / (force * length),
        growth=np.array(
            [
                [*seats_grown(layout, blade) / own_length, layout.blade_growth.get(blade.name, 0.0)]
                for blade, own_length in zip(layout.blades, l, strict=True)
            ]
        ),
        length=length,
        force=force,
    )


def at_nodes(assembly: Assembly, level: int) -> Assembly:
    """Return the same layout with its blades at another level."""
    members = assembly.members.at_level(level)
    return assembly._replace(members=members, inside=members.rest().size)


def finer(coarse: Assembly, fine: Assembly, x: Floats) -> Floats:
    """Return rows of unknowns of a coarse assembly at the level of a finer one."""
    inside = coarse.members.finer(fine.members, x[:, : coarse.inside])
    return np.concatenate([inside, x[:, coarse.inside :]], axis=1)
