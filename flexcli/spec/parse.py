"""YAML text to plain values and, beside them, a tree of positions.

A spec may come from a stranger's pull request, so depth and the expansion of aliases are bounded
while it is read, and tags build nothing. PyYAML lets the last of two equal keys win; here they are
findings.
"""

import re
from collections.abc import Iterator
from typing import Any, NamedTuple, NoReturn

import yaml

from flexcli.errors import Finding, SpecError
from flexcli.spec.document import MAX_FINDINGS, Document, Position, finding_at
from flexcli.spec.scalar import scalar_value
from flexcli.spec.syntax import explain

__all__ = ["parse_document"]

MAX_DEPTH = 40
MAX_NODES = 100_000
"""Some 20 000 points of a profile."""

_SafeLoader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)

_LINE_BREAK = re.compile("\r\n|[\n\r\x85\u2028\u2029]")
_NOT_TEXT = "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f\ud800-\udfff\ufeff\ufffe\uffff]"
"""What YAML does not allow in a file, and a byte order mark in its middle; nothing printable."""


def parse_document(text: str, file: str) -> Document:
    """Parse YAML text into a :class:`Document`, or raise :class:`SpecError` if it is not YAML.

    Mistakes that leave the rest of the text readable, such as equal keys, stay in the document
    beside its values, so that one pass reports them together with what is wrong in the values.
    """
    return _Reader(text, file).document()


class _Node(NamedTuple):
    """A value, its positions, and its size and depth, which limit aliases to it."""

    value: Any
    position: Position
    size: int
    height: int


