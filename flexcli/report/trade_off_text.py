"""The alternatives of a sizing as tables: the designs of a front, the options of a spec."""

from collections.abc import Iterator, Mapping
from typing import Any

from flexcli.report.tables import Line, Piece, table
from flexcli.results import Result
from flexcli.results.trade_off import Choices, Front
from flexcli.units import show

__all__ = ["section"]


def section(result: Result) -> Iterator[Piece]:
    """Yield the front of a trade-off, and the options of a spec beside each other."""
    if result.choices is not None:
        yield from _choices(result.choices)
    if result.front is not None:
        yield from _front(result.front)


def _front(front: Front) -> Iterator[Piece]:
    names = list(front.points[0].sizes)
    options = any(point.chosen for point in front.points)
    columns = ("", front.second, front.first, *names, *["taken"] * options)
    rows = table("Front", *columns, numbers=range(1, 3 + len(names)))
    for k, point in enumerate(front.points):
        sizes = (show(point.sizes[name], "m", 5) for name in names)
        mark = ("knee", "bold") if k == front.knee else ""
        taken = [_option(point.chosen)] * options
        rows.add_row(mark, show(point.second, front.second_unit, 5),
                     show(point.first, front.first_unit, 5), *sizes, *taken)  # fmt: skip
    yield rows
    sure = "each is the global optimum at its bound" if front.proved else "not proved"
    yield Line(f"none is better in both, each passes ({sure})", hang=2)
    if front.knee is None:
        yield Line("no knee: the front is straight in logarithms", hang=2)
    yield from (Line(remark, hang=2) for remark in front.remarks)


def _choices(choices: Choices) -> Iterator[Piece]:
    rows = table("Options", "", "", choices.objective, "why not", numbers=[2])
    for row in choices.rows:
        value = "" if row.objective is None else show(row.objective, choices.unit, 5)
        taken = row.option == choices.chosen
        rows.add_row((_option(row.option), "bold" if taken else ""), row.status, value, row.reason)
    yield rows


def _option(option: Mapping[str, Any]) -> str:
    return ", ".join(map(str, option.values()))
