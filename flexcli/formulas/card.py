"""A formula as data: what ``explain`` prints of it, and the ranges that checks hold a design to.

What the docstring of a formula says (its sentence, equation, symbols with units, source) is read
from there; a card adds what a docstring cannot be queried for: validity, a worked case, tables.
"""

import inspect
import re
from collections.abc import Callable, Mapping
from functools import cache
from math import inf, radians
from typing import Any, NamedTuple

from flexcli.results import QuantityKind
from flexcli.units import show

__all__ = [
    "SLENDER",
    "SMALL_ROTATION",
    "Card",
    "Range",
    "Sheet",
    "Symbol",
    "Table",
    "outside",
    "sheet",
]


class Range(NamedTuple):
    """Where a formula holds: a dimensionless (or SI) quantity between two ends, and why.

    ``kind`` names the numbers that it limits, where not all of a joint are.
    """

    quantity: str
    least: float = -inf
    most: float = inf
    why: str = ""
    unit: str = ""
    kind: QuantityKind | None = None

    @property
    def spoken(self) -> str:
        """Return the range in words."""
        low, high = show(self.least, self.unit), show(self.most, self.unit)
        if self.least == -inf:
            return f"at most {high}"
        return f"at least {low}" if self.most == inf else f"{low} to {high}"


SLENDER = Range("l/h", least=10.0, why="a shorter blade is no slender beam")

SMALL_ROTATION = Range(
    "theta", most=radians(10.0), unit="rad", why="the closed form is the first term in the rotation"
)


class Symbol(NamedTuple):
    """A symbol of a formula with its SI unit ("" for none) and meaning."""

    name: str
    unit: str
    meaning: str


class Table(NamedTuple):
    """A chart as data: columns against one variable; each column is (unit, function of it)."""

    variable: str
    values: tuple[float, ...]
    columns: Mapping[str, tuple[str, Callable[[float], Any]]]
    note: str = ""
    unit: str = ""


class Card(NamedTuple):
    """A formula with its validity, one worked case (SI), and the charts drawn from it.

    ``kind`` says which numbers of a joint it makes: outside its validity nobody judges by them.
    """

    name: str
    function: Callable[..., Any]
    example: Mapping[str, Any]
    validity: tuple[Range, ...] = ()
    tables: Mapping[str, Table] = {}
    kind: QuantityKind | None = None


class Sheet(NamedTuple):
    """The sections of a formula's docstring."""

    title: str
    equation: str
    symbols: tuple[Symbol, ...]
    gives: tuple[Symbol, ...]
    notes: str
    source: str


_SECTION = re.compile(r"^(\w+)\n-{3,}\n", re.MULTILINE)
_UNIT = re.compile(r"\[([^\]]*)\]")


@cache
def sheet(function: Callable[..., Any]) -> Sheet:
    """Return what the docstring of a formula says, section by section."""
    text = inspect.getdoc(function) or ""
    head, *rest = _SECTION.split(text)
    sections = dict(zip(rest[::2], rest[1::2], strict=True))
    title, *body = [p.replace("\n", " ").strip() for p in head.strip().split("\n\n")]
    title = title.removeprefix("Return ").removeprefix("Give ").removesuffix(".")
    return Sheet(
        title=_begun(title),
        equation=" ".join(body).replace("``", ""),
        symbols=tuple(_entries(sections.get("Parameters", ""))),
        gives=tuple(_entries(sections.get("Returns", ""))),
        notes=_joined(sections.get("Notes", "")),
        source=_joined(sections.get("References", "")),
    )


def _joined(text: str) -> str:
    return " ".join(text.replace("``", "").split())


def _entries(section: str) -> list[Symbol]:
    """Return the symbols of a section; several names on one line share unit and meaning."""
    found = []
    for entry in re.split(r"\n(?=\S)", section.strip()):
        names, _, meaning = entry.partition("\n")
        if not meaning:
            continue
        meaning = _joined(meaning)
        unit = _UNIT.search(meaning)
        said = "" if unit is None or unit[1] == "-" else unit[1]
        spoken = re.sub(r"\s+([.,;])", r"\1", " ".join(_UNIT.sub("", meaning).split()))
        each = [name.strip() for name in names.split(":")[0].split(",")]
        meanings = _one_by_one(spoken.rstrip(".,"), len(each))
        found += [Symbol(*pair) for pair in zip(each, (said,) * len(each), meanings, strict=True)]
    return found


def _one_by_one(meaning: str, count: int) -> list[str]:
    """Return the meaning of each of several symbols, from e.g. "Length and width of a blade"."""
    listed = meaning.partition(";")[0]
    parts = re.split(r",? and |, ", listed)
    if count == 2 and len(parts) != 2:
        parts = re.split(r",? and ", listed, maxsplit=1)
    if count == 1 or len(parts) != count:
        return [meaning] * count
    if parts[0].endswith("'s"):  # Young's and shear modulus
        parts[0] = f"{parts[0]} {parts[1].split()[1]}"
    whole = re.search(r" of .*| between .*| in .*", parts[-1])
    tail = whole[0] if whole else ""
    found = [part if part.endswith(tail) or " of " in part else part + tail for part in parts]
    return [_begun(part) for part in found]


def outside(validity: tuple[Range, ...], at: Mapping[str, float]) -> list[Range]:
    """Return the ranges of validity that a design, given by its quantities, lies outside of."""
    return [r for r in validity if r.quantity in at and not r.least <= at[r.quantity] <= r.most]


def _begun(sentence: str) -> str:
    """Return a sentence with a capital letter, unless it begins with a symbol such as σ_x."""
    return sentence[:1].upper() + sentence[1:] if sentence[:1].isascii() else sentence
