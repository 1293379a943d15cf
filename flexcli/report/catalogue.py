"""Lists of what ships: materials, with the source of every number, and examples."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from rich.console import Console

from flexcli.report.tables import Line, table
from flexcli.results import Property
from flexcli.units import show

__all__ = ["document", "print_lines", "print_list", "print_one"]

_LISTED = ("youngs_modulus", "yield_strength", "tensile_strength", "fatigue_amplitude")


def document(titles: Mapping[str, str], rows: Mapping[str, Sequence[Property]]) -> dict[str, Any]:
    """Return materials as JSON content, numbers in SI."""
    return {
        name: {
            "name": titles[name],
            "properties": {
                row.name: {
                    "value": row.value,
                    "unit": row.unit,
                    "detail": row.detail,
                    "status": row.status,
                    "source": row.source,
                }
                for row in properties
            },
        }
        for name, properties in rows.items()
    }


def print_lines(
    heads: tuple[str, ...], rows: Iterable[tuple[str, ...]], told: str, console: Console
) -> None:
    """Print a list of names with their descriptions, and how to use one."""
    listed = table("", *heads)
    for row in rows:
        listed.add_row(*row)
    console.print(listed)
    console.print(Line((told, "dim")))


def print_list(rows: Mapping[str, Sequence[Property]], console: Console) -> None:
    """Print one line per material: stiffness and strengths; a blank is a value nobody gave."""
    listed = table("", "name", "E", "R_p0.2", "R_m", "fatigue", numbers=range(1, 5))
    for name, properties in rows.items():
        known = {row.name: row for row in properties}
        cells = [_cell(known[field]) if field in known else "" for field in _LISTED]
        listed.add_row(name, *cells)
    console.print(listed)
    console.print(Line(("flexure materials NAME shows one with its sources", "dim")))


def _cell(row: Property) -> str:
    mark = "?" if row.status == "placeholder" else ""
    return show(row.value, row.unit) + mark


def print_one(title: str, note: str, properties: Sequence[Property], console: Console) -> None:
    """Print every number of a material with its status and source."""
    console.print(Line((title, "bold")))
    if note:
        console.print(Line(note))
    numbers = table("", "property", "value", "", "status", "source", numbers=[1])
    for row in properties:
        numbers.add_row(row.name, show(row.value, row.unit), row.detail, row.status, row.source)
    console.print(numbers)
