"""The verbs run by the plan of the spec: its model judges, its effects are told with the result."""

from dataclasses import replace
from math import isfinite

from flexcli.engine import values as design_values
from flexcli.engine.check import check
from flexcli.engine.plan import plan, planned_answers
from flexcli.engine.size import size
from flexcli.engine.sizing.corrected import size_by_model
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import CLOSED_FORM
from flexcli.results import Plan, Result

__all__ = ["check_by_plan", "simulate_by_plan", "size_by_plan", "told"]

ROUNDS = 3
"""Sizes that a plan is made for before the last one is taken."""

LEFT_OUT = "effect-left-out"
"""The warning of results without a plan; a plan says what is left out, and why."""


def check_by_plan(design: DesignSpec, sizes: Sizes, spec: str, model: str | None) -> Result:
    """Return the checks of given sizes by the model of the plan, or the one insisted on."""
    found = plan(design, sizes, model)
    return told(check(design, sizes, spec, planned_answers(found)), found)


def size_by_plan(design: DesignSpec, spec: str, model: str | None) -> Result:
    """Return the design sized by the model that the sized design calls for.

    The closed forms size it first; the plan is made for what they find, and once more for what
    its own model finds, until it asks for nothing else.
    """
    result, judge = size(design, spec), CLOSED_FORM.model
    for _ in range(ROUNDS):
        sizes = _sizes(design, result)
        if sizes is None:
            return result
        found = plan(design, sizes, model)
        answers = planned_answers(found)
        if answers.model == judge:
            break
        result, judge = size_by_model(design, spec, answers), answers.model
    return told(result, found)


def simulate_by_plan(design: DesignSpec, sizes: Sizes, spec: str, points: int) -> Result:
    """Return the sweep over the stroke with the effects of the plan and no others."""
    from flexcli.engine.simulate import simulate
    from flexcli.mechanics.mesh import Effects

    found = plan(design, sizes, "exact")
    blades = Effects(extension="axial extension" in found.on, shear="shear" in found.on)
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


def _sizes(design: DesignSpec, result: Result) -> Sizes | None:
    """Return the sizes that a sizing chose, if any."""
    free = design.geometry.free
    if any(name not in result.values for name in free):
        return None
    return design.geometry.sized({name: result.values[name].value for name in free})
