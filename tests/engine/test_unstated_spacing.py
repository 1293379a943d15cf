"""Blades at an unstated distance: finer models have no answer, and what would give one is said."""

from flexcli import api
from flexcli.results import Status, Verdict

SPEC = """\
flexure: 1
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, h: 0.3 mm, l: 30 mm, b: 10 mm}
mechanism: {kind: payload, mass: 50 g}
stroke: {translation: 1 mm}
requirements: {yield: 1e-6}
"""


def test_what_only_a_finer_model_could_decide_names_the_spacing_that_it_lacks():
    factor = api.check(SPEC).checks[0].factor  # amid its range, where no closed form decides
    asked = {"requirements.yield": factor}
    without = api.check(SPEC, overrides=asked)
    assert without.status is Status.UNDECIDED
    assert "needs-spacing" in {note.code for note in without.warnings}
    given = api.check(SPEC, overrides=asked | {"geometry.spacing": "20 mm"})
    assert given.checks[0].model == "exact"
    assert "needs-spacing" not in {note.code for note in given.warnings}


def test_a_wide_margin_needs_no_spacing():
    assert not {note.code for note in api.check(SPEC).warnings} & {"needs-spacing"}


def test_a_load_out_of_the_plane_that_nothing_can_judge_without_it_says_so():
    pushed = {"wrench.z": "40 N"}
    (row,) = [c for c in api.check(SPEC, overrides=pushed).checks if c.name == "wrench"]
    assert row.verdict is Verdict.NOT_JUDGED
    assert "geometry.spacing" in row.quantity
    found = api.check(SPEC, overrides=pushed | {"geometry.spacing": "20 mm"})
    assert "wrench" not in {check.name for check in found.checks}
