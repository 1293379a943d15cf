"""What ``explain`` tells, on screen and as JSON."""

from collections.abc import Sequence
from typing import Any

from rich.console import Console
from rich.table import Table
from rich.text import Text

from flexcli import __version__
from flexcli.report.as_json import FORMAT
from flexcli.results import Explanation, FormulaRow, SymbolRow, TableRow
from flexcli.units import show

__all__ = ["document", "print_list", "print_one"]


def document(command: str, found: Sequence[Explanation]) -> dict[str, Any]:
    """Return explanations as JSON content, numbers in SI."""
    return {
        "flexure": FORMAT,
        "command": command,
        "version": __version__,
        "status": "pass",
        "topics": list(found),
    }


def print_list(found: Sequence[Explanation], console: Console) -> None:
    """Print one line per topic."""
    table = Table(box=None, pad_edge=False)
    table.add_column("name", no_wrap=True)
    table.add_column("what it is", overflow="fold")
    for topic in found:
        table.add_row(topic.name, topic.title)
    console.print(table)
    console.print(Text("flexure explain NAME shows its formulas", "dim"))


def print_one(topic: Explanation, console: Console) -> None:
    """Print a topic: each formula, or the table that was asked for."""
    console.print(Text(f"{topic.name}: {topic.title}", "bold"))
    if topic.table is not None:
        _print_table(topic.table, console)
        return
    for formula in topic.formulas:
        console.print()
        _print_formula(formula, console)


def _print_formula(formula: FormulaRow, console: Console) -> None:
    console.print(Text(f"{formula.name}: {formula.title}", "bold"))
    console.print(Text(formula.equation))
    table = Table(box=None, pad_edge=False)
    for column in ("symbol", "worked case", "meaning"):
        table.add_column(column, overflow="fold")
    for symbol in (*formula.symbols, *formula.gives):
        table.add_row(symbol.name, _value(symbol), symbol.meaning)
    console.print(table)
    for row in formula.validity:
        console.print(Text(f"valid for {row.text}: {row.why}"))
    if formula.notes:
        console.print(Text(formula.notes))
    console.print(Text(f"source: {formula.source}", "dim"))
    for name in formula.tables:
        console.print(Text(f"chart as data: --table {name}", "dim"))


def _value(symbol: SymbolRow) -> str:
    if symbol.value is None:
        return ""
    if isinstance(symbol.value, str):
        return f"{symbol.value} {symbol.unit}".rstrip()
    return show(symbol.value, symbol.unit.replace("·", "*"))


def _print_table(found: TableRow, console: Console) -> None:
    table = Table(box=None, pad_edge=False)
    for column, unit in found.units.items():
        table.add_column(f"{column} [{unit}]" if unit else column, justify="right", no_wrap=True)
    for row in zip(*found.columns.values(), strict=True):
        table.add_row(*(f"{x:.5g}" for x in row))
    console.print(table)
    if found.note:
        console.print(Text(found.note, "dim"))
