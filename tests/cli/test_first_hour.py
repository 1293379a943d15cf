"""The first hour of an engineer: eight tasks as a person would write and run them.

What comes out is held against formulas of beams written here. Blades as wide as these are between a
beam and a plate, which is stiffer by 1/(1 - nu^2), so those are the two sides of a band.
"""

import json
from math import pi, radians, sqrt
from xml.etree import ElementTree

import pytest
import yaml
from jsonschema import Draft202012Validator

E, YIELD = 113.8e9, 880e6  # of Ti-6Al-4V, as flexure materials shows them
PLATE = 1.13 * 1.01  # 1/(1 - nu^2), and what the strokes here add


@pytest.fixture
def wrote(tmp_path):
    def write(name, text):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    return write


def document(told):
    return json.loads(told.stdout)


def checks(told):
    return {check["name"]: check for check in document(told)["checks"]}


GUIDE = """\
flexure: 1
title: Focus guide of a microscope
material: ti-6al-4v
geometry:
  kind: leaf-spring-stage
  spacing: 40 mm
  h: {free: [0.1 mm, 1 mm]}       # sheet that our shop has
  l: {free: [20 mm, 60 mm]}
  b: 15 mm
mechanism: {kind: payload, mass: 250 g}     # objective and turret
cases:
  focusing:
    stroke: {translation: 0.5 mm, cycles: 1e7}
requirements:
  fatigue: 2
  frequency: {min: 20 Hz}
  parasitic_shift: {max: 10 um}
size: {objective: shortest, round: {h: 10 um, l: 0.5 mm}}
"""


def test_a_guide_of_a_microscope_is_sized_for_its_frequency_and_keeps_its_focus(
    flexure, wrote, tmp_path
):
    wrote("guide.yaml", GUIDE)
    assert flexure("size", "guide.yaml", "--write", "sized.yaml").returncode == 0
    assert "# sheet that our shop has" in (tmp_path / "sized.yaml").read_text()
    told = flexure("check", "sized.yaml", "--format", "json")
    assert told.returncode == 0
    values = document(told)["values"]
    h, l, b = (values[name]["value"] for name in "hlb")
    assert h * 1e5 == pytest.approx(round(h * 1e5))  # the steps of the shop
    assert l * 2e3 == pytest.approx(round(l * 2e3))
    found = checks(told)
    beams = 2.0 * E * b * h**3 / l**3
    frequency = sqrt(beams / 0.25) / (2.0 * pi)
    assert 0.99 * frequency <= found["frequency (min)"]["capacity"] <= sqrt(PLATE) * frequency
    assert found["frequency (min)"]["capacity"] >= 20.0
    # the parabola of a leaf spring: 3 x^2 / (5 l)
    shift = 0.6 * 0.5e-3**2 / l
    assert found["parasitic shift (max)"]["demand"] == pytest.approx(shift, rel=0.01)
    stress = 3.0 * E * h * 0.5e-3 / l**2
    assert 0.99 * stress <= found["fatigue"]["demand"] <= PLATE * stress


MIRROR = """\
flexure: 1
title: Tip mirror on crossed blades
material: ti-6al-4v
geometry: {kind: cross-spring, delta: -0.5, half_angle: 45 deg, h: 0.1 mm, l: 20 mm, b: 5 mm}
mechanism: {kind: payload, mass: 30 g, inertia: 4e-6 kg*m^2}
cases:
  scan:
    stroke: {rotation: 3 deg, cycles: 1e7}
requirements:
  fatigue: 1.5
  yield: 2
  frequency: {min: 5 Hz}
  parasitic_shift: {max: 50 um}
"""


def test_a_pivot_of_a_mirror_bends_its_blades_into_arcs(flexure, wrote):
    wrote("flexure.yaml", MIRROR)
    told = flexure("check", "--format", "json")
    assert told.returncode == 0
    found = checks(told)
    stress = E * 0.1e-3 * radians(3.0) / (2.0 * 20e-3)
    assert 0.99 * stress <= found["yield (yield-strength)"]["demand"] <= PLATE * stress
    stiffness = 2.0 * E * 5e-3 * 0.1e-3**3 / (12.0 * 20e-3)
    frequency = sqrt(stiffness / 4e-6) / (2.0 * pi)
    assert 0.99 * frequency <= found["frequency (min)"]["capacity"] <= sqrt(PLATE) * frequency


LAUNCH = """\
flexure: 1
title: Instrument stage that is launched
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, h: {free: [0.1 mm, 1 mm]}, l: {free: [10 mm, 60 mm]}, b: 1 cm}
mechanism: {kind: payload, mass: 20 g}
cases:
  operation: {stroke: {translation: 1 mm, cycles: 1e6}}
  launch: {asd: {profile: gevs-qualification, q: 50}}
requirements: {fatigue: 2, yield: 1.5, dynamic-yield: 1.25, frequency: {min: 90 Hz}}
size: {objective: least-volume}
"""


