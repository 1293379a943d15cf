"""Thick notches are as soft as plane bodies: finite elements at shapes that no fit has seen."""

import json
from functools import cache
from math import pi
from pathlib import Path

import pytest
from plates import notched_block, notched_plate
from pydantic import TypeAdapter
from specs_for_tests import in_steel

from flexcli.formulas.notch import bending_factor, circular_stiffness
from flexcli.parts.bending.thick import thick_linked
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries import AnyGeometry
from flexcli.results import Status

ELEMENTS = 1e-5
"""Error of the finite elements: what halving them changes."""


def circular(e):
    sizes = {"e": e, "depth": 1.0, "l": 2.0}
    return notched_plate.elliptic(**sizes), {"kind": "notch-hinge", "e": e, "r": 1.0}


def elliptic(**sizes):
    return notched_plate.elliptic(**sizes), {"kind": "elliptic-hinge", **sizes}


def filleted(**sizes):
    return notched_plate.filleted(**sizes), {"kind": "filleted-hinge", **sizes}


SHAPES = {
    "thin": circular(0.035),
    "circle": circular(0.15),
    "thick": circular(0.35),
    "as thick as round": circular(0.85),
    "deep": elliptic(e=0.1, depth=1.0, l=1.5),
    "deeper": elliptic(e=0.03, depth=1.0, l=0.7),
    "long": elliptic(e=0.3, depth=1.0, l=3.2),
    "shallow": elliptic(e=1.5, depth=1.0, l=10.0),
    "fillets": filleted(h=0.6, r=1.0, l=3.2),
    "small fillets": filleted(h=1.5, r=1.0, l=15.0),
    "smaller fillets": filleted(h=7.0, r=1.0, l=80.0),
}
BLOCKS = {
    "short": (0.05, 0.0), "square": (0.9, 0.0), "usual": (0.4, 0.2), "high": (1.2, 1.0),
    "long": (1.7, 0.0), "massive": (0.8, 1.6),
}  # fmt: skip
UNSTATED, STATED = ("short", "square", "usual", "high"), ("short", "square", "long", "massive")


@cache
def solid(shape, block, nu=0.3):
    length, rise = BLOCKS[block]
    return notched_plate.solid_over_beam(SHAPES[shape][0], block=length, rise=rise, nu=nu)


@cache
def shift(shape, block):
    length, rise = BLOCKS[block]
    return notched_plate.shift_over_beam(SHAPES[shape][0], block=length, rise=rise)


def spec(shape, **more):
    part = SHAPES[shape][1]
    sizes = {name: f"{x!r} mm" for name, x in part.items() if name != "kind"}
    return {"kind": part["kind"], **sizes, "b": "0.01 mm", **more}


def thick(shape, **more):
    hinge = TypeAdapter(AnyGeometry).validate_python(spec(shape, **more))
    return hinge.thick_notches(hinge.sized({}))


def stated(shape, block):
    """Return the blocks as a spec states them."""
    length, rise = BLOCKS[block]
    edges = SHAPES[shape][0]
    mouth = 2.0 * float(edges[-1](1.0)[1])
    return {"blocks": "massive" if rise else f"{length * mouth!r} mm"}


@pytest.mark.slow
@pytest.mark.parametrize("shape", SHAPES)
def test_a_notch_is_as_soft_as_the_plane_body_whether_its_blocks_are_stated_or_not(shape):
    told = [(block, thick(shape).factor) for block in UNSTATED]
    told += [(block, thick(shape, **stated(shape, block)).factor) for block in STATED]
    for block, factor in told:
        found = solid(shape, block)[0]
        assert factor.low - ELEMENTS <= found <= factor.high + ELEMENTS, block


@pytest.mark.slow
@pytest.mark.parametrize("block", ["short", "square", "massive"])
@pytest.mark.parametrize("shape", SHAPES)
def test_a_thick_notch_shifts_as_the_plane_body(shape, block):
    """To second order, by the work of an axial force on what the rotation strains."""
    found = shift(shape, block)
    for more in ({}, stated(shape, block)):
        low, high = thick(shape, **more).shift
        assert low <= found <= high


def test_blocks_that_bend_move_the_centre_of_a_thick_notch_further_than_it_softens():
    low, high = thick("thick", **stated("thick", "square")).shift
    assert 1.0 < low < shift("thick", "square") < high < 1.3


@pytest.mark.parametrize("block", ["square", "long"])
def test_stated_blocks_decide_what_is_open_without_them(block):
    geometry, of_beam = beam("as thick as round")
    true = float(of_beam * solid("as thick as round", block)[0])
    for share, verdict in ((1.03, Status.FAIL), (0.97, Status.PASS)):
        least = {"stiffness": {"min": f"{share * true!r} N*m/rad"}}
        assert in_steel(geometry | stated("as thick as round", block), least).status is verdict
        result = in_steel(geometry, least)
        if block == "square" and verdict is Status.PASS:
            assert result.status is Status.PASS  # no block gives way more
        elif block == "square":
            assert result.status is Status.UNDECIDED
            assert [note.code for note in result.warnings if "blocks" in note.text] == [
                "needs-blocks"
            ]


