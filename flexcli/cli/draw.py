"""``flexure draw``: the joint to scale, at rest and at the ends of its stroke."""

from enum import Enum
from pathlib import Path
from typing import Annotated

import typer

from flexcli.cli.common import Format, SpecArgument, attempt, finish, spec_path, write_file
from flexcli.results import Result, Status

__all__ = ["NAME", "run"]

NAME = "draw"


class View(str, Enum):  # noqa: UP042 - typer reads the values of a str enum
    """From where the mechanism is seen."""

    FRONT = "front"
    SIDE = "side"
    ISOMETRIC = "isometric"


def run(
    spec: SpecArgument = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="SVG or PNG file; SVG to stdout if left out."),
    ] = None,
    view: Annotated[View, typer.Option("--view", help="From where it is seen.")] = View.FRONT,
    case: Annotated[
        str | None, typer.Option("--case", help="Case whose stroke and forces are drawn.")
    ] = None,
    stress: Annotated[
        bool, typer.Option("--stress", help="Colour the blades of the + end by their stress.")
    ] = False,
) -> None:
    """Draw the joint to scale as SVG: at rest, deflected, with sizes, forces and centre."""
    path = spec_path(spec)
    drawn: list[str] = []
    result = attempt(NAME, path, lambda: _draw(path, drawn, view, case, stress=stress))
    if not drawn:
        finish(NAME, [result], Format.TEXT, many=False)
    (svg,) = drawn
    if output is None:
        typer.echo(svg, nl=False)
    elif output.suffix == ".png":
        from flexcli.report.raster import png

        write_file(output, png(svg))
    else:
        write_file(output, svg)


def _draw(path: Path, drawn: list[str], view: View, case: str | None, *, stress: bool) -> Result:
    from flexcli.engine.draw import drawing
    from flexcli.report.drawing_svg import drawing_svg
    from flexcli.spec.given import given_sizes
    from flexcli.spec.load import load_design

    design, document = load_design(path)
    found = drawing(design, given_sizes(design, document), case)
    title = design.title or found.kind
    if view is View.FRONT:
        drawn.append(drawing_svg(found, title, stress=stress))
    else:
        from flexcli.report.drawing_views import view_svg

        drawn.append(view_svg(found, title, view.value))
    return Result(NAME, str(path), Status.PASS, title=design.title)
