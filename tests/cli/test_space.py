"""Mechanisms in space, and loads out of a joint's plane, as a user asks for them."""

import json
from pathlib import Path

import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"

STAGE = """
flexure: 1
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, h: 0.3 mm, l: 50 mm, b: 20 mm, spacing: 50 mm}
cases:
  push: {wrench: {z: 5 N, theta_x: 100 N*mm}, ends: clamped-guided}
requirements: REQUIREMENTS
"""


@pytest.fixture
def checked(tmp_path, flexure):
    def check(requirements, text=STAGE, *words):
        path = tmp_path / "flexure.yaml"
        path.write_text(text.replace("REQUIREMENTS", requirements), encoding="utf-8")
        told = flexure("check", str(path), "--format", "json", *words)
        return told.returncode, json.loads(told.stdout)

    return check


NOTCH = """
flexure: 1
material:
  name: Ti
  youngs_modulus: 114 GPa
  poisson_ratio: 0.34
  density: 4430 kg/m^3
  yield_strength: 830 MPa
geometry: {kind: notch-hinge, e: 0.2 mm, r: 2 mm, b: 8 mm, blocks: massive}
mechanism: {kind: payload, mass: 0.3 kg, inertia: 1e-5 kg*m^2}
cases:
  launch: {acceleration: {level: 400 m/s^2, axis: z}}
requirements: REQUIREMENTS
"""


@pytest.mark.parametrize(("factor", "verdict"), [(3.5, "pass"), (5.0, "pass"), (7.5, "fail")])
def test_a_notch_that_is_shaken_across_its_plane_is_judged_by_yield(checked, factor, verdict):
    # a throat that is wide against √(e r) is sheared evenly: √3 m a/(b e) is a factor of 5.9, which
    # beams reach around; solids, which decide between, have a fifth more where it is most
    code, found = checked(f"{{yield: {factor}}}", NOTCH)
    assert code == (verdict != "pass")
    (check,) = found["checks"]
    assert check["verdict"] == verdict
    low, high = check["factor_range"]
    nominal = 830e6 / (np.sqrt(3.0) * 0.3 * 400.0 / (8e-3 * 0.2e-3))
    assert low < nominal < high / 0.8
    assert high < 2.0 * low


def test_a_wrench_out_of_the_plane_is_judged_by_yield(checked):
    code, found = checked("{yield: 1.5}")
    assert code == 0
    (check,) = found["checks"]
    # two blades bend across their widths: F l/4 over h b²/6 each; the tilt bends and twists them
    bending = 5.0 * 50e-3 / 4.0 / (0.3e-3 * 20e-3**2 / 6.0)
    assert check["demand"] > bending
    assert check["factor_range"][1] < 1.1 * check["factor_range"][0]


def test_nothing_else_says_that_it_has_looked_at_it(checked):
    code, found = checked("{stiffness: {max: 1 N/um}}")
    assert code == 1
    assert "not judged" in {check["verdict"] for check in found["checks"]}


def test_a_load_out_of_the_plane_leaves_other_requirements_their_models(checked):
    text = STAGE.replace("cases:", "cases:\n  travel: {stroke: {translation: 1 mm, cycles: 1e6}}")
    stage = "{support: {direction: y, min: 1 N/um, at: full-stroke}, envelope: ENVELOPE}"
    code, found = checked(stage.replace("ENVELOPE", "[80 mm, 60 mm, 30 mm]"), text)
    assert code == 1  # nobody looks at the wrench
    verdicts = {check["name"]: check["verdict"] for check in found["checks"]}
    judged = [name for name, verdict in verdicts.items() if verdict == "pass"]
    assert len(judged) == len(verdicts) - 1
    assert any(name.startswith("support y at stroke") for name in judged)
    assert any(name.startswith("envelope") for name in judged)


