"""Miles and the exact oscillator: published numbers, limits, and quadrature beside them."""

import doctest
import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from flexcli.formulas import random_vibration as module
from flexcli.formulas.random_vibration import (
    davenport_peak_factor,
    expected_exceedances,
    miles,
    miles_worst_case,
    oscillator_response,
    peak_factor,
    peak_probability,
    white_noise_response,
)
from flexcli.formulas.spectrum import clip_profile, rms, rms_displacement, rms_velocity

ASKED = 1e-9  # relative accuracy we promise against an independent quadrature
ROUNDING = 1e-12  # sums of a few hundred panels, twice
GEVS = ([20, 50, 800, 2000], [0.026, 0.16, 0.16, 0.026])

qualities = st.one_of(
    st.floats(np.log10(0.5), 6).map(lambda x: float(10**x)).map(lambda q: max(q, 0.5)),
    st.sampled_from([0.5, 1 / np.sqrt(2), 1.0, 100.0, 1e6]),
)


@st.composite
def profiles(draw, scale="log"):
    count = draw(st.integers(2, 5))
    ratios = draw(st.lists(st.floats(1.001, 20), min_size=count - 1, max_size=count - 1))
    levels = draw(st.lists(st.floats(1e-4, 1e2), min_size=count, max_size=count))
    frequency = draw(st.floats(1, 100)) * np.cumprod([1.0, *ratios])
    if scale == "linear" and draw(st.booleans()):
        frequency[0] = 0.0
    if draw(st.booleans()):
        at = draw(st.integers(0, count - 1))
        frequency = np.insert(frequency, at, frequency[at])
        levels.insert(at, draw(st.floats(1e-4, 1e2)))
    return frequency, np.array(levels)


@st.composite
def oscillators(draw, frequency):
    Q = draw(qualities)
    where = draw(st.sampled_from(["below", "inside", "edge", "beside an edge", "above"]))
    edge = float(draw(st.sampled_from(list(frequency[frequency > 0]))))
    low, high = float(frequency[frequency > 0][0]), float(frequency[-1])
    share = draw(st.floats(0, 1))
    fn = {
        "below": low * 10 ** (-3 * share),
        "inside": low * (high / low) ** share,
        "edge": edge,
        "beside an edge": edge * (1 + (2 * share - 1) / Q / 4),
        "above": high * 10 ** (3 * share),
    }[where]
    return fn, Q


def quadrature(frequency, level, fn, Q, scale):
    """∫ G |H_z|² df and ∫ G r² |H_z|² df in d = f/f_n − 1, by adaptive quadrature."""
    rungs = np.concatenate([[0.0], *([s * 5.0**k / Q for k in range(12)] for s in (1, -1))])
    still = moving = 0.0
    for (a, b), (ga, gb) in zip(
        itertools.pairwise(frequency), itertools.pairwise(level), strict=True
    ):
        if a == b:
            continue

        def kernel(d, a=a, b=b, ga=ga, gb=gb):
            f = fn * (1 + d)
            if scale == "log":
                g = ga * (gb / ga) ** (np.log(f / a) / np.log(b / a))
            else:
                g = ga + (gb - ga) * (f - a) / (b - a)
            return g * fn / ((d * (2 + d)) ** 2 + ((1 + d) / Q) ** 2)

        ends = (a - fn) / fn, (b - fn) / fn
        # slivers between a rung and an end would drown quad in rounding
        inner = rungs[(rungs > ends[0]) & (rungs < ends[1])]
        for end in ends:
            inner = inner[np.abs(inner - end) > 1e-3 * np.abs(inner)]
        cuts = [ends[0], *np.sort(inner), ends[1]]
        for x, y in itertools.pairwise(cuts):
            still += quad(kernel, x, y, epsrel=1e-12, epsabs=0, limit=400)[0]
            moving += quad(
                lambda d, kernel=kernel: kernel(d) * (1 + d) ** 2,
                x,
                y,
                epsrel=1e-12,
                epsabs=0,
                limit=400,
            )[0]
    return still, moving


def flat_band(a, b, fn, Q):
    """∫ |H_z|² df over a flat unit density, by partial fractions in the complex plane."""
    pole = np.sqrt(1 - 0.25 / Q**2) + 0.5j / Q
    between = np.log((b / fn - pole) / (b / fn + pole)) - np.log((a / fn - pole) / (a / fn + pole))
    return fn * (between / (2 * pole)).imag / (pole**2).imag


