"""The specs that a spec names, by a shipped name or a path, put in the place of their names.

A spec may come from a stranger: what it names lies in its own folder, also through links, unless
:func:`from_anywhere` allows more; and no line of a file outside is shown.
"""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from pathlib import Path
from typing import Any, NoReturn

from flexcli.errors import Finding, SpecError
from flexcli.parts.base import said
from flexcli.parts.case import Case
from flexcli.parts.design import DesignSpec
from flexcli.spec.document import Document, Position, finding_at
from flexcli.spec.findings import nearest, path_text
from flexcli.spec.overrides import at, with_position, with_value
from flexcli.spec.read import read_document
from flexcli.spec.shipped import FOLDERS, shipped_names, shipped_path

__all__ = [
    "EXTENDS",
    "FORMAT",
    "REFERENCES",
    "SUFFIXES",
    "TABLE_PLACES",
    "TABLE_SUFFIXES",
    "checked_root",
    "from_anywhere",
    "is_from_anywhere",
    "no_version",
    "resolved",
]

FORMAT = 1
SUFFIXES = (".yaml", ".yml")
MAX_DEPTH = 8
"""Specs that may stand behind one another."""

EXTENDS = "extends"

REFERENCES: dict[tuple[str, ...], str] = {
    ("material",): "material",
    ("geometry",): "geometry",
    ("stroke",): "stroke",
    ("asd", "profile"): "asd",
    ("cases", "*", "stroke"): "stroke",
    ("cases", "*", "asd", "profile"): "asd",
    **{("axes", axis, "asd"): "asd" for axis in "xyz"},
    **{("cases", "*", "axes", axis, "asd"): "asd" for axis in "xyz"},
    ("balance", "asd", "profile"): "asd",
    ("stops", "contact", "material"): "material",
    ("geometry", "bodies", "*", "material"): "material",
}
"""Where a design may name a spec instead of holding it."""

TABLE_SUFFIXES = (".csv", ".tsv", ".txt", ".parquet")
TABLE_PLACES: dict[tuple[str, ...], str] = {
    ("asd", "points"): "asd",
    ("asd", "profile", "points"): "asd",
    ("cases", "*", "asd", "points"): "asd",
    ("cases", "*", "asd", "profile", "points"): "asd",
    **{("axes", axis, "asd", "points"): "asd" for axis in "xyz"},
    **{("cases", "*", "axes", axis, "asd", "points"): "asd" for axis in "xyz"},
    ("balance", "asd", "profile", "points"): "asd",
    ("shock", "srs"): "srs",
    ("cases", "*", "shock", "srs"): "srs",
    ("shock", "record"): "record",
    ("cases", "*", "shock", "record"): "record",
}
"""Where a spec may name a table in place of points, and the kind of table."""

_VERSION = f"flexure: {FORMAT}"

_ANYWHERE: ContextVar[bool] = ContextVar("references_from_anywhere", default=False)


@contextmanager
def from_anywhere(allowed: bool = True) -> Iterator[None]:
    """Let specs that are read meanwhile name files outside their folders."""
    token = _ANYWHERE.set(allowed)
    try:
        yield
    finally:
        _ANYWHERE.reset(token)


def is_from_anywhere() -> bool:
    """Return whether specs may name files outside their folders."""
    return _ANYWHERE.get()


def checked_root(document: Document) -> dict[str, Any]:
    """Return the mapping that a spec is, or raise a fault that prevents further reading."""
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
            text = f"{said(version)} is no version of the format"
            refuse(place, "flexure", text, f"write {_VERSION}")
    elif not set(root) & {*FOLDERS, *DesignSpec.model_fields, *Case.model_fields}:
        raise SpecError([*document.findings, no_version(document)])
    return root


def no_version(document: Document) -> Finding:
    """Return the finding for a spec without a version."""
    text, hint = "'flexure' is missing", f"add '{_VERSION}'"
    return finding_at(document.position, document.lines, "", text, hint)


def resolved(document: Document, folder: Path, kind: str = "design") -> tuple[Document, set[str]]:
    """Put the specs that a spec names in the place of their names, positions included.

    Also returns the paths of the names that lead nowhere, for which there are findings.
    """
    return _Resolver(folder.resolve()).resolved(document, folder, kind, 0)


