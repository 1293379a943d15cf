"""What ``explain`` tells of a part: its formulas, where they hold, and charts as data."""

from collections.abc import Mapping
from typing import NamedTuple

__all__ = ["Explanation", "FormulaRow", "SymbolRow", "TableRow", "ValidityRow"]


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


class Explanation(NamedTuple):
    """A part, or a formula alone."""

    name: str
    also: tuple[str, ...]
    title: str
    formulas: tuple[FormulaRow, ...]
    table: TableRow | None = None
