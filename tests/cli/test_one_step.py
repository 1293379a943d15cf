"""From a spec to an answer in one command: free sizes, values put over, stdin, several specs."""

import json

import pytest
import yaml

SPEC = """\
flexure: 1
title: a pivot
material: {youngs_modulus: 114 GPa, poisson_ratio: 0.33, yield_strength: 900 MPa}
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: free, l: 10 mm, b: 2 mm}
cases:
  work: {stroke: {rotation: 2 deg}}
requirements: {yield: 1, stiffness: {min: 0.3 N*m/rad}}
effects: {plate-widening: off, anticlastic: off}
"""


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "flexure.yaml"
    path.write_text(SPEC)
    return path


def document(run):
    return json.loads(run.stdout)


@pytest.mark.parametrize("verb", ["check", "plan", "simulate"])
def test_a_spec_with_free_sizes_is_sized_first_and_says_so(flexure, spec, verb):
    """The sizes are those of ``flexure size``, to the digits that it writes."""
    sizing = document(flexure("size", "--format", "json", "--write", "sized.yaml"))
    told = document(flexure(verb, "--format", "json"))
    given = document(flexure(verb, "sized.yaml", "--format", "json"))
    assert told["warnings"][0]["code"] == "sized-first"
    assert told["values"]["h"]["value"] == sizing["values"]["h"]["value"]
    assert (told["command"], told["status"]) == (verb, given["status"])
    assert [c["factor"] for c in told["checks"]] == [c["factor"] for c in given["checks"]]


def test_text_says_that_a_design_was_sized_first(flexure, spec):
    assert "sized first" in flexure("check").stdout


@pytest.mark.parametrize("verb", ["check", "simulate", "accuracy", "plan"])
def test_a_spec_that_cannot_be_sized_has_the_result_of_size(flexure, spec, verb):
    spec.write_text(
        SPEC.replace("0.3 N*m/rad", "1 kN*m/rad").replace("h: free", "h: {free: [1 um, 1 mm]}")
    )
    told = flexure(verb, "--format", "json")
    assert told.returncode == 1
    assert document(told)["status"] == "infeasible"
    assert document(told)["command"] == verb
    assert document(told)["sizing"]["conflict"]


def test_a_value_put_over_the_specs_is_as_if_it_stood_there(flexure, spec):
    over = document(flexure("check", "--set", "geometry.h=0.25mm", "--format", "json"))
    spec.write_text(SPEC.replace("h: free", "h: 0.25 mm"))
    there = document(flexure("check", "--format", "json"))
    assert over["values"]["h"]["value"] == 0.25e-3
    assert [c["factor"] for c in over["checks"]] == [c["factor"] for c in there["checks"]]


def test_set_reaches_into_a_named_spec_adds_keys_and_replaces_whole_mappings(flexure, spec):
    """The named material has E = 114 GPa: half of it halves the stiffness."""
    spec.write_text(SPEC.replace(SPEC.splitlines()[2], "material: ti-6al-4v-course"))
    fixed = ("--set", "geometry.h=0.25 mm", "--set", "effects.shear=off", "--model", "source")
    soft = (
        "--set",
        "material.youngs_modulus=57 GPa",
        "--set",
        "requirements={stiffness: {min: 1 N*m/rad}}",
    )
    k = [
        document(flexure("check", *more, *fixed, "--format", "json"))["values"]["k_pivot"]["value"]
        for more in ((), soft)
    ]
    assert k[1] == pytest.approx(k[0] / 2, rel=1e-12)


@pytest.mark.parametrize(
    ("stated", "where", "hint"),
    [
        ("geometry.hh=0.2mm", "--set:1:1: geometry.hh: unknown key", "did you mean 'h'?"),
        ("geometry.h=0.2", "--set:1:12: geometry.h:", "e.g. 0.2 mm"),
        (
            "geometry.p.q=1 mm",
            "--set:1:1: geometry.p.q: there is no such place",
            "geometry.p as a whole",
        ),
        ("geometry.h=[1", "--set:1:12: this bracket is never closed", "close it"),
        ("geometry.h", "--set: 'geometry.h' has no '='", "write geometry.h=0.2mm"),
        ("geometry.h=", "a value is missing", "write e.g."),
        ("material=ti-6al4v", "--set:1:10: material: there is no shipped material", "ti-6al-4v"),
        ("flexure=2", "--set:1:9: flexure: 2 is no version", "flexure: 1"),
    ],
)
def test_a_mistake_in_set_is_a_finding_with_the_specs_path(flexure, spec, stated, where, hint):
    told = flexure("check", "--set", stated)
    assert told.returncode == 2
    assert where in told.stderr
    assert hint in told.stderr


def test_a_mistake_in_set_points_at_its_own_line(flexure, spec):
    told = flexure(
        "check", "--set", "geometry.h=0.2mm", "--set", "geometry.ll=1 mm", "--format", "json"
    )
    (found,) = document(told)["findings"]
    assert (found["file"], found["line"], found["path"]) == ("--set", 2, "geometry.ll")


def test_one_value_is_set_once(flexure, spec):
    told = flexure("check", "--set", "geometry.h=1mm", "--set", "geometry.h=2mm")
    assert (told.returncode, "set twice" in told.stderr) == (2, True)


def test_a_spec_comes_from_stdin(flexure, spec, tmp_path):
    told = flexure("size", "-", "--format", "json", "--write", "sized.yaml", stdin=SPEC)
    assert told.returncode == 0
    assert document(told)["spec"] == "<stdin>"
    assert yaml.safe_load((tmp_path / "sized.yaml").read_text())["title"] == "a pivot"
    told = flexure("check", "-", stdin="flexure: 1\nmaterial: steel")
    assert told.returncode == 2
    assert "<stdin>:2:11: material" in told.stderr


@pytest.mark.parametrize("verb", ["size", "plan"])
def test_several_specs_end_with_a_summary_and_the_worst_exit_code(flexure, spec, tmp_path, verb):
    (tmp_path / "bad.yaml").write_text("flexure: 1\n")
    told = flexure(verb, spec.name, "bad.yaml", "--format", "json")
    assert told.returncode == 2
    assert [r["status"] for r in document(told)["results"]] == ["pass", "error"]


def test_one_file_is_not_written_for_two_specs(flexure, spec, tmp_path):
    told = flexure("size", spec.name, spec.name, "--write", "sized.yaml")
    assert told.returncode == 2
    assert "--write: takes the result of one spec" in told.stderr
    assert not (tmp_path / "sized.yaml").exists()


def test_what_is_asked_of_the_joint_itself_needs_no_case(flexure, spec):
    spec.write_text(
        SPEC.replace("cases:\n  work: {stroke: {rotation: 2 deg}}\n", "").replace("yield: 1, ", "")
    )
    assert flexure("check", "--set", "geometry.h=0.3 mm").returncode == 0
    told = flexure("check", "--set", "geometry.h=0.3 mm", "--set", "requirements.yield=2")
    assert told.returncode == 2
    assert "'cases' is missing" in told.stderr
