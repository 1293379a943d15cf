"""Spectral densities: published profiles, limits, and quadrature as the independent route."""

import doctest
import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from flexcli.formulas import spectrum as module
from flexcli.formulas.spectrum import (
    clip_profile,
    db_per_octave_from_slope,
    envelope,
    levels_from_slopes,
    rms,
    rms_displacement,
    rms_velocity,
    scale_level,
    segment_slopes,
    slope_from_db_per_octave,
    spectral_level,
    spectral_moment,
)

QUADRATURE = 1e-9  # what scipy.integrate.quad is asked for, and a decade more than it gives
ROUNDING = 1e-13  # some hundred operations in double precision

GEVS = ([20, 50, 800, 2000], [0.026, 0.16, 0.16, 0.026])
WORKMANSHIP = ([20, 80, 500, 2000], [0.01, 0.04, 0.04, 0.01])


@st.composite
def profiles(draw, zero=False):
    count = draw(st.integers(2, 6))
    ratios = draw(st.lists(st.floats(1.0001, 30), min_size=count - 1, max_size=count - 1))
    levels = draw(st.lists(st.floats(1e-5, 1e2), min_size=count, max_size=count))
    start = draw(st.floats(0.1, 100))
    frequency = start * np.cumprod([1.0, *ratios])
    if zero:
        frequency, levels = frequency - start, [0.0, *levels[1:]]
    return frequency, np.array(levels)


def quadrature(frequency, level, order, scale):
    total = 0.0
    for (a, b), (ga, gb) in zip(
        itertools.pairwise(frequency), itertools.pairwise(level), strict=True
    ):
        if b == a:
            continue
        if scale == "log":
            # in ln f the integrand is one exponential, which quad takes without trouble
            slope = np.log(gb / ga) / np.log(b / a)
            total += quad(
                lambda u, a=a, ga=ga, slope=slope: (
                    ga * a ** (order + 1) * np.exp((slope + order + 1) * u)
                ),
                0,
                np.log(b / a),
                epsrel=1e-11,
                epsabs=0,
            )[0]
        else:
            total += quad(
                lambda f, a=a, b=b, ga=ga, gb=gb: f**order * (ga + (gb - ga) * (f - a) / (b - a)),
                a,
                b,
                epsrel=1e-11,
                epsabs=0,
            )[0]
    return total


def test_docstring_examples_run():
    assert doctest.testmod(module).failed == 0


def test_gevs_qualification_is_14_1_grms():
    assert rms(*GEVS) == pytest.approx(14.1, abs=0.05)  # GSFC-STD-7000A table 2.4-3


def test_gevs_acceptance_is_10_0_grms():
    assert rms(*clip_profile(GEVS[0], np.divide(GEVS[1], 2))) == pytest.approx(10.0, abs=0.05)


def test_nasa_workmanship_is_6_8_grms():
    assert rms(*WORKMANSHIP) == pytest.approx(6.8, abs=0.05)  # NASA-STD-7001A


def test_gevs_levels_follow_from_its_slopes():
    levels = levels_from_slopes(GEVS[0], [6, 0, -6], known_index=2, known_level=0.16)
    np.testing.assert_allclose(levels, GEVS[1], rtol=0, atol=0.0005)


def test_workmanship_slopes_are_3_db_per_octave():
    db = db_per_octave_from_slope(segment_slopes(*WORKMANSHIP))
    np.testing.assert_allclose(db, [3.01, 0, -3.01], atol=0.001)


def test_one_octave_at_m_db_per_octave_changes_the_level_by_m_db():
    low, high = levels_from_slopes([10, 20], [4.5], known_index=0, known_level=2.0)
    assert high == pytest.approx(float(scale_level(low, 4.5)), rel=ROUNDING)


def test_slope_conversions_are_inverse():
    assert float(db_per_octave_from_slope(slope_from_db_per_octave(7.3))) == pytest.approx(7.3)


def test_three_db_is_a_factor_ten_to_the_0_3():
    assert float(scale_level(1.0, 3)) == 10**0.3
    assert rms(GEVS[0], scale_level(GEVS[1], 6)) == pytest.approx(
        rms(*GEVS) * 10**0.3, rel=ROUNDING
    )


@given(profile=profiles(), order=st.floats(-5, 5))
@settings(deadline=None, max_examples=60)
def test_moments_agree_with_quadrature_on_log_axes(profile, order):
    assert float(spectral_moment(*profile, order)) == pytest.approx(
        quadrature(*profile, order, "log"), rel=QUADRATURE
    )


@given(profile=profiles(), order=st.floats(-5, 5))
@settings(deadline=None, max_examples=60)
def test_moments_agree_with_quadrature_on_linear_axes(profile, order):
    assert float(spectral_moment(*profile, order, scale="linear")) == pytest.approx(
        quadrature(*profile, order, "linear"), rel=QUADRATURE
    )


@given(profile=profiles(zero=True), order=st.floats(-0.9, 4))
@settings(deadline=None, max_examples=40)
def test_linear_profiles_may_start_at_zero_hertz(profile, order):
    assert float(spectral_moment(*profile, order, scale="linear")) == pytest.approx(
        quadrature(*profile, order, "linear"), rel=QUADRATURE
    )


def test_a_diverging_moment_is_infinite():
    assert spectral_moment([0, 1], [1, 1], -1, scale="linear") == np.inf
    assert spectral_moment([0, 1], [1, 0], -3, scale="linear") == np.inf
    assert spectral_moment([0, 1], [0, 1], -1, scale="linear") == pytest.approx(1.0)


