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
    from flexcli.report.plots import Plot

__all__ = ["NAME", "run"]

NAME = "plot"

ASKED = {
    "accuracy": "Error against time of every model; takes a while.",
    "transfer": "Motion of the base that a mechanism passes on, before and after balancing.",
    "stops": "Response with end stops, up and down; takes a while.",
    "line": "Range of the tip over the gap by the stop's height, measured and simulated.",
}
"""Plots that need a verb of their own, made when they are asked for."""


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

    There are margins, stress, stiffness, shift, support, spectrum and feasible sizes.
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
    from flexcli.report.plots import standalone

    write_picture(standalone(chosen[0]), output, force=force)


def _plots(path: Path, stated: list[str] | None, what: str | None) -> "list[Plot]":
    """Return the plots of a design; what needs a verb of its own, if it is asked for."""
    from flexcli import api
    from flexcli.report.plots import (
        accuracy_plot,
        margins_plot,
        plots,
        stops_plots,
        tornado_plot,
        transfer_plot,
    )

    spec = read(path, stated)
    if what == "accuracy":
        compared = api.accuracy(spec).accuracy
        return [] if compared is None else [accuracy_plot(compared)]
    if what == "transfer":
        balanced = api.balance(spec).balance
        return [] if balanced is None or not balanced.transfer else [transfer_plot(balanced)]
    if what in ("stops", "line"):
        stopped = api.stops(spec, simulate=False, sweep=True).stops
        return [] if stopped is None else list(stops_plots(stopped))
    gathered = api.dossier(spec)
    result = gathered.result
    found = [margins_plot(result.checks)] if result.checks else []
    if result.sizing is not None and result.sizing.sensitivities:
        found.append(tornado_plot(result.sizing))
    return [*found, *plots(gathered)]
