"""Which of several models an undecided check is shown by: the one that is sure of it most."""

from math import inf

import pytest
from strategies import design, rcc

from flexcli.engine import judge
from flexcli.engine.models import model_series
from flexcli.parts.requirements import Limit
from flexcli.results import ErrorRange, Verdict

CASES = {"turn": {"stroke": {"rotation": "1 deg"}}}
SPEC = design(rcc(h="0.1 mm", b="5 mm", l="20 mm"), {"stiffness": {"min": "1 N*m/rad"}}, CASES)


def shown(monkeypatch, **errors):
    """Return the check of a factor of 1, asked for as such, that models know up to these errors."""

    def limits(design, sizes, requirement, scene, model, near=None):
        yield Limit("a", "", "a", 1.0, 1.0, "", "", error=errors[model.name], in_capacity=True)

    monkeypatch.setattr(judge, "limits_by", limits)
    models = tuple(m for m in model_series(SPEC) if m.name in errors)
    checks = judge.judge(SPEC, SPEC.fixed_sizes(), models, formulas=False).checks
    return next(check for check in checks if check.name == "a")


WIDE, NARROW = ErrorRange(-0.2, 0.3), ErrorRange(-0.1, 0.1)


@pytest.mark.parametrize("finer", [WIDE, None, ErrorRange(-0.1, inf)])
def test_an_open_check_has_the_narrowest_range_that_a_model_gives(monkeypatch, finer):
    found = shown(monkeypatch, linear=NARROW, exact=finer)
    assert found.verdict is Verdict.UNDECIDED
    assert found.model == "linear"
    assert found.factor_range == pytest.approx((0.9, 1.1))


def test_of_ranges_without_end_that_counts_which_is_surely_more(monkeypatch):
    ranges = {"linear": ErrorRange(-0.1, inf), "exact": ErrorRange(-0.2, inf)}
    assert shown(monkeypatch, **ranges).model == "linear"
    assert shown(monkeypatch, linear=ranges["exact"], exact=ranges["linear"]).model == "exact"


def test_a_finer_model_is_shown_where_it_is_as_sure_and_where_it_decides(monkeypatch):
    assert shown(monkeypatch, linear=NARROW, exact=NARROW).model == "exact"
    decided = shown(monkeypatch, linear=NARROW, exact=ErrorRange(0.05, 3.0))
    assert (decided.model, decided.verdict) == ("exact", Verdict.PASS)
