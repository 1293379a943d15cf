"""Height and gap of a stop: the smallest that keeps all limits, and what is said where it errs."""

from math import pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from stop_designs import BALL, LENGTH, MASS, REST, SINE, THICKNESS, E, I, stopped

from flexcli.engine.stops import stops
from flexcli.errors import SolveError
from flexcli.formulas.handbook.stop_numbers import stop_design
from flexcli.formulas.stop_line import line_gap, line_height
from flexcli.results import Status, Verdict

EXACT = 1e-12
"""The same formulas by two routes."""


def run(*arguments, **changes):
    design = stopped(*arguments, **changes)
    return stops(design, design.fixed_sizes(), "spec")


def check(result, name):
    (found,) = (c for c in result.checks if c.name == name)
    return found


def kept(result):
    """Tell whether every number keeps its limit, whatever its error."""
    return all(c.factor >= c.required * (1.0 - 1e-9) for c in result.checks)


def codes(result):
    return [note.code for note in result.warnings]


def test_the_statics_are_those_of_the_source_on_its_line():
    place = run({"height": "20 mm"}).stops.chosen
    design = stop_design(E=E, I=I, h=THICKNESS, L_a=20e-3, L_b=LENGTH - 20e-3, delta_O=200e-6)
    assert place.delta_G == pytest.approx(design.gap, rel=EXACT)
    assert place.tip_at_contact == pytest.approx(design.tip_at_contact, rel=EXACT)
    assert pytest.approx(design.load, rel=EXACT) == place.F
    assert pytest.approx(design.stop_force, rel=EXACT) == place.R_stop
    assert place.sigma_onset == pytest.approx(design.onset_stress, rel=EXACT)
    assert place.sigma_base == pytest.approx(design.base_stress, rel=EXACT)
    assert place.sigma_contact == pytest.approx(design.stop_stress, rel=EXACT)
    assert pytest.approx(place.F_contact + place.F_excess, rel=EXACT) == place.F


def test_what_is_free_takes_the_smallest_gap_of_the_measured_range():
    result = run({"bending": 2, "smallest-gap": "20 um"})
    assert kept(result)
    assert result.stops.chosen.pi_1 == pytest.approx(5.0, rel=1e-9)
    assert "outside-validity" not in codes(result)


@pytest.mark.slow
@settings(max_examples=20, deadline=None)
@given(st.integers(33, 80), st.integers(20, 90))
def test_the_stop_chosen_keeps_all_and_one_a_little_lower_does_not(smallest, stroke):
    cases = SINE | {"operation": {"stroke": {"translation": f"{stroke} um"}}}
    limits = {"bending": 2, "smallest-gap": f"{smallest} um"}
    found = run(limits, cases=cases)
    assert kept(found)
    lower = found.stops.chosen.L_a * (1.0 - 1e-6)
    below = run({**limits, "height": f"{lower!r} m"}, cases=cases)
    assert not kept(below) or below.stops.chosen.pi_1 < 5.0


def test_a_given_gap_takes_its_height_from_the_line():
    place = run({"gap": "44 um"}).stops.chosen
    assert place.L_a == pytest.approx(line_height(d=44e-6, L=LENGTH, delta_O=200e-6), rel=EXACT)


def test_a_stop_off_the_line_is_judged_by_the_travel_that_the_line_gives_it():
    gap = float(line_gap(L_a=20e-3, L_b=LENGTH - 20e-3, delta_O=200e-6))
    for share in (0.9, 1.1):
        result = run({"height": "20 mm", "gap": f"{share * gap!r} m"})
        assert kept(result) is (share < 1.0)
        assert check(result, "travel").factor == pytest.approx(1.0 / share, rel=EXACT)


@pytest.mark.parametrize("share", [0.5, 0.9, 1.0, 1.1])
def test_the_line_alone_never_proves_that_a_stop_keeps_the_travel(share):
    # it is a fit to steady motions: the way there from rest goes farther
    gap = share * float(line_gap(L_a=20e-3, L_b=LENGTH - 20e-3, delta_O=200e-6))
    result = run({"height": "20 mm", "gap": f"{gap!r} m"})
    assert check(result, "travel").verdict is Verdict.UNDECIDED
    assert result.status.exit_code == 1


def test_the_line_proves_a_failure_beyond_all_that_scatters():
    result = run({"height": "20 mm", "gap": "80 um"})
    assert check(result, "travel").verdict is Verdict.FAIL


@pytest.mark.parametrize(
    "case",
    [{"shock": {"velocity": "0.3 m/s"}},
     {"sine": {"acceleration": "1.5 g", "frequency": "150 Hz"}}],
)  # fmt: skip
def test_where_the_line_was_not_measured_its_error_is_unknown(case):
    result = run({"height": "20 mm", "gap": "80 um"}, cases={"other": case})
    assert check(result, "travel").factor_range is None


