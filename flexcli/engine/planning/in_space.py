"""The plan of a mechanism in space: its models in turn, until one is as accurate as is asked.

Plates, sheets and restrained warping are in the springs of all of them; what a stroke leaves out
of small motion is what they differ in. How far exact blades are off is known where they are
solved: a finer model is asked only where those before it do not do.
"""

from collections.abc import Iterator
from math import inf

from flexcli.engine.models import NamedModel, series_of
from flexcli.engine.planning.candidates import not_reached
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Ask, JointModel
from flexcli.results import EffectRow, QuantityKind
from flexcli.results.plan import AuditRow, ModelRow, Plan

__all__ = ["audit_in_space", "plan_in_space"]

COSTS = {"linear": 40.0, "exact": 400.0, "shell": 1500.0}
"""Of a stroke in closed forms of a joint, as measured on guides of two blades."""

SMALL = 1e-3
"""Share of the stroke at which nothing is of second order."""

OF_TRAVEL = (QuantityKind.STRESS, QuantityKind.SHIFT)
"""What large motion changes; stiffness, frequency and sag are stated at rest."""

FINEST = "exact"


def plan_in_space(design: DesignSpec, sizes: Sizes, model: str | None, asked: float) -> Plan:
    """Return what a mechanism in space calls for at an accuracy, and the cheapest model that does.

    Raises
    ------
    SolveError
        When it does not have the model that is insisted on.

    """
    kinds = tuple(_reported(design))
    names = (model,) if model is not None else series_of(design)
    found: dict[str, dict[str, float]] = {}
    for name in names:
        asks = design.asks(sizes, NamedModel(design, name).joint_model)
        found[name] = {kind.value: _error(asks, kind) for kind in kinds}
        if max(found[name].values()) <= asked:
            break
    chosen = min(found, key=lambda name: (max(*found[name].values(), asked), COSTS[name]))
    most = max(found[chosen].values())
    notes = []
    if most > asked:
        notes.append(not_reached(asked, most))
    return Plan(
        accuracy=asked,
        reported=tuple(kind.value for kind in kinds),
        effects=tuple(_large_motion(design, sizes, kinds, chosen)),
        models=tuple(
            ModelRow(name, COSTS[name], max(errors.values()), ()) for name, errors in found.items()
        ),
        model=chosen,
        cost=COSTS[chosen],
        estimated_error=most,
        tolerance=0.0,
        errors=found[chosen],
        notes=tuple(notes),
    )


def audit_in_space(design: DesignSpec, sizes: Sizes, found: Plan) -> tuple[AuditRow, ...]:
    """Return what large motion truly changes, exact blades over linear ones, beside the plan."""
    asks, fine = design.asks(sizes, _linear(design)), NamedModel(design, FINEST).joint_model
    rows = []
    for effect in found.effects:
        for name, estimate in effect.estimates.items():
            change, how = None, f"{FINEST} over linear, largest of all cases"
            try:
                each = [_number(a._replace(joint_model=fine), name) / _number(a, name) - 1.0
                        for a in asks if a.scene.moves]  # fmt: skip
                change = max(each, key=abs)
            except (NotAvailable, SolveError) as error:
                how = f"the {FINEST} model does not tell: a {design.geometry.name} {error}"
            right = None if change is None else effect.on or abs(change) <= found.accuracy
            rows.append(AuditRow(effect.name, effect.on, name, estimate, change, right, how))
    return tuple(rows)


def _linear(design: DesignSpec) -> JointModel:
    return NamedModel(design, "linear").joint_model


def _reported(design: DesignSpec) -> Iterator[QuantityKind]:
    """Yield which numbers a design in space reports of those that its models have errors of."""
    asked, scenes = design.requirements, design.scenes()
    yield QuantityKind.STIFFNESS
    if (asked.fatigue or asked.yielding) and any(scene.is_stressed for scene in scenes):
        yield QuantityKind.STRESS
    if any(scene.moves for scene in scenes):
        yield QuantityKind.SHIFT
    if any(scene.sags for scene in scenes):
        yield QuantityKind.SAG
    if design.geometry.has_masses:
        yield QuantityKind.FREQUENCY


def _error(asks: list[Ask], kind: QuantityKind) -> float:
    """Return the largest error of a kind of number over all cases, endless where unknown."""
    each = [ask.joint_model.error(ask, kind) for ask in asks if _has(ask, kind)]
    return max((inf if error is None else float(error.largest) for error in each), default=0.0)


def _has(ask: Ask, kind: QuantityKind) -> bool:
    """Return whether a case has a number of a kind."""
    if kind is QuantityKind.STRESS:
        return ask.scene.is_stressed
    return kind is not QuantityKind.SHIFT or ask.scene.moves


def _large_motion(
    design: DesignSpec, sizes: Sizes, kinds: tuple[QuantityKind, ...], model: str
) -> Iterator[EffectRow]:
    """Yield what the strokes leave out of small motion, by its second order."""
    asks = [ask for ask in design.asks(sizes, _linear(design)) if ask.scene.moves]
    if not asks:
        return
    estimates = {}
    for kind in OF_TRAVEL:
        if kind in kinds:
            whole, small = _error(asks, kind), _error([_shrunk(ask) for ask in asks], kind)
            estimates[kind.value] = max(whole - small, 0.0) if whole < inf else inf
    travel = max(ask.scene.travel + ask.scene.mean_travel for ask in asks)
    turns = design.geometry.motion == "rotation"
    indicator = travel if turns else travel / design.geometry.length(asks[0].sizes)
    on = model != "linear"
    why = "second order of small motion; " + (
        f"in the {model} model" if on else "small enough to leave out"
    )
    name = EffectName.LARGE_ROTATION
    most = max(estimates.values(), default=0.0)
    text = f"{'θ' if turns else 'stroke/l'} = {indicator:.2g}, {why}"
    yield EffectRow(name, on, indicator, most, text, estimates)


def _shrunk(ask: Ask) -> Ask:
    scene = ask.scene
    return ask._replace(
        scene=scene._replace(
            travel=SMALL * scene.travel,
            mean_travel=SMALL * scene.mean_travel,
            middle=SMALL * scene.middle,
        )
    )


def _number(ask: Ask, name: str) -> float:
    """Return the stress or the shift of a case by the model that is asked."""
    if name == QuantityKind.SHIFT:
        return float(ask.joint_model.parasitic_shift(ask))
    return max(abs(float(each.largest)) for each in ask.joint_model.stresses(ask)[1])