@pytest.mark.parametrize("off", [0.0, 1e-15, 1e-12, 1e-9, -1e-9, -1e-12, 1e-6, -1e-6])
def test_moments_are_smooth_through_slope_minus_one(off):
    # m0 of f^(−1 + off) over [1, e]: (e^off − 1)/off = 1 + off/2 + off²/6
    exact = 1 + off / 2 + off**2 / 6
    moment = spectral_moment([1, np.e], [1, np.exp(-1 + off)])
    assert float(moment) == pytest.approx(exact, rel=ROUNDING)


@pytest.mark.parametrize("order", [0.0, -2.0, -4.0, 2.0])
def test_moments_are_smooth_through_the_logarithm_of_every_order(order):
    values = [
        float(spectral_moment([10, 1000], [1.0, 100.0 ** (-(order + 1) + off)], order))
        for off in (-1e-9, 0.0, 1e-9)
    ]
    # relative derivative by the slope is ln(100)/2 at the centre
    assert np.diff(values) / values[1] == pytest.approx(1e-9 * np.log(100) / 2, rel=1e-5)


def test_order_of_moments_broadcasts():
    orders = np.array([[0, -2], [2, 4]])
    together = spectral_moment(*GEVS, orders)
    assert together.shape == (2, 2)
    assert together[1, 0] == spectral_moment(*GEVS, 2)


def test_velocity_and_displacement_of_a_flat_density():
    a, b, level = 20.0, 2000.0, 3.0
    assert rms_velocity([a, b], [level, level]) == pytest.approx(
        np.sqrt(level * (1 / a - 1 / b)) / (2 * np.pi), rel=ROUNDING
    )
    assert rms_displacement([a, b], [level, level]) == pytest.approx(
        np.sqrt(level * (a**-3 - b**-3) / 3) / (2 * np.pi) ** 2, rel=ROUNDING
    )


def test_narrow_segments_keep_their_digits():
    # a width of 1e-9 of the frequency: level times width, whatever the axes
    f = np.array([1000.0, 1000.0 * (1 + 1e-9)])
    for scale in ("log", "linear"):
        assert float(spectral_moment(f, [2.0, 2.0], 0, scale=scale)) == pytest.approx(
            2 * (f[1] - f[0]), rel=ROUNDING
        )


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


@given(profile=profiles(), cut=st.floats(0.01, 0.99))
@settings(deadline=None, max_examples=40)
def test_the_two_parts_of_a_cut_profile_add_up(profile, cut):
    f, g = profile
    at = f[0] ** (1 - cut) * f[-1] ** cut
    parts = [clip_profile(f, g, upper=at), clip_profile(f, g, lower=at)]
    total = sum(float(spectral_moment(*part, 1)) for part in parts)
    assert total == pytest.approx(float(spectral_moment(f, g, 1)), rel=1e-11)


def test_a_cut_at_a_step_keeps_both_levels():
    f, g = clip_profile([10, 100, 100, 1000], [1, 1, 4, 4], lower=100)
    assert (f.tolist(), g.tolist()) == ([100, 100, 1000], [1, 4, 4])


@pytest.mark.parametrize("scale", ["log", "linear"])
@given(first=profiles(), second=profiles(), third=profiles())
@settings(deadline=None, max_examples=40)
def test_envelope_is_the_greatest_of_its_profiles(scale, first, second, third):
    wide = (np.array([1e-2, 1e12]), np.array([1e-6, 1e-6]))  # so that no gap opens
    some = [first, second, third, wide]
    f, g = envelope(some, scale=scale)
    asked = np.unique(np.concatenate([f, f[:-1] + 0.37 * np.diff(f)]))
    for side in ("left", "right"):
        highest = np.max(
            [spectral_level(asked, *profile, scale=scale, side=side) for profile in some], axis=0
        )
        found = spectral_level(asked, f, g, scale=scale, side=side)
        # at a profile's outer edge the edge belongs to it, from either side
        outer = np.isin(asked, [x for profile in some for x in (profile[0][0], profile[0][-1])])
        # a crossing is right to 1e-16 of its frequency, on a line that may fall over 1e-4 of it
        np.testing.assert_allclose(
            found[~outer], highest[~outer], rtol=1e-9, atol=1e-11 * highest.max()
        )


def test_envelope_finds_the_crossing_exactly():
    f, g = envelope([([10, 1000], [1, 1]), ([10, 1000], [0.01, 100])])
    np.testing.assert_allclose(f, [10, 100, 1000], rtol=ROUNDING)
    np.testing.assert_allclose(g, [1, 1, 100], rtol=ROUNDING)


def test_envelope_of_one_profile_is_itself_with_its_steps():
    f, g = envelope([([10, 100, 100, 1000], [1, 1, 4, 4])])
    assert (f.tolist(), g.tolist()) == ([10, 100, 100, 1000], [1, 1, 4, 4])


def test_envelope_with_a_gap_is_refused_on_log_axes_and_zero_on_linear_ones():
    bands = [([10, 20], [1, 1]), ([30, 40], [1, 1])]
    with pytest.raises(ValueError, match="covers 20 to 30 Hz"):
        envelope(bands)
    f, g = envelope(bands, scale="linear")
    assert (f.tolist(), g.tolist()) == ([10, 20, 20, 30, 30, 40], [1, 1, 0, 0, 1, 1])


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
        (lambda: spectral_moment(*GEVS, np.nan), "order"),
        (lambda: envelope([]), "at least one"),
        (lambda: levels_from_slopes([1, 2], [3, 3], known_index=0, known_level=1), "segments"),
        (lambda: levels_from_slopes([2, 1], [3], known_index=0, known_level=1), "increasing"),
        (lambda: levels_from_slopes([1, 2], [np.inf], known_index=0, known_level=1), "finite"),
        (lambda: levels_from_slopes([1, 2], [3], known_index=2, known_level=1), "known_index"),
        (lambda: levels_from_slopes([1, 2], [3], known_index=0, known_level=0), "positive"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
