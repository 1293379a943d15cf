"""``flexure init``: a first spec to start from."""

from typing import Annotated

import typer

from flexcli.cli.common import Format, OutputOption, fail
from flexcli.cli.files import ForceOption, write_or_end
from flexcli.cli.output import write_plain

__all__ = ["NAME", "run"]

NAME = "init"


def run(
    kind: Annotated[
        str | None,
        typer.Argument(
            help="Name a joint, e.g. rcc, or a mechanism under vibration: payload, tip-mass or "
            "parallel-stage; left out, it is a leaf-spring-stage."
        ),
    ] = None,
    output: OutputOption = None,
    force: ForceOption = False,
) -> None:
    """Print a first spec with comments, or write it.

    It passes as it stands: flexure size chooses its free sizes, flexure check judges it.
    """
    from flexcli.errors import SpecError
    from flexcli.spec.starter import USUAL, starter

    try:
        text = starter(kind or USUAL)
    except SpecError as error:
        fail(NAME, "", error, Format.TEXT)
    if output is None:
        write_plain(text)
    else:
        write_or_end(output, text, force=force)
