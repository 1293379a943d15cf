"""Which files of a folder are designs, and why the others are not."""

import os
import re
from collections.abc import Iterator
from difflib import get_close_matches
from pathlib import Path

from flexcli.errors import SpecError
from flexcli.parts.base import said
from flexcli.spec.load import KINDS
from flexcli.spec.read import read_document
from flexcli.spec.references import SUFFIXES, is_from_anywhere

__all__ = ["members"]

FIRST = "flexure"
"""The key of a spec of any kind."""

DESIGN = {"material", "geometry", "mechanism", "cases", "requirements"}
"""Keys of which two make a design, though its first one be misspelt."""

LIKE_A_SPEC = re.compile(rf"^\W*(fle\w*|{'|'.join(DESIGN)})\b", re.MULTILINE)
"""Text that marks a design even where it is not valid YAML."""

OUTSIDE = "a link to a file outside the folder; --allow-outside takes it"

LOOKED_AT = 65_536
"""Number of characters in which that is looked for."""


def members(folder: Path) -> list[tuple[Path, str]]:
    """Return the YAML files below a folder, sorted, each with why it is passed over, if it is.

    A file that may be a design with mistakes is not, so that its findings are told. Hidden and
    linked folders are named and not entered.
    """
    return sorted(_members(folder))


def _members(folder: Path) -> Iterator[tuple[Path, str]]:
    unread: list[OSError] = []
    for here, folders, files in os.walk(folder, onerror=unread.append):
        for name in list(folders):
            path = Path(here, name)
            if name.startswith(".") or path.is_symlink():
                folders.remove(name)
                yield path, "a hidden folder" if name.startswith(".") else "a link to a folder"
        for name in files:
            path = Path(here, name)
            if path.suffix.lower() in SUFFIXES:
                yield path, OUTSIDE if _leads_outside(path, folder) else _why_not(path)
    for error in unread:
        yield Path(str(error.filename)), f"cannot be read: {error.strerror}"


def _leads_outside(file: Path, folder: Path) -> bool:
    """Return whether a file is a link out of the folder, which is not followed."""
    if is_from_anywhere() or not file.is_symlink():
        return False
    try:
        return not file.resolve().is_relative_to(folder.resolve())
    except (OSError, RuntimeError):  # RuntimeError: a loop of links
        return False


def _why_not(file: Path) -> str:
    """Return why a file is no design, or nothing where it may be one."""
    try:
        root = read_document(file).value
    except SpecError as error:
        return "" if _may_be_a_spec(file) else f"no spec: {error.findings[0].text}"
    if not isinstance(root, dict):
        return f"no spec: it is {said(root)}, not a mapping"
    others = [key for key in root if key != FIRST]
    if FIRST in root:
        is_alone = len(others) == 1 and others[0] in KINDS and not isinstance(root[others[0]], str)
        return f"a spec of kind {others[0]}, not a design" if is_alone else ""
    known = {key.casefold() for key in others}
    if get_close_matches(FIRST, known, cutoff=0.75) or len(known & DESIGN) > 1:
        return ""
    return f"no spec: its first key is '{others[0]}', not '{FIRST}'" if others else "no spec: empty"


def _may_be_a_spec(file: Path) -> bool:
    if not file.is_file():
        return True
    try:
        with file.open(encoding="utf-8", errors="replace") as stream:
            return LIKE_A_SPEC.search(stream.read(LOOKED_AT)) is not None
    except OSError:
        return True
