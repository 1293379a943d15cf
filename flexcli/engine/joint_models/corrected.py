"""A model with corrections for effects that it does not carry itself: each by its formula, once."""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from math import inf
from typing import TYPE_CHECKING

import numpy as np

from flexcli.engine.joint_models.remembered import Remembered
from flexcli.engine.joint_models.wide_under_force import change_by_loads
from flexcli.formulas.amplified import amplified
from flexcli.formulas.quantity import Computed
from flexcli.numerics.rows import Number, isfinite, larger, number, smaller
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import Change, ModelEffect, Setting, left_by
from flexcli.parts.effects.plate import flattest, pulled, stretched, widest
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import ACROSS_WIDTH, Critical
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
from flexcli.results import EXACT, ErrorRange, QuantityKind

if TYPE_CHECKING:
    from flexcli.mechanics.space.springs import MemberSprings
    from flexcli.mechanics.space.swept_box import SweptBox

__all__ = ["Corrected"]

LEAST_STRESS = LEAST_STIFFNESS = 1e-300
"""Stress and stiffness below which there is none [Pa, N/m or N·m/rad]."""

PUSHED = 2.0
"""Times the share that a load along the stroke has in a stress by which it may be off. That share
was at most 1.13 times what is told of it (exact beams with the load and without, of 676 random
pivots, stages and single blades, h/l 0.002 to 0.05, strokes to 0.16 rad or 0.13 l)."""

SHORTENED = 0.35
"""By how much more a wide blade shortens than its beam, of what a plate is stiffer at most: an arc
up to 0.2 of it, an S beside its chord 0.32, by ``plate_shortening``."""

NOTHING_BORNE = 0.0, 0.0, 0.0
"""What no loads make of an effort, by beams, by a joint as stiff, and its error."""


