"""A design with stops is judged with them: what it bears between them, not as if it were free."""

import pytest
from stop_designs import SINE, stopped

from flexcli.engine.check import check
from flexcli.results import Status, Verdict

pytestmark = pytest.mark.slow  # runs in time, contact by contact

FLAT = [{"frequency": "20 Hz", "level": "0.02 g^2/Hz"},
        {"frequency": "400 Hz", "level": "0.02 g^2/Hz"}]  # fmt: skip
SHAKE = {"shake": {"asd": {"profile": {"points": FLAT}, "q": 30, "duration": "0.3 s"}}}
PLACE = {"height": "15 mm", "gap": "20 um", "travel": "2 mm"}


def judged(stops=PLACE, model=None, cases=SHAKE, **requirements):
    design = stopped(stops, cases=cases, requirements=requirements)
    return check(design, design.fixed_sizes(), "spec", model)


def row(result, name):
    (found,) = (c for c in result.checks if c.name == name)
    return found


def test_between_stops_a_blade_is_judged_as_it_touches():
    free = row(judged({**PLACE, "gap": "50 mm", "travel": "80 mm"}, **{"dynamic-yield": 1.0}),
               "dynamic yield")  # fmt: skip
    between = row(judged(**{"dynamic-yield": 1.0}), "dynamic yield")
    assert between.model == "rigid contact"
    assert "between" not in free.quantity
    assert between.demand != pytest.approx(free.demand, rel=1e-3)


def test_the_stops_own_limits_are_checks_of_the_design_too():
    result = judged({**PLACE, "travel": "90 um"}, **{"dynamic-yield": 1.0})
    assert row(result, "travel").verdict is Verdict.FAIL
    assert result.status is Status.FAIL


def test_a_sine_that_only_stops_look_at_is_judged():
    result = judged({"height": "20 mm", "gap": "30 um", "travel": "1 mm"}, cases=SINE)
    assert row(result, "travel").verdict is Verdict.PASS
    assert Verdict.NOT_JUDGED not in {c.verdict for c in result.checks}
    assert result.status is Status.PASS


def test_a_model_that_is_insisted_on_simulates_nothing_and_decides_nothing_there():
    result = judged(model="closed-form", **{"dynamic-yield": 1.0})
    assert row(result, "dynamic yield").verdict is Verdict.UNDECIDED
    assert "rigid contact" not in result.cost.by_model
    assert result.status is not Status.PASS


def test_what_the_simulation_took_is_in_the_cost():
    result = judged(**{"dynamic-yield": 1.0})
    assert 0.0 < result.cost.by_model["rigid contact"] <= result.cost.seconds
