"""A static sweep on screen, and as rows for a spreadsheet."""

from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.text import Text

from flexcli.report.rows_csv import rows_csv
from flexcli.report.tables import table as new_table
from flexcli.results import SweepPoint, SweepResult
from flexcli.units import shown_unit

__all__ = ["sweep_csv", "sweep_table"]


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


def sweep_table(sweep: SweepResult) -> RenderableType:
    """Return the sweep of one case as a table."""
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
    if not sweep.points:
        return Text(sweep.missed, "yellow")
    if all(point.frequency is not None for point in sweep.points):
        columns["frequency"] = "frequency"
    scales = {
        name: shown_unit(max(abs(getattr(p, name)) for p in sweep.points), units[name])
        for name in columns
    }
    heads = [f"{title}\n[{scales[name][0]}]" for name, title in columns.items()]
    found = new_table(f"Over the stroke, {sweep.case}", *heads, numbers=range(len(heads)))
    for point in sweep.points:
        found.add_row(*(f"{getattr(point, name) / scales[name][1]:.5g}" for name in columns))
    notes = [Text(sweep.missed, "yellow")] if sweep.missed else []
    if not all(point.stable for point in sweep.points):
        notes.append(Text("unstable where the drive is let go", "yellow"))
    return Group(found, *notes)


def sweep_csv(sweeps: Sequence[SweepResult]) -> str:
    """Return every point of every case as CSV, SI units in the heading."""
    units, names = _units(sweeps[0]), SweepPoint._fields
    heading = ("case", *(f"{n} [{units[n]}]" if n in units else n for n in names))
    return rows_csv(heading, ((sweep.case, *point) for sweep in sweeps for point in sweep.points))
