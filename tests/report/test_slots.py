"""What a wire cuts is measured by other libraries, and what it cannot cut is refused."""

import io
from math import atan2, pi
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest

import flexcli
from flexcli.errors import SolveError, SpecError

ezdxf = pytest.importorskip("ezdxf")
pytest.importorskip("OCP")

SPEC = """\
flexure: 1
material: {{name: ours, youngs_modulus: 114 GPa, poisson_ratio: 0.3}}
geometry: {geometry}
cases:
  a: {{stroke: {{{stroke}}}}}
requirements: {{stiffness: {{min: 1 {unit}}}}}
manufacturing: {{process: wire-edm, {making}}}
"""
WIRE = "wire: 0.25 mm, spark_gap: 25 um"
GAP, RADIUS = 0.3, 0.15  # mm, of that wire
STAGE = (
    "{kind: leaf-spring-stage, h: 0.3 mm, l: 16 mm, b: 4 mm, spacing: 10 mm, root_radius: 0.2 mm}"
)
NANOMETRE = 1e-6  # mm


def spec(geometry, making=WIRE, stroke="translation: 0.1 mm"):
    unit = "N/m" if stroke.startswith("t") else "N*m/rad"
    return SPEC.format(geometry=geometry, making=making, stroke=stroke, unit=unit)


def turning(geometry, making=WIRE):
    return spec(geometry, making, "rotation: 1 mrad")


PIVOT = (
    "{kind: rcc, p: 3 mm, half_angle: 40 deg, h: 0.3 mm, l: 12 mm, b: 6 mm, root_radius: 0.3 mm}"
)
NOTCH = "{kind: notch-hinge, e: 0.2 mm, r: 1 mm, b: 4 mm}"
LIMBS = "{kind: hinged-stage, e: 0.2 mm, r: 1 mm, l: 20 mm, b: 5 mm, spacing: 10 mm}"
# on two sides of a slot: the stage hangs below the plate that its blades come out of
DRAWN = (
    f"{WIRE}, slot: 0.4 mm, outlines: "
    "{ground: [[-9 mm, 6 mm], [9 mm, 6 mm], [9 mm, -15.6 mm], [-9 mm, -15.6 mm]], "
    "moving: [[-9 mm, -16 mm], [9 mm, -16 mm], [9 mm, -20 mm], [-9 mm, -20 mm]]}"
)


def contours(text):
    """Return (layer, points with bulges) of every closed contour of a DXF, in mm."""
    content, _ = flexcli.exported(text, "dxf")
    document = ezdxf.read(io.StringIO(content.decode()))
    assert document.units == 4  # mm
    assert document.audit().errors == []
    lines = list(document.modelspace())
    assert all(line.dxftype() == "LWPOLYLINE" and line.closed for line in lines)
    return [(line.dxf.layer, list(line.get_points("xyb"))) for line in lines]


def edges(points):
    return zip(points, [*points[1:], points[0]], strict=True)


def arc(one, other):
    """Return centre and radius of a bulge."""
    centre, _, _, radius = ezdxf.math.bulge_to_arc(one[:2], other[:2], one[2])
    return centre, radius


def area(points):
    """Return the area within lines and arcs, positive anticlockwise."""
    found = 0.0
    for (x, y, bulge), (u, v, _) in edges(points):
        found += (x * v - u * y) / 2.0
        if bulge:
            angle, radius = 4.0 * np.arctan(bulge), arc((x, y, bulge), (u, v, 0.0))[1]
            found += radius**2 * (angle - np.sin(angle)) / 2.0
    return found


def plate_volume(text):
    """Return the volume [mm³] of the only solid of a STEP file."""
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_SOLID
    from OCP.TopExp import TopExp_Explorer

    content, _ = flexcli.exported(text, "step")
    reader = STEPControl_Reader()
    with TemporaryDirectory() as folder:
        path = Path(folder) / "plate.step"
        path.write_bytes(content)
        assert reader.ReadFile(str(path)).name == "IFSelect_RetDone"
    reader.TransferRoots()
    explorer = TopExp_Explorer(reader.OneShape(), TopAbs_SOLID)
    solids = []
    while explorer.More():
        solids.append(explorer.Current())
        explorer.Next()
    (solid,) = solids
    assert BRepCheck_Analyzer(solid).IsValid()
    mass = GProp_GProps()
    BRepGProp.VolumeProperties_s(solid, mass, 1e-12)
    return mass.Mass()


def test_the_volume_of_a_plate_is_that_of_its_bodies_and_blades():
    text = spec(STAGE, DRAWN)
    h, l, b, r, slot, R = 0.3, 16.0, 4.0, 0.2, 0.4, RADIUS
    corner = 1.0 - pi / 4.0
    blades = 2 * (h * l + 4 * corner * r**2)
    half = max(h / 2 + slot, h / 2 + r + R)
    rooms = 2 * (2 * half * (l - slot) - 2 * corner * R**2)
    wanted = 18.0 * (6.0 + l - slot) - rooms + 18.0 * 4.0 + blades
    found = contours(text)
    assert [layer for layer, _ in found] == ["PLATE", "SLOTS"]  # one between the blades is closed
    assert sum(area(points) for _, points in found) == pytest.approx(wanted, rel=1e-9)
    assert plate_volume(text) == pytest.approx(wanted * b, rel=1e-9)


