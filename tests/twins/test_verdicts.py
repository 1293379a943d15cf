"""No verdict passes what an independent solution of the same joint says fails.

A design a kind here; `tests/benchmarks/twins.py` judges hundreds and prints what came of them.
"""

import pytest

from twins.designs import KINDS, drawn
from twins.verdicts import RIGHT, UNSAFE, checked, score


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(len(KINDS)), ids=lambda seed: KINDS[seed])
def test_no_requirement_missed_by_three_per_cent_passes(seed):
    design = drawn(seed + 3 * len(KINDS), quick=True)
    assert design.questions, design.dropped
    for question in design.questions:
        said = checked(design.asked(question, kept=False), question.name)
        assert score(said, kept=False) != UNSAFE, (question.name, question.true, said)
        assert said.exit_code != 101, said.text


@pytest.mark.parametrize("seed", [100287, 100219])
def test_a_force_that_pushes_relieves_the_bending_of_blades(seed):
    """A cantilever and a stage that a load of 180 deg compresses while they are moved."""
    design = drawn(seed, quick=True)
    assert design.spec["cases"]["work"]["load"]["direction"] == "180.0 deg"
    for question in design.questions:
        if question.name == "yield":
            for kept in (True, False):
                said = checked(design.asked(question, kept), question.name)
                assert score(said, kept) == RIGHT
