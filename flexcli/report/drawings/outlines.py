"""Outlines in a mechanism's plane: those of blades, and plain blocks that stand for bodies."""

from collections.abc import Sequence
from itertools import combinations
from math import cos, hypot, pi, sin

from flexcli.results.drawing import XY, Drawing, DrawnBlade, DrawnBody

__all__ = ["CLAMP", "INTO", "along", "blocks", "edge_of", "size_of"]

CLAMP, INTO = 0.09, 0.13
"""Half the width of a clamp, and the depth of a body behind it, over the mechanism's size."""

PIN, EIGHTHS = 0.03, tuple(k * pi / 4.0 for k in range(8))
"""Half the width of a link about a pin over the mechanism's size, and the corners there."""

BETWEEN = (0.3, 0.5, 0.7)
"""Places along a blade that the block of a body should not cover."""


def blocks(drawing: Drawing, body: DrawnBody) -> list[list[XY]]:
    """Return the plain blocks that stand for a body: around its clamps and the space behind them.

    It is one block, unless that would cover the blades; then one for each clamp.
    """
    places = [along(blade, share) for blade in drawing.blades for share in BETWEEN]
    feet = zip(body.clamps, body.ways, body.depths, strict=True)
    size = drawing.joint_size or size_of(drawing)
    found = [_foot(*clamp, size) for clamp in feet]
    whole = _hull([corner for foot in found for corner in foot])
    if not any(_is_inside(place, whole) for place in places):
        return [whole]
    while True:
        for one, other in combinations(found, 2):
            both = _hull([*one, *other])
            if not any(_is_inside(place, both) for place in places):
                found = [each for each in found if each is not one and each is not other]
                found.append(both)
                break
        else:
            return found


def _foot(place: XY, way: XY, depth: float, size: float) -> list[XY]:
    """Return the block behind one clamp, or about a pin."""
    (x, y), (wx, wy) = place, way
    if wx == wy == 0.0:  # a pin
        return [(x + PIN * size * cos(a), y + PIN * size * sin(a)) for a in EIGHTHS]
    half, deep = max(CLAMP * size, 0.75 * depth), INTO * size
    return [
        (x + s * half * wy + d * wx, y - s * half * wx + d * wy)
        for s, d in ((-1.0, deep), (-1.0, 0.0), (1.0, 0.0), (1.0, deep))
    ]


def _hull(points: Sequence[XY]) -> list[XY]:
    """Return the convex hull, anticlockwise (Andrew 1979)."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered

    def half(run: Sequence[XY]) -> list[XY]:
        chain: list[XY] = []
        for c in run:
            while len(chain) > 1 and _left(chain[-2], chain[-1], c) <= 0.0:
                chain.pop()
            chain.append(c)
        return chain[:-1]

    return half(ordered) + half(ordered[::-1])


def _left(a: XY, b: XY, c: XY) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _is_inside(place: XY, hull: Sequence[XY]) -> bool:
    """Return whether a place lies within a convex outline that runs anticlockwise."""
    ends = [*hull[1:], hull[0]]
    return all(_left(a, b, place) > 0.0 for a, b in zip(hull, ends, strict=True))


def edge_of(blade: DrawnBlade) -> list[XY]:
    """Return the outline of a blade at rest [m]: one face from end to end, then the other back."""
    (x0, y0), (x1, y1) = blade.axis[0], blade.axis[-1]
    l = hypot(x1 - x0, y1 - y0)
    nx, ny = -(y1 - y0) / l, (x1 - x0) / l
    rigid = 3.0 * max(blade.thickness)
    halves = [0.5 * (h or rigid) for h in blade.thickness]
    left, right = (
        [
            (x + side * k * nx, y + side * k * ny)
            for (x, y), k in zip(blade.axis, halves, strict=True)
        ]
        for side in (1.0, -1.0)
    )
    return [*left, *right[::-1]]


def along(blade: DrawnBlade, share: float) -> XY:
    """Return the place at a share of a blade's length [m]."""
    (x0, y0), (x1, y1) = blade.axis[0], blade.axis[-1]
    return x0 + share * (x1 - x0), y0 + share * (y1 - y0)


def size_of(drawing: Drawing) -> float:
    """Return the larger side of what the blades or pins span [m]."""
    places = [place for blade in drawing.blades for place in blade.axis]
    places = places or [place for body in drawing.bodies for place in body.clamps]
    xs, ys = zip(*places, strict=True)
    return float(max(max(xs) - min(xs), max(ys) - min(ys)))
