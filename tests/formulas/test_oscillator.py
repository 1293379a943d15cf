"""The exact oscillator: limits, partial fractions, and quadrature beside it."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from spectra import GEVS, oscillators, profiles, white_noise

from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.spectrum import clip_profile
from flexcli.formulas.spectrum_integrals import rms, rms_displacement, rms_velocity

ASKED = 1e-9  # relative accuracy we promise against an independent quadrature
ROUNDING = 1e-12  # sums of a few hundred panels, twice


def quadrature(frequency, level, fn, Q, scale):
    """∫ G |H_z|² df and ∫ G r² |H_z|² df by adaptive quadrature.

    In d = f/f_n − 1 beside the resonance; far from it in the distance from the segment's start,
    because what d loses to rounding a narrow, steep segment would multiply.
    """
    models = np.concatenate([[0.0], *([s * 5.0**k / Q for k in range(12)] for s in (1, -1))])
    still = moving = 0.0
    for (a, b), (ga, gb) in zip(
        itertools.pairwise(frequency), itertools.pairwise(level), strict=True
    ):
        if a == b:
            continue
        first, width = (a - fn) / fn, (b - a) / fn
        far = first > 0.5 or first + width < -0.5
        origin = first if far else 0.0
        begin = first - origin

        def kernel(x, a=a, b=b, ga=ga, gb=gb, origin=origin, begin=begin):
            d, along = origin + x, fn * (x - begin)
            if scale == "log":
                g = ga * (gb / ga) ** (np.log1p(along / a) / np.log1p((b - a) / a))
            else:
                g = ga + (gb - ga) * along / (b - a)
            return g * fn / ((d * (2 + d)) ** 2 + ((1 + d) / Q) ** 2)

        # slivers between a rung and an end would drown quad in rounding
        ends = begin, begin + width
        inner = models - origin
        inner = inner[(inner > ends[0]) & (inner < ends[1])]
        for end in ends:
            inner = inner[np.abs(inner - end) > 1e-3 * np.abs(inner + origin)]
        cuts = [ends[0], *np.sort(inner), ends[1]]
        for x, y in itertools.pairwise(cuts):
            still += quad(kernel, x, y, epsrel=1e-12, epsabs=0, limit=400)[0]
            moving += quad(
                lambda x, kernel=kernel, origin=origin: kernel(x) * (1 + origin + x) ** 2,
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


@pytest.mark.parametrize("scale", ["log", "linear"])
@given(data=st.data())
@settings(deadline=None, max_examples=60)
def test_response_agrees_with_quadrature(scale, data):
    f, g = data.draw(profiles(scale))
    assert_response_of_quadrature(f, g, *data.draw(oscillators(f)), scale)


@pytest.mark.parametrize("rise", [1e6, 1e-6])
def test_response_agrees_with_quadrature_on_a_cliff_far_below(rise):
    # a thousandth of an octave or so, a thousand times below the resonance
    assert_response_of_quadrature([17.488, 17.505], [1e-4, 1e-4 * rise], 17506.2, 1.0, "log")


def assert_response_of_quadrature(f, g, fn, Q, scale):
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
    limit = white_noise(fn, Q, 0.3)
    for name, expected in limit.items():
        # the missing tail is 1e-14·4/(πQ) of the pseudo-, 1e-14·4Q/π of the rest
        assert float(getattr(wide, name)) == pytest.approx(expected, rel=ROUNDING)


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


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: oscillator_response(*GEVS, 100, 0.4), "at least 0.5"),
        (lambda: oscillator_response(*GEVS, -1, 10), "fn must be positive"),
        (lambda: oscillator_response(*GEVS, 100, np.inf), "Q must be positive and finite"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
