"""``flexure stops``: size an end stop on a blade, and verify it in time."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexcli.cli.common import (
    Format,
    FormatOption,
    SetOption,
    SpecsArgument,
    finish,
    on_each,
    only_one,
)
from flexcli.cli.files import ForceOption, saved
from flexcli.errors import Finding, SpecError
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "stops"


def run(
    specs: SpecsArgument = None,
    stated: SetOption = None,
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
        bool, typer.Option("--sweep", help="Follow the frequency response with stops, up and down.")
    ] = False,
    seed: Annotated[
        int | None,
        typer.Option(
            "--seed",
            min=0,
            help="Seed random vibration; left out, it is the seed of the spec, else 0.",
        ),
    ] = None,
    csv: Annotated[
        Path | None, typer.Option("--csv", help="Save the history, or with --sweep the response.")
    ] = None,
    force: ForceOption = False,
) -> None:
    """Size an end stop on a blade, and verify it in time.

    It gives gap, height, stresses and contact; Ctrl-C keeps what was simulated.

    The operating line scatters and knows no way from rest: what it leaves undecided is decided by
    simulation, with a rigid contact where that suffices. One that was interrupted is no proof: it
    exits 1.
    """
    only_one(NAME, "--csv", specs, csv, style)

    def verb(spec: "Loaded") -> Result:
        from flexcli import api
        from flexcli.cli.progress import watched

        if csv is not None and not (simulate or sweep):
            raise SpecError(
                [Finding("--csv", "there is no table to save", "add --simulate or --sweep")]
            )
        kept = csv is not None and not sweep
        return api.stops(
            spec, simulate=simulate, sweep=sweep, seed=seed, keep_history=kept, watched=watched
        )

    def text() -> str | None:
        from flexcli.report.stops_csv import history_csv, sweep_csv

        found = results[0].stops
        if found is None:
            return None
        return sweep_csv(found) if sweep else history_csv(found)

    results = on_each(NAME, specs, stated, verb)
    with saved(csv, text, force=force, nothing="nothing was simulated"):
        finish(NAME, results, style, many=len(results) > 1)
