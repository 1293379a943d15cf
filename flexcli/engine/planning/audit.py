"""The audit of a plan: what each effect truly changes, by the finest model with and without it."""

from collections.abc import Callable, Iterator, Mapping

from flexcli.engine.answers.exact import ExactAnswers
from flexcli.engine.answers.linear import LinearAnswers
from flexcli.errors import SolveError
from flexcli.mechanics.mesh import Effects
from flexcli.parts.design import DesignSpec
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import AS_PRINTED, Answers, Ask
from flexcli.results import AuditRow, EffectRow, Plan

__all__ = ["audit"]

TOLERANCE = 1e-11
"""Of the finest model; a share that is not larger by far is not seen."""

SEEN = 1e-7
"""Smallest contribution that can be told from the tolerance, of shifts in particular."""

ALL, NONE = Effects(), Effects(extension=False, shear=False)

HOW: dict[str, str] = {
    EffectName.SHEAR: "exact with and without",
    EffectName.AXIAL_EXTENSION: "exact with and without",
    EffectName.BLADE_TENSION: "linear, both faces, over the bending of the closed form",
    EffectName.LARGE_ROTATION: "exact over first order, blades that neither shear nor stretch",
    EffectName.AXIAL_LOAD: "exact with and without the forces, blades that do not stretch",
}

Number = Callable[[Answers, Ask], float]


def audit(design: DesignSpec, sizes: Sizes, found: Plan) -> tuple[AuditRow, ...]:
    """Return true contributions beside the estimates of a plan, and whether it was right."""
    asks = design.asks(sizes, AS_PRINTED)
    rows: list[AuditRow] = []
    for effect in found.effects:
        true = _true(effect.name, asks, found.reported)
        rows.extend(_rows(effect, true, found.accuracy))
    return tuple(rows)


def _rows(
    effect: EffectRow, true: Mapping[str, float] | None, accuracy: float
) -> Iterator[AuditRow]:
    for name, estimate in effect.estimates.items():
        if true is None or name not in true:
            how = "no model can switch it: the estimate is all there is"
            yield AuditRow(effect.name, effect.on, name, estimate, None, None, how)
            continue
        right = effect.on or abs(true[name]) <= accuracy
        yield AuditRow(effect.name, effect.on, name, estimate, true[name], right, HOW[effect.name])


def _true(effect: str, asks: list[Ask], names: tuple[str, ...]) -> dict[str, float] | None:
    """Return the relative change of each number that the effect makes, largest of all cases."""
    if effect not in HOW:
        return None
    found: dict[str, float] = {}
    for ask in asks:
        for name in names:
            if name in NUMBERS:
                change = _change(effect, ask, name)
                if change is not None and abs(change) >= abs(found.get(name, 0.0)):
                    found[name] = change
    if "stiffness" in found and "frequency" in names:
        found["frequency"] = (1.0 + found["stiffness"]) ** 0.5 - 1.0
    return found


def _change(effect: str, ask: Ask, name: str) -> float | None:
    """Return the change of one number in one case, nothing where it is not there or not known."""
    number, bends = NUMBERS[name], ask.scene.bends
    if (name in ("stress", "shift") and not bends) or (name == "buckling" and not ask.scene.ends):
        return None
    if name == "sag" and not ask.scene.acceleration:
        return None
    full, calm = _exact(ALL), ask._replace(scene=ask.scene.without_loads())
    try:
        if effect == EffectName.SHEAR:
            return number(full, ask) / number(_exact(ALL._replace(shear=False)), ask) - 1.0
        if effect == EffectName.AXIAL_EXTENSION:
            return number(full, ask) / number(_exact(ALL._replace(extension=False)), ask) - 1.0
        if effect == EffectName.BLADE_TENSION:
            if name != "stress":
                return 0.0
            return number(LinearAnswers(NONE), calm) / number(AS_PRINTED, calm) - 1.0
        if effect == EffectName.LARGE_ROTATION:
            if name not in ("stress", "shift"):
                return 0.0
            first = LinearAnswers(NONE)
            return number(_exact(NONE), calm) / number(first, calm) - 1.0
        if name != "stress":
            return 0.0
        axial = number(AS_PRINTED, ask) - number(AS_PRINTED, calm)
        short = _exact(ALL._replace(extension=False))
        return number(short, ask) / (number(short, calm) + axial) - 1.0
    except (NotAvailable, SolveError):
        return None


def _exact(effects: Effects) -> ExactAnswers:
    return ExactAnswers(effects, TOLERANCE)


def _stress(answers: Answers, ask: Ask) -> float:
    return max(abs(float(s.largest)) for s in answers.stresses(ask)[1])


def _critical(answers: Answers, ask: Ask) -> float:
    found = answers.critical(ask)
    return min(float(c.force) for c in found if c.way != "across the width")


NUMBERS: dict[str, Number] = {
    "stiffness": lambda answers, ask: float(answers.stiffness(ask)),
    "stress": _stress,
    "shift": lambda answers, ask: float(answers.parasitic_shift(ask)),
    "buckling": _critical,
    "sag": lambda answers, ask: 1.0 / float(answers.sag_stiffness(ask)),
}
