"""A model with corrections for effects that it does not carry itself: each by its formula, once."""

from collections.abc import Sequence
from contextlib import suppress

from flexcli.engine.joint_models.built_on import BuiltOn
from flexcli.engine.joint_models.corrected_effort import CorrectedEffort
from flexcli.engine.joint_models.corrected_stress import CorrectedStress
from flexcli.engine.joint_models.corrections import Corrections, setting_of
from flexcli.formulas.quantity import Computed
from flexcli.numerics.rows import isfinite, larger, number
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import ModelEffect, Setting
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import ACROSS_WIDTH, Critical
from flexcli.parts.requirements import (
    Ask,
    CriticalShare,
    DriveEffort,
    EndStress,
    JointModel,
)
from flexcli.results import EXACT, ErrorRange, QuantityKind

__all__ = ["Corrected"]


class Corrected(BuiltOn):
    """The answers of a model as effects correct them, and what is left to be off by."""

    def __init__(
        self,
        inner: JointModel,
        effects: Sequence[ModelEffect],
        name: str = "",
        omitted: Sequence[ModelEffect] = (),
    ) -> None:
        self.inner = inner
        self.by = Corrections(inner, effects, omitted)
        self.of_stress, self.of_effort = CorrectedStress(self.by), CorrectedEffort(self.by)
        self.name = name or inner.name
        self.at_stroke, self.at_rest = inner.at_stroke, inner.at_rest
        self.directs_blades = inner.directs_blades
        self.directs_in_plane = inner.directs_in_plane

    def shares(self, other: JointModel) -> None:
        """Let the inner models share."""
        if isinstance(other, Corrected):
            self.inner.shares(other.inner)

    def carried(self, setting: Setting) -> frozenset[EffectName]:
        """Return the effects of the inner model, and those whose values correct it."""
        lacking = {e.name for e in (*self.by.effects, *self.by.omitted) if e.lacks(setting)}
        known = {
            effect.name
            for effect in self.by.added(setting)
            if any(change.value is not None for change in effect.changes(setting).values())
        }
        return frozenset(self.inner.covers | self.inner.always | known) - lacking

    def may_know(self, ask: Ask, kind: QuantityKind) -> bool:
        """Return whether the effects leave an error, whatever the inner model may carry."""
        return self.by.left_by(ask, kind, EXACT, self.inner.may_carry(kind)) is not None

    def frequency_factor(self, ask: Ask) -> float:
        """Return what the effects change beside the stiffness."""
        factor, setting = self.inner.frequency_factor(ask), setting_of(ask)
        for effect in self.by.added(setting):
            change = effect.changes(setting).get("frequency")
            factor *= 1.0 + (change.value or 0.0) if change is not None else 1.0
        return factor

    def stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the motion [N·m/rad or N/m]."""
        return self.by.stiffness(ask)

    def effort(self, ask: Ask) -> tuple[DriveEffort, ...]:
        """Return the efforts at the ends of the stroke, corrected as the stiffness is."""
        return self.of_effort.effort(ask)

    def sag_stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the case's acceleration [N/m]."""
        return self.inner.sag_stiffness(ask) / self.by.factor(ask, QuantityKind.SAG)

    def sags(self, ask: Ask) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the sags in either sense, with what their size changes in them."""
        changes = self.inner.sag_changes(ask)
        sag, known = float(self.sag(ask)), self.inner.error(ask, QuantityKind.SAG)
        if known is not None:
            known = self.by.left(ask, QuantityKind.SAG, known)
        found = list[tuple[float, ErrorRange | None]]()
        for more, off in changes:
            of_change = ErrorRange(-off / (1.0 + more), off / (1.0 + more))
            found.append((sag * (1.0 + more), None if known is None else known + of_change))
        return tuple(found)

    def parasitic_shift(self, ask: Ask) -> Computed:
        """Return the signed shift at the end of the case's stroke [m]."""
        if ask.scene.temperature is not None:
            return self._warm_shift(ask)[0]
        return self.inner.parasitic_shift(ask) * self.by.factor(ask, QuantityKind.SHIFT)

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stresses, those of the stroke corrected."""
        return self.of_stress.stresses(ask)

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return the critical forces, those in the plane corrected by what they do not carry."""
        found = (self._corrected(ask, c) for c in self.inner.critical(ask))
        if not ask.scene.is_accelerated:
            return tuple(found)
        return tuple(_with_weight(ask, critical) for critical in found)

    def critical_shares(self, ask: Ask) -> tuple[CriticalShare, ...]:
        """Return those of the inner model, no surer than the stiffness of what bends in it."""
        unlike = self.by.unlike(ask)
        found = self.inner.critical_shares(ask)

        def known(error: ErrorRange | None) -> ErrorRange | None:
            if unlike is None or error is None:
                return None
            off = number(unlike)
            return ErrorRange(min(error.low, -off), max(error.high, off))

        return tuple(each._replace(error=known(each.error)) for each in found)

    def _corrected(self, ask: Ask, critical: Critical) -> Critical:
        if critical.way == ACROSS_WIDTH:
            return critical
        factor = self.by.factor(ask, QuantityKind.BUCKLING, critical.carries)
        error = critical.error
        if error is not None:
            error = self.by.left(ask, QuantityKind.BUCKLING, error, critical.carries)
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
            beside = self.of_stress.beside_stroke(ask)
            left = self.by.left(ask, kind, found)
            if left is None or beside is None:
                return None
            # of the corrected stress, whatever the corrections leave; nothing is less than none
            low, high = (
                larger(1.0 + a, 0.0) * larger(1.0 + b, 0.0) - 1.0
                for a, b in zip(left, beside, strict=True)
            )
            if EffectName.THICK_NOTCH not in self.inner.always:  # solids have the peak itself
                low = (1.0 + low) * (1.0 - self.of_stress.peaks_above(ask)) - 1.0
            return ErrorRange(low, high) if isfinite(low) and isfinite(high) else None
        left = self.by.left(ask, kind, found)
        if left is not None and ask.scene.temperature is not None:
            left = self._strained(ask, kind, left)
        if left is not None and kind is QuantityKind.SHIFT:
            return self._of_any_strain_law(ask, left)
        if kind is not QuantityKind.SAG or not ask.scene.sags:
            return left
        from flexcli.parts.strained_compliance import beyond_linear_sag

        more, heat = beyond_linear_sag(ask), self._beside_sag(ask)
        if left is None or more is None or heat is None:
            return None
        return left + heat + ErrorRange(-more, more)

    def _of_any_strain_law(self, ask: Ask, error: ErrorRange) -> ErrorRange | None:
        """Return the error of a shift with what another law of finite strain may change in it."""
        if self.inner.has_all_strain_laws or ask.geometry.in_space or not ask.scene.moves:
            return error
        off = setting_of(ask).bending.strain_law(ask.material.elastic.most_nu)
        if off is None:
            from flexcli.engine.joint_models.strain_law import off_by_strain_law

            shift = number(self.parasitic_shift(ask))
            if shift == 0.0:
                return error
            try:
                off = off_by_strain_law(ask, shift)
            except NotAvailable:
                return None
        return error + ErrorRange(-off, off)

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
            unlike, share = self.by.unlike(ask), self.inner.heat_in_stiffness(ask)
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

        warm, bending = self.inner.warm_shift(ask), self.by.unlike(ask)
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
