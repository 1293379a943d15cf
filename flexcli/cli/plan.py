"""``flexure plan``: which effects a design calls for, and the cheapest model that carries them."""

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
)
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "plan"


def run(
    specs: SpecsArgument = None,
    audit: Annotated[
        bool, typer.Option("--audit", help="Solve with and without each effect, and compare.")
    ] = False,
    model: ModelOption = None,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Plan which effects and which model a design calls for.

    Effects come with estimates and reasons, models with cost and error, before anything is solved.

    With --audit it exits 1 where an effect that was left out matters after all.
    """

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        return api.plan(spec, model=model.value if model else None, audit=audit)

    results = on_each(NAME, specs, stated, verb)
    finish(NAME, results, style, many=len(results) > 1)
