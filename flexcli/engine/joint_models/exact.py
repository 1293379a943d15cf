"""The exact model of a joint: geometrically exact blades between its bodies, at full stroke."""

from collections.abc import Iterator, Sequence
from functools import partial
from math import inf, nan
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.bent_in_plane import bent_in_plane
from flexcli.engine.joint_models.blade_weight import BladeWeights
from flexcli.engine.joint_models.buckling import (
    SETTLED,
    critical_unsure,
    exact_critical,
    warm_shares,
)
from flexcli.engine.joint_models.face_stress import PlateStresses, largest_at_faces, worst_of_stroke
from flexcli.engine.joint_models.holds import driven_axis, hold_of
from flexcli.engine.joint_models.joint_states import (
    at_rest,
    blades_of,
    exactly,
    layout_of,
    solved,
    warmed,
)
from flexcli.engine.joint_models.remembered import Remembered
from flexcli.engine.joint_models.states_beside import states_beside, trail_of
from flexcli.engine.joint_models.warm_shift import Shifts, warm_shift
from flexcli.engine.joint_models.wide_under_force import factors_of_states, factors_of_warmth
from flexcli.engine.planning.coverage import COVERAGE, covered
from flexcli.formulas.amplified import FURTHER, bent_part
from flexcli.formulas.blade_spring import Warping
from flexcli.formulas.quantity import Computed
from flexcli.mechanics.equilibrium import LEVELS
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.own_weight import POINTS
from flexcli.mechanics.points import MovedLayout, point_motion
from flexcli.mechanics.state import Equilibrium
from flexcli.mechanics.stresses import BladeStress, beside_beam, blade_stress
from flexcli.mechanics.tangent import held_stiffness
from flexcli.numerics.rows import (
    Number,
    isfinite,
    larger,
    largest_of_each,
    of_each,
    one_alone,
    states_of,
)
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import Buckled, NotAvailable, buckled
from flexcli.parts.geometries.base import MOVING, Critical, Held
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.own_motion import hanging_mass
from flexcli.parts.requirements import (
    Ask,
    Bent,
    CriticalShare,
    DriveEffort,
    EndStress,
    JointModel,
    MisfitStress,
    Told,
)
from flexcli.parts.requirements.closed_form import across_width
from flexcli.parts.requirements.warm_shift import WarmShift, combined
from flexcli.parts.temperature import held_bending, sheared_across
from flexcli.results import EXACT, ErrorRange, QuantityKind

if TYPE_CHECKING:
    from flexcli.mechanics.space.swept_box import SweptBox
    from flexcli.parts.space_joint import Form

__all__ = ["DIGITS", "ExactModel", "alone", "driven_stiffness", "hanging", "lost", "shifts_of"]

Floats = NDArray[np.float64]

TOLERANCE = 1e-9

SAMPLED = 1e-6
"""Of the stress: what its greatest value between two places is more, see ``POINTS``."""

ALIKE = 1e-9
"""Relative difference of the shifts of both ends that counts as none."""

DIGITS = 1e-13
"""Of a travel, what rounding leaves of a shift."""

FIRST_ORDER = 2e-3
"""Of a sag: what its size may change so that nothing else is asked."""

WARPINGS: tuple[Warping, ...] = ("restrained", "free")
"""What the ends of blades in torsion may do."""


