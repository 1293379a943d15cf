"""``flexure asd``: vibration profiles, and the worst case that they make of an oscillator."""

from collections.abc import Callable
from functools import partial
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexcli.cli import response
from flexcli.cli.common import (
    DEFAULT_SPEC,
    Format,
    FormatOption,
    attempt,
    finish,
    with_common_options,
    write_file,
)
from flexcli.errors import Finding, SpecError
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.parts.asd import ASDProfile

__all__ = ["NAME", "app"]

NAME = "asd"

_MOST_DB = 100.0

app = typer.Typer(
    name=NAME,
    help="Vibration profiles (acceleration spectral densities) and their worst case.",
    no_args_is_help=True,
    rich_markup_mode=None,
)

ProfileArgument = Annotated[str, typer.Argument(help="A shipped profile, or a file of one.")]
ProfilesArgument = Annotated[list[str], typer.Argument(help="Shipped profiles, or files of them.")]
WriteOption = Annotated[
    Path | None, typer.Option("--write", help="Save the profile as a spec (.yaml).")
]


app.command(response.NAME)(with_common_options(response.run))


@app.command("list")
def list_(style: FormatOption = Format.TEXT) -> None:
    """List the shipped profiles: rms as computed and as published, status, standard."""
    from flexcli.spec.shipped import shipped_names

    _finish("list", "", lambda: _catalogue("list", shipped_names(NAME)), style)


@app.command()
@with_common_options
def show(name: ProfileArgument, style: FormatOption = Format.TEXT) -> None:
    """Show a profile: breakpoints, slopes, rms values, moments, curve and sources."""
    _finish("show", name, lambda: _described("show", name), style)


@app.command()
@with_common_options
def grms(names: ProfilesArgument, style: FormatOption = Format.TEXT) -> None:
    """Compute the exact rms of profiles, beside the published one."""
    _finish("grms", ", ".join(names), lambda: _catalogue("grms", names), style)


@app.command()
@with_common_options
def validate(
    files: Annotated[list[str], typer.Argument(help="Files of profiles.")],
    style: FormatOption = Format.TEXT,
) -> None:
    """Validate profiles; warn where the published rms is not that of the breakpoints."""
    command = f"{NAME} validate"
    results = [
        attempt(command, Path(name), partial(_catalogue, "validate", [name])) for name in files
    ]
    finish(command, results, style, many=len(files) > 1)


@app.command()
@with_common_options
def envelope(
    names: ProfilesArgument, write: WriteOption = None, style: FormatOption = Format.TEXT
) -> None:
    """Form the envelope of profiles, with the exact points where they cross."""
    from flexcli.engine.asd import enveloped
    from flexcli.spec.profiles import load_profiles

    def run() -> Result:
        return _made("envelope", ", ".join(names), write, enveloped(load_profiles(names)))

    _finish("envelope", ", ".join(names), run, style)


@app.command()
@with_common_options
def scale(
    name: ProfileArgument,
    db: Annotated[float, typer.Option("--db", help="Decibels to add; 3 doubles the density.")],
    write: WriteOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Scale the level of a profile by decibels."""
    from flexcli.engine.asd import scaled
    from flexcli.spec.profiles import load_profile

    if not abs(db) <= _MOST_DB:
        raise typer.BadParameter(f"give decibels from -{_MOST_DB:g} to {_MOST_DB:g}")

    def run() -> Result:
        return _made("scale", name, write, scaled(name, load_profile(name), db))

    _finish("scale", name, run, style)


@app.command("worst-case")
@with_common_options
def worst_case(
    spec: Annotated[
        str, typer.Argument(help="A design, a shipped profile, or a file of a profile.")
    ] = DEFAULT_SPEC,
    qualities: Annotated[
        list[float] | None,
        typer.Option("--q", help="Quality factor, once or more; a design has its own."),
    ] = None,
    duration: Annotated[
        str | None, typer.Option("--duration", help="Time of exposure, e.g. '2 min'.")
    ] = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Give Miles' worst case over all frequencies, beside the exact response and its peaks."""
    _finish("worst-case", spec, lambda: _worst_case(spec, qualities or [], duration), style)


def _finish(verb: str, spec: str, run: Callable[[], Result], style: Format) -> None:
    command = f"{NAME} {verb}"
    finish(command, [attempt(command, Path(spec), run)], style, many=False)


def _catalogue(verb: str, names: list[str]) -> Result:
    from flexcli.engine.asd import catalogue
    from flexcli.spec.profiles import load_profiles

    return catalogue(f"{NAME} {verb}", load_profiles(names))


def _described(verb: str, name: str) -> Result:
    from flexcli.engine.asd import describe
    from flexcli.spec.profiles import load_profile

    return describe(f"{NAME} {verb}", name, load_profile(name))


def _made(verb: str, spec: str, write: Path | None, profile: "ASDProfile") -> Result:
    from flexcli.engine.asd import describe
    from flexcli.spec.profiles import profile_text

    if write is not None:
        if write.suffix not in (".yaml", ".yml"):
            raise SpecError([Finding(str(write), "is no name of a spec", "end it in .yaml")])
        write_file(write, profile_text(profile))
    return describe(f"{NAME} {verb}", spec, profile)


def _worst_case(spec: str, qualities: list[float], duration: str | None) -> Result:
    from flexcli.engine.asd_worst_case import environments, exposed, worst_case
    from flexcli.parts.asd import ASDProfile
    from flexcli.spec.profiles import load_design_or_profile

    wrong = [q for q in qualities if not (isfinite(q) and q > 0.0)]
    if wrong:
        findings = [Finding("--q", f"{q:g} is no quality factor", "give e.g. 100") for q in wrong]
        raise SpecError(findings)
    time = _seconds(duration)
    source = load_design_or_profile(spec)
    if isinstance(source, ASDProfile):
        if not qualities:
            raise SpecError([Finding(spec, "a profile needs a quality factor", "add --q 100")])
        found = exposed(spec, source, qualities, time)
        return worst_case(found, spec, source.name)
    found = environments(source, qualities, time)
    if not found:
        raise SpecError([Finding(spec, "no case has an asd", "add one, or name a profile")])
    return worst_case(found, spec, source.title)


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
