"""Plots over frequency: random vibration, transfer of the base's motion, response with stops."""

from collections.abc import Iterator

import numpy as np

from flexcli.report.plots.chart import Axis, Chart
from flexcli.report.plots.plot import Plot
from flexcli.results.balance import BalanceResult
from flexcli.results.dossier import Spectrum
from flexcli.results.stops import StopsResult, StopSweep
from flexcli.units import STANDARD_GRAVITY

__all__ = ["phase_plot", "spectrum_plot", "stops_plots", "transfer_plot"]

FREQUENCY = Axis("frequency, Hz", log=True)

DASHED, DOTTED = "6 3", "1.5 2.5"


def spectrum_plot(spectrum: Spectrum) -> Plot:
    """Return a density with Miles' response and the exact one over the natural frequency."""
    g = STANDARD_GRAVITY
    chart = Chart(FREQUENCY, Axis("density, g²/Hz; response, g rms", log=True))
    chart.curve(spectrum.natural, np.array(spectrum.exact) / g, f"exact response, Q {spectrum.q:g}")
    chart.curve(spectrum.natural, np.array(spectrum.miles) / g, "Miles", DASHED)
    chart.curve(spectrum.frequency, np.array(spectrum.level) / g**2, "density", DOTTED, "ink3")
    for mode in spectrum.modes:
        chart.rule(x=mode, colour="motion")
    return Plot(
        "spectrum", f"Vibration, {spectrum.case}",
        f"{spectrum.profile}: density over frequency; response over natural frequency. Upright "
        "lines are the design's own frequencies.", chart.svg(),
    )  # fmt: skip


KINDS = (("before", "init", DASHED), ("after balancing", "final", ""))


def _transfers(found: BalanceResult) -> tuple[list[float], dict[str, list[complex]], bool]:
    """Return frequencies, motions per acceleration before and after, and if they have a phase."""
    rows = [row for row in found.transfer if row.frequency > 0.0]
    is_damped = any(row.final_damped is not None for row in rows)
    values = {}
    for _, key, _ in KINDS:
        told = [getattr(row, f"{key}_damped" if is_damped else key) for row in rows]
        values[key] = [complex("nan") if value is None else complex(value) for value in told]
    return [row.frequency for row in rows], values, is_damped


def transfer_plot(found: BalanceResult) -> Plot:
    """Return the motion per acceleration of the base over frequency, before and after balancing."""
    f, values, _ = _transfers(found)
    chart = Chart(FREQUENCY, Axis(f"motion per acceleration, {found.output_unit}/(m/s²)", log=True))
    for label, key, dash in KINDS:
        size = np.abs(values[key])
        if np.nanmax(size, initial=0.0) > 0.0:
            chart.curve(f, size, label, dash)
    return Plot(
        "transfer", "Motion of the base, passed on",
        "Magnitude of the motion for an acceleration of the base.", chart.svg(),
    )  # fmt: skip


def phase_plot(found: BalanceResult) -> Iterator[Plot]:
    """Yield the phase of the motion behind the acceleration of the base, where it is damped."""
    f, values, is_damped = _transfers(found)
    if not is_damped:
        return
    chart = Chart(FREQUENCY, Axis("phase, °", least=-180.0, most=180.0))
    for label, key, dash in KINDS:
        told = np.array(values[key])
        if np.nanmax(np.abs(told), initial=0.0) > 0.0:
            turn = np.degrees(np.angle(told))
            jumps = np.abs(np.diff(turn, prepend=turn[:1])) > 180.0  # once round is no step
            chart.curve(f, np.where(jumps, np.nan, turn), label, dash)
    yield Plot(
        "phase", "Phase of the motion passed on",
        "By how much the motion runs ahead of the acceleration of the base.", chart.svg(),
    )  # fmt: skip


def stops_plots(found: StopsResult) -> Iterator[Plot]:
    """Yield the frequency responses with stops, up and down, and the operating line."""
    for sweep in found.sweeps:
        chart = Chart(Axis("frequency, Hz"), Axis("largest travel of the tip, mm", least=0.0))
        if sweep.metastable is not None:
            chart.band(*sweep.metastable)
        for is_up, dash, label in ((True, "", "up"), (False, DASHED, "down")):
            steps = [step for step in sweep.steps if step.up is is_up]
            f, x = (np.array([getattr(s, n) for s in steps]) for n in ("frequency", "travel"))
            chart.curve(f, x * 1e3, label, dash)
            rough = np.array([not s.settled for s in steps], dtype=bool)
            chart.marks(f[rough], x[rough] * 1e3, "fail", filled=False)
        yield Plot(
            "stops", f"Response with stops, {sweep.case}",
            "Solid going up, dashed going down; shaded where the blade touches or not, by where it "
            "came from; rings did not settle.", chart.svg(),
        )  # fmt: skip
        if sweep.ratios:
            yield _line(sweep)


def _line(sweep: StopSweep) -> Plot:
    """Return the range of the tip over the gap along the operating line."""
    pi_1 = [ratio.pi_1 for ratio in sweep.ratios]
    touching = [ratio for ratio in sweep.ratios if ratio.simulated is not None]
    chart = Chart(
        Axis("stiffness at the stop over that of the free tip, π1", log=True),
        Axis("range over gap, π5", log=True),
    )
    line, threshold = ([getattr(r, n) for r in sweep.ratios] for n in ("line", "threshold"))
    simulated = [r.pi_1 for r in touching], [r.simulated for r in touching]
    chart.curve(*simulated, "simulated")
    chart.curve(pi_1, line, "measured (Monti 2014)", DASHED)
    chart.curve(pi_1, threshold, "threshold, tip load", DOTTED, "ink3")
    chart.marks(*simulated)
    return Plot(
        "line", f"Operating line, {sweep.case}",
        "Whole range of the tip over the gap against how much a stop stiffens the blade: the "
        "measured line, what a tip-loaded blade needs to touch, and this blade once steady at its "
        "own frequency between rigid stops on the line.", chart.svg(),
    )  # fmt: skip
