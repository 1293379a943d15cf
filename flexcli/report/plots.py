"""Plots of a dossier as SVG: ink on paper, solid for the exact model, dashed for the bound.

Matplotlib draws them; its colours become the variables of the page they stand on, so that they
follow it into the dark.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from importlib import import_module
from io import StringIO
from math import log10
from typing import Any, NamedTuple

import numpy as np

from flexcli.errors import SolveError
from flexcli.results import (
    AccuracyResult,
    BalanceResult,
    Check,
    SizingResult,
    StopsResult,
    StopSweep,
    Verdict,
)
from flexcli.results.dossier import Dossier, Region, Spectrum
from flexcli.results.drawing import Drawing
from flexcli.results.simulation import SweepResult
from flexcli.units import STANDARD_GRAVITY, shown_unit

__all__ = [
    "COLOURS",
    "Plot",
    "accuracy_plot",
    "margins_plot",
    "plots",
    "standalone",
    "stops_plots",
    "tornado_plot",
    "transfer_plot",
]

COLOURS = {
    "ink": "#16181b", "ink2": "#4a5057", "ink3": "#676e75", "hair": "#e8eaec",
    "motion": "#5a4fa3", "force": "#9a3412", "fail": "#a8320a", "pass": "#0b5a85",
}  # fmt: skip
"""Names of the page's colours by their light values, which stand for them in a plot."""

SIZE = (5.2, 3.3)
"""Width and height [in] at 100 px an inch."""

FACES = ["Helvetica Neue", "Helvetica", "Arial", "Liberation Sans", "DejaVu Sans"]

SIZED = re.compile(r' (?:width|height)="[^"]*pt"')
"""Size in points, which the page decides."""

MOST_BARS = 14
"""Bars of a tornado."""

MOST_ZEROS = 4
"""Powers of ten from this on are written with an exponent."""

RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

MOST_LETTERS = 9
"""Of a label that fits the margin that plots have beside them."""

DASHES = ("-", "--", ":", "-.", (0, (7, 2, 1, 2, 1, 2)))


class Plot(NamedTuple):
    """A plot: its key on the command line, what it shows, in a sentence, and the SVG."""

    name: str
    title: str
    caption: str
    svg: str


def plots(dossier: Dossier) -> Iterator[Plot]:
    """Yield the plots that a dossier has data for, beside the bars that its page has itself."""
    for sweep in dossier.sweeps:
        if len(sweep.points) > 1:
            yield from _stroke(sweep)
    if dossier.drawing is not None and dossier.drawing.states:
        yield _along(dossier.drawing)
    for spectrum in dossier.spectra:
        yield _spectrum(spectrum)
    if dossier.region is not None:
        yield _region(dossier.region)


def standalone(plot: Plot) -> str:
    """Return a plot as an SVG of its own, in light colours on white."""
    svg = plot.svg
    for key, colour in COLOURS.items():
        svg = svg.replace(f"var(--{key})", colour)
    width, height = (100 * side for side in SIZE)
    size = f'width="{width:g}" height="{height:g}" '
    svg = svg.replace("<svg ", f"<svg {size}", 1)
    # a style for the background is not painted by what makes a PNG of it
    return svg.replace(">", '><rect width="100%" height="100%" fill="#fff"/>', 1)


def _figure(draw: Callable[[Any], None], name: str) -> str:
    """Return the SVG of axes that a function draws on."""
    try:
        matplotlib, figure = import_module("matplotlib"), import_module("matplotlib.figure")
    except ImportError as error:
        hint = "pip install 'flexcli[report]'"
        raise SolveError("no-plots", "plots need the extra 'report'", hint) from error
    ink2, hair = COLOURS["ink2"], COLOURS["hair"]
    style = {
        "svg.fonttype": "none", "svg.hashsalt": name, "font.family": "sans-serif",
        "font.sans-serif": FACES,
        "font.size": 9.0, "axes.edgecolor": ink2, "axes.labelcolor": ink2, "text.color": ink2,
        "xtick.color": ink2, "ytick.color": ink2, "axes.spines.top": False, "axes.linewidth": 0.75,
        "axes.spines.right": False, "grid.color": hair, "grid.linewidth": 0.75, "axes.grid": True,
        "lines.linewidth": 1.5, "legend.frameon": False, "axes.axisbelow": True,
        "axes.formatter.useoffset": False, "axes.unicode_minus": True,
        "axes.formatter.limits": (-4, 5), "font.serif": [], "mathtext.fontset": "dejavusans",
    }  # fmt: skip
    with matplotlib.rc_context(style):
        sheet = figure.Figure(figsize=SIZE)
        axes = sheet.add_subplot()
        draw(axes)
        _number_plainly(axes)
        _fit(sheet, axes)
        text = StringIO()
        sheet.savefig(
            text, format="svg", transparent=True, metadata={"Date": None, "Creator": None}
        )
    svg = text.getvalue()
    svg = svg[svg.index("<svg") :]
    svg = SIZED.sub("", svg, count=2)
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    # its style would be that of all that stands on the same page
    svg = re.sub(r"<style[^>]*>.*?</style>", "", svg, flags=re.DOTALL)
    svg = svg.replace("<svg ", '<svg stroke-linejoin="round" ', 1)
    svg = _own_ids(svg, name)
    for key, colour in COLOURS.items():
        svg = svg.replace(colour, f"var(--{key})")
    return svg


