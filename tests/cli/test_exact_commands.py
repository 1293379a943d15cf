"""``flexure simulate`` and ``--model`` as a user runs them."""

import csv
import json
from pathlib import Path

import pytest

SPEC = """\
flexure: 1
material: {name: titanium, youngs_modulus: 114 GPa, yield_strength: 800 MPa, poisson_ratio: 0.34}
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.2 mm, l: 20 mm, b: 5 mm}
stroke: {rotation: 5 deg}
requirements: {yield: 1.5}
"""


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


@pytest.mark.parametrize("model", ["closed-form", "linear", "exact"])
def test_check_by_a_model_says_so(flexure, spec, model):
    document = json.loads(flexure("check", "--model", model, "--format", "json").stdout)
    assert document["cost"]["model"] == model
    assert document["values"]["k_pivot"]["model"] == model
    k = 8 * 114e9 * 5e-3 * 0.2e-3**3 / 12 / 20e-3 * (3 * 0.1**2 + 3 * 0.1 + 1)
    assert document["values"]["k_pivot"]["value"] == pytest.approx(k, rel=1e-3)


def test_a_margin_that_only_the_exact_model_misses_fails_the_run(flexure, spec):
    document = json.loads(flexure("check", "--model", "exact", "--format", "json").stdout)
    exact = document["checks"][0]["factor"]
    closed = json.loads(flexure("check", "--format", "json").stdout)["checks"][0]["factor"]
    assert exact < closed
    between = (exact + closed) / 2.0
    spec.write_text(SPEC.replace("yield: 1.5", f"yield: {between!r}"))
    assert flexure("check").returncode == 0
    assert flexure("check", "--model", "exact").returncode == 1


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


def test_the_examples_folder_of_linkages_survives_a_write(flexure, tmp_path):
    crank = Path(__file__).parents[2] / "examples/crank-linear-stage/flexure.yaml"
    (tmp_path / "flexure.yaml").write_text(crank.read_text())
    assert flexure("size", "--write", "sized.yaml").returncode == 0
    assert flexure("check", "sized.yaml").returncode == 0
