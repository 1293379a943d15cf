"""Plots of a sizing: feasible region, sensitivities, Pareto front."""

from importlib import import_module

import numpy as np

from flexcli.errors import SolveError
from flexcli.report.plots.chart import Axis, Chart
from flexcli.report.plots.plot import Plot, in_unit
from flexcli.results.dossier import Region
from flexcli.results.sizing import SizingResult
from flexcli.results.trade_off import Front

__all__ = ["front_plot", "region_plot", "tornado_plot"]

MOST_BARS = 14
"""Bars of a tornado."""


def region_plot(region: Region) -> Plot:
    """Return where every closed-form margin holds, over two sizes."""
    try:
        contours = import_module("contourpy").contour_generator
    except ImportError as error:
        hint = "pip install 'flexcli[report]'"
        text = "the plot of feasible sizes needs the extra 'report'"
        raise SolveError("no-contours", text, hint) from error
    x, y = (np.log(np.array(v) * 1e3) for v in (region.x, region.y))
    margins = {name: np.array(rows) for name, rows in region.margins.items()}
    sides = zip(region.names, (region.x, region.y), strict=True)
    chart = Chart(*(Axis(f"{name}, mm", log=True, least=1e3 * v[0], most=1e3 * v[-1])
                    for name, v in sides))  # fmt: skip
    worst = np.log(np.min([*margins.values()], axis=0))
    areas, _ = contours(x, y, worst, fill_type="OuterOffset").filled(0.0, np.inf)
    chart.areas([np.exp(corners) for corners in areas])
    for name, margin in margins.items():
        if margin.min() < 1.0 < margin.max():
            for line in contours(x, y, np.log(margin)).lines(0.0):
                across, up = np.exp(line).T
                chart.curve(across, up, width=1.0)
                some = slice(None, None, max(len(line) // 8, 1))
                chart.note(name, across[some], up[some])
    chart.marks(1e3 * region.chosen[0], 1e3 * region.chosen[1], "motion")
    return Plot(
        "region", "Feasible sizes",
        "Shaded where every requirement holds by the closed forms, the other sizes as chosen; each "
        "line is one requirement just met, the dot the design.", chart.svg(),
    )  # fmt: skip


def tornado_plot(sizing: SizingResult) -> Plot:
    """Return what 1 % more of each demand changes, the largest on top."""
    rows = [
        (f"{name} by {row.driver or row.constraint}", change)
        for row in sizing.sensitivities
        for name, change in row.on.items()
    ]
    rows = sorted(rows, key=lambda row: -abs(row[1]))[:MOST_BARS]
    names = tuple(f"{name}: {change:+.2f} %".replace("-", "−") for name, change in rows)
    chart = Chart(Axis("change for 1 % more, %"), Axis("", names=names))
    for k, (_, change) in enumerate(rows):
        chart.bar(k, 0.0, change, "ink2")
    chart.rule(x=0.0)
    return Plot(
        "tornado", "1 % more of each demand", "Change of the optimum's sizes and objective.",
        chart.svg(),
    )  # fmt: skip


def front_plot(front: Front) -> Plot:
    """Return the designs of which none is better in both objectives, the knee filled."""
    axes, places = [], []
    for key, unit, of in (
        (front.second, front.second_unit, "second"), (front.first, front.first_unit, "first")
    ):  # fmt: skip
        values = np.array([getattr(point, of) for point in front.points])
        shown, size = in_unit(values, unit)
        axes.append(Axis(f"{key}, {shown}".rstrip(", "), log=bool((values > 0.0).all())))
        places.append(values / size)
    x, y = places
    chart = Chart(*axes)
    chart.curve(x, y, width=1.0, colour="ink3")
    chart.marks(x, y, filled=False)
    if front.knee is not None:
        at = x[front.knee], y[front.knee]
        chart.marks(*at)
        chart.note("knee", *at, "ink")
    proof = "each a global optimum" if front.proved else "not proved to be the best"
    return Plot(
        "front", "Pareto front", f"Designs of which none is better in both, {proof}; at the knee, "
        "filled, little of one starts to cost much of the other.", chart.svg(),
    )  # fmt: skip
