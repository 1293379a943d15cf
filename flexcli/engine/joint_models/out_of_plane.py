"""Loads out of a joint's plane: their stress by linear blades in space, on top of a planar model.

The stress of such a load is that at rest, added to the planar one as if both were largest at the
same place; the true one is no less than either. What the stroke changes in it is estimated by
the second order of both together. Where that leaves much, or blades bend aside under such a load,
exact beams in space take all of a case together. So they do where what acts in the plane tilts the
body, as blades stand side by side.
"""

from functools import partial
from math import inf
from typing import NamedTuple

from flexcli.engine.joint_models.built_on import BuiltOn
from flexcli.engine.joint_models.leaving_plane import leaving_plane
from flexcli.engine.joint_models.remembered import Remembered
from flexcli.engine.joint_models.space_exact import SpaceExactModel
from flexcli.engine.joint_models.space_linear import SpaceLinearModel
from flexcli.formulas.quantity import Computed
from flexcli.numerics.rows import design_by_design, isfinite, larger, number, smaller
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import Setting
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Critical
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.requirements import (
    Ask,
    CriticalShare,
    DriveEffort,
    EndStress,
    JointModel,
    Swing,
)
from flexcli.parts.space_joint import joint_in_space
from flexcli.parts.stress_across import AcrossStress, across_stress
from flexcli.parts.tilted_joint import Tilt, least_frequency, tilt_of
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["OutOfPlane"]

UNKNOWN = ErrorRange(-1.0, inf)
"""Of a share whose error nobody knows, for which that of the planar model is not taken."""

NARROW = 0.03
"""Width of the range of a sum from which on exact beams are asked whether they know better."""

SWINGING = 0.06
"""Width of an error of exact beams up to which they tell a stroke beside loads across it."""

OF_TILT = 0.2
"""Error of what a tilt changes of a stiffness: exact beams in space differ by 0.04 of it."""

OF_STRAIN = {
    QuantityKind.STRESS: QuantityKind.STRESS,
    QuantityKind.STIFFNESS: QuantityKind.STIFFNESS,
    QuantityKind.FREQUENCY: QuantityKind.STIFFNESS,
}
"""What is told in space of a joint that a temperature tilts, and the kind of number it is there."""

FINEST = ("exact", "shell")
"""Models beside which exact beams in space are no more than what was asked for."""


class _Parts(NamedTuple):
    """The planar stresses of a case, and what the loads out of the plane add to the largest."""

    name: str
    planar: list[EndStress]
    across: AcrossStress

    @property
    def largest(self) -> float:
        """Return the largest planar stress [Pa]."""
        return max((abs(float(s.largest)) for s in self.planar), default=0.0)


