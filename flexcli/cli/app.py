"""The ``flexure`` command: its verbs, and the edge where a bug becomes its exit code."""

import gc
import os
import sys
import traceback

import typer

from flexcli import __version__
from flexcli.cli import (
    accuracy,
    asd,
    balance,
    check,
    draw,
    explain,
    materials,
    plan,
    schema,
    simulate,
    size,
    stops,
    validate,
)
from flexcli.cli.common import with_common_options

__all__ = ["app", "main"]

EXIT_BUG = 101

GARBAGE_THRESHOLD = 100_000
"""New objects between searches for garbage; Python's own 700 cost a twentieth of a short run."""

app = typer.Typer(
    name="flexure",
    epilog="Exit codes: 0 passed; 1 the design fails or is infeasible; 2 bad input or usage; "
    "101 a bug of ours.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)
for verb in (
    size,
    check,
    simulate,
    plan,
    accuracy,
    balance,
    stops,
    draw,
    explain,
    validate,
    materials,
    schema,
):
    reads_no_spec = verb in (explain, materials, schema)
    app.command(name=verb.NAME)(verb.run if reads_no_spec else with_common_options(verb.run))
app.add_typer(asd.app)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"flexure {__version__}")
        raise typer.Exit


@app.callback()
def root(
    version: bool = typer.Option(
        False, "--version", callback=_version, is_eager=True, help="Print the version and exit."
    ),
) -> None:
    """Size, check and simulate flexures from a YAML spec."""


def main() -> None:
    """Run the command line; what nobody foresaw is a bug and says so."""
    gc.set_threshold(GARBAGE_THRESHOLD)
    # pydantic would read the metadata of every installed package to look for plugins
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    try:
        app()
    except Exception:
        traceback.print_exc()
        sys.stderr.write("flexure: this is a bug of ours; please report it with the spec\n")
        sys.exit(EXIT_BUG)
    finally:
        gc.freeze()  # the end of the process need not search all that was imported
