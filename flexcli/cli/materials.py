"""``flexure materials``: list the shipped materials, or show one with its sources."""

from time import perf_counter
from typing import Annotated

import typer

from flexcli.cli.common import fail
from flexcli.cli.output import CatalogueFormatOption, Format, write_json, write_text

__all__ = ["NAME", "run"]

NAME = "materials"


def run(
    name: Annotated[
        str | None, typer.Argument(help="Name a material; left out, all are listed.")
    ] = None,
    style: CatalogueFormatOption = Format.TEXT,
) -> None:
    """List the shipped materials, or show one with sources.

    Every number has its status.
    """
    from flexcli.errors import SpecError
    from flexcli.report import catalogue
    from flexcli.report.as_json import listing
    from flexcli.spec.load import load_shipped
    from flexcli.spec.shipped import shipped_names

    started = perf_counter()
    try:
        names = shipped_names("material") if name is None else [name]
        materials = {each: load_shipped("material", each) for each in names}
    except SpecError as error:
        fail(NAME, name or "", error, style)
    rows = {each: material.properties() for each, material in materials.items()}
    titles = {each: material.name for each, material in materials.items()}
    if style is Format.JSON:
        content = catalogue.document(titles, rows)
        write_json(listing(NAME, perf_counter() - started, materials=content))
    elif name is None:
        write_text(catalogue.list_of(rows))
    else:
        note = materials[name].note
        write_text(catalogue.sheet(titles[name], note, rows[name]))
