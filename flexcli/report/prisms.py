"""Prismatic parts of a drawing for CAD: outlines with a depth, of blades and blocks."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from math import hypot
from operator import mul
from typing import NamedTuple, TypeAlias

from flexcli.errors import SolveError
from flexcli.report.drawings.outlines import blocks
from flexcli.results.drawing import XY, Drawing, DrawnBlade, DrawnEdge, DrawnInSpace

__all__ = [
    "BLADES",
    "BODIES",
    "GROUND",
    "MM",
    "PLATE",
    "SLOTS",
    "Arc",
    "Edges",
    "Prism",
    "anticlockwise",
    "in_one_plane",
    "is_round",
    "outline",
    "prisms",
    "rigid_middles",
    "span_of",
]

BLADES, BODIES, GROUND = "BLADES", "BODIES", "GROUND"
"""Layers of single parts."""

PLATE, SLOTS = "PLATE", "SLOTS"
"""Layers of what is cut in one piece: its outer contour, and those within it."""

MM = 1e3
"""Of a metre: the unit of all files."""

ROUND = 1e-9
"""Of a radius: half-axes that differ by less are those of a circle."""

THICKER = 4.0
"""Thickness of the rigid middle of a blade, which no spec states, over that of its hinges."""


GROUND_NAME = "ground"

BESIDE, BEHIND = 1.5, 0.1
"""Half the thickness of a block at a clamp in space over that of the blade, its depth over l."""


class Arc(NamedTuple):
    """Part of an outline: of a circle [m], through an angle [rad], anticlockwise if positive."""

    start: XY
    end: XY
    centre: XY
    sweep: float


Edges: TypeAlias = tuple[DrawnEdge | Arc, ...]


def is_round(edge: DrawnEdge | Arc) -> bool:
    """Return whether an edge is straight or of a circle."""
    if edge.centre is None or isinstance(edge, Arc):
        return True
    x, y = edge.centre
    one, other = (hypot(u - x, v - y) for u, v in (edge.start, edge.end))
    return abs(one - other) <= ROUND * one


class Prism(NamedTuple):
    """A closed outline [m], from a depth to another across the plane, with a name and a layer.

    ``holes`` are the closed outlines within it, clockwise. ``axes`` are x and y of its plane and
    its normal, as rows, ``origin`` [m] where they are; nothing for the plane of the drawing.
    """

    name: str
    layer: str
    edges: Edges
    low: float
    high: float
    holes: tuple[Edges, ...] = ()
    axes: tuple[tuple[float, float, float], ...] = ()
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)


def in_one_plane(drawing: Drawing) -> Drawing:
    """Return a mechanism as it is seen across the plane that all its blades stand on.

    Raises
    ------
    SolveError
        When there is none.

    """
    for view in (drawing, *drawing.views.values()) if drawing.in_space else ():
        normal = [float(axis not in dict(view.axes)) for axis in "xyz"]
        stand = (abs(sum(map(mul, normal, each.axes[2]))) for each in drawing.in_space)
        if len(view.blades) == len(drawing.in_space) and min(stand) > 1.0 - ROUND:
            return replace(view, in_space=())
    if drawing.in_space:
        text = "its blades and rods stand across no common plane: they have no outlines in one"
        raise SolveError("no-prisms", text, "write STEP, which has them in space")
    return drawing


def prisms(drawing: Drawing) -> tuple[Prism, ...]:
    """Return blades, exactly, and plain blocks for bodies, at rest.

    Raises
    ------
    SolveError
        When nothing of the drawing is a blade with an outline.

    """
    if drawing.in_space:
        return tuple(part for each in drawing.in_space for part in _placed(each))
    found = [part for blade in drawing.blades for part in _hinges(blade)]
    if not found:
        text = f"a {drawing.kind} draws no blades that are prisms across its plane"
        raise SolveError("no-prisms", text, "see flexure draw for what it draws")
    middles = [
        Prism(f"{blade.name} middle", BODIES, outline(corners), *span_of(blade))
        for blade in drawing.blades
        for corners in rigid_middles(blade)
    ]
    low, high = min(prism.low for prism in found), max(prism.high for prism in found)
    bodies = [
        Prism(body.name, GROUND if body.is_ground else BODIES, outline(corners), low, high)
        for body in drawing.bodies
        for corners in blocks(drawing, body)
    ]
    return (*found, *middles, *bodies)


def _hinges(blade: DrawnBlade) -> list[Prism]:
    """Return what of a blade flexes."""
    name, whole = blade.name, len(blade.outlines) == 1
    return [
        Prism(name if whole else f"{name} hinge {k}", BLADES, edges, *span_of(blade))
        for k, edges in enumerate(blade.outlines, 1)
    ]


def _placed(each: DrawnInSpace) -> Iterator[Prism]:
    """Yield a blade or rod in space, its rigid middle, and a block behind each of its clamps."""
    blade, (low, high) = each.blade, span_of(each.blade)
    parts = _hinges(blade)
    for corners in rigid_middles(blade):
        parts.append(Prism(f"{blade.name} middle", BODIES, outline(corners), low, high))
    half = BESIDE * max(blade.thickness)
    for body, end in ((blade.first, -1.0), (blade.second, 1.0)):
        layer = GROUND if body == GROUND_NAME else BODIES
        if blade.axis:
            (x, _), l = blade.axis[0 if end < 0.0 else -1], blade.axis[-1][0]
            far = x + end * BEHIND * l
            corners = [(x, -half), (far, -half), (far, half), (x, half)]
            parts.append(Prism(body, layer, outline(corners), low, high))
        else:  # a rod is drawn across itself
            square = [(-half, -half), (half, -half), (half, half), (-half, half)]
            at = low if end < 0.0 else high
            under, over = sorted((at, at + end * BEHIND * high))
            parts.append(Prism(body, layer, outline(square), under, over))
    for part in parts:
        yield part._replace(axes=each.axes, origin=each.origin)


def span_of(blade: DrawnBlade) -> tuple[float, float]:
    """Return from where to where a blade reaches across the plane [m]."""
    return blade.height - 0.5 * blade.width, blade.height + 0.5 * blade.width


def anticlockwise(corners: Sequence[XY]) -> list[XY]:
    """Return the corners of an outline, anticlockwise."""
    ends = [*corners[1:], corners[0]]
    area = sum(x * v - u * y for (x, y), (u, v) in zip(corners, ends, strict=True))
    return list(corners) if area > 0.0 else list(corners)[::-1]


def outline(corners: Sequence[XY]) -> tuple[DrawnEdge, ...]:
    """Return the outline through some corners, anticlockwise."""
    ordered = anticlockwise(corners)
    around = zip(ordered, [*ordered[1:], ordered[0]], strict=True)
    return tuple(DrawnEdge(a, b) for a, b in around)


def rigid_middles(blade: DrawnBlade) -> list[list[XY]]:
    """Return the corners of what is rigid between the hinges of a blade."""
    found = []
    for one, other in pairwise(blade.outlines):
        # an outline goes along its right face, across its end, and back
        near, far = one[len(one) // 2 - 1], other[-1]
        corners = [
            (
                (edge.start[0] + edge.end[0] + side * THICKER * (edge.end[0] - edge.start[0]))
                / 2.0,
                (edge.start[1] + edge.end[1] + side * THICKER * (edge.end[1] - edge.start[1]))
                / 2.0,
            )
            for edge in (near, far)
            for side in (-1.0, 1.0)
        ]
        found.append(corners)
    return found
