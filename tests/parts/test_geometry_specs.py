"""Every flexure from its YAML: in the schema, checked, explained and sized."""

import json

import pytest
import yaml
from geometries_for_tests import SAMPLES, geometry, kinds, spec
from judging import size_as_printed
from strategies import TITANIUM, design
from typer.testing import CliRunner

from flexcli.cli.app import command_line
from flexcli.parts.elastic import Elastic
from flexcli.results import Status
from flexcli.spec.schema import json_schema

KINDS = sorted(SAMPLES)

every_kind = pytest.mark.parametrize("kind", KINDS)


def test_the_json_schema_has_every_kind():
    text = json.dumps(json_schema("design"))
    assert not [kind for kind in kinds() if f'"const": "{kind}"' not in text]


def written(path, content):
    path.write_text(yaml.safe_dump(content, allow_unicode=True), encoding="utf-8")
    return str(path)


@every_kind
def test_a_spec_of_it_is_checked_from_the_command_line(kind, tmp_path):
    part = geometry(kind)
    moved = "0.5 deg" if part.motion == "rotation" else "0.1 mm"
    path = written(
        tmp_path / "flexure.yaml",
        {
            "flexure": 1,
            "material": TITANIUM,
            "geometry": spec(kind),
            "stroke": {part.motion: moved, "cycles": 1e7},
            "requirements": {"fatigue": 1.0, "yield": 1.0},
        },
    )
    told = CliRunner().invoke(
        command_line(), ["check", path, "--model", "source", "--format", "json"]
    )
    assert told.exit_code in (0, 1), told.output
    document = json.loads(told.stdout)
    asked = [check["name"] for check in document["checks"] if check["name"] != "geometry"]
    assert asked == ["fatigue", "yield (yield-strength)"]
    symbol = "k_pivot" if part.motion == "rotation" else "k_stage"
    assert document["values"][symbol]["value"] == pytest.approx(
        part.stiffness(Elastic(114e9, 0.34), part.probe())
    )


@every_kind
def test_it_is_explained_under_its_name(kind):
    told = CliRunner().invoke(command_line(), ["explain", kind, "--format", "json"])
    assert told.exit_code == 0, told.output
    assert kind in told.stdout
    assert CliRunner().invoke(command_line(), ["explain", kind]).exit_code == 0


@pytest.mark.parametrize("kind", [kind for kind in KINDS if kinds()[kind].posynomial])
def test_it_is_sized_and_meets_what_is_asked(kind):
    part = geometry(kind)
    free = {
        name: {"free": [f"{x * 1e2} mm", f"{x * 1e4} mm"]}
        for name, x in part.probe()._asdict().items()
    }
    moved = "1 deg" if part.motion == "rotation" else "0.2 mm"
    bounds = {"l/h": {"min": 20.0}, "b/h": {"min": 5.0}}
    found = design(
        {**spec(kind), **free},
        {"fatigue": 1.5, **bounds},
        {"work": {"stroke": {part.motion: moved, "cycles": 1e7}}},
    )
    result = size_as_printed(found, "spec")
    assert result.status is Status.PASS
    assert all(check.margin >= -1e-9 for check in result.checks)


@pytest.mark.slow
@every_kind
def test_its_greatest_thickness_is_the_one_that_just_bears_the_stroke(kind):
    part = geometry(kind)
    thin, size_now = part.probe()._fields[0], part.probe()[0]
    free = {thin: {"free": [f"{size_now * 50.0} mm", f"{size_now * 2e4} mm"]}}
    moved = "4 deg" if part.motion == "rotation" else "1 mm"
    found = design(
        {**spec(kind), **free},
        {"fatigue": 1.5},
        {"work": {"stroke": {part.motion: moved, "cycles": 1e7}}},
        size={"objective": {"maximize": thin}},
    )
    (check,) = (c for c in size_as_printed(found, "spec").checks if c.name != "geometry")
    assert check.factor == pytest.approx(1.5, rel=1e-6)
