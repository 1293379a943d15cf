"""``flexure balance``: what the motion of the base does, before and after balancing."""

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

NAME = "balance"


def run(
    specs: SpecsArgument = None,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
    csv: Annotated[
        Path | None, typer.Option("--csv", help="Save the table of the transfer functions.")
    ] = None,
    force: ForceOption = False,
) -> None:
    """Balance a mechanism against its base's motion.

    It gives arms, masses, coupling, T(ω), and the terms beyond small angles.
    """
    only_one(NAME, "--csv", specs, csv, style)

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        return api.balance(spec)

    def text() -> str | None:
        from flexcli.report.balance_csv import transfer_csv

        found = results[0].balance
        return transfer_csv(found.transfer) if found is not None else None

    results = on_each(NAME, specs, stated, verb)
    with saved(csv, text, force=force, nothing="there are no transfer functions"):
        finish(NAME, results, style, many=len(results) > 1)
