"""The layout of text output: hanging lines, and tables that become blocks where they do not fit."""

import re
from collections.abc import Iterable, Iterator
from functools import cache
from itertools import zip_longest
from typing import Protocol

from flexcli.report.charset import plain
from flexcli.report.formats import Page
from flexcli.report.styled import Text, cell_len
from flexcli.units import SHOWN_UNITS

__all__ = ["GAP", "Cell", "Drawing", "Line", "Piece", "Rows", "Unbroken", "on_page", "table"]

Cell = str | tuple[str, str]
"""A text, or a text with its style."""

GAP = 2
"""Spaces between columns, and before what belongs to a line above."""

FEWEST = 12
"""Characters of a column of texts, if they have as many, below which blocks read better."""


GLUE = "\ue000"
"""Stands for the space between a number and its unit until lines are broken."""


class Laid(Protocol):
    """What lays itself out in lines."""

    def lines(self, width: int, encoding: str) -> Iterator[Text]:
        """Yield its lines on a page of so many columns, in the characters that it has."""
        ...


Piece = Laid | str
"""A piece of text output; a text alone is a paragraph."""


@cache
def _quantity(encoding: str) -> re.Pattern[str]:
    units = "|".join(re.escape(plain(unit, encoding)) for unit in sorted(SHOWN_UNITS))
    return re.compile(rf"(?<=\d) (?=(?:{units})(?![\w/*^·²³]))")


def _text(cell: Cell, encoding: str) -> Text:
    text, style = (cell, "") if isinstance(cell, str) else cell
    return Text((_quantity(encoding).sub(GLUE, plain(text, encoding)), style))


def _lines(text: Text, width: int) -> list[Text]:
    """Return the lines that a text is broken into, at least one, no quantity torn."""
    return [line.replace(GLUE, " ") for line in text.broken(width)]


def _broken(row: list[Text], widths: list[int]) -> list[list[Text]]:
    return [_lines(cell, width) for cell, width in zip(row, widths, strict=False)]


def _joined(separator: str, texts: Iterable[Text]) -> Text:
    found: list[tuple[str, str]] = []
    for text in texts:
        found += [(separator, "")] * bool(found) + [*text.runs]
    return Text(*found)


def _spaces(count: int) -> Text:
    return Text((" " * count, ""))


class Line:
    """A paragraph of differently styled texts; what does not fit goes on below, indented."""

    def __init__(self, *cells: Cell, indent: int = 0, hang: int = 0) -> None:
        self.cells, self.indent, self.hang = cells, indent, hang

    def lines(self, width: int, encoding: str) -> Iterator[Text]:
        """Yield its lines."""
        whole = _joined("", (_text(cell, encoding) for cell in self.cells))
        broken = _lines(whole, max(1, width - self.indent - self.hang))
        for number, line in enumerate(broken):
            yield _spaces(self.indent + (self.hang if number else 0)) + line


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

    def lines(self, width: int, encoding: str) -> Iterator[Text]:
        """Yield its title after an empty line, and its rows."""
        if self.title:
            yield Text()
            yield from Line((self.title, "bold")).lines(width, encoding)
        rows = [[_text(cell, encoding) for cell in row] for row in self.cells]
        heads = [Text((plain(head, encoding), "bold")) for head in self.columns]
        widths = self._widths(heads, rows, width)
        if widths is None:
            yield from self._blocks(heads, rows, width)
            return
        if self.show_header:
            broken = _broken(heads, widths)
            tall = max(map(len, broken))
            # heads of fewer lines stand upon the rows
            yield from self._beside([[Text()] * (tall - len(x)) + x for x in broken], widths)
        for row in rows:
            yield from self._beside(_broken(row, widths), widths)

    def _beside(self, cells: list[list[Text]], widths: list[int]) -> Iterator[Text]:
        """Yield the lines of a row, each cell in its column."""
        for line in zip_longest(*cells, fillvalue=Text()):
            found: list[tuple[str, str]] = []
            for index, (text, width) in enumerate(zip(line, widths, strict=False)):
                room = (" " * (width - cell_len(text.plain)), "")
                found += [room, *text.runs] if index in self.numbers else [*text.runs, room]
                found.append((" " * GAP, ""))
            yield Text(*found)

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

    def _blocks(self, heads: list[Text], rows: list[list[Text]], width: int) -> Iterator[Text]:
        for row in rows:
            yield from _lines(
                _joined(" ", (cell for cell in row[: self.leads] if cell.plain.strip())), width
            )
            rest = [
                _joined(" ", [head, cell] if head.plain else [cell])
                for head, cell in zip(heads[self.leads :], row[self.leads :], strict=False)
                if cell.plain.strip()
            ]
            if rest:
                for line in _lines(_joined(", ", rest), max(1, width - GAP)):
                    yield _spaces(GAP) + line


class Unbroken:
    """Lines meant for copying: they are as long as they are."""

    def __init__(self, text: str) -> None:
        self.texts = text.split("\n")

    def lines(self, _: int, encoding: str) -> Iterator[Text]:
        """Yield its lines."""
        return (Text((plain(text, encoding), "")) for text in self.texts)


class Drawing(Unbroken):
    """Lines that are drawn with characters; left out where the page is too narrow for them."""

    def lines(self, width: int, encoding: str) -> Iterator[Text]:
        """Yield its lines, or none."""
        drawn = [*super().lines(width, encoding)]
        if max(cell_len(line.plain) for line in drawn) <= width:
            yield from drawn


def table(title: str, *columns: str, numbers: Iterable[int] = ()) -> Rows:
    """Return an empty table."""
    return Rows(title, columns, numbers)


def on_page(pieces: Iterable[Piece], page: Page) -> str:
    """Return pieces of text one below the other, as a page takes them."""
    laid = (Line(piece) if isinstance(piece, str) else piece for piece in pieces)
    return "".join(
        f"{line.shown(page.is_coloured).rstrip()}\n"
        for piece in laid
        for line in piece.lines(page.width, page.encoding)
    )
