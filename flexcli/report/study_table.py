"""A study as a table: on the terminal, as CSV, as Parquet."""

from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from math import isnan

from rich.console import RenderableType

from flexcli.errors import SolveError
from flexcli.report.rows_csv import rows_csv
from flexcli.report.tables import Line, table
from flexcli.results import Result
from flexcli.results.study import StudyResult, StudyRow
from flexcli.units import show

__all__ = ["FIXED", "heading", "parquet_bytes", "section", "study_csv"]

FIXED = ("status", "decided by", "model", "reason")
"""Columns that every row has, after those of what varies."""

TOLD = 60
"""Rows that the terminal shows of a longer study: the first and the last of them."""


def heading(result: StudyResult) -> list[str]:
    """Return the names of all columns, with their SI units."""
    own = [f"{c.name} [{c.unit}]" if c.unit else c.name for c in result.columns]
    return [*result.varied, *FIXED, *own]


def _cells(row: StudyRow, result: StudyResult) -> list[object]:
    own = [row.cells.get(column.name, "") for column in result.columns]
    fixed = [row.status, row.decided_by, row.model, row.reason]
    return [*(row.point.get(name, "") for name in result.varied), *fixed, *own]


def study_csv(result: StudyResult) -> str:
    """Return a row a design, numbers in SI with every digit."""
    return rows_csv(
        heading(result), ([_plain(c) for c in _cells(row, result)] for row in result.rows)
    )


def _plain(cell: object) -> object:
    return "" if isinstance(cell, float) and isnan(cell) else cell


def parquet_bytes(result: StudyResult) -> bytes:
    """Return a row a design; each column's unit is in its metadata.

    Raises
    ------
    SolveError
        When what writes Parquet is not installed.

    """
    try:
        arrow, parquet = import_module("pyarrow"), import_module("pyarrow.parquet")
    except ImportError as error:
        hint = "pip install 'flexcli[study]', or write a .csv"
        raise SolveError("no-parquet", "Parquet needs the extra 'study'", hint) from error
    fields, arrays = [], []

    def column(name: str, values: Sequence[object], unit: str, label: str) -> None:
        is_text = any(isinstance(value, str) and value for value in values)
        kind = arrow.string() if is_text else arrow.float64()
        cells = [None if value == "" else value for value in values]
        fields.append(arrow.field(name, kind, metadata={"unit": unit, "label": label}))
        arrays.append(arrow.array(cells, type=kind))

    for name in result.varied:
        column(name, [row.point.get(name, "") for row in result.rows], "", "as the spec writes it")
    for name, values in _fixed(result).items():
        column(name, values, "", "")
    for each in result.columns:
        column(each.name, [r.cells.get(each.name, "") for r in result.rows], each.unit, each.label)
    sink = arrow.BufferOutputStream()
    parquet.write_table(arrow.table(arrays, schema=arrow.schema(fields)), sink)
    return bytes(sink.getvalue())


def _fixed(result: StudyResult) -> Mapping[str, list[str]]:
    rows = [(r.status, r.decided_by, r.model, r.reason) for r in result.rows]
    return {name: [row[k] for row in rows] for k, name in enumerate(FIXED)}


def section(result: Result) -> Iterator[RenderableType]:
    """Yield what a result has of it: what varies, how each design ended, the wanted values."""
    if result.study is None:
        return
    found = result.study
    units = {column.name: column.unit for column in found.columns}
    shown = [name for name in found.shown if name in units]
    names = [*found.varied, "", "nearest its limit", "over required", *shown]
    count = len(found.varied)
    rows = table("Study", *names, numbers=range(count + 2, len(names)))
    kept: list[StudyRow | None] = list(found.rows)
    if len(kept) > TOLD:
        kept = [*found.rows[: TOLD // 2], None, *found.rows[-TOLD // 2 :]]
    for row in kept:
        if row is None:
            rows.add_row("…", *[""] * (len(names) - 1))
            continue
        share = row.cells.get(f"factor over required of {row.decided_by}", "")
        rows.add_row(
            *(row.point.get(name, "") for name in found.varied),
            row.status,
            row.decided_by or row.reason,
            f"{share:.4g}" if isinstance(share, float) and not isnan(share) else "",
            *(_shown(row.cells.get(name, ""), units[name]) for name in shown),
        )
    yield rows
    done = len(found.rows)
    left = f"; {found.points - done} of {found.points} were not done" * (done < found.points)
    yield Line(f"{found.passed} of {done} designs pass{left}")


def _shown(cell: float | str, unit: str) -> str:
    return show(cell, unit) if isinstance(cell, float) else str(cell)
