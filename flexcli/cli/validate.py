"""``flexure validate``: are these specs sound, each kind alone."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexcli.cli.common import DEFAULT_SPEC, Format, FormatOption, SetOption, finish, on_each
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "validate"


def run(
    specs: Annotated[
        list[Path] | None,
        typer.Argument(
            help=f"Name specs of any kind, or - for stdin; left out, it is {DEFAULT_SPEC}."
        ),
    ] = None,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Validate specs of any kind, each alone.

    Kinds are designs, materials, strokes, ASD profiles and geometries.
    """

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        return api.validate(spec)

    results = on_each(NAME, specs, stated, verb)
    finish(NAME, results, style, many=len(results) > 1)
