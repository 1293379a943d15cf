"""A mechanism drawn in space as SVG: its blades with their width, from the side or the corner."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import atan2, cos, hypot, radians, remainder, sin, tau
from typing import NamedTuple, TypeAlias

from flexcli.report.drawings.caption import caption
from flexcli.report.drawings.outlines import blocks, edge_of, size_of
from flexcli.report.drawings.plane import drawing_svg
from flexcli.report.drawings.style import sheet_of
from flexcli.report.svg import Box, Labels, Page
from flexcli.results.drawing import XY, Drawing, DrawnBlade
from flexcli.units import show

__all__ = ["VIEWS", "view_svg"]

XYZ: TypeAlias = tuple[float, float, float]

WIDTH, HIGH, EDGE = 360.0, 280.0, 56.0
"""Width of the page, the height that the mechanism is fitted into, and around it [px]."""

IN_SPACE = 360.0
"""Width of the page of a mechanism in space [px]."""

GROUND_DEPTH = 0.04
"""Thickness of the plate that stands for the ground, over the mechanism's size."""


ROUND = radians(20.0)
"""Turn between sides below which they are one curved side."""


class View(NamedTuple):
    """Directions of the axes x, y and z on the page, and how near along each a place is."""

    x: XY
    y: XY
    z: XY
    near: XYZ


_C, _S = cos(radians(30.0)), sin(radians(30.0))