def test_a_stage_is_sized_for_its_launch_and_no_stronger_one(flexure, wrote):
    wrote("stage.yaml", LAUNCH)
    told = flexure("size", "stage.yaml", "--write", "sized.yaml", "--format", "json")
    assert told.returncode == 0
    assert "dynamic yield, launch" in " ".join(document(told)["sizing"]["active"])
    asked = ("check", "sized.yaml", "--model", "closed-form", "--format", "json")
    quiet, loud = flexure(*asked), flexure(*asked, "--set", "cases.launch.asd.scale=6 dB")
    assert (quiet.returncode, loud.returncode) == (0, 1)
    stresses = [checks(each)["dynamic yield"]["demand"] for each in (quiet, loud)]
    # rms grows with the root of the level; dynamic yield without a stroke is linear in it
    assert stresses[1] / stresses[0] == pytest.approx(10 ** (6 / 20), rel=1e-3)


def test_ci_sees_which_design_of_a_folder_fails_and_in_which_line(flexure, wrote):
    wrote("designs/mirror.yaml", MIRROR)
    wrote("designs/stiff/mirror.yaml", MIRROR.replace("min: 5 Hz", "min: 50 Hz"))
    wrote("designs/ci.yaml", "on: [push]\n")
    told = flexure("check", "designs", "--format", "junit")
    assert told.returncode == 1
    good, bad, over = ElementTree.fromstring(told.stdout)
    assert [suite.get("failures") for suite in (good, bad, over)] == ["0", "1", "0"]
    (failed,) = (case for case in bad.iter("testcase") if case.find("failure") is not None)
    line = MIRROR.splitlines().index("  frequency: {min: 5 Hz}") + 1
    assert "frequency" in failed.get("name")
    assert failed[0].text.startswith(f"designs/stiff/mirror.yaml:{line}:")
    assert over.find("testcase").get("classname") == "designs/ci.yaml"


def test_an_own_material_stands_on_a_shipped_one_and_changes_what_it_says(flexure, wrote):
    own = "{extends: ti-6al-4v, yield_strength: 440 MPa, note: our batch of 2026}"
    wrote("flexure.yaml", MIRROR)
    wrote("own.yaml", MIRROR.replace("ti-6al-4v", own))
    wrote("batch.yaml", f"flexure: 1\nmaterial: {own}\n")
    wrote("named.yaml", MIRROR.replace("ti-6al-4v", "batch.yaml"))
    shipped, inline, named = (
        checks(flexure("check", name, "--format", "json"))
        for name in ("flexure.yaml", "own.yaml", "named.yaml")
    )
    name = "yield (yield-strength)"
    assert inline[name]["capacity"] == pytest.approx(440e6)
    assert inline[name]["factor"] == pytest.approx(shipped[name]["factor"] * 440e6 / YIELD)
    assert inline["fatigue"]["factor"] == shipped["fatigue"]["factor"]
    assert named[name]["factor"] == inline[name]["factor"]


PROFILE = """\
flexure: 1
asd:
  name: our truck
  points:
    - {frequency: 20 Hz, level: 0.01 g^2/Hz}
    - {frequency: 420 Hz, level: 0.01 g^2/Hz}
"""


def test_an_own_profile_has_the_rms_of_its_area_and_shakes_the_design(flexure, wrote):
    wrote("truck.yaml", PROFILE)
    assert flexure("validate", "truck.yaml").returncode == 0
    told = document(flexure("asd", "grms", "truck.yaml", "--format", "json"))
    assert told["profiles"][0]["g_rms"] == pytest.approx(sqrt(0.01 * 400.0) * 9.80665)
    wrote("stage.yaml", LAUNCH.replace("gevs-qualification", "truck.yaml"))
    sizes = ("--set", "geometry.h=0.3 mm", "--set", "geometry.l=25 mm")
    stresses = []
    for level in (0.01, 0.04):
        wrote("truck.yaml", PROFILE.replace("0.01 g", f"{level} g"))
        run = flexure("check", "stage.yaml", *sizes, "--format", "json")
        stresses.append(checks(run)["dynamic yield"]["demand"])
    assert stresses[1] / stresses[0] == pytest.approx(2.0, rel=1e-3)


def test_a_first_spec_is_known_to_editors_and_to_the_verbs_alike(flexure, tmp_path):
    assert flexure("init", "cross-spring", "-o", "flexure.yaml").returncode == 0
    first = (tmp_path / "flexure.yaml").read_text().splitlines()[0]
    schema = first.partition("$schema=")[2]
    assert flexure("schema", "-o", schema).returncode == 0
    assert flexure("size", "--write", "sized.yaml").returncode == 0
    validator = Draft202012Validator(json.loads((tmp_path / schema).read_text()))
    validator.validate(yaml.safe_load((tmp_path / "sized.yaml").read_text()))
    assert flexure("check", "sized.yaml").returncode == 0


def test_what_if_leaves_the_spec_as_it_is(flexure, wrote, tmp_path):
    """Blades of thrice the thickness have thrice the stress; a frequency goes with h to 3/2."""
    wrote("flexure.yaml", MIRROR)
    beams = ("--model", "source", "--format", "json")  # no plates: pure powers of h
    was = checks(flexure("check", *beams))
    thick = checks(flexure("check", "--set", "geometry.h=0.3mm", *beams))
    name = "yield (yield-strength)"
    assert thick[name]["demand"] == pytest.approx(3.0 * was[name]["demand"])
    frequencies = [each["frequency (min)"]["capacity"] for each in (was, thick)]
    assert frequencies[1] == pytest.approx(3.0**1.5 * frequencies[0], rel=0.01)
    assert (tmp_path / "flexure.yaml").read_text() == MIRROR
    assert flexure("check", "--set", "geometry.h=3mm").returncode == 1
