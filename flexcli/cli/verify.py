"""``flexure verify``: a design's numbers beside those of solid finite elements."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexcli.cli.common import (
    Format,
    FormatOption,
    ModelOption,
    SetOption,
    SpecsArgument,
    finish,
    on_each,
    only_one,
)
from flexcli.cli.files import ForceOption, write_all_or_end
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "verify"


def run(
    specs: SpecsArgument = None,
    stated: SetOption = None,
    model: ModelOption = None,
    meshes: Annotated[
        int,
        typer.Option(
            "--meshes", min=2, max=4, help="Solve so many meshes, each finer than the one before."
        ),
    ] = 2,
    only: Annotated[
        list[str] | None,
        typer.Option("--only", help="Compare this number alone, e.g. k_end; may be repeated."),
    ] = None,
    solve: Annotated[
        bool, typer.Option("--run/--no-run", help="Run ccx, or only say what to compare.")
    ] = True,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Keep decks and what ccx prints in this folder."),
    ] = None,
    force: ForceOption = False,
    style: FormatOption = Format.TEXT,
) -> None:
    """Put a design's numbers beside those of solid elements.

    Blades are meshed between rigid bodies, twice, and solved by CalculiX where ccx is installed.

    Exits 1 when two numbers are apart by more than both their errors, or nothing was compared.
    """
    only_one(NAME, "--output", specs, output, style)
    files: dict[str, str] = {}

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        return api.verify(
            spec, model=model.value if model else None, meshes=meshes, only=tuple(only or ()),
            run=solve, files=files,
        )  # fmt: skip

    results = on_each(NAME, specs, stated, verb)
    if output is not None and files:
        contents = {output / name: text.encode() for name, text in files.items()}
        write_all_or_end(contents, force=force)
    finish(NAME, results, style, many=len(results) > 1)