def _number_plainly(axes: Any) -> None:
    """Write the numbers of logarithmic axes as text: formulas take ten times as long to set."""
    usual = import_module("matplotlib.ticker").LogFormatter

    class Between(usual):  # type: ignore[misc, valid-type]
        """Numbers between the powers of ten, where few of those are in view."""

        def __call__(self, value: float, place: int | None = None) -> str:
            return f"{value:g}" if super().__call__(value, place) else ""

    for axis in (axes.xaxis, axes.yaxis):
        if axis.get_scale() == "log":
            axis.set_major_formatter(lambda value, _: _power_of_ten(value))
            axis.set_minor_formatter(Between(minor_thresholds=(1.0, 0.4)))


def _power_of_ten(value: float) -> str:
    power = round(log10(value))
    return f"{value:g}" if abs(power) < MOST_ZEROS else "10" + str(power).translate(RAISED)


def _fit(sheet: Any, axes: Any) -> None:
    """Leave the labels their room: those of bars are long, and others are known beforehand."""
    if any(len(label.get_text()) > MOST_LETTERS for label in axes.get_yticklabels()):
        sheet.tight_layout()
    else:
        right = 0.97 if len(sheet.axes) == 1 else 0.86
        sheet.subplots_adjust(left=0.14, right=right, bottom=0.15, top=0.94)


def _own_ids(svg: str, name: str) -> str:
    """Return an SVG whose ids start with its name, so that many may stand on one page."""
    for found in set(re.findall(r'\bid="([^"]+)"', svg)):
        svg = re.sub(
            rf'(id="|href="#|url\(#){re.escape(found)}(?=["\)])', rf"\g<1>{name}-{found}", svg
        )
    return svg


def _scaled(values: Any, unit: str) -> tuple[Any, str]:
    """Return values in the unit that a person reads the largest of them in, and that unit."""
    values = np.asarray(values, dtype=np.float64)
    name, factor = shown_unit(float(np.nanmax(np.abs(values), initial=0.0)), unit)
    return values / factor, name


