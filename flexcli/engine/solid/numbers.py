"""What a joint is asked for, by solid elements: the same numbers as a model of it gives."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, inf, pi, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.buckling import PushScene, ends_held, push_scene
from flexcli.engine.joint_models.holds import driven_axis
from flexcli.engine.joint_models.joint_states import layout_of, over_travels, warmed
from flexcli.engine.solid.deck import (
    State,
    buckling_deck,
    compliance_deck,
    modes_deck,
    support_deck,
)
from flexcli.engine.solid.deck_model import MM
from flexcli.engine.solid.model import SolidModel, solid_model, solid_model_in_space
from flexcli.engine.solid.states import FaceStress, Runner, SolidStates, solid_states
from flexcli.formulas.profile import Constant, NeckedDown, Tabulated
from flexcli.formulas.rigid_motion import motion_at
from flexcli.mechanics.demand import Held
from flexcli.mechanics.layout import Body, Layout, Load, Number
from flexcli.mechanics.mesh import single
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.mechanisms.carried import is_guided
from flexcli.parts.own_motion import first_taking
from flexcli.parts.requirements import Ask
from flexcli.parts.requirements.support import compliance_of
from flexcli.parts.space_joint import joint_in_space
from flexcli.parts.structure import joined

__all__ = ["BESIDE", "SolidNumbers", "StressPlace", "moving_masses", "whole_model"]

Floats = NDArray[np.float64]

SMALL = 1e-6
"""Rotation, or travel over the blades' length, of the linear steps."""

BESIDE = 0.01
"""Of a stroke: to either side of its end lie the states whose forces give the stiffness there."""

NEAR = 2e-4
"""Rotation, or travel over the blades' length, to either side of where a temperature leaves it."""

NEXT_TO = 0.02
"""Of half the least thickness: how far forces across the plane move the body beside its stroke."""

SETTLED = 1e-4
"""Change of a load factor, relative, at which what a turning body adds to it is found."""

TRIES = 8

FOUND_FROM = 3.0
"""Load factor that is looked for: CalculiX finds those next to one, and none far below."""

STRAIGHT = (Constant, NeckedDown, Tabulated)
"""Profiles that end in a corner at their clamps, where the stress of a solid has no bound."""


class StressPlace(NamedTuple):
    """Where the stress of a stretch is compared: a face, and how far along its blade [m].

    Without a distance it is the greatest along the face, which is on a curve and not in a corner.
    """

    stretch: str
    face: str
    s: float | None


