"""Half-sine pulse: the response against integration in time, and their limits."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from flexcli.formulas.shock import half_sine_sums, velocity_shock_acceleration

SAMPLED = 1e-7  # a maximum read off 20,000 samples of an integration to 1e-12
ROUNDING = 1e-12
LIGHT = 1e7  # quality factor of next to no damping


def half_sine(fn, Q, A, tau):
    """Greatest ω² |z| of oscillators, each alone."""
    alone = [np.ones((1, 1, 1))]
    return np.array([half_sine_sums(alone, [f], Q, A, tau)[0] for f in np.atleast_1d(fn)])


def integrated_maximum(s, Q):
    """Greatest ω² |z| during and after a pulse of 1 m/s² and 1 s, by time integration."""
    w = 2 * np.pi * s

    def motion(t, y):
        base = np.sin(np.pi * t) if t < 1 else 0.0
        return [y[1], -w / Q * y[1] - w**2 * y[0] - base]

    greatest, state = [], [0.0, 0.0]
    for begin, end in ((0.0, 1.0), (1.0, 1.0 + 1.2 / s)):
        path = solve_ivp(
            motion,
            (begin, end),
            state,
            method="DOP853",
            rtol=1e-12,
            atol=1e-14 / w**2,
            max_step=0.1 / max(s, 1 / s),
            t_eval=np.linspace(begin, end, 20001),
        )
        greatest.append(w**2 * np.abs(path.y[0]).max())
        state = path.y[:, -1]
    return max(greatest)


@pytest.mark.slow
@pytest.mark.parametrize("Q", [0.5, 0.8, 10.0, 1e3])
@pytest.mark.parametrize("s", [0.1, 0.5, 3.3])
def test_damped_maxima_agree_with_time_integration(s, Q):
    assert half_sine(s, Q, 1.0, 1.0) == pytest.approx(integrated_maximum(s, Q), rel=SAMPLED)


def test_half_sine_amplifies_by_at_most_1_77():
    # Harris' Shock and Vibration Handbook, chapter 8: undamped half-sine maximum 1.77
    maximax = half_sine(np.linspace(0.7, 0.9, 101), LIGHT, 1.0, 1.0)
    assert maximax.max() == pytest.approx(1.77, abs=0.005)


def test_pulse_in_tune_gives_half_pi_in_both_eras_without_a_jump():
    s = 0.5 + np.array([-1e-9, -1e-15, 0.0, 1e-15, 1e-9])
    # slope in s is of order 1, damping takes about π/Q off
    np.testing.assert_allclose(half_sine(s, LIGHT, 1.0, 1.0), np.pi / 2, rtol=1e-6)


def test_a_short_pulse_is_a_velocity_shock():
    A, tau, fn = 4000.0, 1e-4, 1.0
    impulse = velocity_shock_acceleration(2 * A * tau / np.pi, fn)
    # next term is of order (f_n τ)² = 1e-8, and damping takes about 1/Q off
    assert half_sine(fn, LIGHT, A, tau) == pytest.approx(float(impulse), rel=2e-7)


def test_a_long_pulse_is_quasi_static():
    assert half_sine(150.0, 5.0, 3.0, 1.0) == pytest.approx(3.0, rel=1e-3)


def test_response_scales_with_the_pulse_and_depends_on_fn_tau_only():
    base, other = half_sine(80.0, 10.0, 1.0, 0.01), half_sine(800.0, 10.0, 7.0, 0.001)
    assert other == pytest.approx(7 * base, rel=ROUNDING)


def test_two_oscillators_are_added_in_time_within_the_pulse():
    shares, s, Q = np.array([[[0.6, -0.9]]]), np.array([1.3, 4.1]), 20.0
    t = np.linspace(0.0, 1.0, 20001)

    def motion(time, y):
        w = 2 * np.pi * s
        return np.concatenate([y[2:], -w / Q * y[2:] - w**2 * y[:2] - np.sin(np.pi * time)])

    path = solve_ivp(motion, (0, 1), np.zeros(4), method="DOP853", rtol=1e-11, atol=1e-14, t_eval=t)
    during = np.abs(shares[0, 0] * (2 * np.pi * s) ** 2 @ path.y[:2]).max()
    (found,) = half_sine_sums([shares], s, Q, 1.0, 1.0)
    assert found == pytest.approx(during, rel=SAMPLED)


@pytest.mark.parametrize(
    ("stated", "text"),
    [((1, 10, 1, 0), "tau must be positive"), ((1, 0.4, 1, 1), "at least 0.5")],
)
def test_invalid_arguments_are_refused(stated, text):
    with pytest.raises(ValueError, match=text):
        half_sine(*stated)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_an_oscillator_that_follows_the_pulse_adds_to_one_that_nearly_does(sign):
    # of 100 and 300 periods in the pulse: both ride along, so that their halves add up or cancel
    shares = np.array([[[0.5, 0.5 * sign]]])
    (found,) = half_sine_sums([shares], [100.0, 300.0], 10.0, 1.0, 1.0)
    assert found == pytest.approx(0.5 * (1.0 + sign), abs=0.01)