class OutOfPlane(BuiltOn):
    """A planar model with the stress of the loads out of the plane added."""

    def __init__(self, inner: JointModel) -> None:
        self.inner = inner
        self.name = inner.name
        self.directs_blades = inner.directs_blades
        self.directs_in_plane = inner.directs_in_plane
        self._known: Remembered[_Parts] = Remembered()
        self._across: Remembered[AcrossStress] = Remembered()
        self._told_by_beams: Remembered[bool] = Remembered()
        self._tilts: Remembered[Tilt] = Remembered()
        self._rocking: Remembered[float] = Remembered()
        self._space = _in_space(inner.name)
        self._is_finest = inner.name in FINEST
        self.at_stroke = inner.at_stroke if self._space is None else self._space.at_stroke

    def shares(self, other: JointModel) -> None:
        """Share the stress of loads across, which has nothing of the plane, and beams in space."""
        if not isinstance(other, OutOfPlane):
            return
        self._across = other._across
        if self._is_finest and other._is_finest:
            self._space = other._space
        self.inner.shares(other.inner)

    def carried(self, setting: Setting) -> frozenset[EffectName]:
        """Return the effects of the planar model."""
        return self.inner.carried(setting)

    def frequency_factor(self, ask: Ask) -> float:
        """Return the planar model's."""
        return self.inner.frequency_factor(ask)

    def stiffness(self, ask: Ask) -> Computed:
        """Return the planar model's, the body free to tilt."""
        strained = self._strained(ask)
        if strained is not None:
            return strained.stiffness(ask)
        tilt = self._tilt(ask)
        return self.inner.stiffness(ask) * (1.0 if tilt is None else tilt.stiffness)

    def effort(self, ask: Ask) -> tuple[DriveEffort, ...]:
        """Return the planar model's; under loads out of the plane, that of exact beams in space.

        A body that tilts is softer at rest; at a stroke it is pushed back by no less than that, nor
        by more than an upright one.
        """
        strained = self._strained(ask)
        if strained is not None:
            return strained.effort(ask)
        if not ask.scene.across_by:
            tilt = self._tilt(ask)
            if tilt is None or tilt.stiffness == 1.0:
                return self.inner.effort(ask)
            softer = 1.0 - tilt.stiffness
            if self._space is not None and self._is_finest and softer > NARROW:
                return self._space.effort(ask)
            tilted = ErrorRange(-(1.0 + OF_TILT) * softer, OF_TILT * softer)
            return tuple(
                each._replace(error=None if each.error is None else each.error + tilted)
                for each in self.inner.effort(ask)
            )
        if self._space is None:
            raise NotAvailable("has no force at stroke under loads out of its plane")
        whole = self._space.effort(ask)
        if ask.scene.tilts or max(map(_width, whole)) <= NARROW:
            return whole
        in_plane = ask._replace(scene=ask.scene.in_plane())
        planar, without = self.inner.effort(in_plane), self._space.effort(in_plane)
        summed = map(_with_change, planar, without, whole)
        return tuple(min(pair, key=_width) for pair in zip(whole, summed, strict=True))

    def sag_stiffness(self, ask: Ask) -> Computed:
        """Return the planar model's, which has that along z."""
        return self.inner.sag_stiffness(ask)

    def sags(self, ask: Ask) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the planar model's, which has those along z."""
        return self.inner.sags(ask)

    def parasitic_shift(self, ask: Ask) -> Computed:
        """Return the planar model's."""
        return self.inner.parasitic_shift(ask)

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return the planar model's, and those of drawn joints that a force turns out of it."""
        space = self._space if isinstance(self._space, SpaceExactModel) else None
        return *self.inner.critical(ask), *leaving_plane(ask, space=space)

    def critical_shares(self, ask: Ask) -> tuple[CriticalShare, ...]:
        """Return those of all loads in space; of a joint that stays in its plane the planar's."""
        if not ask.scene.across_by and self._strained(ask) is None:
            return self.inner.critical_shares(ask)
        if self._space is None:
            raise NotAvailable("has no buckling under loads out of its plane")
        return tuple(
            share if share.error is not None else share._replace(error=UNKNOWN)
            for share in self._space.critical_shares(ask)
        )

    def knows_critical_shares(self, ask: Ask) -> bool:
        """Return whether blades in space have errors."""
        return self._space is None or self._space.knows_critical_shares(ask)

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the planar stresses, that of the loads out of the plane on top of each.

        These act either way, so that they make more of a mean in tension and in compression.
        """
        if not ask.scene.across_by:
            tilted = self._tilted_beams(ask)
            return self.inner.stresses(ask) if tilted is None else tilted.stresses(ask)
        if ask.scene.on_bodies:
            return self._whole().stresses(ask)
        beams = self._beams(ask)
        if beams is not None:
            return beams.stresses(ask)
        parts = self._parts(ask)
        across, found = parts.across.value, list[EndStress]()
        for stress in parts.planar or [EndStress("blade", 0.0, 0.0, 0.0)]:
            found.append(stress._replace(axial=stress.axial + across))
            if stress.is_at_face and float(stress.mean + stress.axial) < 0.0:
                found.append(stress._replace(axial=stress.axial - across))
        return f"{parts.name}, with that of the loads out of the plane", found

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return the planar model's error; of a stress, that of what tells it."""
        if ask.scene.on_bodies and kind is QuantityKind.STRESS:
            return None if self._space is None else self._space.error(ask, kind)
        if kind is not QuantityKind.STRESS or not ask.scene.across_by:
            return self._with_tilt(ask, kind, self.inner.error(ask, kind))
        try:
            beams = self._beams(ask)
            return self._sum_error(ask) if beams is None else _on_roots(ask, beams.error(ask, kind))
        except NotAvailable:
            return None

    def swing_error(self, ask: Ask) -> ErrorRange | None:
        """Return the error of an amplitude where beams in space tell it."""
        space = self._space
        if space is None:
            return None
        if not ask.scene.across_by:
            told = self._tilted_beams(ask)
        else:
            told = space if ask.scene.on_bodies else self._beams(ask)
        return None if told is None else _on_roots(ask, told.swing_error(ask))

    def _with_tilt(
        self, ask: Ask, kind: QuantityKind, planar: ErrorRange | None
    ) -> ErrorRange | None:
        """Return the error of a number of the plane with what a tilt of the body may change."""
        strained = self._strained(ask)
        if strained is not None and kind in OF_STRAIN:
            return self._of_strained(ask, kind, strained)
        tilt = self._tilt(ask)
        if tilt is None or planar is None:
            return planar
        if kind is QuantityKind.STRESS:
            tilted = self._tilted_beams(ask)
            if tilted is not None:
                return _on_roots(ask, tilted.error(ask, kind))
            most = self._share_of_tilt(ask, tilt)
            return planar + ErrorRange(0.0, most) if isfinite(most) else None
        if kind in (QuantityKind.STIFFNESS, QuantityKind.FREQUENCY):
            off = OF_TILT * abs(tilt.stiffness - 1.0)
            planar += ErrorRange(-off, off)
        if kind is QuantityKind.FREQUENCY:
            return self._with_rocking(ask, planar)
        return planar

    def _of_strained(
        self, ask: Ask, kind: QuantityKind, space: SpaceLinearModel
    ) -> ErrorRange | None:
        """Return the error of a number that exact beams tell of a joint which a temperature tilts.

        A frequency is that of their stiffness, and of masses as in the plane.
        """
        try:
            known = space.error(ask, OF_STRAIN[kind])
        except NotAvailable:
            return None
        if kind is QuantityKind.STRESS:
            return _on_roots(ask, known)
        if known is None or kind is not QuantityKind.FREQUENCY:
            return known
        planar = self.inner.error(ask._replace(scene=ask.scene.at_assembly()), kind)
        if planar is None:
            return None
        low, high = (max(1.0 + end, 0.0) ** 0.5 - 1.0 for end in known)
        return self._with_rocking(ask, planar + ErrorRange(low, high))

    def _with_rocking(self, ask: Ask, planar: ErrorRange) -> ErrorRange | None:
        """Return the error of a frequency, down to that of a mode in which the body rocks as well.

        Blades that pull at nothing by a stroke leave its motion out of the modes that tilt.
        """
        if not ask.geometry.may_tilt(loaded=False):
            return planar
        asked = ask.geometry, ask.material, ask.sizes, ask.mechanism
        find = partial(
            design_by_design, least_frequency, *asked, name="rocking", about=ask.geometry
        )
        try:
            least = self._rocking.of("rocking", ask, find)
            own = number(self.frequency_squared(ask)) ** 0.5
        except (MechanismError, NotAvailable):
            return planar
        return ErrorRange(smaller(planar.low, least / own - 1.0), planar.high)

    def _tilt(self, ask: Ask) -> Tilt | None:
        """Return what a tilt of the body changes; None where nothing tilts it, or it is held."""
        if not ask.scene.tilts:
            return None
        asked = ask.geometry, ask.material, ask.sizes, ask.scene
        find = partial(design_by_design, tilt_of, *asked, name="tilt", about=ask.scene)
        return self._tilts.of("tilt", ask, find)

    def _strained(self, ask: Ask) -> SpaceLinearModel | None:
        """Return exact beams in space where what a temperature strains tilts the body.

        Bodies and blades that do not fit pull at different heights; kept upright they would be
        strained by more.
        """
        warm = ask.scene.tilts and ask.scene.temperature is not None
        return self._space if warm and self._is_finest else None

    def _tilted_beams(self, ask: Ask) -> SpaceLinearModel | None:
        """Return exact beams in space, where they know the stress of a joint that tilts."""
        space, tilt = self._space, self._tilt(ask)
        if space is None or not self._is_finest or tilt is None:
            return None
        if self._strained(ask) is not None:
            return space
        if self._share_of_tilt(ask, tilt) <= NARROW:
            return None
        find = partial(self._is_told_tilted, ask, space)
        return space if self._told_by_beams.of("tilted beams", ask, find) else None

    def _share_of_tilt(self, ask: Ask, tilt: Tilt) -> float:
        """Return what a tilt adds at most to the largest stress, or to its largest amplitude."""
        found = self.inner.stresses(ask)[1]
        own = larger([0.0, *(number(abs(stress.largest)) for stress in found)])
        swung = larger([0.0, *(number(abs(stress.amplitude)) for stress in found)])
        shares = ((tilt.stress, own), (tilt.amplitude, swung))
        return larger([0.0, *(more / of if of else inf for more, of in shares if more)])

    def _is_told_tilted(self, ask: Ask, space: SpaceLinearModel) -> bool:
        try:
            return space.error(ask, QuantityKind.STRESS) is not None
        except NotAvailable:
            return False

    def _sum_error(self, ask: Ask) -> ErrorRange | None:
        """Return the error of the planar stress with that of the loads out of the plane.

        Both are added as if largest at one place: together they are no less than either.
        """
        planar, parts = self.inner.error(ask, QuantityKind.STRESS), self._parts(ask)
        across, error = parts.across.value, parts.across.error
        if planar is None or error is None:
            return None
        a, b = parts.largest, across
        if a + b == 0.0:
            return planar
        low = max(a * (1.0 + planar.low), b * (1.0 + error.low)) / (a + b) - 1.0
        return ErrorRange(low, (a * (1.0 + planar.high) + b * (1.0 + error.high)) / (a + b) - 1.0)

    def swing(self, ask: Ask) -> Swing | None:
        """Return what is known of the amplitude beside the added stress: both act on each other.

        A sum has a small error beside a large steady load, and that may be all of the amplitude.
        """
        scene = ask.scene
        if not scene.across_by or scene.travel == 0.0 or self._beams(ask) is not None:
            return None
        own, across = self.inner.error(ask, QuantityKind.STRESS), self._parts(ask).across
        if own is None or across.error is None:
            return None
        return Swing(own, abs(across.value), across.error, across.swings)

    def _whole(self) -> SpaceLinearModel:
        """Return the model of a mechanism that is judged in space alone."""
        if self._space is None:
            raise NotAvailable("has no closed form for a locked mechanism accelerated off x")
        return self._space

    def _beams(self, ask: Ask) -> SpaceLinearModel | None:
        """Return exact beams where they say more: of hinges' stress they know no error."""
        space = self._space
        if space is None or not self._is_finest:
            return None
        find = partial(self._is_told_by_beams, ask, space)
        told = self._told_by_beams.of("beams", ask, find)
        return space if told else None

    def _is_told_by_beams(self, ask: Ask, space: SpaceLinearModel) -> bool:
        if not joint_in_space(ask.geometry, ask.material, ask.sizes).is_uniform:
            return False
        summed = self._sum_error(ask)
        if summed is None:
            return True
        swings, width = ask.scene.travel > 0.0, summed.high - summed.low
        if width <= NARROW and not swings:
            return False
        whole = space.error(ask, QuantityKind.STRESS)
        # of a sum nobody knows what is the amplitude's
        most = max(width, SWINGING) if swings else width
        return whole is not None and whole.high - whole.low <= most

    def _parts(self, ask: Ask) -> _Parts:
        return self._known.of("parts", ask, lambda: self._find(ask))

    def _find(self, ask: Ask) -> _Parts:
        name, planar = "stress", list[EndStress]()
        if ask.scene.moves or ask.scene.is_loaded:
            name, planar = self.inner.stresses(ask)
        joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
        across = self._across.of("across", ask, lambda: across_stress(joint, ask.scene))
        return _Parts(name, planar, across)


