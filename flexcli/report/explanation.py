"""The text of ``explain`` for a terminal."""

from collections.abc import Iterator, Sequence

from flexcli.report.charset import plain
from flexcli.report.styled import Text, cell_len
from flexcli.report.tables import GAP, Line, Piece, Unbroken, table
from flexcli.results.explanation import (
    Explanation,
    FieldRow,
    FormulaRow,
    KeyRow,
    SymbolRow,
    TableRow,
)
from flexcli.units import show

SHOWN_PLACES = 4
"""Places of a key that are listed; of more, only their number."""

__all__ = ["list_of", "sheet"]


def list_of(found: Sequence[Explanation]) -> Iterator[Piece]:
    """Yield one line per topic."""
    topics = table("", "name", "what it is")
    for topic in found:
        topics.add_row(topic.name, topic.title)
    yield topics
    told = "flexure explain NAME shows its formulas; NAME may be any key of a spec, e.g. lock"
    yield Line((told, "dim"))


def sheet(topic: Explanation) -> Iterator[Piece]:
    """Yield a topic: each formula, or the chosen table."""
    yield Line((f"{topic.name}: {topic.title}", "bold"))
    if topic.table is not None:
        yield Chart(topic.table)
        if topic.table.note:
            yield from _paragraphs(topic.table.note, "dim")
        return
    for field in topic.fields:
        yield ""
        yield from _field(field)
    for formula in topic.formulas:
        yield ""
        yield from _formula(formula)


def _paragraphs(text: str, style: str = "") -> Iterator[Piece]:
    return (Line((line, style)) for line in text.split("\n"))


def _field(field: FieldRow) -> Iterator[Piece]:
    yield Line((field.path, "bold"))
    if field.text:
        yield from _paragraphs(field.text)
    facts = [field.written]
    facts += ["must be given"] if field.required else []
    facts += [f"default: {field.default}"] if field.default else []
    yield Line("; ".join(facts))
    if field.kinds:
        yield Line((f"of {', '.join(field.kinds)}", "dim"))
    if len(field.also) > SHOWN_PLACES:
        yield Line((f"and in {len(field.also)} other places", "dim"))
    elif field.also:
        yield Line((f"also {', '.join(field.also)}", "dim"))
    if field.axes:
        yield from ("", Unbroken(field.axes.strip("\n")))
    if field.keys:
        yield ""
        yield _keys(field.keys)
    if field.example:
        yield from ("", Unbroken(field.example.strip("\n")))


def _keys(keys: Sequence[KeyRow]) -> Piece:
    found = table("", "key", "default", "what it is")
    for key in keys:
        found.add_row(key.name, "must be given" if key.required else key.default, key.text)
    return found


def _formula(formula: FormulaRow) -> Iterator[Piece]:
    yield Line((f"{formula.name}: {formula.title}", "bold"))
    yield from _paragraphs(formula.equation)
    symbols = table("", "symbol", "worked case", "meaning")
    for symbol in (*formula.symbols, *formula.gives):
        symbols.add_row(symbol.name, _value(symbol), symbol.meaning)
    yield symbols
    for row in formula.validity:
        yield Line(f"valid for {row.text}: {row.why}")
    if formula.notes:
        yield from _paragraphs(formula.notes)
    yield from _paragraphs(f"source: {formula.source}", "dim")
    for name in formula.tables:
        yield Line((f"chart as data: --table {name}", "dim"))


def _value(symbol: SymbolRow) -> str:
    if symbol.value is None:
        return ""
    if isinstance(symbol.value, str):
        return f"{symbol.value} {symbol.unit}".rstrip()
    return show(symbol.value, symbol.unit.replace("·", "*"))


class Chart:
    """A chart as numbers: columns that do not fit beside the others stand below, x again first."""

    def __init__(self, found: TableRow) -> None:
        self.found = found

    def lines(self, width: int, encoding: str) -> Iterator[Text]:
        """Yield its lines."""
        units = self.found.units.items()
        titles = {c: plain(f"{c} [{unit}]" if unit else c, encoding) for c, unit in units}
        texts = {c: [f"{x:.5g}" for x in values] for c, values in self.found.columns.items()}
        variable, *rest = titles
        widths = {c: max(map(cell_len, (titles[c], *texts[c]))) + GAP for c in titles}
        while rest:
            room = width + GAP - widths[variable]
            taken = [c for i, c in enumerate(rest) if sum(widths[c] for c in rest[: i + 1]) <= room]
            shown = (variable, *(taken or rest[:1]))
            rest = rest[len(shown) - 1 :]
            rows = table("", *(titles[c] for c in shown), numbers=range(len(shown)))
            for row in zip(*(texts[c] for c in shown), strict=True):
                rows.add_row(*row)
            yield from rows.lines(width, encoding)