class _Resolver:
    """Finds what the spec of a folder names, and what that names in turn."""

    def __init__(self, home: Path) -> None:
        self.home = home

    def resolved(
        self, document: Document, folder: Path, kind: str, depth: int
    ) -> tuple[Document, set[str]]:
        """Return a document whose paths start at a folder with what it names in place."""
        findings = list(document.findings)
        unresolved: set[str] = set()
        known: dict[tuple[str, str], Document] = {}
        lines = dict(document.lines)
        value, position = document.value, document.position
        for pattern, wanted in (REFERENCES if kind == "design" else {(kind,): kind}).items():
            for path in _matches(value, pattern):
                own = at(value, path)
                step = (*path, EXTENDS) if _extends(own, wanted) else path
                name = own[EXTENDS] if step != path else own
                if not isinstance(name, str) or (step == path and kind != "design"):
                    continue
                try:
                    target = known.get((wanted, name)) or self._found(wanted, name, folder, depth)
                except SpecError as error:
                    unresolved.add(path_text(path))
                    place, _ = position.closest(step)
                    findings.extend(
                        f if f.line else finding_at(place, lines, path_text(step), f.text, f.hint)
                        for f in error.findings
                    )
                    continue
                known[wanted, name] = target
                findings.extend(target.findings)
                lines.update(target.lines)
                new, place = target.value[wanted], target.position.children[wanted]
                if step != path:
                    new, place = _extended(new, place, own, position.closest(path)[0])
                value = with_value(value, path, new)
                position = with_position(position, path, place)
        found = document._replace(
            value=value, position=position, lines=lines, findings=tuple(findings)
        )
        for pattern, wanted in TABLE_PLACES.items() if kind in ("design", "asd") else ():
            for path in _matches(found.value, pattern):
                if isinstance(at(found.value, path), str | dict):
                    found, is_read = self._with_table(found, path, wanted, folder)
                    unresolved |= set() if is_read else {path_text(path)}
        return found, unresolved

    def _with_table(
        self, document: Document, path: tuple[str, ...], kind: str, folder: Path
    ) -> tuple[Document, bool]:
        """Return a document with the rows of a table in place of its name, or what is wrong."""
        from flexcli.spec.table_file import named_table, read_table, recorded

        lines = dict(document.lines)
        try:
            name, columns = named_table(at(document.value, path), TABLE_SUFFIXES)
            file = self._data_file(folder, name, TABLE_SUFFIXES, "a table")
            table = read_table(file, kind, columns)
            value = recorded(name, table) if kind == "record" else table.points()
        except SpecError as error:
            place, _ = document.position.closest(path)
            here = [
                f if f.line else finding_at(place, lines, path_text(path), f.text, f.hint)
                for f in error.findings
            ]
            return document._replace(findings=(*document.findings, *here)), False
        value = with_value(document.value, path, value)
        position = with_position(document.position, path, table.position())
        if file.resolve().is_relative_to(self.home):
            lines[table.file] = table.lines
        return document._replace(value=value, position=position, lines=lines), True

    def _found(self, kind: str, name: str, folder: Path, depth: int) -> Document:
        """Return the document of a spec named or given by its path from a folder."""
        if depth == MAX_DEPTH:
            text, hint = "these specs name one another without end", "write one of them out"
            raise SpecError([Finding("", text, hint)])
        if kind == "asd" and name.lower().endswith(TABLE_SUFFIXES):
            return self._of_table(name, folder)
        is_path = name.endswith(SUFFIXES)
        path = self._data_file(folder, name) if is_path else shipped_path(kind, name)
        if path is None:
            hints = (nearest(name, shipped_names(kind)), "a path ends in .yaml")
            text = f"there is no shipped {kind} '{name}'"
            raise SpecError([Finding("", text, "; ".join(hint for hint in hints if hint))])
        is_foreign = is_path and not path.resolve().is_relative_to(self.home)
        try:
            document = _read(kind, path) if is_path else _shipped(kind, path)
            if is_foreign:
                document = document._replace(lines={}, findings=_unquoted(document.findings))
            document, unresolved = self.resolved(document, path.parent, kind, depth + 1)
            if unresolved:
                raise SpecError(list(document.findings))
        except SpecError as error:
            raise SpecError(
                list(_unquoted(error.findings) if is_foreign else error.findings)
            ) from (error)
        return document

    def _of_table(self, name: str, folder: Path) -> Document:
        """Return the document of a profile whose points are those of a table."""
        place = Position(name, 1, 1, 1, 1, {})
        whole = Position(name, 1, 1, 1, 1, {"asd": place._replace(children={"points": place})})
        document = Document(name, {"asd": {"points": name}}, whole, {})
        document, is_read = self._with_table(document, ("asd", "points"), "asd", folder)
        if not is_read:
            raise SpecError([f if f.line else Finding("", f.text, f.hint)
                             for f in document.findings])  # fmt: skip
        return document

    def _data_file(
        self,
        folder: Path,
        name: str,
        suffixes: tuple[str, ...] = SUFFIXES,
        called: str = "a YAML file",
    ) -> Path:
        """Return the file of a path in a spec, which may lead, also by links, to data files only.

        Where it leads outside, nothing is told of what is there.
        """
        path = folder / name
        try:
            if not _ANYWHERE.get() and not path.resolve().is_relative_to(self.home):
                text = f"{path} lies outside the spec's folder"
                hint = "copy the file into the folder, or allow it by --allow-outside"
                raise SpecError([Finding("", text, hint)])
            target = path.resolve(strict=True)
        except (OSError, ValueError, RuntimeError) as error:  # RuntimeError: a loop of links
            text, hint = f"there is no file {path}", "paths start at the spec's folder"
            raise SpecError([Finding("", text, hint)]) from error
        if not target.suffix.lower().endswith(suffixes):
            text, hint = f"{path} is a link to something else", f"a path leads to {called}"
            raise SpecError([Finding("", text, hint)])
        return path


