"""``flexure explain``: what a spec may say, and the formulas behind it with their source."""

from time import perf_counter
from typing import Annotated

import typer

from flexcli.cli.common import fail
from flexcli.cli.output import CatalogueFormatOption, Format, write_json, write_text

__all__ = ["NAME", "run"]

NAME = "explain"


def run(
    name: Annotated[
        str | None,
        typer.Argument(help="Name a joint, a key of the spec, or a formula; left out, a list."),
    ] = None,
    table: Annotated[
        str | None, typer.Option("--table", help="Print a chart as data, e.g. delta.")
    ] = None,
    style: CatalogueFormatOption = Format.TEXT,
) -> None:
    """Explain a joint, a key of the spec, or a formula.

    Keys come with units, default and YAML to copy; formulas with symbols, validity and source.
    """
    from flexcli.engine.explain import explain, topics
    from flexcli.errors import SpecError
    from flexcli.report import explanation
    from flexcli.report.as_json import listing
    from flexcli.spec.manual import entries, names

    started = perf_counter()
    try:
        if name is None:
            found = topics()
        else:
            fields = entries(name)
            found = (explain(name, table, fields, names()),)
    except SpecError as error:
        fail(NAME, name or "", error, style)
    if style is Format.JSON:
        write_json(listing(NAME, perf_counter() - started, topics=list(found)))
    elif name is None:
        write_text(explanation.list_of(found))
    else:
        write_text(explanation.sheet(found[0]))
