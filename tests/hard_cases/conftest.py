"""The table of hard cases: what usually breaks, the digits kept, the time.

``pytest tests/hard_cases --hard-case-table`` prints it. What usually breaks is the docstring of
the test; the digits are what the test told the fixture ``kept``, those of its worst variant.
"""

from collections import defaultdict
from math import inf, log10
from typing import Any, NamedTuple

import numpy as np
import pytest

MOST = 16.0
"""Digits of a float."""


class Case(NamedTuple):
    """One variant of a test: its digits (None where it decides something), its time [s]."""

    digits: float | None
    seconds: float
    breaks: str


def digits_of(found: Any, exact: Any, scale: Any = None) -> float:
    """Return to how many digits numbers agree, over the larger of each, or over a scale."""
    found, exact = np.broadcast_arrays(
        np.asarray(found, dtype=np.float64), np.asarray(exact, dtype=np.float64)
    )
    size = np.maximum(np.abs(found), np.abs(exact)) if scale is None else np.asarray(scale)
    apart = np.abs(found - exact)
    with np.errstate(invalid="ignore", divide="ignore"):
        worst = float(np.max(np.where(apart == 0.0, 0.0, apart / size), initial=0.0))
    return MOST if worst == 0.0 else min(MOST, max(0.0, -log10(worst))) if worst < inf else 0.0


@pytest.fixture
def kept(record_property):
    """Return a recorder ``kept(found, exact, scale=None)`` of the digits that a case keeps."""

    def record(found: Any, exact: Any, scale: Any = None) -> float:
        digits = digits_of(found, exact, scale)
        record_property("digits", digits)
        return digits

    return record


@pytest.fixture(autouse=True)
def _sentence(request, record_property):
    record_property("breaks", " ".join((request.function.__doc__ or "").split()))


def pytest_addoption(parser):
    parser.addoption(
        "--hard-case-table", action="store_true", help="Print hard cases, digits kept and time."
    )


def cases(reports):
    """Return the variants of each test that passed or failed, by file and name."""
    found = defaultdict(list)
    for report in reports:
        told = dict(report.user_properties)
        if report.when != "call" or "breaks" not in told:
            continue
        digits = [value for name, value in report.user_properties if name == "digits"]
        file, _, test = report.location
        found[file, test.partition("[")[0]].append(
            Case(min(digits, default=None), report.duration, told["breaks"])
        )
    return found


def pytest_terminal_summary(terminalreporter, config):
    if not config.getoption("--hard-case-table"):
        return
    stats = terminalreporter.stats
    found = cases([*stats.get("passed", ()), *stats.get("failed", ())])
    terminalreporter.section("hard cases: digits kept, time of a variant, what usually breaks")
    file = ""
    for (where, test), variants in found.items():
        if where != file:
            file = where
            terminalreporter.write_line(f"\n{file}")
        digits = [v.digits for v in variants if v.digits is not None]
        kept_digits = f"{min(digits):5.1f}" if digits else "    –"
        seconds = sum(v.seconds for v in variants) / len(variants)
        words = test.removeprefix("test_").replace("_", " ")
        terminalreporter.write_line(f"{kept_digits}  {seconds * 1e3:8.2f} ms  {words}")
        terminalreporter.write_line(f"{'':20}{variants[0].breaks}")
