"""The answer of ``flexure stops`` as text and CSV, from results made by hand."""

import csv
from io import StringIO

import pytest

from flexcli.report.as_json import contents
from flexcli.report.formats import Page
from flexcli.report.stops_csv import history_csv, sweep_csv
from flexcli.report.stops_text import stops_tables
from flexcli.report.tables import on_page
from flexcli.results import Result, Status
from flexcli.results.stops import (
    StopEnd,
    StopHistory,
    StopHold,
    StopKick,
    StopPlace,
    StopSimulation,
    StopsResult,
    StopSweep,
    SweepStep,
)

PLACE = StopPlace("chosen", 15e-3, 33e-6, 5e4, 5.0, 6.1, 5.9, 97e-6, 1.1, 0.95, 0.15, 0.37, 13e6,
                  12e6, 7e6, 42e6, 13e6)  # fmt: skip
RUN = StopSimulation(
    case="launch", kind="random, 4 exposures of 60 s", law="rigid", q=30.0, modes=1, seed=0,
    planned=240.0, duration=240.0, outcome="", confidence=0.8, travel=1e-4, pi_5=6.0, force=3.0,
    impulse=0.0, contacts=12, contact_share=0.05, fastest=0.03, sigma_base=1e7, sigma_contact=2e7,
    p_hertz=None, tau_hertz=None, energy_residual=1e-15, impulse_residual=1e-15, events=24,
    seconds=1.0,
)  # fmt: skip


def step(up, frequency, settled=True):
    return SweepStep(up, frequency, 1e-4, 2.0, 2.0, settled)


def told(stops):
    return on_page(stops_tables(stops), Page(150))


def result(**changes):
    return StopsResult("chosen", PLACE, (PLACE,))._replace(**changes)


def test_what_has_no_stop_says_why_and_what_would_do():
    text = told(result(outcome="infeasible", reason="nowhere: bending", remedy="more travel"))
    assert "no stop is possible: nowhere: bending" in text
    assert "remedy: more travel" in text


def test_limits_have_every_range_in_which_they_hold():
    rows = (StopHold("contact shear", ((15e-3, 18e-3), (25e-3, 25.6e-3))), StopHold("bending", ()))
    text = told(result(holds=rows))
    assert "15 mm to 18 mm, 25 mm to 25.6 mm" in text
    assert "nowhere" in text


@pytest.mark.parametrize(
    ("changes", "words"),
    [({}, "80.0%, seed 0"),
     ({"duration": 30.0}, "interrupted after 30 s of 240 s"),
     ({"contacts": 0}, "none"),
     ({"impulse": 2e-3, "force": 0.0}, "0.002 N·s"),
     ({"outcome": "contacts follow each other"}, "contacts follow each other"),
     ({"p_hertz": 4e7, "tau_hertz": 1.2e7}, "40 MPa, 12 MPa")],
)  # fmt: skip
def test_a_simulation_tells_how_it_went(changes, words):
    assert words in told(result(simulations=(RUN._replace(**changes),)))


def test_a_response_tells_its_bands_and_shows_both_ways_beside_each_other():
    steps = (step(True, 100.0), step(True, 110.0, settled=False), step(False, 110.0))
    sweep = StopSweep("s", "stepped", steps, (100.0, 110.0), None, None)
    text = told(result(sweeps=(sweep,)))
    assert "going up it touches from 100 Hz to 110 Hz" in text
    assert "going down the blade does not touch" in text
    assert "* unsettled" in text
    end, kick = StopEnd(110.0, True, "it folds back"), StopKick(105.0, 1e-4, 2e-3, 0.02, 0.4)
    told_more = told(result(sweeps=(sweep._replace(ends=(end,), kicks=(kick,)),)))
    assert "going up a motion ends at 110 Hz: it folds back" in told_more
    assert all(words in told_more for words in ("0.1 mN·s", "2 mN·s", "0.4 m/s"))
    unknown = kick._replace(enough=None, speed_enough=None)
    assert "not found" in told(result(sweeps=(sweep._replace(kicks=(unknown,)),)))
    twice = sweep._replace(contact_down=(100.0, 104.0), metastable=(104.0, 110.0))
    assert "metastable: 104 Hz to 110 Hz" in told(result(sweeps=(twice,)))


def test_a_long_response_is_thinned_and_says_so():
    steps = tuple(step(True, 100.0 + n) for n in range(60))
    text = told(result(sweeps=(StopSweep("s", "stepped", steps, None, None, None),)))
    assert "one in 3 of 60 steps" in text


def test_a_response_that_was_stopped_tells_no_more_than_was_done():
    none = StopSweep("shake", "up", (), None, None, None, is_complete=False)
    text = told(result(sweeps=(none,)))
    assert "no step of it was done" in text
    assert "does not touch" not in text
    one = none._replace(steps=(step(True, 40.0),))
    assert "does not touch in the steps that were done" in told(result(sweeps=(one,)))


def test_csv_keeps_every_digit():
    history = StopHistory("a", (0.1, 0.2), (1 / 3, -1e-5), (0.0, 0.0), (0.0, 2.5))
    rows = history_csv(result(histories=(history,))).splitlines()
    assert rows[0] == "case,time_s,tip_m,at_stop_m,force_N"
    assert float(rows[1].split(",")[2]) == 1 / 3
    sweep = StopSweep("s", "", (step(False, 1 / 7, settled=False),), None, None, None)
    row = sweep_csv(result(sweeps=(sweep,))).splitlines()[1].split(",")
    assert float(row[2]) == 1 / 7
    assert row[6:] == ["false", "", "", "", "", ""]


def test_any_name_of_a_case_keeps_to_its_cell():
    name = 'sine, 1.5 g "slow"\nand back'
    history = StopHistory(name, (0.1,), (1 / 3,), (0.0,), (2.5,))
    sweep = StopSweep(name, "", (step(True, 1 / 7),), None, None, None)
    for text in (history_csv(result(histories=(history,))), sweep_csv(result(sweeps=(sweep,)))):
        (row,) = csv.DictReader(StringIO(text, newline=""))
        assert row["case"] == name
        assert None not in row, "no cell beyond the heading"


def test_a_range_and_the_periods_of_a_motion_are_told():
    odd = step(True, 100.0, settled=False)._replace(least=5e-5)
    double = step(True, 110.0)._replace(periods=2, multiplier=0.5)
    told_sweep = StopSweep("s", "stepped", (odd, double), None, None, None)
    text = told(result(sweeps=(told_sweep,)))
    assert "50 µm to 100 µm *" in text
    assert "(2 periods)" in text
    assert sweep_csv(result(sweeps=(told_sweep,))).splitlines()[2].endswith("true,2,0.5,,,stepped")


def test_json_leaves_histories_to_the_csv_file():
    history = StopHistory("a", (0.1,), (0.0,), (0.0,), (0.0,))
    told = Result("stops", "spec", Status.PASS, stops=result(histories=(history,)))
    assert "histories" not in contents(told)["stops"]
