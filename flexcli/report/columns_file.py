"""Columns of numbers or words with their units as a file, CSV or Parquet by its name."""

from collections.abc import Sequence
from importlib import import_module
from math import isnan
from typing import NamedTuple

from flexcli.errors import SolveError
from flexcli.report.rows_csv import rows_csv

__all__ = ["FileColumn", "csv_text", "file_bytes", "parquet_bytes"]


class FileColumn(NamedTuple):
    """A column: its name, SI unit ("" for none), what it is, a cell a row ("" for none)."""

    name: str
    unit: str
    label: str
    cells: Sequence[float | str]


def file_bytes(columns: Sequence[FileColumn], suffix: str) -> bytes:
    """Return columns as what a file of a suffix holds."""
    return parquet_bytes(columns) if suffix == ".parquet" else csv_text(columns).encode()


def csv_text(columns: Sequence[FileColumn]) -> str:
    """Return a heading with units and a row of each cell, numbers with every digit."""
    heading = [f"{c.name} [{c.unit}]" if c.unit else c.name for c in columns]
    rows = zip(*(map(_plain, column.cells) for column in columns), strict=True)
    return rows_csv(heading, rows)


def _plain(cell: float | str) -> float | str:
    return "" if isinstance(cell, float) and isnan(cell) else cell


def parquet_bytes(columns: Sequence[FileColumn]) -> bytes:
    """Return columns as Parquet; each column's unit is in its metadata.

    Raises
    ------
    SolveError
        When what writes Parquet is not installed.

    """
    try:
        arrow, parquet = import_module("pyarrow"), import_module("pyarrow.parquet")
    except ImportError as error:
        hint = "pip install 'flexcli[study]', or write a .csv"
        raise SolveError("no-parquet", "Parquet needs the extra 'study'", hint) from error
    fields, arrays = [], []
    for column in columns:
        is_text = any(isinstance(cell, str) and cell for cell in column.cells)
        kind = arrow.string() if is_text else arrow.float64()
        about = {"unit": column.unit, "label": column.label}
        fields.append(arrow.field(column.name, kind, metadata=about))
        cells = [None if cell == "" else cell for cell in column.cells]
        arrays.append(arrow.array(cells, type=kind))
    sink = arrow.BufferOutputStream()
    parquet.write_table(arrow.table(arrays, schema=arrow.schema(fields)), sink)
    return bytes(sink.getvalue())
