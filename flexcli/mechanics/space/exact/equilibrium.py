"""Equilibrium of a mechanism in space of rigid bodies, blades and rods, at any stroke and load.

Blades are geometrically exact beams in mixed form (:mod:`flexcli.mechanics.space.exact.blade`), or
shells: their end forces are unknowns, what is inside them is eliminated blade by blade, which
leaves six equations that close each blade and six that balance each body. The path from rest and
the refinement of the nodes are those of the planar solver.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import Outcome
from flexcli.mechanics.refinement import (
    LEVELS,
    Reached,
    by_steps,
    difference,
    refined,
)
from flexcli.mechanics.space.exact.assembly import (
    UNTURNED,
    Assembly,
    Linearised,
    assemble,
    at_nodes,
    finer,
)
from flexcli.mechanics.space.exact.beams import beams_of
from flexcli.mechanics.space.exact.demand import Demand, Force, Frame, Held, demand_of
from flexcli.mechanics.space.exact.members import FIRST_GUESS, MembersOf
from flexcli.mechanics.space.exact.rotation import moved, vector_of
from flexcli.mechanics.space.exact.second_variation import (
    SecondVariation,
    inertia_count,
    second_variation,
)
from flexcli.mechanics.space.layout import BeamEffects, MissedSeat, SpaceLayout, SpaceLoad, Vector
from flexcli.numerics.newton import NewtonResult

__all__ = ["SpaceEquilibrium", "SpacePart", "beside", "solve", "started"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


class SpacePart(NamedTuple):
    """A mechanism at its nodes, what is asked, unknowns x and the share λ reached."""

    assembly: Assembly
    demand: Demand
    x: Floats
    share: float


@dataclass(frozen=True, eq=False)
class SpaceEquilibrium:
    """A mechanism in space in equilibrium, or how far it came and why (call ``checked``).

    ``frames`` are the points and axes of bodies whose motion is stated by others than their own.
    """

    layout: SpaceLayout
    effects: BeamEffects
    frames: Mapping[str, Frame]
    outcome: Outcome
    reached: float
    iterations: int
    estimated_error: float
    nodes: int
    seconds: float
    part: SpacePart
    coarser_part: SpacePart | None = None

    @property
    def coarser(self) -> "SpaceEquilibrium | None":
        """Return the same equilibrium on the level of nodes before, where there is one.

        What is read off both tells by how much it is off itself.
        """
        if self.coarser_part is None:
            return None
        return replace(self, part=self.coarser_part, coarser_part=None)

    def checked(self) -> "SpaceEquilibrium":
        """Return this when it converged.

        Raises
        ------
        SolveError
            Saying why it did not.
        """
        if self.outcome is not Outcome.CONVERGED:
            raise self.outcome.error()
        return self

    @cached_property
    def linearised(self) -> Linearised:
        """Return the equations about the solution."""
        return self.part.assembly.linearise(self.part.x, self.part.share, self.part.demand)

    @cached_property
    def variation(self) -> SecondVariation:
        """Return the second variation of the energy."""
        part = self.part
        return second_variation(part.assembly, part.demand, self.linearised, part.x, part.share)

    @cached_property
    def unstable(self) -> int:
        """Return in how many directions it is unstable, what is held being held; 0 is stable."""
        return inertia_count(self.variation, self.part.demand.free, self.part.assembly.blades)

    @cached_property
    def coordinates(self) -> Floats:
        """Return shift [m] and rotation vector [rad] of each body in its frame (bodies, 6)."""
        assembly = self.part.assembly
        motion = assembly.coordinates(self.part.x).reshape(-1, 6)
        return np.asarray(motion * np.repeat([assembly.length, 1.0], 3))

    @cached_property
    def end_forces(self) -> Floats:
        """Return force [N] and moment [N·m] on each blade's end, global axes (blades, 6)."""
        assembly = self.part.assembly
        forces = assembly.split(self.part.x).forces.copy()
        l = assembly.members.lengths[:, None]
        unit = assembly.members.bending[:, None] / l
        forces[:, :3] *= unit / l
        forces[:, 3:] *= unit
        return forces

    @cached_property
    def own_forces(self) -> Floats:
        """Return force [EI/l²] and end moment [EI/l] in the frames of the starts (blades, 6)."""
        forces = self.part.assembly.split(self.part.x).forces.reshape(-1, 2, 3)
        return np.asarray((forces @ np.swapaxes(self.linearised.axes, -1, -2)).reshape(-1, 6))

    @cached_property
    def reactions(self) -> Floats:
        """Return what holds each body in its coordinates (bodies, 6) [N, N·m], zero where free."""
        assembly, demand = self.part.assembly, self.part.demand
        held = np.zeros(6 * assembly.bodies)
        held[demand.held] = self.linearised.residual[6 * assembly.blades + demand.held]
        unit = assembly.force * np.repeat([1.0, assembly.length], 3)
        return np.asarray(held.reshape(-1, 6) * unit)

    def quaternion(self, body: str) -> Floats:
        """Return the rotation of a body as a unit quaternion (4,); the ground has none."""
        if not self._moves(body):
            return UNTURNED
        turn = self.part.assembly.split(self.part.x).turn[self.layout.index(body)]
        return np.asarray(turn / np.linalg.norm(turn))

    def motion_of(self, body: str, point: Vector) -> Floats:
        """Return how a point of a body, named at rest, moved: shift [m], rotation vector [rad]."""
        assembly = self.part.assembly
        i, at = self.layout.index(body), assembly.split(self.part.x)
        own = self.part.demand.warmth(self.part.share) * self.layout.body_growth.get(body, 0.0)
        grown = own * np.subtract(point, self.layout.bodies[i].point)
        arm = np.asarray(point) - assembly.points[i] * assembly.length + grown
        shift = at.shift[i] * assembly.length + grown + moved(at.turn[i], arm)
        return np.concatenate([shift, vector_of(at.turn[i])])

    def shift_of(self, body: str, point: Vector) -> Floats:
        """Return how far a point of a body moved [m] (3,); those of the ground do not."""
        return self.motion_of(body, point)[:3] if self._moves(body) else np.zeros(3)

    def _moves(self, body: str) -> bool:
        return any(each.name == body for each in self.layout.bodies)


