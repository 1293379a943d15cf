"""What is exported is read again, and measures as the spec says."""

import io
import re
from math import atan, hypot, pi, sin
from pathlib import Path

import numpy as np
import pytest

import flexcli
from flexcli.errors import SolveError
from flexcli.report.prisms import BLADES, MM, prisms

EXAMPLES = Path(__file__).parents[2] / "examples"
DRAWN = (
    "boundary-control", "compound-stage", "force-balanced-stage", "four-hinge-stage",
    "generalized-cross-spring", "hinged-rcc-pivot", "lecture-leaf-spring", "linear-stage",
    "necked-down-stage", "unseparated-cross-spring", "wittrick-crossing",
)  # fmt: skip
"""Examples whose sizes are given and that are made of blades."""

NANOMETRE = 1e-6
"""In mm: what a size may differ by."""

ELLIPTIC = """\
flexure: 1
material: {name: ours, youngs_modulus: 114 GPa, poisson_ratio: 0.3}
geometry: {kind: elliptic-hinge, e: 0.2 mm, depth: 1 mm, l: 6 mm, b: 4 mm}
cases:
  a: {stroke: {rotation: 1 mrad}}
requirements: {stiffness: {min: 1 N*m/rad}}
"""
FILLETED = ELLIPTIC.replace(
    "elliptic-hinge, e: 0.2 mm, depth: 1 mm", "filleted-hinge, h: 0.2 mm, r: 0.5 mm"
)
ROUNDED = """\
flexure: 1
material: {name: ours, youngs_modulus: 114 GPa, poisson_ratio: 0.3}
geometry: {kind: guided-blade, h: 0.3 mm, l: 16 mm, b: 4 mm, root_radius: 0.4 mm}
cases:
  a: {stroke: {translation: 1 mm}}
requirements: {stiffness: {min: 1 N/m}}
"""
SPECS = {
    "elliptic": ELLIPTIC,
    "filleted": FILLETED,
    "fillets at the roots": ROUNDED,
    **{name: EXAMPLES / name / "flexure.yaml" for name in DRAWN},
}


@pytest.fixture(scope="module", params=SPECS)
def drawn(request):
    """Return the drawing of a design, and the volume of what flexes in it [m³]."""
    spec = flexcli.load(SPECS[request.param])
    geometry = spec.part.geometry
    return flexcli.joint_drawing(spec), float(geometry.volume(geometry.sized({})))


def area(edges):
    """Return the area within edges, by Green's theorem."""
    found = 0.0
    for (x, y), (u, v), centre in edges:
        if centre is None:
            found += (x * v - u * y) / 2.0
        else:
            a, b = centre
            found += (a * (v - y) - b * (u - x)) / 2.0
            found += pi / 4.0 * ((x - a) * (v - b) - (y - b) * (u - a))
    return found


def test_outlines_of_blades_hold_the_volume_of_what_flexes(drawn):
    drawing, volume = drawn
    blades = [p for p in prisms(drawing) if p.layer == BLADES]
    found = sum(area(p.edges) * (p.high - p.low) for p in blades)
    assert found == pytest.approx(volume, rel=1e-12)
    for each in prisms(drawing):
        ends = [edge.end for edge in each.edges]
        starts = [edge.start for edge in each.edges]
        gaps = [
            hypot(a - c, b - d)
            for (a, b), (c, d) in zip(ends, [*starts[1:], starts[0]], strict=True)
        ]
        assert max(gaps) < 1e-15


def test_a_dxf_has_every_outline_where_it_is(drawn):
    ezdxf = pytest.importorskip("ezdxf")
    from flexcli.report.export_dxf import dxf

    drawing, _ = drawn
    document = ezdxf.read(io.StringIO(dxf(prisms(drawing)).decode()))
    assert document.units == 4  # mm
    assert document.audit().errors == []
    space = list(document.modelspace())
    shapes = prisms(drawing)
    assert {entity.dxf.layer for entity in space} == {shape.layer for shape in shapes}
    corners = {
        (round(x * MM, 6), round(y * MM, 6))
        for shape in shapes for x, y in (edge.start for edge in shape.edges)
    }  # fmt: skip
    found = set()
    for entity in space:
        kind = entity.dxftype()
        if kind == "LWPOLYLINE":
            assert entity.closed
            found |= {(round(x, 6), round(y, 6)) for x, y in entity.get_points("xy")}
        elif kind == "LINE":
            found |= {(round(p.x, 6), round(p.y, 6)) for p in (entity.dxf.start, entity.dxf.end)}
        else:
            found |= {
                (round(p.x, 6), round(p.y, 6)) for p in (entity.start_point, entity.end_point)
            }
    assert near(corners, found)
    widths = {round((shape.high - shape.low) * MM, 6) for shape in shapes}
    polylines = [e for e in space if e.dxftype() != "ELLIPSE"]
    assert {round(entity.dxf.thickness, 6) for entity in polylines} <= widths


