"""``flexure asd``: vibration profiles, and the worst case that they make of an oscillator."""

from collections.abc import Callable
from functools import partial
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexcli.cli.common import (
    DEFAULT_SPEC,
    STDIN,
    Format,
    FormatOption,
    SetOption,
    SpecsArgument,
    attempt,
    finish,
    on_each,
    overrides_of,
    read,
    with_common_options,
)
from flexcli.cli.files import ForceOption, saved
from flexcli.errors import Finding, SpecError
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "app"]

NAME = "asd"

_MOST_DB = 100.0

app = typer.Typer(
    name=NAME,
    help="Show, combine and judge vibration profiles.",
    no_args_is_help=True,
    rich_markup_mode=None,
)

ProfileArgument = Annotated[str, typer.Argument(help="Name a shipped profile, or a file of one.")]
ProfilesArgument = Annotated[
    list[str], typer.Argument(help="Name shipped profiles, or files of them.")
]
WriteOption = Annotated[
    Path | None, typer.Option("--write", help="Save the profile as a spec (.yaml).")
]


@app.command()
@with_common_options
def response(
    specs: SpecsArgument = None, stated: SetOption = None, style: FormatOption = Format.TEXT
) -> None:
    """Compute what a design's modes make of each case.

    It gives modes, rms and peaks of travel, stress and force, and life.
    """

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        return api.asd_response(spec)

    results = on_each("asd response", specs, stated, verb)
    finish("asd response", results, style, many=len(results) > 1)


@app.command("list")
def list_(style: FormatOption = Format.TEXT) -> None:
    """List the shipped profiles.

    Each has its rms as computed and as published, status and standard.
    """
    from flexcli import api

    _finish("list", "", api.asd_list, style)


@app.command()
@with_common_options
def show(name: ProfileArgument, style: FormatOption = Format.TEXT) -> None:
    """Show a profile with its curve and sources.

    It gives breakpoints, slopes, rms values and moments.
    """
    from flexcli import api

    _finish("show", name, partial(api.asd_show, name), style)


@app.command()
@with_common_options
def grms(names: ProfilesArgument, style: FormatOption = Format.TEXT) -> None:
    """Compute the exact rms of profiles, beside the published one."""
    from flexcli import api

    _finish("grms", ", ".join(names), partial(api.asd_grms, names), style)


@app.command()
@with_common_options
def validate(
    files: Annotated[list[str], typer.Argument(help="Name files of profiles.")],
    style: FormatOption = Format.TEXT,
) -> None:
    """Validate profiles, with the published rms.

    It warns where that is not the rms of the breakpoints.
    """
    from flexcli import api

    command = f"{NAME} validate"
    results = [
        attempt(command, Path(name), partial(api.asd_grms, [name], command=command))
        for name in files
    ]
    finish(command, results, style, many=len(files) > 1)


@app.command()
@with_common_options
def envelope(
    names: ProfilesArgument,
    write: WriteOption = None,
    force: ForceOption = False,
    style: FormatOption = Format.TEXT,
) -> None:
    """Form the envelope of profiles.

    It has the exact points where they cross.
    """
    from flexcli import api

    verb = partial(api.asd_envelope, names)
    _finish_made("envelope", ", ".join(names), verb, write, style, force=force)


@app.command()
@with_common_options
def scale(
    name: ProfileArgument,
    db: Annotated[float, typer.Option("--db", help="Add so many decibels; 3 doubles the density.")],
    write: WriteOption = None,
    force: ForceOption = False,
    style: FormatOption = Format.TEXT,
) -> None:
    """Scale the level of a profile by decibels."""
    from flexcli import api

    if not abs(db) <= _MOST_DB:
        raise typer.BadParameter(f"give decibels from -{_MOST_DB:g} to {_MOST_DB:g}")
    _finish_made("scale", name, partial(api.asd_scale, name, db), write, style, force=force)


@app.command("worst-case")
@with_common_options
def worst_case(
    spec: Annotated[
        str, typer.Argument(help="Name a design, a shipped profile, or a file of a profile.")
    ] = DEFAULT_SPEC,
    qualities: Annotated[
        list[float] | None,
        typer.Option("--q", help="Give a quality factor, once or more; a design has its own."),
    ] = None,
    duration: Annotated[
        str | None, typer.Option("--duration", help="Give the time of exposure, e.g. '2 min'.")
    ] = None,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Give Miles' worst case over all frequencies.

    Beside it stand the exact response and its peaks.
    """

    def verb() -> Result:
        from flexcli import api

        _refuse_no_quality(qualities or [])
        source = spec if spec != STDIN else read(Path(spec), None)
        return api.asd_worst_case(
            source,
            qualities=qualities or (),
            duration=_seconds(duration),
            overrides=overrides_of(stated),
        )

    _finish("worst-case", spec, verb, style)


def _finish(verb: str, spec: str, run: Callable[[], Result], style: Format) -> None:
    command = f"{NAME} {verb}"
    finish(command, [attempt(command, Path(spec), run)], style, many=False)


def _finish_made(
    verb: str,
    spec: str,
    run: Callable[[], Result],
    write: Path | None,
    style: Format,
    *,
    force: bool,
) -> None:
    """Show a profile that was made, and save it where that is wished."""

    def made() -> Result:
        if write is not None and write.suffix not in (".yaml", ".yml"):
            raise SpecError([Finding(str(write), "is no name of a spec", "end it in .yaml")])
        return run()

    def text() -> str | None:
        from flexcli.spec.profiles import profile_text

        return profile_text(result) if result.breakpoints else None

    command = f"{NAME} {verb}"
    result = attempt(command, Path(spec), made)
    with saved(write, text, force=force, nothing="there is no profile"):
        finish(command, [result], style, many=False)


def _refuse_no_quality(qualities: list[float]) -> None:
    wrong = [q for q in qualities if not (isfinite(q) and q > 0.0)]
    if wrong:
        findings = [Finding("--q", f"{q:g} is no quality factor", "give e.g. 100") for q in wrong]
        raise SpecError(findings)


def _seconds(duration: str | None) -> float | None:
    from flexcli.units import QuantityError, parse_quantity

    if duration is None:
        return None
    try:
        time = parse_quantity(duration, "time")
    except QuantityError as error:
        raise SpecError([Finding("--duration", str(error), error.hint)]) from error
    if time <= 0.0:
        raise SpecError([Finding("--duration", f"{duration} must be above 0", "give e.g. '2 min'")])
    return time
