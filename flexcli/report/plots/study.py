"""Plot of a study: the outcome of each design over the varied values."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.report.plots.chart import DASHES, Axis, Chart
from flexcli.report.plots.plot import Plot, in_unit
from flexcli.results.study import StudyResult, StudyRow
from flexcli.units import numbers_and_unit

__all__ = ["study_plot"]

Floats = NDArray[np.float64]

MARKS = {"pass": ("pass", True), "undecided": ("undecided", True)}
"""Colour of a mark, and whether it is filled, by how a design ended; all others fail."""

MOST_NAMES = len(DASHES)
"""Values in words, or checks, that curves are drawn of."""

OVER = "factor over required of "
"""How the columns begin that tell by how much a check holds."""


class _Varied(NamedTuple):
    """What varies along an axis: its path in the spec, the unit it is written in, its numbers."""

    path: str
    unit: str
    numbers: Floats

    @property
    def axis(self) -> Axis:
        """Return the axis that it is shown along."""
        unit = self.unit.replace("um", "µm").replace("*", "·")
        return Axis(f"{self.path}, {unit}".rstrip(", "))


def study_plot(found: StudyResult) -> Plot:
    """Return the least margin, or the first value that is to be shown, over what varies.

    Over one number there are curves, of the checks that are nearest to their limits or of each
    combination of what is varied in words; over two or more numbers marks, over the first two.

    Raises
    ------
    SolveError
        When no number varies, when no row has what is to be shown, or nobody knows that value.

    """
    numbers = [v for v in (_varied(name, found.rows) for name in found.varied) if v is not None]
    if not numbers:
        text = "there is nothing to plot over: what varies are no numbers of one unit"
        raise SolveError("no-axis", text, "vary a number, or save a table by -o FILE.csv")
    wanted = found.shown[0] if found.shown else ""
    if wanted and wanted not in {column.name for column in found.columns}:
        raise SolveError("no-such-value", f"no row has the value {wanted}", "name another --value")
    if len(numbers) > 1:
        return _map(found, numbers, wanted)
    return _curves(found, numbers[0], wanted)


def _varied(name: str, rows: Sequence[StudyRow]) -> _Varied | None:
    """Return what varies as numbers of one unit; nothing where it is words."""
    read = numbers_and_unit(row.point.get(name, "") for row in rows)
    return None if read is None else _Varied(name, read[1], np.array(read[0]))


def _number(cells: Mapping[str, float | str], name: str) -> float:
    """Return the number of a cell, not a number where there is none."""
    cell = cells.get(name, "")
    return float(cell) if isinstance(cell, float) else float("nan")


def _least(row: StudyRow) -> float:
    """Return the factor over the required one of the check that is nearest to its limit."""
    return _number(row.cells, OVER + row.decided_by)


def _curves(found: StudyResult, along: _Varied, wanted: str) -> Plot:
    """Return curves over the one number that varies, and a mark for each design."""
    order = np.argsort(along.numbers, kind="stable")
    rows, x = [found.rows[i] for i in order], along.numbers[order]
    words = [tuple(row.point[n] for n in found.varied if n != along.path) for row in rows]
    y, axis, what = _values(found, rows, wanted)
    chart = Chart(along.axis, axis)
    groups = list(dict.fromkeys(words))
    deciding = list(dict.fromkeys(row.decided_by for row in rows if row.decided_by))
    if len(groups) > 1 or wanted:
        for group, dash in zip(groups, DASHES * len(groups), strict=False):
            here = [k for k, each in enumerate(words) if each == group]
            chart.curve(x[here], y[here], ", ".join(group), dash)
    else:
        for name, dash in zip(deciding[:MOST_NAMES], DASHES, strict=False):
            chart.curve(x, [_number(row.cells, OVER + name) for row in rows], name, dash)
    if not wanted:
        chart.rule(y=1.0, colour="fail")
    _mark(chart, x, y, rows)
    return Plot("study", "Study", f"{what} {_told(rows, y)}", chart.svg())


def _map(found: StudyResult, along: Sequence[_Varied], wanted: str) -> Plot:
    """Return a mark for each design over the first two numbers that vary."""
    first, second = along[:2]
    y, _, _ = _values(found, found.rows, wanted)
    chart = Chart(first.axis, second.axis)
    _mark(chart, first.numbers, second.numbers, found.rows)
    what = wanted or "Factor over the required one"
    ends = ""
    if np.isfinite(y).any():
        least, most = (
            f"{y[k]:.3g}, where they are {first.numbers[k]:g} and {second.numbers[k]:g}"
            for k in (np.nanargmin(y), np.nanargmax(y))
        )
        ends = f" {what} from {least}, to {most}."
    besides = "" if len(along) == 2 else f" What varies besides, {len(along) - 2}, is not seen."
    return Plot(
        "study", "Study", f"Every design. {_told(found.rows, y)}{ends}{besides}", chart.svg()
    )


def _values(found: StudyResult, rows: Sequence[StudyRow], wanted: str) -> tuple[Floats, Axis, str]:
    """Return the number of each row that is shown, the axis of it, and what it is."""
    if not wanted:
        y = np.array([_least(row) for row in rows])
        if not np.isfinite(y).any():
            raise SolveError("no-numbers", "no design was judged", "see the reasons in the table")
        what = "Factor over the required one of the checks nearest to their limits."
        return y, Axis("factor over required", log=bool(np.nanmin([*y, 1.0]) > 0.0)), what
    y = np.array([_number(row.cells, wanted) for row in rows])
    column = next(each for each in found.columns if each.name == wanted)
    unit, size = in_unit(y, column.unit)
    return y / size, Axis(f"{wanted}, {unit}".rstrip(", ")), f"{column.label or wanted}."


def _mark(chart: Chart, x: Floats, y: Floats, rows: Sequence[StudyRow]) -> None:
    """Mark each design by how it ended."""
    for status in dict.fromkeys(row.status for row in rows):
        here = [k for k, row in enumerate(rows) if row.status == status]
        colour, filled = MARKS.get(status, ("fail", False))
        chart.marks(x[here], y[here], colour, filled=filled)


def _told(rows: Sequence[StudyRow], y: Floats) -> str:
    """Return the legend of the marks, and the number of designs without one."""
    count = {status: sum(row.status == status for row in rows) for status in MARKS}
    failed = len(rows) - sum(count.values())
    missing = int(np.sum(~np.isfinite(y)))
    none = f"; {missing} have no number here" if missing else ""
    return (
        f"Blue dots pass ({count['pass']}), rings fail ({failed}), "
        f"brown dots are undecided ({count['undecided']}){none}."
    )