def _stroke(sweep: SweepResult) -> Iterator[Plot]:
    """Yield stress, stiffness and shift over the stroke of a case."""
    rotates = sweep.motion == "rotation"
    unit, stiff = ("rad", "N*m/rad") if rotates else ("m", "N/m")
    travel, travel_unit = _scaled([p.travel for p in sweep.points], unit)
    if rotates:
        travel, travel_unit = np.degrees([p.travel for p in sweep.points]), "°"

    def over(
        key: str, title: str, caption: str, rows: dict[str, list[float]], label: str, of: str
    ) -> Plot:
        def draw(axes: Any) -> None:
            each = [x for values in rows.values() for x in values]
            _, shown = _scaled(each, of)
            factor = shown_unit(float(np.max(np.abs(each), initial=0.0)), of)[1]
            for (name, values), dash in zip(rows.items(), DASHES, strict=False):
                axes.plot(
                    travel, np.asarray(values) / factor, color=COLOURS["ink"], ls=dash, label=name
                )
            axes.set_xlabel(f"travel, {travel_unit}")
            axes.set_ylabel(f"{label}, {shown}")
            if len(rows) > 1:
                axes.legend()

        name = f"{key}-{sweep.case}"
        return Plot(key, title, caption, _figure(draw, name))

    points = sweep.points
    yield over(
        "stress", f"Stress over the stroke, {sweep.case}",
        "Largest stress at the faces, and that of bending alone; exact model.",
        {"with the axial force": [p.total for p in points], "bending": [p.bending for p in points]},
        "stress", "Pa",
    )  # fmt: skip
    yield over(
        "stiffness", f"Stiffness over the stroke, {sweep.case}",
        "Tangent stiffness along the motion, all else free; exact model.",
        {"": [p.stiffness for p in points]}, "stiffness", stiff,
    )  # fmt: skip
    yield over(
        "shift", f"Shift of the centre, {sweep.case}" if rotates else f"Shift, {sweep.case}",
        "Motion of the moving body's point along x and y of the joint; exact model.",
        {"along x": [p.shift_x for p in points], "along y": [p.shift_y for p in points]},
        "shift", "m",
    )  # fmt: skip
    support = {
        "along x": [p.stiffness_x for p in points], "along y": [p.stiffness_y for p in points],
    }  # fmt: skip
    if all(np.isfinite(v) and v > 0.0 for values in support.values() for v in values):

        def draw(axes: Any) -> None:
            for (name, values), dash in zip(support.items(), DASHES, strict=False):
                axes.semilogy(travel, values, color=COLOURS["ink"], ls=dash, label=name)
            axes.set_xlabel(f"travel, {travel_unit}")
            axes.set_ylabel("stiffness, N/m")
            axes.legend()

        yield Plot(
            "support", f"Support stiffness over the stroke, {sweep.case}",
            "In the plane, at the body's point, the drive held and all else free; exact model.",
            _figure(draw, f"support-{sweep.case}"),
        )  # fmt: skip


def _along(drawing: Drawing) -> Plot:
    """Return the stress along each blade at the + end of the stroke."""
    state = drawing.states[0]

    def draw(axes: Any) -> None:
        most = max(max(each) for each in state.stress.values())
        factor = shown_unit(most, "Pa")[1]
        for (name, stress), dash in zip(state.stress.items(), DASHES * 60, strict=False):
            places = np.array(state.axes[name])
            s = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(places, axis=0).T))])
            axes.plot(
                s * 1e3, np.asarray(stress) / factor, color=COLOURS["ink"], ls=dash, label=name
            )
        if drawing.strength is not None and drawing.strength < 4.0 * most:
            axes.axhline(drawing.strength / factor, color=COLOURS["fail"], lw=1.0)
            axes.annotate(
                "strength", (0.99, drawing.strength / factor), xycoords=("axes fraction", "data"),
                ha="right", va="bottom", color=COLOURS["fail"],
            )  # fmt: skip
        axes.set_xlabel("place along the blade, mm")
        axes.set_ylabel(f"stress, {shown_unit(most, 'Pa')[0]}")
        if 1 < len(state.stress) <= len(DASHES):
            axes.legend()

    return Plot(
        "along", "Stress along the blades",
        f"Larger of both faces at the + end of {drawing.case}; exact model.",
        _figure(draw, "along"),
    )  # fmt: skip


def _spectrum(spectrum: Spectrum) -> Plot:
    """Return a density with Miles' response and the exact one over the natural frequency."""

    def draw(axes: Any) -> None:
        g = STANDARD_GRAVITY
        axes.loglog(spectrum.frequency, np.array(spectrum.level) / g**2, color=COLOURS["ink3"],
                    ls=":", label="density, g²/Hz")  # fmt: skip
        axes.loglog(spectrum.natural, np.array(spectrum.exact) / g, color=COLOURS["ink"],
                    label=f"exact response, g rms, Q {spectrum.q:g}")  # fmt: skip
        axes.loglog(spectrum.natural, np.array(spectrum.miles) / g, color=COLOURS["ink"], ls="--",
                    label="Miles, g rms")  # fmt: skip
        for mode in spectrum.modes:
            axes.axvline(mode, color=COLOURS["motion"], lw=1.0)
        axes.set_xlabel("frequency, Hz")
        axes.legend()

    return Plot(
        "spectrum", f"Vibration, {spectrum.case}",
        f"{spectrum.profile}: density over frequency; response over natural frequency. Upright "
        "lines are the design's own frequencies.",
        _figure(draw, f"spectrum-{spectrum.case}"),
    )  # fmt: skip


