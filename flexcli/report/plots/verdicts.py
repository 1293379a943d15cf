"""Plots of verdicts: margins with their ranges, and accuracy against time of each model."""

from collections.abc import Sequence

import numpy as np

from flexcli.report.plots.chart import COLOURS, Axis, Chart
from flexcli.report.plots.plot import Plot
from flexcli.results import Check, Verdict
from flexcli.results.accuracy import AccuracyResult

__all__ = ["accuracy_plot", "margins_plot"]

WIDEST = (0.1, 1e3)
"""Factors over the required one that a bar is drawn between."""


def margins_plot(checks: Sequence[Check]) -> Plot:
    """Return the factors over the required ones as bars, each with its range."""
    rows = [c for c in checks if np.isfinite(c.factor) and c.required > 0.0]
    names = tuple(f"{c.verdict.value.upper()} {c.full_name}" for c in rows)
    chart = Chart(Axis("factor over the required one", log=True), Axis("", names=names))
    for k, check in enumerate(rows):
        ends = check.factor_range or (check.factor, check.factor)
        low, high = np.clip([end / check.required for end in ends], *WIDEST).tolist()
        colour = check.verdict.value if check.verdict.value in COLOURS else "ink3"
        done = check.verdict in (Verdict.PASS, Verdict.FAIL)
        chart.bar(k, low, high, colour, filled=done)
        chart.tick(k, float(np.clip(check.factor / check.required, *WIDEST)))
    chart.rule(x=1.0, width=1.5)
    return Plot(
        "margins", "Margins", "Each bar is the range by the error of the model that decided; the "
        "mark its value, the upright line what is required.", chart.svg(),
    )  # fmt: skip


def accuracy_plot(found: AccuracyResult) -> Plot:
    """Return error against time of every model on a design."""
    chart = Chart(Axis("time for all quantities, s", log=True), Axis("largest error", log=True))
    for model in found.models:
        if np.isfinite(model.error):
            error = max(model.error, 1e-15)
            chart.marks(model.seconds, error, filled=model.pareto)
            chart.note(model.model, model.seconds, error)
    chart.rule(y=found.accuracy, name="asked", colour="fail")
    return Plot(
        "accuracy", "What accuracy costs",
        "Filled: no model is both faster and nearer. The line is the accuracy asked.", chart.svg(),
    )  # fmt: skip