def test_widening_is_left_out_of_the_numbers_and_in_their_error():
    # flat across its width it is stiffer by ν²/(1 − ν²), 12 %; this one by a part of that
    values = run({"height": "20 mm"}, material={"poisson_ratio": 0.33}).values
    assert values["k_free"].value == pytest.approx(3 * E * I / LENGTH**3, rel=1e-12)
    assert 0.01 <= values["k_free"].estimated_error <= 1 / (1 - 0.33**2) - 1


def test_a_hard_stop_is_not_reached_and_says_so():
    result = run({"height": "25.65 mm"})
    assert result.status is Status.FAIL
    assert not check(result, "contact").passed
    assert {"hard-stop", "outside-validity"} <= set(codes(result))


def test_outside_the_measured_range_the_value_and_the_range_are_named():
    result = run({"height": "10 mm"})
    (text, *_) = (note.text for note in result.warnings if "pi_1" in note.text)
    assert text.startswith(f"pi_1 = {result.stops.chosen.pi_1:.4g} is outside 5 to 250")


def test_where_the_statics_do_not_hold_is_said():
    texts = [note.text for note in run({"travel": "4 mm", "height": "27 mm"}).warnings]
    assert any(text.startswith("travel/L = 0.1404 is outside at most 0.1") for text in texts)
    assert any(text.startswith("L_b/h = 1.2 is outside at least 2") for text in texts)


def test_a_height_bounded_outside_the_measured_range_is_refused():
    result = run({"height": {"free": ["5 mm", "10 mm"]}})
    assert result.status is Status.INFEASIBLE
    assert "where the operating line was measured" in result.stops.reason


def test_a_gap_that_no_stop_could_have_is_refused():
    result = run({"gap": "19 um"})
    assert result.status is Status.INFEASIBLE
    assert "below any" in result.stops.reason


@pytest.mark.parametrize(
    ("bounds", "where"),
    [({"height": "20 mm", "gap": {"free": ["50 um", None]}}, "a gap of 44"),
     ({"gap": "44 um", "height": {"free": [None, "18 mm"]}}, "a height of 19.9"),
     ({"gap": {"free": ["95 um", None]}}, "gap is bounded outside 32.5")],
)  # fmt: skip
def test_bounds_that_the_line_does_not_meet_are_named(bounds, where):
    result = run(bounds)
    assert result.status is Status.INFEASIBLE
    assert where in result.stops.reason


def test_a_limit_that_holds_nowhere_is_the_reason():
    result = run({"bending": 6, "contact": BALL, "shear": 1})
    assert result.status is Status.INFEASIBLE
    assert result.stops.reason == "nowhere on the operating line: bending"
    assert result.stops.chosen.name == "nearest"


def test_limits_that_hold_apart_only_are_shown_with_their_heights():
    # the gaps leave the middle of the line, the shear its ends, where the blade hardly touches
    gaps = {"smallest-gap": "40 um", "gap": {"free": [None, "80 um"]}}
    result = run({"contact": BALL, "shear": 1, **gaps})
    assert result.status is Status.INFEASIBLE
    assert result.stops.reason == "the limits hold at different heights, at none together"
    rows = {row.name: row.ranges for row in result.stops.holds}
    assert len(rows["contact shear"]) == 2
    assert all(least <= most for ranges in rows.values() for least, most in ranges)


def test_without_a_travel_the_free_base_bears_it():
    # section 9.1.1: 27.7 MPa, 200 µm
    result = run({"travel": None, "bending": 2})
    assert result.values["travel"].value == pytest.approx(200e-6, abs=0.5e-6)


def test_the_stroke_of_every_case_stays_free_of_contact():
    assert check(run(cases=SINE | REST), "free travel").demand == 50e-6


def test_travel_without_stops_at_resonance_is_q_times_the_static_one():
    result = run()
    omega = 2 * pi * result.values["f_0"].value
    free = result.values["travel_free_resonance"].value
    assert free == pytest.approx(30 * 1.5 * 9.80665 / omega**2, rel=1e-3)
    assert MASS * omega**2 == pytest.approx(result.values["k_free"].value, rel=EXACT)


def test_a_blade_that_needs_no_stop_is_told():
    gentle = {"resonance": {"sine": {"acceleration": "0.1 g", "frequency": "176 Hz"}}}
    assert "no-stop-needed" in codes(run(cases=gentle))
    assert "no-stop-needed" not in codes(run())


def test_what_the_line_was_not_measured_for_is_said():
    shock = {"drop": {"shock": {"velocity": "0.3 m/s"}}}
    assert {"one-sided", "line-of-a-sine", "offset-left-out"} <= set(
        codes(run({"sides": "one"}, cases=shock, mechanism={"offset": "2 mm"}))
    )


def test_nothing_to_size_is_an_error():
    design = stopped().model_copy(update={"stops": None})
    with pytest.raises(SolveError, match="no stops"):
        stops(design, design.fixed_sizes(), "spec")


def test_a_line_contact_bears_more_than_a_point():
    line = {**BALL, "kind": "cylinder", "width": "7.8 mm"}
    point, along = (run({"contact": c, "height": "20 mm"}).stops.chosen for c in (BALL, line))
    assert along.p_hertz < point.p_hertz / 3
