"""Plots of a tolerance run: yields, sensitivities of the margins, the tolerance to narrow first."""

from collections.abc import Iterator

from flexcli.report.numbers import share_text
from flexcli.report.plots.chart import Axis, Chart
from flexcli.report.plots.plot import Plot
from flexcli.results.tolerances import TolerancesResult, YieldRow

__all__ = ["tolerances_plots"]


def tolerances_plots(found: TolerancesResult) -> Iterator[Plot]:
    """Yield the yields with their intervals, the margins of the parts, and their causes."""
    yield _yields(found)
    yield _narrowing(found)
    for row in found.checks:
        if row.histogram is not None:
            yield _histogram(row)
        if row.total:
            yield _causes(row)


def _yields(found: TolerancesResult) -> Plot:
    rows = [*found.checks, found.together]
    names = tuple(f"{r.name}: {share_text(r.passed)} [{share_text(r.interval[0])}, "
                  f"{share_text(r.interval[1])}]" for r in rows)  # fmt: skip
    least = min(99.0, *(100.0 * row.interval[0] for row in rows))
    chart = Chart(Axis("parts that pass, %", least=least, most=100.0), Axis("", names=names))
    asked = found.asked
    for k, row in enumerate(rows):
        low, high = row.interval
        colour = "ink2" if asked is None else "pass" if low >= asked else "undecided"
        colour = "fail" if asked is not None and high < asked else colour
        chart.bar(k, 100.0 * low, 100.0 * high, colour)
        chart.tick(k, 100.0 * row.passed)
    if asked is not None:
        chart.rule(x=100.0 * asked, width=1.5)
    return Plot(
        "yields", "Yields", f"Share of {found.parts} parts that pass, and where it lies with "
        f"{share_text(found.confidence)} confidence{'; the line is what is asked' * bool(asked)}.",
        chart.svg(),
    )  # fmt: skip


def _narrowing(found: TolerancesResult) -> Plot:
    rows = sorted(found.tolerances, key=lambda row: -row.halved)
    names = tuple(f"{row.name}: {share_text(row.halved)}" for row in rows)
    least = min(99.0, *(100.0 * row.halved for row in rows))
    chart = Chart(Axis("parts that pass all, %", least=least, most=100.0), Axis("", names=names))
    for k, row in enumerate(rows):
        chart.bar(k, 100.0 * found.together.passed, 100.0 * row.halved, "ink2")
    chart.rule(x=100.0 * found.together.passed, width=1.5)
    return Plot(
        "narrowing", "Which tolerance to narrow first",
        "Share of the parts that would pass all with this one tolerance halved, from the line, "
        "which is today's.", chart.svg(),
    )  # fmt: skip


def _histogram(row: YieldRow) -> Plot:
    assert row.histogram is not None  # the caller's
    edges, shares = row.histogram
    chart = Chart(Axis("factor over the required one", least=1.0, most=1.0), Axis("parts, %"))
    for low, high, share in zip(edges[:-1], edges[1:], shares, strict=True):
        chart.column(low, high, 100.0 * share)
    chart.rule(x=1.0, width=1.5, name="required", colour="ink")
    chart.rule(x=row.nominal, colour="motion", name="as drawn")
    return Plot(
        "parts", f"Margin of the parts, {row.name}",
        "Share of the parts by factor over the required one; left of the line they fail.",
        chart.svg(),
    )  # fmt: skip


def _causes(row: YieldRow) -> Plot:
    told = sorted(row.total.items(), key=lambda each: -each[1])
    names = tuple(f"{name}: {100.0 * row.first.get(name, 0.0):.2g} % by itself, "
                  f"{100.0 * total:.2g} % in all" for name, total in told)  # fmt: skip
    chart = Chart(Axis("share of the variance, %", least=0.0, most=100.0), Axis("", names=names))
    for k, (name, total) in enumerate(told):
        chart.bar(k, 0.0, 100.0 * total, "ink2", filled=False)
        chart.bar(k, 0.0, 100.0 * row.first.get(name, 0.0), "ink2")
    return Plot(
        "causes", f"What the margin depends on, {row.name}",
        "Sobol's indices of the logarithm of the factor: filled by itself, outlined with what it "
        "does together with others.", chart.svg(),
    )  # fmt: skip
