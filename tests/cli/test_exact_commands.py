"""``flexure simulate`` and ``--model`` as a user runs them."""

import csv
import json
import math
from pathlib import Path

import pytest

SPEC = """\
flexure: 1
material: {name: titanium, youngs_modulus: 114 GPa, yield_strength: 800 MPa, poisson_ratio: 0.34}
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.2 mm, l: 20 mm, b: 5 mm}
stroke: {rotation: 5 deg}
requirements: {yield: 1.5}
"""
BEAMS = "effects: {plate-widening: off, anticlastic: off}\n"


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "flexure.yaml"
    path.write_text(SPEC)
    return path


def test_simulate_takes_the_spec_of_the_folder_and_prints_the_stroke(flexure, spec):
    told = flexure("simulate", "--points", "3")
    assert told.returncode == 0
    assert "Over the stroke" in told.stdout
    assert told.stdout.startswith("PASS  simulate")


def test_simulate_saves_every_point(flexure, spec, tmp_path):
    assert flexure("simulate", "--points", "7", "--csv", "t.csv").returncode == 0
    rows = list(csv.DictReader((tmp_path / "t.csv").read_text().splitlines()))
    assert len(rows) == 7
    assert float(rows[0]["travel [rad]"]) == pytest.approx(-0.0872664626)


def test_json_has_the_sweep(flexure, spec):
    document = json.loads(flexure("simulate", "--points", "3", "--format", "json").stdout)
    (sweep,) = document["sweeps"]
    assert [point["outcome"] for point in sweep["points"]] == ["converged"] * 3
    assert document["cost"]["model"] == "exact"


def checked(flexure, *arguments):
    told = flexure("check", "--format", "json", *arguments)
    document = json.loads(told.stdout)
    assert told.returncode == (0 if document["status"] == "pass" else 1)
    return document


@pytest.mark.parametrize("model", ["source", "closed-form", "linear", "exact"])
def test_check_by_a_model_says_so(flexure, spec, model):
    spec.write_text(SPEC + BEAMS)
    document = checked(flexure, "--model", model)
    assert document["cost"]["model"] == model
    assert set(document["cost"]["by_model"]) == {model}
    assert {check["model"] for check in document["checks"]} == {model}
    assert document["values"]["k_pivot"]["model"] == model
    # the source's formula to rounding; the others carry shear, some (h/l)² of it
    k = 8 * 114e9 * 5e-3 * 0.2e-3**3 / 12 / 20e-3 * (3 * 0.1**2 + 3 * 0.1 + 1)
    within = 1e-12 if model == "source" else 1e-3
    assert document["values"]["k_pivot"]["value"] == pytest.approx(k, rel=within)


def test_a_margin_that_a_cheap_model_cannot_tell_is_decided_by_the_exact_one(flexure, spec):
    """Just below and just above the exact factor: undecided, then decided, both ways."""
    exact = checked(flexure, "--model", "exact")["checks"][0]
    for end, factor, verdict in ((0, 0.999, "pass"), (1, 1.001, "fail")):
        required = exact["factor_range"][end] * factor
        spec.write_text(SPEC.replace("yield: 1.5", f"yield: {required!r}"))
        assert checked(flexure, "--model", "source")["status"] == "undecided"
        document = checked(flexure)
        (check,) = document["checks"]
        assert (check["verdict"], check["model"]) == (verdict, "exact")
        assert document["status"] == verdict
        assert set(document["cost"]["by_model"]) == {"closed-form", "linear", "exact"}


def test_a_wide_margin_stays_with_the_closed_form(flexure, spec):
    document = checked(flexure)
    assert document["checks"][0]["verdict"] == "pass"
    assert set(document["cost"]["by_model"]) == {"closed-form"}


def test_values_that_an_accuracy_asks_for_are_in_the_cost(flexure, spec):
    """The closed form decides; the model that makes the values beside has seconds of its own."""
    spec.write_text(SPEC + "accuracy: 1e-6\n")
    document = checked(flexure)
    assert [check["model"] for check in document["checks"]] == ["closed-form"]
    by_model = document["cost"]["by_model"]
    assert set(by_model) == {"closed-form", "exact"}
    assert 0.0 < by_model["exact"] < document["cost"]["seconds"]


def test_size_by_the_exact_model_writes_a_design_that_it_passes(flexure, spec):
    spec.write_text(SPEC.replace("h: 0.2 mm", "h: free") + "size: {objective: {maximize: h}}\n")
    assert flexure("size", "--model", "exact", "--write", "sized.yaml").returncode == 0
    assert flexure("check", "--model", "exact", "sized.yaml").returncode == 0


def test_a_joint_without_blades_is_refused_in_words(flexure, spec):
    bar = "{kind: torsion-bar, h: 0.5 mm, l: 20 mm, b: 4 mm}"
    spec.write_text(SPEC.replace(SPEC.splitlines()[2], f"geometry: {bar}"))
    told = flexure("simulate")
    assert told.returncode != 0
    assert "not made of straight blades" in told.stderr
    assert "Traceback" not in told.stderr


@pytest.mark.slow
def test_the_examples_folder_of_linkages_survives_a_write(flexure, tmp_path):
    crank = Path(__file__).parents[2] / "examples/crank-linear-stage/flexure.yaml"
    (tmp_path / "flexure.yaml").write_text(crank.read_text())
    # nobody knows the errors of its closed forms, so their margins stay undecided, written or not
    for command in (("size", "--write", "sized.yaml"), ("check", "sized.yaml")):
        told = flexure(*command, "--model", "closed-form", "--format", "json")
        document = json.loads(told.stdout)
        assert (told.returncode, document["status"]) == (1, "undecided")
        assert [check["factor_range"] for check in document["checks"]] == [None] * 3
        # sized to its limit within 1e-6
        assert [check["factor"] for check in document["checks"]] == pytest.approx(
            [1.0] * 3, rel=2e-6
        )


def test_a_crank_stage_follows_the_relations_of_its_source_over_the_input(flexure, tmp_path):
    crank = Path(__file__).parents[2] / "examples/crank-linear-stage/flexure.yaml"
    (tmp_path / "flexure.yaml").write_text(crank.read_text())
    sizes = {"theta": "120 um", "beta": "60 um", "alpha": "330 um"}
    given = [f"--set=geometry.joints.{joint}.flexure.h={h}" for joint, h in sizes.items()]
    told = flexure("simulate", *given, "--points", "5", "--csv", "theta.csv")
    assert told.returncode == 0, told.stderr
    with (tmp_path / "theta.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 5
    for row in rows:
        theta, alpha, beta = (float(row[f"{name} [rad]"]) for name in ("travel", "alpha", "beta"))
        # exercise 12 C, solution: L = 50 mm
        assert math.sin(alpha) == pytest.approx(1 - math.cos(theta), abs=1e-12)
        assert beta == pytest.approx(alpha - theta, abs=1e-12)
        z = 0.05 * (math.sin(theta) - math.cos(alpha) + 1)
        assert float(row["z [m]"]) == pytest.approx(z, abs=1e-14)
