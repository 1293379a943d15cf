"""``flexure asd`` on profiles alone: list, show, compare, combine and scale them."""

from enum import Enum
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from flexcli.cli.asd.common import (
    NAME,
    ColumnOption,
    ProfilesArgument,
    UnitsOption,
    WriteOption,
    app,
    columns_of,
    finish_made,
    finish_one,
)
from flexcli.cli.common import Format, FormatOption, attempt, finish, with_common_options
from flexcli.cli.files import ForceOption

_MOST_DB = 100.0

ProfileArgument = Annotated[str, typer.Argument(help="Name a shipped profile, or a file of one.")]


class Rule(str, Enum):  # noqa: UP042 - typer reads the values of a str enum
    """How profiles are put together."""

    SUM = "sum"
    ENVELOPE = "envelope"


@app.command("list")
def list_(style: FormatOption = Format.TEXT) -> None:
    """List the shipped profiles.

    Each has its rms as computed and as published, status and standard.
    """
    from flexcli import api

    finish_one("list", "", api.asd_list, style)


@app.command()
@with_common_options
def show(
    name: ProfileArgument,
    units: UnitsOption = None,
    column: ColumnOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Show a profile with its curve and sources.

    It gives breakpoints, slopes, rms values and moments.
    """
    from flexcli import api

    finish_one("show", name, partial(api.asd_show, name, columns=columns_of(units, column)), style)


@app.command()
@with_common_options
def grms(
    names: ProfilesArgument,
    units: UnitsOption = None,
    column: ColumnOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Compute the exact rms of profiles, beside the published one."""
    from flexcli import api

    verb = partial(api.asd_grms, names, columns=columns_of(units, column))
    finish_one("grms", ", ".join(names), verb, style)


@app.command()
@with_common_options
def validate(
    files: Annotated[list[str], typer.Argument(help="Name files of profiles.")],
    units: UnitsOption = None,
    column: ColumnOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Validate profiles, with the published rms.

    It warns where that is not the rms of the breakpoints.
    """
    from flexcli import api

    command, columns = f"{NAME} validate", columns_of(units, column)
    results = [
        attempt(
            command, Path(name), partial(api.asd_grms, [name], command=command, columns=columns)
        )
        for name in files
    ]
    finish(command, results, style, many=len(files) > 1)


@app.command()
@with_common_options
def envelope(
    names: ProfilesArgument,
    write: WriteOption = None,
    force: ForceOption = False,
    units: UnitsOption = None,
    column: ColumnOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Form the envelope of profiles.

    It has the exact points where they cross.
    """
    from flexcli import api

    verb = partial(api.asd_envelope, names, columns=columns_of(units, column))
    finish_made("envelope", ", ".join(names), verb, write, style, force=force)


@app.command()
@with_common_options
def scale(
    name: ProfileArgument,
    db: Annotated[float, typer.Option("--db", help="Add so many decibels; 3 doubles the density.")],
    write: WriteOption = None,
    force: ForceOption = False,
    units: UnitsOption = None,
    column: ColumnOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Scale the level of a profile by decibels."""
    from flexcli import api

    if not abs(db) <= _MOST_DB:
        raise typer.BadParameter(f"give decibels from -{_MOST_DB:g} to {_MOST_DB:g}")
    verb = partial(api.asd_scale, name, db, columns=columns_of(units, column))
    finish_made("scale", name, verb, write, style, force=force)


@app.command()
@with_common_options
def combine(
    names: ProfilesArgument,
    rule: Annotated[
        Rule, typer.Option("--rule", help="Add powers that act at once, or take the greatest.")
    ] = Rule.SUM,
    write: WriteOption = None,
    force: ForceOption = False,
    units: UnitsOption = None,
    column: ColumnOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Combine profiles: the sum of their powers, or the envelope.

    The lines of a sum follow it to 0.1 %.
    """
    from flexcli import api

    told = columns_of(units, column)
    verb = partial(api.asd_combine, names, rule=rule.value, columns=told)
    finish_made("combine", ", ".join(names), verb, write, style, force=force)