def _region(region: Region) -> Plot:
    """Return where every closed-form margin holds, over two sizes."""
    x, y = (np.array(v) * 1e3 for v in (region.x, region.y))
    worst = np.min([np.array(m) for m in region.margins.values()], axis=0)

    def draw(axes: Any) -> None:
        axes.contourf(x, y, worst, levels=[1.0, np.inf], colors=[COLOURS["hair"]])
        for name, rows in region.margins.items():
            margin = np.array(rows)
            if margin.min() < 1.0 < margin.max():
                lines = axes.contour(
                    x, y, margin, levels=[1.0], colors=[COLOURS["ink"]], linewidths=1.0
                )
                axes.clabel(lines, fmt={1.0: name}, fontsize=8, colors=[COLOURS["ink2"]])
        axes.plot(*(at * 1e3 for at in region.chosen), "o", color=COLOURS["motion"], ms=6)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel(f"{region.names[0]}, mm")
        axes.set_ylabel(f"{region.names[1]}, mm")

    return Plot(
        "region", "Feasible sizes",
        "Shaded where every requirement holds by the closed forms, the other sizes as chosen; each "
        "line is one requirement just met, the dot the design.",
        _figure(draw, "region"),
    )  # fmt: skip


def margins_plot(checks: Sequence[Check]) -> Plot:
    """Return the factors over the required ones as bars, each with its range."""
    rows = [c for c in reversed(checks) if np.isfinite(c.factor) and c.required > 0.0]

    def draw(axes: Any) -> None:
        for k, check in enumerate(rows):
            low, high = check.factor_range or (check.factor, check.factor)
            colour = COLOURS.get(check.verdict.value, COLOURS["ink3"])
            ends = np.clip([low / check.required, high / check.required], 0.1, 1e3)
            done = check.verdict in (Verdict.PASS, Verdict.FAIL)
            axes.plot(ends, [k, k], color=colour, lw=6.0, solid_capstyle="butt",
                      ls="-" if done else (0, (1, 0.5)))  # fmt: skip
            axes.plot(check.factor / check.required, k, "|", color=COLOURS["ink"], ms=12)
        axes.axvline(1.0, color=COLOURS["ink"], lw=1.5)
        axes.set_xscale("log")
        axes.set_yticks(range(len(rows)))
        axes.set_yticklabels([f"{c.full_name}: {c.verdict.value.upper()}" for c in rows])
        axes.set_xlabel("factor over the required one")

    return Plot(
        "margins", "Margins", "Each bar is the range by the error of the model that decided; the "
        "mark its value, the upright line what is required.", _figure(draw, "margins"),
    )  # fmt: skip


def tornado_plot(sizing: SizingResult) -> Plot:
    """Return what 1 % more of each demand changes, the largest on top."""
    rows = [
        (f"{name} by {row.driver or row.constraint}", change)
        for row in sizing.sensitivities
        for name, change in row.on.items()
    ]
    rows = sorted(rows, key=lambda row: abs(row[1]))[-MOST_BARS:]

    def draw(axes: Any) -> None:
        names, changes = zip(*rows, strict=True)
        axes.barh(names, changes, color=COLOURS["ink2"], height=0.6)
        axes.axvline(0.0, color=COLOURS["ink"], lw=1.0)
        axes.set_xlabel("change for 1 % more, %")

    return Plot(
        "tornado", "1 % more of each demand", "Change of the optimum's sizes and objective.",
        _figure(draw, "tornado"),
    )  # fmt: skip


def transfer_plot(found: BalanceResult) -> Plot:
    """Return the motion per acceleration of the base over frequency, before and after balancing."""
    rows = [row for row in found.transfer if row.frequency > 0.0]
    f = [row.frequency for row in rows]
    is_damped = any(row.final_damped is not None for row in rows)
    kinds = (("before", "init", "--"), ("after balancing", "final", "-"))

    def values(key: str) -> list[complex]:
        told = [getattr(row, f"{key}_damped" if is_damped else key) for row in rows]
        return [complex("nan") if value is None else complex(value) for value in told]

    def draw(axes: Any) -> None:
        for label, key, dash in kinds:
            size = np.abs(values(key))
            if np.nanmax(size, initial=0.0) > 0.0:
                axes.loglog(f, size, color=COLOURS["ink"], ls=dash, label=label)
        axes.set_xlabel("frequency, Hz")
        axes.set_ylabel(f"motion per acceleration, {found.output_unit}/(m/s²)")
        axes.legend()
        if is_damped:
            phases = axes.twinx()
            for _, key, dash in kinds:
                turn = np.degrees(np.angle(values(key)))
                phases.semilogx(f, turn, color=COLOURS["motion"], ls=dash, lw=1.0)
            phases.set_ylabel("phase, °", color=COLOURS["motion"])
            phases.grid(visible=False)

    return Plot(
        "transfer", "Motion of the base, passed on",
        f"Magnitude{' in ink, phase in violet' * is_damped}; dashed before balancing.",
        _figure(draw, "transfer"),
    )  # fmt: skip


