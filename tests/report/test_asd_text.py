"""Worst cases as text, from results made by hand."""

import pytest

from flexcli.report.asd_text import worst_cases
from flexcli.report.formats import Page
from flexcli.report.tables import on_page
from flexcli.results.vibration import WorstCaseRow


def row(**changes):
    given = {
        "case": "launch", "profile": "flat", "applied": "as it stands", "q": 30.0,
        "f_worst": 2000.0, "g_rms_worst": 100.0, "g_rms_exact": 99.0, "g_rms_pseudo": 98.0,
        "f_max": 1900.0, "g_rms_max": 99.5, "miles_excess_there": 0.01, "miles_excess": 0.005,
        "shortfall": 0.0, "f_shortfall": None, "duration": None, "c_sigma": 3.0, "a_sigma": 300.0,
        "c_peak": None, "a_peak": None, "c_davenport": None, "a_davenport": None,
    }  # fmt: skip
    return WorstCaseRow(**{**given, **changes})


def told(*rows):
    return on_page(worst_cases(rows), Page(150))


@pytest.mark.parametrize("excess", [-1e-6, -0.0, 0.0, 1e-6])
def test_what_rounds_to_nothing_is_told_without_a_loss(excess):
    text = told(row(), row(q=31.0, miles_excess=excess, miles_excess_there=excess))
    assert text.count("+0.0%") == 2
    assert "-0.0%" not in text


def test_a_loss_is_told_as_one():
    assert "-0.2%" in told(row(), row(miles_excess=-0.0016))
