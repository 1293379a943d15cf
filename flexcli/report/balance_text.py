"""The answer of ``flexure balance`` as text for a terminal."""

from cmath import phase
from collections.abc import Iterator
from math import degrees

from flexcli.report.numbers import NOISE, largest, shown
from flexcli.report.tables import Line, Piece, Rows, table
from flexcli.results import Result
from flexcli.results.balance import BalanceResult, TransferRow
from flexcli.units import show

__all__ = ["balance_tables", "section"]

MOST_ROWS = 25
"""Rows of the transfer functions that a terminal gets; a sweep has more in CSV and JSON."""


def section(result: Result) -> Iterator[Piece]:
    """Yield the balancing of a mechanism, and its residual coupling."""
    if result.balance is not None:
        yield from balance_tables(result.balance)


def balance_tables(balance: BalanceResult) -> Iterator[Piece]:
    """Yield the choice of free numbers, and the tables that have rows."""
    if balance.outcome == "infeasible":
        yield Line(("not balanced: ", "bold red"), balance.reason, hang=2)
        if balance.remedy:
            yield Line(f"remedy: {balance.remedy}", hang=2)
    elif balance.unknowns:
        chosen = ", ".join(
            f"{unknown.name} {show(unknown.value, unknown.unit, 6)}" for unknown in balance.unknowns
        )
        yield Line(f"chosen: {chosen}", hang=2)
    for rows, told in (
        (balance.transfer, _transfer),
        (balance.over_stroke, _over_stroke),
        (balance.sensitivities, _sensitivities),
        (balance.gravity, _gravity),
    ):
        if rows:
            yield told(balance)


def _transfer(balance: BalanceResult) -> Rows:
    """Return T(ω) before and after; one column where there is nothing to balance."""
    both = any(row.init is not None or row.init_damped is not None for row in balance.transfer)
    damped = balance.quality is not None
    names = ("T_init", "T_final") if both else ("T",)
    heads = [f"{name} (s²)" for name in names]
    if damped:
        heads += [f"{name}, Q = {balance.quality:g}" for name in names]
    turns = balance.motion == "rotation"
    title = "Rotation over the base's own" if turns else "Displacement over the base's acceleration"
    rows = table(title, "frequency", *heads, numbers=range(1, 1 + len(heads)))
    scale = largest(x for row in balance.transfer for x in (row.init, row.final))
    for row in balance.transfer[:MOST_ROWS]:
        plain = [row.init, row.final] if both else [row.final]
        cells = ["∞" if x is None else f"{_or_zero(x, scale):+z.4g}" for x in plain]
        if damped:
            cells += _damped(row, scale, both=both)
        rows.add_row(show(row.frequency, "Hz"), *cells)
    if len(balance.transfer) > MOST_ROWS:
        rows.add_row(f"… {len(balance.transfer) - MOST_ROWS} more in --csv and JSON")
    return rows


def _or_zero(number: float, scale: float) -> float:
    return number if abs(number) > NOISE * scale else 0.0


def _damped(row: TransferRow, scale: float, *, both: bool) -> list[str]:
    values = [row.init_damped, row.final_damped] if both else [row.final_damped]
    return [
        ""
        if value is None
        else f"{abs(value):.4g} ∠ {degrees(phase(value)):.4g}°"
        if abs(value) > NOISE * scale
        else "0"
        for value in values
    ]


def _over_stroke(balance: BalanceResult) -> Rows:
    unit = "rad" if any(row.unit == "N*m" for row in balance.gravity) else "m"
    title = f"Beyond small angles, at the end of the stroke, {show(balance.stroke or 0.0, unit)}"
    heads = ("term", "at rest", "1st order", "2nd order", "3rd order", "at full stroke")
    rows = table(title, *heads, numbers=range(1, len(heads)))
    for row in balance.over_stroke:
        numbers = (row.at_rest, *row.orders, row.at_stroke)
        alike = [r for r in balance.over_stroke if r.unit == row.unit]
        scale = largest(x for r in alike for x in (r.at_rest, r.at_stroke))
        rows.add_row(row.name, *(shown(number, row.unit, scale) for number in numbers))
    return rows


def _sensitivities(balance: BalanceResult) -> Rows:
    heads = ("number", "value", "∂τ/∂p", "±", "effect on τ")
    rows = table("What the coupling depends on", *heads, numbers=range(1, len(heads)))
    for term in balance.sensitivities:
        per = "kg/kg" if term.unit == "kg" else "g/mm"  # kg/m is g/mm
        tolerance = [show(term.tolerance, term.unit), show(term.effect, "kg", 3)]
        rows.add_row(
            term.name,
            show(term.value, term.unit),
            f"{term.slope:+z.4g} {per}",
            *(tolerance if term.tolerance else ("", "")),
        )
    return rows


def _gravity(balance: BalanceResult) -> Rows:
    heads = ("axis", "at rest", "at full stroke", "sag", "stiffness")
    rows = table("Gravity along each axis", *heads, numbers=range(1, len(heads)))
    stiffness = "N*m/rad" if balance.output_unit == "rad" else "N/m"
    several = len({row.mounted for row in balance.gravity}) > 1
    torque, sag, change = (
        largest(values)
        for values in (
            [row.at_rest for row in balance.gravity],
            [row.sag for row in balance.gravity],
            [row.stiffness for row in balance.gravity],
        )
    )
    for row in balance.gravity:
        rows.add_row(
            f"{row.axis}, {row.mounted} balancing" if several else row.axis,
            shown(row.at_rest, row.unit, torque),
            "" if row.at_stroke is None else shown(row.at_stroke, row.unit, torque),
            "" if row.sag is None else shown(row.sag, balance.output_unit, sag),
            shown(row.stiffness, stiffness, change),
        )
    return rows
