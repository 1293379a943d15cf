"""``flexure balance`` as a user runs it."""

import csv
import json
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[2] / "examples" / "force-balanced-stage" / "flexure.yaml"


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "flexure.yaml"
    path.write_text(EXAMPLE.read_text())
    return path


def test_without_a_file_it_takes_the_spec_of_the_folder(flexure, spec):
    told = flexure("balance")
    assert told.returncode == 0
    assert told.stdout.startswith("PASS  balance flexure.yaml")
    assert "24.1716 mm" in told.stdout


def test_json_stands_alone_and_has_the_table(flexure, spec):
    document = json.loads(flexure("balance", "--format", "json").stdout)
    assert document["command"] == "balance"
    assert [row["frequency"] for row in document["balance"]["transfer"]] == [10.0, 100.0, 1000.0]
    assert document["values"]["l_bal"]["unit"] == "m"


def test_a_sweep_is_saved_as_csv(flexure, spec, tmp_path):
    sweep = "{from: 10 Hz, to: 1 kHz, points: 200}"
    spec.write_text(spec.read_text().replace("[10 Hz, 100 Hz, 1 kHz]", sweep))
    assert flexure("balance", "--csv", "t.csv").returncode == 0
    rows = list(csv.DictReader((tmp_path / "t.csv").read_text().splitlines()))
    assert len(rows) == 200
    assert float(rows[-1]["frequency_Hz"]) == pytest.approx(1000.0)
    assert float(rows[0]["T_init_s2"]) < 0.0


def test_what_cannot_be_balanced_exits_1_with_reason_and_json(flexure, spec):
    spec.write_text(spec.read_text().replace("arm: free", "arm: {free: [0 mm, 20 mm]}"))
    told = flexure("balance", "--format", "json")
    document = json.loads(told.stdout)
    assert told.returncode == 1
    assert document["status"] == "infeasible"
    assert "above its limit 20 mm" in document["balance"]["reason"]


def test_a_mistake_exits_2_with_its_place(flexure, spec):
    spec.write_text(spec.read_text().replace("arm: free", "arm: fre", 1))
    told = flexure("balance")
    assert told.returncode == 2
    assert "mechanism.balance-1.arm: 'fre' is not a number with a unit" in told.stderr
    assert "or free" in told.stderr


def test_size_and_check_take_the_arm_that_balances(flexure, spec):
    for verb in ("size", "check"):
        document = json.loads(flexure(verb, "--format", "json").stdout)
        assert document["values"]["l_bal"]["value"] == pytest.approx(24.1716e-3, rel=1e-5)
        assert document["checks"][0]["name"] == "coupling (max)"
        assert document["checks"][0]["pass"]


@pytest.mark.slow
def test_the_sized_design_is_written_with_what_is_free_in_its_mechanism(flexure, spec, tmp_path):
    text = spec.read_text().replace("h: 637 um", "h: free")
    spec.write_text(text)
    assert flexure("size", "--write", "sized.yaml").returncode == 0
    assert "arm: free" in (tmp_path / "sized.yaml").read_text()
    assert flexure("check", "sized.yaml").returncode == 0


def test_a_design_without_bodies_is_refused(flexure, tmp_path):
    (tmp_path / "flexure.yaml").write_text(
        "flexure: 1\nmaterial: ti-6al-4v\n"
        "geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.1 mm, l: 10 mm, b: 5 mm}\n"
        "stroke: {rotation: 2 deg, cycles: 1e7}\nrequirements: {fatigue: 1.1}\n"
    )
    told = flexure("balance")
    assert told.returncode == 2
    assert "add a mechanism" in told.stderr