@dataclass(frozen=True, eq=False)
class SolidNumbers:
    """A joint in a case on one mesh; ``runner`` runs its decks."""

    ask: Ask
    runner: Runner
    fineness: int

    def stiffness(self) -> float:
        """Return the stiffness along the motion at rest [N·m/rad or N/m]."""
        if self.ask.geometry.in_space:
            way = _drive_motion(self.ask)
            return float(1.0 / (way @ self.compliance() @ way))
        layout = layout_of(self.ask)
        axis = driven_axis(self.ask.geometry)
        if self.ask.scene.tilts:
            index = (0, 1, 5)[axis]
            return float(1.0 / self.compliance()[index, index])
        return self._upright_stiffness(layout, axis)

    def _upright_stiffness(self, layout: Layout, axis: int) -> float:
        """Return the stiffness along the motion of a body that stays in the plane."""
        small = SMALL * (1.0 if axis == 2 else _longest(layout))
        held: Held = {MOVING: self.ask.geometry.held(small)}
        state = self._solve(layout, held, (), is_linear=True)
        return float(state.reactions[0, layout.index(MOVING), axis]) / small

    def compliance(self) -> Floats:
        """Return the 6×6 compliance at the moving body's point, in the axes of cases."""
        geometry = self.ask.geometry
        model, name = whole_model(self.ask, self.fineness), moving_body(self.ask)
        deck = compliance_deck(model, name, geometry.is_guided)
        ref, rot = deck.bodies[name]
        columns = [
            np.concatenate([moved[ref], moved[rot]])
            for moved in self.runner(deck).tables("displacements")
        ]
        # N and N·mm give mm and rad
        C = np.stack(columns, axis=-1) * np.repeat([1.0 / MM, 1.0], 3)[:, None]
        C = C * np.repeat([1.0, MM], 3)[None, :]
        c, s = cos(geometry.axes), sin(geometry.axes)
        turn = np.kron(np.eye(2), np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]))
        return np.asarray(turn @ C @ turn.T)

    def states(self) -> SolidStates:
        """Return the states of the case: at the end of its stroke, and a little to either side."""
        scene = self.ask.scene
        travels = None
        if scene.moves:
            travels = scene.stroke_ends[0] * np.array([1.0 - BESIDE, 1.0, 1.0 + BESIDE])
        return over_travels(self.ask, self._solve, travels)

    def stiffness_at_end(self) -> float:
        """Return the tangent of the effort at the end of the stroke."""
        state, axis = self.states(), driven_axis(self.ask.geometry)
        body = state.model.layout.index(MOVING)
        effort, travel = state.reactions[:, body, axis], state.motions[:, body, axis]
        return float((effort[2] - effort[0]) / (travel[2] - travel[0]))

    def shift(self) -> float:
        """Return the shift at the end of the stroke, positive towards −x of the layout [m].

        With a temperature it is the larger one of both ends, or what that leaves without a stroke.
        """
        scene = self.ask.scene
        if scene.temperature is None:
            return self._shift_of(self.states(), 1)
        if not scene.moves:
            return self._shift_of(self._warm_rest(), 0)
        ends = np.array(scene.stroke_ends)
        state = self._solve(warmed(self.ask), self._held_at(ends), ())
        return max((self._shift_of(state, index) for index in (0, 1)), key=abs)

    def _shift_of(self, state: SolidStates, index: int) -> float:
        body = state.model.layout.body(MOVING)
        x, y, phi = state.motions[index, state.model.layout.index(MOVING)]
        if self.ask.geometry.motion == "translation":
            return -float(x)
        # the centre is the layout's origin
        a, b = (-single(c) for c in body.point)
        x += (cos(phi) - 1.0) * a - sin(phi) * b
        y += sin(phi) * a + (cos(phi) - 1.0) * b
        return float(np.copysign(np.hypot(x, y), -x))

    def _warm_rest(self) -> SolidStates:
        """Return the joint as its temperature leaves it, the drive free."""
        held: Held = {MOVING: (None, None, 0.0 if self.ask.geometry.is_guided else None)}
        return self._solve(warmed(self.ask), held, ())

    def _held_at(self, travels: Floats) -> Held:
        """Return the coordinates of the moving body that the drive holds, at travels."""
        held: list[Number | None] = list(self.ask.geometry.held(0.0))
        held[driven_axis(self.ask.geometry)] = travels
        return {MOVING: (held[0], held[1], held[2])}

    def warm_stiffness(self) -> float:
        """Return the stiffness along the motion where the temperature leaves the joint."""
        layout, axis = warmed(self.ask), driven_axis(self.ask.geometry)
        body = layout.index(MOVING)
        small = NEAR * (1.0 if axis == 2 else _longest(layout))
        travels = self._warm_rest().motions[0, body, axis] + small * np.array([-1.0, 1.0])
        state = self._solve(layout, self._held_at(travels), ())
        effort = state.reactions[:, body, axis]
        return float(effort[1] - effort[0]) / (2.0 * small)

    def across_at_end(self, force: float) -> float:
        """Return the stiffness along the layout's x at the end of the stroke, the drive held."""
        scene, layout = self.ask.scene, warmed(self.ask)
        held: Held = {MOVING: self.ask.geometry.held(scene.stroke_ends[0])}
        point = layout.body(MOVING).point
        loads = [Load(MOVING, point, (np.array([-force, force]), 0.0))]
        state = self._solve(layout, held, loads)
        x = state.motions[:, layout.index(MOVING), 0]
        return float(2.0 * force / (x[1] - x[0]))

    def support_at_end(self, index: int) -> float:
        """Return the stiffness along z, or about x or y, at the end of the stroke, drive locked.

        By forces along z on two places of the body that lie along an axis of cases there.
        """
        scene, geometry, layout = self.ask.scene, self.ask.geometry, layout_of(self.ask)
        end, arm = scene.stroke_ends[0], _longest(layout)
        back = end if geometry.motion == "rotation" else 0.0
        x, y = (single(c) for c in layout.body(MOVING).point)
        ways = [geometry.axes - back, geometry.axes - back + pi / 2.0]
        arms = [
            ((x + arm * cos(way), y + arm * sin(way)), (x - arm * cos(way), y - arm * sin(way)))
            for way in ways
        ]
        stiff = 1.0 / np.diag(compliance_of(self.ask, locked=True))[2:5]
        model = self._model(layout, is_half=False)
        small = NEXT_TO * min(float(s.bricks.places[:, 1].max()) for s in model.stretches)
        along, about_x, about_y = stiff * small / [1.0, arm**2, arm**2]
        forces = [
            (0, along / 2.0, along / 2.0), (1, about_x / 2.0, -about_x / 2.0),
            (0, about_y / 2.0, -about_y / 2.0),
        ]  # fmt: skip
        state = State({MOVING: geometry.held(end)})
        deck, nodes = support_deck(model, MOVING, state, arms, forces)
        rest, *moved = self.runner(deck).tables("displacements")
        which, one, other = forces[index - 2]
        u, v = ((moved[index - 2][node] - rest[node])[2] / MM for node in nodes[which])
        if index == 2:
            return float((one + other) / ((u + v) / 2.0))
        return float((one - other) * arm / ((u - v) / (2.0 * arm)))

    def stress(self, place: StressPlace) -> float:
        """Return the magnitude of the stress at a place at the end of the stroke [Pa]."""
        states = self.states()
        found = states.face_stresses(1 if self.ask.scene.moves else 0)
        return _stress_at(next(f for f in found if f.stretch.name == place.stretch), place)

    def critical(self, near: float) -> float:
        """Return the least force of the case at which the joint buckles at rest in its plane [N].

        ``near`` is about where it is.
        """
        scene = self.ask.scene
        found = [
            self._critical(push_scene(self.ask, push), near * push.force / scene.force)
            * scene.force / push.force
            for push in scene.pushes()
        ]  # fmt: skip
        return min(found)

    def frequency(self) -> float:
        """Return the lowest frequency that the joint's own motion takes part in [Hz]."""
        ask, density = self.ask, self.ask.material.density
        if density is None:
            raise NotAvailable("needs material.density for the mass of the blades")
        if ask.geometry.in_space:
            model, guided, way = whole_model(ask, self.fineness), [], _drive_motion(ask)
        else:
            model = self._model(moving_masses(ask))
            guided = [MOVING] if is_guided(ask.geometry) else []
            way = np.eye(6)[(0, 1, 5)[driven_axis(ask.geometry)]]
        deck = modes_deck(model, float(density.value), guided)
        printed = self.runner(deck)
        ref, rot = deck.bodies[moving_body(ask)]
        squares = np.array(printed.squares())
        moved = [
            float(way @ np.concatenate([shape[ref] / MM, shape[rot]]))
            for shape in printed.tables("displacements")
        ]
        count = min(len(moved), squares.size)
        taking = np.array(moved[:count]) ** 2 / squares[:count]
        first = first_taking(taking, taking.sum())
        assert first is not None  # one of them takes as much
        found = float(np.sqrt(squares[first]) / (2.0 * np.pi))
        if ask.geometry.in_space or not ask.scene.tilts:
            return found
        upright = self._upright_stiffness(layout_of(ask), driven_axis(ask.geometry))
        return found * float(np.sqrt(self.stiffness() / upright))

    def _solve(
        self, layout: Layout, held: Held, loads: Sequence[Load], *, is_linear: bool = False
    ) -> SolidStates:
        return solid_states(
            layout, held, loads, self.runner, fineness=self.fineness, is_linear=is_linear,
            stiffness=self._stiffness,
        )  # fmt: skip

    def _model(self, layout: Layout, *, is_half: bool = True) -> SolidModel:
        return solid_model(
            layout, fineness=self.fineness, is_half=is_half, stiffness=self._stiffness
        )

    @property
    def _stiffness(self) -> Floats | None:
        return self.ask.material.stiffness_in(self.ask.geometry.drawn_turn)

    def _critical(self, scene: PushScene, near: float) -> float:
        """Return the factor of the unit force at which the joint buckles.

        CalculiX's rigid bodies lack what the forces of their blades do as the arms turn on which
        they act. What holds the turn gives that back, as stiff as it is at the factor found.
        """
        if scene.hold.hinged:
            raise NotAvailable("has hinged ends, which are no solid")
        model = self._model(scene.layout)
        unit = near / FOUND_FROM
        loads = [
            load._replace(
                force=(unit * load.force[0], unit * load.force[1]), moment=unit * load.moment
            )
            for load in scene.pattern
        ]
        state = State({MOVING: ends_held(scene)[MOVING]}, loads)
        turning = self._turning(model, scene)

        def factor(at: float) -> float:
            holding = {name: at * moment for name, moment in turning.items()}
            found = self.runner(buckling_deck(model, state, holding)).buckling()
            return unit * min((f for f in found if f > 0.0), default=inf)

        if not turning:
            return factor(0.0)
        one = near
        f_one = factor(one)
        other = f_one
        for _ in range(TRIES):
            f_other = factor(other)
            if abs(f_other - other) <= SETTLED * abs(f_other):
                return f_other
            slope = (f_other - f_one) / (other - one)
            one, f_one = other, f_other
            other = (f_other - slope * other) / (1.0 - slope)
        raise NotAvailable("has no settled critical load by solid elements")

    def _turning(self, model: SolidModel, scene: PushScene) -> dict[str, float]:
        """Return the moment per turn of the forces on each body that turns, under the unit force.

        ``Σ f·r`` over the faces that are tied to it [N·m/rad].
        """
        held = ends_held(scene)[MOVING]
        bodies = [b for b in model.bodies if b.name != MOVING or held[2] is None]
        if not bodies:
            return {}
        states = solid_states(
            scene.layout, ends_held(scene), scene.pattern, self.runner,
            fineness=self.fineness, is_linear=True, stiffness=self._stiffness,
        )  # fmt: skip
        places = np.concatenate([stretch.places for stretch in model.stretches])
        forces = next(states.printed.tables("forces"))
        found = {}
        for body in bodies:
            arms = places[body.nodes, :2] - np.array(body.point[:2])
            on_blade = np.array([forces[n][:2] for n in body.nodes + 1])
            moment = -float(np.sum(on_blade * arms)) / model.share
            if abs(moment) <= SETTLED * float(np.abs(on_blade * arms).sum()):
                continue
            if moment < 0.0:
                raise NotAvailable(
                    f"has a body, {body.name}, that the forces of its blades turn further: "
                    "CalculiX's rigid bodies lack that, and what gives it back would be negative"
                )
            found[body.name] = moment
        return found