def test_without_a_shear_modulus_nobody_knows(checked):
    text = STAGE.replace("ti-6al-4v", "{youngs_modulus: 114 GPa, yield_strength: 800 MPa}")
    code, found = checked("{yield: 1.5}", text)
    assert code == 1
    assert {check["verdict"] for check in found["checks"]} == {"undecided"}


def test_a_bar_held_by_nobody_knows_what_leaves_it_unjudged(checked):
    bar = "{kind: torsion-star, h: 0.2 mm, l: 20 mm, b: 4 mm, shortening: held}"
    text = STAGE.replace(STAGE.split("geometry: ")[1].split("\n")[0], bar)
    text = text.replace("push: {", "push: {stroke: {rotation: 1 deg}, ")
    code, found = checked("{yield: 1.5}", text)
    assert code == 1
    assert "not judged" in {check["verdict"] for check in found["checks"]}


@pytest.mark.slow
@pytest.mark.parametrize(("model", "verdict"), [("linear", "undecided"), ("exact", "pass")])
def test_a_far_stroke_under_gravity_takes_exact_beams(tmp_path, flexure, model, verdict):
    text = (EXAMPLES / "folded-stage" / "flexure.yaml").read_text(encoding="utf-8")
    path = tmp_path / "flexure.yaml"
    path.write_text(text.replace("translation: 2 mm", "translation: 12 mm"), encoding="utf-8")
    told = flexure("check", str(path), "--model", model, "--format", "json")
    assert told.returncode == 1
    (check,) = (c for c in json.loads(told.stdout)["checks"] if c["name"] == "fatigue")
    assert check["verdict"] == verdict


def test_a_verb_that_has_no_model_in_space_says_so(flexure):
    # rods alone, of which no shells are made
    told = flexure("accuracy", str(EXAMPLES / "tripod-mount" / "flexure.yaml"))
    assert told.returncode == 2
    assert "space-layout" in told.stderr


def test_a_mechanism_in_space_is_drawn_from_any_side(flexure):
    path = str(EXAMPLES / "tripod-mount" / "flexure.yaml")
    told = flexure("draw", path)
    assert told.returncode == 0
    assert told.stdout.count("2 mm") >= 1
    corner = flexure("draw", path, "--view", "isometric")
    assert corner.returncode == 0
    assert corner.stdout != told.stdout


WIDE = """
flexure: 1
material: {youngs_modulus: 70 GPa, poisson_ratio: 0.33, density: 2.8 g/cm^3}
parameters: {l: 40 mm}
geometry:
  kind: layout
  moving: stage
  motion: {translation: 0 deg}
  bodies:
    frame: {at: [0 mm, 0 mm], mass: 1 kg, inertia: 1e-4 kg*m^2}
    stage: {at: [0 mm, l/2], mass: 2 kg, inertia: 3e-4 kg*m^2}
  blades:
    o1: {between: [ground, frame], from: [-20 mm, l], to: [-20 mm, 0 mm], h: 0.3 mm, b: 16 mm}
    o2: {between: [ground, frame], from: [20 mm, l], to: [20 mm, 0 mm], h: 0.3 mm, b: 16 mm}
    i1: {between: [frame, stage], from: [-12 mm, 0 mm], to: [-12 mm, l], h: 0.3 mm, b: 16 mm}
    i2: {between: [frame, stage], from: [12 mm, 0 mm], to: [12 mm, l], h: 0.3 mm, b: 16 mm}
cases: {weight: {acceleration: {level: 9.81 m/s^2, axis: AXIS}}}
requirements: REQUIREMENTS
"""


def test_a_sag_across_the_stroke_is_no_stiffer_for_the_width_of_its_blades(checked):
    """Only bending over the thickness is, which neither a pull nor bending across the width is."""
    text = WIDE.replace("AXIS", "y").replace("9.81 m/s^2", "0.981 m/s^2")
    code, found = checked("{sag: {max: 1 mm}}", text)
    assert code == 0
    # the stage stretches both pairs, the frame the outer one
    stretched = 0.981 * (2.0 + 3.0) * 40e-3 / (2.0 * 70e9 * 0.3e-3 * 16e-3)
    # clamps that hold a blade's width make it stiffer, by less than 3 % at b = 0.4 l
    assert 0.97 * stretched < found["checks"][0]["demand"] <= stretched * (1.0 + 1e-3)


