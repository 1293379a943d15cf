"""``flexure explain``: the formulas of a joint, where they hold, and where they come from."""

from typing import Annotated

import typer

from flexcli.cli.common import fail
from flexcli.cli.output import CatalogueFormatOption, Format, write_json, write_text

__all__ = ["NAME", "run"]

NAME = "explain"


def run(
    name: Annotated[
        str | None, typer.Argument(help="Name a joint or a formula; left out, they are listed.")
    ] = None,
    table: Annotated[
        str | None, typer.Option("--table", help="Print a chart as data, e.g. delta.")
    ] = None,
    style: CatalogueFormatOption = Format.TEXT,
) -> None:
    """Explain a joint or a formula.

    Each formula has symbols, units, validity, source and a worked case.
    """
    from flexcli.engine.explain import explain, topics
    from flexcli.errors import SpecError
    from flexcli.report import explanation

    try:
        found = topics() if name is None else (explain(name, table),)
    except SpecError as error:
        fail(NAME, name or "", error, style)
    if style is Format.JSON:
        write_json(explanation.document(NAME, found))
    elif name is None:
        write_text(lambda console: explanation.print_list(found, console))
    else:
        write_text(lambda console: explanation.print_one(found[0], console))
