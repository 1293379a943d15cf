"""Studies: one verb at many points of a spec, a row for each; above the verbs of the API."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import inf, isnan
from typing import Literal, TypeAlias

from flexcli import api
from flexcli.errors import SolveError, SpecError
from flexcli.results import Check, Result
from flexcli.results.study import Column, StudyResult, StudyRow

__all__ = ["Row", "collected", "rows_of", "shared"]

Each = Literal["check", "verdict", "size", "simulate"]

Row: TypeAlias = tuple[StudyRow, tuple[Column, ...]]
"""A design of a study, and the columns of its cells."""


def rows_of(
    source: api.Portable, each: Each, model: str | None, points: Sequence[Mapping[str, str]]
) -> list[Row]:
    """Return the rows of some points, each with its columns."""
    return [_row_at(source, each, model, point) for point in points]


def shared(rows: Iterable[Row]) -> Iterator[Row]:
    """Yield rows, whatever made them, that share their columns and the names of their cells."""
    known: dict[tuple[Column, ...], tuple[Column, ...]] = {}
    for row, own in rows:
        columns = known.setdefault(own, own)
        yield row._replace(cells={each.name: row.cells[each.name] for each in columns}), columns


def _row_at(source: api.Portable, each: Each, model: str | None, point: Mapping[str, str]) -> Row:
    """Return the row of one point; what goes wrong is its reason."""
    try:
        spec = source.at(point)
        if each == "simulate":
            result = api.simulate(spec)
        else:
            verb = {"size": api.size, "verdict": api.verdicts}.get(each, api.check)
            result = verb(spec, model=model)
    except SpecError as error:
        reason = "; ".join(f"{found.path or found.file}: {found.text}" for found in error.findings)
        return StudyRow(point, "error", "", "", reason, {}), ()
    except SolveError as error:
        return StudyRow(point, "undecided", "", "", error.text, {}), ()
    return _row(point, result)


def _row(point: Mapping[str, str], result: Result) -> Row:
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


def collected(found: Sequence[Row], each: Each, points: int) -> StudyResult:
    """Return rows as one table; a column is there where any row has it, and of use."""
    varied = tuple(dict.fromkeys(name for row, _ in found for name in row.point))
    columns = tuple({column.name: column for _, each_of in found for column in each_of}.values())
    rows = tuple(row for row, _ in found)
    return StudyResult(varied, each, columns, rows, points)
