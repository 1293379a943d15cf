"""A mechanism as DXF, in mm: closed outlines on the layers of their kinds, with their widths."""

from collections.abc import Iterator, Sequence
from importlib import import_module
from io import StringIO
from math import atan2, degrees, hypot, pi, tan
from typing import Any

from flexcli.errors import SolveError
from flexcli.report.prisms import (
    BLADES,
    BODIES,
    GROUND,
    MM,
    PLATE,
    SLOTS,
    Arc,
    Edges,
    Prism,
    is_round,
)
from flexcli.results.drawing import DrawnEdge

__all__ = ["dxf"]

COLOURS = {BLADES: 1, BODIES: 5, GROUND: 8, PLATE: 7, SLOTS: 1}
"""Of AutoCAD's index: red, blue, grey, white."""


def dxf(shapes: Sequence[Prism]) -> bytes:
    """Return a file of outlines; width and height stand in each as thickness and elevation.

    An outline of lines and circles is one closed polyline; one with ellipses is made of lines and
    ellipses that meet.

    Raises
    ------
    SolveError
        When the library is not installed.

    """
    try:
        library = import_module("ezdxf")
    except ImportError as error:
        text = "a DXF needs the extra 'cad'"
        raise SolveError("no-cad", text, "pip install 'flexcli[cad]'") from error
    document = library.new("R2010")
    document.header["$INSUNITS"], document.header["$MEASUREMENT"] = 4, 1  # mm
    contours = [
        (layer, edges, shape)
        for shape in shapes
        for layer, edges in ((shape.layer, shape.edges), *((SLOTS, hole) for hole in shape.holes))
    ]
    for layer in dict.fromkeys(layer for layer, *_ in contours):
        document.layers.add(layer, color=COLOURS[layer])
    space = document.modelspace()
    for layer, edges, shape in contours:
        at = {"layer": layer, "thickness": (shape.high - shape.low) * MM}
        low = shape.low * MM
        if all(is_round(edge) for edge in edges):
            points = [(*_mm(edge.start), _bulge(edge)) for edge in edges]
            at["elevation"] = low
            space.add_lwpolyline(points, format="xyb", close=True, dxfattribs=at)
        else:
            for kind, values in _entities(edges, low):
                given = at if kind == "add_line" else {"layer": layer}
                getattr(space, kind)(**values, dxfattribs=given)
    stream = StringIO()
    document.write(stream)
    return stream.getvalue().encode()


def _mm(place: tuple[float, float]) -> tuple[float, float]:
    return place[0] * MM, place[1] * MM


def _arms(edge: DrawnEdge) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the half-axes to the start and to the end."""
    assert edge.centre is not None
    x, y = edge.centre
    return (edge.start[0] - x, edge.start[1] - y), (edge.end[0] - x, edge.end[1] - y)


def _turn(edge: DrawnEdge) -> float:
    """Return 1 for a quarter that is anticlockwise from its start, else −1."""
    (a, b), (c, d) = _arms(edge)
    return 1.0 if a * d - b * c > 0.0 else -1.0


def _bulge(edge: DrawnEdge | Arc) -> float:
    """Return the tangent of a quarter of the angle of an arc, zero for a line."""
    if isinstance(edge, Arc):
        return tan(edge.sweep / 4.0)
    return 0.0 if edge.centre is None else _turn(edge) * tan(pi / 8.0)


def _entities(edges: Edges, low: float) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield what a contour with ellipses is made of."""
    for edge in edges:
        start, end = (*_mm(edge.start), low), (*_mm(edge.end), low)
        if edge.centre is None:
            yield "add_line", {"start": start, "end": end}
            continue
        if isinstance(edge, Arc):
            (x, y), is_left = edge.centre, edge.sweep > 0.0
            ends = (edge.start, edge.end) if is_left else (edge.end, edge.start)
            angles = [degrees(atan2(v - y, u - x)) for u, v in ends]
            yield (
                "add_arc",
                {
                    "center": (*_mm(edge.centre), low),
                    "radius": hypot(edge.start[0] - x, edge.start[1] - y) * MM,
                    "start_angle": angles[0],
                    "end_angle": angles[1],
                },
            )
            continue
        arms = _arms(edge)
        major = max(arms, key=lambda arm: hypot(*arm))
        minor = min(hypot(*arm) for arm in arms)
        first, _ = arms if _turn(edge) > 0.0 else arms[::-1]
        begin = atan2(*_along(first, major)[::-1])
        # both arms are half-axes: a quarter in the parameter of the ellipse, too
        begin = round(begin / (pi / 2.0)) * (pi / 2.0)
        yield (
            "add_ellipse",
            {
                "center": (*_mm(edge.centre), low),
                "major_axis": (*_mm(major), 0.0),
                "ratio": minor / hypot(*major),
                "start_param": begin,
                "end_param": begin + pi / 2.0,
            },
        )


def _along(arm: tuple[float, float], major: tuple[float, float]) -> tuple[float, float]:
    """Return an arm in the frame of the larger half-axis."""
    (x, y), (u, v) = arm, major
    return x * u + y * v, u * y - v * x
