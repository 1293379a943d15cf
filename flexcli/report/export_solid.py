"""A mechanism as solids, in mm: STEP with a named part for each blade and body, or STL."""

from collections.abc import Callable
from functools import partial
from importlib import import_module
from math import hypot
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from flexcli.errors import SolveError
from flexcli.report.prisms import MM, Prism, prisms
from flexcli.results.drawing import XY, Drawing, DrawnEdge

__all__ = ["step", "stl"]

CHORD, ANGLE = 1e-3, 0.1
"""Of an STL: how far its triangles lie off a curve at most [mm], and turn along it [rad]."""


def step(drawing: Drawing) -> bytes:
    """Return a STEP file (AP 214) of all parts at rest.

    Raises
    ------
    SolveError
        When the library is not installed, or nothing of the drawing can be cut.

    """
    shapes = prisms(drawing)
    _library()
    caf, names, tools = (_part(name) for name in ("XCAFApp", "TDataStd", "XCAFDoc"))
    document = _part("TDocStd").TDocStd_Document(_text("XmlXCAF"))
    caf.XCAFApp_Application.GetApplication_s().InitDocument(document)
    assembly = tools.XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    for shape in shapes:
        label = assembly.AddShape(_solid(shape), False)
        names.TDataStd_Name.Set_s(label, _text(shape.name))
    writer = _part("STEPCAFControl").STEPCAFControl_Writer()
    writer.Transfer(document, _part("STEPControl").STEPControl_StepModelType.STEPControl_AsIs)
    return _written(writer.Write)


def stl(drawing: Drawing) -> bytes:
    """Return the triangles of all parts at rest, as binary STL: single precision.

    Raises
    ------
    SolveError
        When the library is not installed, or nothing of the drawing can be cut.

    """
    shapes = prisms(drawing)
    _library()
    compound, builder = _part("TopoDS").TopoDS_Compound(), _part("BRep").BRep_Builder()
    builder.MakeCompound(compound)
    for shape in shapes:
        builder.Add(compound, _solid(shape))
    _part("BRepMesh").BRepMesh_IncrementalMesh(compound, CHORD, False, ANGLE, False)
    writer = _part("StlAPI").StlAPI_Writer()
    writer.ASCIIMode = False
    return _written(partial(writer.Write, compound))


def _written(write: Callable[[str], Any]) -> bytes:
    """Return what the library writes, which it does to files alone."""
    with TemporaryDirectory(prefix="flexure-") as folder:
        path = Path(folder) / "parts"
        write(str(path))
        return path.read_bytes()


def _library() -> None:
    """Find the library, and keep it from telling on stdout what it writes."""
    try:
        message = _part("Message")
    except ImportError as error:
        text = "STEP and STL need the extra 'cad'"
        raise SolveError("no-cad", text, "pip install 'flexcli[cad]'") from error
    for printer in message.Message.DefaultMessenger_s().Printers():
        printer.SetTraceLevel(message.Message_Gravity.Message_Fail)


def _part(name: str) -> Any:
    return import_module(f"OCP.{name}")


def _text(text: str) -> Any:
    return _part("TCollection").TCollection_ExtendedString(text)


def _solid(shape: Prism) -> Any:
    """Return the outline as a face, pushed through the width."""
    build, make, gp = _part("BRepBuilderAPI"), _part("BRepPrimAPI"), _part("gp")
    low = shape.low * MM
    wire = build.BRepBuilderAPI_MakeWire()
    for edge in shape.edges:
        wire.Add(build.BRepBuilderAPI_MakeEdge(_curve(edge, low)).Edge())
    face = build.BRepBuilderAPI_MakeFace(wire.Wire(), True).Face()
    through = gp.gp_Vec(0.0, 0.0, (shape.high - shape.low) * MM)
    return make.BRepPrimAPI_MakePrism(face, through).Shape()


def _curve(edge: DrawnEdge, z: float) -> Any:
    """Return an edge as a trimmed curve."""
    gp, gc = _part("gp"), _part("GC")

    def point(place: XY) -> Any:
        return gp.gp_Pnt(place[0] * MM, place[1] * MM, z)

    start, end = point(edge.start), point(edge.end)
    if edge.centre is None:
        return gc.GC_MakeSegment(start, end).Value()
    x, y = edge.centre
    arms = [(a - x, b - y) for a, b in (edge.start, edge.end)]
    (a, b), (c, d) = arms
    is_ccw = a * d - b * c > 0.0
    major = max(arms, key=lambda arm: hypot(*arm))
    sizes = sorted((hypot(*arm) * MM for arm in arms), reverse=True)
    axes = gp.gp_Ax2(point(edge.centre), gp.gp_Dir(0.0, 0.0, 1.0), gp.gp_Dir(*major, 0.0))
    first, last = (start, end) if is_ccw else (end, start)
    ellipse = gp.gp_Elips(axes, sizes[0], sizes[1])
    return gc.GC_MakeArcOfEllipse(ellipse, first, last, True).Value()