def stops_plots(found: StopsResult) -> Iterator[Plot]:
    """Yield the frequency responses with stops, up and down, settled steps filled."""
    for sweep in found.sweeps:

        def draw(axes: Any, sweep: StopSweep = sweep) -> None:
            for is_up, dash, label in ((True, "-", "up"), (False, "--", "down")):
                steps = [step for step in sweep.steps if step.up is is_up]
                f, x = ([getattr(s, n) for s in steps] for n in ("frequency", "travel"))
                axes.plot(f, np.array(x) * 1e3, color=COLOURS["ink"], ls=dash, label=label)
                rough = [s for s in steps if not s.settled]
                axes.plot([s.frequency for s in rough], [s.travel * 1e3 for s in rough], "o",
                          mfc="none", color=COLOURS["fail"], ms=4)  # fmt: skip
            if sweep.metastable is not None:
                axes.axvspan(*sweep.metastable, color=COLOURS["hair"])
            axes.set_xlabel("frequency, Hz")
            axes.set_ylabel("largest travel of the tip, mm")
            axes.legend()

        yield Plot(
            "stops", f"Response with stops, {sweep.case}",
            "Solid going up, dashed going down; shaded where the blade touches or not, by where it "
            "came from; rings did not settle.",
            _figure(draw, f"stops-{sweep.case}"),
        )  # fmt: skip
        if sweep.ratios:
            yield _line(sweep)


def _line(sweep: StopSweep) -> Plot:
    """Return the range of the tip over the gap along the operating line."""
    pi_1 = [ratio.pi_1 for ratio in sweep.ratios]
    touching = [ratio for ratio in sweep.ratios if ratio.simulated is not None]

    def draw(axes: Any) -> None:
        line, threshold = ([getattr(r, n) for r in sweep.ratios] for n in ("line", "threshold"))
        axes.loglog(pi_1, line, color=COLOURS["ink"], ls="--", label="measured (Monti 2014)")
        axes.loglog(pi_1, threshold, color=COLOURS["ink3"], ls=":", label="threshold, tip load")
        axes.loglog([r.pi_1 for r in touching], [r.simulated for r in touching], "o-",
                    color=COLOURS["ink"], ms=4, label="simulated")  # fmt: skip
        axes.set_xlabel("stiffness at the stop over that of the free tip, π1")
        axes.set_ylabel("range over gap, π5")
        axes.legend()

    return Plot(
        "line", f"Operating line, {sweep.case}",
        "Whole range of the tip over the gap against how much a stop stiffens the blade: the "
        "measured line, what a tip-loaded blade needs to touch, and this blade once steady at its "
        "own frequency between rigid stops on the line.",
        _figure(draw, f"line-{sweep.case}"),
    )  # fmt: skip


def accuracy_plot(found: AccuracyResult) -> Plot:
    """Return error against time of every model on a design."""

    def draw(axes: Any) -> None:
        for model in found.models:
            if not np.isfinite(model.error):
                continue
            error = max(model.error, 1e-15)
            axes.loglog(model.seconds, error, "o", color=COLOURS["ink"],
                        mfc=COLOURS["ink"] if model.pareto else "none")  # fmt: skip
            axes.annotate(model.model, (model.seconds, error), xytext=(5, 4),
                          textcoords="offset points", fontsize=8)  # fmt: skip
        axes.axhline(found.accuracy, color=COLOURS["fail"], lw=1.0)
        axes.set_xlabel("time for all quantities, s")
        axes.set_ylabel("largest error")

    return Plot(
        "accuracy", "What accuracy costs",
        "Filled: no model is both faster and nearer. The line is the accuracy asked.",
        _figure(draw, "accuracy"),
    )  # fmt: skip
