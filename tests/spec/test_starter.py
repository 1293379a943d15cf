"""First specs: whoever starts from one, of any kind, starts from a design that passes."""

from functools import cache

import pytest
from jsonschema import Draft202012Validator

from flexcli import api
from flexcli.parts.geometries import GEOMETRIES
from flexcli.parts.mechanisms import MECHANISMS
from flexcli.results import Status
from flexcli.spec.parse import parse_document
from flexcli.spec.schema import json_schema
from flexcli.spec.starter import kinds, starter

USUAL = {"leaf-spring-stage", "rcc", "cross-spring"}
"""What a newcomer is likely to start from."""


@cache
def validator():
    return Draft202012Validator(json_schema("design"))


def test_there_is_one_of_every_joint_and_every_mechanism():
    assert set(kinds()) == {*GEOMETRIES.paths, *MECHANISMS.paths}


@pytest.mark.parametrize("kind", kinds())
def test_a_first_spec_follows_the_schema(kind):
    document = parse_document(starter(kind), kind)
    validator().validate(document.value)
    part = "mechanism" if kind in MECHANISMS.paths else "geometry"
    assert document.value[part]["kind"] == kind


@pytest.mark.parametrize(
    "kind",
    [k if k in USUAL else pytest.param(k, marks=pytest.mark.slow) for k in kinds()],
)
def test_a_first_spec_passes_as_it_stands(kind):
    text = starter(kind)
    result = api.size(text) if "flexure size" in text.splitlines()[2] else api.check(text)
    assert result.status is Status.PASS
    asked = {check.name.partition(" ")[0] for check in result.checks}
    assert asked >= {"fatigue", "yield"}
    assert kind not in MECHANISMS.paths or len(asked) > 2, "vibration is judged too"


@pytest.mark.parametrize("kind", ["leaf-spring-stage", "linkage", "parallel-stage"])
def test_a_first_spec_names_its_schema_and_says_of_each_key_what_it_means(kind):
    lines = starter(kind).splitlines()
    assert lines[0] == "# yaml-language-server: $schema=flexure.schema.json"
    assert max(map(len, lines)) <= 100
    for key in ("material", "geometry", "kind", "cases", "stroke", "requirements", "yield"):
        at = next(i for i, line in enumerate(lines) if line.strip().startswith(f"{key}:"))
        assert "#" in lines[at] or lines[at - 1].strip().startswith("#"), key
