"""From a spec file to its validated part: read, resolve references, validate, cross-check."""

from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from pydantic import TypeAdapter, ValidationError

from flexcli.errors import Finding, SpecError
from flexcli.parts.asd import ASDProfile
from flexcli.parts.base import said
from flexcli.parts.design import CASE_KEYS, DesignSpec
from flexcli.parts.geometries import AnyGeometry
from flexcli.parts.material import Material
from flexcli.parts.stroke import Stroke
from flexcli.spec.document import Document, Position, finding_at
from flexcli.spec.findings import findings_of, nearest, path_text
from flexcli.spec.read import read_document
from flexcli.spec.shipped import shipped_names, shipped_path

__all__ = ["KINDS", "Loaded", "load", "load_design", "load_shipped"]

FORMAT = 1
SUFFIXES = (".yaml", ".yml")
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
    ("balance", "asd", "profile"): "asd",
    ("stops", "contact", "material"): "material",
}
"""Where a design may name a spec instead of holding it."""

_VERSION = f"flexure: {FORMAT}"


class Loaded(NamedTuple):
    """A validated spec, the kind of spec it is, and the document that it came from."""

    kind: str
    part: Any
    document: Document


def load_design(path: Path) -> tuple[DesignSpec, Document]:
    """Read a design, or raise :class:`SpecError` with every finding."""
    loaded = load(path)
    if loaded.kind != "design":
        text = f"is a spec of kind {loaded.kind}, not a design"
        hint = "name it in a design: flexure, material, geometry, cases, requirements"
        raise SpecError([Finding(str(path), text, hint)])
    return loaded.part, loaded.document


def load(path: Path) -> Loaded:
    """Read and validate a spec of any kind, or raise :class:`SpecError` with every finding."""
    document = read_document(path)
    root = _checked_root(document)
    kind = _own_kind(root)
    if kind is not None:
        part, findings = _validated(kind, root[kind], document, (kind,))
        if "flexure" not in root:
            findings.append(_no_version(document))
    else:
        document, unresolved = _resolved(document, path.parent)
        part, findings = _validated("design", document.value, document)
        findings = [f for f in findings if f.path not in unresolved]
    if document.findings or findings:
        raise SpecError(_each_once([*document.findings, *findings]))
    if kind is None:
        _refuse_problems(part, document)
    return Loaded(kind or "design", part, document)


def load_shipped(kind: str, name: str) -> Any:
    """Return a shipped spec by its name, or raise :class:`SpecError`."""
    path = shipped_path(kind, name)
    if path is None:
        text = f"there is no shipped {kind} of this name"
        raise SpecError([Finding(name, text, nearest(name, shipped_names(kind)))])
    return load(path).part


def _checked_root(document: Document) -> dict[str, Any]:
    """Return the mapping that a spec is, or raise what makes the rest of it meaningless."""
    root, position = document.value, document.position

    def refuse(place: Position, path: str, text: str, hint: str) -> NoReturn:
        finding = finding_at(place, document.lines, path, text, hint)
        raise SpecError([*document.findings, finding])

    if not isinstance(root, dict):
        refuse(position, "", f"a spec is a mapping, not {said(root)}", f"start with {_VERSION}")
    if "flexure" in root:
        version = root["flexure"]
        if version != FORMAT or not isinstance(version, int) or isinstance(version, bool):
            place = position.children["flexure"]
            refuse(
                place,
                "flexure",
                f"{said(version)} is no version of the format",
                f"write {_VERSION}",
            )
    elif not set(root) & {*KINDS, *DesignSpec.model_fields, *CASE_KEYS}:
        raise SpecError([*document.findings, _no_version(document)])
    return root


def _no_version(document: Document) -> Finding:
    text, hint = "'flexure' is missing", f"add '{_VERSION}'"
    return finding_at(document.position, document.lines, "", text, hint)


def _own_kind(root: dict[str, Any]) -> str | None:
    """Return the kind of a spec that stands alone in its file, or nothing for a design."""
    keys = set(root) - {"flexure"}
    return next((k for k in KINDS if keys == {k} and not isinstance(root[k], str)), None)


@cache
def _adapter(kind: str) -> TypeAdapter[Any]:
    return TypeAdapter(DesignSpec if kind == "design" else KINDS[kind])