def near(ones, others):
    """Return whether two sets of places are the same, to a nanometre and a half."""
    a, b = (np.array(sorted(places)) for places in (ones, others))
    apart = np.hypot(*(a[:, None, :] - b[None, :, :]).transpose(2, 0, 1))
    return bool(
        (apart.min(axis=0) <= 1.5 * NANOMETRE).all()
        and (apart.min(axis=1) <= 1.5 * NANOMETRE).all()
    )


def test_the_arcs_of_a_dxf_leave_the_throat(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    from ezdxf import bbox, path

    for spec, throat in ((ELLIPTIC, 0.2), (FILLETED, 0.2)):
        content, _ = flexcli.exported(spec, "dxf")
        document = ezdxf.read(io.StringIO(content.decode()))
        blades = [e for e in document.modelspace() if e.dxf.layer == BLADES]
        places = np.array(
            [(p.x, p.y) for e in blades for p in path.make_path(e).flattening(1e-4, segments=64)]
        )
        x, y = np.abs(places.T)
        across = y if np.ptp(places[:, 0]) > np.ptp(places[:, 1]) else x
        assert 2.0 * across.min() == pytest.approx(throat, abs=NANOMETRE)
        size = bbox.extents(blades).size
        assert max(size.x, size.y) == pytest.approx(6.0, abs=NANOMETRE)


def test_a_step_has_a_named_part_of_each_size(drawn, tmp_path):
    pytest.importorskip("OCP")
    from OCP.Bnd import Bnd_Box
    from OCP.BRepBndLib import BRepBndLib
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_SOLID
    from OCP.TopExp import TopExp_Explorer

    from flexcli.report.export_solid import step

    drawing, volume = drawn
    content = step(prisms(drawing))
    shapes = prisms(drawing)
    for shape in shapes:
        assert f"PRODUCT('{shape.name}'".encode() in content
    path = tmp_path / "parts.step"
    path.write_bytes(content)
    reader = STEPControl_Reader()
    assert reader.ReadFile(str(path)).name == "IFSelect_RetDone"
    reader.TransferRoots()
    explorer = TopExp_Explorer(reader.OneShape(), TopAbs_SOLID)
    parts = []
    while explorer.More():
        solid = explorer.Current()
        assert BRepCheck_Analyzer(solid).IsValid()
        mass, box = GProp_GProps(), Bnd_Box()
        BRepGProp.VolumeProperties_s(solid, mass, 1e-12)
        BRepBndLib.AddOptimal_s(solid, box, False, False)
        low, high = box.CornerMin(), box.CornerMax()
        ends = (low.X(), low.Y(), low.Z(), high.X(), high.Y(), high.Z())
        parts.append((mass.Mass(), ends))
        explorer.Next()
    assert len(parts) == len(shapes)
    # volumes are integrated: exact for flat faces, to some 1e-9 for curved ones
    found = sorted(volume for volume, _ in parts)
    wanted = sorted(area(shape.edges) * (shape.high - shape.low) * MM**3 for shape in shapes)
    assert found == pytest.approx(wanted, rel=1e-7)
    boxes = np.array([ends for _, ends in parts])
    for shape in shapes:
        if any(edge.centre is not None for edge in shape.edges):
            continue
        at = np.array([edge.start for edge in shape.edges])
        ends = np.array([*at.min(axis=0), shape.low, *at.max(axis=0), shape.high]) * MM
        assert np.abs(boxes - ends).max(axis=1).min() < NANOMETRE
    blades = sum(area(s.edges) * (s.high - s.low) for s in shapes if s.layer == BLADES)
    assert blades == pytest.approx(volume, rel=1e-12)


def test_the_text_of_a_step_has_every_corner_in_millimetres(drawn):
    """Its entities as ISO 10303-21 writes them, without the kernel that wrote them."""
    pytest.importorskip("OCP")
    from flexcli.report.export_solid import step

    shapes = prisms(drawn[0])
    text = re.sub(r"\s", "", step(shapes).decode("ascii"))
    entities = dict(re.findall(r"#(\d+)=([^;]*);", text))
    lengths = [entity for entity in entities.values() if "LENGTH_UNIT" in entity]
    assert lengths
    assert all("SI_UNIT(.MILLI.,.METRE.)" in entity for entity in lengths)
    found = []
    for entity in entities.values():
        if at := re.fullmatch(r"VERTEX_POINT\('[^']*',#(\d+)\)", entity):
            place = re.fullmatch(r"CARTESIAN_POINT\('[^']*',\((.*)\)\)", entities[at[1]])
            found.append([float(x) for x in place[1].split(",")])
    wanted = [
        [*(c * MM for c in edge.start), height * MM]
        for shape in shapes
        for edge in shape.edges
        for height in (shape.low, shape.high)
    ]
    assert len(found) == len(wanted)
    apart = np.abs(np.subtract(np.array(found)[:, None], np.array(wanted))).max(axis=2)
    assert apart.min(axis=0).max() < NANOMETRE
    assert apart.min(axis=1).max() < NANOMETRE


def test_an_stl_is_closed_and_as_long_as_single_precision_tells():
    pytest.importorskip("OCP")
    content, _ = flexcli.exported(EXAMPLES / "lecture-leaf-spring" / "flexure.yaml", "stl")
    kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("spare", "<u2")])
    triangles = np.frombuffer(content[84:], kind)
    assert triangles.size == np.frombuffer(content[80:84], "<u4")[0]
    corners = triangles["corners"].astype(np.float64)
    a, b, c = np.moveaxis(corners, 1, 0)
    found = float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum()) / 6.0
    drawing = flexcli.joint_drawing(EXAMPLES / "lecture-leaf-spring" / "flexure.yaml")
    wanted = sum(area(s.edges) * (s.high - s.low) for s in prisms(drawing)) * MM**3
    # single precision keeps 1e-7 of a place: of a blade of 0.2 mm some 3e-5 of the thickness
    assert found == pytest.approx(wanted, rel=1e-5)


