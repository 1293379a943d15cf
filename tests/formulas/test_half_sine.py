"""Half-sine pulse: the response against integration in time, and their limits."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from flexcli.formulas.shock import (
    half_sine_damped,
    velocity_shock_acceleration,
)

SAMPLED = 1e-7  # a maximum read off 20,000 samples of an integration to 1e-12
ROUNDING = 1e-12
LIGHT = 1e7  # quality factor of next to no damping


def integrated_maxima(s, Q, quantity):
    """Greatest |signal| during and after a pulse of 1 m/s² and 1 s, by time integration."""
    w = 2 * np.pi * s

    def motion(t, y):
        base = np.sin(np.pi * t) if t < 1 else 0.0
        return [y[1], -w / Q * y[1] - w**2 * y[0] - base]

    def signal(y):
        return w**2 * y[0] + (w / Q * y[1] if quantity == "absolute" else 0.0)

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
        greatest.append(np.abs(signal(path.y)).max())
        state = path.y[:, -1]
    return greatest


@pytest.mark.slow
@pytest.mark.parametrize("quantity", ["absolute", "pseudo"])
@pytest.mark.parametrize("Q", [0.5, 0.8, 10.0, 1e3])
@pytest.mark.parametrize("s", [0.1, 0.5, 3.3])
def test_damped_maxima_agree_with_time_integration(s, Q, quantity):
    found = half_sine_damped(s, Q, 1.0, 1.0, quantity=quantity)
    primary, residual = integrated_maxima(s, Q, quantity)
    assert float(found.primary) == pytest.approx(primary, rel=SAMPLED)
    assert float(found.residual) == pytest.approx(residual, rel=SAMPLED)


def test_half_sine_amplifies_by_at_most_1_77():
    # Harris' Shock and Vibration Handbook, chapter 8: undamped half-sine maximum 1.77
    maximax = half_sine_damped(np.linspace(0.7, 0.9, 101), LIGHT, 1.0, 1.0).maximax
    assert maximax.max() == pytest.approx(1.77, abs=0.005)


def test_pulse_in_tune_gives_half_pi_in_both_eras_without_a_jump():
    s = 0.5 + np.array([-1e-9, -1e-15, 0.0, 1e-15, 1e-9])
    found = half_sine_damped(s, LIGHT, 1.0, 1.0)
    # slope in s is of order 1, damping takes about π/Q off
    np.testing.assert_allclose(found.primary, np.pi / 2, rtol=1e-6)
    np.testing.assert_allclose(found.residual, np.pi / 2, rtol=1e-6)


def test_a_short_pulse_is_a_velocity_shock():
    A, tau, fn = 4000.0, 1e-4, 1.0
    impulse = velocity_shock_acceleration(2 * A * tau / np.pi, fn)
    # next term is of order (f_n τ)² = 1e-8, and damping takes about 1/Q off
    found = half_sine_damped(fn, LIGHT, A, tau).residual
    assert float(found) == pytest.approx(float(impulse), rel=2e-7)


def test_a_long_pulse_is_quasi_static():
    assert float(half_sine_damped(150.0, 5.0, 3.0, 1.0).primary) == pytest.approx(3.0, rel=1e-3)


def test_response_scales_with_the_pulse_and_depends_on_fn_tau_only():
    base = half_sine_damped(80.0, 10.0, 1.0, 0.01)
    other = half_sine_damped(800.0, 10.0, 7.0, 0.001)
    assert float(other.maximax) == pytest.approx(7 * float(base.maximax), rel=ROUNDING)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: half_sine_damped(1, 10, 1, 0), "tau must be positive"),
        (lambda: half_sine_damped(1, 0.4, 1, 1), "at least 0.5"),
        (lambda: half_sine_damped(201, 10, 1, 1), "quasi-static"),
        (lambda: half_sine_damped(1, 10, 1, 1, quantity="jerk"), "quantity"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
