"""``flexure stops``: size an end stop on a blade, and verify it in time."""

from pathlib import Path
from typing import Annotated

import typer

from flexcli.cli.common import (
    Format,
    FormatOption,
    SpecArgument,
    attempt,
    finish,
    spec_path,
    write_file,
)
from flexcli.errors import Finding, SpecError
from flexcli.results import Result

__all__ = ["NAME", "run"]

NAME = "stops"


def run(
    spec: SpecArgument = None,
    style: FormatOption = Format.TEXT,
    simulate: Annotated[
        bool | None,
        typer.Option(
            "--simulate/--no-simulate",
            help="Run every case in time to its end; or none, however little the line decides. "
            "Left out, what the operating line leaves undecided is run.",
        ),
    ] = None,
    sweep: Annotated[
        bool, typer.Option("--sweep", help="Frequency response with stops, up and down.")
    ] = False,
    seed: Annotated[
        int | None, typer.Option("--seed", min=0, help="Of random vibration; the spec's, else 0.")
    ] = None,
    csv: Annotated[
        Path | None, typer.Option("--csv", help="Save the history, or with --sweep the response.")
    ] = None,
) -> None:
    """Size an end stop: gap, height, stresses, contact; Ctrl-C keeps what was simulated.

    The operating line scatters and knows no way from rest: what it leaves undecided is decided by
    simulation, with a rigid contact where that suffices. One that was interrupted is no proof: it
    exits 1.
    """
    path = spec_path(spec)
    result = attempt(NAME, path, lambda: _stops(path, simulate, sweep, seed, csv))
    finish(NAME, [result], style, many=False)


def _stops(
    path: Path, simulate: bool | None, sweep: bool, seed: int | None, csv: Path | None
) -> Result:
    from flexcli.cli.progress import watched
    from flexcli.engine.stopping.by_plan import with_plan
    from flexcli.engine.stopping.simulation import decided, simulated
    from flexcli.engine.stopping.sweep import swept
    from flexcli.engine.stops import stops
    from flexcli.report.stops_csv import history_csv, sweep_csv
    from flexcli.spec.given import given_sizes
    from flexcli.spec.load import load_design

    if csv is not None and not (simulate or sweep):
        raise SpecError(
            [Finding("--csv", "there is no table to save", "add --simulate or --sweep")]
        )
    design, document = load_design(path)
    sizes = given_sizes(design, document)
    result = with_plan(stops(design, sizes, str(path)), design, sizes)
    with watched() as watch:
        if simulate:
            kept = csv is not None and not sweep
            result = simulated(result, design, sizes, watch, seed=seed, keep_history=kept)
        elif simulate is None:
            result = decided(result, design, sizes, watch, seed=seed)
        if sweep:
            result = swept(result, design, sizes, watch)
    if csv is not None and result.stops is not None:
        write_file(csv, sweep_csv(result.stops) if sweep else history_csv(result.stops))
    return result
