"""The greatest exact response and Miles' shortfall: dense scans, limits, steps, units."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar
from spectra import GEVS, profiles

from flexcli.formulas.miles import miles, miles_worst_case
from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.response_spectrum import (
    ResponseSpectrum,
    peak_ratio,
)
from flexcli.formulas.spectrum import spectral_level

PROMISED = 1e-8  # what the value is good for
STEP = ([20, 100, 100, 2000], [0.01, 0.01, 0.16, 0.16])


def spectrum(f, g, Q, scale="log"):
    return ResponseSpectrum(np.asarray(f, float), np.asarray(g, float), Q, scale)


@pytest.mark.parametrize("Q", [0.5, 5.0, 100.0, 1e4])
@pytest.mark.parametrize("profile", [GEVS, STEP, ([20, 2000], [0.04, 0.0004])])
def test_the_maximum_agrees_with_a_scalar_minimiser(profile, Q):
    most = spectrum(*profile, Q).maximum()

    def response(fn):
        return float(oscillator_response(*profile, fn, Q).absolute_acceleration)

    reach = 0.3 / Q
    low = max(most.frequency * (1 - reach), profile[0][0])
    high = most.frequency * (1 + reach)
    other = minimize_scalar(
        lambda fn: -response(fn), bounds=(low, high), method="bounded", options={"xatol": 1e-7}
    )
    assert most.response == pytest.approx(response(most.frequency), rel=PROMISED)
    assert most.response >= -other.fun * (1 - PROMISED)


@given(profile=profiles(), Q=st.sampled_from([0.5, 3.0, 30.0, 1000.0]), data=st.data())
@settings(max_examples=40)
def test_no_natural_frequency_responds_more(profile, Q, data):
    f, g = profile
    most = spectrum(f, g, Q).maximum()
    near = f[data.draw(st.integers(0, f.size - 1))]
    scan = np.concatenate([
        f[0] * (f[-1] / f[0]) ** np.linspace(0, 1, 60),
        near * (1 + np.linspace(-3, 3, 61) / Q),
        f[0] * np.geomspace(0.1, 1, 10),
        f[-1] * np.geomspace(1, 10, 30),
    ])  # fmt: skip
    scan = scan[scan > 0]
    responses = oscillator_response(f, g, scan, Q).absolute_acceleration
    assert responses.max() <= most.response * (1 + PROMISED)


@given(profile=profiles(), Q=st.sampled_from([0.5, 3.0, 30.0, 1000.0]))
@settings(max_examples=40)
def test_no_natural_frequency_of_the_band_exceeds_miles_more(profile, Q):
    f, g = profile
    low = spectrum(f, g, Q).shortfall()
    scan = f[0] * (f[-1] / f[0]) ** np.linspace(0, 1, 120)
    scan = scan[(scan >= f[0]) & (scan <= f[-1])]
    exact = oscillator_response(f, g, scan, Q).absolute_acceleration
    for side in ("left", "right"):
        ratio = exact / miles(scan, Q, spectral_level(scan, f, g, side=side))
        inside = (scan > f[0]) & (scan < f[-1])
        assert (ratio[inside] - 1).max() <= low.excess + PROMISED * (1 + low.excess)


def test_below_a_step_miles_misses_half_of_the_resonance_above():
    # at the step of a lightly damped oscillator half the resonance sees either level
    low = spectrum(*STEP, 1e5).shortfall()
    assert low.frequency == pytest.approx(100, rel=1e-4)
    assert (1 + low.excess) ** 2 == pytest.approx((0.01 + 0.16) / 2 / 0.01, rel=1e-3)


@pytest.mark.parametrize("Q", [100.0, 1e3, 1e4])
def test_the_maximum_tends_to_miles_worst_case_as_q_grows(Q):
    most, worst = spectrum(*GEVS, Q).maximum(), miles_worst_case(*GEVS, Q)
    # the resonance is some 1/Q wide, and the level falls on one side of it only
    assert most.response == pytest.approx(float(worst.response), rel=3 / Q)
    assert most.frequency == pytest.approx(worst.frequency, rel=1 / Q)


@pytest.mark.slow
@given(profile=profiles(), unit=st.floats(1e-3, 1e3))
@settings(max_examples=20)
def test_units_scale_out(profile, unit):
    f, g = profile
    base, louder = spectrum(f, g, 20.0).maximum(), spectrum(f, g * unit**2, 20.0).maximum()
    assert louder.response == pytest.approx(unit * base.response, rel=PROMISED)
    assert spectrum(f, g * unit**2, 20.0).shortfall().excess == pytest.approx(
        spectrum(f, g, 20.0).shortfall().excess, abs=PROMISED * 10
    )


def test_linear_lines_serve_too():
    f, g = [20.0, 1000.0, 2000.0], [0.1, 1.0, 0.1]
    most = spectrum(f, g, 50.0, scale="linear").maximum()
    scan = np.linspace(20, 2000, 4000)
    dense = oscillator_response(f, g, scan, 50.0, scale="linear").absolute_acceleration
    assert dense.max() <= most.response * (1 + PROMISED)
    assert most.response == pytest.approx(dense.max(), rel=1e-5)  # the scan's own coarseness


def test_an_overdamped_oscillator_is_refused():
    with pytest.raises(ValueError, match=r"at least 0\.5"):
        spectrum(*GEVS, 0.4).maximum()


def jagged(count, seed, low=20.0, high=2000.0):
    """Give a profile of a measured kind: many narrow lines, with a step."""
    generator = np.random.default_rng(seed)
    inner = np.sort(low * (high / low) ** generator.random(count - 3))
    f = np.concatenate([[low], inner, [inner[count // 2]], [high]])
    return np.sort(f), 10 ** generator.uniform(-4, 1, count)


@pytest.mark.slow
@pytest.mark.parametrize("scale", ["log", "linear"])
@given(
    count=st.sampled_from([20, 150, 600]),
    seed=st.integers(0, 999),
    Q=st.floats(-0.3, 5).map(lambda x: float(10**x)),
    top=st.floats(25.0, 1e6),
)
@settings(max_examples=25)
def test_all_at_once_is_the_sum_of_every_segment(scale, count, seed, Q, top):
    f, g = jagged(count, seed, high=top)
    spectrum = ResponseSpectrum(f, g, Q, scale)
    generator = np.random.default_rng(seed)
    fn = np.concatenate([
        generator.choice(f, 8),
        generator.choice(f, 8) * (1 + generator.uniform(-2, 2, 8) / Q),
        f[0] * (spectrum.top / f[0]) ** generator.random(8),
        [f[0], f[-1], spectrum.top],
    ])  # fmt: skip
    fn = np.clip(fn, f[0], spectrum.top)
    direct = oscillator_response(f, g, fn, Q, scale=scale).absolute_acceleration
    assert spectrum(fn) == pytest.approx(direct, rel=1e-10)


def test_a_cliff_is_no_obstacle_for_panels():
    # a thousand lines, of which one falls by 300 dB within 1e-4 of its frequency
    f, g = jagged(1000, 3)
    at = 400
    f = np.insert(f, at + 1, f[at] * (1 + 1e-9))
    g = np.insert(g, at + 1, g[at] * 1e-30)
    for Q in (2.0, 100.0):
        fn = np.array([f[0], f[at], f[at] * (1 + 1 / Q), f[-1]])
        direct = oscillator_response(f, g, fn, Q).absolute_acceleration
        assert ResponseSpectrum(f, g, Q)(fn) == pytest.approx(direct, rel=1e-10)


@pytest.mark.parametrize("Q", [1.0, 30.0, 1000.0])
def test_a_flat_profile_of_many_points_is_that_of_two(Q):
    f = np.geomspace(20, 2000, 1500)
    many, two = (
        ResponseSpectrum(f, np.full(1500, 0.3), Q),
        spectrum([20, 2000], [0.3] * 2, Q).maximum(),
    )
    assert many.maximum().response == pytest.approx(two.response, rel=1e-9)
    fn = np.geomspace(30, 1500, 7)
    direct = oscillator_response([20, 2000], [0.3, 0.3], fn, Q).absolute_acceleration
    assert many(fn) == pytest.approx(direct, rel=1e-10)


@pytest.mark.parametrize("Q", [0.5, 0.7, 2.0, 10.0, 1e3])
def test_a_line_at_one_frequency_is_felt_most_above_it(Q):
    # |H_a|² at r² = Q² (√(1 + 2/Q²) − 1) is a maximum: r_p lies below 1
    ratio = peak_ratio(Q)
    most = spectrum([100.0, 100.0 * (1 + 1e-6)], [1.0, 1.0], Q).maximum()
    assert most.frequency * ratio == pytest.approx(100.0, rel=1e-4 if Q < 100 else 1e-5)

    def gain(r):
        return np.sqrt((1 + (r / Q) ** 2) / ((1 - r * r) ** 2 + (r / Q) ** 2))

    assert most.response == pytest.approx(np.sqrt(1e-4) * gain(ratio), rel=1e-6)
    assert gain(ratio) >= max(gain(ratio * (1 + 1e-4)), gain(ratio * (1 - 1e-4)))


def test_an_overdamped_oscillator_is_felt_most_beyond_the_band():
    most = spectrum([500, 2000], [0.01, 1.0], 0.5).maximum()
    assert most.frequency > 2000
    beyond = oscillator_response([500, 2000], [0.01, 1.0], [2000, most.frequency, 1e5], 0.5)
    at_edge, there, far = beyond.absolute_acceleration
    assert there > max(at_edge, far)


def test_a_maximum_between_two_points_as_high_is_found():
    """The coarse grid of 1 to 2.39 Hz has one just beyond it, and the next far before."""
    f, g = np.array([1.0, 2.390625]), np.array([2.390625, 46.25])
    scan = np.linspace(1.26, 1.27, 1001)
    exact = oscillator_response(f, g, scan, 30.0).absolute_acceleration
    ratio = exact / miles(scan, 30.0, spectral_level(scan, f, g, side="left"))
    assert spectrum(f, g, 30.0).shortfall().excess == pytest.approx(ratio.max() - 1.0, abs=1e-9)
