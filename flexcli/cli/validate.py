"""``flexure validate``: are these specs sound, each kind alone."""

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexcli.cli.common import DEFAULT_SPEC, Format, FormatOption, attempt, finish
from flexcli.results import Result, Status

if TYPE_CHECKING:
    from collections.abc import Sequence

__all__ = ["NAME", "run"]

NAME = "validate"


def run(
    specs: Annotated[
        list[Path] | None,
        typer.Argument(help=f"Specs of any kind; {DEFAULT_SPEC} if left out."),
    ] = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Validate designs, materials, strokes, ASD profiles and geometries, each alone."""
    paths: Sequence[Path] = specs or [Path(DEFAULT_SPEC)]
    results = [attempt(NAME, path, partial(_validate, path)) for path in paths]
    finish(NAME, results, style, many=len(paths) > 1)


def _validate(path: Path) -> Result:
    from flexcli.spec.load import load

    loaded = load(path)
    name = getattr(loaded.part, "title", "") or getattr(loaded.part, "name", "")
    return Result(NAME, str(path), Status.PASS, title=f"{loaded.kind} {name}".rstrip())
