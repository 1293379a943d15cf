"""A mechanism as solids, in mm: STEP with a named part for each blade and body, or STL."""

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from flexcli.report.cad_kernel import face, library, part
from flexcli.report.prisms import MM, Prism

__all__ = ["step", "stl"]

CHORD, ANGLE = 1e-3, 0.1
"""Of an STL: how far its triangles lie off a curve at most [mm], and turn along it [rad]."""


def step(shapes: Sequence[Prism]) -> bytes:
    """Return a STEP file (AP 214) of all parts at rest.

    Raises
    ------
    SolveError
        When the library is not installed.

    """
    library()
    caf, names, tools = (part(name) for name in ("XCAFApp", "TDataStd", "XCAFDoc"))
    document = part("TDocStd").TDocStd_Document(_text("XmlXCAF"))
    caf.XCAFApp_Application.GetApplication_s().InitDocument(document)
    assembly = tools.XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    for shape in shapes:
        label = assembly.AddShape(_solid(shape), False)
        names.TDataStd_Name.Set_s(label, _text(shape.name))
    writer = part("STEPCAFControl").STEPCAFControl_Writer()
    writer.Transfer(document, part("STEPControl").STEPControl_StepModelType.STEPControl_AsIs)
    return _written(writer.Write)


def stl(shapes: Sequence[Prism]) -> bytes:
    """Return the triangles of all parts at rest, as binary STL: single precision.

    Raises
    ------
    SolveError
        When the library is not installed.

    """
    library()
    compound, builder = part("TopoDS").TopoDS_Compound(), part("BRep").BRep_Builder()
    builder.MakeCompound(compound)
    for shape in shapes:
        builder.Add(compound, _solid(shape))
    part("BRepMesh").BRepMesh_IncrementalMesh(compound, CHORD, False, ANGLE, False)
    writer = part("StlAPI").StlAPI_Writer()
    writer.ASCIIMode = False
    return _written(partial(writer.Write, compound))


def _written(write: Callable[[str], Any]) -> bytes:
    """Return what the library writes, which it does to files alone."""
    with TemporaryDirectory(prefix="flexure-") as folder:
        path = Path(folder) / "parts"
        write(str(path))
        return path.read_bytes()


def _text(text: str) -> Any:
    return part("TCollection").TCollection_ExtendedString(text)


def _solid(shape: Prism) -> Any:
    """Return the outline as a face, pushed through the width."""
    make, gp = part("BRepPrimAPI"), part("gp")
    through = gp.gp_Vec(0.0, 0.0, (shape.high - shape.low) * MM)
    plane = face(shape.edges, shape.holes, shape.low)
    solid = make.BRepPrimAPI_MakePrism(plane, through).Shape()
    if not shape.axes:
        return solid
    x, _, z = (gp.gp_Dir(*axis) for axis in shape.axes)
    there, placed = gp.gp_Trsf(), gp.gp_Ax3(gp.gp_Pnt(*(c * MM for c in shape.origin)), z, x)
    there.SetTransformation(placed, gp.gp_Ax3())
    return part("BRepBuilderAPI").BRepBuilderAPI_Transform(solid, there, True).Shape()
