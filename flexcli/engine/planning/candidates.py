"""The models that a plan chooses from: what each would leave out of a design, and be off by."""

from collections.abc import Iterator, Mapping
from math import inf, isfinite, log10
from typing import NamedTuple

from flexcli.engine.planning.coverage import COARSE, COVERAGE, FINE, OUTER
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import ModelEffect, Setting, estimate
from flexcli.parts.elastic import NotAvailable
from flexcli.results import Note, QuantityKind

__all__ = [
    "Candidate",
    "Known",
    "candidates",
    "carries",
    "error_of",
    "errors_of",
    "not_reached",
    "tolerance_for",
]


class Known(NamedTuple):
    """An effect that the design can have, with what it changes of what is reported.

    ``formula`` tells whether formulas have the values of all that it changes, not bounds alone.
    """

    effect: ModelEffect
    indicator: float
    text: str
    estimates: Mapping[str, float]
    asked: str
    lacks: str
    formula: bool

    @property
    def name(self) -> str:
        """Return the name of the effect."""
        return self.effect.name

    @property
    def most(self) -> float:
        """Return the largest estimate."""
        return max(self.estimates.values(), default=0.0)


class Candidate(NamedTuple):
    """A model with its own errors by what is reported, and effects that are on but not in it."""

    name: str
    cost: float
    errors: Mapping[str, float]
    missing: frozenset[str]

    @property
    def always(self) -> frozenset[str]:
        """Return what it carries whether asked or not."""
        return COVERAGE[self.name].always


def candidates(
    setting: Setting,
    names: tuple[str, ...],
    known: list[Known],
    on: set[str],
    tolerance: float,
) -> Iterator[Candidate]:
    """Yield the models that the joint has, cheapest first, for what is on and reported."""
    wanted = [each for each in known if each.name in on]
    warm = any(scene.temperature is not None for scene in setting.scenes)
    cold = frozenset({EffectName.EXPANSION.value}) if warm else frozenset()
    if setting.geometry.closed_forms:
        found = _closed_form(setting, names, wanted)
        yield found._replace(missing=found.missing | cold)
    try:
        setting.geometry.layout(setting.material.elastic, setting.sizes)
    except NotAvailable:
        return
    found = _of_beams("linear", setting, names, wanted, 0.0 if setting.blade else inf)
    yield found._replace(missing=found.missing | cold)
    yield _of_beams("exact", setting, names, wanted, tolerance)


def carries(model: str, known: Known) -> bool:
    """Return whether a model can carry an effect in all that it changes."""
    covers = COVERAGE[model]
    if model == "closed-form" or known.name in OUTER:
        return known.formula
    borrows = any(known.estimates.get(name) for name in covers.borrowed)
    return known.name in covers.can | covers.always and not borrows


def errors_of(model: Candidate, known: list[Known], on: set[str]) -> dict[str, float]:
    """Return the error of each reported quantity: the model's own, and what it leaves out."""
    out = [k for k in known if (k.name not in on or k.name in model.missing)]
    left = [k for k in out if k.name not in model.always]
    return {
        name: own + sum(k.estimates.get(name, 0.0) for k in left)
        for name, own in model.errors.items()
    }


def error_of(model: Candidate, known: list[Known], on: set[str]) -> float:
    """Return the largest error of a quantity."""
    return max(errors_of(model, known, on).values(), default=0.0)


def tolerance_for(setting: Setting, names: tuple[str, ...], asked: float) -> float:
    """Return the exact model's: a hundredth of the accuracy, finer where the shift is small.

    Motions are solved to a share of the largest of them, next to which a shift is small.
    """
    wanted = asked / 100.0
    blade, travel = setting.blade, setting.largest_travel
    if "shift" in names and blade is not None and travel:
        try:
            shift = abs(float(setting.geometry.parasitic_shift(setting.sizes, travel)))
        except NotAvailable:
            shift = inf
        reach = travel * float(blade.l) if setting.geometry.motion == "rotation" else travel
        wanted *= min(1.0, shift / reach)
    return min(max(wanted, FINE), COARSE)


def _closed_form(setting: Setting, names: tuple[str, ...], wanted: list[Known]) -> Candidate:
    """Return the closed form, corrected, with the error that its estimates promise."""
    missing = frozenset(each.name for each in wanted if not carries("closed-form", each))
    used = [each.effect for each in wanted if each.name not in missing]
    cost = COVERAGE["closed-form"].cost + sum(effect.cost for effect in used)
    own = {}
    for name in names:
        error = estimate(setting, QuantityKind(name), used).error
        own[name] = inf if error is None else error.largest
    return Candidate("closed-form", cost, own, missing)


def _of_beams(
    model: str, setting: Setting, names: tuple[str, ...], wanted: list[Known], own: float
) -> Candidate:
    """Return a model of beams, with corrections for what no beam has."""
    covers = COVERAGE[model]
    cost, missing, errors = covers.cost, set(), dict.fromkeys(names, own)
    if model == "exact":  # its own error is its tolerance
        cost *= 1.0 + log10(COARSE / own) / log10(COARSE / FINE)
    for each in wanted:
        if not carries(model, each):
            missing.add(each.name)
        elif each.name in OUTER:
            cost += each.effect.cost
            for name, change in each.effect.all_changes(setting).items():
                if name in errors:
                    errors[name] += change.error
    return Candidate(model, cost, errors, frozenset(missing))


def not_reached(asked: float, error: float) -> Note:
    """Return the note that no model is as accurate as is asked."""
    most = f"may be {100.0 * error:.3g} %" if isfinite(error) else "is unknown"
    text = f"an accuracy of {100.0 * asked:.3g} % is not reached: the error {most}"
    return Note("accuracy-not-reached", text)
