"""A static sweep on screen, and as rows for a spreadsheet."""

from collections.abc import Iterator, Sequence
from math import isinf

from flexcli.report.rows_csv import rows_csv
from flexcli.report.tables import Line, Piece, table
from flexcli.results import Result
from flexcli.results.simulation import (
    Deflection,
    SpacePoint,
    SpaceSweep,
    Sweep,
    SweepPoint,
    SweepResult,
)
from flexcli.units import shown_unit

__all__ = ["section", "sweep_csv"]

SUPPORT = ("travel", "effort", "k_x", "k_y", "k_z", "k_theta_x", "k_theta_y", "k_theta_z", "stress")
"""Columns of a stroke in space on a terminal; the CSV file has all."""


def _units(sweep: Sweep) -> dict[str, str]:
    """Return the SI unit of every number of a point."""
    turns = sweep.motion == "rotation"
    own = {
        "travel": "rad" if turns else "m",
        "effort": "N*m" if turns else "N",
        "stiffness": "N*m/rad" if turns else "N/m",
        "frequency": "Hz",
    }
    if isinstance(sweep, SpaceSweep):
        return {
            **own,
            **{f"shift_{axis}": "m" for axis in "xyz"},
            **{f"turn_{axis}": "rad" for axis in "xyz"},
            **{f"k_{axis}": "N/m" for axis in "xyz"},
            **{f"k_theta_{axis}": "N*m/rad" for axis in "xyz"},
            "stress": "Pa",
        }
    return {
        **own,
        "stiffness_x": "N/m",
        "stiffness_y": "N/m",
        "stiffness_phi": "N*m/rad",
        "shift_x": "m",
        "shift_y": "m",
        "bending": "Pa",
        "total": "Pa",
        "energy": "J",
    }


def section(result: Result) -> Iterator[Piece]:
    """Yield the sweep of every case."""
    sweeps: tuple[Sweep, ...] = (*result.sweeps, *result.space_sweeps)
    for sweep in sweeps:
        if sweep.missed:
            yield Line((sweep.missed, "yellow"))
        if sweep.points:
            yield from _in_plane(sweep) if isinstance(sweep, SweepResult) else _in_space(sweep)


def _in_plane(sweep: SweepResult) -> Iterator[Piece]:
    """Yield motion and stress over a stroke, and notes."""
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


def _in_space(sweep: SpaceSweep) -> Iterator[Piece]:
    """Yield effort and support stiffness over a stroke, the drive locked."""
    units, scales = _units(sweep), {}
    for name in SUPPORT:
        sizes = [abs(getattr(p, name)) for p in sweep.points]
        known = [size for size in sizes if not isinf(size)]
        scales[name] = shown_unit(max(known, default=1.0), units[name])
    titles = [f"{_title(name, sweep)} [{scales[name][0]}]" for name in SUPPORT]
    found = table(f"Support over the stroke, drive locked, {sweep.case}", *titles,
                  numbers=range(len(titles)))  # fmt: skip
    for point in sweep.points:
        cells = [(getattr(point, name), scales[name][1]) for name in SUPPORT]
        found.add_row(*("held" if isinf(v) else f"{v / unit:.4g}" for v, unit in cells))
    yield found


def _title(name: str, sweep: SpaceSweep) -> str:
    if name == "effort":
        return "moment" if sweep.motion == "rotation" else "force"
    return name.replace("theta_", "θ").replace("k_", "k ")


def _deflections(sweep: SweepResult, input_scale: tuple[str, float]) -> Piece:
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


def sweep_csv(sweeps: Sequence[Sweep]) -> str:
    """Return every point of every case as CSV, SI units in the heading."""
    units = _units(sweeps[0])
    names = (SpacePoint if isinstance(sweeps[0], SpaceSweep) else SweepPoint)._fields
    heading = ["case", *(f"{n} [{units[n]}]" if n in units else n for n in names)]
    heading += [f"{d.joint} [{d.unit}]" for d in _of_joints(sweeps[0])]
    rows = (
        (sweep.case, *point, *(d.values[index] for d in _of_joints(sweep)))
        for sweep in sweeps
        for index, point in enumerate(sweep.points)
    )
    return rows_csv(heading, rows)


def _of_joints(sweep: Sweep) -> Sequence[Deflection]:
    return sweep.deflections if isinstance(sweep, SweepResult) else ()
