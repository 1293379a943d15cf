"""Values to the accuracy that a spec asks for: by the model of its plan, told with the result."""

from dataclasses import replace
from math import isfinite
from time import perf_counter

from flexcli.engine import values as design_values
from flexcli.engine.models import NamedModel
from flexcli.engine.plan import plan, planned_model
from flexcli.engine.planning.coverage import COVERAGE
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.results import Note, Result, with_seconds
from flexcli.results.plan import Plan

__all__ = ["simulate_by_plan", "told", "with_planned_values"]

LEFT_OUT = "effect-left-out"
"""The warning of results without a plan; a plan says what is left out, and why."""


def with_planned_values(
    result: Result, design: DesignSpec, sizes: Sizes, model: str | None
) -> Result:
    """Return a result with its values by the model that the spec's accuracy calls for.

    They stay as they are, with a note, where that model has no answer. Of shells and solids of a
    joint of the plane there is no plan: they judge, and values are by the cheapest other model.
    """
    started, in_space = perf_counter(), design.geometry.in_space
    judges_alone = model is not None and not in_space and model not in COVERAGE
    found = plan(design, sizes, None if judges_alone else model)
    if judges_alone:
        text = f"the {model} model judges, but plans no values: they are by the {found.model} model"
        found = found._replace(notes=(Note("values-by-another-model", text), *found.notes))
    try:
        by = NamedModel(design, found.model).joint_model if in_space else planned_model(found)
        values = design_values.values(design, sizes, by)
    except (NotAvailable, SolveError) as error:
        text = f"the {found.model} model of the plan has no answer: {error}"
        note = Note("planned-model-has-no-answer", text)
        return replace(result, warnings=(*result.warnings, note))
    kept = {name: value for name, value in result.values.items() if name not in values}
    if result.cost is not None:
        took = with_seconds(result.cost.by_model, found.model, perf_counter() - started)
        result = replace(result, cost=replace(result.cost, by_model=took))
    return told(replace(result, values={**kept, **values}), found)


def simulate_by_plan(design: DesignSpec, sizes: Sizes, spec: str, points: int) -> Result:
    """Return the sweep over the stroke with the effects of the plan and no others."""
    from flexcli.engine.simulate import simulate
    from flexcli.mechanics.mesh import Effects

    found = plan(design, sizes, "exact")
    on = set(found.on)
    blades = Effects(extension=EffectName.AXIAL_EXTENSION in on, shear=EffectName.SHEAR in on)
    return told(simulate(design, sizes, spec, points, blades), found)


def told(result: Result, found: Plan) -> Result:
    """Return a result with its plan: effects on and off, notes, the error that is left."""
    kept = tuple(note for note in result.warnings if note.code != LEFT_OUT)
    cost = result.cost
    if cost is not None:
        cost = replace(cost, estimated_error=found.known_error)
    warnings = (*kept, *found.notes)
    known = {name: error for name, error in found.errors.items() if isfinite(error)}
    values = design_values.with_errors(result.values, known)
    return replace(
        result, values=values, effects=found.effects, warnings=warnings, cost=cost, plan=found
    )