def test_a_sag_is_not_told_where_the_weight_nearly_buckles_the_blades(checked):
    # 16.1 N on each outer blade that stands: a beam sways at π² EI/l² = 15.5 N, a plate that is
    # kept as wide at 12 % more
    text = WIDE.replace("AXIS", "y").replace("9.81 m/s^2", "10.7 m/s^2")
    code, found = checked("{sag: {max: 1 mm}}", text)
    assert code == 1
    assert found["checks"][0]["verdict"] == "undecided"


def test_a_sag_along_the_width_is_the_weight_over_the_support_stiffness(checked):
    text = WIDE.replace("AXIS", "z").replace("mass: 1 kg, inertia: 1e-4 kg*m^2", "mass: 1e-9 kg")
    text = text.replace("at: [0 mm, l/2]", "at: [0 mm, 0 mm]")
    code, found = checked("{sag: {max: 1 mm}, support: {direction: z, min: 1 N/mm}}", text)
    assert code == 0
    sag, support = found["checks"]
    # the blades weigh 2e-3 of the stage
    assert sag["demand"] == pytest.approx(2.0 * 9.81 / support["capacity"], rel=3e-3)
    assert sag["factor_range"][1] > sag["factor_range"][0] * (1.0 + 1e-3)


TANGENTIAL = """
flexure: 1
material: ti-6al-4v
geometry:
  kind: space-layout
  bodies: {lens: {at: [0 mm, 0 mm, 0 mm], mass: 250 g}}
  blades:
    t: {between: [ground, lens], from: [40 mm, -12 mm, 0 mm], to: [40 mm, 12 mm, 0 mm], h: 0.6 mm,
        b: 6 mm, width: z, repeat: {count: 3, about: z}}
  moving: lens
  motion: {rotation: {about: z}}
cases: {twist: {stroke: {rotation: 0.2 deg, cycles: 1e5}}}
requirements: REQUIREMENTS
"""


def test_ends_of_a_stroke_that_take_unlike_nodes_have_one_amplitude(checked):
    """One way blades are pulled straight, the other they buckle."""
    code, found = checked("{fatigue: 0.3}", TANGENTIAL)
    assert code == 0
    strain = 0.2 * 0.017453 * 40.0 / 24.0
    assert found["checks"][0]["demand"] > 113.8e9 * strain


CROSSED = """
flexure: 1
material: ti-6al-4v
geometry:
  kind: space-layout
  bodies: {rotor: {at: [0 mm, 0 mm, 0 mm], mass: 80 g}}
  blades:
    one: {between: [ground, rotor], from: [-14 mm, -14 mm, 12 mm], to: [14 mm, 14 mm, 12 mm],
          h: 0.2 mm, b: 10 mm, width: z, mirror: [z]}
    two: {between: [ground, rotor], from: [14 mm, -14 mm, 0 mm], to: [-14 mm, 14 mm, 0 mm],
          h: 0.25 mm, b: 12 mm, width: z}
  moving: rotor
  motion: {rotation: {about: z}}
cases: {lift: {wrench: {z: 20 N, theta_x: 300 N*mm}}}
requirements: REQUIREMENTS
"""


def test_a_deflection_that_small_motion_leaves_open_is_decided_by_exact_beams(checked):
    """The moment takes the soft rotation along in second order, whose size small motion lacks."""
    wanted = "{deflection: {direction: z, max: 30 um}, support: {direction: z, min: 1 N/mm}}"
    code, found = checked(wanted, CROSSED)
    assert code == 0
    support, deflection = found["checks"]
    assert deflection["model"] == "exact"
    assert deflection["demand"] == pytest.approx(20.0 / support["capacity"], rel=1e-2)


