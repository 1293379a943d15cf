"""The verb check: judge the blade that the spec gives."""

from time import perf_counter

from flexcli.engine import assess, left_out
from flexcli.engine import values as design_values
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import CLOSED_FORM, Answers, Limit, RequirementError
from flexcli.results import Cost, Result, Status

__all__ = ["check", "judged_by"]

MODEL = "closed-form"


def check(design: DesignSpec, sizes: Sizes, spec: str, answers: Answers = CLOSED_FORM) -> Result:
    """Return the checks of one blade by a model, with values, effects and warnings."""
    started = perf_counter()
    rows = left_out.effects(design, sizes, answers)
    errors = left_out.errors(rows)
    found = assess.checks(judged_by(design, sizes, answers))
    passed = all(check.passed for check in found)
    return Result(
        command="check",
        spec=spec,
        status=Status.PASS if passed else Status.FAIL,
        title=design.title,
        values=design_values.with_errors(design_values.values(design, sizes, answers), errors),
        checks=found,
        effects=rows,
        warnings=left_out.warnings(design, sizes, rows),
        cost=Cost(
            perf_counter() - started,
            answers.model,
            max(errors.values(), default=None),
        ),
    )


def judged_by(design: DesignSpec, sizes: Sizes, answers: Answers) -> list[Limit]:
    """Return every limit by a model; what it cannot answer is a :class:`SolveError`."""
    try:
        return design.limits(sizes, answers)
    except RequirementError as error:
        raise SolveError(
            f"{answers.model}-has-no-answer", str(error), error.hint or "take another model"
        ) from error
