"""The box around a mechanism: at rest, over its stroke, and as what sizes it."""

from math import atan2, cos, hypot, radians, sin

import numpy as np
import pytest
import yaml

import flexcli
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.shape import centre_line
from flexcli.results import Status, Verdict

STAGE = """flexure: 1
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, l: 40 mm, h: 0.2 mm, b: 5 mm, spacing: 20 mm}
cases: {push: {wrench: {y: 1 N}}}
requirements: {envelope: [30 mm, 50 mm, 6 mm]}
"""
GUIDE = """flexure: 1
material: ti-6al-4v
parameters: {l: 40 mm}
geometry:
  kind: space-layout
  bodies: {stage: {at: [l, 0 mm, 0 mm], box: [10 mm, 30 mm, 8 mm], density: 2810 kg/m^3}}
  blades:
    pair: {between: [ground, stage], from: [0 mm, 10 mm, 0 mm], to: [l, 10 mm, 0 mm],
           h: 0.2 mm, b: 5 mm, width: z, mirror: [y]}
  moving: stage
  motion: {translation: y}
cases: {op: {stroke: {translation: 2 mm}}}
requirements: {envelope: [50 mm, 40 mm, 10 mm]}
"""
CROSS = """flexure: 1
material: ti-6al-4v
geometry:
  kind: layout
  bodies: {rotor: {at: [0 mm, 0 mm], box: [30 mm, 10 mm, 4 mm]}}
  blades:
    one: {between: [ground, rotor], from: [-4 mm, -4 mm], to: [4 mm, 4 mm], h: 0.1 mm, b: 2 mm}
    two: {between: [ground, rotor], from: [4 mm, -4 mm], to: [-4 mm, 4 mm], h: 0.1 mm, b: 2 mm}
  moving: rotor
  motion: rotation
cases: {op: {stroke: {rotation: 10 deg}}}
requirements: {envelope: [40 mm, 20 mm, 5 mm]}
"""


def box(text, model=None):
    """Return the sides by axis, and the ranges that they lie in."""
    rows = [row for row in flexcli.check(text, model=model).checks if "envelope" in row.name]
    sides = [row.demand for row in rows]
    between = [(row.capacity / row.factor_range[1], row.capacity / row.factor_range[0])
               for row in rows]  # fmt: skip
    return np.array(sides), np.array(between)


def test_at_rest_it_is_that_of_the_blades():
    sides, between = box(STAGE)
    # x is along the stroke, y along the blades
    assert sides == pytest.approx([20e-3 + 0.2e-3, 40e-3, 5e-3], rel=1e-9)
    assert between == pytest.approx(np.stack([sides, sides], axis=1), rel=1e-9)


@pytest.mark.parametrize("model", ["linear", "exact"])
def test_over_a_stroke_it_grows_by_what_the_body_moves(model):
    sides, between = box(GUIDE, model)
    expected = [45e-3, 30e-3 + 2 * 2e-3, 8e-3]
    # the stage comes back by 0.6 x²/l = 60 µm, on the side where the box ends at rest
    assert sides == pytest.approx(expected, rel=1e-3)
    assert (between[:, 0] <= expected).all()
    assert (between[:, 1] >= np.multiply(expected, 1.0 - 1e-9)).all()


def test_a_corner_that_turns_reaches_as_far_as_it_turns():
    turn, radius, corner = radians(10.0), hypot(15e-3, 5e-3), atan2(5.0, 15.0)
    expected = [2.0 * radius * cos(corner - turn), 2.0 * radius * sin(corner + turn), 4e-3]
    small, between = box(CROSS, "linear")
    beams, _ = box(CROSS, "exact")
    # the axis drifts by some 40 µm, which small motion knows to second order
    assert small == pytest.approx(expected, abs=0.1e-3)
    assert (between[:, 0] <= beams).all()
    assert (beams <= between[:, 1]).all()


def test_bent_blades_stay_within_the_box_and_its_doubt():
    text = CROSS.replace(", box: [30 mm, 10 mm, 4 mm]", "").replace("10 deg", "20 deg")
    _, between = box(text, "exact")
    layout = flexcli.load(text).part.geometry.layout(
        flexcli.load(text).part.material.elastic, flexcli.load(text).part.fixed_sizes()
    )
    lines = []
    for turn in np.linspace(-radians(20.0), radians(20.0), 5):
        state = solve(layout, {"moving": (None, None, np.array([turn]))}).checked()
        lines += [centre_line(state, name).place[0] for name in ("one", "two")]
    points = np.concatenate(lines)
    reach = points.max(axis=0) - points.min(axis=0)
    # half a thickness on either side
    assert (reach <= between[:2, 1]).all()
    assert (reach + 0.2e-3 >= between[:2, 0]).all()


def test_what_has_no_outline_is_told():
    text = CROSS.replace(", box: [30 mm, 10 mm, 4 mm]", "")
    assert "without the outline of moving" in flexcli.check(text).checks[0].quantity
    assert "without" not in flexcli.check(CROSS).checks[0].quantity


def test_a_box_too_long_fails_and_a_list_of_boxes_is_by_case():
    found = flexcli.check(GUIDE.replace("[50 mm, 40 mm", "[50 mm, 33 mm"))
    assert [row.verdict for row in found.checks if row.name == "envelope y (max)"] == [Verdict.FAIL]
    listed = "[{sides: [50 mm, 40 mm, 10 mm], cases: [op]}]"
    assert flexcli.check(GUIDE.replace("[50 mm, 40 mm, 10 mm]", listed)).checks


@pytest.mark.slow
def test_a_layout_is_sized_by_its_envelope():
    text = GUIDE.replace("l: 40 mm", "l: {free: [20 mm, 80 mm]}") + "model: linear\n"
    text = text.replace("{envelope", "{yield: 1.5, envelope")
    found = flexcli.size(text + "size: {objective: {maximize: l}}\n")
    assert found.status is Status.PASS
    # the blades, and half of the stage beyond them, to within the doubt of small motion
    assert found.values["l"].value == pytest.approx(45e-3, rel=0.015)
    assert found.values["l"].value < 45e-3


def test_a_stage_is_sized_to_stay_in_its_box():
    box = ["50 mm", "40 mm", "10 mm"]
    free = {"h": {"free": ["0.05 mm", "1 mm"]}, "l": {"free": ["5 mm", "60 mm"]}}
    spec = {
        "flexure": 1,
        "material": {"youngs_modulus": "114 GPa", "yield_strength": "800 MPa",
                     "poisson_ratio": 0.34, "density": "4430 kg/m^3"},
        "geometry": {"kind": "leaf-spring-stage", "spacing": "30 mm", "b": "5 mm", **free},
        "cases": {"work": {"stroke": {"translation": "0.5 mm"}}},
        "requirements": {"yield": 1.5, "stiffness": {"max": "5 N/mm"}, "envelope": box},
        "size": {"objective": {"minimize": "mass"}},
    }  # fmt: skip
    result = flexcli.size(yaml.safe_dump(spec))
    assert result.status is Status.PASS
    assert sum(check.name.startswith("envelope") for check in result.checks) == 3
