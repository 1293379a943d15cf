"""Faults of a drawn layout: names, motion, and bodies without support."""

from collections.abc import Iterator, Mapping
from math import hypot, sin
from typing import NamedTuple

import numpy as np
from pydantic_core import PydanticCustomError

from flexcli.parts.base import spec_error
from flexcli.parts.geometries.base import GROUND, MOVING
from flexcli.parts.geometries.layout_parts import DrawnBlade, DrawnBody, DrawnSupport, Place

__all__ = ["Drawing", "faults"]

_HELD = 1e-9
"""Least over largest singular value of a group's springs above which they hold it."""

_SQUARE = 1e-9
"""Sine of twice the turn [rad] below which axes of springs stay axes."""


class Drawing(NamedTuple):
    """A drawing in a spec: parts by name, the body that moves, its travel's angle or its centre."""

    bodies: Mapping[str, DrawnBody]
    blades: Mapping[str, DrawnBlade]
    supports: tuple[DrawnSupport, ...]
    moving: str
    along: float | None
    centre: Place | None


def faults(drawing: Drawing) -> Iterator[PydanticCustomError]:
    """Yield every fault between the parts of a layout, each with its path in the spec."""
    names = list(_names(drawing))
    yield from names
    yield from _motions(drawing)
    yield from _doubles(drawing)
    if not names:
        yield from _loose(drawing)


def _names(drawing: Drawing) -> Iterator[PydanticCustomError]:
    known = f"bodies are: {', '.join(drawing.bodies)}"
    if GROUND in drawing.bodies:
        hint = "give the body another name; blades name ground as it is"
        yield spec_error("the ground is no body", hint, at=("bodies", GROUND))
    if MOVING in drawing.bodies and drawing.moving != MOVING:
        hint = "give it another name"
        yield spec_error("the stroke does not move this body", hint, at=("bodies", MOVING))
    if drawing.moving not in drawing.bodies:
        yield spec_error(f"there is no body '{drawing.moving}'", known, at=("moving",))
    for name, blade in drawing.blades.items():
        for index, end in enumerate(blade.between):
            if end != GROUND and end not in drawing.bodies:
                at = ("blades", name, "between", index)
                yield spec_error(f"there is no body '{end}'", f"{known}, or ground", at=at)
    for index, support in enumerate(drawing.supports):
        if support.body not in drawing.bodies:
            place = ("supports", index, "body")
            yield spec_error(f"there is no body '{support.body}'", known, at=place)


def _motions(drawing: Drawing) -> Iterator[PydanticCustomError]:
    along = drawing.along
    if along is None:
        return
    if drawing.centre is not None:
        yield spec_error("a translation has no centre", "take it out", at=("centre",))
    if abs(sin(2.0 * along)) < _SQUARE:
        return
    for index, support in enumerate(drawing.supports):
        if support.x != support.y:
            yield spec_error(
                "springs along x and y that differ need a travel along x or y",
                "draw the mechanism with its travel along y",
                at=("supports", index),
            )


def _doubles(drawing: Drawing) -> Iterator[PydanticCustomError]:
    seen: dict[object, str] = {}
    for name, blade in drawing.blades.items():
        first = seen.setdefault((frozenset((blade.start, blade.end)), blade.z), name)
        if first != name:
            hint = "give it another height z, or make one blade wider"
            yield spec_error(f"lies where blade {first} does", hint, at=("blades", name))


def _loose(drawing: Drawing) -> Iterator[PydanticCustomError]:
    """Yield the bodies that neither blades nor springs hold to the ground."""
    for group in _groups(drawing):
        if GROUND in group or _is_held(drawing, group):
            continue
        for name in drawing.bodies:
            if name in group:
                yield spec_error(
                    f"body {name} is not held to the ground",
                    "lead a blade from it to what is held, or give it springs in x, y and theta",
                    at=("bodies", name),
                )


def _groups(drawing: Drawing) -> list[set[str]]:
    """Return the groups of bodies that blades join, the ground among them."""
    groups = [{name} for name in (GROUND, *drawing.bodies)]
    for blade in drawing.blades.values():
        joined = [group for group in groups if group & set(blade.between)]
        groups = [group for group in groups if group not in joined] + [set().union(*joined)]
    return groups


def _is_held(drawing: Drawing, group: set[str]) -> bool:
    """Return whether springs hold the bodies of a group, which move as one, in all directions."""
    rows = [
        row
        for support in drawing.supports
        if support.body in group
        for row, stiffness in (
            ((1.0, 0.0, -support.at[1]), support.x),
            ((0.0, 1.0, support.at[0]), support.y),
            ((0.0, 0.0, 1.0), support.theta),
        )
        if stiffness is not None
    ]
    if len(rows) < 3:
        return False
    size = max((hypot(*support.at) for support in drawing.supports), default=0.0) or 1.0
    scaled = np.array(rows) / np.array([1.0, 1.0, size])
    values = np.linalg.svd(scaled / np.linalg.norm(scaled, axis=1)[:, None], compute_uv=False)
    return bool(values[-1] > _HELD * values[0])