def whole_model(ask: Ask, fineness: int) -> SolidModel:
    """Return the solids of a joint at rest, blades whole, in the plane or in space."""
    geometry, elastic = ask.geometry, ask.material.elastic
    if geometry.in_space:
        layout = joint_in_space(geometry, ask.material, ask.sizes).layout
        return solid_model_in_space(layout, fineness=fineness)
    stiffness = ask.material.stiffness_in(geometry.drawn_turn)
    planar = geometry.layout(elastic, ask.sizes)
    return solid_model(planar, fineness=fineness, stiffness=stiffness)


def moving_body(ask: Ask) -> str:
    """Return the name of the body whose motion the joint's stiffness is of."""
    if not ask.geometry.in_space:
        return MOVING
    return joint_in_space(ask.geometry, ask.material, ask.sizes).layout.drive.body


def _drive_motion(ask: Ask) -> Floats:
    """Return the motion (6,) of the driven body's point along the drive of a joint in space."""
    layout = joint_in_space(ask.geometry, ask.material, ask.sizes).layout
    arm = np.subtract(layout.drive.point, layout.body(layout.drive.body).point)
    return np.asarray(motion_at(arm).T @ layout.drive.motion)


def moving_masses(ask: Ask) -> Layout:
    """Return the layout with all that moves on its bodies: its own masses, and the mechanism's.

    Raises
    ------
    NotAvailable
        Where the mechanism is more than a body on one joint, or nothing has a mass.

    """
    layout = ask.geometry.layout(ask.material.elastic, ask.sizes)
    mechanism = ask.mechanism
    if mechanism is None:
        if not ask.geometry.has_masses:
            raise NotAvailable("moves nothing that has a mass")
        return layout
    if mechanism.joints != 1:
        raise NotAvailable("is one of several joints: the mechanism's frequency is not the joint's")
    moving = layout.body(MOVING)
    centre = ask.geometry.payload_point(moving.point)
    com = (centre[0] + getattr(mechanism, "arm", 0.0), centre[1])
    own = moving._replace(com=moving.com if moving.mass else com)
    mass, inertia = mechanism.hanging_mass(), mechanism.turning_inertia or 0.0
    both = joined(MOVING, moving.point, [own, Body("payload", centre, mass, inertia, com)])
    bodies = tuple(both if body.name == MOVING else body for body in layout.bodies)
    return Layout(bodies, layout.blades, layout.E, layout.G, layout.supports)


def _longest(layout: Layout) -> float:
    ends = [np.subtract(b.end, b.start).astype(np.float64) for b in layout.blades]
    return max(float(np.hypot(*end)) for end in ends)


def _stress_at(found: FaceStress, place: StressPlace) -> float:
    face = found.left if place.face == "left" else found.right
    if place.s is None:
        return float(np.abs(face).max())
    return abs(float(np.interp(place.s, found.s, face)))