class _Reader:
    """Builds values and positions from the events of the parser, collecting findings."""

    def __init__(self, text: str, file: str) -> None:
        self.text = text
        self.file = file
        self.lines = {file: _LINE_BREAK.split(text)}
        self.events: Iterator[Any] = yaml.parse(text, Loader=_SafeLoader)
        self.findings: list[Finding] = []
        self.anchors: dict[str, _Node | None] = {}
        self.brackets: list[Any] = []
        self.size = 0
        self.depth = 0

    def document(self) -> Document:
        """Return the one document of the text."""
        is_plain = all(map(str.isprintable, self.lines[self.file]))
        # looked for only where it may be: the pattern costs more than most specs
        strange = None if is_plain else re.search(_NOT_TEXT, self.text)
        if strange is not None:
            before = _LINE_BREAK.split(self.text[: strange.start()])
            place = self._position(len(before) - 1, len(before[-1]))
            text = f"the character U+{ord(strange.group()):04X} has no place in a text"
            self._give_up(place, "", text, "delete it")
        try:
            next(self.events)  # the start of the stream
            if isinstance(next(self.events), yaml.StreamEndEvent):
                self._give_up(self._position(0, 0), "", "is empty", "start it with flexure: 1")
            node = self._node(next(self.events), "", None)
            next(self.events)  # the end of the document
            event = next(self.events)
            if not isinstance(event, yaml.StreamEndEvent):
                place = self._at(event.start_mark)
                self._give_up(place, "", "a second document starts here", "keep one in a file")
        except yaml.YAMLError as error:
            self._not_yaml(error)
        findings = tuple(self.findings)
        return Document(self.file, node.value, node.position, self.lines, findings, self.text)

    def _position(self, line: int, column: int) -> Position:
        return Position(self.file, line + 1, column + 1, line + 1, column + 1, {})

    def _at(self, mark: Any) -> Position:
        return self._position(mark.line, mark.column)

    def _find(self, place: Position, path: str, text: str, hint: str) -> None:
        self.findings.append(finding_at(place, self.lines, path, text, hint))
        if len(self.findings) == MAX_FINDINGS:
            more = Finding(self.file, "the rest is not read", "mend the findings above first")
            raise SpecError([*self.findings, more])

    def _give_up(self, place: Position, path: str, text: str, hint: str) -> NoReturn:
        self._find(place, path, text, hint)
        raise SpecError(self.findings)

    def _node(self, event: Any, path: str, key: Any) -> _Node:
        """Return the node that starts with an event, reading on to its end."""
        mark, key_mark = event.start_mark, (key or event).start_mark
        children: dict[str | int, Position] = {}
        place = Position(
            self.file,
            mark.line + 1,
            mark.column + 1,
            key_mark.line + 1,
            key_mark.column + 1,
            children,
        )
        if isinstance(event, yaml.AliasEvent):
            return self._alias(event, path, place)
        before = self.size
        self._grow(1, 1, place)
        if event.anchor is not None:
            self.anchors[event.anchor] = None
        if event.tag is not None:
            tag = event.tag.replace("tag:yaml.org,2002:", "!!")
            text = f"the tag '{tag}' is not allowed: a spec holds plain values"
            self._find(place, path, text, "take the tag out")
        value, height = None, 0
        if isinstance(event, yaml.ScalarEvent):
            value = scalar_value(event.value, event.style) if event.tag is None else None
        else:
            value, height = self._collection(event, path, children)
        node = _Node(value, place, self.size - before, height + 1)
        if event.anchor is not None:
            self.anchors[event.anchor] = node
        return node

    def _alias(self, event: Any, path: str, place: Position) -> _Node:
        node = self.anchors.get(event.anchor)
        if node is None:
            inside = event.anchor in self.anchors
            why = "stands inside what it names" if inside else "names nothing above it"
            self._find(place, path, f"the alias '*{event.anchor}' {why}", "write the value out")
            return _Node(None, place, 1, 1)
        self._grow(node.size, node.height, place)
        place.children.update(node.position.children)
        return node._replace(position=place)

    def _grow(self, size: int, height: int, place: Position) -> None:
        """Count nodes and levels, aliases unfolded, and refuse what no spec needs."""
        self.size += size
        if self.depth + height > MAX_DEPTH:
            self._too_deep(place)
        if self.size > MAX_NODES:
            text = f"holds more than {MAX_NODES} values, aliases unfolded"
            self._give_up(place, "", text, "no spec is that long")

    def _too_deep(self, place: Position) -> NoReturn:
        text = f"is nested deeper than {MAX_DEPTH} levels"
        self._give_up(place, "", text, "no spec is that deep")

    def _collection(
        self, event: Any, path: str, children: dict[str | int, Position]
    ) -> tuple[Any, int]:
        self.depth += 1
        if event.flow_style:
            self.brackets.append(event.start_mark)
        is_mapping = isinstance(event, yaml.MappingStartEvent)
        built = (self._mapping if is_mapping else self._sequence)(path, children)
        if event.flow_style:
            self.brackets.pop()
        self.depth -= 1
        return built

    def _sequence(self, path: str, children: dict[str | int, Position]) -> tuple[list[Any], int]:
        items: list[Any] = []
        height = 0
        while not isinstance(event := next(self.events), yaml.SequenceEndEvent):
            index = len(items)
            node = self._node(event, f"{path}[{index}]", None)
            items.append(node.value)
            children[index] = node.position
            height = max(height, node.height)
        return items, height

    def _mapping(
        self, path: str, children: dict[str | int, Position]
    ) -> tuple[dict[str, Any], int]:
        mapping: dict[str, Any] = {}
        height = 0
        while not isinstance(event := next(self.events), yaml.MappingEndEvent):
            key = self._key(event, path)
            inner = path if key is None else f"{path}.{key}" if path else key
            known = len(self.findings)
            node = self._node(next(self.events), inner, event)
            height = max(height, node.height)
            if key is None:
                continue
            if key in mapping:
                first = children[key].key_line
                text = f"'{key}' is given twice; the first is on line {first}"
                self._find(self._at(event.start_mark), inner, text, "keep one of them")
                continue
            mapping[key], children[key] = node.value, node.position
            if node.value is None and len(self.findings) == known:
                text = f"'{key}' has no value"
                self._find(
                    self._at(event.start_mark), inner, text, "give it one, or take the key out"
                )
        return mapping, height

    def _key(self, event: Any, path: str) -> str | None:
        """Return the name that a key is, or nothing, with a finding, when it is something else."""
        place = self._at(event.start_mark)
        if not isinstance(event, yaml.ScalarEvent) or event.tag is not None:
            self._find(place, path, "this key is not a plain name", "write 'name: value'")
            if not isinstance(event, yaml.ScalarEvent):
                self._node(event, path, None)
            return None
        self._grow(1, 1, place)
        if event.value == "<<":
            self._find(place, path, "merge keys are not allowed", "write the keys out")
            return None
        if event.anchor is not None:
            self.anchors[event.anchor] = _Node(event.value, place, 1, 1)
        return str(event.value)

    def _not_yaml(self, error: yaml.YAMLError) -> NoReturn:
        """Raise what broke the syntax, and the findings before it."""
        if not isinstance(error, yaml.MarkedYAMLError):
            self._give_up(self._position(0, 0), "", "is not valid YAML", "save it as UTF-8 text")
        mark = error.problem_mark or error.context_mark
        # libyaml scans brackets far ahead, and gives up at a depth of its own
        ahead = self.text[: mark.index] if mark is not None else ""
        if sum(map(ahead.count, "[{")) - sum(map(ahead.count, "]}")) > MAX_DEPTH:
            self._too_deep(self._at(mark))
        bracket = self.brackets[-1] if self.brackets else None
        mark, text, hint = explain(error, self.text, self.lines[self.file], bracket)
        self._give_up(self._at(mark), "", text, hint)
