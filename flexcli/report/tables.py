"""The layout of text output: hanging lines, and tables that become blocks where they do not fit."""

import re
from collections.abc import Callable, Iterable
from functools import cache
from io import StringIO

from rich.cells import cell_len
from rich.console import Console, ConsoleOptions, RenderableType, RenderResult
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from flexcli.report.charset import plain
from flexcli.report.formats import Page
from flexcli.units import SHOWN_UNITS

__all__ = ["Cell", "Drawing", "Line", "Rows", "on_page", "table"]

Cell = str | tuple[str, str]
"""A text, or a text with its style."""

GAP = 2
"""Spaces between columns, and before what belongs to a line above."""

FEWEST = 12
"""Characters of a column of texts, if they have as many, below which blocks read better."""


GLUE = "\ue000"
"""Stands for the space between a number and its unit until lines are broken."""


@cache
def _quantity(encoding: str) -> re.Pattern[str]:
    units = "|".join(re.escape(plain(unit, encoding)) for unit in sorted(SHOWN_UNITS))
    return re.compile(rf"(?<=\d) (?=(?:{units})(?![\w/*^·²³]))")


def _text(cell: Cell, encoding: str) -> Text:
    text, style = (cell, "") if isinstance(cell, str) else cell
    return Text(_quantity(encoding).sub(GLUE, plain(text, encoding)), style)


def _lines(text: Text, console: Console, width: int) -> list[Text]:
    """Return the lines that a text is broken into, at least one, no quantity torn."""
    lines = [*text.wrap(console, width)] or [Text()]
    for line in lines:
        line.plain = line.plain.replace(GLUE, " ")
    return lines


def _broken(text: Text, console: Console, width: int) -> Text:
    return Text("\n").join(_lines(text, console, width))


class Line:
    """A paragraph of differently styled texts; what does not fit goes on below, indented."""

    def __init__(self, *cells: Cell, indent: int = 0, hang: int = 0) -> None:
        self.cells, self.indent, self.hang = cells, indent, hang

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """Render it for rich."""
        whole = Text.assemble(*(_text(cell, options.encoding) for cell in self.cells))
        width = max(1, options.max_width - self.indent - self.hang)
        for number, line in enumerate(_lines(whole, console, width)):
            yield Padding(line, (0, 0, 0, self.indent + (self.hang if number else 0)))


class Rows:
    """A table without frame; columns of numbers stand right and never wrap, words never break.

    On a page that is too narrow for that each row is a block: the texts that lead it, then
    the rest with the heads of their columns.
    """

    def __init__(self, title: str, columns: Iterable[str], numbers: Iterable[int]) -> None:
        self.title, self.columns, self.numbers = title, tuple(columns), frozenset(numbers)
        self.cells: list[tuple[Cell, ...]] = []
        self.show_header = True
        self.leads = next((i for i in range(len(self.columns)) if i in self.numbers), 1) or 1

    def add_row(self, *cells: Cell) -> None:
        """Add a row; cells that are left out are empty."""
        self.cells.append(cells)

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """Render it for rich."""
        if self.title:
            yield from ("", Line((self.title, "bold")))
        rows = [[_text(cell, options.encoding) for cell in row] for row in self.cells]
        heads = [Text(plain(head, options.encoding), "bold") for head in self.columns]
        widths = self._widths(heads, rows, options.max_width)
        if widths is None:
            yield from self._blocks(heads, rows, console, options.max_width)
            return
        found = Table(box=None, pad_edge=False, padding=(0, GAP, 0, 0))
        found.show_header = self.show_header
        for index, (head, width) in enumerate(zip(heads, widths, strict=True)):
            right = index in self.numbers
            found.add_column(head, justify="right" if right else "left", width=width)
        for row in rows:
            found.add_row(*(_broken(c, console, w) for c, w in zip(row, widths, strict=False)))
        yield found

    def _widths(self, heads: list[Text], rows: list[list[Text]], most: int) -> list[int] | None:
        """Return the widths of the columns, the widest texts made narrower; nothing if too many."""
        widths, least = [], []
        for index, head in enumerate(heads):
            cells = [row[index].plain for row in rows if index < len(row)]
            words = [word for text in (head.plain, *cells) for word in text.split()]
            unbroken = cells if index in self.numbers else []
            widths.append(max(map(cell_len, (head.plain, *cells)), default=0))
            some = 0 if index in self.numbers else min(widths[-1], FEWEST)
            least.append(max((some, *map(cell_len, (*words, *unbroken)))))
        room = most - GAP * (len(widths) - 1)
        if sum(least) > room:
            return None
        while (excess := sum(widths) - room) > 0:
            wide = max((i for i, w in enumerate(widths) if w > least[i]), key=widths.__getitem__)
            next_wide = max((w for w in widths if w < widths[wide]), default=0)
            widths[wide] = max(least[wide], next_wide, widths[wide] - excess)
        return widths

    def _blocks(
        self, heads: list[Text], rows: list[list[Text]], console: Console, width: int
    ) -> Iterable[RenderableType]:
        for row in rows:
            lead = [cell for cell in row[: self.leads] if cell.plain.strip()]
            yield _broken(Text(" ").join(lead), console, width)
            rest = [
                Text.assemble(head.plain, " " * bool(head.plain), cell)
                for head, cell in zip(heads[self.leads :], row[self.leads :], strict=False)
                if cell.plain.strip()
            ]
            if rest:
                told = _broken(Text(", ").join(rest), console, max(1, width - GAP))
                yield Padding(told, (0, 0, 0, GAP))


class Drawing:
    """Lines that are drawn with characters; left out where the page is too narrow for them."""

    def __init__(self, text: str) -> None:
        self.lines = text.split("\n")

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        """Render it for rich."""
        lines = [plain(line, options.encoding) for line in self.lines]
        if max(map(cell_len, lines)) <= options.max_width:
            yield Text("\n".join(lines), no_wrap=True)


def table(title: str, *columns: str, numbers: Iterable[int] = ()) -> Rows:
    """Return an empty table."""
    return Rows(title, columns, numbers)


class _Sheet(StringIO):
    """A file in memory with the alphabet of the one that the text is for."""

    def __init__(self, alphabet: str) -> None:
        super().__init__()
        self.alphabet = alphabet

    @property
    def encoding(self) -> str:  # type: ignore[override]
        return self.alphabet


def on_page(body: Callable[[Console], None], page: Page) -> str:
    """Return what a body prints on a page."""
    sheet = _Sheet(page.encoding)
    console = Console(
        file=sheet,
        width=page.width,
        force_terminal=page.is_coloured,
        no_color=not page.is_coloured,
        color_system="standard" if page.is_coloured else None,
        highlight=False,
        markup=False,
        emoji=False,
    )
    body(console)
    return "\n".join(line.rstrip() for line in sheet.getvalue().split("\n"))
