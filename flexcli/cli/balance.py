"""``flexure balance``: what the motion of the base does, before and after balancing."""

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
from flexcli.results import Result

__all__ = ["NAME", "run"]

NAME = "balance"


def run(
    spec: SpecArgument = None,
    style: FormatOption = Format.TEXT,
    csv: Annotated[
        Path | None, typer.Option("--csv", help="Save the table of the transfer functions.")
    ] = None,
) -> None:
    """Balance a mechanism against its base's motion: arms, masses, coupling, T(ω), residuals."""
    path = spec_path(spec)
    result = attempt(NAME, path, lambda: _balance(path, csv))
    finish(NAME, [result], style, many=False)


def _balance(path: Path, csv: Path | None) -> Result:
    from flexcli.engine.balance import balance
    from flexcli.report.balance_csv import transfer_csv
    from flexcli.spec.load import load_design

    design, _ = load_design(path)
    result = balance(design, str(path))
    if csv is not None and result.balance is not None:
        write_file(csv, transfer_csv(result.balance.transfer))
    return result