@pytest.mark.parametrize("shape", ["circle", "thick", "fillets"])
def test_poissons_ratio_changes_nothing_of_that(shape):
    """Hence plane strain, which is plane stress at E/(1 − ν²) and ν/(1 − ν), is the same."""
    factor = thick(shape).factor
    for nu in (0.0, 0.45 / 0.55):
        found, _ = solid(shape, "usual", nu)
        assert found == pytest.approx(solid(shape, "usual")[0], rel=2e-3)  # of its rigid ends
        assert factor.low <= found <= factor.high


@pytest.mark.parametrize("shape", ["circle", "thick", "as thick as round"])
def test_the_peak_over_the_nominal_stress_is_that_of_a_deep_notch(shape):
    """So that at a given rotation the stress falls as the stiffness does."""
    _, peak = solid(shape, "usual")
    assert peak == pytest.approx(bending_factor(e=SHAPES[shape][1]["e"], r=1.0), rel=3e-3)


@pytest.mark.parametrize("e", [0.05, 0.1])
def test_blocks_that_are_rigid_at_the_mouth_are_the_solids_between_rigid_bodies(e):
    solid_block = notched_block.stiffness(e=e, b=0.2 * e, nu=0.3)
    edges = notched_plate.elliptic(e=e, depth=1.0, l=2.0)
    beam = circular_stiffness(E=1.0, b=1.0, e=e, r=1.0)
    found, _ = notched_plate.solid_over_beam(edges, block=0.005)
    # the solid by polynomials is the stiffer, and a tenth of a throat's width is no plane stress
    assert found == pytest.approx(solid_block / beam, rel=2.5e-3)


def test_thicker_throats_are_unknown():
    shape = {"kind": "notch-hinge", "e": "1.1 mm", "r": "1 mm", "b": "2 mm"}
    hinge = TypeAdapter(AnyGeometry).validate_python(shape)
    assert hinge.thick_notches(hinge.sized({})).factor is None


def beam(shape):
    """Return the hinge in metres, E = 100 GPa, and the stiffness of its beam [N·m/rad]."""
    geometry = spec(shape)
    hinge = TypeAdapter(AnyGeometry).validate_python(geometry)
    return geometry, float(hinge.stiffness(Elastic(100e9), hinge.sized({})))


def row(checks, name):
    """Return the check of a requirement."""
    (found,) = (check for check in checks if check.name.startswith(name))
    return found


@pytest.mark.parametrize("model", ["closed-form", "linear", "exact", None])
@pytest.mark.parametrize("shape", ["circle", "deep", "fillets"])
def test_a_stiffness_above_the_solids_is_no_pass(shape, model):
    geometry, of_beam = beam(shape)
    true = float(of_beam * solid(shape, "usual")[0])
    assert 1.03 * true < of_beam  # which a beam would pass
    for share, passes in ((1.03, False), (0.95, True)):
        least = {"stiffness": {"min": f"{share * true!r} N*m/rad"}}
        result = in_steel(geometry, least, model)
        assert (result.status is Status.PASS) is passes


def test_a_frequency_above_the_solids_is_no_pass():
    geometry, of_beam = beam("circle")
    true = float(of_beam * solid("circle", "usual")[0] / 1e-4) ** 0.5 / (2.0 * pi)
    body = {"mechanism": {"kind": "payload", "mass": "1 g", "inertia": "1 kg*cm^2"}}
    for share, passes in ((1.02, False), (0.97, True)):
        least = {"frequency": {"min": f"{share * true!r} Hz"}}
        assert (in_steel(geometry, least, **body).status is Status.PASS) is passes


def joints(notch):
    """Return joints of which all hinges are the same notch of e/r = 0.15, or beams of none."""
    e, r, b = (notch[name] for name in ("e", "r", "b"))
    limb = {"e": e, "r": r, "l": "30 mm", "b": b}
    return {
        "stage": {"kind": "hinged-stage", "spacing": "20 mm", **limb},
        "pivot": {"kind": "hinged-pivot", "delta": 0.3, "half_angle": "40 deg", **limb},
        "drawn": {
            "kind": "layout",
            "bodies": {"arm": {"at": ["1 mm", "0 mm"]}},
            "blades": {
                "hinge": {
                    "between": ["ground", "arm"], "from": ["-1 mm", "0 mm"],
                    "to": ["1 mm", "0 mm"], "b": b,
                    "profile": {"kind": "notch", "e": e, "depth": r},
                }
            },
            "moving": "arm",
            "motion": "rotation",
            "centre": ["0 mm", "0 mm"],
        },
        "linkage": {
            "kind": "linkage",
            "ground": "base",
            "input": "a",
            "joints": {
                "a": {"links": ["base", "left"], "at": ["0 mm", "0 mm"], "flexure": notch},
                "b": {"links": ["left", "bar"], "at": ["0 mm", "30 mm"], "flexure": notch},
                "c": {"links": ["bar", "right"], "at": ["40 mm", "30 mm"], "flexure": notch},
                "d": {"links": ["right", "base"], "at": ["40 mm", "0 mm"], "flexure": notch},
            },
        },
    }  # fmt: skip