def test_docstring_examples_run():
    assert doctest.testmod(module).failed == 0


def test_miles_gives_the_251_g_of_the_flexure_course():
    # Exercise 9 part II: 0.2 g²/Hz at 2000 Hz, Q = 100, printed as 251 g
    assert float(miles(2000, 100, 0.2)) == pytest.approx(250.66, abs=0.005)


def test_worst_case_of_gevs_is_at_the_end_of_the_plateau():
    worst = miles_worst_case(*GEVS, 100)
    assert worst.frequency == 800
    assert worst.response == pytest.approx(np.sqrt(np.pi / 2 * 800 * 100 * 0.16), rel=ROUNDING)


@pytest.mark.parametrize("scale", ["log", "linear"])
@given(data=st.data())
@settings(deadline=None, max_examples=60)
def test_worst_case_is_the_supremum_of_a_dense_grid(scale, data):
    f, g = data.draw(profiles(scale))
    worst = miles_worst_case(f, g, 30.0, scale=scale)
    share = np.linspace(0, 1, 400)
    products = []
    for (a, b), (ga, gb) in zip(itertools.pairwise(f), itertools.pairwise(g), strict=True):
        if scale == "log":
            products.append(a * (b / a) ** share * ga * (gb / ga) ** share)
        else:
            products.append((a + (b - a) * share) * (ga + (gb - ga) * share))
    grid = float(np.sqrt(np.pi / 2 * 30.0 * np.max(products)))
    assert grid <= float(worst.response) * (1 + ROUNDING)
    assert float(worst.response) == pytest.approx(grid, rel=1e-4)  # the grid's own coarseness
    assert float(worst.response) == pytest.approx(
        float(miles(worst.frequency, 30.0, worst.level)), rel=ROUNDING
    )


def test_worst_case_takes_the_higher_side_of_a_step():
    up = miles_worst_case([10, 100, 100, 1000], [1, 1, 9, 0.1], 10)
    down = miles_worst_case([10, 100, 100, 1000], [1, 9, 0.1, 0.1], 10)
    assert (up.frequency, up.level) == (100, 9)
    assert (down.frequency, down.level) == (100, 9)


def test_worst_case_on_a_slope_of_minus_one_is_its_lowest_frequency():
    assert miles_worst_case([30, 70, 700], [1 / 30, 1 / 70, 1 / 700], 10).frequency == 30


def test_worst_case_inside_a_linear_segment_is_the_top_of_a_parabola():
    worst = miles_worst_case([0, 10], [5, 0], 2, scale="linear")
    assert worst.frequency == pytest.approx(5, rel=ROUNDING)
    assert worst.level == pytest.approx(2.5, rel=ROUNDING)


def test_worst_case_serves_several_q_and_a_range_at_once():
    worst = miles_worst_case(*GEVS, [10, 40], upper=200)
    assert worst.frequency == 200
    assert worst.response.tolist() == [miles(200, 10, 0.16), miles(200, 40, 0.16)]


@pytest.mark.parametrize("scale", ["log", "linear"])
@given(data=st.data())
@settings(deadline=None, max_examples=60)
def test_response_agrees_with_quadrature(scale, data):
    f, g = data.draw(profiles(scale))
    fn, Q = data.draw(oscillators(f))
    exact = oscillator_response(f, g, fn, Q, scale=scale)
    still, moving = quadrature(f, g, fn, Q, scale)
    omega = 2 * np.pi * fn
    # a peak 1/Q wide is moved by the rounding of f/f_n: eps·Q = 2e-10 at Q = 1e6
    assert float(exact.pseudo_acceleration) == pytest.approx(np.sqrt(still), rel=ASKED)
    assert float(exact.relative_velocity) == pytest.approx(np.sqrt(moving) / omega, rel=ASKED)
    assert float(exact.absolute_acceleration) == pytest.approx(
        np.sqrt(still + moving / Q**2), rel=ASKED
    )
    assert float(exact.relative_displacement) == pytest.approx(np.sqrt(still) / omega**2, rel=ASKED)