class _InSpace(NamedTuple):
    """Blades in space and what is asked of them (``Discretised``), one design."""

    assembly: Assembly
    demand: Demand

    @property
    def nodes(self) -> int:
        """Return the level of the blades: Gauss nodes on a piece, or modes."""
        return self.assembly.members.level

    def step(self, x: Floats, share: Floats, rows: Integers) -> Floats:
        """Return Newton's steps."""
        each = [self.assembly.step(*pair, self.demand) for pair in zip(x, share, strict=True)]
        return np.array(each).reshape(x.shape)

    def newton(self, x: Floats, share: Floats, rows: Integers, **how: Any) -> NewtonResult:
        """Return where Newton's method leads from x."""
        return by_steps(self, x, share, rows, **how)

    def length_of(self, x: Floats, step: Floats) -> Floats:
        """Return the lengths of steps [-]."""
        return self.assembly.length_of(x, step)

    def unstable(self, x: Floats, share: Floats, rows: Integers) -> Integers:
        """Return in how many directions equilibria are unstable."""
        return np.array([self._unstable(*pair) for pair in zip(x, share, strict=True)])

    def _unstable(self, x: Floats, share: float) -> int:
        assembly, demand = self
        at = assembly.linearise(x, share, demand)
        variation = second_variation(assembly, demand, at, x, share)
        return inertia_count(variation, demand.free, assembly.blades)

    def at_nodes(self, nodes: int) -> "_InSpace":
        """Return the same at another number of nodes."""
        return self._replace(assembly=at_nodes(self.assembly, nodes))

    def finer(self, fine: "_InSpace", x: Floats) -> Floats:
        """Return unknowns interpolated to the nodes of a finer one."""
        return finer(self.assembly, fine.assembly, x)

    def changed(self, fine: "_InSpace", x: Floats, y: Floats, scale: Floats) -> Floats:
        """Return by how much x differs from y, solved with finer nodes [-]."""
        if self.nodes == FIRST_GUESS:
            return np.full(x.shape[0], np.inf)
        pairs = []
        for one, rows in ((self.assembly, x), (fine.assembly, y)):
            at = [one.at(row) for row in rows]
            # by quaternions: they know no singular pose
            moved = [np.append(a.shift, 2.0 * (a.turn - UNTURNED)) for a in at]
            pairs.append((np.array([a.forces for a in at]), np.array(moved)))
        return difference(pairs[0], pairs[1], fine.assembly.members.stretch, scale)

    def part(self, reached: Reached) -> SpacePart:
        """Return the design of a level as the answer."""
        return SpacePart(self.assembly, self.demand, reached.x[0], float(reached.share[0]))


