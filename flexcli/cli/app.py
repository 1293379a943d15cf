"""The ``flexure`` command: its verbs, and the edge where a mistake or a bug becomes a code."""

import os
import sys
import traceback
from collections.abc import Sequence
from functools import cache
from importlib import import_module
from typing import Any

import typer

from flexcli import __version__
from flexcli.cli.common import with_common_options
from flexcli.cli.output import Format, any_stream, asked_format, write_failure

__all__ = ["command_line", "main"]

EXIT_BUG = 101

EXIT_CODES = (
    "Exit codes: 0 passed; 1 the design fails, is infeasible or undecided, or the run was "
    "stopped; 2 bad input or usage; 101 a bug of ours."
)

VERBS = (
    "init", "size", "check", "simulate", "plan", "accuracy", "verify", "balance", "stops", "sweep",
    "tolerances", "draw", "export", "plot", "report", "explain", "validate", "materials", "schema",
)  # fmt: skip
"""Commands of one verb, by their modules, in the order of the help."""

READING_NO_SPEC = ("init", "explain", "materials", "schema")

GROUPS = ("asd", "examples")
"""Commands of several verbs, by their modules."""


@cache
def command_line(only: str | None = None) -> typer.Typer:
    """Return the command line, of one command alone where it is named: others are not imported."""
    app = _without_commands()
    for verb in VERBS:
        if only in (None, verb):
            run = import_module(f"flexcli.cli.{verb}").run
            app.command(name=verb)(run if verb in READING_NO_SPEC else with_common_options(run))
    groups = [
        import_module(f"flexcli.cli.{group}").app for group in GROUPS if only in (None, group)
    ]
    for group in groups:
        app.add_typer(group)
    for each in (app, *groups):
        for command in each.registered_commands:
            command.epilog = EXIT_CODES
    return app


def contents() -> typer.Typer:
    """Return the command line as its help lists it: commands by what they do, without options.

    For lines that run none of them; typer would look into every option of every command.
    """
    app = _without_commands()
    for verb in VERBS:
        run = import_module(f"flexcli.cli.{verb}").run
        app.command(name=verb, help=run.__doc__)(_listed)
    for group in GROUPS:
        info = import_module(f"flexcli.cli.{group}").app.info
        app.command(name=group, help=info.help)(_listed)
    return app


def _listed() -> None:
    """Stand in a list for a command."""


def _without_commands() -> typer.Typer:
    return typer.Typer(
        name="flexure",
        epilog=EXIT_CODES,
        no_args_is_help=True,
        context_settings={"help_option_names": ["-h", "--help"]},
        pretty_exceptions_enable=False,
        rich_markup_mode=None,
        callback=root,
    )


def _asked(arguments: Sequence[str]) -> typer.Typer:
    """Return what a line needs of the command line: a command, or what lists them."""
    if any(name.endswith("_COMPLETE") for name in os.environ):
        return command_line()
    word = next((word for word in arguments if not word.startswith("-")), None)
    return command_line(word) if word in (*VERBS, *GROUPS) else contents()


UsageError: Any = typer.BadParameter.__base__
"""What typer raises for wrong usage; its name differs between versions, its place does not."""


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"flexure {__version__}")
        raise typer.Exit


def root(
    version: bool = typer.Option(
        False, "--version", callback=_version, is_eager=True, help="Print the version and exit."
    ),
) -> None:
    """Size, check and simulate flexures from a YAML spec."""


def _for_machines(app: typer.Typer, style: Format) -> int:
    """Run the command line and return its exit code; wrong usage is told in the asked format."""
    try:
        return app(standalone_mode=False) or 0
    except UsageError as error:
        context = error.ctx
        verb = context.info_name if context is not None and context.parent is not None else ""
        write_failure(style, error.format_message(), verb, "see flexure --help")
        return int(error.exit_code)
    except typer.Abort:
        return 1


def main() -> None:
    """Run the command line; what nobody foresaw is a bug and says so."""
    any_stream()
    style = asked_format(sys.argv[1:])
    try:
        app = _asked(sys.argv[1:])
        if style is Format.TEXT:
            app()
        else:
            sys.exit(_for_machines(app, style))
    except Exception as error:
        traceback.print_exc()
        sys.stderr.write("flexure: this is a bug of ours; please report it with the spec\n")
        if style is not Format.TEXT:
            write_failure(style, f"a bug of ours: {type(error).__name__}: {error}")
        sys.exit(EXIT_BUG)
