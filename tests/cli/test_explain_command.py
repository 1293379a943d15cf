"""``flexure explain`` on a terminal of 80 columns: YAML to copy, charts that are whole."""

import json

import pytest
import yaml


@pytest.mark.parametrize("name", ["lock", "cases", "sag", "payload", "layout", "geometry.h"])
def test_a_key_is_told_with_yaml_to_copy(flexure, name):
    told = flexure("explain", name, "--format", "json")
    assert told.returncode == 0
    (topic,) = json.loads(told.stdout)["topics"]
    text = flexure("explain", name, COLUMNS="80").stdout
    for field in topic["fields"]:
        assert isinstance(yaml.safe_load(field["example"]), dict)
        assert field["example"] in text
        assert field["text"]


def test_a_name_that_is_near_a_key_is_suggested(flexure):
    told = flexure("explain", "payloud")
    assert told.returncode == 2
    assert "payload" in told.stderr


def test_symbols_are_told_one_by_one(flexure):
    told = json.loads(flexure("explain", "guided-blade-stiffness", "--format", "json").stdout)
    symbols = {s["name"]: s["meaning"] for s in told["topics"][0]["formulas"][0]["symbols"]}
    assert {"h", "l", "b"} <= set(symbols)
    assert len(set(symbols.values())) == len(symbols)


def test_a_chart_is_whole_at_80_columns(flexure):
    arguments = ("explain", "cross-spring", "--table", "delta")
    lines = flexure(*arguments, COLUMNS="80").stdout.splitlines()
    assert max(map(len, lines)) <= 80
    assert not any("…" in line for line in lines)
    (topic,) = json.loads(flexure(*arguments, "--format", "json").stdout)["topics"]
    for column in topic["table"]["columns"]:
        assert any(column in line for line in lines)


@pytest.mark.parametrize(("axis", "fails"), [("x", False), ("y", True)])
def test_the_x_of_a_moment_blade_is_along_it_as_its_sketch_says(flexure, tmp_path, axis, fails):
    told = flexure("explain", "moment-blade", COLUMNS="100").stdout
    assert "x is along the blade" in told
    assert "x, stroke" not in told
    (tmp_path / "flexure.yaml").write_text(
        "flexure: 1\nmaterial: cube-c17200\n"
        "geometry: {kind: moment-blade, h: 0.15 mm, l: 15 mm, b: 6 mm}\n"
        "mechanism: {kind: payload, mass: 5 g, inertia: 2e-7 kg*m^2, damping: {q: 40}}\n"
        f"cases: {{sweep: {{sine: {{acceleration: 3 g, frequency: 100 Hz, axis: {axis}}}}}}}\n"
        "requirements: {dynamic-yield: 50}\n"
    )
    # 0.15 N: 0.2 MPa along the blade; across it the moment of the lever is a hundred times as much
    assert flexure("check").returncode == int(fails)
