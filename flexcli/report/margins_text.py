"""The margins of a design as text: what fails first, each with the range of its factor."""

from collections.abc import Callable, Sequence
from functools import partial
from math import isfinite, isnan

from rich.console import Group
from rich.text import Text

from flexcli.report.tables import table
from flexcli.results import Check, Verdict
from flexcli.units import show

__all__ = ["margins"]

MARK = {
    Verdict.FAIL: ("FAIL", "bold red"),
    Verdict.UNDECIDED: ("undecided", "bold yellow"),
    Verdict.NOT_JUDGED: ("not judged", "bold yellow"),
    Verdict.PASS: ("pass", "green"),
}
"""Worst first, which is also the order of the rows."""

SHORT = {"closed-form": "closed"}

FEWEST, MOST = 4, 12
"""Digits of a number: the fewest that tell two different numbers apart, up to the most."""


def margins(checks: Sequence[Check]) -> Group:
    """Return every check with verdict, demand, capacity, factor, its range and who decided."""
    order = list(MARK)
    rows = sorted(checks, key=lambda check: order.index(check.verdict))
    found = table("Margins", "", "check", "factor", "range", "asked", "by", numbers=[0, 2, 3, 4, 5])
    for column in (0, 5):
        found.columns[column].justify = "left"
    for check in rows:
        word, style = MARK[check.verdict]
        factor, required = _apart(_number, check.factor, check.required)
        by = SHORT.get(check.model, check.model)
        found.add_row(Text(word, style), check.full_name, factor, _range(check), required, by)
    return Group(found, Text("\n".join(map(_told, rows)), "dim"))


def _told(check: Check) -> str:
    """Return what was compared with what, and by which formula."""
    unit = partial(_sized, check.unit)
    demand, capacity = _apart(unit, check.demand, check.capacity)
    against = f"{demand} against {capacity}" if demand and capacity else ""
    return f"  {check.full_name}: " + "; ".join(
        filter(None, (against, check.quantity, check.source))
    )


def _apart(text: Callable[[float, int], str], one: float, other: float) -> tuple[str, str]:
    """Return two numbers as texts that differ where the numbers do; nothing for no number."""
    enough = (d for d in range(FEWEST, MOST) if text(one, d) != text(other, d))
    digits = next(enough, FEWEST)
    return "" if isnan(one) else text(one, digits), "" if isnan(other) else text(other, digits)


def _sized(unit: str, value: float, digits: int) -> str:
    return show(value, unit, digits)


def _number(value: float, digits: int = FEWEST) -> str:
    return f"{value:.{digits}g}" if isfinite(value) else "∞"


def _range(check: Check) -> str:
    """Return between which factors a check lies, with digits that tell its ends apart."""
    if check.factor_range is None:
        return "" if isnan(check.factor) else "unknown"
    low, high = check.factor_range
    if low == high:
        return ""
    if isfinite(high) and high - low <= 1e-6 * abs(high):
        return "±0"
    least, most = _apart(_number, low, high)
    return f"{least}–{most}"