def _read(kind: str, path: Path) -> Document:
    """Return the document of a file that holds a spec of a kind and nothing else."""
    try:
        document = read_document(path)
    except SpecError as error:
        raise SpecError(
            [f if f.line else f._replace(text=f"{path} {f.text}") for f in error.findings]
        ) from error
    root = checked_root(document)
    if "flexure" not in root:
        raise SpecError([*document.findings, no_version(document)])
    if set(root) != {"flexure", kind}:
        others = ", ".join(key for key in root if key != "flexure") or "nothing"
        text, hint = f"{path} holds {others}", f"it must hold 'flexure' and '{kind}' alone"
        raise SpecError([*document.findings, Finding("", text, hint)])
    return document


@cache
def _shipped(kind: str, path: Path) -> Document:
    """Return the document of a shipped spec, which no run changes."""
    return _read(kind, path)


def _unquoted(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """Return findings without the lines that they point at."""
    return tuple(found._replace(source_line="") for found in findings)


def _extends(value: Any, kind: str) -> bool:
    """Return whether a value stands on a named one of its kind."""
    return kind == "material" and isinstance(value, dict) and isinstance(value.get(EXTENDS), str)


_FATIGUE = {"fatigue_amplitude", "sn_amplitudes"}


def _extended(
    base: dict[str, Any], base_position: Position, own: dict[str, Any], position: Position
) -> tuple[dict[str, Any], Position]:
    """Return a material with own values in the place of those that it extends.

    Own fatigue data take the place of all of the other's, for they are of another test.
    """
    if not isinstance(base, dict):
        return base, base_position
    gone = _FATIGUE if _FATIGUE & set(own) else set()
    kept = {key: value for key, value in base.items() if key not in gone}
    changed = ", ".join(key for key in own if key not in (EXTENDS, "name", "condition", "note"))
    name = (
        f"{base.get('name') or own[EXTENDS]}, with own {changed}" if changed else base.get("name")
    )
    value = {**kept, **({"name": name} if name else {}), **own}
    inherited: dict[str | int, Position] = {
        key: at for key, at in base_position.children.items() if key in kept
    }
    return value, position._replace(children={**inherited, **position.children})


def _matches(value: Any, pattern: tuple[str, ...]) -> list[tuple[str, ...]]:
    """Return the paths in a value that a pattern with wildcards names."""
    if not pattern:
        return [()]
    if not isinstance(value, dict):
        return []
    keys = list(value) if pattern[0] == "*" else [pattern[0]] if pattern[0] in value else []
    return [(key, *rest) for key in keys for rest in _matches(value[key], pattern[1:])]
