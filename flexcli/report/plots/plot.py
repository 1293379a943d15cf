"""A plot: a chart with its name on the command line, its title and what it shows."""

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np

from flexcli.report.plots.chart import DASHES, Axis, Chart
from flexcli.units import shown_unit

__all__ = ["Plot", "curves", "in_unit"]


class Plot(NamedTuple):
    """A plot: its key on the command line, its title and description, and the SVG."""

    name: str
    title: str
    caption: str
    svg: str


def in_unit(values: Iterable[float], unit: str) -> tuple[str, float]:
    """Return the unit for the largest of some values as a person reads them, and its size in SI."""
    size = np.abs(np.fromiter(values, dtype=np.float64))
    return shown_unit(float(np.max(size[np.isfinite(size)], initial=0.0)), unit)


def curves(x: Any, rows: Sequence[tuple[str, Any]], x_axis: Axis, y_axis: Axis) -> str:
    """Return the chart of curves over the same values, told apart by their dashes."""
    chart = Chart(x_axis, y_axis)
    for (name, values), dash in zip(rows, DASHES * len(rows), strict=False):
        chart.curve(x, values, name, dash)
    return chart.svg()
