"""Sizing corrected to the exact model: the exact margins of its design are at their limit."""

import pytest
from geometries_for_tests import MATERIAL
from strategies import design, rcc

from flexcli.engine.answers.exact import ExactAnswers
from flexcli.engine.answers.linear import LinearAnswers
from flexcli.engine.size import size
from flexcli.engine.sizing.corrected import size_by_model
from flexcli.results import Status

CASES = {"turn": {"stroke": {"rotation": "8 deg"}}}
LIMITS = {"yield": 1.5, "stiffness": {"min": "0.05 N*m/rad"}}


def one(**changes):
    return design(
        rcc(b="5 mm", l={"free": ["5 mm", "60 mm"]}, **changes), LIMITS, CASES, material=MATERIAL
    )


@pytest.mark.parametrize("answers", [LinearAnswers(), ExactAnswers()], ids=["linear", "exact"])
def test_the_margins_of_the_finer_model_are_at_their_limit(answers):
    result = size_by_model(one(), "spec", answers)
    assert result.status is Status.PASS
    assert result.cost.model == answers.model
    assert [c.margin for c in result.checks] == pytest.approx([0.0, 0.0], abs=1e-6)
    assert any(note.code == "corrected" for note in result.warnings)


def test_the_closed_form_design_does_not_pass_the_exact_model():
    closed = size(one(), "spec")
    judged = size(one(), "spec", ExactAnswers())
    assert closed.status is Status.PASS
    assert judged.status is Status.FAIL
    assert judged.values["h"].value == closed.values["h"].value


def test_a_conflict_stays_a_conflict():
    impossible = design(
        rcc(b="5 mm", l="10 mm"), {"yield": 10, "stiffness": {"min": "5 N*m/rad"}}, CASES,
        material=MATERIAL,
    )  # fmt: skip
    assert size_by_model(impossible, "spec", ExactAnswers()).status is Status.INFEASIBLE
