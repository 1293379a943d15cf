"""A tolerance run as tables: yields, worst cases, and what they hang on."""

from collections.abc import Iterator
from math import isnan

from flexcli.report.numbers import share_text
from flexcli.report.tables import Cell, Line, Piece, table
from flexcli.results import Result
from flexcli.results.tolerances import TolerancesResult, YieldRow
from flexcli.units import show

__all__ = ["section"]

NEAR = 1.5
"""Factor over the required one in the worst case below which it is told what a check hangs on."""

STYLE = {"pass": "green", "fail": "red", "undecided": "yellow"}

GAIN = 0.001
"""Share of the parts that a narrower tolerance has to gain to be told."""


def section(result: Result) -> Iterator[Piece]:
    """Yield the share of parts that pass, the worst of them, and what it hangs on."""
    found = result.tolerances
    if found is None:
        return
    yield from _yields(found)
    yield from _worst(found)
    yield from _tolerances(found)
    yield from _causes(found)
    yield Line(("judged by ", "dim"), (found.method, "dim"), hang=2)


def _yields(found: TolerancesResult) -> Iterator[Piece]:
    sure = f"{100.0 * found.confidence:.4g} %"
    rows = table("Yields", "", "pass", f"{sure} interval", "undecided", "first order",
                 numbers=(1, 2, 3, 4))  # fmt: skip
    for row in (*found.checks, found.together):
        low, high = row.interval
        name: Cell = ("all together", "bold") if row is found.together else row.name
        rows.add_row(
            name, share_text(row.passed), f"{share_text(low)} to {share_text(high)}",
            share_text(row.undecided) if row.undecided else "",
            "" if row.first_order is None else share_text(row.first_order),
        )  # fmt: skip
    yield rows
    asked = f"; {share_text(found.asked)} are asked" if found.asked is not None else ""
    yield Line(f"of {found.parts} parts of seed {found.seed}{asked}; undecided parts do not pass")


def _worst(found: TolerancesResult) -> Iterator[Piece]:
    units = {row.name: row.unit for row in found.tolerances}
    rows = table("Worst case", "", "", "over required", "known by", "at", numbers=[2])
    for row in found.checks:
        if row.worst is None:
            rows.add_row(row.name, ("undecided", "yellow"), "", "", "")
            continue
        at = ", ".join(f"{name} {show(x, units[name], 5)}" for name, x in row.worst.at.items())
        mark = (row.worst.verdict, STYLE[row.worst.verdict])
        rows.add_row(row.name, mark, f"{row.worst.share:.4g}", row.worst.by, at)
    yield rows
    if any(row.spread == "normal" for row in found.tolerances):
        yield Line("of a normal spread, up to three standard deviations")


def _tolerances(found: TolerancesResult) -> Iterator[Piece]:
    rows = table("Tolerances", "", "nominal", "least", "most", "spread", "all pass if halved",
                 numbers=(1, 2, 3, 5))  # fmt: skip
    for row in found.tolerances:
        ends = (show(x, row.unit, 5) for x in (row.nominal, row.low, row.high))
        rows.add_row(row.name, *ends, row.spread, share_text(row.halved))
    yield rows
    best = max(found.tolerances, key=lambda row: -1.0 if isnan(row.halved) else row.halved)
    if best.halved > found.together.passed + GAIN:
        yield Line(
            ("narrow first: ", "bold"),
            f"{best.name}; with half of it {share_text(best.halved)} of the parts pass, not "
            f"{share_text(found.together.passed)}", hang=2,
        )  # fmt: skip


def _causes(found: TolerancesResult) -> Iterator[Piece]:
    heads = ("", "number", "by 1 % more", "of the variance", "in all")
    rows = table("What the margins depend on", *heads, numbers=(2, 3, 4))
    near = [row for row in found.checks if row.slopes and _is_near(row)]
    for row in near:
        order = sorted(row.total, key=lambda name: -row.total[name])
        for name in order:
            told = row.name if name == order[0] else ""
            shares = (max(each[name], 0.0) for each in (row.first, row.total))
            slope = f"{row.slopes[name]:+.3g} %"
            rows.add_row(told, name, slope, *(f"{100.0 * x:.1f} %" for x in shares))
    if near:
        yield rows


def _is_near(row: YieldRow) -> bool:
    return row.passed < 1.0 or row.worst is None or row.worst.share < NEAR
