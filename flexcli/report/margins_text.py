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
    found = table(
        "Margins", "", "check", "demand", "capacity", "factor", "range", "asked", "by",
        numbers=[2, 3, 4, 5, 6],
    )  # fmt: skip
    for check in rows:
        word, style = MARK[check.verdict]
        demand, capacity = _apart(partial(_sized, check.unit), check.demand, check.capacity)
        factor, required = _apart(_number, check.factor, check.required)
        found.add_row(
            Text(word, style),
            check.full_name,
            demand,
            capacity,
            factor,
            _range(check),
            required,
            SHORT.get(check.model, check.model),
        )
    told = dict.fromkeys(
        f"  {c.full_name}: {'; '.join(filter(None, (c.quantity, c.source)))}" for c in rows
    )
    return Group(found, Text("\n".join(told), "dim"))


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
