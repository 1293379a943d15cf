"""The plan of a mechanism in space: its models in turn, until one is as accurate as is asked.

Plates, sheets and restrained warping are in the springs of all of them; what a stroke leaves out
of small motion is what they differ in. How far exact blades are off is known where they are
solved: a finer model is asked only where those before it do not do.
"""

from collections.abc import Iterator
from contextlib import suppress
from math import inf

import numpy as np

from flexcli.engine.models import NamedModel, series_of
from flexcli.engine.omitted_effects import setting
from flexcli.engine.planning.candidates import not_reached
from flexcli.errors import SolveError
from flexcli.formulas.plate_factors import bound
from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.layout import SpaceBlade
from flexcli.parts.design import DesignSpec
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import Setting
from flexcli.parts.effects.warping import Warping
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import BEAM_EFFECTS, Sizes
from flexcli.parts.requirements import Ask, JointModel
from flexcli.parts.requirements.support import CENTRE, HELD, compliance_of
from flexcli.parts.space_joint import joint_in_space
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
    felt = tuple(_of_blades(design, sizes, kinds))
    left = {k.value: sum(e.estimates.get(k.value, 0.0) for e in felt if not e.on) for k in kinds}
    found: dict[str, dict[str, float]] = {}
    for name in names:
        asks = design.asks(sizes, NamedModel(design, name).joint_model)
        found[name] = {kind.value: _error(asks, kind) + left[kind.value] for kind in kinds}
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
        effects=(*_large_motion(design, sizes, kinds, chosen), *felt),
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
    """Return what effects truly change by exact blades, largest of all cases, beside the plan.

    Large motion is over linear blades, what blades feel over exact ones without it.
    """
    asks, rows = design.whole.asks(sizes, NamedModel(design, FINEST).joint_model), []
    for effect in found.effects:
        if effect.name == EffectName.LARGE_ROTATION:
            how, others = f"{FINEST} over linear", design.whole.asks(sizes, _linear(design))
        else:
            how, others = f"{FINEST} with and without", _without(asks, EffectName(effect.name))
        for name, estimate in effect.estimates.items():
            change = None
            try:
                change = max(_changes(asks, others, name), key=abs)
            except (NotAvailable, SolveError) as error:
                how = f"the {FINEST} model does not tell: a {design.geometry.name} {error}"
            right = None
            if change is not None and effect.asked != "off":
                right = effect.on or abs(change) <= found.accuracy
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
    if kind is QuantityKind.SAG:
        return ask.scene.sags
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


def _of_blades(
    design: DesignSpec, sizes: Sizes, kinds: tuple[QuantityKind, ...]
) -> Iterator[EffectRow]:
    """Yield what blades feel that a spec may leave out, and what it changes of small motion.

    What curvature flattens is bounded, as is what held ends stiffen at a stroke.
    """
    given, asks = setting(design, sizes), design.whole.asks(sizes, _linear(design))
    names = [kind.value for kind in kinds]
    if given.supports:
        names.append(QuantityKind.SUPPORT.value)
    nu = given.poisson_bound
    for name in BEAM_EFFECTS:
        text, indicator = _felt(asks[0], given, name)
        if not indicator:
            continue
        others = _without(asks, name)
        estimates = {n: max(map(abs, _changes(asks, others, n)), default=0.0) for n in names}
        plate = float(bound(nu))
        if name is EffectName.ANTICLASTIC:
            # moments by no more than a plate's, torsion by no more than GJ/(1 − ν)
            estimates |= {n: plate for n in OF_TRAVEL if n in estimates}
            if given.supports:
                estimates[QuantityKind.SUPPORT] = nu / (1.0 - nu)
        elif name is EffectName.PLATE_WIDENING:
            # at a stroke with what curvature does to it
            at_stroke = (*OF_TRAVEL, QuantityKind.SUPPORT)
            estimates |= {n: 2.0 * plate for n in at_stroke if given.largest_travel and n in names}
        elif name is EffectName.WARPING:
            estimates |= Warping().estimates(given)
        on = name not in design.omitted
        why = f"{text}; {'in every model' if on else 'off by the spec'}"
        asked = design.effects.get(name.key, "auto")
        yield EffectRow(name, on, indicator, max(estimates.values()), why, estimates, asked)


def _felt(ask: Ask, given: Setting, name: EffectName) -> tuple[str, float]:
    """Return how much of an effect the blades have, in words and as a number."""
    if name is EffectName.WARPING:
        found = Warping().indicator(given._replace(supports=True))
        return ("", 0.0) if found is None else (found.text, found.value)
    joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
    travel = np.array([given.largest_travel])
    moved = joint.assembly.moved(travel=travel).deformations[:, 0]
    widest, curled = 0.0, 0.0
    for k, (blade, member) in enumerate(
        zip(joint.layout.blades, joint.assembly.members, strict=True)
    ):
        if isinstance(blade, SpaceBlade) and isinstance(blade.profile, Constant):
            b, l = blade.b, member.l
            kappa = abs(moved[6 * k + 5]) / l + 6.0 * abs(moved[6 * k + 1]) / l**2
            widest = max(widest, b / l)
            curled = max(curled, float(b**2 * kappa / blade.profile.h))
    if name is EffectName.PLATE_WIDENING:
        return f"b/l = {widest:.3g}", widest
    return f"b²κ/h = {curled:.2g}", curled


def _without(asks: list[Ask], effect: EffectName) -> list[Ask]:
    """Return the same questions of blades that do not feel an effect."""
    bare = {id(ask.geometry): ask.geometry.omitting(frozenset({effect})) for ask in asks}
    return [ask._replace(geometry=bare[id(ask.geometry)]) for ask in asks]


def _changes(asks: list[Ask], others: list[Ask], name: str) -> Iterator[float]:
    """Yield by what share a number of each case differs from that of another question."""
    for one, other in zip(asks, others, strict=True):
        if _has(one, QuantityKind(name)):
            pairs = zip(_numbers(one, name), _numbers(other, name), strict=True)
            yield from (a / b - 1.0 for a, b in pairs if b != 0.0)


def _numbers(ask: Ask, name: str) -> list[float]:
    """Return a number of a case by its model; of the support all that the drive does not hold."""
    model = ask.joint_model
    match name:
        case QuantityKind.STIFFNESS:
            return [float(model.stiffness(ask))]
        case QuantityKind.FREQUENCY:
            return [float(model.frequency_squared(ask)) ** 0.5]
        case QuantityKind.SAG:
            return [1.0 / float(model.sag_stiffness(ask))]
        case QuantityKind.SHIFT:
            return [float(model.parasitic_shift(ask))]
        case QuantityKind.STRESS:
            return [max(abs(float(each.largest)) for each in model.stresses(ask)[1])]
    if not ask.scene.moves or model.name == "linear":
        C = np.diag(compliance_of(ask, locked=True)).reshape(2, 3)
        return [float(1.0 / c) for block in C for c in block if c > HELD * block.sum()]
    found = []
    for index in range(6):
        with suppress(NotAvailable):  # the drive holds it
            ends = model.support_at_stroke(ask, index, CENTRE, locked=True)
            found += [value for value, _ in ends]
    return found
