"""``flexure schema``: the JSON Schema of the spec, for editors that complete and mark typos."""

from typing import Annotated

import typer

from flexcli.cli.common import write_json

__all__ = ["NAME", "run"]

NAME = "schema"


def run(
    kind: Annotated[
        str, typer.Argument(help="design, material, stroke, asd or geometry.")
    ] = "design",
) -> None:
    """Print the JSON Schema of a kind of spec."""
    from flexcli.spec.schema import KINDS, json_schema

    if kind not in KINDS:
        raise typer.BadParameter(f"'{kind}' is not one of {', '.join(KINDS)}")
    write_json(json_schema(kind))
