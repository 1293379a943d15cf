"""From a spec file to its validated part: read, resolve references, validate, cross-check."""

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Annotated, Any, NamedTuple

from pydantic import TypeAdapter, ValidationError

from flexcli.errors import Finding, SpecError
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import AnyGeometry
from flexcli.parts.material import Material
from flexcli.parts.named import Named
from flexcli.parts.stroke import Stroke
from flexcli.spec.document import Document, finding_at
from flexcli.spec.findings import findings_of, nearest, path_text, with_nearest_kinds
from flexcli.spec.overrides import overridden, overrides_of, refuse_waiting
from flexcli.spec.read import read_document
from flexcli.spec.references import checked_root, no_version, resolved
from flexcli.spec.shipped import shipped_names, shipped_path

__all__ = ["KINDS", "Loaded", "load", "load_shipped", "validated"]

KINDS: dict[str, Any] = {
    "material": Material,
    "stroke": Stroke,
    "asd": Annotated[Any, Named("flexcli.parts.asd:ASDProfile")],
    "geometry": AnyGeometry,
}
"""Specs that may stand in a file of their own, and what each must be."""


class Loaded(NamedTuple):
    """A validated spec, the kind of spec it is, and the document that it came from."""

    kind: str
    part: Any
    document: Document


def load(path: Path) -> Loaded:
    """Read and validate a spec of any kind, or raise :class:`SpecError` with every finding."""
    return validated(read_document(path), path.parent)


def validated(
    document: Document, folder: Path, overrides: Mapping[Any, Any] | None = None
) -> Loaded:
    """Validate a document whose paths start at a folder, with values put over its own.

    Raises :class:`SpecError` with every finding.
    """
    document, waiting = overridden(document, overrides_of(overrides or {}))
    root = checked_root(document)
    own = _own_kind(root)
    kind = own or "design"
    document, unresolved = resolved(document, folder, kind)
    document = refuse_waiting(*overridden(document, waiting))
    if own is None:
        value = document.value
        if "parameters" in value:
            from flexcli.spec.parameters import with_parameters

            document, value = with_parameters(document)
        part, findings = _validated(kind, value, document)
    else:
        part, findings = _validated(kind, document.value[own], document, (own,))
        if "flexure" not in root:
            findings.append(no_version(document))
    findings = [f for f in findings if f.path not in unresolved]
    if document.findings or findings:
        raise SpecError(_each_once([*document.findings, *findings]))
    if own is None and (problems := _problems(part, document)):
        raise SpecError(problems)
    return Loaded(kind, part, document)


def load_shipped(kind: str, name: str) -> Any:
    """Return a shipped spec by its name, or raise :class:`SpecError`."""
    path = shipped_path(kind, name)
    if path is None:
        text = f"there is no shipped {kind} of this name"
        raise SpecError([Finding(name, text, nearest(name, shipped_names(kind)))])
    return load(path).part


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
    """Return the validated part, or nothing and what is wrong beyond what reading found.

    Where a kind is unknown, the rest is held against the nearest one.
    """
    try:
        return _adapter(kind).validate_python(value), []
    except ValidationError as error:
        model = DesignSpec if kind == "design" else KINDS[kind]
        found = findings_of(error, model, document, below)
        known = {(f.file, f.line, f.path) for f in document.findings}
        found = [f for f in found if (f.file, f.line, f.path) not in known]
        mended = with_nearest_kinds(value, error, model)
        if mended is not None:
            part, more = _validated(kind, mended, document, below)
            found += more if part is None or below else _problems(part, document)
        return None, found


def _each_once(findings: list[Finding]) -> list[Finding]:
    """Leave out what is said already, as when two cases name the same file."""
    once = {(f.file, f.line, f.column, f.text): f for f in reversed(findings)}
    return list(reversed(once.values()))


def _problems(design: DesignSpec, document: Document) -> list[Finding]:
    """Return what does not fit between parts of a design that are sound each."""
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
    return findings


def _as_written(path: tuple[str | int, ...], document: Document) -> tuple[str | int, ...]:
    """Return a path below ``cases`` as it stands in a spec whose single case is at the top."""
    return path[2:] if path[0] == "cases" and "cases" not in document.value else path
