"""``flexure size``: choose h, l, b."""

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
from flexcli.cli.files import ForceOption, saved
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "size"


def run(
    specs: SpecsArgument = None,
    model: ModelOption = None,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
    write: Annotated[
        Path | None,
        typer.Option(
            "--write", help="Save the sized design as a spec for check; comments and order stay."
        ),
    ] = None,
    force: ForceOption = False,
) -> None:
    """Choose the free sizes of a design.

    Every requirement holds at them by the models that judge; it prints margins and what holds the
    sizes there.
    """
    only_one(NAME, "--write", specs, write, style)
    designs: list[Loaded] = []

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        designs.append(spec)
        return api.size(spec, model=model.value if model else None)

    def text() -> str | None:
        from flexcli import api

        (result,) = results
        if write is None or not result.checks or not api.is_sized(designs[0], result):
            return None
        return api.spec_text(api.sized(designs[0], result), write.parent)

    results = on_each(NAME, specs, stated, verb)
    with saved(write, text, force=force, nothing="no sizes were chosen"):
        finish(NAME, results, style, many=len(results) > 1)
