"""From a spec file to its validated part: read, resolve references, validate, cross-check."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter, ValidationError

from flexcli.errors import Finding, SpecError
from flexcli.parts.asd import ASDProfile
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import AnyGeometry
from flexcli.parts.material import Material
from flexcli.parts.stroke import Stroke
from flexcli.spec.document import Document, Position, finding_at, read_document
from flexcli.spec.findings import findings_of, nearest, path_text
from flexcli.spec.shipped import shipped_names, shipped_path

__all__ = ["KINDS", "Loaded", "load", "load_design", "load_shipped"]

FORMAT = 1
KINDS: dict[str, Any] = {
    "material": Material,
    "stroke": Stroke,
    "asd": ASDProfile,
    "geometry": AnyGeometry,
}
"""Specs that may stand in a file of their own, and what each must be."""

_REFERENCES = {
    ("material",): "material",
    ("geometry",): "geometry",
    ("stroke",): "stroke",
    ("asd", "profile"): "asd",
    ("cases", "*", "stroke"): "stroke",
    ("cases", "*", "asd", "profile"): "asd",
}
"""Where a design may name a spec instead of holding it."""


@dataclass(frozen=True)
class Loaded:
    """A validated spec, the kind of spec it is, and the document that it came from."""

    kind: str
    part: Any
    document: Document


def load_design(path: Path) -> tuple[DesignSpec, Document]:
    """Read a design, or raise :class:`SpecError` with every finding."""
    loaded = load(path)
    if loaded.kind != "design":
        raise SpecError(
            [
                Finding(
                    str(path),
                    f"is a {loaded.kind}, not a design",
                    "name it in a design: flexure, material, geometry, cases, requirements",
                )
            ]
        )
    return loaded.part, loaded.document


def load(path: Path) -> Loaded:
    """Read and validate a spec of any kind."""
    document = read_document(path)
    root = _checked_root(document)
    own = [kind for kind in KINDS if kind in root and isinstance(root[kind], dict)]
    if set(root) <= {"flexure", *KINDS} and len(own) == 1 and len(root) == 1 + ("flexure" in root):
        kind = own[0]
        part = _validated(KINDS[kind], root[kind], document.position.children[kind], document, kind)
        return Loaded(kind, part, document)
    document = _resolved(document, path.parent)
    design = _validated(DesignSpec, document.value, document.position, document, "")
    _refuse_problems(design, document)
    return Loaded("design", design, document)


def load_shipped(kind: str, name: str) -> Any:
    """Return a shipped spec by its name, or raise :class:`SpecError`."""
    path = shipped_path(kind, name)
    if path is None:
        text = f"there is no shipped {kind} of this name"
        raise SpecError([Finding(name, text, nearest(name, shipped_names(kind)))])
    return load(path).part


def _checked_root(document: Document) -> dict[str, Any]:
    root, position = document.value, document.position
    if not isinstance(root, dict):
        raise SpecError(
            [
                finding_at(
                    position, document.lines, "", "a spec is a mapping", "start with flexure: 1"
                )
            ]
        )
    version = root.get("flexure")
    if "flexure" not in root:
        text, hint = "'flexure' is missing", f"start the file with flexure: {FORMAT}"
        raise SpecError([finding_at(position, document.lines, "", text, hint)])
    if version != FORMAT or isinstance(version, bool):
        place = position.children["flexure"]
        text = f"version {version} of the format is not known"
        raise SpecError([finding_at(place, document.lines, "flexure", text, f"write {FORMAT}")])
    return root


def _validated(model: Any, value: Any, position: Position, document: Document, prefix: str) -> Any:
    try:
        return TypeAdapter(model).validate_python(value)
    except ValidationError as error:
        findings = findings_of(error, model, position, document.lines)
        if prefix:
            findings = [replace(f, path=f"{prefix}.{f.path}".rstrip(".")) for f in findings]
        raise SpecError(findings) from error


def _refuse_problems(design: DesignSpec, document: Document) -> None:
    findings = []
    for problem in design.problems():
        place, path = document.position.closest(_as_written(problem.path, document))
        findings.append(
            finding_at(place, document.lines, path_text(path), problem.text, problem.hint)
        )
    if findings:
        raise SpecError(findings)


def _as_written(path: tuple[str | int, ...], document: Document) -> tuple[str | int, ...]:
    """Return a path below ``cases`` as it stands in a spec whose single case is at the top."""
    return path[2:] if path[0] == "cases" and "cases" not in document.value else path


def _resolved(document: Document, folder: Path) -> Document:
    """Put the specs that a design names in the place of their names, positions included."""
    findings: list[Finding] = []
    lines = dict(document.lines)
    value, position = document.value, document.position
    for pattern, kind in _REFERENCES.items():
        for path in _matches(value, pattern):
            place, _ = position.closest(path)
            name = _at(value, path)
            if not isinstance(name, str):
                continue
            try:
                target, target_position, target_lines = _referenced(kind, name, folder)
            except SpecError as error:
                findings.extend(
                    f if f.line else finding_at(place, lines, path_text(path), f.text, f.hint)
                    for f in error.findings
                )
                # an empty part keeps the rest of the pass going; its findings are dropped below
                continue
            lines.update(target_lines)
            value = _with(value, path, target)
            position = _with_position(position, path, target_position)
    if findings:
        findings.extend(_other_findings(value, position, lines, {f.path for f in findings}))
        raise SpecError(findings)
    return Document(document.file, value, position, lines)


def _other_findings(
    value: Any, position: Position, lines: dict[str, list[str]], unresolved: set[str]
) -> list[Finding]:
    """Return what else is wrong with a design some of whose references do not resolve."""
    try:
        TypeAdapter(DesignSpec).validate_python(value)
    except ValidationError as error:
        found = findings_of(error, DesignSpec, position, lines)
        return [f for f in found if f.path not in unresolved]
    return []


def _referenced(kind: str, name: str, folder: Path) -> tuple[Any, Position, dict[str, list[str]]]:
    """Return the value, positions and lines of a spec named or given by its path."""
    is_path = name.endswith((".yaml", ".yml"))
    path = folder / name if is_path else shipped_path(kind, name)
    if path is None:
        raise SpecError(
            [
                Finding(
                    "",
                    f"there is no shipped {kind} '{name}'",
                    nearest(name, shipped_names(kind)) + "; a path ends in .yaml",
                )
            ]
        )
    if not path.is_file():
        raise SpecError(
            [Finding("", f"there is no file {path}", "paths start at the spec's folder")]
        )
    document = read_document(path)
    root = _checked_root(document)
    if set(root) != {"flexure", kind}:
        text = f"a file referred to as {kind} holds 'flexure' and '{kind}' alone"
        others = ", ".join(k for k in root if k != "flexure")
        raise SpecError(
            [finding_at(document.position, document.lines, "", text, f"it holds {others}")]
        )
    return root[kind], document.position.children[kind], document.lines


def _matches(value: Any, pattern: tuple[str, ...]) -> list[tuple[str, ...]]:
    """Return the paths in a value that a pattern with wildcards names."""
    if not pattern:
        return [()]
    if not isinstance(value, dict):
        return []
    keys = list(value) if pattern[0] == "*" else [pattern[0]] if pattern[0] in value else []
    return [(key, *rest) for key in keys for rest in _matches(value[key], pattern[1:])]


def _at(value: Any, path: tuple[str, ...]) -> Any:
    for step in path:
        value = value[step]
    return value


def _with(value: Any, path: tuple[str, ...], new: Any) -> Any:
    if not path:
        return new
    return {**value, path[0]: _with(value[path[0]], path[1:], new)}


def _with_position(position: Position, path: tuple[str, ...], new: Position) -> Position:
    if not path:
        return new
    inner = _with_position(position.children[path[0]], path[1:], new)
    return replace(position, children={**position.children, path[0]: inner})
