"""``flexure size``: choose h, l, b."""

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
    write_file,
)
from flexcli.results import Result

__all__ = ["NAME", "run"]

NAME = "size"


def run(
    spec: SpecArgument = None,
    model: ModelOption = None,
    style: FormatOption = Format.TEXT,
    write: Annotated[
        Path | None, typer.Option("--write", help="Save the sized design as a spec for check.")
    ] = None,
) -> None:
    """Choose blade thickness h, length l and width b; print margins and what holds them."""
    path = spec_path(spec)
    result = attempt(NAME, path, lambda: _size(path, write, model))
    finish(NAME, [result], style, many=False)


def _size(path: Path, write: Path | None, model: Model | None) -> Result:
    from flexcli.engine.size import size
    from flexcli.spec.load import load_design
    from flexcli.spec.save import sized_text

    design, document = load_design(path)
    result = size(design, str(path), model.value if model else None)
    if write is not None and result.checks:
        geometry = design.geometry
        sizes = {geometry.place(name): result.values[name].value for name in geometry.extents}
        chosen = result.values.get("H")
        height = chosen.value if chosen is not None and chosen.model == "sized" else None
        write_file(write, sized_text(path, document, write, sizes, height))
    return result
