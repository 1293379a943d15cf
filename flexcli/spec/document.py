"""YAML text to plain values and, beside them, a tree of positions.

YAML 1.1 as PyYAML reads it turns ``no`` into false, ``010`` into 8, ``1:30`` into 90, leaves
``1e-3`` a text and lets the last of two equal keys win. Here scalars follow the core schema of
YAML 1.2 and equal keys are findings. A spec may come from a stranger's pull request, so size,
depth and the expansion of aliases are bounded before anything is built.
"""

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import yaml

from flexcli.errors import Finding, SpecError

__all__ = ["Document", "Position", "finding_at", "read_document"]

MAX_BYTES = 1_000_000
MAX_DEPTH = 40
MAX_NODES = 50_000

_SafeLoader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)

_NULL = re.compile(r"~|null|Null|NULL|")
_TRUE = re.compile(r"true|True|TRUE")
_FALSE = re.compile(r"false|False|FALSE")
_INT = re.compile(r"[-+]?[0-9]{1,300}")
_FLOAT = re.compile(r"[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?")
_SPECIAL_FLOAT = re.compile(r"[-+]?\.(?:inf|Inf|INF)|\.(?:nan|NaN|NAN)")


@dataclass(frozen=True)
class Position:
    """Where a value stands, and where the values inside it stand."""

    file: str
    line: int
    column: int
    key_line: int
    key_column: int
    children: dict[str | int, "Position"] = field(default_factory=dict)

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


@dataclass(frozen=True)
class Document:
    """The plain values of a YAML file, its positions and its lines."""

    file: str
    value: Any
    position: Position
    lines: dict[str, list[str]]


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
    return Finding(position.file, text, hint, path, line, column, source)


def read_document(path: Path, name: str | None = None) -> Document:
    """Read a YAML file, or raise :class:`SpecError` with what is wrong with it."""
    file = name or str(path)
    try:
        if not path.is_file():
            reason = "is a folder" if path.is_dir() else "there is no such file"
            raise SpecError([Finding(file, reason, "give the path of a YAML file")])
        with path.open("rb") as stream:
            raw = stream.read(MAX_BYTES + 1)
    except OSError as error:
        raise SpecError([Finding(file, f"cannot be read: {error.strerror}")]) from error
    if len(raw) > MAX_BYTES:
        raise SpecError([Finding(file, f"is larger than {MAX_BYTES} bytes, too large for a spec")])
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = raw[: error.start].count(b"\n") + 1
        raise SpecError(
            [Finding(file, "is not UTF-8 text", "save it as UTF-8", line=line, column=1)]
        ) from error
    return parse_document(text, file)


def parse_document(text: str, file: str) -> Document:
    """Parse YAML text into a :class:`Document`, or raise :class:`SpecError`."""
    lines = {file: text.splitlines()}
    builder = _Builder(file, lines)
    try:
        _bound_nesting(text, file)
        node = yaml.compose(text, Loader=_SafeLoader)
        if node is None:
            raise SpecError([Finding(file, "is empty", "a spec starts with 'flexure: 1'")])
        value, position = builder.build(node, "", None)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line, column = (mark.line + 1, mark.column + 1) if mark else (0, 0)
        rows = lines[file]
        source = rows[line - 1] if 0 < line <= len(rows) else ""
        context = f" ({error.context})" if error.context else ""
        raise SpecError(
            [
                Finding(
                    file,
                    f"is not valid YAML: {error.problem}{context}",
                    "",
                    "",
                    line,
                    column,
                    source,
                )
            ]
        ) from error
    except yaml.YAMLError as error:
        raise SpecError([Finding(file, f"is not valid YAML: {error}")]) from error
    if builder.findings:
        raise SpecError(builder.findings)
    return Document(file, value, position, lines)


def _bound_nesting(text: str, file: str) -> None:
    """Refuse deep nesting before the recursive composer meets it."""
    depth = 0
    for event in yaml.parse(text, Loader=_SafeLoader):
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            if depth > MAX_DEPTH:
                mark = event.start_mark
                raise SpecError(
                    [
                        Finding(
                            file,
                            f"is nested deeper than {MAX_DEPTH} levels",
                            line=mark.line + 1,
                            column=mark.column + 1,
                        )
                    ]
                )
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1


class _Builder:
    """Builds values and positions from composed nodes, collecting findings on the way."""

    def __init__(self, file: str, lines: dict[str, list[str]]) -> None:
        self.file = file
        self.lines = lines
        self.findings: list[Finding] = []
        self.nodes = 0
        self.depth = 0

    def build(self, node: yaml.Node, path: str, key: yaml.Node | None) -> tuple[Any, Position]:
        """Return the plain value of a node and its position tree."""
        self.depth += 1
        try:
            return self._build(node, path, key)
        finally:
            self.depth -= 1

    def _build(self, node: yaml.Node, path: str, key: yaml.Node | None) -> tuple[Any, Position]:
        self.nodes += 1
        mark, key_mark = node.start_mark, (key or node).start_mark
        children: dict[str | int, Position] = {}
        position = Position(
            self.file,
            mark.line + 1,
            mark.column + 1,
            key_mark.line + 1,
            key_mark.column + 1,
            children,
        )
        if self.nodes > MAX_NODES or self.depth > MAX_DEPTH:  # aliases grow without end
            text = "unfolds, by its aliases, to more than a spec may hold"
            raise SpecError([finding_at(position, self.lines, path, text, "write it out")])
        if not node.tag.startswith("tag:yaml.org,2002:") or node.tag.count("/"):
            text = f"the tag '{node.tag}' is not allowed"
            self.findings.append(finding_at(position, self.lines, path, text, "remove it"))
            return None, position
        if isinstance(node, yaml.MappingNode):
            return self._mapping(node, path, children), position
        if isinstance(node, yaml.SequenceNode):
            items = []
            for index, item in enumerate(node.value):
                value, child = self.build(item, f"{path}[{index}]", None)
                items.append(value)
                children[index] = child
            return items, position
        return _scalar(node), position

    def _mapping(
        self, node: yaml.MappingNode, path: str, children: dict[str | int, Position]
    ) -> dict[str, Any]:
        mapping: dict[str, Any] = {}
        for key_node, value_node in node.value:
            key = key_node.value if isinstance(key_node, yaml.ScalarNode) else None
            mark = key_node.start_mark
            at = Position(self.file, mark.line + 1, mark.column + 1, mark.line + 1, mark.column + 1)
            if not isinstance(key, str) or key == "<<":
                self.findings.append(
                    finding_at(at, self.lines, path, "this key is not a plain name", "use a name")
                )
                continue
            inner = f"{path}.{key}" if path else key
            if key in mapping:
                first = children[key]
                self.findings.append(
                    finding_at(
                        at,
                        self.lines,
                        inner,
                        f"'{key}' is given twice; the first is on line {first.key_line}",
                        "keep one of them",
                    )
                )
                continue
            mapping[key], children[key] = self.build(value_node, inner, key_node)
        return mapping


def _scalar(node: yaml.Node) -> Any:
    """Return the value of a scalar by the core schema of YAML 1.2."""
    text: str = node.value
    if node.style in ("'", '"', "|", ">"):
        return text
    if _NULL.fullmatch(text):
        return None
    if _TRUE.fullmatch(text):
        return True
    if _FALSE.fullmatch(text):
        return False
    if _INT.fullmatch(text):
        return int(text)
    if _FLOAT.fullmatch(text):
        return float(text)
    if _SPECIAL_FLOAT.fullmatch(text):
        return float(text.replace(".", "", 1))
    return text
