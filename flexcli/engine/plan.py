"""The verb plan: which effects a design calls for, and the cheapest model that carries them.

Nothing is solved: effects are estimated by formulas. Half of the accuracy asked is for what is
left out, all of it together, so that many small effects don't add up to a large one; the other
half is for the model.
"""

from collections.abc import Iterator
from math import inf

from flexcli.engine import omitted_effects
from flexcli.engine.joint_models.corrected import Corrected
from flexcli.engine.planning.candidates import (
    Candidate,
    Known,
    candidates,
    carries,
    error_of,
    errors_of,
    not_reached,
    tolerance_for,
)
from flexcli.engine.planning.coverage import COVERAGE
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import MODEL_EFFECTS, SCENE_EFFECTS, ModelEffect, Setting
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import AS_PRINTED, JointModel
from flexcli.results import EffectRow, Note
from flexcli.results.plan import ModelRow, Plan

__all__ = ["ACCURACY", "plan", "planned_model"]

ACCURACY = 0.01
"""What ``flexure plan`` takes where the spec asks for none."""


def plan(
    design: DesignSpec, sizes: Sizes, model: str | None = None, accuracy: float | None = None
) -> Plan:
    """Return what to simulate and by which model.

    Parameters
    ----------
    design : DesignSpec
        The design.
    sizes : named tuple
        Its sizes [m].
    model : str, optional
        The model that the user insists on.
    accuracy : float, optional
        Accuracy where the spec states none; without either only what is asked for is on.

    Returns
    -------
    Plan
        Effects, models and the choice.

    Raises
    ------
    SolveError
        When the joint does not have the model insisted on, or none at all.

    """
    asked = design.accuracy or accuracy or inf
    if design.geometry.in_space:
        from flexcli.engine.planning.in_space import plan_in_space

        return plan_in_space(design, sizes, model, asked)
    setting = omitted_effects.setting(design, sizes)
    names = omitted_effects.reported(design, setting)
    known = list(_known(design, setting, names))
    on = _wanted(known, asked)
    tolerance = tolerance_for(setting, names, asked)
    models = list(candidates(setting, names, known, on, tolerance))
    chosen = _taken(design, models, known, on, asked, model)
    carried = (on - chosen.missing) | _always_in_beams(known, chosen)
    rows = (_row(k, on, carried, chosen, models) for k in known)
    return Plan(
        accuracy=asked,
        reported=names,
        effects=(*rows, *_scene_rows(setting)),
        models=tuple(
            ModelRow(m.name, m.cost, error_of(m, known, on), tuple(sorted(m.missing)))
            for m in models
        ),
        model=chosen.name,
        cost=chosen.cost,
        estimated_error=error_of(chosen, known, carried),
        errors=errors_of(chosen, known, carried),
        tolerance=tolerance,
        notes=(*_notes(known, chosen, on, asked), *_excluded(setting, on)),
    )


def planned_model(found: Plan) -> JointModel:
    """Return the model of a plan in the plane, with the effects that are on and no others."""
    on = set(found.on)
    inner: JointModel = AS_PRINTED
    if found.model != "closed-form":
        from flexcli.engine.joint_models.exact import ExactModel
        from flexcli.engine.joint_models.linear import LinearModel
        from flexcli.mechanics.mesh import Effects

        off = {row.name for row in found.effects if row.asked == "off"}
        blades = Effects(
            extension=EffectName.AXIAL_EXTENSION not in off, shear=EffectName.SHEAR not in off
        )
        exact = found.model == ExactModel.name
        inner = ExactModel(blades, found.tolerance) if exact else LinearModel(blades)
    extra = [e for e in MODEL_EFFECTS if e.name in on and e.name not in inner.covers | inner.always]
    return Corrected(inner, extra, _named(inner, extra))


def _named(inner: JointModel, extra: list[ModelEffect]) -> str:
    name = "closed-form" if inner is AS_PRINTED else inner.name
    return f"{name} with {', '.join(e.name for e in extra)}" if extra else name


def _known(design: DesignSpec, setting: Setting, names: tuple[str, ...]) -> Iterator[Known]:
    for effect in MODEL_EFFECTS:
        indicator = effect.indicator(setting)
        if indicator is not None:
            found, changes = effect.estimates(setting), effect.all_changes(setting)
            estimates = {name: found[name] for name in names if name in found}
            formula = all(changes[name].value is not None for name in estimates)
            asked = design.effects.get(effect.key, "auto")
            yield Known(effect, *indicator, estimates, asked, effect.lacks(setting), formula)