@pytest.mark.parametrize("name", ["stage", "pivot", "drawn", "linkage"])
def test_every_joint_is_as_soft_as_its_hinges(name):
    geometry = joints(spec("circle"))[name]
    unit = "N/m" if name == "stage" else "N*m/rad"
    least = {"stiffness": {"min": f"1 {unit}"}}
    of_hinge = solid("circle", "usual")[0]
    found = {
        kept: in_steel(
            geometry, least, "linear",
            effects={"thick-notch": kept},
        ).checks
        for kept in ("off", "auto")
    }  # fmt: skip
    soft, stiff = (row(found[kept], "stiffness") for kept in ("auto", "off"))
    assert soft.factor / stiff.factor == pytest.approx(of_hinge, rel=5e-3)


def test_at_a_given_stroke_the_throat_has_less_stress_and_under_a_load_no_less():
    geometry, _ = beam("circle")
    softer = solid("circle", "usual")[0]
    sound = {"yield": {"factor": 1}}
    turned = {"stroke": {"rotation": "1 mrad"}}
    pulled = {"load": {"force": "1 uN", "direction": "0 deg"}}
    stress = [
        in_steel(geometry, sound, "linear", cases={"use": {**turned, **more}}).checks
        for more in ({}, pulled)
    ]
    alone, loaded = (row(checks, "yield").demand for checks in stress)
    assert alone / loaded == pytest.approx(softer, rel=5e-3)


def test_hinges_that_soften_unlike_each_other_may_move_a_joint_by_as_much_either_way():
    """A drawn pivot of a thick notch beside a blade: what the notch changes may count twice."""
    thin, thick_one = thick("thin"), thick("thick")
    both = thick_linked([thin, thick_one, None])
    for part in (thin, thick_one):
        assert both.shift[0] <= min(part.factor.low, part.shift[0])
        assert both.shift[1] >= max(2.0 - part.factor.low, part.shift[1])


BLOCK = 30e-3
"""Length of the blocks [m]."""


@pytest.mark.parametrize("blocks", ["30 mm", "0 mm", None])
def test_support_deflection_and_sag_count_the_blocks_that_are_stated(blocks):
    """As soft as two bars from the mouth to the rigid bodies at least, about the middle between.

    Half of what such bars give way, or twice their stiffness, is asked of it.
    """
    e, r, b, E = 0.5e-3, 2e-3, 10e-3, 100e9
    H = e + 2.0 * r
    bars = 24.0 * ((r + BLOCK) ** 3 - r**3) / (3.0 * E * b * H**3)
    geometry = {"kind": "notch-hinge", "e": "0.5 mm", "r": "2 mm", "b": "10 mm"}
    if blocks is not None:
        geometry["blocks"] = blocks
    asked = {
        "support": {"direction": "y", "min": f"{2.0 / bars!r} N/m"},
        "deflection": {"direction": "y", "max": f"{50.0 * bars!r} m"},
        "sag": {"max": f"{50.0 * bars!r} m"},
    }
    cases = {
        "push": {"wrench": {"y": "100 N"}},
        "hang": {"acceleration": {"level": "100 m/s^2", "axis": "y"}},
    }
    body = {"kind": "payload", "mass": "1 kg", "inertia": "1 kg*cm^2"}
    found = in_steel(geometry, asked, cases=cases, mechanism=body).checks
    for name in asked:
        verdict = row(found, name).verdict.value
        assert verdict == ("fail" if blocks == "30 mm" else "pass")


def test_a_thick_notch_that_is_kept_wide_is_as_soft_as_the_solid():
    """``tests/benchmarks/hinges_in_space.py``, clamped at the mouth: ν from 0.3, b/e from 10."""
    rows = json.loads((Path(__file__).parents[1] / "mechanics/space/hinges.json").read_text())
    thick = [row for row in rows if row[0] == "notch" and row[1][0] > 0.2 and row[4] >= 0.3]
    wide = [row for row in thick if row[3] > 10.0 * row[1][0]]
    assert len(wide) >= 10
    for _, (e, depth), l, b, nu, solid in wide:
        sizes = {"e": e, "depth": depth, "l": l, "b": b}
        geometry = {"kind": "elliptic-hinge", "blocks": "0 mm"}
        geometry |= {name: f"{size} mm" for name, size in sizes.items()}
        k = 100e9 * solid[5]
        steel = {
            "name": "s",
            "youngs_modulus": "100 GPa",
            "poisson_ratio": nu,
            "density": "8 g/cm^3",
        }
        for share, status in ((0.87, Status.PASS), (1.13, Status.FAIL)):
            asked = {"stiffness": {"min": f"{share * k!r} N*m/rad"}}
            assert in_steel(geometry, asked, material=steel).status is status, (
                e,
                depth,
                l,
                b,
                nu,
            )
