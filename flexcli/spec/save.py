"""Saving a spec with changed values as text: comments and order are kept.

Changed values are put in the place of the old ones in the text. Where that does not read as it
should (an alias, a value of several lines), the whole spec is written anew, without comments.
"""

import os
from collections.abc import Mapping
from datetime import date
from pathlib import Path
from typing import Any, NamedTuple

import yaml

from flexcli import __version__
from flexcli.errors import SpecError
from flexcli.spec.document import Document
from flexcli.spec.load import Loaded
from flexcli.spec.overrides import Place, at, with_value
from flexcli.spec.parse import parse_document
from flexcli.spec.references import TABLE_SUFFIXES

__all__ = ["spec_text"]

NOTE = "# sized by flexure "
"""How the comment starts that a sized design carries."""

MODELINE = "# yaml-language-server:"
"""What an editor looks for in the first line."""

_SafeLoader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def spec_text(spec: Loaded, folder: Path) -> str:
    """Return the text of a sized design, to be written to a folder and read by check.

    What the spec named stays named, with paths made to start at that folder; what it named and
    was changed is written out. A comment says which tool sized it, and when.
    """
    document = spec.document
    plain = parse_document(document.text, document.file).value
    changes = _changes(document, plain, Path(document.file).parent, folder)
    wanted = plain
    for place, value in changes.items():
        wanted = with_value(wanted, place, value)
    text = _edited(document.text, changes)
    if not _reads_as(text, wanted):
        text = yaml.safe_dump(wanted, sort_keys=False, allow_unicode=True, width=100)
    return _with_note(text, Path(document.file).name)


def _changes(document: Document, plain: Any, folder: Path, target: Path) -> dict[Place, Any]:
    """Return the values of the text that change, none of them inside another."""
    changes: dict[Place, Any] = {}
    for place, value in document.changed.items():
        here = _written_way(plain, place)
        changes[here] = value if here == place else at(document.value, here)
    for place in list(changes):
        above = next((place[:n] for n in range(len(place)) if place[:n] in changes), None)
        if above is not None:
            changes[above] = at(document.value, above)
            del changes[place]
    kept = {place: value for place, value in _leaves(plain) if place not in changes}
    moved = {place: _moved(value, folder, target) for place, value in {**kept, **changes}.items()}
    return {p: value for p, value in moved.items() if p in changes or value != kept[p]}


def _written_way(value: Any, place: Place) -> Place:
    """Return a place, or its nearest ancestor in the text, where the change is written."""
    for index, step in enumerate(place):
        known = dict(enumerate(value)) if isinstance(value, list) else value
        if not isinstance(known, dict) or step not in known:
            return place[: index + isinstance(known, dict)]
        value = known[step]
    return place


def _leaves(value: Any, place: Place = ()) -> list[tuple[Place, Any]]:
    if isinstance(value, dict):
        return [leaf for key, inner in value.items() for leaf in _leaves(inner, (*place, key))]
    if isinstance(value, list):
        inside = enumerate(value)
        return [leaf for index, inner in inside for leaf in _leaves(inner, (*place, index))]
    return [(place, value)]


def _moved(value: Any, folder: Path, target: Path) -> Any:
    """Return a value with the paths of spec files made relative to another folder."""
    if isinstance(value, dict):
        return {key: _moved(inner, folder, target) for key, inner in value.items()}
    if isinstance(value, list):
        return [_moved(inner, folder, target) for inner in value]
    is_file = isinstance(value, str) and value.endswith((".yaml", ".yml", *TABLE_SUFFIXES))
    if is_file and (folder / value).is_file():
        return Path(os.path.relpath(folder / value, target)).as_posix()
    return value


class _Edit(NamedTuple):
    """What takes the place of a stretch of the text."""

    start: int
    end: int
    text: str


def _edited(text: str, changes: Mapping[Place, Any]) -> str:
    """Return a text with values replaced where they stand, and new keys added to their mapping."""
    root = yaml.compose(text, Loader=_SafeLoader)
    edits = [_edit(text, root, place, value) for place, value in changes.items()]
    for edit in sorted(edits, reverse=True):
        text = text[: edit.start] + edit.text + text[edit.end :]
    return text


def _edit(text: str, node: yaml.Node | None, place: Place, value: Any) -> _Edit:
    for step in place:
        if isinstance(node, yaml.SequenceNode) and isinstance(step, int):
            node = node.value[step]
            continue
        assert isinstance(node, yaml.MappingNode)
        inner = next((inner for key, inner in node.value if key.value == step), None)
        if inner is None:
            return _added(text, node, f"{_flow(step)}: {_flow(value)}")
        node = inner
    assert node is not None
    return _Edit(node.start_mark.index, _end(text, node), _flow(value))


def _added(text: str, node: yaml.MappingNode, entry: str) -> _Edit:
    """Return the edit that adds an entry: first in braces, last in a block."""
    if node.flow_style:
        start = node.start_mark.index + 1
        return _Edit(start, start, f"{entry}, " if node.value else entry)
    end = _end(text, node)
    line_end = text.find("\n", end)
    end = len(text) if line_end < 0 else line_end
    end -= text[:end].endswith("\r")
    return _Edit(end, end, "\n" + " " * node.value[0][0].start_mark.column + entry)


def _end(text: str, node: yaml.Node) -> int:
    """Return where a value ends, without the comments and lines after it."""
    if isinstance(node, yaml.CollectionNode) and not node.flow_style and node.value:
        last = node.value[-1]
        return _end(text, last[1] if isinstance(last, tuple) else last)
    return len(text[: node.end_mark.index].rstrip())


def _flow(value: Any) -> str:
    """Return a value in one line, as it may stand in braces or after a key."""
    inside = yaml.safe_dump([value], default_flow_style=True, allow_unicode=True, width=10**9)
    return inside.strip()[1:-1]


def _reads_as(text: str, wanted: Any) -> bool:
    try:
        read = parse_document(text, "")
    except SpecError:
        return False
    return bool(read.value == wanted) and not read.findings


def _with_note(text: str, name: str) -> str:
    """Return a text whose head says which tool sized it, when, and from what."""
    lines = [line for line in text.splitlines(keepends=True) if not line.startswith(NOTE)]
    place = 1 if lines and lines[0].startswith((MODELINE, "%")) else 0
    lines.insert(place, f"{NOTE}{__version__} on {date.today().isoformat()}, from {name}\n")
    return "".join(lines)
