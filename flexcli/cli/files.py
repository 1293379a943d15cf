"""Output files: a new file is written whole or not at all, an old one replaced if forced."""

import os
import stat
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Annotated

import typer

from flexcli.errors import SolveError

__all__ = ["ForceOption", "saved", "write_all_or_end", "write_or_end", "write_picture"]

ForceOption = Annotated[
    bool, typer.Option("--force", help="Replace the file to write, if it exists.")
]

EXISTS = "it exists; --force replaces it"


class _NotWritten(Exception):
    """Why a file was not written, in one line."""


@contextmanager
def saved(
    path: Path | None, text: Callable[[], str | bytes | None], *, force: bool, nothing: str
) -> Iterator[None]:
    """Write a text to a file around the printing of the result, then report any failure.

    Parameters
    ----------
    path : Path, optional
        The file, if one is wished.
    text : callable
        Gives the text, or None where there is none.
    force : bool
        Whether a file that exists may be replaced.
    nothing : str
        Why there may be no text.

    """
    told, has_failed = "", False
    if path is not None:
        content = text()
        if content is None:
            told = f"nothing was written to {path}: {nothing}"
        else:
            try:
                _write(path, content, force=force)
            except _NotWritten as error:
                told, has_failed = f"cannot write {path}: {error}", True
    try:
        yield
    except typer.Exit as ended:
        if told:
            sys.stderr.write(f"flexure: {told}\n")
        if has_failed:
            raise typer.Exit(2) from ended
        raise


def write_or_end(path: Path, content: str | bytes, *, force: bool) -> None:
    """Write a file that is all that was asked for, or end the run with one line."""
    try:
        _write(path, content, force=force)
    except _NotWritten as error:
        sys.stderr.write(f"flexure: cannot write {path}: {error}\n")
        raise typer.Exit(2) from error


def write_all_or_end(files: Mapping[Path, bytes], *, force: bool) -> None:
    """Write files of new folders, or end the run with one line before any is written."""
    for path in files:
        if path.exists() and not force:
            sys.stderr.write(f"flexure: cannot write {path}: {EXISTS}\n")
            raise typer.Exit(2)
    for path, content in files.items():
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            sys.stderr.write(f"flexure: cannot make {path.parent}: {error.strerror}\n")
            raise typer.Exit(2) from error
        write_or_end(path, content, force=force)


def write_picture(svg: str, path: Path | None, *, force: bool) -> None:
    """Write a picture as its file's name says, to stdout where there is none, or end the run."""
    if path is None:
        typer.echo(svg, nl=False)
        return
    content: str | bytes = svg
    if path.suffix == ".png":
        from flexcli.report.raster import png

        try:
            content = png(svg)
        except SolveError as error:  # what draws pixels is not installed
            sys.stderr.write(f"flexure: {error.text}: {error.remedy}\n")
            raise typer.Exit(2) from error
    write_or_end(path, content, force=force)


def _write(path: Path, content: str | bytes, *, force: bool) -> None:
    """Write a file whole or not at all; a link keeps its target, a file its mode and owner."""
    target = _target(path)
    partial = target.with_name(f".flexure-{os.urandom(4).hex()}.part")
    try:
        before = target.stat() if target.exists() else None
        if before is not None and not stat.S_ISREG(before.st_mode):
            raise _NotWritten("it is a folder, a device or a pipe, not a file")
        if before is not None and not force:
            raise _NotWritten(EXISTS)
        with partial.open("xb") as stream:
            stream.write(content if isinstance(content, bytes) else content.encode())
        if before is not None:
            with suppress(OSError, AttributeError):  # not one's own to give away; Windows
                os.chown(partial, before.st_uid, before.st_gid)
            partial.chmod(stat.S_IMODE(before.st_mode))
            partial.replace(target)
        else:
            _put(partial, target)
    except OSError as error:
        raise _NotWritten(error.strerror or str(error)) from error
    finally:
        with suppress(OSError):
            partial.unlink(missing_ok=True)


def _target(path: Path) -> Path:
    """Return the file that a path leads to, links followed."""
    if str(path) == "-":
        raise _NotWritten("give it a name; the result itself is on stdout")
    try:
        return path.resolve()
    except (OSError, RuntimeError) as error:  # RuntimeError: a loop of links
        raise _NotWritten("its links lead nowhere") from error


def _put(partial: Path, target: Path) -> None:
    """Give a file its name where there is none of that name, also if one came just now."""
    try:
        os.link(partial, target)
    except FileExistsError:
        raise _NotWritten(EXISTS) from None
    except OSError:  # a file system without links
        partial.replace(target)
