"""What the verbs of ``flexure asd`` share: options, checks of their values, output."""

import sys
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from flexcli.cli.common import Format, attempt, finish
from flexcli.cli.files import saved
from flexcli.errors import Finding, SolveError, SpecError
from flexcli.results import Result

if TYPE_CHECKING:
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
    "saved_spectra",
]

NAME = "asd"

app = typer.Typer(
    name=NAME,
    help="Show, combine and judge vibration profiles.",
    no_args_is_help=True,
    rich_markup_mode=None,
)

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


def saved_spectra(
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
    with saved_spectra(output, [result], verb, force=force):
        finish(command, [result], style, many=False)
