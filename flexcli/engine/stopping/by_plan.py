"""The plan of a design with stops: what its numbers, those of a beam, leave out."""

from dataclasses import replace

from flexcli.parts.design import DesignSpec
from flexcli.parts.effects import MODEL_EFFECTS
from flexcli.parts.geometries import Sizes
from flexcli.results import Result

__all__ = ["with_plan"]


def with_plan(result: Result, design: DesignSpec, sizes: Sizes) -> Result:
    """Return a sized stop with the plan of its design, where the spec asks an accuracy.

    No model of stops carries an effect of the blade: none of them is on, whatever the plan of
    the joint alone would have, and the errors are those of the numbers without them.
    """
    if design.accuracy is None:
        return result
    from flexcli.engine.plan import plan
    from flexcli.engine.planning.by_plan import told

    found = plan(design, sizes, "closed-form")
    names = {effect.name for effect in MODEL_EFFECTS}
    rows = tuple(
        row._replace(on=False, reason=f"{row.reason}; left out of the numbers of stops")
        if row.name in names and row.on
        else row
        for row in found.effects
    )
    errors = {n: v.estimated_error for n, v in result.values.items() if v.estimated_error}
    worst = max(errors.values(), default=0.0)
    planned = told(result, found._replace(effects=rows, errors={}, estimated_error=worst))
    return replace(planned, values=result.values)
