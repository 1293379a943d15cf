"""A static sweep on screen, and as rows for a spreadsheet."""

from collections.abc import Iterator, Sequence

from rich.console import RenderableType

from flexcli.report.rows_csv import rows_csv
from flexcli.report.tables import Line, table
from flexcli.results import Result
from flexcli.results.simulation import SweepPoint, SweepResult
from flexcli.units import shown_unit

__all__ = ["section", "sweep_csv", "sweep_table"]


def _units(sweep: SweepResult) -> dict[str, str]:
    """Return the SI unit of every number of a point."""
    turns = sweep.motion == "rotation"
    return {
        "travel": "rad" if turns else "m",
        "effort": "N*m" if turns else "N",
        "stiffness": "N*m/rad" if turns else "N/m",
        "stiffness_x": "N/m",
        "stiffness_y": "N/m",
        "stiffness_phi": "N*m/rad",
        "shift_x": "m",
        "shift_y": "m",
        "bending": "Pa",
        "total": "Pa",
        "energy": "J",
        "frequency": "Hz",
    }


def section(result: Result) -> Iterator[RenderableType]:
    """Yield the sweep of every case."""
    for sweep in result.sweeps:
        yield from sweep_table(sweep)


def sweep_table(sweep: SweepResult) -> Iterator[RenderableType]:
    """Yield the sweep of one case as a table, and what is to be said of it."""
    units = _units(sweep)
    columns = {
        "travel": "travel",
        "effort": "moment" if sweep.motion == "rotation" else "force",
        "stiffness": "stiffness",
        "shift_x": "shift x",
        "shift_y": "shift y",
        "bending": "bending",
        "total": "at faces",
    }
    if sweep.missed:
        yield Line((sweep.missed, "yellow"))
    if not sweep.points:
        return
    if all(point.frequency is not None for point in sweep.points):
        columns["frequency"] = "frequency"
    scales = {
        name: shown_unit(max(abs(getattr(p, name)) for p in sweep.points), units[name])
        for name in columns
    }
    heads = [f"{title} [{scales[name][0]}]" for name, title in columns.items()]
    found = table(f"Over the stroke, {sweep.case}", *heads, numbers=range(len(heads)))
    for point in sweep.points:
        found.add_row(*(f"{getattr(point, name) / scales[name][1]:.5g}" for name in columns))
    yield found
    if sweep.deflections:
        yield _deflections(sweep, scales["travel"])
    if not all(point.stable for point in sweep.points):
        yield Line(("unstable where the drive is let go", "yellow"))


def _deflections(sweep: SweepResult, input_scale: tuple[str, float]) -> RenderableType:
    """Return the deflection of every joint of a linkage over its input."""
    name, unit = input_scale
    columns = {f"travel [{name}]": [point.travel / unit for point in sweep.points]}
    for joint, joint_unit, values in sweep.deflections:
        name, unit = shown_unit(max(map(abs, values)), joint_unit)
        columns[f"{joint} [{name}]"] = [value / unit for value in values]
    title = f"Deflection of joints, links rigid, {sweep.case}"
    found = table(title, *columns, numbers=range(len(columns)))
    for row in zip(*columns.values(), strict=True):
        found.add_row(*(f"{value:.5g}" for value in row))
    return found


def sweep_csv(sweeps: Sequence[SweepResult]) -> str:
    """Return every point of every case as CSV, SI units in the heading."""
    units, names = _units(sweeps[0]), SweepPoint._fields
    heading = ["case", *(f"{n} [{units[n]}]" if n in units else n for n in names)]
    heading += [f"{d.joint} [{d.unit}]" for d in sweeps[0].deflections]
    rows = (
        (sweep.case, *point, *(d.values[index] for d in sweep.deflections))
        for sweep in sweeps
        for index, point in enumerate(sweep.points)
    )
    return rows_csv(heading, rows)
