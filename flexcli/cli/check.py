"""``flexure check``: margins of given designs."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexcli.cli.common import (
    DEFAULT_SPEC,
    Format,
    FormatOption,
    ModelOption,
    SetOption,
    finish,
    on_each,
)
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "check"


def run(
    specs: Annotated[
        list[Path] | None,
        typer.Argument(
            help=f"Designs, folders of them, or - for stdin; {DEFAULT_SPEC} if left out."
        ),
    ] = None,
    model: ModelOption = None,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Check designs: every requirement with demand, capacity, factor and margin."""
    from flexcli.spec.folder import designs_in

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        return api.check(spec, model=model.value if model else None)

    paths = designs_in(specs or [Path(DEFAULT_SPEC)])
    results = on_each(NAME, paths, stated, verb)
    finish(NAME, results, style, many=len(specs or []) > 1 or len(paths) != 1)
