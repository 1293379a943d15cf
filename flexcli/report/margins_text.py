"""The margins of a design as text: what fails first, each with the range of its factor."""

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from math import inf, isfinite, isnan, log
from types import MappingProxyType

from flexcli.report.numbers import MOST_FACTOR, NOISE, apart, factor_text
from flexcli.report.tables import Cell, Line, Piece, Rows, table
from flexcli.results import Check, Verdict
from flexcli.units import show

__all__ = [
    "VERDICTS",
    "against",
    "cells_of",
    "decisive",
    "margins",
    "sentence",
    "source_lines",
    "sources",
    "worst_first",
]

VERDICTS = {
    Verdict.FAIL: ("FAIL", "bold red"),
    Verdict.UNDECIDED: ("undecided", "bold yellow"),
    Verdict.NOT_JUDGED: ("not judged", "bold yellow"),
    Verdict.PASS: ("pass", "green"),
}
"""Worst first, which is also the order of the rows."""

SHORT = {"closed-form": "closed"}

Scales = Mapping[str, float]
"""The largest number of each unit in a result, beside which rounding errors are shown as 0."""

NO_SCALES: Scales = MappingProxyType({})

BAR = 25
"""Characters of the axis of the factors, where the page has room for them."""


def worst_first(checks: Sequence[Check]) -> list[Check]:
    """Return checks with what fails first, then what is not decided, then what passes."""
    return sorted(checks, key=lambda check: check.verdict.rank)


def decisive(checks: Sequence[Check]) -> Check | None:
    """Return the deciding check of a verdict: of the worst kind, the one of least margin."""
    rows = worst_first(checks)
    worst = [check for check in rows if check.verdict is rows[0].verdict]
    return min(worst, key=_least, default=None)


def _least(check: Check) -> float:
    """Return the least ratio of factor to required factor, minus infinity where unknown."""
    low = check.factor if check.factor_range is None else check.factor_range[0]
    return -inf if isnan(low) else low / check.required


def sentence(check: Check, scales: Scales = NO_SCALES) -> str:
    """Return the result of a check as one sentence."""
    if isnan(check.factor):
        return f"{check.full_name}: {check.quantity}."
    factor, required = apart(factor_text, check.factor, check.required)
    demand, capacity = _sizes(check, scales)
    compared = f"{demand} against {capacity}" if demand and capacity else check.quantity
    if check.verdict is Verdict.UNDECIDED:
        known = "its error is not known"
        if check.factor_range is not None:
            known = "it may be anything from {} to {}".format(*_ends(check.factor_range))
        return f"{check.full_name} has a factor of {factor} where {required} is asked, but {known}."
    verb = "reaches only" if check.verdict is Verdict.FAIL else "is nearest to its limit, with"
    return f"{check.full_name} {verb} a factor of {factor} where {required} is asked: {compared}."


def margins(checks: Sequence[Check], notes: Sequence[str], width: int) -> Rows:
    """Return every check with verdict, factor, its range and who decided; worst first.

    ``notes`` are the sources; where the page has room, a bar shows the range on a common axis.
    """
    rows = worst_first(checks)
    bars = _bars(rows)
    heads = ["", "check", "factor", "range", "asked", "by"]
    cells = [_row(check, notes) for check in rows]
    taken = sum(max(len(str(row[i])) for row in [heads, *_plain(cells)]) + 2 for i in range(6))
    if bars and taken + BAR <= width:
        heads.insert(4, "")
        cells = [(*row[:4], bar, *row[4:]) for row, bar in zip(cells, bars, strict=True)]
    found = table("Margins", *heads, numbers=(2, 3, len(heads) - 2))
    for row in cells:
        found.add_row(*row)
    return found


def _plain(rows: Sequence[tuple[Cell, ...]]) -> list[list[str]]:
    return [[cell if isinstance(cell, str) else cell[0] for cell in row] for row in rows]


