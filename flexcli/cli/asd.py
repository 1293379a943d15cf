"""``flexure asd``: vibration profiles, and the worst case that they make of an oscillator."""

import sys
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from functools import partial
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

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
    only_one,
    overrides_of,
    read,
    with_common_options,
)
from flexcli.cli.files import ForceOption, saved
from flexcli.errors import Finding, SolveError, SpecError
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded
    from flexcli.spec.table_file import Columns

__all__ = [
    "NAME",
    "ColumnOption",
    "ProfilesArgument",
    "TableOption",
    "UnitsOption",
    "WriteOption",
    "app",
    "columns_of",
    "finish_made",
    "finish_one",
    "finish_spectrum",
    "quantity",
    "refuse_no_quality",
    "refuse_no_table",
]

NAME = "asd"

_MOST_DB = 100.0

KINDS: tuple[Literal["density", "transfer"], ...] = ("density", "transfer")

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
    Path | None,
    typer.Option("--write", help="Save the profile as a spec (.yaml) or a table (.csv)."),
]
UnitsOption = Annotated[
    str | None,
    typer.Option("--units", help="Tell the units of a table that has none, e.g. 'Hz, g^2/Hz'."),
]
TableOption = Annotated[
    Path | None, typer.Option("--csv", "-o", help="Save the spectrum, .csv or .parquet.")
]
ColumnOption = Annotated[
    str | None,
    typer.Option("--column", help="Take this column of a table of several, by name or number."),
]


def columns_of(units: str | None, column: str | None) -> "Columns":
    """Return what the command line tells of tables."""
    from flexcli.spec.table_file import Columns

    return Columns.told(units, column)


@app.command()
@with_common_options
def response(
    specs: SpecsArgument = None,
    stated: SetOption = None,
    densities: Annotated[
        Path | None,
        typer.Option("--csv", "-o", help="Save the densities of the responses, .csv or .parquet."),
    ] = None,
    transfers: Annotated[
        Path | None,
        typer.Option("--frf", help="Save the transfer functions to every body, likewise."),
    ] = None,
    force: ForceOption = False,
    style: FormatOption = Format.TEXT,
) -> None:
    """Compute what a design's modes make of each case.

    It gives modes, rms and peaks of travel, stress and force, and life.
    """
    only_one("asd response", "--csv", specs, densities or transfers, style)
    files = {"density": densities, "transfer": transfers}

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        for path in files.values():
            refuse_no_table(path)
        return api.asd_response(spec, spectra=[kind for kind in KINDS if files[kind]])

    results = on_each("asd response", specs, stated, verb)
    with (
        _saved_spectra(densities, results, "density", force=force),
        _saved_spectra(transfers, results, "transfer", force=force),
    ):
        finish("asd response", results, style, many=len(results) > 1)


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
    units: UnitsOption = None,
    column: ColumnOption = None,
    stated: SetOption = None,
    output: TableOption = None,
    force: ForceOption = False,
    style: FormatOption = Format.TEXT,
) -> None:
    """Give Miles' worst case over all frequencies.

    Beside it stand the exact response and its peaks.
    """

    def verb() -> Result:
        from flexcli import api

        refuse_no_quality(qualities or [])
        refuse_no_table(output)
        source = spec if spec != STDIN else read(Path(spec), None)
        return api.asd_worst_case(
            source,
            qualities=qualities or (),
            duration=quantity("--duration", duration, "time"),
            spectra=output is not None,
            columns=columns_of(units, column),
            overrides=overrides_of(stated),
        )

    finish_spectrum("worst-case", spec, verb, output, style, force=force)


def finish_one(verb: str, spec: str, run: Callable[[], Result], style: Format) -> None:
    """Show what a verb found of one spec."""
    command = f"{NAME} {verb}"
    finish(command, [attempt(command, Path(spec), run)], style, many=False)


def finish_made(
    verb: str,
    spec: str,
    run: Callable[[], Result],
    write: Path | None,
    style: Format,
    *,
    force: bool,
) -> None:
    """Show a profile that was made, and save it where that is wished."""

    def checked() -> Result:
        if write is not None and write.suffix not in (".yaml", ".yml", ".csv"):
            hint = "end it in .yaml, or in .csv for a table"
            raise SpecError([Finding(str(write), "is no name of a spec", hint)])
        made = run()
        if write is not None and write.suffix == ".csv":
            _refuse_linear(write, made)
        return made

    def text() -> str | None:
        from flexcli.spec.profiles import profile_text

        as_table = write is not None and write.suffix == ".csv"
        return profile_text(result, as_table=as_table) if result.breakpoints else None

    command = f"{NAME} {verb}"
    result = attempt(command, Path(spec), checked)
    with saved(write, text, force=force, nothing="there is no profile"):
        finish(command, [result], style, many=False)


def _refuse_linear(path: Path, made: Result) -> None:
    """Refuse to write as a table what one would be read as otherwise than it is."""
    if any(profile.interpolation == "linear" for profile in made.profiles):
        text = "a table is straight on log-log axes, and this profile on linear ones"
        raise SpecError([Finding(str(path), text, "end it in .yaml")])


def refuse_no_table(path: Path | None) -> None:
    """Refuse a file that is no table."""
    if path is not None and path.suffix not in (".csv", ".parquet"):
        text = "is neither .csv nor .parquet"
        raise SpecError([Finding(str(path), text, "name it .csv")])


def _saved_spectra(
    path: Path | None, results: Sequence[Result], kind: str, *, force: bool
) -> AbstractContextManager[None]:
    """Write the spectra of a kind to a file, then let the results be printed."""

    def content() -> bytes | None:
        from flexcli.report.columns_file import file_bytes
        from flexcli.report.spectra_text import spectra_columns

        assert path is not None  # it is asked for
        wanted = [one for result in results for one in result.spectra if one.kind == kind]
        try:
            return file_bytes(spectra_columns(wanted), path.suffix) if wanted else None
        except SolveError as error:  # what writes Parquet is not installed
            sys.stderr.write(f"flexure: {error.text}: {error.remedy}\n")
            raise typer.Exit(2) from error

    return saved(path, content, force=force, nothing="there is no spectrum")


def refuse_no_quality(qualities: list[float]) -> None:
    """Refuse what is no quality factor."""
    wrong = [q for q in qualities if not (isfinite(q) and q > 0.0)]
    if wrong:
        findings = [Finding("--q", f"{q:g} is no quality factor", "give e.g. 100") for q in wrong]
        raise SpecError(findings)


def quantity(option: str, text: str | None, dimension: str, *, least: float = 0.0) -> float | None:
    """Return what an option says in SI, above a least value; raise SpecError."""
    from flexcli.units import DIMENSIONS, QuantityError, parse_quantity

    if text is None:
        return None
    try:
        value = parse_quantity(text, dimension)
    except QuantityError as error:
        raise SpecError([Finding(option, str(error), error.hint)]) from error
    if value <= least:
        hint = f"give e.g. '{DIMENSIONS[dimension].example}'"
        raise SpecError([Finding(option, f"{text} must be above {least:g}", hint)])
    return value


def finish_spectrum(
    verb: str,
    spec: str,
    run: Callable[[], Result],
    output: Path | None,
    style: Format,
    *,
    force: bool,
) -> None:
    """Show what a verb found of one spec, and save its spectrum where that is wished."""
    command = f"{NAME} {verb}"
    result = attempt(command, Path(spec), run)
    with _saved_spectra(output, [result], verb, force=force):
        finish(command, [result], style, many=False)
