"""Studies: one verb at many points of a spec, a row for each; above the verbs of the API."""

from collections.abc import Mapping, Sequence
from math import inf, isnan
from typing import Any, Literal

from flexcli import api
from flexcli.errors import SolveError, SpecError
from flexcli.results import Check, Result
from flexcli.results.study import Column, StudyResult, StudyRow

__all__ = ["collected", "row_of"]

Each = Literal["check", "size", "simulate"]


def row_of(
    source: api.Spec,
    overrides: Mapping[str, Any],
    each: Each,
    model: str | None,
    varied: Mapping[str, str] | None = None,
) -> tuple[StudyRow, tuple[Column, ...]]:
    """Return the row of one point and its columns; what goes wrong is its reason.

    ``varied`` are those of the overrides that make the point; all, if left out.
    """
    point = dict(overrides) if varied is None else varied
    try:
        if each == "simulate":
            result = api.simulate(source, overrides=overrides)
        else:
            verb = api.size if each == "size" else api.check
            result = verb(source, model=model, overrides=overrides)
    except SpecError as error:
        reason = "; ".join(f"{found.path or found.file}: {found.text}" for found in error.findings)
        return StudyRow(point, "error", "", "", reason, {}), ()
    except SolveError as error:
        return StudyRow(point, "undecided", "", "", error.text, {}), ()
    return _row(point, result)


def _row(point: Mapping[str, str], result: Result) -> tuple[StudyRow, tuple[Column, ...]]:
    cells: dict[str, float | str] = {}
    columns: list[Column] = []

    def cell(name: str, unit: str, label: str, value: float | str) -> None:
        columns.append(Column(name, unit, label))
        cells[name] = value

    for name, value in result.values.items():
        cell(name, value.unit, value.label, value.value)
    for check in result.checks:
        name = check.full_name
        cell(f"factor of {name}", "", "capacity over demand", check.factor)
        cell(f"factor over required of {name}", "", "1 where it just holds", _share(check))
        cell(f"verdict on {name}", "", "pass, fail, undecided or not judged", check.verdict.value)
        cell(f"model of {name}", "", "which decided it", check.model)
    worst = min(result.checks, key=_key, default=None)
    reason = "; ".join(found.text for found in result.findings)
    if result.sizing is not None and result.sizing.conflict and not reason:
        reason = "in conflict: " + ", ".join(row.name for row in result.sizing.conflict)
    row = StudyRow(
        point,
        result.status.value,
        worst.full_name if worst is not None else "",
        worst.model if worst is not None else "",
        reason,
        cells,
    )
    return row, tuple(columns)


def _share(check: Check) -> float:
    return check.factor / check.required if check.required else inf


def _key(check: Check) -> tuple[int, float]:
    share = _share(check)
    return check.verdict.rank, share if not isnan(share) else inf


def collected(
    found: Sequence[tuple[StudyRow, tuple[Column, ...]]], each: Each, points: int
) -> StudyResult:
    """Return rows as one table; a column is there where any row has it, and of use."""
    varied = tuple(dict.fromkeys(name for row, _ in found for name in row.point))
    columns = tuple({column.name: column for _, each_of in found for column in each_of}.values())
    rows = tuple(row for row, _ in found)
    return StudyResult(varied, each, columns, rows, points)
