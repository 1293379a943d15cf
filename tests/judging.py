"""Designs judged by the sources' formulas as if these were exact, as tests of them need it."""

from dataclasses import replace

from flexcli.engine.assess import ROUNDING
from flexcli.engine.check import check
from flexcli.engine.size import size
from flexcli.results import Status, Verdict

__all__ = ["check_as_printed", "size_as_printed"]


def size_as_printed(design, name="spec"):
    """Return a design sized by the formulas; it passes where their own numbers do."""
    return _by_own_numbers(size(design, name, "source"))


def check_as_printed(design, sizes, name="spec"):
    """Return a design judged by the formulas; it passes where their own numbers do."""
    return _by_own_numbers(check(design, sizes, name, "source"))


def _by_own_numbers(result):
    if result.status is Status.INFEASIBLE:
        return result
    judged = tuple(one for one in result.checks if one.verdict is not Verdict.NOT_JUDGED)
    met = all(one.factor >= one.required * (1.0 - ROUNDING) for one in judged)
    return replace(result, status=Status.PASS if met else Status.FAIL, checks=judged)
