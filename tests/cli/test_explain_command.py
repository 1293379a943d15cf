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
