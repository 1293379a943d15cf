"""``flexure asd response`` as a user runs it."""

import json

import pytest

SPEC = """\
flexure: 1
material: 7075-t6
geometry: {kind: leaf-spring-stage, h: 0.5 mm, l: 40 mm, b: 15 mm}
mechanism: {kind: payload, mass: 0.5 kg}
cases:
  launch:
    asd: {profile: gevs-qualification, q: 20, axis: x and y}
    ends: clamped-guided
  separation:
    shock: {half-sine: {acceleration: 5 g, duration: 5 ms}, axis: x}
requirements:
  dynamic-yield: 1.25
  dynamic-life: {factor: 4, method: dirlik}
"""


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "flexure.yaml"
    path.write_text(SPEC)
    return path


def test_modes_totals_and_lives_are_told_for_each_case(flexure, spec):
    told = json.loads(flexure("asd", "response", "--format", "json").stdout)
    launch, separation = told["responses"]
    assert [row["case"] for row in told["responses"]] == ["launch", "separation"]
    along_x, along_y, *blades = [mode for mode in launch["modes"] if mode["dynamic"]]
    for mode in (along_x, along_y):
        assert mode["mass_share"] == pytest.approx(1.0, abs=0.02)
    # the blades' own modes move some of their 3.3 g, next to the 500 g
    assert all(mode["mass_share"] < 0.01 for mode in blades)
    assert 20.0 * along_x["frequency"] < blades[0]["frequency"]
    assert len(launch["lives"]["stress joint"]) == 5
    assert {row["name"] for row in separation["outputs"]} >= {"travel", "stress joint"}
    peaks = [row for row in launch["outputs"] if row["name"] == "travel"]
    assert peaks[0]["expected_peak"] > peaks[0]["peak"] > peaks[0]["rms"]


def test_checks_decide_the_exit_code_and_stand_in_check_too(flexure, spec):
    # 0.5 kg would push its blades by twice what buckles them
    light = SPEC.replace("0.5 kg", "10 g")
    spec.write_text(light)
    passed = flexure("asd", "response", "--format", "json")
    assert passed.returncode == 0
    spec.write_text(light.replace("dynamic-yield: 1.25", "dynamic-yield: 1e6"))
    failed = flexure("asd", "response")
    assert failed.returncode == 1
    checked = json.loads(flexure("check", "--format", "json").stdout)
    failing = {(check["name"], check["case"]) for check in checked["checks"] if not check["pass"]}
    assert failing == {("dynamic yield", "launch"), ("dynamic yield", "separation")}


def test_the_real_modes_are_told_against_miles(flexure, tmp_path, sizing):
    (tmp_path / "flexure.yaml").write_text(sizing.design)
    told = json.loads(flexure("asd", "response", "--format", "json").stdout)
    codes = [note["code"] for note in told["warnings"]]
    # blades as short as these bear no more than a few times the peak force of the levers' mode
    assert codes == ["miles-conservative", "no-life", "axial-force-in-modes"]
    (response,) = told["responses"]
    assert told["values"]["f_1_take-off"]["value"] == response["modes"][0]["frequency"]


def test_without_a_vibration_it_says_what_is_missing(flexure, spec):
    stroke = SPEC[: SPEC.index("cases:")] + (
        "stroke: {translation: 1 mm, cycles: 1e3}\nrequirements: {yield: 1.1}\n"
    )
    spec.write_text(stroke)
    told = flexure("asd", "response")
    assert told.returncode == 2
    assert "no case has a vibration or a shock" in told.stderr


def test_a_life_without_duration_is_a_finding_with_its_line(flexure, spec):
    points = "[{frequency: 20 Hz, level: 0.1 g^2/Hz}, {frequency: 2 kHz, level: 0.1 g^2/Hz}]"
    spec.write_text(SPEC.replace("profile: gevs-qualification", f"profile: {{points: {points}}}"))
    told = flexure("check")
    assert told.returncode == 2
    assert "flexure.yaml:13:3: requirements.dynamic-life" in told.stderr
    assert "duration: 2 min" in told.stderr
