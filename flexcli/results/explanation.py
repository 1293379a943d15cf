"""The content of ``explain``: formulas, their validity, and charts as data."""

from collections.abc import Mapping
from typing import NamedTuple

__all__ = [
    "Explanation",
    "FieldRow",
    "FormulaRow",
    "KeyRow",
    "SymbolRow",
    "TableRow",
    "ValidityRow",
]


class SymbolRow(NamedTuple):
    """A symbol of a formula, its SI unit and meaning, and its value in the worked case."""

    name: str
    unit: str
    meaning: str
    value: float | str | None


class ValidityRow(NamedTuple):
    """The range of a quantity in which a formula holds; no end is infinite but left out."""

    quantity: str
    least: float | None
    most: float | None
    unit: str
    why: str
    text: str


class FormulaRow(NamedTuple):
    """A formula with its worked case; ``gives`` are its results, ``symbols`` its arguments."""

    name: str
    title: str
    equation: str
    symbols: tuple[SymbolRow, ...]
    gives: tuple[SymbolRow, ...]
    validity: tuple[ValidityRow, ...]
    notes: str
    source: str
    tables: tuple[str, ...]


class TableRow(NamedTuple):
    """A chart as data: SI values of each column by the values of one variable."""

    name: str
    columns: Mapping[str, tuple[float, ...]]
    units: Mapping[str, str]
    note: str


class KeyRow(NamedTuple):
    """A key of a part of a spec: its name, what it means, how it is written, its default."""

    name: str
    text: str
    written: str
    default: str
    required: bool


class FieldRow(NamedTuple):
    """A key of a spec, or a kind of part: where, what, how it is written, YAML to copy.

    ``also`` are other places of the same meaning, ``kinds`` the parts that have it, ``keys`` what
    it holds, ``axes`` a sketch of them.
    """

    path: str
    also: tuple[str, ...]
    kinds: tuple[str, ...]
    text: str
    written: str
    default: str
    required: bool
    keys: tuple[KeyRow, ...]
    axes: str
    example: str


class Explanation(NamedTuple):
    """A part, or a formula alone; ``fields`` are what a spec says of it."""

    name: str
    also: tuple[str, ...]
    title: str
    formulas: tuple[FormulaRow, ...]
    table: TableRow | None = None
    fields: tuple[FieldRow, ...] = ()
