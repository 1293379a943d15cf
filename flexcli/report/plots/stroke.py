"""Plots of a joint over its stroke, and of the stress along its blades."""

from collections.abc import Iterator
from math import degrees, isfinite

import numpy as np

from flexcli.report.plots.chart import DASHES, Axis, Chart
from flexcli.report.plots.plot import Plot, curves, in_unit
from flexcli.results.drawing import Drawing
from flexcli.results.simulation import SpaceSweep, Sweep, SweepResult
from flexcli.units import shown_unit

__all__ = ["along_plot", "stroke_plots"]

MODEL = "exact beams."
IN_PLANE = "exact beams, plate widening left out."

HELD = f"the drive held and all else free; along the drive it is its own; {MODEL}"


def _travels(sweep: Sweep) -> tuple[list[float], Axis]:
    """Return the travels as a person reads them, and their axis."""
    travels = [point.travel for point in sweep.points]
    if sweep.motion == "rotation":
        return [degrees(travel) for travel in travels], Axis("travel, °")
    unit, size = in_unit(travels, "m")
    return [travel / size for travel in travels], Axis(f"travel, {unit}")


def _over(sweep: Sweep, what: str, unit: str, rows: dict[str, list[float]]) -> str:
    """Return the chart of quantities of a unit over the stroke."""
    travels, axis = _travels(sweep)
    name, size = in_unit((value for values in rows.values() for value in values), unit)
    scaled = [(key, np.asarray(values) / size) for key, values in rows.items()]
    least, most = (f(float(np.nanmin(v)) for _, v in scaled) for f in (min, max))
    y = Axis(f"{what}, {name}", least=min(least, 0.0) if what == "stress" else float("inf"))
    return curves(travels, scaled, axis, y._replace(most=most if isfinite(most) else y.most))


def stroke_plots(sweep: Sweep) -> Iterator[Plot]:
    """Yield stress, stiffness, motion and support stiffness over the stroke of a case."""
    yield from _in_plane(sweep) if isinstance(sweep, SweepResult) else _in_space(sweep)


def _in_plane(sweep: SweepResult) -> Iterator[Plot]:
    """Yield stress, stiffness, shift and support over the stroke of a case in the plane."""
    rotates, points, case = sweep.motion == "rotation", sweep.points, sweep.case
    yield Plot(
        "stress", f"Stress over the stroke, {case}",
        f"Largest stress at the faces, and that of bending alone; {IN_PLANE}",
        _over(sweep, "stress", "Pa", {
            "with the axial force": [p.total for p in points],
            "bending": [p.bending for p in points],
        }),
    )  # fmt: skip
    yield _tangent(sweep, IN_PLANE)
    yield Plot(
        "shift", f"Shift of the centre, {case}" if rotates else f"Shift, {case}",
        f"Motion of the moving body's point along x and y of the joint; {IN_PLANE}",
        _over(sweep, "shift", "m", {
            "along x": [p.shift_x for p in points], "along y": [p.shift_y for p in points],
        }),
    )  # fmt: skip
    yield from _support(
        sweep, {"x": "stiffness_x", "y": "stiffness_y"}, {"z": "stiffness_phi"},
        f"Of the body's point along the joint's own axes, motion out of its plane held; {HELD}",
    )  # fmt: skip


def _in_space(sweep: SpaceSweep) -> Iterator[Plot]:
    """Yield stress, stiffness, motion and all six support stiffnesses over a stroke in space."""
    points, case = sweep.points, sweep.case
    yield Plot(
        "stress", f"Stress over the stroke, {case}",
        f"Largest of the blades' von Mises' stresses, as beams bear it; {MODEL}",
        _over(sweep, "stress", "Pa", {"": [p.stress for p in points]}),
    )  # fmt: skip
    yield _tangent(sweep, MODEL)
    yield Plot(
        "shift", f"Shift, {case}",
        f"Motion of the moving body's point along the axes of cases; {MODEL}",
        _over(sweep, "shift", "m", {
            f"along {axis}": [getattr(p, f"shift_{axis}") for p in points] for axis in "xyz"
        }),
    )  # fmt: skip
    own = {sweep.drive: "stiffness"}
    along, about = (
        {axis: own.get(f"{kind}{axis}", f"k_{kind}{axis}") for axis in "xyz"}
        for kind in ("", "theta_")
    )
    yield from _support(
        sweep, along, about,
        f"Of the body's point along the axes of cases, other loads of the case aside; {HELD}",
    )  # fmt: skip


def _tangent(sweep: Sweep, model: str) -> Plot:
    unit = "N*m/rad" if sweep.motion == "rotation" else "N/m"
    return Plot(
        "stiffness", f"Stiffness over the stroke, {sweep.case}",
        f"Tangent stiffness along the motion, all else free; {model}",
        _over(sweep, "stiffness", unit, {"": [p.stiffness for p in sweep.points]}),
    )  # fmt: skip


def _support(
    sweep: Sweep, along: dict[str, str], about: dict[str, str], caption: str
) -> Iterator[Plot]:
    """Yield what holds the body: stiffness along axes in ink, about them in violet."""
    travels, axis = _travels(sweep)
    kinds = [(along, "along ", "N/m", "ink"), (about, "about ", "N*m/rad", "motion")]
    found, units = [], []
    for keys, way, unit, colour in kinds:
        rows = {
            f"{way}{name}": [getattr(p, key) for p in sweep.points] for name, key in keys.items()
        }
        known = {k: v for k, v in rows.items() if all(isfinite(x) and x > 0.0 for x in v)}
        if known:
            shown, size = in_unit((x for v in known.values() for x in v), unit)
            units.append(f"{shown} {way}axes")
            found += [(k, np.array(v) / size, colour, dash)
                      for (k, v), dash in zip(known.items(), DASHES, strict=False)]  # fmt: skip
    if found:
        chart = Chart(axis, Axis(f"stiffness, {', '.join(units)}", log=True))
        for name, values, colour, dash in found:
            chart.curve(travels, values, name, dash, colour)
        yield Plot(
            "support", f"Support stiffness over the stroke, {sweep.case}", caption, chart.svg(),
        )  # fmt: skip


def along_plot(drawing: Drawing) -> Plot:
    """Return the stress along each blade at the + end of the stroke."""
    state = drawing.states[0]
    most = max(max(each) for each in state.stress.values())
    unit, size = shown_unit(most, "Pa")
    strength = drawing.strength
    chart = Chart(Axis("place along the blade, mm", least=0.0), Axis(f"stress, {unit}", least=0.0))
    named = 1 < len(state.stress) <= len(DASHES)
    for (name, stress), dash in zip(state.stress.items(), DASHES * 60, strict=False):
        places = np.array(state.axes[name])
        s = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(places, axis=0).T))])
        chart.curve(s * 1e3, np.asarray(stress) / size, name if named else "", dash)
    if strength is not None and strength < 4.0 * most:
        chart.rule(y=strength / size, name="strength", colour="fail")
    return Plot(
        "along", "Stress along the blades",
        f"Larger of both faces at the + end of {drawing.case}; {IN_PLANE}", chart.svg(),
    )  # fmt: skip
