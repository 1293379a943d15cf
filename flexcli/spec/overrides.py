"""Values put over those of a spec, as ``--set geometry.h=0.2mm`` states them."""

import re
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple, TypeAlias

from flexcli.errors import SpecError
from flexcli.spec.document import Document, Position, finding_at
from flexcli.spec.findings import path_text
from flexcli.spec.parse import parse_document

__all__ = [
    "Override",
    "Place",
    "at",
    "overridden",
    "overrides_of",
    "refuse_waiting",
    "with_position",
    "with_value",
]

FILE = "--set"
"""The file that findings about an override name; each override is one line of it."""

_STEP = re.compile(r"\[([0-9]+)\]|([^.\[\]]+)")

Place: TypeAlias = tuple[str | int, ...]


class Override(NamedTuple):
    """A value, the path in the spec where it belongs, where it was stated, all of the lines."""

    path: Place
    value: Any
    position: Position
    lines: list[str]


def overrides_of(given: Mapping[Any, Any]) -> list[Override]:
    """Return overrides; a text stated by a path with dots is read as the YAML that it would be.

    Raises :class:`SpecError` where such a text is no YAML.
    """
    names = [name if isinstance(name, str) else path_text(name) for name in given]
    lines = [f"{name}={stated}" for name, stated in zip(names, given.values(), strict=True)]
    found = []
    for number, (place, stated) in enumerate(given.items(), start=1):
        position = Position(FILE, number, len(names[number - 1]) + 2, number, 1, {})
        if not isinstance(place, str):
            found.append(Override(place, stated, position, lines))
            continue
        value = _read(stated, position, lines) if isinstance(stated, str) else stated
        path = tuple(int(index) if index else word for index, word in _STEP.findall(place))
        if not path or value is None:
            text = "a value is missing" if path else "a path is missing"
            hint = "write e.g. geometry.h=0.2mm"
            raise SpecError([finding_at(position, {FILE: lines}, "", text, hint)])
        found.append(Override(path, value, position, lines))
    return found


def _read(text: str, position: Position, lines: list[str]) -> Any:
    """Return a text as the YAML that it is, its positions beside that of the whole."""
    if not text.strip():
        return None
    # as it stands in its line, so that what is found in it is pointed at
    padding = "\n" * (position.line - 1) + " " * (position.column - 1)
    try:
        read = parse_document(padding + text, FILE)
    except SpecError as error:
        shown = [f._replace(source_line=lines[f.line - 1]) for f in error.findings]
        raise SpecError(shown) from error
    position.children.update(read.position.children)
    return read.value


def overridden(
    document: Document, overrides: Iterable[Override]
) -> tuple[Document, list[Override]]:
    """Return a document with values put in, and the overrides whose path leads through no mapping.

    Such a path may lead through the name of another spec, and become valid once that is read.
    """
    value, position, lines = document.value, document.position, document.lines
    changed = dict(document.changed)
    waiting = []
    for override in overrides:
        lines = {**lines, FILE: override.lines}
        if _open_way(value, override.path) != override.path:
            waiting.append(override)
            continue
        value = with_value(value, override.path, override.value)
        position = with_position(position, override.path, override.position)
        changed[override.path] = override.value
    found = document._replace(value=value, position=position, lines=lines, changed=changed)
    return found, waiting


def refuse_waiting(document: Document, waiting: Iterable[Override]) -> Document:
    """Return a document with a finding for each override that leads nowhere."""
    findings = []
    for override in waiting:
        path, here = path_text(override.path), _open_way(document.value, override.path)
        text = (
            f"there is no such place: '{path_text(here)}' holds {_said(at(document.value, here))}"
        )
        hint = f"set {path_text(here)} as a whole" if here else "a spec is a mapping"
        findings.append(
            finding_at(override.position, document.lines, path, text, hint, at_key=True)
        )
    return document._replace(findings=(*document.findings, *findings))


def at(value: Any, path: Place) -> Any:
    """Return the value at a path of a value."""
    for step in path:
        value = value[step]
    return value


def with_value(value: Any, path: Place, new: Any) -> Any:
    """Return a value with the one at a path replaced or, in a mapping, added."""
    if not path:
        return new
    first, rest = path[0], path[1:]
    if isinstance(value, list) and isinstance(first, int):
        return [*value[:first], with_value(value[first], rest, new), *value[first + 1 :]]
    inner = value or {}
    return {**inner, first: with_value(inner.get(first), rest, new)}


def with_position(position: Position, path: Place, new: Position) -> Position:
    """Return a position with the one at a path below it replaced or added."""
    if not path:
        return new
    below = position.children.get(path[0], new._replace(children={}))
    inner = with_position(below, path[1:], new)
    return position._replace(children={**position.children, path[0]: inner})


def _open_way(value: Any, path: Place) -> Place:
    """Return a path as far as it leads through mappings, lists and what is not there yet."""
    for index, step in enumerate(path):
        if value is None:
            return path
        known = value if isinstance(value, dict) and isinstance(step, str) else None
        if isinstance(value, list) and isinstance(step, int):
            known = dict(enumerate(value))
            if step not in known:
                return path[:index]
        if known is None:
            return path[:index]
        value = known.get(step)
    return path


def _said(value: Any) -> str:
    return f"{len(value)} items" if isinstance(value, list) else f"'{value}'"