def test_two_ways_to_miss_a_seat_and_two_points_are_checks_of_their_own(checked):
    wanted = """
  misalignment_stress:
    - {of: t, translation: {along: z, by: 20 um}, factor: 1.2}
    - {of: t, rotation: {about: [1, 1, 0], by: 0.1 mrad}, factor: 1.1}
  support:
    - {direction: x, min: 1 N/um}
    - {direction: x, min: 1 N/um, point: [0 mm, 0 mm, 20 mm]}
"""
    code, found = checked(wanted, TANGENTIAL)
    assert code == 1  # nobody looks at the stroke
    names = [check["name"] for check in found["checks"]]
    assert len(names) == 5
    assert "misalignment stress t, along z" in names
    near, far = (check for check in found["checks"] if check["name"].startswith("support x"))
    assert far["capacity"] < near["capacity"]


def test_a_deflection_beyond_buckling_says_why_it_is_open(checked):
    text = TANGENTIAL.split("cases:")[0] + "cases: {push: {wrench: {z: -4 kN}}}\n"
    text = text.replace("about: z}}", "about: x}}").replace("from: [40 mm, -12 mm, 0 mm]", "FROM")
    upright = text.replace("FROM", "from: [40 mm, 0 mm, -60 mm]").replace(
        "to: [40 mm, 12 mm, 0 mm]", "to: [40 mm, 0 mm, 0 mm]"
    )
    upright = upright.replace("width: z", "width: y") + "requirements: REQUIREMENTS\n"
    code, found = checked("{deflection: {direction: z, max: 1 mm}}", upright)
    assert code == 1
    check = found["checks"][0]
    assert check["verdict"] == "undecided"
    assert "the joint has no deflection" in check["source"]


BOWED = """\
flexure: 1
material: ti-6al-4v
geometry:
  kind: space-layout
  bodies: {m: {at: [0 mm, 0 mm, 0 mm]}}
  blades:
    a: {between: [ground, m], from: [10 mm, -20 mm, 0 mm], to: [10 mm, 0 mm, 0 mm],
        h: 0.2 mm, b: 4 mm, width: z, mirror: [x]}
  moving: m
  motion: {translation: x}
cases:
  c: {wrench: {y: -3.5 N, x: 0.02 N}}
requirements: REQUIREMENTS
"""


def test_a_small_force_across_does_not_hide_that_blades_buckle(checked):
    """Both blades buckle at 2 π² EI/l² = 15 N; those that bow from the first on go past it."""
    code, found = checked("{buckling: 4.6}", BOWED, "--model", "exact")
    (check,) = found["checks"]
    buckles = 2.0 * np.pi**2 * 113.8e9 * 4e-3 * (0.2e-3) ** 3 / 12.0 / (20e-3) ** 2 / 3.5
    low, _ = check["factor_range"]
    assert code == 1
    # plates are stiffer, and the low end counts the error of the beams
    assert check["verdict"] == "undecided"
    assert buckles * 0.95 < low < buckles * 1.06


def test_warping_that_is_switched_off_is_told_and_leaves_the_verdict_open(checked):
    text = STAGE.replace("push: {wrench: {z: 5 N, theta_x: 100 N*mm}, ends: clamped-guided}",
                         "travel: {stroke: {translation: 10 mm}}")  # fmt: skip
    text += "effects: {warping: off}\n"
    need = "{support: {direction: z, min: 0.2 N/um, at: full-stroke, drive: locked}}"
    code, found = checked(need, text)
    (check,), (row,) = found["checks"], [e for e in found["effects"] if e["name"] == "warping"]
    assert code == 1
    assert check["verdict"] == "undecided"
    assert not row["on"]
    assert row["estimates"]["support"] >= check["factor_range"][1] / check["factor"] - 1.0
    assert any("warping, left out" in warning["text"] for warning in found["warnings"])
