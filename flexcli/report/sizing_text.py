"""How the dimensions of a design were found, as text for a terminal."""

from collections.abc import Iterator, Mapping

from flexcli.report.tables import Line, Piece, Rows, table
from flexcli.results import Result, Value
from flexcli.results.sizing import SizingResult
from flexcli.units import show

__all__ = ["section"]

MOST_COLUMNS = 4
"""Sizes that a table of designs shows before it leaves the given ones out."""


def section(result: Result) -> Iterator[Piece]:
    """Yield the designs, what holds them, what conflicts, and what a demand costs."""
    sizing = result.sizing
    if sizing is None:
        return
    if sizing.conflict:
        conflict = table("Conflict: these cannot all hold", "requirement", "what would do")
        for relaxation in sizing.conflict:
            conflict.add_row(relaxation.name, relaxation.text)
        yield conflict
    if sizing.designs:
        yield _designs(sizing, result.values)
    yield Line(f"objective: {sizing.objective} ({sizing.certificate})", hang=2)
    for active in sizing.active:
        yield Line(f"active: {active}", hang=2)
    yield from (Line(remark, hang=2) for remark in sizing.remarks)
    if sizing.sensitivities:
        yield _sensitivities(sizing)


def _designs(sizing: SizingResult, values: Mapping[str, Value]) -> Rows:
    names = list(sizing.designs[0].sizes)
    if len(names) > MOST_COLUMNS:  # the given ones stand among the values
        names = [n for n in names if n in values and values[n].model != "given"]
    columns = ("design", *names, "volume")
    designs = table("Designs", *columns, numbers=range(1, 2 + len(names)))
    units = {name: values[name].unit if name in values else "m" for name in names}
    for d in sizing.designs:
        sizes = (show(d.sizes[name], unit, 5) for name, unit in units.items())
        designs.add_row(d.label, *sizes, show(d.volume, "m^3"))
    return designs


def _sensitivities(sizing: SizingResult) -> Rows:
    names = list(sizing.sensitivities[0].on)
    changes = table(
        "What 1 % more of a demand changes", "constraint", "by", *names,
        numbers=range(2, 2 + len(names)),
    )  # fmt: skip
    for row in sizing.sensitivities:
        # smaller changes are rounding of the optimum
        cells = (f"{round(row.on[name], 6):+z.3g} %" for name in names)
        changes.add_row(row.constraint, row.driver, *cells)
    return changes