def _wanted(known: list[Known], asked: float) -> set[str]:
    """Return what is on: the smallest are left out while all of them together stay in half."""
    on = {k.name for k in known if k.asked == "on" and not k.lacks}
    left: dict[str, float] = {}
    for each in sorted((k for k in known if k.asked == "auto"), key=lambda k: k.most):
        total = {name: left.get(name, 0.0) + e for name, e in each.estimates.items()}
        if all(e <= asked / 2.0 for e in total.values()):
            left |= total
        elif not each.lacks:
            on.add(each.name)
    return on


def _taken(
    design: DesignSpec,
    models: list[Candidate],
    known: list[Known],
    on: set[str],
    asked: float,
    model: str | None,
) -> Candidate:
    """Return the model insisted on, else the cheapest that will do.

    Where none does, it is the most accurate of those that carry the most of what is on.
    """
    names = ", ".join(m.name for m in models)
    if model is not None:
        models = [m for m in models if m.name == model]
    if not models:
        what = f"no {model} model to plan with" if model else "no model to plan with"
        remedy = f"take --model {names}" if names else "leave accuracy: out; check judges it"
        raise SolveError("no-model", f"a {design.geometry.name} has {what}", remedy)
    heard = [k for k in known if k.asked != "off"]
    good = [m for m in models if not m.missing and error_of(m, heard, on) <= asked]
    if good:
        return min(good, key=lambda m: m.cost)
    return min(models, key=lambda m: (len(m.missing), error_of(m, heard, on), m.cost))


def _always_in_beams(known: list[Known], model: Candidate) -> set[str]:
    """Return the effects that beams have whether they matter or not, unless the spec forbids.

    Blades that do not stretch have no answer in a joint that is held more than it needs.
    """
    can = COVERAGE[model.name].can
    return {k.name for k in known if k.name in can and k.asked != "off" and not k.lacks}


def _row(
    known: Known, on: set[str], carried: set[str], model: Candidate, models: list[Candidate]
) -> EffectRow:
    name, estimates = known.name, known.estimates
    could = tuple(m.name for m in models if carries(m.name, known))
    most = max(estimates, key=lambda n: estimates[n], default="")
    if known.lacks and known.asked != "off":
        why = f"left out, for it needs {known.lacks}"
    elif known.asked != "auto":
        why = f"{known.asked} by the spec"
    elif name in model.missing:
        why = f"not in the {model.name} model"
    elif name in on:
        why = f"matters most in {most}"
    elif name in carried or name in model.always:
        why = f"always in the {model.name} model"
    else:
        why = "small enough to leave out" if most else "changes nothing that is reported"
    return EffectRow(
        name=name,
        on=name in carried,
        indicator=known.indicator,
        estimate=known.most,
        reason=f"{known.text}; {why}",
        estimates=estimates,
        asked=known.asked,
        models=could,
    )


def _scene_rows(setting: Setting) -> Iterator[EffectRow]:
    """Yield what the scene has; what it has not is not there."""
    for effect in SCENE_EFFECTS:
        found = effect.indicator(setting)
        if found is not None:
            reason = f"{found.text}; the scene has it"
            estimates = effect.estimates(setting)
            most = max(estimates.values(), default=0.0)
            yield EffectRow(effect.name, True, found.value, most, reason, estimates)


def _excluded(setting: Setting, on: set[str]) -> Iterator[Note]:
    """Yield what is on but cannot be beside what the scene has."""
    for effect in SCENE_EFFECTS:
        shut_out = sorted(effect.shuts_out & on)
        if shut_out and effect.indicator(setting) is not None:
            text = f"{effect.name}: the scene in time has no {', '.join(shut_out)}"
            yield Note("effect-excluded", text)


def _notes(known: list[Known], model: Candidate, on: set[str], asked: float) -> Iterator[Note]:
    for each in known:
        if each.lacks and (each.asked == "on" or (each.asked == "auto" and each.most > asked / 2)):
            yield Note("effect-needs", f"{each.name} is left out: it needs {each.lacks}")
    if model.missing:
        text = f"the {model.name} model does not carry {', '.join(sorted(model.missing))}"
        yield Note("effect-not-in-model", text)
    error = error_of(model, [k for k in known if k.asked != "off"], on)
    if error > asked:
        yield not_reached(asked, error)