@pytest.mark.parametrize("Q", [0.500001, 0.7, 3.0, 100.0, 1e4, 1e6])
@pytest.mark.parametrize("fn", [1.0, 20.0, 21.0, 300.0, 2000.0, 3e4])
def test_flat_band_agrees_with_partial_fractions(Q, fn):
    # the logarithms cancel by (band/f_n)^±3 outside the band: compare at what is left
    left = 1e-12 * max(1.0, (fn / 2000) ** 3, (20 / fn) ** 3, Q * (fn > 2000) * (fn / 2000) ** 2)
    pseudo = oscillator_response([20, 2000], [1, 1], fn, Q).pseudo_acceleration
    assert float(pseudo) ** 2 == pytest.approx(flat_band(20, 2000, fn, Q), rel=max(left, ASKED))


@pytest.mark.parametrize("Q", [0.5, 1.0, 10.0, 1e3, 1e6])
def test_an_endless_flat_band_gives_the_white_noise_response(Q):
    fn = 150.0
    wide = oscillator_response([fn * 1e-14, fn * 1e14], [0.3, 0.3], fn, Q)
    limit = white_noise_response(fn, Q, 0.3)
    for name in ("absolute_acceleration", "pseudo_acceleration", "relative_displacement"):
        # the missing tail is 1e-14·4/(πQ) of the pseudo-, 1e-14·4Q/π of the rest
        assert float(getattr(wide, name)) == pytest.approx(
            float(getattr(limit, name)), rel=ROUNDING
        )
    assert float(wide.relative_velocity) == pytest.approx(
        float(limit.relative_velocity), rel=ROUNDING
    )


def test_white_noise_absolute_exceeds_miles_by_the_damper_force():
    response = white_noise_response(100, 2, 1.0)
    assert float(response.absolute_acceleration / miles(100, 2, 1.0)) == pytest.approx(
        np.sqrt(1.25), rel=ROUNDING
    )


@given(profile=profiles(), data=st.data())
@settings(deadline=None, max_examples=30)
def test_spring_and_damper_forces_add_in_quadrature(profile, data):
    fn, Q = data.draw(oscillators(profile[0]))
    r = oscillator_response(*profile, fn, Q)
    both = np.hypot(r.pseudo_acceleration, 2 * np.pi * fn * r.relative_velocity / Q)
    assert float(r.absolute_acceleration) == pytest.approx(float(both), rel=ROUNDING)


def test_a_stiff_oscillator_moves_with_its_base():
    r = oscillator_response(*GEVS, 2e7, 50)
    # |H| − 1 is about (2000/2e7)² = 1e-8
    assert float(r.absolute_acceleration) == pytest.approx(rms(*GEVS), rel=2e-8)
    assert float(r.pseudo_acceleration) == pytest.approx(rms(*GEVS), rel=2e-8)


def test_the_base_moves_under_a_soft_oscillator():
    r = oscillator_response(*GEVS, 2e-3, 50)
    assert float(r.relative_displacement) == pytest.approx(rms_displacement(*GEVS), rel=2e-8)
    assert float(r.relative_velocity) == pytest.approx(rms_velocity(*GEVS), rel=2e-8)


@given(profile=profiles(), data=st.data(), share=st.floats(0.01, 0.99))
@settings(deadline=None, max_examples=40)
def test_a_point_added_on_a_line_changes_nothing(profile, data, share):
    f, g = profile
    fn, Q = data.draw(oscillators(f))
    at = f[0] * (f[-1] / f[0]) ** share
    parts = [clip_profile(f, g, upper=at), clip_profile(f, g, lower=at)]
    halves = [float(oscillator_response(*part, fn, Q).absolute_acceleration) for part in parts]
    whole = float(oscillator_response(f, g, fn, Q).absolute_acceleration)
    assert np.hypot(*halves) == pytest.approx(whole, rel=ASKED)


@given(profile=profiles(), data=st.data(), unit=st.floats(1e-3, 1e3))
@settings(deadline=None, max_examples=30)
def test_units_of_level_and_frequency_scale_out(profile, data, unit):
    f, g = profile
    fn, Q = data.draw(oscillators(f))
    base = oscillator_response(f, g, fn, Q)
    louder = oscillator_response(f, g * unit**2, fn, Q)
    faster = oscillator_response(f * unit, g / unit, fn * unit, Q)
    for other in (louder.absolute_acceleration / unit, faster.absolute_acceleration):
        assert float(other) == pytest.approx(float(base.absolute_acceleration), rel=ASKED)


