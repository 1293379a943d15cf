"""Rows as CSV text, by the standard library: a name may hold commas, quotes and line breaks."""

import csv
from collections.abc import Iterable, Sequence
from io import StringIO

__all__ = ["rows_csv"]


def rows_csv(heading: Sequence[str], rows: Iterable[Iterable[object]]) -> str:
    """Return a heading and rows; a cell is empty where there is nothing."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(heading)
    writer.writerows(rows)
    return text.getvalue()