def test_a_round_bar_and_a_linkage_of_pins_are_no_prisms():
    bar = ELLIPTIC.replace(
        "{kind: elliptic-hinge, e: 0.2 mm, depth: 1 mm, l: 6 mm, b: 4 mm}",
        "{kind: round-torsion-bar, d: 1 mm, l: 20 mm}",
    )
    with pytest.raises(SolveError, match="draws no blades"):
        prisms(flexcli.joint_drawing(bar))


FREE = ("mercury-three-blade-pivot", "rocket-parallel-stage")
"""Examples whose sizes are chosen, to an end."""

ENDLESS = "crank-linear-stage"
"""The one whose sizes have no end: it is given some."""

READ = sorted(path.parent.name for path in EXAMPLES.glob("*/flexure.yaml"))

NO_PLANE = "tripod-mount"
"""The one whose rods stand across no common plane."""


def of_given_sizes(name):
    """Return an example with numbers for its sizes."""
    path = EXAMPLES / name / "flexure.yaml"
    if name == ENDLESS:
        return flexcli.load(path.read_text(encoding="utf-8").replace("h: free", "h: 0.3 mm"))
    spec = flexcli.load(path)
    return flexcli.sized(spec, flexcli.size(spec)) if name in FREE else spec


def volume_of(spec):
    """Return the volume of all that flexes in a design, whole [mm³]."""
    geometry, mechanism = spec.part.geometry, spec.part.mechanism
    joints = 1 if mechanism is None else mechanism.joints
    return joints * float(geometry.volume(geometry.sized({}))) * MM**3


IN_SPACE = (
    "butterfly-pivot",
    "folded-stage",
    "kinematic-mount",
    "leaf-spring-guide",
    "tripod-mount",
)


