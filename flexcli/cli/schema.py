"""``flexure schema``: the JSON Schema of the spec, for editors that complete and mark typos."""

from typing import Annotated

import typer

from flexcli.cli.common import OutputOption, write_json
from flexcli.cli.files import ForceOption, write_or_end

__all__ = ["NAME", "run"]

NAME = "schema"


def run(
    kind: Annotated[
        str, typer.Argument(help="Name the kind: design, material, stroke, asd or geometry.")
    ] = "design",
    output: OutputOption = None,
    force: ForceOption = False,
) -> None:
    """Print the JSON Schema of a kind of spec, or write it.

    An editor takes the schema that a spec's first line names, a path from the spec's own folder:
    # yaml-language-server: $schema=flexure.schema.json
    """
    from flexcli.report.as_json import dumps
    from flexcli.spec.schema import KINDS, json_schema

    if kind not in KINDS:
        raise typer.BadParameter(f"'{kind}' is not one of {', '.join(KINDS)}")
    schema = json_schema(kind)
    if output is None:
        write_json(schema)
    else:
        write_or_end(output, dumps(schema) + "\n", force=force)
