"""Styled text in lines: its width in the cells of a terminal, its breaks, and its colours."""

from collections.abc import Iterator
from functools import cache
from unicodedata import category, east_asian_width

__all__ = ["Text", "cell_len"]

_CODES = {"bold": "1", "dim": "2", "red": "31", "green": "32", "yellow": "33"}
"""What a terminal is told (ECMA-48, select graphic rendition) for each word of a style."""


def cell_len(text: str) -> int:
    """Return how many cells of a terminal a text takes."""
    return len(text) if text.isascii() else sum(map(_cells, text))


@cache
def _cells(character: str) -> int:
    if category(character) in ("Mn", "Me", "Cf"):  # stands on the character before it
        return 0
    return 2 if east_asian_width(character) in ("W", "F") else 1


class Text:
    """A line of runs, each in a style of words such as ``bold red``, or in none."""

    __slots__ = ("plain", "runs")

    def __init__(self, *runs: tuple[str, str]) -> None:
        self.runs = runs
        self.plain = "".join(text for text, _ in runs)

    def __add__(self, other: "Text") -> "Text":
        """Return both in one line."""
        return Text(*self.runs, *other.runs)

    def replace(self, old: str, new: str) -> "Text":
        """Return it with other characters in every run."""
        return Text(*((text.replace(old, new), style) for text, style in self.runs))

    def broken(self, width: int) -> list["Text"]:
        """Return the lines, at least one, that fit a width: broken at spaces, else in words."""
        if cell_len(self.plain) <= width:
            return [self._part(0, len(self.plain))]
        starts = [0, *_breaks(self.plain, width)]
        return [self._part(*ends) for ends in zip(starts, [*starts[1:], None], strict=True)]

    def _part(self, start: int, end: int | None) -> "Text":
        """Return what stands between two places, without the spaces at its end."""
        end = start + len(self.plain[start:end].rstrip())
        runs, at = [], 0
        for text, style in self.runs:
            inside = text[max(0, start - at) : max(0, end - at)]
            if inside:
                runs.append((inside, style))
            at += len(text)
        return Text(*runs)

    def shown(self, is_coloured: bool) -> str:
        """Return it for a terminal, or without styles."""
        if not is_coloured:
            return self.plain
        return "".join(f"\x1b[{_code(s)}m{text}\x1b[0m" if s else text for text, s in self.runs)


def _code(style: str) -> str:
    return ";".join(_CODES[word] for word in style.split())


def _breaks(text: str, width: int) -> Iterator[int]:
    """Yield where lines after the first begin: at words that do not fit, and inside longer ones."""
    place = used = 0
    for word in text.split(" "):
        long = cell_len(word)
        if used and word and used + long > width:
            yield place
            used = 0
        if long > width:
            for offset, character in enumerate(word):
                if used + _cells(character) > width:
                    yield place + offset
                    used = 0
                used += _cells(character)
            used += 1
        else:
            used += long + 1
        place += len(word) + 1
