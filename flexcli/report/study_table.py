"""A study as a table: on the terminal, as CSV, as Parquet."""

from collections import Counter
from collections.abc import Iterator, Sequence
from math import isnan

from flexcli.report.columns_file import FileColumn, csv_text
from flexcli.report.columns_file import parquet_bytes as columns_parquet
from flexcli.report.tables import Line, Piece, table
from flexcli.results import Result
from flexcli.results.study import StudyResult, StudyRow
from flexcli.units import numbers_and_unit, show

__all__ = ["FIXED", "parquet_bytes", "section", "study_csv"]

FIXED = ("status", "decided by", "model", "reason")
"""Columns that every row has, after those of what varies."""

TOLD = 60
"""Rows that the terminal shows of a longer study: the first and the last of them."""


def study_csv(result: StudyResult) -> str:
    """Return a row a design, numbers in SI with every digit."""
    return csv_text(_columns(result))


def parquet_bytes(result: StudyResult) -> bytes:
    """Return a row a design; each column's unit is in its metadata.

    What varies in one unit is numbers in it, where CSV keeps the words that a study goes on from.

    Raises
    ------
    SolveError
        When what writes Parquet is not installed.

    """
    columns = _columns(result)
    for k, name in enumerate(result.varied):
        read = numbers_and_unit(row.point.get(name, "") for row in result.rows)
        if read is not None:
            columns[k] = FileColumn(name, read[1], "as the spec writes it", read[0])
    return columns_parquet(columns)


def _columns(result: StudyResult) -> list[FileColumn]:
    """Return what varies, how each design ended, and its values."""
    rows = result.rows
    fixed = [(row.status, row.decided_by, row.model, row.reason) for row in rows]
    return [
        *(
            FileColumn(name, "", "as the spec writes it", [r.point.get(name, "") for r in rows])
            for name in result.varied
        ),
        *(FileColumn(name, "", "", [cells[k] for cells in fixed]) for k, name in enumerate(FIXED)),
        *(
            FileColumn(each.name, each.unit, each.label, [r.cells.get(each.name, "") for r in rows])
            for each in result.columns
        ),
    ]


def section(result: Result) -> Iterator[Piece]:
    """Yield what a result has of it: what varies, how each design ended, the wanted values."""
    if result.study is None:
        return
    found = result.study
    units = {column.name: column.unit for column in found.columns}
    shown = [name for name in found.shown if name in units]
    names = [*_short(found.varied), "", "nearest its limit", "over required", *shown]
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


def _short(paths: Sequence[str]) -> list[str]:
    """Return the ends of paths that tell them apart, of two words or more: stroke.translation."""
    short = [path.split(".")[-2:] for path in paths]
    while len({tuple(each) for each in short}) < len(short):
        known = Counter(map(tuple, short))
        short = [
            path.split(".")[-len(each) - (known[tuple(each)] > 1) :]
            for path, each in zip(paths, short, strict=True)
        ]
    return [".".join(each) for each in short]


def _shown(cell: float | str, unit: str) -> str:
    return show(cell, unit) if isinstance(cell, float) else str(cell)
