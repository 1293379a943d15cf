"""``flexure export``: the joint at rest as a file for drawing and cutting."""

import sys
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexcli.cli.common import Format, SetOption, SpecsArgument, fail, finish, on_each
from flexcli.cli.files import ForceOption, write_or_end
from flexcli.errors import Finding, SpecError
from flexcli.results import Result, Status

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "export"


class Target(str, Enum):  # noqa: UP042 - typer reads the values of a str enum
    """What is written."""

    STEP = "step"
    DXF = "dxf"
    STL = "stl"


def run(
    to: Annotated[
        Target,
        typer.Option("--to", help="Write STEP solids, DXF outlines or STL triangles, in mm."),
    ],
    specs: SpecsArgument = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Write this file; left out, it is the spec's name."),
    ] = None,
    plain: Annotated[
        bool,
        typer.Option("--plain", help="Write blades and blocks where a wire would cut a plate."),
    ] = False,
    force: ForceOption = False,
    stated: SetOption = None,
) -> None:
    """Write a design for CAD: blades at rest, bodies as blocks.

    Blades are exact, with their notches and fillets. With manufacturing: {process: wire-edm,
    wire: 0.25 mm} it is one plate with the slots that free blades and bodies.
    """
    if len(specs or ()) > 1:
        fail(NAME, "", SpecError([Finding(NAME, "writes one spec", "name one")]), Format.TEXT)
    made: list[bytes] = []
    told: list[str] = []

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        content, notes = api.exported(spec, to.value, plain=plain)
        made.append(content)
        told.extend(notes)
        return Result(NAME, "", Status.PASS)

    results = on_each(NAME, specs, stated, verb)
    if not made:
        finish(NAME, results, Format.TEXT, many=False)
    for note in told:
        sys.stderr.write(f"flexure: {note}\n")
    path = output or Path(f"{Path((specs or [Path('flexure')])[0]).stem}.{to.value}")
    write_or_end(path, made[0], force=force)
    typer.echo(f"wrote {path}")