@pytest.mark.parametrize("name", READ)
def test_every_example_is_read_again_and_has_the_volume_of_its_design(name, tmp_path):
    pytest.importorskip("OCP")
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_SOLID
    from OCP.TopExp import TopExp_Explorer

    spec = of_given_sizes(name)
    parts = prisms(flexcli.drawing(spec))
    path = tmp_path / "parts.step"
    path.write_bytes(flexcli.exported(spec, "step")[0])
    reader = STEPControl_Reader()
    assert reader.ReadFile(str(path)).name == "IFSelect_RetDone"
    reader.TransferRoots()
    explorer, volumes = TopExp_Explorer(reader.OneShape(), TopAbs_SOLID), []
    while explorer.More():
        assert BRepCheck_Analyzer(explorer.Current()).IsValid()
        mass = GProp_GProps()
        BRepGProp.VolumeProperties_s(explorer.Current(), mass, 1e-9)
        volumes.append(mass.Mass())
        explorer.Next()
    assert len(volumes) == len(parts)
    assert len(volumes) == len(parts)
    flexes = sum(v for v, part in zip(volumes, parts, strict=True) if part.layer == BLADES)
    # volumes are integrated: exact for flat faces, to some 1e-9 for curved ones
    assert flexes == pytest.approx(volume_of(spec), rel=1e-7)


def area_of(polyline):
    """Return the area within a polyline of lines and arcs, whichever way round it goes [mm²]."""
    points, found = polyline.get_points("xyb"), 0.0
    for (x, y, bulge), (u, v, _) in zip(points, [*points[1:], points[0]], strict=True):
        turn, chord = 4.0 * atan(bulge), hypot(u - x, v - y)
        found += (x * v - u * y) / 2.0
        if turn:
            found += (chord / (2.0 * sin(turn / 2.0))) ** 2 * (turn - sin(turn)) / 2.0
    return abs(found)


@pytest.mark.parametrize("name", [name for name in READ if name != NO_PLANE])
def test_the_outlines_of_every_example_hold_the_volume_of_its_design(name):
    ezdxf = pytest.importorskip("ezdxf")
    spec = of_given_sizes(name)
    document = ezdxf.read(io.StringIO(flexcli.exported(spec, "dxf")[0].decode()))
    assert document.units == 4  # mm
    assert document.audit().errors == []
    blades = [entity for entity in document.modelspace() if entity.dxf.layer == BLADES]
    assert {entity.dxftype() for entity in blades} == {"LWPOLYLINE"}
    assert all(entity.closed for entity in blades)
    flexes = sum(area_of(entity) * entity.dxf.thickness for entity in blades)
    # sixteen digits of a place leave some thirteen of a thin blade's area
    assert flexes == pytest.approx(volume_of(spec), rel=1e-10)


@pytest.mark.parametrize("name", IN_SPACE)
def test_a_step_in_space_has_every_corner_of_blades_and_rods_where_it_is(name):
    """Read as ISO 10303-21 writes it, without the kernel that wrote it."""
    pytest.importorskip("OCP")
    content, _ = flexcli.exported(EXAMPLES / name / "flexure.yaml", "step")
    text = re.sub(r"\s", "", content.decode("ascii"))
    entities = dict(re.findall(r"#(\d+)=([^;]*);", text))
    found = []
    for entity in entities.values():
        if at := re.fullmatch(r"VERTEX_POINT\('[^']*',#(\d+)\)", entity):
            place = re.fullmatch(r"CARTESIAN_POINT\('[^']*',\((.*)\)\)", entities[at[1]])
            found.append([float(x) for x in place[1].split(",")])
    part = flexcli.load(EXAMPLES / name / "flexure.yaml").part
    layout = part.geometry.space_layout(part.material.elastic, part.geometry.sized({}))
    wanted = []
    for member in layout.blades:
        _, y, z = member.axes
        d = getattr(member, "d", None)
        if d is None:
            h, b = float(member.profile.h), member.b
            corners = [s * h / 2.0 * y + t * b / 2.0 * z for s in (-1, 1) for t in (-1, 1)]
        else:
            corners = [s * d / 2.0 * way for s in (-1, 1) for way in (y, z)]
        wanted += [np.asarray(end) + c for end in (member.start, member.end) for c in corners]
    apart = np.abs(np.array(found)[:, None] - MM * np.array(wanted)).max(axis=2)
    assert apart.min(axis=0).max() < NANOMETRE


def test_what_stands_on_no_plane_has_no_outline_in_one():
    pytest.importorskip("ezdxf")
    with pytest.raises(SolveError, match="no common plane"):
        flexcli.exported(EXAMPLES / NO_PLANE / "flexure.yaml", "dxf")
