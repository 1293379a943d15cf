"""``flexure accuracy``: what accuracy costs in time, on one's own design."""

from pathlib import Path
from typing import Annotated

import typer

from flexcli.cli.common import Format, FormatOption, SpecArgument, attempt, finish, spec_path
from flexcli.errors import Finding, SpecError
from flexcli.results import Result

__all__ = ["NAME", "run"]

NAME = "accuracy"


def run(
    spec: SpecArgument = None,
    asked: Annotated[
        str | None,
        typer.Option("--accuracy", help="Error that will do, e.g. 0.1 %; the spec's, else 1 %."),
    ] = None,
    runs: Annotated[
        int, typer.Option("--runs", min=5, max=1000, help="Runs of each model that are timed.")
    ] = 5,
    style: FormatOption = Format.TEXT,
) -> None:
    """Compare models on a design: value, error against the finest, and time, per quantity.

    Exits 1 when no model is within the accuracy asked.
    """
    path = spec_path(spec)
    result = attempt(NAME, path, lambda: _accuracy(path, asked, runs))
    finish(NAME, [result], style, many=False)


def _accuracy(path: Path, asked: str | None, runs: int) -> Result:
    from flexcli.engine.accuracy import accuracy
    from flexcli.spec.given import given_sizes
    from flexcli.spec.load import load_design
    from flexcli.units import QuantityError, parse_quantity

    try:
        error = None if asked is None else parse_quantity(asked, "ratio")
    except QuantityError as wrong:
        raise SpecError([Finding("--accuracy", str(wrong), wrong.hint)]) from wrong
    if error is not None and not 0.0 < error < 1.0:
        raise SpecError([Finding("--accuracy", f"{asked} is no share of a number", "write 1 %")])
    design, document = load_design(path)
    return accuracy(design, given_sizes(design, document), str(path), runs, error)
