"""``flexure plan`` as a user runs it, and the verbs that run by it."""

import json

import pytest

from flexcli.formulas.thick_plates import thick_arc_factor, thick_s_factor

SPEC = """\
flexure: 1
title: thick pivot
material: {youngs_modulus: 114 GPa, poisson_ratio: 0.33, yield_strength: 900 MPa}
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.3 mm, l: 10 mm, b: 2 mm}
cases:
  work: {stroke: {rotation: 2 deg}}
requirements: {yield: 1}
accuracy: 1 %
effects: {plate-widening: off, anticlastic: off}
"""


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "flexure.yaml"
    path.write_text(SPEC)
    return path


def test_plan_tells_effects_models_and_choice(flexure, spec):
    run = flexure("plan", COLUMNS="160")
    assert run.returncode == 0
    for told in ("shear", "matters most in", "off by the spec", "Models", "plan: accuracy 1.00%"):
        assert told in run.stdout


def test_plan_as_json_has_it_whole(flexure, spec):
    document = json.loads(flexure("plan", "--format", "json").stdout)
    effects = {row["name"]: row for row in document["effects"]}
    assert set(document["plan"]["reported"]) == {"stiffness", "stress", "shift"}
    assert document["plan"]["on"] == [name for name, row in effects.items() if row["on"]]
    assert effects["shear"]["estimate"] == max(effects["shear"]["estimates"].values())
    assert effects["plate widening"]["asked"] == "off"
    costs = {model["name"]: model["cost"] for model in document["plan"]["models"]}
    assert costs["closed-form"] < costs["linear"] < costs["exact"]
    assert document["cost"]["model"] == document["plan"]["model"]


def test_audit_sets_the_truth_beside_the_estimate(flexure, spec):
    run = flexure("plan", "--audit", "--format", "json")
    assert run.returncode == 0
    rows = json.loads(run.stdout)["audit"]
    shear = next(r for r in rows if r["effect"] == "shear" and r["quantity"] == "stiffness")
    assert shear["true"] == pytest.approx(-shear["estimate"], rel=0.05)
    plate = [row for row in rows if row["effect"] in ("plate widening", "anticlastic")]
    assert all(row["right"] for row in rows if row["true"] is not None and row not in plate)
    # what the spec switches off is told, and is no mistake of the plan
    told = {row["quantity"]: row for row in plate if row["effect"] == "plate widening"}
    nu, b, l, h = 0.33, 2.0, 10.0, 0.3
    blade, share = {"b": b, "l": l, "h": h, "poisson_ratio": nu}, 12.0 * 0.7**2
    arc, s_shape = thick_arc_factor(**blade), thick_s_factor(**blade)
    true = (arc + share * s_shape) / (1.0 + share) - 1.0
    assert told["stiffness"]["true"] == pytest.approx(float(true), rel=2e-3)  # less what stretches
    assert [row["right"] for row in plate] == [None] * len(plate)


def test_audit_says_what_the_material_lacks(flexure, spec):
    lacking = SPEC.replace("poisson_ratio: 0.33, ", "").replace("plate-widening: off, ", "")
    spec.write_text(lacking)
    rows = json.loads(flexure("plan", "--audit", "--format", "json").stdout)["audit"]
    plate = [row for row in rows if row["effect"] == "plate widening"]
    assert plate
    assert all(row["true"] is None and "poisson_ratio" in row["how"] for row in plate)


def test_audit_on_screen(flexure, spec):
    assert "right" in flexure("plan", "--audit", COLUMNS="160").stdout


def test_a_spec_without_accuracy_is_planned_for_one_that_is_told(flexure, spec):
    spec.write_text(SPEC.replace("accuracy: 1 %\n", ""))
    document = json.loads(flexure("plan", "--format", "json").stdout)
    assert "accuracy-assumed" in [note["code"] for note in document["warnings"]]
    assert document["plan"]["accuracy"] == 0.01


def test_a_free_design_is_planned_for_the_sizes_that_size_chooses(flexure, spec):
    spec.write_text(
        SPEC.replace("h: 0.3 mm", "h: free").replace(
            "{yield: 1}", "{yield: 1, stiffness: {min: 0.3 N*m/rad}}"
        )
    )
    document = json.loads(flexure("plan", "--format", "json").stdout)
    assert document["warnings"][0]["code"] == "sized-first"
    sized = json.loads(flexure("size", "--format", "json").stdout)
    assert sized["plan"]["on"] == document["plan"]["on"]
    assert sized["status"] == "pass"


def test_requirements_in_conflict_leave_nothing_to_plan(flexure, spec):
    """The answer is that of the sizing: which requirements cannot all hold."""
    text = SPEC.replace("h: 0.3 mm", "h: {free: [0.1 mm, 0.2 mm]}")
    spec.write_text(text.replace("yield: 1", "yield: 1, stiffness: {min: 1 kN*m/rad}"))
    run = flexure("plan", "--format", "json")
    document = json.loads(run.stdout)
    assert run.returncode == 1
    assert (document["command"], document["status"]) == ("plan", "infeasible")
    assert "stiffness" in " ".join(row["name"] for row in document["sizing"]["conflict"])


@pytest.mark.parametrize("verb", ["check", "simulate"])
def test_verbs_run_by_the_plan_and_tell_it_in_short(flexure, spec, verb):
    run = flexure(verb)
    assert run.returncode == 0
    assert "plan: accuracy 1.00%" in run.stdout
    assert "Models" not in run.stdout


def test_check_by_a_plan_names_its_model_and_error(flexure, spec):
    document = json.loads(flexure("check", "--format", "json").stdout)
    assert document["cost"]["estimated_error"] == document["plan"]["estimated_error"]
    assert document["values"]["k_pivot"]["model"].startswith(document["plan"]["model"])


def test_a_model_of_the_command_line_overrules_the_plan(flexure, spec):
    document = json.loads(flexure("check", "--model", "linear", "--format", "json").stdout)
    assert document["plan"]["model"] == "linear"
    assert document["cost"]["model"] == "linear"


def test_stops_tell_the_plan(flexure, spec):
    spec.write_text("""\
flexure: 1
material: {youngs_modulus: 60 GPa, poisson_ratio: 0.31, yield_strength: 55.4 MPa}
geometry: {kind: cantilever, h: 1.25 mm, l: 28.5 mm, b: 7.8 mm}
mechanism: {kind: tip-mass, mass: 8.07 g, damping: {q: 20}}
cases: {resonance: {sine: {acceleration: 1.5 g, frequency: 176 Hz}}}
requirements: {}
stops: {travel: 100 um, smallest-gap: 20 um, bending: 2}
accuracy: 20 %
""")
    document = json.loads(flexure("stops", "--format", "json").stdout)
    assert {"damping", "end stops"} <= set(document["plan"]["on"])
