"""The exact model of a mechanism in space: geometrically exact beams at stroke and under loads.

About rest it is the linear model.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from itertools import product
from math import inf, isfinite
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.beam_peaks import (
    beam_peaks,
    beam_swings,
    unsure_of_peaks,
    unsure_of_swings,
)
from flexcli.engine.joint_models.dead_loads import loads_of, signed
from flexcli.engine.joint_models.holds import hold_of
from flexcli.engine.joint_models.remembered import Remembered
from flexcli.engine.joint_models.space_critical import critical_shares, may_stand
from flexcli.engine.joint_models.space_deflection import deflections, warm_sag_ratio
from flexcli.engine.joint_models.space_errors import StrokeErrors, warping_errors, width_error
from flexcli.engine.joint_models.space_frequency import locked_frequency
from flexcli.engine.joint_models.space_linear import SpaceLinearModel
from flexcli.engine.joint_models.space_stroke import (
    BEAMS,
    Loads,
    at_travel,
    driven_coordinate,
    sag_of_drive,
    support_at_stroke,
    warm_ratio,
    warm_support_ratio,
)
from flexcli.errors import SolveError
from flexcli.formulas.amplified import FURTHER, amplified, bent_by_forces, bent_part
from flexcli.formulas.quantity import Computed
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.stresses import blade_stresses
from flexcli.mechanics.space.exact.support import support_compliance, vibration
from flexcli.mechanics.space.inertia import blade_masses
from flexcli.mechanics.space.states import Acting, Stresses, action, combined
from flexcli.mechanics.space.stresses import equivalent
from flexcli.parts.elastic import Buckled, NotAvailable
from flexcli.parts.own_motion import first_taking
from flexcli.parts.requirements import (
    Ask,
    CriticalShare,
    DriveEffort,
    EndStress,
    JointModel,
    MisfitStress,
    Told,
)
from flexcli.parts.scene import Scene
from flexcli.parts.space_joint import SpaceJoint, joint_of
from flexcli.parts.space_states import (
    SOFTENED,
    acting_groups,
    bent_by_gradient,
    moved_by_lengths,
    moved_by_moduli,
)
from flexcli.parts.strained_compliance import sag
from flexcli.parts.worst_places import worst_places
from flexcli.results import EXACT, ErrorRange, QuantityKind

if TYPE_CHECKING:
    from flexcli.mechanics.space.swept_box import SweptBox

__all__ = ["SpaceExactModel"]

Floats = NDArray[np.float64]

ROUGH = 0.02
"""By how much beams may bear too much that is not looked at further."""


class SpaceExactModel(SpaceLinearModel):
    """The linear model about rest, and exact beams at the ends of strokes."""

    name = "exact"
    at_stroke = JointModel.at_stroke
    blades = BEAMS
    """What blades are made of at the ends of strokes."""
    stress_kind = "nominal stress in space, von Mises"

    def __init__(self) -> None:
        super().__init__()
        self._stands: Remembered[bool] = Remembered()
        self._unsure: Remembered[tuple[ErrorRange | None, ErrorRange | None]] = Remembered()

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return the error of its numbers: of its blades, and of their level."""
        warm = ask.scene.temperature is not None
        if kind is QuantityKind.SHIFT and (ask.scene.moves or warm):
            return self._shift_error(ask)
        if kind is QuantityKind.STRESS:
            return self._stress_errors(ask)[0]
        if kind is QuantityKind.STIFFNESS and warm:
            own = super().error(ask, kind)
            try:
                strained = self._warm_stiffness(ask).error
            except NotAvailable:
                return None
            return None if own is None or strained is None else own + strained
        return super().error(ask, kind)

    def stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the motion, all else free, at the case's temperature."""
        if ask.scene.temperature is None:
            return super().stiffness(ask)
        joint = joint_of(ask, warm=False)
        travel = joint.assembly.moved(travel=np.ones(1))
        return float(travel.drive[0]) * self._warm_stiffness(ask).value

    def _sag(self, ask: Ask) -> Told:
        """Return the sag, with what a temperature strains makes of it."""
        if ask.scene.temperature is not None:
            with suppress(NotAvailable):
                return self._told.of("sag", ask, lambda: _warm_sag(ask))
        return super()._sag(ask)

    def _warm_stiffness(self, ask: Ask) -> Told:
        """Return what the strain of a temperature makes of the stiffness along the motion [-]."""
        return self._told.of("warm stiffness", ask, lambda: warm_ratio(ask, _free_stiffness))

    def warm_frequency_ratio(self, ask: Ask, *, locked: bool) -> tuple[float, ErrorRange | None]:
        """Return what the strain of a temperature makes of a frequency [-]."""
        what = f"warm frequency, {'locked' if locked else 'free'}"
        number = _lowest if locked else _own_frequency
        return self._told.of(what, ask, lambda: warm_ratio(ask, number, 0.0 if locked else None))

    def effort(self, ask: Ask) -> tuple[DriveEffort, ...]:
        """Return what the drive holds at both ends of the stroke, the loads in their worst sense.

        The stroke is from where they leave the joint with its drive free.
        """
        scene = ask.scene
        if not scene.moves:
            raise NotAvailable("has no force at stroke without a stroke")
        plain = [_effort(state) for state in self._ends(ask, warmth=0.0)]
        k, found = float(self.stiffness(ask)), []
        for end, travel in enumerate(scene.stroke_ends):
            each = []
            for states in self._loaded_ends(ask):
                state = states[end]
                pushed = abs(_travel(state) - travel) * k
                each.append(self._held(state, travel, plain[end], pushed))
            found.append(max(each, key=lambda one: one.effort + one.load))
        return tuple(found)

    def _held(
        self, state: SpaceEquilibrium, travel: float, plain: float, load: float
    ) -> DriveEffort:
        """Return what a drive holds in a state, ``plain`` what it would without loads and heat."""
        effort, known, error = _effort(state), self.blades.errors(state), None
        if state.coarser is not None and known is not None and effort != 0.0:
            # what loads and heat change of it is as unsure as what they change it from
            most = max(abs(effort), abs(plain)) + abs(effort - plain)
            off = (abs(_effort(state.coarser) - effort) + known.support * most) / abs(effort)
            error = ErrorRange(-float(off), float(off))
        return DriveEffort(travel, -effort if travel < 0.0 else effort, error, load)

    def support_at_stroke(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the support stiffness at both ends of the stroke, the drive locked or free."""
        return support_at_stroke(ask, index, point, locked=locked, blades=self.blades)

    def warm_support_ratio(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> Told:
        """Return the ratio by exact beams in space."""
        return warm_support_ratio(ask, index, point, locked=locked)

    def deflections(
        self, ask: Ask, point: tuple[float, float, float], direction: str
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return how far the wrench moves a point, by exact beams."""
        return deflections(ask, point, direction)

    def misfit_stresses(
        self, ask: Ask, small: Sequence[MisfitStress]
    ) -> Iterator[tuple[Told, str]]:
        """Yield the largest stress of each missed seat, by beams or shells."""
        from flexcli.engine.joint_models.space_misfit import StressModel, misfit_stresses

        model = StressModel(self.blades, self.largest_stress, self.unsure_stress)
        return misfit_stresses(ask, small, model)

    def parasitic_frequency_at_stroke(
        self, ask: Ask
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the lowest frequency at both ends of the stroke, the drive locked."""
        both = zip(self._ends(ask), self._ends(ask, warmth=0.0), strict=True)
        return tuple(locked_frequency(ask, state, cold, self.blades) for state, cold in both)

    def parasitic_shift(self, ask: Ask) -> Computed:
        """Return how far the driven point, or the axis, leaves its path at the stroke's ends."""
        return max(_shift(state) for state in self._ends(ask))

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stress of stroke, loads and temperature together.

        The loads act either way; a stroke is from where they leave the joint with its drive free.
        """
        found: list[EndStress] = []
        for ends in self._loaded_ends(ask):
            first, last = (self.signed_stresses(state) for state in (ends[0], ends[-1]))
            swings = self.swings(ends[0], ends[-1])
            for name, one in first.items():
                amplitude, mean = np.abs(one - last[name]) / 2.0, (one + last[name]) / 2.0
                if name in swings:
                    # where shear leads, the sign of the normal stress tells nothing of its swing
                    lost = swings[name] > amplitude
                    most = np.maximum(np.abs(one), np.abs(last[name]))
                    amplitude = np.minimum(swings[name], most)
                    mean = np.where(lost, most - amplitude, np.copysign(most - amplitude, mean))
                found.extend(
                    EndStress(name, float(amplitude[i]), float(mean[i]), 0.0, is_at_face=True)
                    for i in dict.fromkeys(map(int, worst_places(amplitude, mean)))
                )
        return self.stress_kind, found

    def signed_stresses(self, state: SpaceEquilibrium) -> dict[str, Floats]:
        """Return von Mises' stress at places of each blade, signed as the normal stress [Pa]."""
        return beam_peaks(blade_stresses(state))

    def swings(self, first: SpaceEquilibrium, last: SpaceEquilibrium) -> dict[str, Floats]:
        """Return half of von Mises' stress of what changes from one state to another [Pa]."""
        return beam_swings(blade_stresses(first), blade_stresses(last))

    def largest_stress(self, state: SpaceEquilibrium) -> tuple[float, str]:
        """Return the largest stress of the blades [Pa], and the blade that has it."""
        found = self.signed_stresses(state)
        return max((float(np.max(np.abs(each))), name) for name, each in found.items())

    def unsure_stress(self, state: SpaceEquilibrium, largest: float) -> ErrorRange:
        """Return how unsure the largest stress of a state is besides: by restrained warping."""
        return unsure_of_peaks(blade_stresses(state), warping_errors(state))

    def unsure_swing(self, first: SpaceEquilibrium, last: SpaceEquilibrium) -> ErrorRange:
        """Return how unsure the largest swing of a stroke is besides."""
        both = zip(warping_errors(first), warping_errors(last), strict=True)
        errors = [one if one.low < other.low else other for one, other in both]  # what curls more
        return unsure_of_swings(blade_stresses(first), blade_stresses(last), errors)

    def envelope(self, ask: Ask) -> tuple["SweptBox", tuple[str, ...]]:
        """Return the box around it by exact beams, and the bodies that have no outline."""
        from flexcli.engine.joint_models.space_box import exact_box

        return exact_box(ask)

    def critical_shares(self, ask: Ask) -> tuple[CriticalShare, ...]:
        """Return the shares of the loads that buckle it: drive locked at a stroke, else free."""
        return tuple(critical_shares(ask, self.blades))

    def knows_critical_shares(self, ask: Ask) -> bool:
        """Return whether its blades have errors at the ends of the stroke, before loads act."""
        with suppress(NotAvailable, SolveError):
            ends = (at_travel(ask, end, self.blades, warmth=0.0) for end in ask.scene.stroke_ends)
            found = [self.blades.errors(state) for state in ends]
            return all(known is not None and isfinite(known.support) for known in found)
        return True

    def _ends(
        self, ask: Ask, loads: Loads = (), stroke: float = 1.0, warmth: float = 1.0
    ) -> tuple[SpaceEquilibrium, ...]:
        """Return the joint at both ends of its stroke, or as loads and temperature leave it.

        ``stroke`` is the share of it that is gone, ``warmth`` that of what heat strains.
        """
        scene, hold = ask.scene, hold_of(ask.scene)
        at = partial(at_travel, ask, blades=self.blades, warmth=warmth, hold=hold)
        if not scene.moves:
            return (at(None, loads=loads),)
        sag = sag_of_drive(ask, loads, self.blades, warmth=warmth) if loads else 0.0
        travels = tuple(stroke * end + sag for end in scene.stroke_ends)
        ends = tuple(at(travel, loads=loads) for travel in travels)
        levels = [state.part.assembly.members.level for state in ends]
        if levels[0] == levels[1]:
            return ends
        # stress is compared place by place, which takes as fine blades at both ends
        coarse = levels.index(min(levels))
        name = f"{self.blades.name}, {max(levels)} for {min(levels)}"
        alike = self.blades._replace(name=name, levels=tuple(sorted(levels)))
        finer = at_travel(ask, travels[coarse], alike, loads=loads, warmth=warmth, hold=hold)
        return (finer, ends[1]) if coarse == 0 else (ends[0], finer)

    def _loaded_ends(self, ask: Ask) -> Iterator[tuple[SpaceEquilibrium, ...]]:
        """Yield the joint at the ends of its stroke, its loads acting in one sense or another.

        Raises
        ------
        Buckled
            Where the loads make it lose its stability on their way.

        """
        for signs, loads in _senses(ask):
            try:
                ends = self._ends(ask, loads)
            except (NotAvailable, SolveError):
                self._prove_buckled(ask, signs)
                raise
            yield ends

    def _prove_buckled(self, ask: Ask, signs: tuple[float, ...]) -> None:
        """Raise :class:`Buckled` where loads of these signs do, at the least share of any sense.

        Each requirement of a case asks: the path of its loads is walked once.
        """
        each = {other: partial(may_stand, ask, self.blades, loads) for other, loads in _senses(ask)}
        try:
            self._stands.of(f"{signs}", ask, each.pop(signs))
        except Buckled as first:
            found = [first]
            for other, stands in each.items():
                try:
                    self._stands.of(f"{other}", ask, stands)
                except Buckled as buckled:
                    found.append(buckled)
                except NotAvailable:
                    continue
            raise min(found, key=lambda buckled: buckled.share) from first

    def _bends(self, ask: Ask) -> Iterator[float]:
        """Yield, sense by sense of the loads, what these, heat and stroke bend of the stress."""
        largest, less, more = partial(self._largest_at_ends, ask), None, 1.0 + FURTHER
        rest = largest(warmth=0.0)
        if ask.scene.moves:
            less = largest(warmth=0.0, stroke=1.0 - FURTHER)
        for _, loads in _senses(ask):
            here, raised = largest(loads), tuple(load.times(more) for load in loads)
            further = largest(raised, warmth=more)
            yield float(np.max(bent_by_forces(rest, less, here, further)))

    def _largest_at_ends(
        self, ask: Ask, loads: Loads = (), stroke: float = 1.0, warmth: float = 1.0
    ) -> Floats:
        """Return the largest stress at the ends of so much of a stroke (ends,) [Pa]."""
        ends = self._ends(ask, loads, stroke, warmth)
        return np.array([self.largest_stress(state)[0] for state in ends])

    def _at_ends(
        self,
        ask: Ask,
        error: Callable[[StrokeErrors], float],
        number: Callable[[SpaceEquilibrium], float],
    ) -> ErrorRange | None:
        """Return an error with what a number changes from the level before."""
        try:
            ends = self._ends(ask)
            most = _most_off(ends, [self.blades.errors(state) for state in ends], error, number)
        except (NotAvailable, SolveError):
            return None
        return None if most is None else ErrorRange(-most, most)

    def _shift_error(self, ask: Ask) -> ErrorRange | None:
        """Return the error of the motion beside the stroke.

        Uneven sections count, and what shortening leaves where it cancels.
        """
        found = self._at_ends(ask, lambda errors: errors.shift, _shift)
        if found is None:
            return None
        joint, states = joint_of(ask), self._ends(ask)
        rest = float(np.linalg.norm(bent_by_gradient(joint, ask.scene)[1][:3]))
        if ask.scene.temperature is not None:
            lengths = moved_by_lengths(joint, ask.scene, ask.material)[1]
            lengths = lengths + moved_by_moduli(joint, ask.scene, ask.material, ask.geometry.axes)
            bent = self._bent_of_shift(ask)
            if not isfinite(bent):
                return None
            rest += float(np.linalg.norm(lengths[:3])) + bent
        rest += max(known.rest for known in map(self.blades.errors, states) if known is not None)
        least = min(_shift(state) for state in states)
        return found + ErrorRange(-rest / least, rest / least)

    def _bent_of_shift(self, ask: Ask) -> float:
        """Return how far what heat bends of the motion beside the stroke may be off [m]."""
        off = 0.0
        try:
            each = [self._ends(ask, warmth=share) for share in (0.0, 1.0, 1.0 + FURTHER)]
            for ends in zip(*each, strict=True):
                rest, here, further = map(_off_path, ends)
                known, size = self.blades.errors(ends[1]), float(np.linalg.norm(here))
                bent = float(np.linalg.norm(bent_part(rest, here, further)))
                if known is None:
                    return inf
                off = max(off, size * amplified(bent / size, known.support) if bent else 0.0)
        except (NotAvailable, SolveError):
            return inf
        return off

    def swing_error(self, ask: Ask) -> ErrorRange | None:
        """Return the error of the largest amplitude of a stroke."""
        return self._stress_errors(ask)[1] if ask.scene.moves else None

    def _stress_errors(self, ask: Ask) -> tuple[ErrorRange | None, ErrorRange | None]:
        return self._unsure.of("stress", ask, lambda: self._find_stress_errors(ask))

    def _find_stress_errors(self, ask: Ask) -> tuple[ErrorRange | None, ErrorRange | None]:
        """Return the error of the largest stress, and that of the largest amplitude.

        They are of blades and level, of what forces bend in them, and of the blades' weight.

        That acts on the bodies; what it does between the ends of a blade counts as if it were
        largest where the stress is.
        Beams and shells differ by the strain itself where that is large: by 0.9 of it at 0.04.
        """
        joint = joint_of(ask)
        beside = sum(_stress_of_weight(joint, each) for each in acting_groups(joint, ask.scene))
        beside += bent_by_gradient(joint, ask.scene)[0]
        most, unsure, largest, lengths = 0.0, beside, 0.0, 0.0
        least_warped = most_warped = 0.0
        swing = EXACT
        if ask.scene.temperature is not None:
            lengths = moved_by_lengths(joint, ask.scene, ask.material)[0]
        if self.blades is BEAMS and _may_turn_aside(joint, ask.scene):
            return None, None
        beams = self if self.blades is BEAMS else SpaceExactModel()  # which tell it for shells
        try:
            bends = beams._bends(ask)
            for ends in self._loaded_ends(ask):
                told = [self.blades.errors(state) for state in ends]
                # of hinges beams know no stress, whatever bends them
                in_vain = any(each is None or not isfinite(each.stress) for each in told)
                bent = 0.0 if in_vain else next(bends)
                known = _most_off(
                    ends, told, partial(StrokeErrors.stress_of, bent=bent),
                    lambda state: self.largest_stress(state)[0],
                )  # fmt: skip
                if known is None:
                    return None, None
                most = max(most, known)
                if ask.scene.moves:
                    own_swing = self.unsure_swing(ends[0], ends[-1])
                    low, high = min(swing.low, own_swing.low), max(swing.high, own_swing.high)
                    swing = ErrorRange(low, high)
                # what is bent once more amplifies what lengths leave as it does all else
                own = beside + lengths * (1.0 + bent) ** 2
                for state in ends:
                    here = self.largest_stress(state)[0]
                    warped = self.unsure_stress(state, here)
                    largest, unsure = max(largest, here), max(unsure, own)
                    least_warped = max(least_warped, here * (1.0 + warped.low))
                    most_warped = max(most_warped, here * (1.0 + warped.high))
        except (NotAvailable, SolveError):
            return None, None
        if self.blades is BEAMS:
            most += largest / ask.material.elastic.E
        off, swung = most + unsure / largest, beside / largest
        warped = ErrorRange(least_warped / largest - 1.0, most_warped / largest - 1.0)
        return (
            warped + ErrorRange(-off, off),
            ErrorRange(-most + min(swing.low, -swung), most + max(swing.high, swung)),
        )


def _may_turn_aside(joint: SpaceJoint, scene: Scene) -> bool:
    """Return whether loads nearly turn blades aside that are so wide that beams bear too much."""
    states = [action(joint.assembly, each) for each in acting_groups(joint, scene)]
    for signs in product((1.0, -1.0), repeat=len(states)):
        both = combined(states, list(signs)) if states else None
        more = 0.0 if both is None else width_error(joint.assembly, both.moved.forces[:, 0])
        if both is None or more < ROUGH:
            continue
        if both.following().buckling * max(SOFTENED * (1.0 + more), 1.0) > SOFTENED:
            return True
    return False


def _senses(ask: Ask) -> Iterator[tuple[tuple[float, ...], Loads]]:
    """Yield the signs of the loads of a case, each of which acts either way, and all so."""
    joint = joint_of(ask)
    groups = [loads_of(joint, each) for each in acting_groups(joint, ask.scene)]
    for signs in product((1.0, -1.0), repeat=len(groups)):
        yield signs, tuple(signed(groups, signs))


def _most_off(
    states: Iterable[SpaceEquilibrium],
    errors: Iterable[StrokeErrors | None],
    error: Callable[[StrokeErrors], float],
    number: Callable[[SpaceEquilibrium], float],
) -> float | None:
    """Return the largest error of a number in states, with what it changes from level to level.

    ``errors`` are those of the states.
    """
    most = 0.0
    for state, known in zip(states, errors, strict=True):
        found = number(state)
        if state.coarser is None or known is None or found == 0.0:
            return None
        most = max(most, abs(number(state.coarser) / found - 1.0) + error(known))
    return most


def _stress_of_weight(joint: SpaceJoint, acting: Acting) -> float:
    """Return the largest stress of the blades' weight between ends that do not move [Pa]."""
    if not np.any(acting.acceleration):
        return 0.0
    masses = blade_masses(joint.assembly)
    weights = np.array(
        [
            member.axes @ acting.acceleration * mass / member.l
            for member, mass in zip(joint.assembly.members, masses, strict=True)
        ]
    )
    found = Stresses(joint.assembly).of(np.zeros(len(joint.assembly.rows)), weights)
    return max(float(np.max(equivalent(each.normal, each.shear))) for each in found)


def _warm_sag(ask: Ask) -> Told:
    """Return the sag at a temperature: unstrained, times what the strain makes of a small one."""
    ratio, error = warm_sag_ratio(ask)
    return sag(joint_of(ask, warm=False), ask.scene).times(ratio, error)


def _free_stiffness(state: SpaceEquilibrium) -> float:
    """Return the stiffness along the drive's motion, the drive free."""
    drive = state.layout.drive
    C = support_compliance(state, drive.body, drive.point)
    return float(1.0 / (drive.motion @ C @ drive.motion))


def _lowest(state: SpaceEquilibrium) -> float:
    """Return the lowest frequency of all [Hz]."""
    return float(vibration(state).frequency[0, 0])


def _own_frequency(state: SpaceEquilibrium) -> float:
    """Return the lowest frequency that the drive's own motion takes part in [Hz]."""
    found = vibration(state)
    row = found.shapes[0][driven_coordinate(state.layout)]
    frequency = found.frequency[0]
    compliance = (row / frequency) ** 2
    first = first_taking(compliance, compliance.sum())
    assert first is not None  # one of them takes as much
    return float(frequency[first])


def _travel(state: SpaceEquilibrium) -> float:
    """Return where the drive is in a state [m or rad]."""
    return float(state.coordinates.ravel()[driven_coordinate(state.layout)])


def _effort(state: SpaceEquilibrium) -> float:
    """Return what holds the drive at an equilibrium [N or N·m]."""
    return float(state.reactions.ravel()[driven_coordinate(state.layout)])


def _shift(state: SpaceEquilibrium) -> float:
    """Return how far the driven point leaves its path [m]."""
    return float(np.linalg.norm(_off_path(state)))


def _off_path(state: SpaceEquilibrium) -> Floats:
    """Return how the driven point leaves its path (3,) [m]."""
    drive = state.layout.drive
    moved = state.motion_of(drive.body, drive.point)[:3]
    if not drive.turns:
        along = np.asarray(drive.direction)
        moved = moved - (moved @ along) * along
    return np.asarray(moved)