def _validated(
    kind: str, value: Any, document: Document, below: tuple[str, ...] = ()
) -> tuple[Any, list[Finding]]:
    """Return the validated part, or nothing and what is wrong beyond what reading found."""
    try:
        return _adapter(kind).validate_python(value), []
    except ValidationError as error:
        model = DesignSpec if kind == "design" else KINDS[kind]
        found = findings_of(error, model, document, below)
        known = {(f.file, f.line, f.path) for f in document.findings}
        return None, [f for f in found if (f.file, f.line, f.path) not in known]


def _each_once(findings: list[Finding]) -> list[Finding]:
    """Leave out what is said already, as when two cases name the same file."""
    return list({(f.file, f.line, f.column, f.text): f for f in reversed(findings)}.values())


def _refuse_problems(design: DesignSpec, document: Document) -> None:
    findings = []
    for problem in design.problems():
        written = _as_written(problem.path, document)
        place, path = document.position.closest(written)
        is_missing = isinstance(written[-1], str) and written != path
        findings.append(
            finding_at(
                place,
                document.lines,
                path_text(path),
                problem.text,
                problem.hint,
                at_key=bool(path) and (is_missing or bool(place.children)),
            )
        )
    if findings:
        raise SpecError(findings)


def _as_written(path: tuple[str | int, ...], document: Document) -> tuple[str | int, ...]:
    """Return a path below ``cases`` as it stands in a spec whose single case is at the top."""
    return path[2:] if path[0] == "cases" and "cases" not in document.value else path


def _resolved(document: Document, folder: Path) -> tuple[Document, set[str]]:
    """Put the specs that a design names in the place of their names, positions included.

    Also returns the paths of the names that lead nowhere, for which there are findings.
    """
    findings = list(document.findings)
    unresolved: set[str] = set()
    known: dict[tuple[str, str], Document] = {}
    lines = dict(document.lines)
    value, position = document.value, document.position
    for pattern, kind in _REFERENCES.items():
        for path in _matches(value, pattern):
            place, _ = position.closest(path)
            name = _at(value, path)
            if not isinstance(name, str):
                continue
            try:
                target = known.get((kind, name)) or _referenced(kind, name, folder)
            except SpecError as error:
                unresolved.add(path_text(path))
                findings.extend(
                    f if f.line else finding_at(place, lines, path_text(path), f.text, f.hint)
                    for f in error.findings
                )
                continue
            known[kind, name] = target
            findings.extend(target.findings)
            lines.update(target.lines)
            value = _with(value, path, target.value[kind])
            position = _with_position(position, path, target.position.children[kind])
    return Document(document.file, value, position, lines, tuple(findings)), unresolved


def _referenced(kind: str, name: str, folder: Path) -> Document:
    """Return the document of a spec named or given by its path."""
    path = _data_file(folder, name) if name.endswith(SUFFIXES) else shipped_path(kind, name)
    if path is None:
        hints = (nearest(name, shipped_names(kind)), "a path ends in .yaml")
        text = f"there is no shipped {kind} '{name}'"
        raise SpecError([Finding("", text, "; ".join(hint for hint in hints if hint))])
    try:
        document = read_document(path)
    except SpecError as error:
        raise SpecError(
            [f if f.line else replace(f, text=f"{path} {f.text}") for f in error.findings]
        ) from error
    root = _checked_root(document)
    if "flexure" not in root:
        raise SpecError([*document.findings, _no_version(document)])
    if set(root) != {"flexure", kind}:
        others = ", ".join(key for key in root if key != "flexure") or "nothing"
        text, hint = f"{path} holds {others}", f"it must hold 'flexure' and '{kind}' alone"
        raise SpecError([*document.findings, Finding("", text, hint)])
    return document


def _data_file(folder: Path, name: str) -> Path:
    """Return the file of a path in a spec, which may lead, also by links, to YAML files only."""
    path = folder / name
    try:
        target = path.resolve(strict=True)
    except (OSError, ValueError, RuntimeError) as error:  # RuntimeError: a loop of links
        text, hint = f"there is no file {path}", "paths start at the spec's folder"
        raise SpecError([Finding("", text, hint)]) from error
    if target.suffix not in SUFFIXES:
        text, hint = f"{path} is a link to something else", "a path leads to a YAML file"
        raise SpecError([Finding("", text, hint)])
    return path


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
    return position._replace(children={**position.children, path[0]: inner})