def _width(effort: DriveEffort) -> float:
    """Return how wide the range of a drive's effort is, infinite where nobody knows it [-]."""
    return inf if effort.error is None else effort.error.high - effort.error.low


def _with_change(planar: DriveEffort, without: DriveEffort, whole: DriveEffort) -> DriveEffort:
    """Return a planar effort with what beams in space say that loads out of the plane change.

    That change may be off by itself: of notches beams know less than the planar model.
    """
    change = whole.effort - without.effort
    effort, error = planar.effort + change, None
    if planar.error is not None and effort != 0.0:
        low, high = sorted(planar.effort * end for end in planar.error)
        low, high = sorted(((low - abs(change)) / effort, (high + abs(change)) / effort))
        error = ErrorRange(low, high)
    return whole._replace(effort=effort, error=error)


def _on_roots(ask: Ask, error: ErrorRange | None) -> ErrorRange | None:
    """Return the error of a stress of beams in space on roots that may give way in its plane."""
    nu = ask.material.elastic.most_nu
    if error is None or ask.geometry.root_springs(ask.sizes, nu) is None:
        return error
    clamped = ask.geometry.compliant_clamps(ask.sizes, nu)
    assert clamped is not None  # it has roots
    least, most = clamped.stress
    if ask.scene.is_loaded:
        least, most = min(least, 1.0 / (1.0 + clamped.loaded) - 1.0), max(most, clamped.loaded)
    if not isfinite(most):
        return None
    low, high = (1.0 + error.low) * (1.0 + least), (1.0 + error.high) * (1.0 + max(most, 0.0))
    return ErrorRange(low - 1.0, high - 1.0)


def _in_space(name: str) -> SpaceLinearModel | None:
    """Return the model of the whole joint in space beside a planar one, which it may not have."""
    if name in FINEST:
        return SpaceExactModel()
    return SpaceLinearModel() if name == SpaceLinearModel.name else None
