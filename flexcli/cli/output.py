"""How output is written: results in the asked format, on any stream, and how a run ends."""

import io
import os
import sys
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer

from flexcli.errors import Finding
from flexcli.report.formats import Format, Page, Report
from flexcli.results import PassedOver, Result, Status

if TYPE_CHECKING:
    from flexcli.report.tables import Piece

__all__ = [
    "CatalogueFormatOption",
    "Format",
    "FormatOption",
    "any_stream",
    "asked_format",
    "finish",
    "write_failure",
    "write_json",
    "write_plain",
    "write_text",
]

USUAL_COLUMNS = 80
"""Columns of what is no terminal."""

FormatOption = Annotated[
    Format,
    typer.Option(
        "--format",
        help="How the result is printed on stdout: text for people; json for scripts; junit, "
        "sarif, github (annotations) and markdown (a job summary) for CI.",
    ),
]


def _text_or_json(style: Format) -> Format:
    if style not in (Format.TEXT, Format.JSON):
        raise typer.BadParameter(f"{style.value} is for results; this is text or json")
    return style


CatalogueFormatOption = Annotated[
    Format,
    typer.Option(
        "--format",
        metavar="[text|json]",
        callback=_text_or_json,
        help="How it is printed on stdout: text for people, json for scripts.",
    ),
]


def finish(
    command: str,
    results: Sequence[Result],
    style: Format,
    *,
    many: bool,
    passed_over: Sequence[PassedOver] = (),
) -> NoReturn:
    """Print results and leave with the exit code of the worst."""
    report = Report(command, tuple(results), many, tuple(passed_over))
    if style is Format.TEXT:
        from flexcli.report.as_text import findings_text

        findings = [found for result in results for found in result.findings]
        _write(findings_text(findings, _encoding(sys.stderr)), sys.stderr)
    _write(style.render(report, _page(sys.stdout, style)), sys.stdout)
    raise typer.Exit(max((result.status.exit_code for result in results), default=0))


def write_failure(style: Format, text: str, command: str = "", hint: str = "") -> None:
    """Print what went wrong outside of any spec, in the format of results."""
    finding = Finding("flexure", text, hint)
    result = Result(command or "flexure", "", Status.ERROR, findings=(finding,))
    _write(style.render(Report(result.command, (result,)), _page(sys.stdout, style)), sys.stdout)


def write_text(pieces: Iterable["Piece"]) -> None:
    """Lay pieces of text out for the terminal that reads, and write them whole."""
    from flexcli.report.tables import on_page

    _write(on_page(pieces, _page(sys.stdout, Format.TEXT)), sys.stdout)


def write_plain(text: str) -> None:
    """Write a text to stdout as it stands."""
    _write(text, sys.stdout)


def write_json(content: Any) -> None:
    """Write JSON to stdout."""
    from flexcli.report import as_json

    _write(as_json.dumps(content, _encoding(sys.stdout)) + "\n", sys.stdout)


def asked_format(arguments: Sequence[str]) -> Format:
    """Return the format that arguments ask for, text where they ask for none that there is."""
    asked = [b for a, b in pairwise(arguments) if a == "--format"]
    asked += [a.partition("=")[2] for a in arguments if a.startswith("--format=")]
    return Format(asked[-1]) if asked and asked[-1] in list(Format) else Format.TEXT


def any_stream() -> None:
    """Let both streams replace characters that their encoding lacks by ASCII."""
    from flexcli.report.charset import TRANSLITERATE

    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=TRANSLITERATE)


def _encoding(stream: Any) -> str:
    return getattr(stream, "encoding", None) or "utf-8"


def _page(stream: Any, style: Format) -> Page:
    """Return the columns, colours and characters of a stream; only text has the first two."""
    if style is not Format.TEXT:
        return Page(encoding=_encoding(stream))
    return Page(_columns(), _is_coloured(stream), _encoding(stream))


def _columns() -> int:
    """Return the columns that the environment states, else those of the terminal in use."""
    stated = os.environ.get("COLUMNS", "")
    if stated.isdigit() and int(stated):
        return int(stated)
    for stream in (sys.__stdin__, sys.__stdout__, sys.__stderr__):
        try:
            if stream is not None and (found := os.get_terminal_size(stream.fileno()).columns):
                return found
        except (OSError, ValueError):  # no terminal, or closed
            continue
    return USUAL_COLUMNS


def _is_coloured(stream: Any) -> bool:
    """Return whether a stream wants colours: no-color.org, force-color.org, else a terminal."""
    forced = os.environ.get("FORCE_COLOR")
    if os.environ.get("NO_COLOR") or os.environ.get("TERM") in ("dumb", "unknown"):
        return False
    return bool(forced) if forced is not None else stream.isatty()


def _write(text: str, stream: Any) -> None:
    try:
        stream.write(text)
        stream.flush()
    except OSError as error:
        # keep the interpreter's shutdown from flushing into the broken stream once more
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
        sys.stderr.write(f"flexure: the output could not be written: {error.strerror}\n")
        raise typer.Exit(2) from error
