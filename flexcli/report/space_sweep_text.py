"""A sweep in space on screen, and as rows for a spreadsheet."""

from collections.abc import Iterator, Sequence
from math import isinf

from rich.console import RenderableType

from flexcli.report.rows_csv import rows_csv
from flexcli.report.tables import Line, table
from flexcli.results import Result
from flexcli.results.simulation import SpacePoint, SpaceSweep
from flexcli.units import shown_unit

__all__ = ["section", "space_sweep_csv"]

SHOWN = ("travel", "effort", "k_x", "k_y", "k_z", "k_theta_x", "k_theta_y", "k_theta_z", "stress")
"""What stands on screen; the table has all."""


def _units(sweep: SpaceSweep) -> dict[str, str]:
    """Return the SI unit of every number of a point."""
    turns = sweep.motion == "rotation"
    return {
        "travel": "rad" if turns else "m",
        "effort": "N*m" if turns else "N",
        "stiffness": "N*m/rad" if turns else "N/m",
        **{f"shift_{axis}": "m" for axis in "xyz"},
        **{f"turn_{axis}": "rad" for axis in "xyz"},
        **{f"k_{axis}": "N/m" for axis in "xyz"},
        **{f"k_theta_{axis}": "N*m/rad" for axis in "xyz"},
        "frequency": "Hz",
        "stress": "Pa",
    }


def section(result: Result) -> Iterator[RenderableType]:
    """Yield the sweep of every case: travel, effort, support stiffness with the drive locked."""
    for sweep in result.space_sweeps:
        if sweep.missed:
            yield Line((sweep.missed, "yellow"))
        if not sweep.points:
            continue
        units = _units(sweep)
        scales = {}
        for name in SHOWN:
            sizes = [abs(getattr(p, name)) for p in sweep.points]
            known = [size for size in sizes if not isinf(size)]
            scales[name] = shown_unit(max(known, default=1.0), units[name])
        titles = [f"{_title(name, sweep)} [{scales[name][0]}]" for name in SHOWN]
        found = table(f"Support over the stroke, drive locked, {sweep.case}", *titles,
                      numbers=range(len(titles)))  # fmt: skip
        for point in sweep.points:
            cells = [(getattr(point, name), scales[name][1]) for name in SHOWN]
            found.add_row(*("held" if isinf(v) else f"{v / unit:.4g}" for v, unit in cells))
        yield found


def _title(name: str, sweep: SpaceSweep) -> str:
    if name == "effort":
        return "moment" if sweep.motion == "rotation" else "force"
    return name.replace("theta_", "θ").replace("k_", "k ")


def space_sweep_csv(sweeps: Sequence[SpaceSweep]) -> str:
    """Return every point of every case as CSV, SI units in the heading."""
    units, names = _units(sweeps[0]), SpacePoint._fields
    heading = ("case", *(f"{n} [{units[n]}]" if n in units else n for n in names))
    return rows_csv(heading, ((sweep.case, *point) for sweep in sweeps for point in sweep.points))
