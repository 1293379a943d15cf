"""What one profile holds, one scaled, the envelope of several."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from spectra import part, profiles

from flexcli.engine.asd import catalogue, describe, enveloped, scaled
from flexcli.errors import SolveError
from flexcli.formulas.spectrum import spectral_level
from flexcli.spec.load import load_shipped
from flexcli.units import STANDARD_GRAVITY as G0

ROUNDING = 1e-11  # logarithms of crossings and back


parts = profiles().map(lambda fg: part(*fg))


@given(profile=parts, db=st.floats(-30, 30))
@settings(max_examples=50)
def test_decibels_scale_the_rms_by_their_half(profile, db):
    assert scaled("mine", profile, db).grms == pytest.approx(
        profile.grms * 10 ** (db / 20), rel=ROUNDING
    )


@given(profile=parts, db=st.floats(-30, 30))
@settings(max_examples=50)
def test_decibels_back_and_forth_change_nothing(profile, db):
    again = scaled("mine", scaled("mine", profile, db), -db)
    assert again.levels == pytest.approx(profile.levels, rel=ROUNDING)


@given(first=parts, second=parts, share=st.floats(0, 1))
@settings(max_examples=60)
def test_an_envelope_is_nowhere_below_its_profiles(first, second, share):
    try:
        whole = enveloped({"a": first, "b": second})
    except SolveError:
        assert first.frequencies[-1] < second.frequencies[0] or (
            second.frequencies[-1] < first.frequencies[0]
        )
        return
    assert whole.grms >= max(first.grms, second.grms) * (1 - ROUNDING)
    for each in (first, second):
        f = each.frequencies
        at = min(max(f[0] * (f[-1] / f[0]) ** share, f[0]), f[-1])
        level = spectral_level(at, f, each.levels, side="upper")
        over = spectral_level(at, whole.frequencies, whole.levels, side="upper")
        assert float(over) >= float(level) * (1 - ROUNDING)


def test_an_envelope_marks_its_steps():
    low = part([10, 1000], [0.01, 0.01])
    whole = enveloped({"low": low, "high": part([100, 200], [1, 1])})
    assert whole.frequencies.tolist() == [10, 100, 100, 200, 200, 1000]
    assert [point.step for point in whole.points] == [False, False, True, False, True, False]


def test_an_envelope_keeps_the_longest_duration_and_a_common_axis():
    a = part([10, 100], [1, 1], duration="60 s", axis="x")
    b = part([10, 100], [2, 2], duration="2 min", axis="x")
    assert enveloped({"a": a, "b": b}).duration == 120
    assert enveloped({"a": a, "b": b}).axis == "x"
    assert enveloped({"a": a, "b": part([10, 100], [2, 2], axis="y")}).axis == ""


def test_different_axes_of_straight_lines_have_no_envelope():
    with pytest.raises(SolveError, match="no common straight lines"):
        enveloped({
            "a": part([10, 100], [1, 1]), "b": part([10, 100], [1, 2], interpolation="linear"),
        })  # fmt: skip


def test_decibels_out_of_this_world_are_refused():
    with pytest.raises(SolveError, match="physical"):
        scaled("mine", part([10, 100], [1e-27, 1e-27]), -100)


def test_a_profile_is_described_by_its_slopes_and_moments():
    result = describe("asd show", "gevs", load_shipped("asd", "gevs-qualification"))
    assert [row.slope for row in result.breakpoints][1:3] == pytest.approx([0, -5.97], abs=0.01)
    assert result.breakpoints[-1].slope is None
    assert result.values["g_rms"].value / G0 == pytest.approx(14.1, abs=0.05)  # GSFC-STD-7000
    assert result.values["m_0"].value == pytest.approx(result.values["g_rms"].value ** 2)
    rate = np.sqrt(result.values["m_2"].value / result.values["m_0"].value)
    assert result.values["f_zero"].value == pytest.approx(rate)


def test_a_step_has_an_infinite_slope_and_linear_lines_have_none():
    step = describe("asd show", "s", part([10, 20, 20, 40], [1, 1, 2, 2]))
    assert step.breakpoints[1].slope == np.inf
    line = describe("asd show", "s", part([10, 20], [1, 2], interpolation="linear"))
    assert [row.slope for row in line.breakpoints] == [None, None]


@pytest.mark.parametrize(("published", "codes"), [("10 g", []), ("9.85 g", ["grms-differs"])])
def test_a_published_rms_that_is_another_is_told(published, codes):
    profile = part([100, 1100], [0.1, 0.1], published_grms=published)
    assert [n.code for n in catalogue("asd grms", {"mine": profile}).warnings] == codes
