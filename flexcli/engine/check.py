"""The verb check: judge the blade that the spec gives."""

from time import perf_counter

from flexcli.engine import assess
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.results import Cost, Result, Status

__all__ = ["check"]

MODEL = "closed-form"


def check(design: DesignSpec, sizes: Sizes, spec: str) -> Result:
    """Return the checks of one blade with values, effects and warnings."""
    started = perf_counter()
    rows = assess.effects(design, sizes)
    found = assess.checks(design.limits(sizes))
    passed = all(check.passed for check in found)
    return Result(
        command="check",
        spec=spec,
        status=Status.PASS if passed else Status.FAIL,
        title=design.title,
        values=assess.values(design, sizes),
        checks=found,
        effects=rows,
        warnings=assess.warnings(design, sizes, rows),
        cost=Cost(
            perf_counter() - started, MODEL, max((row.estimate for row in rows), default=None)
        ),
    )