def _row(check: Check, notes: Sequence[str]) -> tuple[Cell, ...]:
    name = f"{check.full_name} [{notes.index(_source(check)) + 1}]"
    factor, between, required, _, _ = cells_of(check)
    by = SHORT.get(check.model, check.model)
    return VERDICTS[check.verdict], name, factor, between, required, by


def cells_of(check: Check) -> tuple[str, str, str, str, str]:
    """Return factor, range, requirement, demand and capacity; unequal numbers look unequal."""
    factor, required = apart(factor_text, check.factor, check.required)
    return (factor, _range(check), required, *_sizes(check))


def against(checks: Sequence[Check], scales: Scales) -> Rows:
    """Return the compared quantity of each check, and how long it took to decide."""
    found = table("", "check", "demand", "capacity", "time", numbers=(1, 2, 3))
    for check in worst_first(checks):
        seconds = show(check.seconds, "s", 2) if check.seconds else ""
        found.add_row(check.full_name, *_sizes(check, scales), seconds)
    return found


def sources(checks: Sequence[Check]) -> list[str]:
    """Return what checks compare and by which formula, each text once, in the rows' order."""
    return list(dict.fromkeys(map(_source, worst_first(checks))))


def source_lines(notes: Sequence[str]) -> Iterator[Piece]:
    """Yield the numbered sources."""
    yield from ("", Line(("Sources", "bold")))
    for number, note in enumerate(notes, 1):
        yield Line(f"[{number}] {note}", indent=2, hang=4)


def _source(check: Check) -> str:
    return "; ".join(filter(None, (check.quantity, check.source)))


def _sizes(check: Check, scales: Scales = NO_SCALES) -> tuple[str, str]:
    """Return demand and capacity with digits that distinguish them; rounding errors are 0."""
    demand, capacity = apart(partial(_sized, check.unit), check.demand, check.capacity)
    is_noise = abs(check.demand) <= NOISE * scales.get(check.unit, 0.0)
    return "0" if is_noise and check.passed else demand, capacity


def _sized(unit: str, value: float, digits: int) -> str:
    return show(value, unit, digits)


def _range(check: Check) -> str:
    """Return the range of a check's factor, with digits that distinguish its ends."""
    if check.factor_range is None:
        return "" if isnan(check.factor) else "unknown"
    low, high = check.factor_range
    if low == high or low >= MOST_FACTOR:
        return ""
    if isfinite(high) and high - low <= 1e-6 * abs(high):
        return "±0"
    return "–".join(_ends(check.factor_range))


def _ends(ends: tuple[float, float]) -> tuple[str, str]:
    return apart(factor_text, *ends)


def _bars(checks: Sequence[Check]) -> list[str]:
    """Return the range of each factor over the required one, on one logarithmic axis.

    A full block is a decided range, a light one crosses the required factor, which is the line.
    """
    ranges = [_over_required(check) for check in checks]
    known = [end for ends in ranges if ends is not None for end in ends]
    if not known:
        return []
    low, high = min(0.0, *known), max(0.0, *known)
    step = (high - low) / (BAR - 1) or 1.0
    line = round(-low / step)
    found = []
    for ends in ranges:
        drawn = [" "] * BAR
        if ends is not None:
            first, last = (round((end - low) / step) for end in ends)
            block = "░" if ends[0] < 0.0 < ends[1] else "█"
            drawn[first : last + 1] = block * (last - first + 1)
        is_covered = drawn[line] != " "
        drawn[line] = "╂" if is_covered else "┃"
        found.append("".join(drawn))
    return found


def _over_required(check: Check) -> tuple[float, float] | None:
    """Return the logarithms of the range over the required factor, if they are drawable."""
    if check.factor_range is None:
        return None
    low, high = check.factor_range
    if not (0.0 < low <= high < 1e3 * check.required and check.required > 0.0):
        return None
    return log(low / check.required), log(high / check.required)
