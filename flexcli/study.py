"""Studies: one verb at many points of a spec, a row for each; above the verbs of the API.

Verdicts of designs that differ in nothing but numbers are found together
(:mod:`flexcli.numerics.rows`), one at a time where something is found for one design alone.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby
from math import inf, isclose, isnan, nan
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli import api
from flexcli.errors import Finding, SolveError, SpecError
from flexcli.numerics.compilation import compiled, has_numba, pays
from flexcli.numerics.rows import each_alike, is_of_many, one_alone
from flexcli.parts.base import Texts
from flexcli.results import Check, Result
from flexcli.results.study import Column, StudyResult, StudyRow
from flexcli.units import number_and_unit

__all__ = ["JUDGING", "Row", "block_of", "collected", "is_compiled", "rows_of", "shared"]

Each = Literal["check", "verdict", "size", "simulate", "balance", "response", "stops"]

JUDGING = {"check": api.check, "verdict": api.verdicts, "size": api.size}
"""What is done at each point by the models that judge."""

OTHERS = {
    "simulate": api.simulate, "balance": api.balance, "response": api.asd_response,
    "stops": api.stops,
}  # fmt: skip
"""What else may be done at each point, by models of its own."""

Row: TypeAlias = tuple[StudyRow, tuple[Column, ...]]
"""A design of a study, and the columns of its cells."""


BLOCK = 1024
"""Designs that are judged together, which bounds the memory of a pass; always the same ones, so
that no digit hangs on how many processes there are."""

PROBE = 8
"""Designs that tell whether those of a study can be judged together."""

SAME = 1e-6
"""Difference of a factor (relative) from that of a design alone that is none."""


def block_of(
    source: api.Portable, each: Each, model: str | None, points: Sequence[Mapping[str, str]]
) -> int:
    """Return how many designs of a study are one task: many where they are judged together."""
    if each != "verdict" or len(points) <= PROBE:
        return 1
    passes = _passes(source, model, points[:: len(points) // PROBE][:PROBE])
    return BLOCK if any(found is not None for _, found in passes) else 1


def is_compiled(each: Each, points: int) -> bool:
    """Return whether the equilibria of a study are found by compiled code.

    Each verdict asks for both ends of a stroke.
    """
    return each == "verdict" and pays(2 * points)


def rows_of(
    source: api.Portable,
    each: Each,
    model: str | None,
    points: Sequence[Mapping[str, str]],
    *,
    is_compiled: bool = False,
) -> list[Row]:
    """Return the rows of some points, each with its columns.

    Raises
    ------
    SpecError
        When the study is solved by compiled code, and Numba is not here.

    """
    if is_compiled and not has_numba():
        text = "a worker has no Numba, by which the rest of the study is solved"
        raise SpecError([Finding("--scheduler", text, "pip install 'flexcli[fast]' there")])
    with compiled(is_compiled):
        return _rows_of(source, each, model, points)


def _rows_of(
    source: api.Portable, each: Each, model: str | None, points: Sequence[Mapping[str, str]]
) -> list[Row]:
    if each != "verdict" or len(points) == 1:
        return [_row_at(source, each, model, point) for point in points]
    rows: dict[int, Row] = {}
    for which, found in _passes(source, model, points):
        if found is not None:
            designs = [_of_one(found, place) for place in range(len(which))]
            middle = len(which) // 2
            if _is_as_alone(designs[middle], source, model, points[which[middle]]):
                rows |= {i: _row(points[i], one) for i, one in zip(which, designs, strict=True)}
                continue
        rows |= {i: _row_at(source, each, model, points[i]) for i in which}
    return [rows[i] for i in range(len(points))]


def _passes(
    source: api.Portable, model: str | None, points: Sequence[Mapping[str, str]]
) -> Iterator[tuple[list[int], Result | None]]:
    """Yield the places of designs that are judged in one pass, and what it found for them."""

    def form(place: int) -> list[str]:
        return ["" if number_and_unit(text) else text for text in points[place].values()]

    for _, like in groupby(sorted(range(len(points)), key=form), key=form):
        places = np.array(list(like))

        def judged(which: NDArray[np.intp], places: NDArray[np.intp] = places) -> Result:
            one_of = points[places[0]]
            texts = {name: [points[i][name] for i in places[which]] for name in one_of}
            point: dict[str, Any] = {
                name: Texts(each) if number_and_unit(one_of[name]) else one_of[name]
                for name, each in texts.items()
            }
            spec = source.at(point)
            if spec.part.geometry.free or spec.part.stops is not None:
                one_alone()
            return api.verdicts(spec, model=model)

        for which, found in each_alike(judged, len(places)):
            yield places[which].tolist(), found


def _of_one(found: Result, place: int) -> Result:
    """Return what a pass found for one of its designs."""

    def of_one(value: Any) -> Any:
        return float(np.asarray(value)[place]) if is_of_many(value) else value

    def check_of_one(check: Check) -> Check:
        between = check.factor_range
        return check._replace(
            factor=of_one(check.factor),
            required=of_one(check.required),
            factor_range=between and (of_one(between[0]), of_one(between[1])),
        )

    return replace(found, checks=tuple(map(check_of_one, found.checks)))


def _is_as_alone(
    one: Result, source: api.Portable, model: str | None, point: Mapping[str, str]
) -> bool:
    """Return whether a design that was judged with others is as it is alone."""
    try:
        alone = api.verdicts(source.at(point), model=model)
    except (SpecError, SolveError):
        return False
    return len(one.checks) == len(alone.checks) and all(
        (check.full_name, check.verdict, check.model) == (own.full_name, own.verdict, own.model)
        and all(
            isclose(x, y, rel_tol=SAME) or (isnan(x) and isnan(y))
            for x, y in zip(_numbers(check), _numbers(own), strict=True)
        )
        for check, own in zip(one.checks, alone.checks, strict=True)
    )


def _numbers(check: Check) -> tuple[float, float, float]:
    return (check.factor, *(check.factor_range or (nan, nan)))


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
        result = OTHERS[each](spec) if each in OTHERS else JUDGING[each](spec, model=model)
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