@pytest.mark.parametrize("off", [-1e-9, -1e-12, 0.0, 1e-12, 1e-9])
def test_response_is_smooth_through_slope_minus_one(off):
    base = oscillator_response([20, 2000], [1, 0.01], 100, 20).absolute_acceleration
    near = oscillator_response([20, 2000], [1, 0.01 ** (1 + off)], 100, 20).absolute_acceleration
    assert float(near / base) == pytest.approx(1 - off * np.log(5) / 2, abs=1e-9)


def test_a_band_narrow_against_the_resonance_responds_like_a_sine():
    for scale in ("log", "linear"):
        f = np.array([300.0, 300.0 * (1 + 1e-8)])
        r = oscillator_response(f, [2.0, 2.0], 250.0, 20.0, scale=scale)
        ratio = 300 / 250
        gain = 1 / np.hypot(1 - ratio**2, ratio / 20)
        sine = np.sqrt(2.0 * (f[1] - f[0])) * gain
        # the gain turns by about 10·1e-8 over the band
        assert float(r.pseudo_acceleration) == pytest.approx(sine, rel=1e-7)


def test_steep_skirts_are_resolved():
    # 400 dB/octave on both sides of a plateau, against quadrature
    f, g = np.array([90.0, 100.0, 110.0, 120.0]), np.array([1e-6, 1.0, 1.0, 1e-6])
    for fn in (95.0, 105.0, 300.0):
        still, _ = quadrature(f, g, fn, 50.0, "log")
        exact = float(oscillator_response(f, g, fn, 50.0).pseudo_acceleration)
        assert exact == pytest.approx(np.sqrt(still), rel=ASKED)


def test_response_broadcasts_over_frequency_and_q():
    fn, Q = np.geomspace(5, 5000, 300)[:, None], np.array([0.5, 10, 1e5])
    table = oscillator_response(*GEVS, fn, Q)
    assert table.absolute_acceleration.shape == (300, 3)
    one = oscillator_response(*GEVS, fn[123, 0], Q[2])
    assert one.absolute_acceleration.shape == ()
    assert float(one.absolute_acceleration) == pytest.approx(
        float(table.absolute_acceleration[123, 2]), rel=ROUNDING
    )


def test_crossing_rate_of_a_lightly_damped_oscillator_is_its_natural_frequency():
    r = oscillator_response([1, 10000], [1, 1], 200, 100)
    # the base's own share of displacement and velocity is of order 1/Q
    assert float(r.crossing_frequency) == pytest.approx(200, rel=0.01)


def test_three_sigma_is_expected_once_in_e_to_the_4_5_cycles():
    T = np.exp(4.5) / 200
    assert float(peak_factor(200, T)) == pytest.approx(3, rel=ROUNDING)
    assert float(expected_exceedances(3, 200, T)) == pytest.approx(2, rel=ROUNDING)  # both signs
    assert float(peak_probability(3, 200, T)) == pytest.approx(1 - np.exp(-2), rel=ROUNDING)


def test_davenport_factor_is_the_mean_of_the_extreme_value_density():
    # P(max < η) = exp(−N e^(−η²/2)); its mean tends to Davenport's with error O((ln N)^(-3/2))
    N = 600.0
    mean = quad(lambda x: -np.expm1(-N * np.exp(-(x**2) / 2)), 0, 20)[0]
    assert float(davenport_peak_factor(10, 60)) == pytest.approx(mean, rel=0.005)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: miles(0, 10, 1), "f must be positive"),
        (lambda: miles(1, 10, -1), "negative"),
        (lambda: oscillator_response(*GEVS, 100, 0.4), "at least 0.5"),
        (lambda: oscillator_response(*GEVS, -1, 10), "fn must be positive"),
        (lambda: oscillator_response(*GEVS, 100, np.inf), "Q must be positive and finite"),
        (lambda: miles_worst_case(*GEVS, 10, lower=4000), "nothing between"),
        (lambda: peak_factor(1, 0.5), "more than one cycle"),
        (lambda: expected_exceedances(3, 100, -1), "T must be positive"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
