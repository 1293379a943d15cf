"""The worst case over all frequencies: the course's number, units, several Q, warnings."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from judging import size_as_printed
from spectra import part, profiles

from flexcli.engine.asd_worst_case import environments, exposed, worst_case
from flexcli.errors import SolveError
from flexcli.formulas.miles import miles
from flexcli.formulas.spectrum import spectral_level
from flexcli.parts.asd import ASDProfile
from flexcli.spec.load import load, load_shipped
from flexcli.units import STANDARD_GRAVITY as G0

EXAMPLE = Path(__file__).parents[2] / "examples" / "rocket-parallel-stage" / "flexure.yaml"
ROUNDING = 1e-12  # a handful of operations
EXACT = 1e-8  # what the greatest response is good for


def flat(unit="g^2/Hz", level=0.2, **more):
    ends = [{"frequency": f"{f} Hz", "level": f"{level!r} {unit}"} for f in (20, 2000)]
    return ASDProfile.model_validate({"points": ends, **more})


def judged(profile, *qualities, duration=None):
    return worst_case(exposed("mine", profile, qualities, duration), "mine.yaml")


def codes(result):
    return [note.code for note in result.warnings]


def test_exercise_9_gives_251_g_at_2000_hz():
    # exercise 9, part II: printed 251 g
    result = judged(load_shipped("asd", "exercise-9-rocket"), 100)
    assert result.values["g_rms_worst"].value / G0 == pytest.approx(251, abs=0.5)
    assert result.values["f_worst"].value == 2000


def test_the_design_gives_what_its_sizing_uses():
    design = load(EXAMPLE).part
    found = worst_case(environments(design), str(EXAMPLE)).values
    used = size_as_printed(design, str(EXAMPLE)).values
    for name in ("g_rms_worst", "f_worst"):
        assert found[name].value == pytest.approx(used[name].value, rel=ROUNDING)


@given(profile=profiles(), share=st.floats(0, 1), q=st.floats(0.5, 1e4))
@settings(max_examples=25)
def test_miles_worst_case_is_miles_nowhere_exceeded(profile, share, q):
    found = part(*profile)
    f = found.frequencies
    (row,) = judged(found, q).worst_cases
    at = min(max(f[0] * (f[-1] / f[0]) ** share, f[0]), f[-1])
    here = miles(at, q, spectral_level(at, f, found.levels, side="upper"))
    assert row.g_rms_worst >= float(here) * (1 - 1e-11)
    assert row.g_rms_max >= row.g_rms_exact * (1 - EXACT)
    assert row.g_rms_exact >= row.g_rms_pseudo


def test_the_unit_of_the_level_does_not_matter():
    (g,) = judged(flat(), 100).worst_cases
    (si,) = judged(flat("(m/s^2)^2/Hz", 0.2 * G0**2), 100).worst_cases
    for name in ("f_worst", "g_rms_worst", "g_rms_exact", "g_rms_max", "miles_excess"):
        assert getattr(g, name) == pytest.approx(getattr(si, name), rel=1e-9)


def test_the_greatest_of_several_q_leads():
    result = judged(flat(), 10, 50, 5)
    assert [row.q for row in result.worst_cases] == [10, 50, 5]
    assert result.values["g_rms_worst"].value == result.worst_cases[1].g_rms_worst


def test_miles_is_unsafe_on_a_slope_of_minus_three_decibels():
    # f G is constant there, so Miles is the same at every f; lower frequencies add to the exact
    result = judged(load_shipped("asd", "nasa-std-7001-workmanship"), 10)
    assert {"miles-unsafe", "worst-case-unsafe"} <= set(codes(result))
    (row,) = result.worst_cases
    assert row.shortfall == pytest.approx(1 - 1 / (row.g_rms_max / row.g_rms_worst), rel=1e-6)


def test_a_flat_band_ends_where_miles_counts_twice():
    # at the end of the band half of the resonance is cut off
    (row,) = judged(flat(), 1e4).worst_cases
    assert row.miles_excess_there == pytest.approx(2**0.5 - 1, rel=1e-3)
    assert row.shortfall < 1e-3


@pytest.mark.parametrize(
    ("duration", "expected"),
    [(None, "no-duration"), (60.0, "sigma-exceeded"), (0.004, "few-cycles"), (1e-4, "few-cycles")],
)
def test_the_duration_decides_on_the_sigma(duration, expected):
    result = judged(flat(), 100, duration=duration)
    assert expected in codes(result)


def test_three_sigma_holds_for_ninety_cycles():
    assert "sigma-exceeded" not in codes(judged(flat(), 100, duration=85 / 2000))
    assert "sigma-exceeded" in codes(judged(flat(), 100, duration=95 / 2000))


def test_levels_that_are_not_verified_are_told():
    assert "levels-not-verified" in codes(judged(flat(status="reconstructed"), 10))
    assert "levels-not-verified" not in codes(judged(flat(), 10))


def test_a_tolerance_that_is_not_applied_is_told():
    tolerant = flat(tolerance={"above": "3 dB", "below": "1.5 dB"})
    assert "tolerance-not-applied" in codes(judged(tolerant, 10))


def test_an_overdamped_oscillator_is_refused():
    with pytest.raises(SolveError, match="critical damping"):
        judged(flat(), 0.4)


def test_a_step_counts_with_its_higher_side():
    points = [
        {"frequency": "20 Hz", "level": "0.1 g^2/Hz"},
        {"frequency": "500 Hz", "level": "0.1 g^2/Hz"},
        {"frequency": "500 Hz", "level": "0.01 g^2/Hz", "step": True},
        {"frequency": "2000 Hz", "level": "0.01 g^2/Hz"},
    ]
    (row,) = judged(ASDProfile.model_validate({"points": points}), 30).worst_cases
    assert row.f_worst == 500
    assert row.g_rms_worst / G0 == pytest.approx(float(miles(500, 30, 0.1)), rel=ROUNDING)