def solve(
    layout: SpaceLayout,
    held: Held | None = None,
    *,
    loads: Sequence[SpaceLoad] = (),
    load_factor: float = 1.0,
    frames: Mapping[str, Frame] | None = None,
    effects: BeamEffects | None = None,
    tolerance: float = 1e-9,
    start: SpaceEquilibrium | None = None,
    levels: Sequence[int] = LEVELS,
    made: MembersOf = beams_of,
    missed: MissedSeat | None = None,
) -> SpaceEquilibrium:
    """Return the equilibrium on the path from rest, or from ``start``, to the motions and loads.

    Parameters
    ----------
    layout : SpaceLayout
        The mechanism.
    held : mapping, optional
        Shift [m] and rotation vector [rad] of bodies in their frames, None where free.
    loads : sequence of SpaceLoad
        Dead loads, each times ``load_factor``. A moment about fixed axes has no energy where the
        body turns far about more than one.
    load_factor : float
        Factor on ``loads`` [-].
    frames : mapping, optional
        Points and axes by which the motion of bodies is stated; by default their own points and
        the axes of the drawing.
    effects : BeamEffects, optional
        What blades feel; everything by default.
    tolerance : float
        Error of the blades' end forces, over the largest of them, and of motions, over the
        largest (lengths in mean blade lengths) [-].
    start : SpaceEquilibrium, optional
        Where the path begins: an equilibrium of the same layout in the same frames.
    levels : sequence of int
        Gauss nodes on a segment, level by level; a single one is taken as it is.
    made : callable
        Makes the blades: beams, or shells, whose levels are modes along a blade.
    missed : MissedSeat, optional
        A seat that is off, by as much as the share of the way.

    Returns
    -------
    SpaceEquilibrium
        The solution, or how far it came and why.

    Raises
    ------
    KeyError
        When a body of ``held`` or of a load is not in the layout.
    SolveError
        When the thickness of a blade varies.

    """
    begun = perf_counter()
    effects = BeamEffects() if effects is None else effects
    frames = {} if frames is None else frames
    coarse = assemble(layout, effects, levels[0], frames, made)
    length, force = coarse.length, coarse.force
    demand = demand_of(
        layout,
        {} if held is None else held,
        loads,
        coarse.points,
        length,
        force,
        load_factor,
        missed,
    )
    x = coarse.rest()
    if start is not None:
        x = finer(start.part.assembly, coarse, start.part.x[None])[0]
        demand = started(start, demand)
    found = refined(_InSpace(coarse, demand), x[None], tolerance, levels)
    (last,) = found.parts
    return SpaceEquilibrium(
        layout=layout,
        effects=effects,
        frames=frames,
        outcome=found.outcome[0],
        reached=float(found.reached[0]),
        iterations=int(found.iterations[0]),
        estimated_error=float(found.error[0]),
        nodes=int(found.nodes[0]),
        seconds=perf_counter() - begun,
        part=last.at.part(last),
        coarser_part=found.coarser[0].at.part(found.coarser[0]) if found.coarser else None,
    )


def beside(
    state: SpaceEquilibrium,
    layout: SpaceLayout,
    held: Held,
    *,
    loads: Sequence[SpaceLoad] = (),
    frames: Mapping[str, Frame],
    made: MembersOf = beams_of,
) -> SpaceEquilibrium:
    """Return what an equilibrium becomes where the numbers of its layout change a little.

    One step of Newton's method from the known unknowns, at the same nodes. Half the difference of
    numbers at changes ±δp is their implicit derivative times δp,
    ``∂g/∂p − ∂g/∂x (∂R/∂x)⁻¹ ∂R/∂p``: what the step leaves of R is even in δp.

    Parameters
    ----------
    state : SpaceEquilibrium
        An equilibrium on a path from rest.
    layout : SpaceLayout
        The same bodies and blades, with other numbers.
    held, loads, frames, made
        As in :func:`solve`; what is held may differ a little too.

    """

    def changed(part: SpacePart) -> SpacePart:
        level = part.assembly.members.level
        assembly = assemble(layout, state.effects, level, frames, made)
        length, force = assembly.length, assembly.force
        demand = demand_of(layout, held, loads, assembly.points, length, force)
        x = part.x + assembly.step(part.x, 1.0, demand)
        return SpacePart(assembly, demand, x, 1.0)

    coarser = None if state.coarser_part is None else changed(state.coarser_part)
    return replace(
        state, layout=layout, frames=frames, part=changed(state.part), coarser_part=coarser
    )


def started(start: SpaceEquilibrium, demand: Demand) -> Demand:
    """Return the demand with what holds at the start fading away along the path."""
    part = start.part
    assembly = part.assembly
    before = assembly.coordinates(part.x)[demand.held]
    gone = [
        force._replace(before=force.size(part.share), after=0.0) for force in part.demand.forces
    ]
    k_f = 6 * assembly.blades
    reaction = np.zeros(6 * assembly.bodies)
    reaction[part.demand.held] = start.linearised.residual[k_f + part.demand.held]
    reaction[demand.held] = 0.0
    for body in range(assembly.bodies):
        own = reaction[6 * body : 6 * body + 6]
        if np.any(own != 0.0):
            # as force and moment about fixed axes
            load = np.linalg.solve(start.linearised.basis[body].T, own)
            gone.append(Force(body, np.zeros(3), load[:3], load[3:], 1.0, 0.0))
    return demand._replace(before=before, forces=(*gone, *demand.forces), grown=True)
