"""A YAML file as read: plain values, where each stands, and findings that point there."""

from collections.abc import Mapping
from typing import Any, NamedTuple

from flexcli.errors import Finding, printable

__all__ = ["Document", "Position", "finding_at"]

MAX_FINDINGS = 100
MAX_SHOWN = 500


class Position(NamedTuple):
    """Where a value stands, and where the values inside it stand."""

    file: str
    line: int
    column: int
    key_line: int
    key_column: int
    children: dict[str | int, "Position"]

    def closest(self, path: tuple[str | int, ...]) -> tuple["Position", tuple[str | int, ...]]:
        """Return the deepest position on a path and the steps of the path that exist.

        Steps that the tree does not hold are passed over: pydantic's ``loc`` also names the
        tags of unions and the wrappers of validators.
        """
        here, taken = self, []
        for step in path:
            if step in here.children:
                here = here.children[step]
                taken.append(step)
        return here, tuple(taken)


class Document(NamedTuple):
    """The plain values of a YAML file, its positions and lines, and what is wrong so far.

    ``text`` is that of the file; ``changed`` holds the values put in since it was read, by path.
    """

    file: str
    value: Any
    position: Position
    lines: dict[str, list[str]]
    findings: tuple[Finding, ...] = ()
    text: str = ""
    changed: Mapping[tuple[str | int, ...], Any] = {}


def finding_at(
    position: Position,
    lines: dict[str, list[str]],
    path: str,
    text: str,
    hint: str = "",
    *,
    at_key: bool = False,
) -> Finding:
    """Return a finding that points at a value, or at its key, with the line of the file."""
    line = position.key_line if at_key else position.line
    column = position.key_column if at_key else position.column
    rows = lines.get(position.file, [])
    source = rows[line - 1] if 0 < line <= len(rows) else ""
    if len(source) > MAX_SHOWN:
        source = ""
    return Finding(
        position.file,
        printable(text),
        printable(hint),
        printable(path),
        line,
        column,
        printable(source),
    )
