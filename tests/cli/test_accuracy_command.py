"""``flexure accuracy`` as a user runs it."""

import json

import pytest

SPEC = """\
flexure: 1
title: pivot
material: {youngs_modulus: 114 GPa, poisson_ratio: 0.34, yield_strength: 830 MPa}
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.2 mm, l: 20 mm, b: 5 mm}
cases:
  turn: {stroke: {rotation: 5 deg}}
requirements: {yield: 1}
"""


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "flexure.yaml"
    path.write_text(SPEC)
    return path


@pytest.mark.slow
def test_without_a_file_it_takes_the_spec_of_the_folder(flexure, spec):
    told = flexure("accuracy")
    assert told.returncode == 0, told.stderr
    assert told.stdout.startswith("PASS  accuracy flexure.yaml")
    assert "shift, parasitic shift, turn" in told.stdout
    assert "All quantities, median of 5 runs" in told.stdout
    assert "within 1 %, all quantities: " in told.stdout
    assert "error\n" in told.stdout


@pytest.mark.slow
def test_a_rough_answer_takes_a_cheaper_model_than_a_fine_one(flexure, spec):
    taken = []
    for asked in ("20 %", "1e-6"):
        told = flexure("accuracy", "--accuracy", asked, "--format", "json")
        assert told.returncode == 0, told.stderr
        taken.append(json.loads(told.stdout)["accuracy"])
    assert taken[0]["recommended"] == "source"
    assert taken[1]["recommended"].startswith("exact")
    assert (taken[0]["accuracy"], taken[1]["accuracy"]) == (0.2, 1e-6)
    assert taken[0]["runs"] == 5


@pytest.mark.slow
def test_what_no_model_meets_exits_1(flexure, spec):
    told = flexure("accuracy", "--accuracy", "1e-15")
    assert told.returncode == 1
    assert "no model is within" in told.stdout


@pytest.mark.parametrize("asked", ["1 mm", "0", "-1 %", "120 %", "fine"])
def test_an_accuracy_that_is_none_is_bad_input(flexure, spec, asked):
    told = flexure("accuracy", f"--accuracy={asked}")
    assert told.returncode == 2
    assert "--accuracy" in told.stderr


def test_a_joint_without_blades_says_why_there_is_nothing_to_compare(flexure, spec):
    bar = "{kind: round-torsion-bar, d: 0.5 mm, l: 20 mm, bars: 2}"
    geometry = SPEC.split("geometry: ")[1].split("\n")[0]
    spec.write_text(SPEC.replace(geometry, bar))
    told = flexure("accuracy")
    assert told.returncode == 2
    assert "is not made of straight blades" in told.stderr
