"""The audit of a plan: what each effect truly changes, by the finest model with and without it."""

from collections.abc import Callable, Iterator, Mapping
from math import isfinite
from typing import NamedTuple

from flexcli.engine.joint_models.corrected import Corrected
from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.joint_models.linear import LinearModel
from flexcli.errors import SolveError
from flexcli.mechanics.mesh import Effects
from flexcli.parts.design import DesignSpec
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import MODEL_EFFECTS, ModelEffect, Setting
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import AS_PRINTED, Ask, JointModel
from flexcli.results import EffectRow
from flexcli.results.plan import AuditRow, Plan

__all__ = ["audit"]

TOLERANCE = 1e-11
"""Of the finest model; a share that is not larger by far is not seen."""

ALL, NONE = Effects(), Effects(extension=False, shear=False)

HOW: dict[str, str] = {
    EffectName.SHEAR: "exact with and without",
    EffectName.AXIAL_EXTENSION: "exact with and without",
    EffectName.BLADE_TENSION: "linear, both faces, over the bending of the closed form",
    EffectName.LARGE_ROTATION: "exact over first order, blades that neither shear nor stretch",
    EffectName.AXIAL_LOAD: "exact with and without the forces, blades that do not stretch",
    EffectName.HINGE_LENGTH: "exact at a hundredth of the stroke over the closed form of pins",
    EffectName.PLATE_WIDENING: "exact with and without the correction of the plate",
    EffectName.ANTICLASTIC: "exact with and without the correction of the curved plate",
    EffectName.WARPING: "closed form with and without",
    EffectName.CLAMP_COMPLIANCE: "exact with and without the correction of the roots",
    EffectName.THICK_NOTCH: "exact with and without the correction of the plane body",
    EffectName.EXPANSION: "exact with and without the temperature, over the larger of both",
    EffectName.BLADE_MASS: "modes with and without the blades' mass",
}

FORMULAS = (
    EffectName.PLATE_WIDENING,
    EffectName.ANTICLASTIC,
    EffectName.CLAMP_COMPLIANCE,
    EffectName.THICK_NOTCH,
    EffectName.BLADE_MASS,
)
"""Effects that the finest model has as corrections of what it solves."""

SMALL = 0.01
"""Share of the stroke at which nothing is of next order."""

Number = Callable[[JointModel, Ask], float]


class _True(NamedTuple):
    """A change as the finest model has it, nothing where it does not tell, and how or why."""

    change: float | None
    how: str


def audit(design: DesignSpec, sizes: Sizes, found: Plan) -> tuple[AuditRow, ...]:
    """Return true contributions beside the estimates of a plan, and whether it was right."""
    asks = design.asks(sizes, AS_PRINTED)
    rows: list[AuditRow] = []
    for effect in found.effects:
        true = _true(effect.name, asks, found.reported)
        rows.extend(_rows(effect, true, found.accuracy))
    return tuple(rows)


def _rows(effect: EffectRow, true: Mapping[str, _True], accuracy: float) -> Iterator[AuditRow]:
    for name, estimate in effect.estimates.items():
        change, how = true.get(name, _True(None, "no model can switch it: all there is"))
        right = None
        if change is not None and (effect.on or effect.asked != "off"):
            right = effect.on or abs(change) <= accuracy
        yield AuditRow(effect.name, effect.on, name, estimate, change, right, how)


def _true(effect: str, asks: list[Ask], names: tuple[str, ...]) -> dict[str, _True]:
    """Return the relative change of each number that the effect makes, largest of all cases."""
    found: dict[str, _True] = {}
    for ask in asks if effect in HOW else ():
        for name in names:
            try:
                change = _change(effect, ask, name)
            except (NotAvailable, SolveError) as error:
                text = f"the finest model does not tell: a {ask.geometry.name} {error}"
                found.setdefault(name, _True(None, text))
                continue
            before = found.get(name)
            if change is None or not isfinite(change):
                continue
            if before is None or before.change is None or abs(change) >= abs(before.change):
                found[name] = _True(change, HOW[effect])
    stiffness = found.get("stiffness")
    if stiffness is not None and stiffness.change is not None and "frequency" in names:
        half = _True((1.0 + stiffness.change) ** 0.5 - 1.0, stiffness.how)
        found.setdefault("frequency", half)
    return found


