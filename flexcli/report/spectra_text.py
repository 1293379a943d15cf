"""Spectra: on the terminal a curve and the maxima, in a file every number."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from flexcli.report.columns_file import FileColumn
from flexcli.report.curve import curve
from flexcli.report.tables import Drawing, Line, Piece, table
from flexcli.results import Result
from flexcli.results.vibration import Spectrum
from flexcli.units import show

__all__ = ["section", "spectra_columns"]


BESIDE = ("density", "transfer")
"""Kinds of spectra that are made for a file, beside a result."""

NEGLIGIBLE = 1e-9
"""Of the largest number of its unit: what is below is rounding, and is not told."""


def section(result: Result) -> Iterator[Piece]:
    """Yield where every column is greatest; of a spectrum that was asked for, its curve before."""
    for spectrum in result.spectra:
        over, *columns = spectrum.columns
        heading = f"{spectrum.case}: {spectrum.name}" if spectrum.case else spectrum.name
        yield Line((heading, "bold"))
        drawn = _drawn(over.values, columns[0].values)
        if drawn is not None and spectrum.kind not in BESIDE:
            yield Drawing(curve(*drawn, linear=False, units=(over.unit, columns[0].unit or "-")))
        tops = {column.name: max(column.values) for column in columns}
        rows = table("", "", "greatest", f"at {over.name}", "", numbers=(1, 2))
        for column in columns:
            alike = max(tops[other.name] for other in columns if other.unit == column.unit)
            if column.name.endswith(" phase") or tops[column.name] < NEGLIGIBLE * alike:
                continue
            at = over.values[column.values.index(tops[column.name])]
            shown = show(tops[column.name], column.unit)
            rows.add_row(column.name, shown, show(at, over.unit), column.label)
        yield rows


def _drawn(x: Sequence[float], y: Sequence[float]) -> tuple[list[float], list[float]] | None:
    """Return the data of a curve on logarithmic axes; None where there is no such curve."""
    points = [(a, b) for a, b in zip(x, y, strict=True) if a > 0.0 and b > 0.0]
    rising = all(b[0] >= a[0] for a, b in pairwise(points))
    if len(points) < 2 or not rising or points[0][0] == points[-1][0]:
        return None
    return [a for a, _ in points], [b for _, b in points]


def spectra_columns(spectra: Sequence[Spectrum]) -> list[FileColumn]:
    """Return all numbers of spectra of one kind; a column says the case where there is one."""
    names: dict[str, tuple[str, str]] = {}
    for spectrum in spectra:
        for column in spectrum.columns:
            names.setdefault(column.name, (column.unit, column.label))
    cases: list[float | str] = []
    cells: dict[str, list[float | str]] = {name: [] for name in names}
    for spectrum in spectra:
        own = {column.name: column.values for column in spectrum.columns}
        count = len(spectrum.columns[0].values)
        cases += [spectrum.case] * count
        for name in names:
            cells[name] += own.get(name, [""] * count)
    told = [FileColumn("case", "", "case of the spec", cases)] if any(cases) else []
    return told + [FileColumn(name, *names[name], column) for name, column in cells.items()]
