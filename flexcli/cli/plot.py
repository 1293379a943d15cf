"""``flexure plot``: one plot of a design as SVG or PNG."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexcli.cli.common import (
    DEFAULT_SPEC,
    Format,
    SetOption,
    attempt,
    fail,
    finish,
    read,
)
from flexcli.cli.files import ForceOption, write_picture
from flexcli.errors import Finding, SpecError
from flexcli.results import Result, Status

if TYPE_CHECKING:
    from flexcli.api import Loaded
    from flexcli.report.plots.plot import Plot
    from flexcli.results.simulation import Sweep

__all__ = ["NAME", "run"]

NAME = "plot"

ASKED = {
    "accuracy": "Error against time of every model; takes a while.",
    "transfer": "Motion of the base that a mechanism passes on, before and after balancing.",
    "phase": "Phase of that motion, of a damped mechanism.",
    "stops": "Response with end stops, up and down; takes a while.",
    "line": "Range of the tip over the gap by the stop's height, measured and simulated.",
    "yields": "Share of the parts within the tolerances that pass; takes a while.",
    "parts": "Histogram of the margin of such parts.",
    "causes": "What the margin of such parts depends on, by Sobol's indices.",
    "narrowing": "Which tolerance to narrow first.",
}
"""Plots that need a verb of their own, made when they are asked for."""

AROUND, FINE = 50.0, 1001
"""Factor about its own frequency that a transfer is plotted over, and places there."""


def run(
    spec: Annotated[Path, typer.Argument(help="Design file, or - for stdin.")] = Path(DEFAULT_SPEC),
    what: Annotated[
        str | None, typer.Argument(help="Name of the plot; the names are listed if left out.")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="SVG or PNG file; SVG to stdout if left out."),
    ] = None,
    force: ForceOption = False,
    stated: SetOption = None,
) -> None:
    """Plot what was found of a design.

    There are margins, stress, stiffness, shift, support, spectrum, feasible sizes, sensitivities,
    the Pareto front, and those of other verbs: accuracy, transfer, stops, tolerances.
    """
    found: list[Plot] = []

    def verb() -> Result:
        found.extend(_plots(spec, stated, what))
        return Result(NAME, str(spec), Status.PASS)

    result = attempt(NAME, spec, verb)
    if result.findings:
        finish(NAME, [result], Format.TEXT, many=False)
    if what is None:
        for plot in found:
            typer.echo(f"{plot.name:12} {plot.title}: {plot.caption}")
        for name, text in ASKED.items():
            typer.echo(f"{name:12} {text}")
        return
    chosen = [plot for plot in found if plot.name == what]
    if not chosen:
        names = ", ".join(dict.fromkeys([*(plot.name for plot in found), *ASKED]))
        finding = Finding(str(spec), f"there is no plot '{what}' of this design", f"one of {names}")
        fail(NAME, str(spec), SpecError([finding]), Format.TEXT)
    from flexcli.report.plots.chart import standalone

    write_picture(standalone(chosen[0].svg), output, force=force)


def _plots(path: Path, stated: list[str] | None, what: str | None) -> "list[Plot]":
    """Return the plots of a design; what needs a verb of its own, if it is asked for."""
    from flexcli import api

    spec = read(path, stated)
    if what in ASKED:
        return _of_another_verb(spec, what)
    if what == "support":
        return _support(spec)
    from flexcli.report.plots.of_dossier import plots
    from flexcli.report.plots.sizes import tornado_plot
    from flexcli.report.plots.verdicts import margins_plot

    gathered = api.dossier(spec)
    result = gathered.result
    found = [margins_plot(result.checks)] if result.checks else []
    if result.sizing is not None and result.sizing.sensitivities:
        found.append(tornado_plot(result.sizing))
    return [*found, *plots(gathered)]


def _support(spec: "Loaded") -> "list[Plot]":
    """Return support stiffness over the stroke, in six axes where the joint has them in space."""
    from flexcli import api
    from flexcli.report.plots.stroke import stroke_plots

    swept = api.support_over_stroke(spec)
    for note in swept.notes:
        typer.echo(f"in space, {note}", err=True)
    if swept.in_plane:
        typer.echo("so the plot has three axes, the joint's own in its plane", err=True)
    followed: list[Sweep] = [*swept.in_space, *swept.in_plane]
    return [plot for s in followed if len(s.points) > 1 for plot in stroke_plots(s)]


def _of_another_verb(spec: "Loaded", what: str) -> "list[Plot]":
    """Return the plots of the verb that finds what is to be plotted; none where it finds none."""
    from flexcli import api
    from flexcli.report.plots import tolerances, verdicts, vibration

    if what == "accuracy":
        compared = api.accuracy(spec).accuracy
        return [] if compared is None else [verdicts.accuracy_plot(compared)]
    if what in ("transfer", "phase"):
        own = api.balance(spec).values.get("f_final")
        if own is None:
            return []
        sweep = {"from": f"{own.value / AROUND} Hz", "to": f"{own.value * AROUND} Hz"}
        asked = {"balance.frequencies": {**sweep, "points": FINE}}
        balanced = api.balance(spec, overrides=asked).balance
        if balanced is None or not balanced.transfer:
            return []
        return [vibration.transfer_plot(balanced), *vibration.phase_plot(balanced)]
    if what in ("stops", "line"):
        stopped = api.stops(spec, simulate=False, sweep=True).stops
        return [] if stopped is None else list(vibration.stops_plots(stopped))
    spread = api.tolerances(spec).tolerances
    return [] if spread is None else list(tolerances.tolerances_plots(spread))
