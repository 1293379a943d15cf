"""First specs: of every kind of joint and mechanism one that passes, each key with its meaning."""

from collections.abc import Iterator
from textwrap import wrap
from typing import Any, NamedTuple

from pydantic import TypeAdapter

from flexcli.errors import Finding, SpecError
from flexcli.parts.geometries import GEOMETRIES, AnyGeometry, Geometry
from flexcli.parts.mechanisms import MECHANISMS
from flexcli.spec.as_yaml import as_yaml
from flexcli.spec.document import Position
from flexcli.spec.findings import nearest
from flexcli.spec.manual import entries, meaning
from flexcli.spec.parse import parse_document

__all__ = ["USUAL", "kinds", "starter"]

USUAL = "leaf-spring-stage"
"""The joint that a newcomer knows."""

HEAD = """\
# yaml-language-server: $schema=flexure.schema.json
# That line is for editors: 'flexure schema -o flexure.schema.json' writes the file that it names.
# {first}; 'flexure explain KEY' tells of any key.
"""
WIDTH = 98

FREE = {"h": ["0.1 mm", "1 mm"], "d": ["0.2 mm", "5 mm"], "l": ["10 mm", "60 mm"]}
"""Sizes that are left free, and between what."""

STEPS = {"h": "10 um", "d": "10 um", "l": "0.5 mm"}
"""Steps in which they are made."""

SHAKEN = {"profile": "gevs-qualification", "q": 50}


class _Scene(NamedTuple):
    """What a mechanism lives through besides its stroke, and what is asked for that."""

    joint: str
    stroke: dict[str, Any]
    cases: dict[str, Any]
    requirements: dict[str, Any]


SLIDES, TURNS = {"translation": "1 mm"}, {"rotation": "2 deg"}
SCENES = {
    "payload": _Scene(USUAL, SLIDES, {"launch": {"asd": SHAKEN}}, {"dynamic-yield": 1.25}),
    "tip-mass": _Scene("cantilever", SLIDES, {"launch": {"asd": SHAKEN}}, {"dynamic-yield": 1.25}),
    "parallel-stage": _Scene(
        "rcc",
        {"translation": "0.4 mm"},
        {"take-off": {"lock": "solid-2", "asd": SHAKEN}},
        {"buckling": 2.0},
    ),
}
HINGED = {"translation": "0.2 mm", "rotation": "0.5 deg"}
"""Strokes of what bends in notches alone."""

PIVOT = {"kind": "cross-spring", "delta": -0.5, "half_angle": "45 deg"} | {
    "h": "0.1 mm", "l": "15 mm", "b": "5 mm"
}  # fmt: skip
"""What a linkage turns on."""

_GEOMETRY: TypeAdapter[Geometry] = TypeAdapter(AnyGeometry)


def kinds() -> tuple[str, ...]:
    """Return what a first spec may be of: joints, then mechanisms under vibration."""
    return (*GEOMETRIES.paths, *MECHANISMS.paths)


def starter(kind: str) -> str:
    """Return the text of a first spec of a kind.

    Raises :class:`SpecError` where there is no such kind.
    """
    if kind not in kinds():
        text, hint = f"there is no joint or mechanism '{kind}'", nearest(kind, kinds())
        raise SpecError([Finding("flexure init", text, hint)])
    spec = _spec(kind)
    first = "'flexure check' judges it" if "size" not in spec else (
        "'flexure size' chooses the sizes that are free"
    )  # fmt: skip
    lines = [line for key in spec for line in _section(key, spec)]
    return "\n".join([HEAD.format(first=first) + lines[0], *lines[1:]]) + "\n"


def _spec(kind: str) -> dict[str, Any]:
    """Return the values of a first spec."""
    scene = SCENES.get(kind)
    geometry = _block("geometry", scene.joint if scene else kind)
    for joint in geometry.get("joints", {}).values():
        if "along" not in joint:  # an ideal pivot has nothing to be judged
            joint["flexure"] = PIVOT
    stroke = scene.stroke if scene else _stroke(geometry)
    free = [name for name in FREE if name in geometry]
    if len(free) > 1:  # else a notch or a drawing, whose sizes are given
        geometry |= {name: {"free": FREE[name]} for name in free}
    spec = {"flexure": 1, "title": f"A first {kind}", "material": "ti-6al-4v", "geometry": geometry}
    if scene:
        spec["mechanism"] = _block("mechanism", kind)
    spec["cases"] = {
        "operation": {"stroke": {**stroke, "cycles": 1e6}},
        **(scene.cases if scene else {}),
    }
    spec["requirements"] = {"yield": 1.5, "fatigue": 2.0, **(scene.requirements if scene else {})}
    if len(free) > 1:
        steps = {name: STEPS[name] for name in free}
        spec["size"] = {"objective": "least-volume", "round": steps}
    return spec


def _block(section: str, kind: str) -> dict[str, Any]:
    """Return the manual's example of a kind."""
    (row,) = (row for row in entries(kind) if row.path == section)
    found: dict[str, Any] = parse_document(row.example, "").value[section]
    return found


def _stroke(geometry: dict[str, Any]) -> dict[str, Any]:
    motion = _GEOMETRY.validate_python(geometry).motion
    if "e" in geometry:
        return {motion: HINGED[motion]}
    return SLIDES if motion == "translation" else TURNS


def _section(key: str, spec: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of a section, each with what its first key means, and what else it takes."""
    text = as_yaml({key: spec[key]}, 3 if key == "cases" else 2)
    said = dict(_said(parse_document(text, "").position, (), {key: spec[key]}))
    told = set()
    for number, line in enumerate(text.splitlines(), start=1):
        comment = said.get(number, "") if said.get(number) not in told else ""
        told.add(comment)
        if len(line) + len(comment) + 4 <= WIDTH:
            yield f"{line}  # {comment}" if comment else line
        else:
            start = f"{' ' * (len(line) - len(line.lstrip()))}# "
            yield from wrap(comment, WIDTH, initial_indent=start, subsequent_indent=start)
            yield line
    if isinstance(spec[key], dict):
        kind = spec[key].get("kind", key)
        row = next((row for row in entries(kind) if row.path == key), None)
        more = [each.name for each in (row.keys if row else ()) if each.name not in spec[key]]
        if more:
            rest = f"also: {', '.join(more)}"
            yield from wrap(rest, WIDTH, initial_indent="  # ", subsequent_indent="  # ")


def _said(position: Position, path: tuple[str | int, ...], value: Any) -> Iterator[tuple[int, str]]:
    """Yield the line of each key and what the key means, the inner ones first."""
    for step, inner in position.children.items():
        here = (*path, step)
        yield from _said(inner, here, value[step])
        if isinstance(step, str):
            yield inner.key_line, meaning(here, value.get("kind", ""))