class Corrected(JointModel):
    """The answers of a model times one factor an effect, and what is left to be off by.

    An effect whose value nobody knows, or that lacks a property of the material, corrects
    nothing: the whole range of what it may change is part of the error. So do the ``omitted``,
    between none of what they change and all of it.
    """

    def __init__(
        self,
        inner: JointModel,
        effects: Sequence[ModelEffect],
        name: str = "",
        omitted: Sequence[ModelEffect] = (),
    ) -> None:
        self.inner = inner
        self.effects = tuple(effects)
        self.omitted = tuple(omitted)
        self.name = name or inner.name
        self.at_stroke, self.at_rest = inner.at_stroke, inner.at_rest
        self.directs_blades = inner.directs_blades
        self._known: Remembered[dict[EffectName, dict[str, Change]]] = Remembered()

    def shares(self, other: JointModel) -> None:
        """Let the inner models share."""
        if isinstance(other, Corrected):
            self.inner.shares(other.inner)

    def carried(self, setting: Setting) -> frozenset[EffectName]:
        """Return the effects of the inner model, and those whose values correct it."""
        lacking = {e.name for e in (*self.effects, *self.omitted) if e.lacks(setting)}
        known = {
            effect.name
            for effect in self._added(setting)
            if any(change.value is not None for change in effect.changes(setting).values())
        }
        return frozenset(self.inner.covers | self.inner.always | known) - lacking

    def springs(self, ask: Ask, *, in_plane: bool) -> "tuple[MemberSprings, ...] | None":
        """Return those of the inner model."""
        return self.inner.springs(ask, in_plane=in_plane)

    def may_know(self, ask: Ask, kind: QuantityKind) -> bool:
        """Return whether the effects leave an error, whatever the inner model may carry."""
        return self._left_by(ask, kind, EXACT, self.inner.may_carry(kind)) is not None

    def frequency_factor(self, ask: Ask) -> float:
        """Return what the effects change beside the stiffness."""
        factor, setting = self.inner.frequency_factor(ask), _setting(ask)
        for effect in self._added(setting):
            change = effect.changes(setting).get("frequency")
            factor *= 1.0 + (change.value or 0.0) if change is not None else 1.0
        return factor

    def stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the motion [N·m/rad or N/m]."""
        return self.inner.stiffness(ask) * self._factor(ask, QuantityKind.STIFFNESS)

    def effort(self, ask: Ask) -> tuple[DriveEffort, ...]:
        """Return the efforts at the ends of the stroke, corrected as the stiffness is.

        What beside the stiffness at rest a large travel makes of an effort may be corrected or not;
        it bends wide blades otherwise, up to as flat as plates are. Curvature that flattens them
        makes more of it, as of their moments. What loads make of it is that of a joint as stiff.
        Errors of the stiffness are of its own share, however small the whole is.
        """
        factor = self._factor(ask, QuantityKind.STIFFNESS)
        widens = self._widening(ask, QuantityKind.STIFFNESS) is not None
        most = larger(factor, flattest(_setting(ask)) if widens else 1.0)
        stiffened, warm = factor != 1.0 or most != 1.0, ask.scene.temperature is not None
        cold = ask._replace(scene=ask.scene.at_assembly())
        plain = float(self.inner.stiffness(cold)) if stiffened or warm else 0.0
        other, flat = larger(abs(factor - 1.0), most / factor - 1.0), self._flattened(ask)
        given = self.inner.effort(ask)
        borne = self._borne(ask, given, factor, most) if stiffened else [NOTHING_BORNE] * len(given)
        found = []
        for (travel, effort, known, load), (beam, of_loads, unsure) in zip(
            given, borne, strict=True
        ):
            own = factor * (effort - beam)
            whole = own + of_loads
            error = None if known is None else self._left(ask, QuantityKind.STIFFNESS, known)
            if error is not None and whole != 0.0:
                share = larger(abs(own / whole), 1.0)
                if warm:  # which presses and pulls no less if blades are stiffer
                    share = larger(share, abs(factor * plain * travel / whole))
                beside = abs(own - factor * plain * abs(travel)) * other if stiffened else 0.0
                off = (beside + unsure) / abs(whole)
                error = ErrorRange(share * error.low - off, share * (error.high + flat) + off)
            found.append(DriveEffort(travel, whole, error, load))
        return tuple(found)

    def _borne(
        self, ask: Ask, given: Sequence[DriveEffort], factor: float, most: float
    ) -> list[tuple[float, float, float]]:
        """Return what loads make of the efforts: by beams, by a joint as stiff, and its error.

        A joint so many times as stiff under its loads is the joint under so much less. Of what
        bends otherwise nobody knows more than that it is between beams and flat plates. The error
        has what wide blades shorten otherwise as they bend, and all of what other effects do.
        """
        scene = ask.scene
        if not scene.is_loaded or scene.temperature is not None:
            return [NOTHING_BORNE] * len(given)
        alone = self._efforts(ask, scene.without_loads())
        try:
            under = [(k, self._efforts(ask, scene.with_loads(1.0 / k))) for k in (factor, most)]
        except NotAvailable:  # softer, it buckles
            return [NOTHING_BORNE] * len(given)
        of_loads = [
            [k * (effort - own) for effort, own in zip(efforts, alone, strict=True)]
            for k, efforts in ((1.0, [each.effort for each in given]), *under)
        ]
        off, found = self._shortened(ask, factor), list[tuple[float, float, float]]()
        for beam, value, flat in zip(*of_loads, strict=True):
            unsure = larger(abs(beam - value), abs(flat - value)) + off * abs(value)
            found.append((beam, value, number(unsure)))
        return found

    def _efforts(self, ask: Ask, scene: Scene) -> list[float]:
        """Return the efforts of beams in another scene."""
        return [each.effort for each in self.inner.effort(ask._replace(scene=scene))]

    def _shortened(self, ask: Ask, factor: float) -> float:
        """Return by how much the shortening of bent blades may differ from that of beams [-].

        A stage of its own form shifts by that; of blades in any shape it is that of plates at most.
        """
        effect = self._widening(ask, QuantityKind.STIFFNESS)
        if effect is None:
            return abs(factor - 1.0)
        found = self._changes(ask, effect)
        widened, shift = found.get(QuantityKind.STIFFNESS), found.get(QuantityKind.SHIFT)
        most = SHORTENED * (flattest(_setting(ask)) - 1.0)
        if shift is not None and ask.geometry.motion == "translation" and ask.geometry.closed_forms:
            most = smaller(most, shift.bound)
        own = 1.0 + ((widened.value if widened is not None else None) or 0.0)
        return most + abs(factor / own - 1.0)

    def _flattened(self, ask: Ask) -> float:
        """Return by how much curvature at most raises the moments of a travel [-]."""
        for effect in (*self.effects, *self.omitted):
            if effect.name is EffectName.ANTICLASTIC and effect.indicator(_setting(ask)):
                change = self._changes(ask, effect).get(QuantityKind.STRESS)
                return 0.0 if change is None else change.bound
        return 0.0

    def envelope(self, ask: Ask) -> tuple["SweptBox", tuple[str, ...]]:
        """Return that of the model: it is in its errors what it leaves out."""
        return self.inner.envelope(ask)

    def sag_stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the case's acceleration [N/m]."""
        return self.inner.sag_stiffness(ask) / self._factor(ask, QuantityKind.SAG)

    def sags(self, ask: Ask) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the sags in either sense, with what their size changes in them."""
        changes = self.inner.sag_changes(ask)
        sag, known = float(self.sag(ask)), self.inner.error(ask, QuantityKind.SAG)
        if known is not None:
            known = self._left(ask, QuantityKind.SAG, known)
        found = list[tuple[float, ErrorRange | None]]()
        for more, off in changes:
            of_change = ErrorRange(-off / (1.0 + more), off / (1.0 + more))
            found.append((sag * (1.0 + more), None if known is None else known + of_change))
        return tuple(found)

    def parasitic_shift(self, ask: Ask) -> Computed:
        """Return the signed shift at the end of the case's stroke [m]."""
        if ask.scene.temperature is not None:
            return self._warm_shift(ask)[0]
        return self.inner.parasitic_shift(ask) * self._factor(ask, QuantityKind.SHIFT)

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stresses, those of the stroke corrected.

        A wide blade resists a curvature more than a beam; under a force along the stroke it is
        curved less, and its moments and stresses are those of the force. That of a force along it
        is its largest across the width.
        """
        name, found = self.inner.stresses(ask)
        if self._widening(ask) is not None:
            along = stretched(_setting(ask)).value
            found = [s._replace(axial=s.axial * along) for s in found]
        if not ask.scene.moves:
            factor, _ = self._of_push(ask)
            return name, [s._replace(mean=s.mean * factor) for s in found]
        of_mean = bool(ask.scene.mean_travel) or not ask.scene.push
        whole, corrected = self._factor(ask, QuantityKind.STRESS), []
        for s in found:
            factor = whole * self._of_wide(ask, s)[0]
            mean = s.mean * factor if of_mean else s.mean
            corrected.append(s._replace(amplitude=s.amplitude * factor, mean=mean))
        return name, corrected

    def _of_push(self, ask: Ask) -> tuple[Number, Number]:
        """Return the factor of the stress by a load along the stroke, and what wide blades leave.

        It moves the joint by its force over the stiffness, and both are corrected. That of blades
        which a case keeps from turning is the force's.
        """
        factor: Number = 1.0
        wide: Number = 0.0
        scene = ask.scene
        if scene.push == 0.0 or not _setting(ask).largest_travel:
            return factor, wide
        for effect in self._of_stress(ask):
            found = self._changes(ask, effect)
            both = found.get(QuantityKind.STRESS), found.get(QuantityKind.STIFFNESS)
            stress, stiffness = (None if each is None else each.value for each in both)
            if stress is None or stiffness is None:
                continue
            ratio = (1.0 + stress) / (1.0 + stiffness)
            if effect.name is EffectName.SHEAR:
                factor *= ratio
            elif effect.name is EffectName.PLATE_WIDENING and not scene.keeps_turn:
                wide = abs(ratio - 1.0)
        return factor, wide

    def _of_wide(self, ask: Ask, stress: EndStress) -> tuple[Number, ErrorRange]:
        """Return what the force along a wide blade changes of its factor, and the range left.

        Nothing is changed where the factor corrects nothing; nor where a force makes the travel.
        """
        wide, effect = stress.wide, self._widening(ask)
        if wide is None or effect is None:
            return 1.0, ErrorRange(0.0, 0.0)
        change = self._changes(ask, effect).get(QuantityKind.STRESS)
        plain = 1.0 + (change.value or 0.0) if change is not None else 1.0
        low, high = (each / plain for each in wide.of(plain))
        if not isfinite(high):
            return 1.0, ErrorRange(-1.0, inf)
        loose = pulled(_setting(ask)) * wide.axial
        if change is None or change.value is None or ask.scene.push:
            return 1.0, ErrorRange(smaller(low, 1.0) - 1.0 - loose, larger(high, 1.0) - 1.0 + loose)
        value = (low + high) / 2.0
        return value, ErrorRange(low / value - 1.0 - loose, high / value - 1.0 + loose)

    def _widening(self, ask: Ask, kind: QuantityKind = QuantityKind.STRESS) -> ModelEffect | None:
        """Return the effect of wide blades where it corrects a kind of number of the model."""
        return self._widening_beside(self.inner.carries(ask, kind))

    def _widening_beside(self, carried: frozenset[EffectName]) -> ModelEffect | None:
        """Return it where the model carries these besides what it always has."""
        carried |= self.inner.covers | self.inner.always
        both = (e for e in self.effects if e.name not in carried)
        return next((e for e in both if e.name is EffectName.PLATE_WIDENING), None)

    def support_at_stroke(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the support stiffness at both ends of the stroke, which needs no correction."""
        return self.inner.support_at_stroke(ask, index, point, locked=locked)

    def warm_support_ratio(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> Told:
        """Return that of the inner model."""
        return self.inner.warm_support_ratio(ask, index, point, locked=locked)

    def deflections(
        self, ask: Ask, point: tuple[float, float, float], direction: str
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return those of the inner model, which need no correction."""
        return self.inner.deflections(ask, point, direction)

    def misfit_stresses(
        self, ask: Ask, small: Sequence[MisfitStress]
    ) -> Iterator[tuple[Told, str]]:
        """Yield those of the inner model, which need no correction."""
        return self.inner.misfit_stresses(ask, small)

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return the critical forces, those in the plane corrected by what they do not carry."""
        found = (self._corrected(ask, c) for c in self.inner.critical(ask))
        if not ask.scene.is_accelerated:
            return tuple(found)
        return tuple(_with_weight(ask, critical) for critical in found)

    def critical_shares(self, ask: Ask) -> tuple[CriticalShare, ...]:
        """Return the shares of the loads that buckle it; their errors have what is not carried."""
        return self.inner.critical_shares(ask)

    def _corrected(self, ask: Ask, critical: Critical) -> Critical:
        if critical.way == ACROSS_WIDTH:
            return critical
        factor = self._factor(ask, QuantityKind.BUCKLING, critical.carries)
        error = critical.error
        if error is not None:
            error = self._left(ask, QuantityKind.BUCKLING, error, critical.carries)
        return critical._replace(force=critical.force * factor, error=error)

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return the model's own error, and what the corrections and what they lack leave."""
        if kind is QuantityKind.SHIFT and ask.scene.temperature is not None:
            try:
                return self._warm_shift(ask)[1]
            except NotAvailable:
                return None
        found = self.inner.error(ask, kind)
        if found is None:
            return None
        if kind is QuantityKind.STRESS:
            beside = self._beside_stroke(ask)
            left = self._left(ask, kind, found)
            if left is None or beside is None:
                return None
            # of the corrected stress, whatever the corrections leave; nothing is less than none
            low, high = (
                larger(1.0 + a, 0.0) * larger(1.0 + b, 0.0) - 1.0
                for a, b in zip(left, beside, strict=True)
            )
            if EffectName.THICK_NOTCH not in self.inner.always:  # solids have the peak itself
                low = (1.0 + low) * (1.0 - ask.geometry.peaks_above(ask.sizes)) - 1.0
            return ErrorRange(low, high) if isfinite(low) and isfinite(high) else None
        left = self._left(ask, kind, found)
        if left is not None and ask.scene.temperature is not None:
            left = self._strained(ask, kind, left)
        if kind is not QuantityKind.SAG or not ask.scene.sags:
            return left
        from flexcli.parts.strained_compliance import beyond_linear_sag

        more, heat = beyond_linear_sag(ask), self._beside_sag(ask)
        if left is None or more is None or heat is None:
            return None
        return left + heat + ErrorRange(-more, more)

    def _strained(self, ask: Ask, kind: QuantityKind, error: ErrorRange) -> ErrorRange | None:
        """Return the error of a number that follows from the stiffness, at a temperature.

        What heat strains presses and pulls no less where blades are stiffer: of a stiffness that it
        takes away their errors are of what is left.
        """
        along = ask.geometry.sags_along_stroke(ask.scene.axis) if ask.scene.sags else True
        of_stiffness = kind in (QuantityKind.STIFFNESS, QuantityKind.FREQUENCY)
        if not (of_stiffness or (kind is QuantityKind.SAG and along)):
            return error
        try:
            unlike, share = self._unlike(ask), self.inner.heat_in_stiffness(ask)
        except NotAvailable:
            return None
        if unlike is None:
            return None
        off = unlike * share
        low, high = larger(1.0 - off, 0.0), 1.0 + off
        if kind is QuantityKind.SAG:
            return error + ErrorRange(1.0 / high - 1.0, 1.0 / low - 1.0) if off < 1.0 else None
        if kind is QuantityKind.FREQUENCY:
            low, high = low**0.5, high**0.5
        return error + ErrorRange(low - 1.0, high - 1.0)

    def _warm_shift(self, ask: Ask) -> tuple[float, ErrorRange | None]:
        """Return the shift at a temperature and its error: what is corrected is the stroke's share.

        A material that leaves a shift unsure does so of that share, however small the whole is.
        """
        from flexcli.parts.requirements.warm_shift import combined

        warm, bending = self.inner.warm_shift(ask), self._unlike(ask)
        if not ask.scene.moves:
            found = _between(*combined(warm, bending=number(bending or 0.0)))
            return found if bending is not None else (found[0], None)
        cold = ask._replace(scene=ask.scene.at_assembly())
        own = abs(float(self.parasitic_shift(cold)))
        factor = own / warm.cold if warm.cold else 1.0
        known = self.error(cold, QuantityKind.SHIFT) if warm.cold else EXACT
        known = None if known is None else ask.doubted(known, QuantityKind.SHIFT)
        if known is None or bending is None:
            return combined(warm, factor=factor)[0], None
        errors = {"cold_error": known.largest, "bending": number(bending)}
        return _between(*combined(warm, factor=factor, **errors))

    def _beside_sag(self, ask: Ask) -> ErrorRange | None:
        """Return the error of a sag by what strains the joint besides.

        Stiffness along the stroke has that of a temperature.
        """
        scene = ask.scene
        has_heat = scene.temperature is not None
        if has_heat and ask.geometry.sags_along_stroke(scene.axis):
            scene, has_heat = scene.at_assembly(), False
        if not (has_heat or any(scene.stated)):
            return EXACT
        with suppress(NotAvailable):
            return self.inner.heat_in_sag(ask)
        from flexcli.parts.space_joint import joint_of
        from flexcli.parts.space_states import acting_groups
        from flexcli.parts.strained_compliance import changed_beside, either_way

        try:
            joint = joint_of(ask._replace(scene=scene))
            stated = acting_groups(joint, scene._replace(inertial=(), accelerations=()))
            driven = ask.geometry.sags_along_stroke(scene.axis)
            return changed_beside(joint, either_way(scene), stated, driven=driven)
        except NotAvailable:  # no shear modulus, or no blades
            return None

    def _beside_stroke(self, ask: Ask) -> ErrorRange | None:
        """Return what of a stress is not the stroke's: of a force beside it, of blades' weight."""
        scene, found = ask.scene, ErrorRange(0.0, 0.0)
        if scene.moves and scene.has_plane:
            found += self._of_nearer_end(ask)
        if scene.moves:
            found += self._of_forces(ask)
        if scene.is_loaded:
            bent = self._of_bent(ask)
            if bent is None:
                return None
            found += self._of_loads(ask) + self._of_pulled(ask) + self._of_heat(ask) + bent
        if scene.push:
            factor, wide = self._of_push(ask)
            pushed = self._of_pushed_travel(ask) + ErrorRange(-wide, wide)
            if scene.moves:
                of_mean = self._factor(ask, QuantityKind.STRESS) if scene.mean_travel else 1.0
                share = self._pushed_share(ask)
                low, high = (share * each for each in pushed + _as_much(factor / of_mean))
                pushed = ErrorRange(low, high)
            elif scene.beyond or scene.blade_force:  # other loads bend it besides
                pushed += _as_much(1.0 / factor)
            found += pushed
        if not scene.is_accelerated:
            return found
        if ask.geometry.has_limbs(ask.material.elastic, ask.sizes):
            return None  # nobody knows what they weigh
        if self.inner.weighs_blades and ask.material.density is not None:
            return found
        from flexcli.engine.joint_models.blade_weight import left_share

        try:
            more = left_share(ask, self.inner.stresses(ask)[1])
        except NotAvailable:
            return None
        return found + ErrorRange(-more, more)

    def _of_bent(self, ask: Ask) -> ErrorRange | None:
        """Return what blades that loads and heat bend leave, which are as stiff as they are.

        What a model has in its stress it has in what bends it.
        """
        try:
            bent = self.inner.bent(ask)
        except NotAvailable:  # a little more of them buckles it
            return None
        if not np.any(bent.share):
            return ErrorRange(0.0, 0.0)
        softer = self._unlike(ask, self.inner.carries(ask, QuantityKind.STRESS))
        if softer is None:
            return None
        unlike = softer + bent.unlike
        return ErrorRange(-bent.share * unlike, amplified(bent.share, unlike))

    def _unlike(self, ask: Ask, carried: frozenset[EffectName] = frozenset()) -> Number | None:
        """Return by how much blades that bend are off in stiffness, beside those of the model.

        What corrects their stiffness at assembly counts as an error of what forces bend.
        """
        cold = ask._replace(scene=ask.scene.at_assembly())
        known = self.inner.error(cold, QuantityKind.STIFFNESS)
        left = None if known is None else self._left(cold, QuantityKind.STIFFNESS, known, carried)
        if left is None:
            return None
        factor = self._factor(cold, QuantityKind.STIFFNESS, carried)
        return number(left.largest) + abs(factor - 1.0)

    def _of_nearer_end(self, ask: Ask) -> ErrorRange:
        """Return what corrections that grow with the travel do not do at its nearer end.

        They are of the end at which the stress is largest. The amplitude is between both ends: a
        term that is of the square of the travel, as the two ways of an uneven joint, cancels there.
        Of ends that are alike nothing is less; bars in torsion have no two ways.
        """
        low, high, is_even = 1.0, 1.0, not ask.scene.mean_travel
        for change in self._growing(ask):
            factor = 1.0 + (change.value or 0.0)
            low /= larger(factor, 1.0)
            high /= 1.0 if is_even else smaller(factor, 1.0)
        return ErrorRange(low - 1.0, high - 1.0)

    def _of_loads(self, ask: Ask) -> ErrorRange:
        """Return what is raised too much of a stress that is in part of loads beside the stroke.

        Of loads is a mean that is not that of the stroke.
        """
        more = 1.0
        for effect in self._of_stress(ask):
            change = self._changes(ask, effect).get(QuantityKind.STRESS)
            if effect.spares_loads and change is not None:
                more *= 1.0 + larger(change.value or 0.0, 0.0)
        if more == 1.0:
            return ErrorRange(0.0, 0.0)
        return ErrorRange((1.0 / more - 1.0) * self._share_beside(ask), 0.0)

    def _share_beside(self, ask: Ask) -> Number:
        """Return the largest share of a stress that is a mean which the stroke does not make."""
        scene, shares = ask.scene, [0.0]
        own = scene.mean_travel / scene.travel if scene.travel else 0.0
        for stress in self.inner.stresses(ask)[1]:
            size, mean = number(abs(stress.amplitude)), number(abs(stress.mean))
            beside = abs(mean - own * size)
            shares.append(beside / larger(size + larger(mean, beside), LEAST_STRESS))
        return larger(shares)

    def _pushed_share(self, ask: Ask) -> Number:
        """Return the share of the largest stress that may be of a load along the stroke.

        By how far it moves the joint and by the mean beside that of the stroke, which large
        travels and other loads may hide or be. A design nearby is moved as far.
        """
        scene, about = ask.scene, ask if ask.near is None else ask.near._replace(scene=ask.scene)
        moved = scene.push / larger(number(self.stiffness(about)), LEAST_STIFFNESS)
        share = larger(moved / (moved + scene.travel), self._share_beside(ask))
        return smaller(PUSHED * share, 1.0)

    def _of_pulled(self, ask: Ask) -> ErrorRange:
        """Return what wide blades may have of the forces along them.

        Without a stroke what widens has no share in that beside it: of the largest stress, that of
        these forces is as unsure as they are, and the rest as what widens.
        """
        widening, setting = self._widening(ask), _setting(ask)
        if widening is None or not (ask.scene.moves or _is_told(widening, setting)):
            return ErrorRange(0.0, 0.0)
        shares, along, bent, largest = [0.0], 0.0, 0.0, LEAST_STRESS
        for stress in self.stresses(ask)[1]:
            axial = number(abs(stress.axial))
            rest = number(abs(stress.amplitude)) + number(abs(stress.mean))
            shares.append(axial / larger(rest + axial, LEAST_STRESS))
            along, bent = larger(along, axial), larger(bent, rest)
            largest = larger(largest, number(abs(stress.largest)))
        value, low, high, _ = stretched(setting)
        share = larger(shares) if ask.scene.moves else along / largest
        off = 0.0 if ask.scene.moves else pulled(setting) * bent / largest
        low, high = (share * (each / value - 1.0) for each in (low, high))
        return ErrorRange(low - off, high + off)

    def _of_heat(self, ask: Ask) -> ErrorRange:
        """Return what wide blades leave that heat bends: by motions, and in any shape.

        Of a stress beside that of a stroke which is corrected, and of all without one.
        """
        scene, setting = ask.scene, _setting(ask)
        if scene.temperature is None or self._widening(ask) is None:
            return ErrorRange(0.0, 0.0)
        if scene.moves:
            share = self._share_beside(ask)
            is_corrected = bool(scene.mean_travel) or not scene.push
            factor = self._factor(ask, QuantityKind.STRESS) if is_corrected else 1.0
        else:
            each = [(abs(s.amplitude) + abs(s.mean), s.largest) for s in self.stresses(ask)[1]]
            bent, largest = (larger(map(number, part)) for part in zip(*each, strict=True))
            share, factor = bent / larger(abs(largest), LEAST_STRESS), 1.0
        low, high = (share * (most / factor - 1.0) for most in (1.0, widest(setting)))
        return ErrorRange(smaller(low, 0.0), larger(high, 0.0))

    def _of_forces(self, ask: Ask) -> ErrorRange:
        """Return what of the largest stress forces along wide blades leave, see plates.

        Each blade's stress has its own range; one that is not the largest may become it.
        """
        effect = self._widening(ask)
        if effect is None:
            return ErrorRange(0.0, 0.0)
        most, least, sizes = 0.0, 0.0, 0.0
        for s in self.stresses(ask)[1]:
            if s.wide is None:
                return change_by_loads(_setting(ask))
            size, left = number(abs(s.largest)), self._of_wide(ask, s)[1]
            sizes = larger(sizes, size)
            most, least = (
                larger(most, size * (1.0 + left.high)),
                larger(least, size * (1.0 + left.low)),
            )
        if sizes == 0.0:
            return ErrorRange(0.0, 0.0)
        return ErrorRange(smaller(least / sizes - 1.0, 0.0), larger(most / sizes - 1.0, 0.0))

    def _of_pushed_travel(self, ask: Ask) -> ErrorRange:
        """Return what a travel by a force may change of its stress, either way.

        Corrections are of a travel that is given; a force that moves the joint as far has other
        moments by as much.
        """
        found = ErrorRange(0.0, 0.0)
        for change in self._growing(ask):
            found += ErrorRange(-abs(change.value or 0.0), abs(change.value or 0.0))
        return found

    def _growing(self, ask: Ask) -> Iterator[Change]:
        """Yield what effects that grow with the travel correct of a stress."""
        for effect in self._of_stress(ask):
            change = self._changes(ask, effect).get(QuantityKind.STRESS)
            if effect.grows_with_travel and change is not None:
                yield change

    def _left(
        self,
        ask: Ask,
        kind: QuantityKind,
        found: ErrorRange,
        carried: frozenset[EffectName] = frozenset(),
    ) -> ErrorRange | None:
        """Return an error with what the effects leave that are not carried."""
        return self._left_by(ask, kind, found, carried | self.inner.carries(ask, kind))

    def _left_by(
        self, ask: Ask, kind: QuantityKind, found: ErrorRange, carried: frozenset[EffectName]
    ) -> ErrorRange | None:
        """Return an error with what all effects leave but those that are carried."""
        ask = _asked(ask, kind)
        setting, inner = _setting(ask), self.inner.covers | self.inner.always
        missing, applied, beside, whole = self._missing(setting), [], [], True
        widening = self._widening_beside(carried) if kind is QuantityKind.STRESS else None
        low = high = 1.0
        for effect in (*self.effects, *self.omitted):
            if kind not in effect.only or effect.indicator(setting) is None:
                continue
            change = self._changes(ask, effect).get(kind)
            if change is None:
                continue
            if not ask.scene.moves and effect is widening:
                change = change._replace(error=0.0)  # by how much forces along blades have of it
            if effect not in missing or effect.name in carried:
                beside.append(change)
            elif not _is_told(effect, setting):
                if change.value is None and not effect.is_whole:
                    return None
                found += _whole_range(effect, change, setting, kind)
            elif change.value is None and effect.is_whole:  # a range that holds, and no value
                found += _whole_range(effect, change, setting, kind)
            elif effect.name not in inner:
                applied.append(change)
                whole = whole and effect.is_whole
                if effect in self.omitted and change.value is not None:
                    low *= 1.0 + smaller(change.value, 0.0)
                    high *= 1.0 + larger(change.value, 0.0)
            else:  # carried, at one value of the property that is not given
                found += ErrorRange(-change.error, change.error)
        # bounds that are of all that an effect changes leave nothing to what stands beside it
        left = left_by(applied, () if whole else beside)
        if left is None:
            return None
        found += left
        if not (isfinite(found.low) and isfinite(found.high)):
            return None
        return ErrorRange(larger(1.0 + found.low, 0.0) * low - 1.0, (1.0 + found.high) * high - 1.0)

    def _changes(self, ask: Ask, effect: ModelEffect) -> dict[str, Change]:
        """Return all that an effect changes, found once for every number and its error."""
        known = self._known.of("changes", ask, dict)
        if effect.name not in known:
            known[effect.name] = effect.all_changes(_setting(ask))
        return known[effect.name]

    def _missing(self, setting: Setting) -> list[ModelEffect]:
        """Return the effects that the inner model has not, as the material lacks something."""
        carried = self.inner.covers | self.inner.always
        both = (*self.effects, *self.omitted)
        return [e for e in both if e.name not in carried or e.lacks(setting)]

    def _added(self, setting: Setting) -> list[ModelEffect]:
        """Return the effects that correct the inner model."""
        carried = self.inner.covers | self.inner.always
        return [e for e in self.effects if e.name not in carried and _is_told(e, setting)]

    def _of_stress(self, ask: Ask) -> list[ModelEffect]:
        """Return the effects that correct the stress of the inner model."""
        carried = self.inner.carries(ask, QuantityKind.STRESS)
        return [e for e in self._added(_setting(ask)) if e.name not in carried]

    def _factor(
        self, ask: Ask, kind: QuantityKind, carried: frozenset[EffectName] = frozenset()
    ) -> float:
        carried |= self.inner.carries(ask, kind)
        ask = _asked(ask, kind)
        factor, setting = 1.0, _setting(ask)
        for effect in self._added(setting):
            if kind not in effect.only or effect.name in carried:
                continue
            change = self._changes(ask, effect).get(kind)
            factor *= 1.0 + (change.value or 0.0) if change is not None else 1.0
        return factor


def _with_weight(ask: Ask, critical: Critical) -> Critical:
    """Return a critical force with what it may be less by since blades weigh something.

    Their weight loads no blade by more than as if all of it were on the body.
    """
    from flexcli.engine.joint_models.blade_weight import weighed

    error = critical.error
    if error is None or ask.geometry.has_limbs(ask.material.elastic, ask.sizes):
        return critical._replace(error=None)
    more = weighed(ask) / ask.scene.force
    return critical._replace(error=error + ErrorRange(1.0 / (1.0 + more) - 1.0, 0.0))


def _between(value: float, least: float, most: float) -> tuple[float, ErrorRange | None]:
    """Return a value and its error by the sizes between which it is."""
    if value == 0.0 or not isfinite(most):
        return value, None
    return value, ErrorRange(least / abs(value) - 1.0, most / abs(value) - 1.0)


def _as_much(other: Number) -> ErrorRange:
    """Return the range of a number of which a part, or all, is another factor times as much."""
    return ErrorRange(smaller(other, 1.0) - 1.0, larger(other, 1.0) - 1.0)


def _is_told(effect: ModelEffect, setting: Setting) -> bool:
    """Return whether an effect knows its change, for all that what is not given may be."""
    return effect.spans_what_it_needs or not effect.lacks(setting)


def _whole_range(
    effect: ModelEffect, change: Change, setting: Setting, kind: QuantityKind
) -> ErrorRange:
    """Return all that an effect may change that corrects nothing."""
    most = effect.estimates(setting).get(kind, change.bound)
    if change.value is not None:
        most = larger(most, abs(change.value) + change.error)
    sign = change.sign
    if sign == 0 and change.value is not None and change.error == 0.0:
        sign = 1 if change.value > 0.0 else -1
    return ErrorRange(0.0 if sign > 0 else -most, 0.0 if sign < 0 else most)


def _asked(ask: Ask, kind: QuantityKind) -> Ask:
    """Return what a kind of number is asked of: a shift is that of the stroke alone."""
    if kind is not QuantityKind.SHIFT or not ask.scene.moves:
        return ask
    return ask._replace(scene=ask.scene.without_loads())


def _setting(ask: Ask) -> Setting:
    return Setting(ask.material, ask.geometry, ask.mechanism, ask.sizes, (ask.scene,))
