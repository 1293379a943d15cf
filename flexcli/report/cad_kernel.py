"""Faces and solids of the geometry kernel: from outlines in metres to its shapes in mm."""

from importlib import import_module
from math import hypot
from typing import Any

from flexcli.errors import SolveError
from flexcli.report.prisms import MM, Arc, Edges, is_round
from flexcli.results.drawing import XY, DrawnEdge

__all__ = ["face", "library", "part"]


def part(name: str) -> Any:
    """Return a module of the kernel."""
    return import_module(f"OCP.{name}")


def library() -> None:
    """Find the kernel, and silence what it prints on stdout.

    Raises
    ------
    SolveError
        When it is not installed.

    """
    try:
        message = part("Message")
    except ImportError as error:
        text = "STEP, STL and slots need the extra 'cad'"
        raise SolveError("no-cad", text, "pip install 'flexcli[cad]'") from error
    for printer in message.Message.DefaultMessenger_s().Printers():
        printer.SetTraceLevel(message.Message_Gravity.Message_Fail)


def face(edges: Edges, holes: tuple[Edges, ...] = (), z: float = 0.0) -> Any:
    """Return the plane face within an outline and without its holes, at a height [m]."""
    build = part("BRepBuilderAPI")
    made = build.BRepBuilderAPI_MakeFace(_wire(edges, z), True)
    for hole in holes:
        made.Add(_wire(hole, z))
    return made.Face()


def _wire(edges: Edges, z: float) -> Any:
    build = part("BRepBuilderAPI")
    wire = build.BRepBuilderAPI_MakeWire()
    for edge in edges:
        wire.Add(build.BRepBuilderAPI_MakeEdge(_curve(edge, z * MM)).Edge())
    return wire.Wire()


def _curve(edge: DrawnEdge | Arc, z: float) -> Any:
    """Return an edge as a trimmed curve."""
    gp, gc = part("gp"), part("GC")

    def point(place: XY) -> Any:
        return gp.gp_Pnt(place[0] * MM, place[1] * MM, z)

    start, end = point(edge.start), point(edge.end)
    if edge.centre is None:
        return gc.GC_MakeSegment(start, end).Value()
    x, y = edge.centre
    arms = [(a - x, b - y) for a, b in (edge.start, edge.end)]
    centre, up = point(edge.centre), gp.gp_Dir(0.0, 0.0, 1.0)
    (a, b), (c, d) = arms
    is_left = edge.sweep > 0.0 if isinstance(edge, Arc) else a * d - b * c > 0.0
    first, last = (start, end) if is_left else (end, start)
    if is_round(edge):
        circle = gp.gp_Circ(gp.gp_Ax2(centre, up), hypot(a, b) * MM)
        return gc.GC_MakeArcOfCircle(circle, first, last, True).Value()
    major = max(arms, key=lambda arm: hypot(*arm))
    sizes = sorted((hypot(*arm) * MM for arm in arms), reverse=True)
    axes = gp.gp_Ax2(centre, up, gp.gp_Dir(*major, 0.0))
    ellipse = gp.gp_Elips(axes, sizes[0], sizes[1])
    return gc.GC_MakeArcOfEllipse(ellipse, first, last, True).Value()
