"""``flexure check``: margins of given designs."""

from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from flexcli.cli.common import (
    DEFAULT_SPEC,
    Format,
    FormatOption,
    Model,
    ModelOption,
    attempt,
    finish,
)
from flexcli.errors import Finding, SpecError
from flexcli.results import Result

__all__ = ["NAME", "run"]

NAME = "check"


def run(
    specs: Annotated[
        list[Path] | None,
        typer.Argument(help=f"Designs or folders of them; {DEFAULT_SPEC} if left out."),
    ] = None,
    model: ModelOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Check given designs: every requirement with demand, capacity, factor and margin."""
    from flexcli.spec.folder import designs_in

    paths = designs_in(specs or [Path(DEFAULT_SPEC)])
    results = [attempt(NAME, path, partial(_check, path, model)) for path in paths]
    finish(NAME, results, style, many=len(specs or []) > 1 or len(paths) != 1)


def _check(path: Path, model: Model | None) -> Result:
    from flexcli.engine.check import check
    from flexcli.spec.given import given_sizes
    from flexcli.spec.load import load_design

    if path.is_dir():
        hint = "a design has flexure, material, geometry, cases and requirements"
        raise SpecError([Finding(str(path), "there is no design in this folder", hint)])
    design, document = load_design(path)
    return check(design, given_sizes(design, document), str(path), model.value if model else None)
