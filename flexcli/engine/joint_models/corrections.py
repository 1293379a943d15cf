"""What effects correct of a model that does not carry them: factors, and the errors they leave."""

from collections.abc import Sequence
from math import inf

from flexcli.engine.joint_models.remembered import Remembered
from flexcli.formulas.quantity import Computed
from flexcli.numerics.rows import Number, isfinite, larger, number, smaller
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import Change, ModelEffect, Setting, left_by
from flexcli.parts.effects.estimate import MOST
from flexcli.parts.requirements import Ask, JointModel
from flexcli.results import EXACT, ErrorRange, QuantityKind

__all__ = ["Corrections", "is_told", "setting_of"]


class Corrections:
    """What effects correct of a model, one factor an effect, and what is left to be off by.

    An effect whose value nobody knows, or that lacks a property of the material, corrects
    nothing: the whole range of what it may change is part of the error. So do the ``omitted``,
    between none of what they change and all of it.
    """

    def __init__(
        self, inner: JointModel, effects: Sequence[ModelEffect], omitted: Sequence[ModelEffect]
    ) -> None:
        self.inner = inner
        self.effects = tuple(effects)
        self.omitted = tuple(omitted)
        self._known: Remembered[dict[EffectName, dict[str, Change]]] = Remembered()

    def stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the motion [N·m/rad or N/m]."""
        return self.inner.stiffness(ask) * self.factor(ask, QuantityKind.STIFFNESS)

    def factor(
        self, ask: Ask, kind: QuantityKind, carried: frozenset[EffectName] = frozenset()
    ) -> float:
        """Return what the effects make of a kind of number that are not carried [-]."""
        carried |= self.inner.carries(ask, kind)
        ask = _asked(ask, kind)
        factor, setting = 1.0, setting_of(ask)
        for effect in self.added(setting):
            if kind not in effect.only or effect.name in carried:
                continue
            change = self.changes(ask, effect).get(kind)
            factor *= 1.0 + (change.value or 0.0) if change is not None else 1.0
        return factor

    def left(
        self,
        ask: Ask,
        kind: QuantityKind,
        found: ErrorRange,
        carried: frozenset[EffectName] = frozenset(),
    ) -> ErrorRange | None:
        """Return an error with what the effects leave that are not carried."""
        return self.left_by(ask, kind, found, carried | self.inner.carries(ask, kind))

    def left_by(
        self, ask: Ask, kind: QuantityKind, found: ErrorRange, carried: frozenset[EffectName]
    ) -> ErrorRange | None:
        """Return an error with what all effects leave but those that are carried."""
        ask = _asked(ask, kind)
        setting, inner = setting_of(ask), self.inner.covers | self.inner.always
        missing, applied, beside, whole = self.missing(setting), [], [], True
        widening = self.widening_beside(carried) if kind is QuantityKind.STRESS else None
        low = high = 1.0
        for effect in (*self.effects, *self.omitted):
            if kind not in effect.only or effect.indicator(setting) is None:
                continue
            change = self.changes(ask, effect).get(kind)
            if change is None:
                continue
            if not ask.scene.moves and effect is widening:
                change = change._replace(error=0.0)  # by how much forces along blades have of it
            if effect not in missing or effect.name in carried:
                beside.append(change)
            elif not is_told(effect, setting):
                if change.value is None and not effect.is_whole:
                    return None
                found += _whole_range(effect, change, setting, kind)
            elif change.value is None and effect.is_whole:  # a range that holds, and no value
                found += _whole_range(effect, change, setting, kind)
            elif effect.name not in inner:
                if kind is QuantityKind.BUCKLING and effect.is_whole and _only_raises(change):
                    high, change = inf, change._replace(error=0.0)
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

    def unlike(self, ask: Ask, carried: frozenset[EffectName] = frozenset()) -> Number | None:
        """Return by how much blades that bend are off in stiffness, beside those of the model.

        What corrects their stiffness at assembly counts as an error of what forces bend. The error
        of the model is that of a design nearby where there is one.
        """
        cold = ask._replace(scene=ask.scene.at_assembly())
        about = cold if ask.near is None else ask.near._replace(scene=cold.scene)
        known = self.inner.error(about, QuantityKind.STIFFNESS)
        left = None if known is None else self.left(cold, QuantityKind.STIFFNESS, known, carried)
        if left is None:
            return None
        factor = self.factor(cold, QuantityKind.STIFFNESS, carried)
        return number(left.largest) + abs(factor - 1.0)

    def bears(
        self, ask: Ask, carried: frozenset[EffectName] = frozenset()
    ) -> tuple[Number, Number] | None:
        """Return between which shares of what buckles blades of the model theirs is [-]."""
        left = self.left(ask, QuantityKind.BUCKLING, EXACT, carried)
        factor = self.factor(ask, QuantityKind.BUCKLING, carried)
        if left is None or number(factor * (1.0 + left.low)) <= 0.0:
            return None
        return number(factor * (1.0 + left.low)), number(factor * (1.0 + left.high))

    def changes(self, ask: Ask, effect: ModelEffect) -> dict[str, Change]:
        """Return all that an effect changes, found once for every number and its error."""
        known = self._known.of("changes", ask, dict)
        if effect.name not in known:
            known[effect.name] = effect.all_changes(setting_of(ask))
        return known[effect.name]

    def widening(self, ask: Ask, kind: QuantityKind = QuantityKind.STRESS) -> ModelEffect | None:
        """Return the effect of wide blades where it corrects a kind of number of the model."""
        return self.widening_beside(self.inner.carries(ask, kind))

    def widening_beside(self, carried: frozenset[EffectName]) -> ModelEffect | None:
        """Return it where the model carries these besides what it always has."""
        carried |= self.inner.covers | self.inner.always
        both = (e for e in self.effects if e.name not in carried)
        return next((e for e in both if e.name is EffectName.PLATE_WIDENING), None)

    def missing(self, setting: Setting) -> list[ModelEffect]:
        """Return the effects that the inner model has not, as the material lacks something."""
        carried = self.inner.covers | self.inner.always
        both = (*self.effects, *self.omitted)
        return [e for e in both if e.name not in carried or e.lacks(setting)]

    def added(self, setting: Setting) -> list[ModelEffect]:
        """Return the effects that correct the inner model."""
        carried = self.inner.covers | self.inner.always
        return [e for e in self.effects if e.name not in carried and is_told(e, setting)]

    def of_stress(self, ask: Ask) -> list[ModelEffect]:
        """Return the effects that correct the stress of the inner model."""
        carried = self.inner.carries(ask, QuantityKind.STRESS)
        return [e for e in self.added(setting_of(ask)) if e.name not in carried]


def _only_raises(change: Change) -> bool:
    """Return whether a change makes a number larger, by so much that nobody knows how much.

    It makes others unsure by its bound alone.
    """
    return change.value == 0.0 and change.sign > 0 and change.error >= MOST


def is_told(effect: ModelEffect, setting: Setting) -> bool:
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


def setting_of(ask: Ask) -> Setting:
    """Return what an effect is looked at in."""
    return Setting(ask.material, ask.geometry, ask.mechanism, ask.sizes, (ask.scene,))
