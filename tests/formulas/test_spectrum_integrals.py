"""Moments of spectral densities: published rms values, limits, and quadrature beside them."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from spectra import GEVS, WORKMANSHIP, lines

from flexcli.formulas.spectrum import clip_profile
from flexcli.formulas.spectrum_integrals import (
    rms,
    rms_displacement,
    rms_velocity,
    spectral_moment,
)

QUADRATURE = 1e-9  # what scipy.integrate.quad is asked for, and a decade more than it gives
ROUNDING = 1e-13  # some hundred operations in double precision


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


def test_gevs_qualification_is_14_1_grms():
    assert rms(*GEVS) == pytest.approx(14.1, abs=0.05)  # GSFC-STD-7000A table 2.4-3


def test_gevs_acceptance_is_10_0_grms():
    assert rms(*clip_profile(GEVS[0], np.divide(GEVS[1], 2))) == pytest.approx(10.0, abs=0.05)


def test_nasa_workmanship_is_6_8_grms():
    assert rms(*WORKMANSHIP) == pytest.approx(6.8, abs=0.05)  # NASA-STD-7001A


@given(profile=lines(), order=st.floats(-5, 5))
@settings(deadline=None, max_examples=60)
def test_moments_agree_with_quadrature_on_log_axes(profile, order):
    assert float(spectral_moment(*profile, order)) == pytest.approx(
        quadrature(*profile, order, "log"), rel=QUADRATURE
    )


@given(profile=lines(), order=st.floats(-5, 5))
@settings(deadline=None, max_examples=60)
def test_moments_agree_with_quadrature_on_linear_axes(profile, order):
    assert float(spectral_moment(*profile, order, scale="linear")) == pytest.approx(
        quadrature(*profile, order, "linear"), rel=QUADRATURE
    )


@given(profile=lines(zero=True), order=st.floats(-0.9, 4))
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


@given(profile=lines(), cut=st.floats(0.01, 0.99))
@settings(deadline=None, max_examples=40)
def test_the_two_parts_of_a_cut_profile_add_up(profile, cut):
    f, g = profile
    at = f[0] ** (1 - cut) * f[-1] ** cut
    parts = [clip_profile(f, g, upper=at), clip_profile(f, g, lower=at)]
    total = sum(float(spectral_moment(*part, 1)) for part in parts)
    assert total == pytest.approx(float(spectral_moment(f, g, 1)), rel=1e-11)


def test_an_order_that_is_no_number_is_refused():
    with pytest.raises(ValueError, match="order"):
        spectral_moment(*GEVS, np.nan)