class ExactModel(JointModel):
    """Any rotation, stretching and shear of the blades; stress at both faces all along them.

    ``levels`` are the Gauss nodes on a piece, level by level until the tolerance is met; a single
    one is taken as it is.
    """

    name = "exact"
    always = COVERAGE["exact"].always
    weighs_blades = True
    directs_in_plane = True

    def __init__(
        self,
        effects: Effects | None = None,
        tolerance: float = TOLERANCE,
        levels: Sequence[int] = LEVELS,
    ) -> None:
        self.effects = Effects() if effects is None else effects
        self.covers = covered("exact", self.effects)
        self.tolerance = tolerance
        self.levels = levels
        self._known_stresses: Remembered[tuple[list[EndStress], float]]
        self._known_stresses = Remembered("exact", of_blades=True)
        self._known_trails: Remembered[tuple[Equilibrium, ...]] = Remembered(of_blades=True)
        self._known_states: Remembered[Equilibrium] = Remembered(of_blades=True)
        self._known_pairs: Remembered[tuple[float, float]] = Remembered("exact", of_blades=True)
        self._known_critical: Remembered[tuple[Critical, ...]] = Remembered(of_blades=True)
        self._known_sags: Remembered[Told] = Remembered()
        self._known_warm: Remembered[WarmShift] = Remembered(of_blades=True)
        self._known_bent: Remembered[Number] = Remembered("exact", of_blades=True)

    def shares(self, other: JointModel) -> None:
        """Share the equilibria of beams, which other exact models have as well."""
        if isinstance(other, ExactModel):
            self._known_trails, self._known_states = other._known_trails, other._known_states
            self._known_critical, self._known_warm = other._known_critical, other._known_warm
            self._known_bent = other._known_bent

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return the solver's own error: by how much its last two levels of nodes differ.

        It is nothing for what it has no second level of. What no beam carries is not in it.
        """
        if kind is QuantityKind.SAG:
            try:
                return self._sag_error(ask)
            except NotAvailable:
                return None
        find = {
            QuantityKind.STIFFNESS: lambda: self._stiffness(ask)[1],
            QuantityKind.FREQUENCY: lambda: self._stiffness(ask)[1] / 2.0,
            QuantityKind.STRESS: lambda: self._judged(ask)[1],
            QuantityKind.SHIFT: lambda: self._shift(ask)[1],
            QuantityKind.BUCKLING: lambda: SETTLED * self.tolerance,
        }.get(kind)
        try:
            found = find() if find is not None else inf
        except NotAvailable:
            return None
        return ErrorRange(-found, found) if isfinite(found) else None

    def stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the motion at rest, shear and stretching included."""
        return self._stiffness(ask)[0]

    def _stiffness(self, ask: Ask) -> tuple[float, float]:
        """Return the stiffness at rest and its relative error.

        At rest nothing moves that could tell whether the nodes do: the stiffness itself tells.
        """
        # the forces of a case play no part at rest
        return self._known_pairs.of("stiffness", ask, lambda: self._settled_stiffness(ask))

    def _settled_stiffness(self, ask: Ask) -> tuple[float, float]:
        found, error = nan, inf
        layout, held = at_rest(ask, self.effects)
        effects = blades_of(layout, self.effects)
        for nodes in self.levels:
            before = found
            state = solved(layout, held, effects=effects, tolerance=self.tolerance, levels=(nodes,))
            found = of_each(driven_stiffness(state, ask))
            error = abs(before / found - 1.0) if isfinite(before) else inf
            if error <= self.tolerance:
                break
        if ask.scene.temperature is not None:
            error += held_bending(warmed(ask), ask.material.elastic.most_nu)
        return found, error

    def heat_in_stiffness(self, ask: Ask) -> Number:
        """Return what heat changes of it, and what it does by bending what is deformed."""

        def at(warmth: float) -> Floats:
            layout, held = at_rest(ask, self.effects, warmth)
            state = solved(
                layout, held, effects=blades_of(layout, self.effects),
                tolerance=self.tolerance, levels=self.levels[:1],
            )  # fmt: skip
            return driven_stiffness(state, ask)

        cold, warm, hotter = (at(warmth) for warmth in (0.0, 1.0, 1.0 + FURTHER))
        return of_each((np.abs(cold - warm) + bent_part(cold, warm, hotter)) / warm)

    def stiffness_at_end(self, ask: Ask) -> float:
        """Return the tangent of the effort at the end of the stroke, under the case's forces."""
        one_alone()
        return float(driven_stiffness(self.states(ask), ask)[0])

    def states(self, ask: Ask) -> Equilibrium:
        """Return the equilibria of a case."""
        if ask.near is None or ask.scene.temperature is not None:
            return self._trail(ask)[-1]
        trail = self._trail(ask.near._replace(scene=ask.scene))
        return self._known_states.of("states", ask, lambda: states_beside(ask, trail))

    def _trail(self, ask: Ask) -> tuple[Equilibrium, ...]:
        """Return the equilibria of a case after those that they start from."""
        find = partial(trail_of, ask, self.effects, self.tolerance, self.levels)
        try:
            return self._known_trails.of("states", ask, find)
        except Buckled as found:
            less, more = critical_unsure(ask)
            raise buckled(found.share, less=less, more=more) from None

    def effort(self, ask: Ask) -> tuple[DriveEffort, ...]:
        """Return what holds the joint at both ends of the stroke, under the case's loads."""
        one_alone()
        states, scene = self.states(ask), ask.scene
        body, axis = states.layout.index(MOVING), driven_axis(ask.geometry)
        sagged = states.motions[:, body, axis] - np.tile(scene.stroke_ends, states.designs // 2)
        held = states.reactions[:, body, axis]
        before = None if states.coarser is None else states.coarser.reactions[:, body, axis]
        pushed = np.abs(sagged) * self._stiffness(ask)[0] if np.any(sagged) else sagged
        found = []
        for end, travel in enumerate(scene.stroke_ends):
            sense = -1.0 if travel < 0.0 else 1.0
            efforts, loads = sense * held[end::2], pushed[end::2]
            worst = int(np.argmax(efforts + loads))
            effort, load, error = float(efforts[worst]), float(loads[worst]), None
            if before is not None and effort != 0.0:
                off = float(np.max(np.abs(before - held)[end::2])) / abs(effort)
                error = ErrorRange(-off, off)
            found.append(DriveEffort(travel, effort, error, load))
        return tuple(found)

    def sag_stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the case's acceleration, the joint free but for its guide."""
        if ask.geometry.sags_along_stroke(ask.scene.axis):
            return self.stiffness(ask)
        try:
            ratio = self._warm_sag(ask).value
        except NotAvailable:
            ratio = 1.0
        return 1.0 / (hanging(ask).found * ratio)

    def _warm_sag(self, ask: Ask) -> Told:
        """Return what a temperature strains makes of a sag off the stroke [-]."""
        if any(ask.scene.stated):
            raise NotAvailable("has no sag beside stated loads")
        if ask.scene.temperature is None:
            return Told(1.0, EXACT)
        from flexcli.engine.joint_models.space_deflection import warm_sag_ratio

        return self._known_sags.of("warm sag", ask, lambda: warm_sag_ratio(ask))

    def heat_in_sag(self, ask: Ask) -> ErrorRange | None:
        """Return the error of what a temperature strains, which exact beams in space have."""
        return self._warm_sag(ask).error

    def carries(self, ask: Ask, kind: QuantityKind) -> frozenset[EffectName]:
        """Return what the springs in space and their error have of a sag off the stroke."""
        if kind is not QuantityKind.SAG or ask.geometry.sags_along_stroke(ask.scene.axis):
            return frozenset()
        return frozenset({EffectName.PLATE_WIDENING, EffectName.CLAMP_COMPLIANCE})

    def sag_changes(self, ask: Ask) -> tuple[tuple[float, float], ...]:
        """Return what exact beams in space tell of a sag that is not small.

        Raises
        ------
        Buckled
            When what the body weighs surely buckles the joint, or turns it over.

        """
        from flexcli.engine.joint_models.space_deflection import sag_changes
        from flexcli.parts.strained_compliance import beyond_linear_sag

        if not ask.scene.sags:
            raise NotAvailable("does not sag along one axis")
        small = beyond_linear_sag(ask)
        if small is not None and small <= FIRST_ORDER:
            raise NotAvailable("has a sag of first order")
        return tuple(sag_changes(ask))

    def _sag_error(self, ask: Ask) -> ErrorRange | None:
        """Return the error of a sag, where there is one: off the stroke that of springs in space.

        Where masses hang off the point, so that blades twist, that counts besides: torsion with
        ends that may warp, or not.
        """
        if not ask.scene.sags:
            return EXACT
        if ask.geometry.sags_along_stroke(ask.scene.axis):
            found = self._stiffness(ask)[1]
            return ErrorRange(-found, found) if isfinite(found) else None
        joint = ask.mechanism, ask.geometry, ask.material.elastic, ask.sizes, ask.scene.axis
        error = hanging(ask).error
        if error is None:
            return None
        try:
            held, free = (hanging_mass(*joint, warping=each) for each in WARPINGS)
        except MechanismError:
            return error
        apart = abs(free / held - 1.0)
        return error + ErrorRange(-apart, apart)

    def support_at_stroke(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the support stiffness at both ends of the stroke, by the joint in space."""
        from flexcli.engine.joint_models.space_stroke import support_at_stroke

        return support_at_stroke(ask, index, point, locked=locked)

    def warm_support_ratio(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> Told:
        """Return the ratio by exact beams in space."""
        from flexcli.engine.joint_models.space_stroke import warm_support_ratio

        return warm_support_ratio(ask, index, point, locked=locked)

    def deflections(
        self, ask: Ask, point: tuple[float, float, float], direction: str
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return how far the wrench moves a point, by exact beams in space."""
        from flexcli.engine.joint_models.space_deflection import deflections

        return deflections(ask, point, direction)

    def misfit_stresses(
        self, ask: Ask, small: Sequence[MisfitStress]
    ) -> Iterator[tuple[Told, str]]:
        """Yield the largest stress of each missed seat, by exact beams in space."""
        from flexcli.engine.joint_models.space_exact import SpaceExactModel

        return SpaceExactModel().misfit_stresses(ask, small)

    def envelope(self, ask: Ask) -> tuple["SweptBox", tuple[str, ...]]:
        """Return the box around the joint in space, and the bodies that have no outline."""
        from flexcli.engine.joint_models.space_box import exact_box

        return exact_box(ask)

    def parasitic_shift(self, ask: Ask) -> Computed:
        """Return the largest shift at the ends of the stroke alone, positive towards its −x."""
        return self._shift(ask)[0]

    def _shift(self, ask: Ask) -> tuple[float, float]:
        """Return the shift and its relative error."""
        return self._known_pairs.of("shift", ask, lambda: self._settled_shift(ask))

    def _settled_shift(self, ask: Ask) -> tuple[float, float]:
        if ask.scene.temperature is None:
            ask = alone(ask)
            shift, error = _worst_shift(self.states(ask), ask)
            return shift, error + DIGITS * lost(ask, shift)
        shift, least, most = combined(self.warm_shift(ask))
        return shift, max(1.0 - least / abs(shift), most / abs(shift) - 1.0) if shift else inf

    def warm_shift(self, ask: Ask) -> WarmShift:
        """Return what stroke and heat make of the shift, by beams."""
        return self._known_warm.of("warm shift", ask, lambda: warm_shift(ask, self._shifts_of(ask)))

    def _shifts_of(self, ask: Ask) -> Shifts:
        """Return how the shifts of layouts are found that are held somehow."""

        def find(layout: Layout, held: Held) -> tuple[Floats, Floats]:
            state = solved(
                layout, {MOVING: held}, effects=blades_of(layout, self.effects),
                tolerance=self.tolerance, levels=self.levels,
            )  # fmt: skip
            shifts = _moved_off(state, ask)
            if state.coarser is None:
                return shifts, np.full_like(shifts, inf)
            return shifts, shifts - _moved_off(state.coarser, ask)

        return find

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stress at both faces where it is greatest, blade by blade."""
        return "stress at the faces, bending with the axial force", self._judged(ask)[0]

    def _judged(self, ask: Ask) -> tuple[list[EndStress], float]:
        """Return the worst stresses of a case and the relative error of the largest."""
        return self._known_stresses.of("stress", ask, lambda: self._judge_stress(ask))

    def _judge_stress(self, ask: Ask) -> tuple[list[EndStress], float]:
        """Return them; the error is by how much they change from one level to the next.

        What lies between the places at which the stress is sampled counts besides, and what a
        temperature may add or relieve that rises through the thickness of blades, or makes bodies
        grow along the axis between blades at different heights; what blades that bend under their
        own weight do when they are bent and pulled already; and what hinges are beside beams.
        """
        state, scene = self.states(ask), ask.scene
        before, temperature, axes = state.coarser, scene.temperature, ask.geometry.axes
        change, most, found = 0.0, 0.0, list[EndStress]()
        weights, off, plates = BladeWeights.of(ask), 0.0, self._plates(ask)
        for index, blade in enumerate(state.layout.blades):
            fine = blade_stress(state, blade.name, POINTS)
            total = fine if plates is None else plates.added(index, fine)
            hinge, own = beside_beam(blade, fine), 0.0
            if hinge is not None:
                total = total._replace(bending=total.bending + hinge[0])
            if weights is not None:
                added = weights.stress(index)
                total = total._replace(
                    bending=total.bending + added[1], axial=total.axial + added[0]
                )
                own += weights.off(index, added, fine.axial, fine.bending, state.motions)
            faces = {"left": states_of(total.left), "right": states_of(total.right)}
            wide = None
            if plates is None and (scene.moves or temperature is not None):
                factors = factors_of_states if scene.moves else factors_of_warmth
                wide = factors(ask, blade, fine)
            found.extend(worst_of_stroke(ask, blade.name, faces, wide))
            here = largest_at_faces(faces)
            most = larger(most, here)
            if hinge is not None:
                own += largest_at_faces(faces, states_of(hinge[1])) - here
            off = larger(off, own)
            if before is not None:
                coarse = blade_stress(before, blade.name, POINTS)
                pairs = ((fine.left, coarse.left), (fine.right, coarse.right))
                changes = (states_of(np.abs(a - b)) for a, b in pairs)
                change = larger(change, *map(largest_of_each, changes))
        if temperature is not None and temperature.rises:
            strain = temperature.across_thickness(state.layout, ask.material, axes)
            change += ask.material.elastic.E * strain
        if temperature is not None:
            change += ask.material.elastic.E * sheared_across(state.layout)
        change += off
        if before is None or (most == 0.0 and change > 0.0):
            return found, inf
        own_off = SAMPLED if plates is None else SAMPLED + plates.unsure
        return found, (change / most if most else 0.0) + own_off

    def bent(self, ask: Ask) -> Bent:
        """Return what loads and heat bend, in a design nearby where there is one.

        Clamps that hold blades across change how stiff they are besides.
        """
        scene, about = ask.scene, ask if ask.near is None else ask.near._replace(scene=ask.scene)
        if not scene.is_loaded:
            return Bent(0.0)
        solver = exactly(self.effects, self.tolerance, self.levels)
        share = self._known_bent.of(
            "bent", about, lambda: bent_in_plane(about, self.states(about), solver)
        )
        if scene.temperature is None:
            return Bent(share)
        return Bent(share, held_bending(warmed(ask), ask.material.elastic.most_nu))

    def axial_stress(self, ask: Ask) -> float:
        """Return the largest stress of what pulls and pushes along blades."""
        found = range(len(self.states(ask).layout.blades))
        return max(float(np.abs(self.stress_along(ask, i, POINTS).axial).max()) for i in found)

    def stress_along(self, ask: Ask, index: int, points: int) -> BladeStress:
        """Return the stress along a blade in a case's states, at places on each of its pieces."""
        state, plates = self.states(ask), self._plates(ask)
        found = blade_stress(state, state.layout.blades[index].name, points)
        return found if plates is None else plates.added(index, found)

    def _plates(self, ask: Ask) -> PlateStresses | None:
        """Return what plates add to the stress of beams: nothing that beams know."""
        return None

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return the forces at which the joint buckles at any motion that the case holds."""
        find = partial(exact_critical, ask, self.effects, self.tolerance, self.levels)
        in_plane = self._known_critical.of("critical", ask, lambda: tuple(find()))
        return (*in_plane, *across_width(ask))

    def critical_shares(self, ask: Ask) -> tuple[CriticalShare, ...]:
        """Return the shares of temperature and loads together at which the joint buckles."""
        return tuple(warm_shares(ask, self.effects, self.tolerance, self.levels))


def alone(ask: Ask) -> Ask:
    """Return a stroke without what acts beside it, and without what holds the body."""
    scene = ask.scene
    if not scene.is_loaded and not hold_of(scene).turn:
        return ask
    return ask._replace(scene=scene.without_loads()._replace(ends=None, lock=None))


def lost(ask: Ask, shift: Number) -> Number:
    """Return how many times as large as a shift the travel is that makes it.

    A turn counts as what it moves on the shortest blade. Where blades cancel, so many digits of the
    travel are none of the shift's.
    """
    if shift == 0.0:
        return 0.0
    travel = larger(map(abs, ask.scene.stroke_ends))
    if ask.geometry.motion == "rotation":
        travel *= min(float(np.min(blade.length)) for blade in layout_of(ask).blades)
    return travel / abs(shift)


def hanging(ask: Ask) -> "Form":
    """Return how far a force along the case's acceleration moves the body's point, per force."""
    from flexcli.parts.requirements.support import deflection_form

    along = np.eye(6)["xyz".index(ask.scene.axis)]
    return deflection_form(ask, along, along)


def _worst_shift(state: Equilibrium, ask: Ask) -> tuple[float, float]:
    """Return the largest shift in a case's states and its relative error.

    Of a joint that is not its own mirror image it is not the same at both ends of a stroke.
    """
    shifts, before = states_of(shifts_of(state, ask)), state.coarser
    sizes = np.abs(shifts)
    sizes[1:] *= 1.0 - ALIKE  # of ends that are alike the first
    worst = np.argmax(sizes, axis=0)[None]
    shift = _of_worst(shifts, worst)
    if before is None or shift == 0.0:
        return shift, inf
    return shift, abs(_of_worst(states_of(shifts_of(before, ask)), worst) / shift - 1.0)


def _of_worst(shifts: Floats, worst: NDArray[np.intp]) -> float:
    """Return the shift of each design in the state that is its worst."""
    return of_each(np.atleast_1d(np.take_along_axis(shifts, worst, axis=0)[0]))


def shifts_of(state: MovedLayout, ask: Ask) -> Floats:
    """Return the shift of a pivot's centre, or a stage's point along its blades (states,) [m]."""
    x, y = _moved_off(state, ask).T
    return np.asarray(np.copysign(np.hypot(x, y), x))


def _moved_off(state: MovedLayout, ask: Ask) -> Floats:
    """Return how far a pivot's centre is off, of a stage along its blades, towards −x, −y [m]."""
    if ask.geometry.motion == "translation":
        moved = -point_motion(state, MOVING, state.layout.body(MOVING).point)
        return np.asarray(moved * [1.0, 0.0])
    return np.asarray(-point_motion(state, MOVING, (0.0, 0.0)))


def driven_stiffness(state: Equilibrium, ask: Ask) -> Floats:
    """Return the stiffness of the driven motion at equilibria that hold it (designs,)."""
    driven = 3 * state.layout.index(MOVING) + driven_axis(ask.geometry)
    index = state.parts[0].demand.held.tolist().index(driven)
    return np.asarray(held_stiffness(state)[:, index, index])
