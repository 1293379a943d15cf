"""``flexure accuracy``: what accuracy costs in time, on one's own design."""

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
from flexcli.cli.files import ForceOption, write_all_or_end
from flexcli.errors import Finding, SpecError
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "accuracy"


def run(
    specs: SpecsArgument = None,
    asked: Annotated[
        str | None,
        typer.Option(
            "--accuracy",
            help="State the error that will do, e.g. 0.1 %; left out, the spec's, else 1 %.",
        ),
    ] = None,
    runs: Annotated[
        int, typer.Option("--runs", min=5, max=1000, help="Time so many runs of each model.")
    ] = 5,
    solid: Annotated[
        bool,
        typer.Option("--solid", help="Let solid elements by CalculiX be the finest; minutes."),
    ] = False,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Keep the solids' decks in this folder."),
    ] = None,
    force: ForceOption = False,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Compare the models on a design: errors against time.

    Each quantity has its value by every model, the error against the finest, and the time.

    Exits 1 when no model is within the accuracy asked.
    """
    only_one(NAME, "--output", specs, output, style)
    files: dict[str, str] = {}

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        return api.accuracy(spec, asked=_share(asked), runs=runs, solid=solid, files=files)

    results = on_each(NAME, specs, stated, verb)
    if output is not None and files:
        contents = {output / name: text.encode() for name, text in files.items()}
        write_all_or_end(contents, force=force)
    finish(NAME, results, style, many=len(results) > 1)


def _share(asked: str | None) -> float | None:
    from flexcli.units import QuantityError, parse_quantity

    if asked is None:
        return None
    try:
        error = parse_quantity(asked, "ratio")
    except QuantityError as wrong:
        raise SpecError([Finding("--accuracy", str(wrong), wrong.hint)]) from wrong
    if not 0.0 < error < 1.0:
        raise SpecError([Finding("--accuracy", f"{asked} is no share of a number", "write 1 %")])
    return error
