"""``flexure plan``: which effects a design calls for, and the cheapest model that carries them."""

from pathlib import Path
from typing import Annotated

import typer

from flexcli.cli.common import (
    Format,
    FormatOption,
    Model,
    ModelOption,
    SpecArgument,
    attempt,
    finish,
    spec_path,
)
from flexcli.results import Result

__all__ = ["NAME", "run"]

NAME = "plan"


def run(
    spec: SpecArgument = None,
    audit: Annotated[
        bool, typer.Option("--audit", help="Solve with and without each effect, and compare.")
    ] = False,
    model: ModelOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Plan before solving: effects with estimates and reasons, models with cost and error.

    With --audit it exits 1 where an effect that was left out matters after all.
    """
    path = spec_path(spec)
    result = attempt(NAME, path, lambda: _plan(path, model, audit=audit))
    finish(NAME, [result], style, many=False)


def _plan(path: Path, model: Model | None, *, audit: bool) -> Result:
    from flexcli.engine.planning.planned import planned
    from flexcli.spec.load import load_design

    design, document = load_design(path)
    if design.geometry.free:
        return planned(design, None, str(path), model.value if model else None, audit=audit)
    from flexcli.spec.given import given_sizes

    sizes = given_sizes(design, document)
    return planned(design, sizes, str(path), model.value if model else None, audit=audit)
