"""The text of ``explain`` for a terminal."""

from collections.abc import Sequence

from rich.console import Console
from rich.table import Table
from rich.text import Text

from flexcli.results.explanation import (
    Explanation,
    FieldRow,
    FormulaRow,
    KeyRow,
    SymbolRow,
    TableRow,
)
from flexcli.units import show

GAP = 2
"""Columns between those of a table."""

SHOWN_PLACES = 4
"""Places of a key that are listed; of more, only their number."""

__all__ = ["print_list", "print_one"]


def print_list(found: Sequence[Explanation], console: Console) -> None:
    """Print one line per topic."""
    table = Table(box=None, pad_edge=False)
    table.add_column("name", no_wrap=True)
    table.add_column("what it is", overflow="fold")
    for topic in found:
        table.add_row(topic.name, topic.title)
    console.print(table)
    told = "flexure explain NAME shows its formulas; NAME may be any key of a spec, e.g. lock"
    console.print(Text(told, "dim"))


def print_one(topic: Explanation, console: Console) -> None:
    """Print a topic: each formula, or the chosen table."""
    console.print(Text(f"{topic.name}: {topic.title}", "bold"))
    if topic.table is not None:
        _print_table(topic.table, console)
        return
    for field in topic.fields:
        console.print()
        _print_field(field, console)
    for formula in topic.formulas:
        console.print()
        _print_formula(formula, console)


def _print_field(field: FieldRow, console: Console) -> None:
    console.print(Text(field.path, "bold"))
    if field.text:
        console.print(Text(field.text))
    facts = [field.written]
    facts += ["must be given"] if field.required else []
    facts += [f"default: {field.default}"] if field.default else []
    console.print(Text("; ".join(facts)))
    if field.kinds:
        console.print(Text(f"of {', '.join(field.kinds)}", "dim"))
    if len(field.also) > SHOWN_PLACES:
        console.print(Text(f"and in {len(field.also)} other places", "dim"))
    elif field.also:
        console.print(Text(f"also {', '.join(field.also)}", "dim"))
    if field.axes:
        console.print()
        _print_as_is(field.axes, console)
    if field.keys:
        console.print()
        _print_keys(field.keys, console)
    if field.example:
        console.print()
        _print_as_is(field.example, console)


def _print_keys(keys: Sequence[KeyRow], console: Console) -> None:
    table = Table(box=None, pad_edge=False)
    for column in ("key", "default", "what it is"):
        table.add_column(column, overflow="fold")
    for key in keys:
        default = "must be given" if key.required else key.default
        table.add_row(Text(key.name), Text(default), Text(key.text))
    console.print(table)


def _print_as_is(text: str, console: Console) -> None:
    """Print lines meant for copying, or drawn with characters: without wrapping."""
    for line in text.strip("\n").splitlines():
        console.print(Text(line), soft_wrap=True)


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
    titles = {c: f"{c} [{unit}]" if unit else c for c, unit in found.units.items()}
    texts = {c: [f"{x:.5g}" for x in values] for c, values in found.columns.items()}
    variable, *rest = titles
    widths = {c: max(map(len, (titles[c], *texts[c]))) + GAP for c in titles}
    while rest:
        # as many columns as stand beside the variable; the others below, with it again
        room = console.width - widths[variable]
        taken = [c for i, c in enumerate(rest) if sum(widths[c] for c in rest[: i + 1]) <= room]
        shown = taken or rest[:1]
        rest = rest[len(shown) :]
        table = Table(box=None, pad_edge=False)
        for column in (variable, *shown):
            table.add_column(titles[column], justify="right", no_wrap=True)
        for row in zip(*(texts[column] for column in (variable, *shown)), strict=True):
            table.add_row(*row)
        console.print(table)
    if found.note:
        console.print(Text(found.note, "dim"))
