"""A planar layout as it is drawn: its blades and bodies at rest, and its equilibria."""

from collections.abc import Callable, Mapping, Sequence
from math import cos, sin
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Edge
from flexcli.mechanics.layout import Blade, Body, Layout, Point
from flexcli.mechanics.mesh import single
from flexcli.mechanics.shape import ROUNDING, centre_line
from flexcli.mechanics.state import Equilibrium
from flexcli.parts.geometries.base import GROUND, MOVING
from flexcli.results.drawing import (
    XY,
    DrawnBlade,
    DrawnBody,
    DrawnEdge,
    DrawnMass,
    DrawnState,
)

__all__ = [
    "Turn",
    "drawn_blade",
    "drawn_bodies",
    "drawn_line",
    "drawn_states",
    "numbers",
    "place_of",
    "turning",
]

Floats = NDArray[np.float64]

AT_REST = 33
"""Places on each piece of a blade at rest, enough to see the shape of a notch."""

Turn: TypeAlias = Callable[[Floats], Floats]
"""What turns places into the axes that are drawn, or mirrors them."""


def turning(angle: float) -> Turn:
    """Return what turns places about the origin."""
    c, s = cos(angle), sin(angle)
    matrix = np.array([[c, -s], [s, c]])
    matrix[np.abs(matrix) < 1e-12] = 0.0  # quarter turns leave straight lines straight
    return lambda places: places @ matrix.T


def numbers(place: Point) -> Floats:
    """Return the place of the one design that is drawn."""
    return np.array([single(c) for c in place])


def place_of(place: Floats) -> XY:
    """Return a place as it is drawn."""
    return float(place[0]), float(place[1])


def drawn_line(places: Floats) -> tuple[XY, ...]:
    """Return places as they are drawn."""
    return tuple(place_of(place) for place in places)


def _ends(blade: Blade) -> tuple[Floats, Floats]:
    return numbers(blade.start), numbers(blade.end)


def drawn_blade(blade: Blade, turn: Turn) -> DrawnBlade:
    """Return a blade at rest, its thickness at places crowded where it changes."""
    start, end = _ends(blade)
    l = float(np.hypot(*(end - start)))
    s, h = [0.0], [0.0]
    u = np.linspace(-1.0, 1.0, AT_REST)[None, :]
    for piece in blade.profile.pieces(l):
        at = np.broadcast_to(piece.position(u), u.shape)[0]
        if at[0] > s[-1] + ROUNDING * l:  # a rigid stretch before it
            s, h = [*s, float(at[0])], [*h, 0.0]
        s.extend(at.tolist())
        h.extend(np.broadcast_to(piece.thickness(u), u.shape)[0].tolist())
    if s[-1] < l * (1.0 - ROUNDING):
        s, h = [*s, s[-1], l], [*h, 0.0, 0.0]
    if h[0] == 0.0 and s[1] == 0.0:
        s, h = s[1:], h[1:]
    axis = start + (np.array(s) / l)[:, None] * (end - start)
    width, height = single(blade.b), single(blade.z)
    outlines = tuple(_outline(face, start, end, turn) for face in blade.profile.faces(l))
    line = drawn_line(turn(axis))
    return DrawnBlade(
        blade.name, blade.first, blade.second, line, tuple(h), width, height, outlines
    )


def _outline(face: Sequence[Edge], start: Floats, end: Floats, turn: Turn) -> tuple[DrawnEdge, ...]:
    """Return the outline of a stretch between its left face and the mirror of it, on the right."""
    along = (end - start) / np.hypot(*(end - start))
    across = np.array([-along[1], along[0]])

    def drawn(edge: Edge, side: float) -> DrawnEdge:
        def place(at: XY) -> XY:
            return place_of(turn(start + at[0] * along + side * at[1] * across))

        centre = None if edge.centre is None else place(edge.centre)
        return DrawnEdge(place(edge.start), place(edge.end), centre)

    right = [drawn(edge, -1.0) for edge in face]
    left = [edge._replace(start=edge.end, end=edge.start) for edge in reversed(face)]
    whole = [right, [drawn(edge, 1.0) for edge in left]]
    closed = [DrawnEdge(a[-1].end, b[0].start) for a, b in (whole, whole[::-1])]
    return (*whole[0], closed[0], *whole[1], closed[1])


def drawn_bodies(
    layout: Layout, turn: Turn, moving: str, carried: Body | None = None
) -> tuple[DrawnBody, ...]:
    """Return the ground and the bodies with what is clamped to them and what they carry."""
    known = {body.name: body for body in layout.bodies}
    if carried is not None:
        known[MOVING] = known[MOVING]._replace(mass=carried.mass, com=carried.com)
    names = [GROUND, *known]
    places: dict[str, list[XY]] = {name: [] for name in names}
    ways: dict[str, list[XY]] = {name: [] for name in names}
    depths: dict[str, list[float]] = {name: [] for name in names}
    for blade in layout.blades:
        start, end = _ends(blade)
        along = turn((end - start) / np.hypot(*(end - start)))
        h = [x for x in drawn_blade(blade, turn).thickness if x > 0.0]
        for body, place, way, depth in (
            (blade.first, start, -along, h[0]),
            (blade.second, end, along, h[-1]),
        ):
            name = body if body in known else GROUND
            places[name].append(place_of(turn(place)))
            ways[name].append(place_of(way))
            depths[name].append(depth)
    found = []
    for name in names:
        if not places[name]:
            continue
        point = np.zeros(2)
        masses: tuple[DrawnMass, ...] = ()
        if name in known:
            rigid = known[name]
            point = numbers(rigid.point)
            if (mass := single(rigid.mass)) > 0.0:
                masses = (DrawnMass("", place_of(turn(numbers(rigid.com))), mass),)
        found.append(
            DrawnBody(
                name=moving if name == MOVING else name,
                clamps=tuple(places[name]),
                ways=tuple(ways[name]),
                depths=tuple(depths[name]),
                point=place_of(turn(point)),
                is_ground=name == GROUND,
                masses=masses,
            )
        )
    return tuple(found)


def drawn_states(
    state: Equilibrium, turn: Turn, moving: str, travels: Mapping[int, float]
) -> tuple[DrawnState, ...]:
    """Return equilibria by their rows, as they are drawn, with what the moving body is called."""
    lines = {blade.name: centre_line(state, blade.name) for blade in state.layout.blades}
    hand = float(np.sign(np.linalg.det(turn(np.eye(2)))))
    found = []
    for i, travel in travels.items():
        motions = {}
        for k, body in enumerate(state.layout.bodies):
            x, y = turn(state.motions[i, k, :2])
            name = moving if body.name == MOVING else body.name
            motions[name] = (float(x), float(y), hand * float(state.motions[i, k, 2]))
        found.append(
            DrawnState(
                travel=travel,
                axes={name: drawn_line(turn(line.place[i])) for name, line in lines.items()},
                stress={name: tuple(line.stress[i].tolist()) for name, line in lines.items()},
                motions=motions,
            )
        )
    return tuple(found)
