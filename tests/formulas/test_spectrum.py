"""Spectral densities: levels, slopes, steps and cuts of profiles, and what is no profile."""

import numpy as np
import pytest
from spectra import GEVS

from flexcli.formulas.spectrum import clip_profile, segment_slopes, spectral_level
from flexcli.formulas.spectrum_integrals import rms

ROUNDING = 1e-13  # some hundred operations in double precision


def test_a_step_has_a_side_and_no_area():
    f, g = [10, 100, 100, 1000], [1.0, 1.0, 4.0, 4.0]
    assert spectral_level(100, f, g, side="left") == 1.0
    assert spectral_level(100, f, g, side="right") == 4.0
    assert spectral_level(100, f, [4.0, 4.0, 1.0, 1.0], side="upper") == 4.0
    assert rms(f, g) == pytest.approx(np.sqrt(90 + 3600), rel=ROUNDING)
    assert segment_slopes(f, g).tolist() == [0.0, np.inf, 0.0]


@pytest.mark.parametrize("scale", ["log", "linear"])
@pytest.mark.parametrize("side", ["left", "right", "upper"])
def test_breakpoints_have_their_own_level_exactly(scale, side):
    f, g = [20.0, 80.0, 500.0, 2000.0], [0.01, 0.04, 0.043, 0.011]
    assert spectral_level(f, f, g, scale=scale, side=side).tolist() == g


def test_density_is_zero_outside_the_band():
    assert spectral_level([19.999, 2000.001], *GEVS).tolist() == [0.0, 0.0]


def test_a_single_point_has_a_level_and_no_area():
    assert spectral_level([99, 100, 101], [100], [2.0]).tolist() == [0.0, 2.0, 0.0]
    assert rms([100], [2.0]) == 0.0


def test_a_cut_at_a_step_keeps_both_levels():
    f, g = clip_profile([10, 100, 100, 1000], [1, 1, 4, 4], lower=100)
    assert (f.tolist(), g.tolist()) == ([100, 100, 1000], [1, 4, 4])


@pytest.mark.parametrize(
    ("frequency", "level", "scale", "text"),
    [
        ([20, 10], [1, 1], "log", "must not fall: 20 Hz then 10 Hz"),
        ([10, 10, 10], [1, 2, 3], "log", "three times"),
        ([0, 10], [1, 1], "log", "positive"),
        ([10, 20], [0, 1], "log", "positive"),
        ([-1, 20], [0, 1], "linear", "negative"),
        ([10, 20], [1], "log", "one length"),
        ([], [], "log", "not empty"),
        ([10, np.nan], [1, 1], "log", "finite"),
        ([10, 20], [1, 1], "cubic", "scale"),
    ],
)
def test_unsound_profiles_are_refused(frequency, level, scale, text):
    with pytest.raises(ValueError, match=text):
        rms(frequency, level, scale=scale)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: clip_profile(*GEVS, lower=3000), "nothing between"),
        (lambda: spectral_level(30, *GEVS, side="middle"), "side"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
