"""An actuator on the command line: sizes are chosen by it, what it lacks is told."""

import json

import pytest

SPEC = """
flexure: 1
material: {youngs_modulus: 114 GPa, poisson_ratio: 0.34, yield_strength: 880 MPa}
geometry: {kind: leaf-spring-stage, h: {free: [0.1 mm, 0.6 mm]}, l: 12 mm, b: 3 mm,
           blades: 4, spacing: 3 mm}
actuator: {blocking_force: 5.5 N, free_stroke: 85 um, drives: both-ways}
stroke: {translation: 50 um}
requirements: {drive: 1.2, yield: 2}
size: {objective: {maximize: h}}
"""


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "flexure.yaml"
    path.write_text(SPEC)
    return path


def test_the_thickest_blades_leave_the_reserve_that_is_asked(flexure, spec):
    told = flexure("size", str(spec), "--format", "json")
    assert told.returncode == 0
    document = json.loads(told.stdout)
    (drive,) = (check for check in document["checks"] if check["name"] == "drive")
    left = 5.5 * (1.0 - 50.0 / 85.0)
    assert drive["capacity"] == pytest.approx(left, rel=1e-9)
    assert 1.2 <= drive["factor_range"][0] < 1.21
    # k = 4 E b (h/l)³ of beams, which plates exceed by up to 1/(1 − ν²)
    beams = (left / 1.2 / 50e-6 / (4.0 * 114e9 * 3e-3)) ** (1.0 / 3.0) * 12e-3
    h = document["values"]["h"]["value"]
    assert 0.95 * beams < h < beams


def test_a_stroke_that_it_does_not_reach_exits_1(flexure, spec):
    told = flexure("check", str(spec), "--set", "geometry.h=0.55mm")
    assert told.returncode == 1
    assert "drive" in told.stdout
    assert "s_reached" in told.stdout


LEANING = """
flexure: 1
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, h: 0.3 mm, l: 40 mm, b: 10 mm, spacing: 30 mm}
mechanism: {kind: payload, mass: 150 g}
actuator: {blocking_force: 20 N, free_stroke: 5 mm, drives: both-ways}
cases:
  work: {stroke: {translation: 1 mm}LOAD}
requirements: {drive: 1.5}
"""


def test_a_load_out_of_the_plane_leaves_the_drive_an_answer(flexure, tmp_path):
    def drive(load):
        (tmp_path / "flexure.yaml").write_text(LEANING.replace("LOAD", load))
        told = flexure("check", "--format", "json")
        return next(c for c in json.loads(told.stdout)["checks"] if c["name"] == "drive")

    plain, loaded = drive(""), drive(", wrench: {z: 2 N}")
    assert loaded["verdict"] == "pass"
    low, high = loaded["factor_range"]
    # a force along z turns no blade of a symmetric stage aside to first order
    assert low < plain["factor"] < high < 1.2 * low