@pytest.mark.parametrize("text", [spec(STAGE), turning(PIVOT), turning(NOTCH), spec(LIMBS)])
def test_slots_are_closed_and_no_inner_corner_is_sharper_than_the_wire(text):
    found = contours(text)
    assert sorted({layer for layer, _ in found}) == ["PLATE", "SLOTS"]
    for layer, points in found:
        # metal is on the left: the plate anticlockwise, holes clockwise
        assert bool(area(points) > 0.0) is (layer == "PLATE")
        for one, other in edges(points):
            if one[2] < 0.0:
                assert arc(one, other)[1] >= RADIUS - NANOMETRE
        for before, at, after in zip([points[-1], *points[:-1]], points, [*points[1:], points[0]],
                                     strict=True):  # fmt: skip
            came = atan2(at[1] - before[1], at[0] - before[0]) + 2.0 * np.arctan(before[2])
            goes = atan2(after[1] - at[1], after[0] - at[0]) - 2.0 * np.arctan(at[2])
            turn = (goes - came + pi) % (2.0 * pi) - pi
            assert turn > -1e-4  # the kernel's places are good to 1e-7 mm


def test_blade_and_slots_beside_it_are_as_wide_as_stated():
    for making, slot in ((WIRE, GAP), (f"{WIRE}, slot: 0.5 mm", 0.5)):
        crossed = []
        for _, points in contours(spec(STAGE, making)):
            for (x, y, _), (u, v, _) in edges(points):
                if (y + 8.0) * (v + 8.0) < 0.0:
                    crossed.append(x + (u - x) * (-8.0 - y) / (v - y))
        at = np.sort(crossed)[1:-1]  # between the sides of the plate
        half = max(0.15 + slot, 0.15 + 0.2 + RADIUS)
        wanted = [x + t for x in (-5.0, 5.0) for t in (-half, -0.15, 0.15, half)]
        assert np.abs(at - wanted).max() < NANOMETRE


def test_the_throat_of_a_notch_is_between_two_arcs():
    arcs = {
        (round(arc(one, other)[0].y, 6), round(arc(one, other)[1], 6))
        for _, points in contours(turning(NOTCH)) for one, other in edges(points)
        if one[2] < 0.0 and arc(one, other)[1] > 0.5
    }  # fmt: skip
    assert arcs == {(1.1, 1.0), (-1.1, 1.0)}  # e = 0.2 between circles of 1 mm


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (spec(STAGE.replace(", root_radius: 0.2 mm", "")), "roots of blade 1 are sharp"),
        (spec(STAGE.replace("0.2 mm}", "0.1 mm}")), "inner radius .* 0.1 mm"),
        (spec(STAGE.replace("10 mm,", "0.95 mm,")), "blade 1 and blade 2 are 0.25 mm apart"),
        (turning(NOTCH.replace("r: 1 mm", "r: 0.14 mm")), "0.28 mm long"),
        (turning("{kind: cross-spring, delta: -0.3, half_angle: 45 deg, h: 0.3 mm, l: 12 mm, "
                 "b: 6 mm, root_radius: 0.2 mm}"), "several heights"),
        (turning("{kind: torsion-bar, h: 1 mm, l: 20 mm, b: 2 mm}"), "not planar"),
        (spec(STAGE, f"{WIRE}, outlines: {{table: [[0 mm, 0 mm], [1 mm, 0 mm], [0 mm, 1 mm]]}}"),
         "no body 'table'"),
        (spec(STAGE, f"{WIRE}, outlines: {{moving: [[-9 mm, -17 mm], [9 mm, -17 mm], "
                     "[9 mm, -20 mm], [-9 mm, -20 mm]]}"), "moving and ground are one piece"),
        (spec(STAGE, f"{WIRE}, outlines: {{moving: [[-5.5 mm, -16 mm], [-4.5 mm, -16 mm], "
                     "[-4.5 mm, 3 mm], [4.5 mm, 3 mm], [4.5 mm, -16 mm], [5.5 mm, -16 mm], "
                     "[5.5 mm, -20 mm], [-5.5 mm, -20 mm]]}"), "an inner corner"),
    ],
)  # fmt: skip
def test_what_no_wire_can_cut_is_one_finding(text, told):
    with pytest.raises(SolveError, match=told):
        flexcli.exported(text, "dxf")


def test_its_own_parts_are_written_when_they_shall_be():
    plain, _ = flexcli.exported(spec(STAGE.replace(", root_radius: 0.2 mm", "")), "dxf", plain=True)
    layers = {e.dxf.layer for e in ezdxf.read(io.StringIO(plain.decode())).modelspace()}
    assert layers == {"BLADES", "BODIES", "GROUND"}


def test_a_stroke_beyond_the_slots_is_told():
    _, notes = flexcli.exported(spec(STAGE, stroke="translation: 1 mm"), "dxf")
    assert any("1 mm, the slots are 0.3 mm" in note for note in notes)
    _, notes = flexcli.exported(spec(STAGE), "dxf")
    assert not any("stop the stroke" in note for note in notes)


@pytest.mark.parametrize(
    ("making", "told"),
    [
        (f"{WIRE}, slot: 0.2 mm", "narrower"),
        ("least_thickness: 60 um, spark_gap: 20 um", "beside a wire"),
        ("least_thickness: 60 um, slot: 1 mm", "no wire"),
    ],
)
def test_slots_that_contradict_the_wire_are_refused_with_the_spec(making, told):
    with pytest.raises(SpecError, match=told):
        flexcli.load(spec(STAGE, making))
