from math import pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from flexcli.formulas.modal_response import harmonic_gain, response_moments, squared_gain
from flexcli.formulas.oscillator import oscillator_response

FREQUENCY = np.array([20.0, 50.0, 800.0, 800.0, 2000.0])
LEVEL = np.array([0.026, 0.16, 0.16, 0.05, 0.026])

AGREES = 1e-9
"""Relative: asked of the exact response; at Q = 1e6 the pole is known to 1e-10 of its distance."""


def one_mode(fn, Q, orders=(0.0, 2.0), scale="log", frequency=FREQUENCY, level=LEVEL):
    return response_moments(
        frequency=frequency,
        level=level,
        scale=scale,
        angular=np.array([2 * pi * fn]),
        Q=Q,
        coefficients=np.ones((1, 1)),
        residual=np.zeros(1),
        orders=orders,
    )


@settings(max_examples=60, deadline=None)
@given(fn=st.floats(1.0, 2e4), log_q=st.floats(np.log(0.5), np.log(1e6)))
def test_one_mode_is_the_single_oscillator(fn, log_q):
    Q = float(np.exp(log_q))
    m0, m2 = one_mode(fn, Q)[:, 0]
    single = oscillator_response(FREQUENCY, LEVEL, fn, Q)
    assert sqrt(m0) == pytest.approx(float(single.relative_displacement), rel=AGREES)
    assert 2 * pi * sqrt(m2) == pytest.approx(float(single.relative_velocity), rel=AGREES)


def test_linear_axes_agree_with_the_single_oscillator():
    frequency, level = np.array([10.0, 500.0]), np.array([1.0, 3.0])
    m0 = one_mode(100.0, 20.0, (0.0,), "linear", frequency, level)[0, 0]
    single = oscillator_response(frequency, level, 100.0, 20.0, scale="linear")
    assert sqrt(m0) == pytest.approx(float(single.relative_displacement), rel=AGREES)


def test_close_modes_add_with_their_correlation():
    angular, Q = 2 * pi * np.array([100.0, 103.0]), 25.0
    c, r = np.array([[1.0, -0.8]]), np.array([3e-7])
    frequency, level = np.array([20.0, 400.0]), np.array([2.0, 2.0])

    def integrand(f):
        w = 2 * pi * f
        return 2.0 * abs((c[0] / (angular**2 - w**2 + 1j * w * angular / Q)).sum() + r[0]) ** 2

    expected, _ = quad(
        integrand, 20.0, 400.0, points=[100.0, 101.5, 103.0], limit=400, epsabs=0.0, epsrel=1e-11
    )
    found = response_moments(
        frequency=frequency, level=level, scale="log", angular=angular, Q=Q,
        coefficients=c, residual=r, orders=(0.0,),
    )  # fmt: skip
    assert found[0, 0] == pytest.approx(expected, rel=AGREES)
    alone = [one_mode(fn, Q, (0.0,), "log", frequency, level)[0, 0] for fn in (100.0, 103.0)]
    apart = float(c[0] ** 2 @ alone)
    assert found[0, 0] < 0.6 * apart  # opposite signs, nearly the same frequency: they cancel


def test_a_band_below_all_modes_is_followed_without_resonance():
    fn, Q = 1e5, 10.0
    m0 = one_mode(fn, Q, (0.0,))[0, 0]
    grms = sqrt(response_moments(
        frequency=FREQUENCY, level=LEVEL, scale="log", angular=np.array([]), Q=Q,
        coefficients=np.zeros((1, 0)), residual=np.ones(1), orders=(0.0,),
    )[0, 0])  # fmt: skip
    # the next term is (f/fn)², at most 4e-4
    assert sqrt(m0) == pytest.approx(grms / (2 * pi * fn) ** 2, rel=1e-3)


def test_squares_of_gains_are_those_of_complex_amplitudes():
    rng = np.random.default_rng(2)
    how = (np.linspace(1.0, 90.0, 50), rng.uniform(50.0, 400.0, 4), rng.uniform(5.0, 90.0, 4),
           rng.normal(size=(7, 4)), rng.normal(size=7) * 1e-5)  # fmt: skip
    assert squared_gain(*how) == pytest.approx(np.abs(harmonic_gain(*how)) ** 2, rel=1e-12)
