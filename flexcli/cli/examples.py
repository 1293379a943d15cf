"""``flexure examples``: worked examples that ship with the tool, to run and to change."""

from pathlib import Path
from time import perf_counter
from typing import Annotated

import typer

from flexcli.cli.common import fail
from flexcli.cli.files import ForceOption, write_all_or_end
from flexcli.cli.output import CatalogueFormatOption, Format, write_json, write_plain, write_text

__all__ = ["NAME", "app"]

NAME = "examples"

app = typer.Typer(
    name=NAME,
    help="List worked examples, or copy one to run and change it.",
    no_args_is_help=False,
    rich_markup_mode=None,
)


@app.callback(invoke_without_command=True)
def usual(context: typer.Context) -> None:
    """List the examples where nothing else is asked."""
    if context.invoked_subcommand is None:
        list_()


@app.command("list")
def list_(style: CatalogueFormatOption = Format.TEXT) -> None:
    """List the examples.

    Each has a line and the command that runs it.
    """
    from flexcli.report import catalogue
    from flexcli.report.as_json import listing
    from flexcli.spec.examples import examples

    started = perf_counter()
    found = examples()
    if style is Format.JSON:
        rows = {each.name: {"title": each.title, "command": each.command} for each in found}
        write_json(listing(f"{NAME} list", perf_counter() - started, examples=rows))
        return
    lines = [(each.name, each.title, each.command) for each in found]
    told = "flexure examples copy NAME makes one your own"
    write_text(catalogue.lines(("name", "what it is", "command"), lines, told))


@app.command()
def copy(
    name: Annotated[str, typer.Argument(help="Name an example, as flexure examples lists them.")],
    folder: Annotated[
        Path | None,
        typer.Argument(metavar="[DIR]", help="Name its new folder; left out, that of its name."),
    ] = None,
    force: ForceOption = False,
) -> None:
    """Copy an example into a folder and say how to run it.

    It is a spec, what its source prints, and a text that compares both.
    """
    from flexcli.errors import SpecError
    from flexcli.spec.examples import SPEC, example

    try:
        found = example(name)
    except SpecError as error:
        fail(f"{NAME} copy", "", error, Format.TEXT)
    target = folder or Path(name)
    write_all_or_end({target / file: text for file, text in found.files().items()}, force=force)
    write_plain(f"Copied to {target}. Run it:\n\n    {found.command} {target / SPEC}\n")
