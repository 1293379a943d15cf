"""A static sweep on screen, and as rows for a spreadsheet."""

import csv
from collections.abc import Sequence
from io import StringIO

from rich.console import Group, RenderableType
from rich.text import Text

from flexcli.report.tables import table as new_table
from flexcli.results import SweepPoint, SweepResult
from flexcli.units import show

__all__ = ["sweep_csv", "sweep_table"]


def _units(sweep: SweepResult) -> dict[str, str]:
    """Return the SI unit of every number of a point."""
    turns = sweep.motion == "rotation"
    return {
        "travel": "rad" if turns else "m",
        "effort": "N*m" if turns else "N",
        "stiffness": "N*m/rad" if turns else "N/m",
        "shift_x": "m",
        "shift_y": "m",
        "bending": "Pa",
        "total": "Pa",
        "energy": "J",
    }


def sweep_table(sweep: SweepResult) -> RenderableType:
    """Return the sweep of one case as a table."""
    units = _units(sweep)
    columns = ("travel", "effort", "stiffness", "shift_x", "shift_y", "bending", "total")
    found = new_table(
        f"Over the stroke, {sweep.case}",
        "travel", "moment" if sweep.motion == "rotation" else "force", "stiffness", "shift x",
        "shift y", "bending", "at faces", numbers=range(7),
    )  # fmt: skip
    for point in sweep.points:
        cells = [show(getattr(point, name), units[name]) for name in columns]
        found.add_row(*cells)
    notes = [Text(sweep.missed, "yellow")] if sweep.missed else []
    if not all(point.stable for point in sweep.points):
        notes.append(Text("unstable where the drive is let go", "yellow"))
    return Group(found, *notes)


def sweep_csv(sweeps: Sequence[SweepResult]) -> str:
    """Return every point of every case as CSV, SI units in the heading."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    units = _units(sweeps[0])
    names = SweepPoint._fields
    writer.writerow(["case", *(f"{n} [{units[n]}]" if n in units else n for n in names)])
    for sweep in sweeps:
        writer.writerows([sweep.case, *point] for point in sweep.points)
    return text.getvalue()