VIEWS = {
    "side": View((0.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (1.0, 0.0, 0.0)),
    "isometric": View((_C, -_S), (0.0, 1.0), (-_C, -_S), (1.0, 1.0, 1.0)),
}
"""Seen from +x, and from the corner between +x, +y and +z."""


class Face(NamedTuple):
    """A flat side of a solid: its corners [m], how near it is, and how it is drawn."""

    corners: tuple[XYZ, ...]
    near: float
    style: str


def view_svg(drawing: Drawing, title: str, view: str, *, stress: bool = False) -> str:
    """Return the mechanism at rest as it is seen from the side or from the corner.

    One in space is drawn from there as from the front, moved as well, by stress if asked.
    """
    if view in drawing.views:
        return drawing_svg(drawing.views[view], title, stress=stress, width=IN_SPACE)
    seen = VIEWS[view]
    faces = sorted(_faces(drawing, seen), key=lambda face: face.near)
    places = [_flat(corner, seen) for face in faces for corner in face.corners]
    lows, highs = ([f(side) for side in zip(*places, strict=True)] for f in (min, max))
    wide, high = (most - least for least, most in zip(lows, highs, strict=True))
    scale = min((WIDTH - 2.0 * EDGE) / (wide or high), HIGH / (high or wide))
    page = Page(WIDTH, high * scale + 2.0 * EDGE)
    left, base = 0.5 * (WIDTH - (lows[0] + highs[0]) * scale), EDGE + highs[1] * scale

    def at(place: XYZ) -> XY:
        x, y = _flat(place, seen)
        return left + scale * x, base - scale * y

    labels = Labels(Box(4.0, 4.0, WIDTH - 4.0, page.height - 40.0))
    for face in faces:
        corners = [at(corner) for corner in face.corners]
        page.path(corners, face.style, closed=True)
        labels.keep_off(corners, closed=True)
    for name, size in drawing.sizes:
        if name == "b" and drawing.blades:
            blade = drawing.blades[0]
            x, y = blade.axis[len(blade.axis) // 2]
            near = at((x, y, blade.height + 0.5 * blade.width))
            found = labels.place(f"b = {show(size, 'm')}", [near], 12.5)
            if found is not None:
                page.text(f"b = {show(size, 'm')}", found[0], found[1])
    _axes(page, seen)
    page.text(f"{view} view, at rest", (WIDTH - 16.0, page.height - 17.0), "end", "s")
    return sheet_of(page, title, f"{view.capitalize()} view. {caption(drawing)}")


def _axes(page: Page, view: View) -> None:
    x, y = 60.0, page.height - 44.0
    for name, (right, up) in (("x", view.x), ("y", view.y), ("z", view.z)):
        if right == up == 0.0:
            continue
        end = (x + 26.0 * right, y - 26.0 * up)
        page.arrow((x, y), end, "thin", "head")
        page.text(name, (end[0] + 6.0 * right, end[1] - 6.0 * up + 4.0), "middle", "s")


def _flat(place: XYZ, view: View) -> XY:
    """Return where a place is seen [m]."""
    x, y, z = place
    return (
        x * view.x[0] + y * view.y[0] + z * view.z[0],
        x * view.x[1] + y * view.y[1] + z * view.z[1],
    )


def _faces(drawing: Drawing, view: View) -> Iterator[Face]:
    """Yield the sides that are seen of blades, bodies and ground."""
    size = drawing.joint_size or size_of(drawing)
    for blade in drawing.blades:
        yield from _prism(_anticlockwise(edge_of(blade)), _span(blade), view, "face")
    for body in drawing.bodies:
        spans = [_span(b) for b in drawing.blades if body.name in (b.first, b.second)]
        spans = spans or [_span(b) for b in drawing.blades] or [(-0.1 * size, 0.1 * size)]
        low, high = min(s[0] for s in spans), max(s[1] for s in spans)
        if not body.is_ground:
            for block in blocks(drawing, body):
                yield from _prism(block, (low, high), view, "body")
            continue
        for (x, y), (wx, wy), depth in zip(body.clamps, body.ways, body.depths, strict=True):
            half, deep = max(0.09 * size, 0.75 * depth), GROUND_DEPTH * size
            plate = [
                (x + s * half * wy + d * wx, y - s * half * wx + d * wy)
                for s, d in ((-1.0, 0.0), (1.0, 0.0), (1.0, deep), (-1.0, deep))
            ]
            yield from _prism(_anticlockwise(plate), (low, high), view, "body")


def _span(blade: DrawnBlade) -> tuple[float, float]:
    return blade.height - 0.5 * blade.width, blade.height + 0.5 * blade.width


def _anticlockwise(corners: Sequence[XY]) -> list[XY]:
    """Return an outline anticlockwise, without redundant corners."""
    around = zip([corners[-1], *corners[:-1]], corners, [*corners[1:], corners[0]], strict=True)
    corners = [b for a, b, c in around if a != b and not _is_straight(a, b, c)]
    ends = [*corners[1:], corners[0]]
    area = sum(x * v - u * y for (x, y), (u, v) in zip(corners, ends, strict=True))
    return list(corners) if area > 0.0 else list(corners)[::-1]


def _is_straight(a: XY, b: XY, c: XY) -> bool:
    (ux, uy), (vx, vy) = ((q[0] - p[0], q[1] - p[1]) for p, q in ((a, b), (b, c)))
    return abs(ux * vy - uy * vx) <= 1e-9 * (hypot(ux, uy) * hypot(vx, vy))


def _prism(base: Sequence[XY], span: tuple[float, float], view: View, style: str) -> Iterator[Face]:
    """Yield the sides of a prism that face the eye."""
    low, high = span
    nx, ny, nz = view.near
    if nz > 0.0:
        yield _face([(x, y, high) for x, y in base], view, style)
    ways = [atan2(v - y, u - x) for (x, y), (u, v) in pairwise([*base, base[0]])]
    for k, ((x, y), (u, v)) in enumerate(pairwise([*base, base[0]])):
        if (v - y) * nx - (u - x) * ny > 0.0:
            corners = [(x, y, low), (u, v, low), (u, v, high), (x, y, high)]
            turns = (ways[k] - ways[k - 1], ways[(k + 1) % len(ways)] - ways[k])
            is_round = all(abs(remainder(turn, tau)) < ROUND for turn in turns)
            yield _face(corners, view, "curved" if is_round else style)


def _face(corners: Sequence[XYZ], view: View, style: str) -> Face:
    near = sum(
        sum(c * n for c, n in zip(corner, view.near, strict=True)) for corner in corners
    ) / len(corners)
    return Face(tuple(corners), near, style)
