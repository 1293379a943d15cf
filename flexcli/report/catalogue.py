"""Lists of what ships: materials, with the source of every number, and examples."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from flexcli.report.tables import Line, Piece, table
from flexcli.results import Property
from flexcli.units import show

__all__ = ["document", "lines", "list_of", "sheet"]

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


def lines(heads: tuple[str, ...], rows: Iterable[tuple[str, ...]], told: str) -> Iterator[Piece]:
    """Yield a list of names with their descriptions, and how to use one."""
    listed = table("", *heads)
    for row in rows:
        listed.add_row(*row)
    yield listed
    yield Line((told, "dim"))


def list_of(rows: Mapping[str, Sequence[Property]]) -> Iterator[Piece]:
    """Yield one line per material: stiffness and strengths; a blank is a value nobody gave."""
    listed = table("", "name", "E", "R_p0.2", "R_m", "fatigue", numbers=range(1, 5))
    for name, properties in rows.items():
        known = {row.name: row for row in properties}
        cells = [_cell(known[field]) if field in known else "" for field in _LISTED]
        listed.add_row(name, *cells)
    yield listed
    yield Line(("flexure materials NAME shows one with its sources", "dim"))


def _cell(row: Property) -> str:
    mark = "?" if row.status == "placeholder" else ""
    return show(row.value, row.unit) + mark


def sheet(title: str, note: str, properties: Sequence[Property]) -> Iterator[Piece]:
    """Yield every number of a material with its status and source."""
    yield Line((title, "bold"))
    if note:
        yield Line(note)
    numbers = table("", "property", "value", "", "status", "source", numbers=[1])
    for row in properties:
        numbers.add_row(row.name, show(row.value, row.unit), row.detail, row.status, row.source)
    yield numbers
