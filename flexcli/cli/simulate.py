"""``flexure simulate``: the joint over its stroke, by geometrically exact mechanics."""

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
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "simulate"


def run(
    specs: SpecsArgument = None,
    points: Annotated[
        int,
        typer.Option("--points", min=2, max=10_000, help="Solve so many travels over the stroke."),
    ] = 11,
    table: Annotated[
        Path | None, typer.Option("--csv", help="Save every point, with SI units.")
    ] = None,
    force: ForceOption = False,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Simulate the stroke by geometrically exact mechanics.

    It gives effort, stiffness, shift and stress at every travel, and margins.
    """
    only_one(NAME, "--csv", specs, table, style)

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        return api.simulate(spec, points=points)

    def text() -> str | None:
        from flexcli.report.sweep_text import sweep_csv

        sweeps = results[0].sweeps or results[0].space_sweeps
        return sweep_csv(sweeps) if sweeps else None

    results = on_each(NAME, specs, stated, verb)
    with saved(table, text, force=force, nothing="no stroke was simulated"):
        finish(NAME, results, style, many=len(results) > 1)