def _change(effect: str, ask: Ask, name: str) -> float | None:
    """Return the change of one number in one case, nothing where it is not there."""
    if effect in FORMULAS:
        return _corrected_by(effect, ask, name)
    if name not in NUMBERS:
        return None
    number, bends = NUMBERS[name], ask.scene.bends
    if effect == EffectName.EXPANSION:
        return _by_temperature(number, ask)
    if (name in ("stress", "shift") and not bends) or (name == "buckling" and not ask.scene.ends):
        return None
    if name == "sag" and not ask.scene.sags:
        return None
    if effect == EffectName.WARPING:
        whole, without = (
            ask._replace(geometry=ask.geometry.omitting(frozenset(off)))
            for off in ((), (EffectName.WARPING,))
        )
        return number(AS_PRINTED, whole) / number(AS_PRINTED, without) - 1.0
    full, calm = _exact(ALL), ask._replace(scene=ask.scene.without_loads())
    scene = calm.scene._replace(
        travel=SMALL * calm.scene.travel, mean_travel=SMALL * calm.scene.mean_travel,
        middle=SMALL * calm.scene.middle,
    )  # fmt: skip
    small = calm._replace(scene=scene)
    if effect == EffectName.SHEAR:
        return number(full, ask) / number(_exact(ALL._replace(shear=False)), ask) - 1.0
    if effect == EffectName.AXIAL_EXTENSION:
        return number(full, ask) / number(_exact(ALL._replace(extension=False)), ask) - 1.0
    if effect == EffectName.BLADE_TENSION:
        if name != "stress":
            return 0.0
        return number(LinearModel(NONE), calm) / number(AS_PRINTED, calm) - 1.0
    if effect == EffectName.LARGE_ROTATION:
        if name not in ("stress", "shift"):
            return 0.0
        if name == "shift" and _own(EffectName.HINGE_LENGTH).indicator(_setting(ask)) is not None:
            # their first order is not that of the closed form, which takes hinges as pins
            return number(_exact(NONE), calm) / number(_exact(NONE), small) * SMALL**2 - 1.0
        first = LinearModel(NONE)
        return number(_exact(NONE), calm) / number(first, calm) - 1.0
    if effect == EffectName.HINGE_LENGTH:
        if name not in ("stress", "shift"):
            return 0.0
        return number(_exact(NONE), small) / number(AS_PRINTED, small) - 1.0
    if name != "stress":
        return 0.0
    axial = number(AS_PRINTED, ask) - number(AS_PRINTED, calm)
    short = _exact(ALL._replace(extension=False))
    return number(short, ask) / (number(short, calm) + axial) - 1.0


def _by_temperature(number: Number, ask: Ask) -> float | None:
    """Return what a temperature changes, over the larger of both, nothing where there is none."""
    if ask.scene.temperature is None:
        return None
    warm, cold = number(_exact(ALL), ask), 0.0
    if ask.scene.bends:
        cold = number(_exact(ALL), ask._replace(scene=ask.scene.at_assembly()))
    return (warm - cold) / max(abs(warm), abs(cold))


def _corrected_by(effect: str, ask: Ask, name: str) -> float | None:
    """Return what the correction of an effect makes of one number, nothing where it has no value.

    The number that it corrects is the same with and without it.
    """
    own, setting = _own(effect), _setting(ask)
    if own.indicator(setting) is None:
        return None
    if own.lacks(setting):
        raise NotAvailable(f"needs {own.lacks(setting)}")
    change = own.all_changes(setting).get(name)
    if change is None or change.value is None:
        return None
    finest = ExactModel()
    whole, without = (
        Corrected(finest, [e for e in MODEL_EFFECTS if e.name != out]) for out in ("", effect)
    )
    if name == "frequency":
        if effect != EffectName.BLADE_MASS:
            return None  # it follows from the stiffness
        return whole.frequency_factor(ask) / without.frequency_factor(ask) - 1.0
    if name in NUMBERS:
        return NUMBERS[name](whole, ask) / NUMBERS[name](without, ask) - 1.0
    return None


def _own(effect: str) -> ModelEffect:
    return next(each for each in MODEL_EFFECTS if each.name == effect)


def _setting(ask: Ask) -> Setting:
    return Setting(ask.material, ask.geometry, ask.mechanism, ask.sizes, (ask.scene,))


def _exact(effects: Effects) -> ExactModel:
    return ExactModel(effects, TOLERANCE)


def _stress(joint_model: JointModel, ask: Ask) -> float:
    return max(abs(float(s.largest)) for s in joint_model.stresses(ask)[1])


def _critical(joint_model: JointModel, ask: Ask) -> float:
    found = joint_model.critical(ask)
    return min(float(c.force) for c in found if c.way != "across the width")


NUMBERS: dict[str, Number] = {
    "stiffness": lambda joint_model, ask: float(joint_model.stiffness(ask)),
    "stress": _stress,
    "shift": lambda joint_model, ask: float(joint_model.parasitic_shift(ask)),
    "buckling": _critical,
    "sag": lambda joint_model, ask: 1.0 / float(joint_model.sag_stiffness(ask)),
}
