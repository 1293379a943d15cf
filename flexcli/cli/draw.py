"""``flexure draw``: the mechanism to scale, at rest and at the ends of its stroke."""

from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexcli.cli.common import (
    Format,
    SetOption,
    SpecsArgument,
    fail,
    finish,
    on_each,
)
from flexcli.cli.files import ForceOption, write_picture
from flexcli.errors import Finding, SpecError
from flexcli.results import Result, Status

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "draw"


class View(str, Enum):  # noqa: UP042 - typer reads the values of a str enum
    """From where the mechanism is seen."""

    FRONT = "front"
    SIDE = "side"
    ISOMETRIC = "isometric"


def run(
    specs: SpecsArgument = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", help="Write this SVG or PNG file; left out, SVG goes to stdout."
        ),
    ] = None,
    force: ForceOption = False,
    stated: SetOption = None,
    view: Annotated[
        View, typer.Option("--view", help="Choose the side from which it is seen.")
    ] = View.FRONT,
    case: Annotated[
        str | None, typer.Option("--case", help="Draw the stroke and the forces of this case.")
    ] = None,
    stress: Annotated[
        bool, typer.Option("--stress", help="Colour the blades of the + end by their stress.")
    ] = False,
    joint: Annotated[
        bool, typer.Option("--joint", help="Draw one joint alone, without the mechanism on it.")
    ] = False,
) -> None:
    """Draw a mechanism to scale, as SVG or PNG.

    It is drawn at rest and deflected, with sizes, forces and centre.
    """
    if len(specs or ()) > 1:
        fail(NAME, "", SpecError([Finding(NAME, "draws one spec", "name one")]), Format.TEXT)
    drawn: list[str] = []

    def verb(spec: "Loaded") -> Result:
        drawn.append(_drawn(spec, view, case, stress=stress, joint=joint))
        return Result(NAME, "", Status.PASS)

    results = on_each(NAME, specs, stated, verb)
    if not drawn:
        finish(NAME, results, Format.TEXT, many=False)
    write_picture(drawn[0], output, force=force)


def _drawn(spec: "Loaded", view: View, case: str | None, *, stress: bool, joint: bool) -> str:
    from flexcli import api
    from flexcli.report.drawings.plane import drawing_svg

    found = (api.joint_drawing if joint else api.drawing)(spec, case=case)
    title = spec.part.title or found.kind
    if view is View.FRONT:
        return drawing_svg(found, title, stress=stress)
    from flexcli.report.drawings.views import view_svg

    return view_svg(found, title, view.value, stress=stress)
