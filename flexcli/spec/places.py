"""Where the spec asks for each check of a result."""

from dataclasses import replace

from flexcli.results import Check, Place, Result
from flexcli.spec.document import Document, Position
from flexcli.spec.findings import path_text

__all__ = ["placed"]


def placed(result: Result, document: Document) -> Result:
    """Return a result whose checks know the lines of the spec that ask for them."""
    checks = tuple(
        check._replace(place=_place(check, document.position)) for check in result.checks
    )
    return replace(result, checks=checks)


def _place(check: Check, root: Position) -> Place | None:
    """Return where the last step of a check's path that the spec writes stands, if any does."""
    here, taken = root.closest(check.path)
    if not taken:
        return None
    return Place(here.file, here.key_line, here.key_column, path_text(taken))
