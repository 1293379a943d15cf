"""Oscillators on records, against pulses in closed form, an integrator and scaling."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from flexcli.formulas.record_spectrum import record_turns, shock_response_spectrum
from flexcli.formulas.shock import half_sine_sums, velocity_shock_acceleration

TAU = 0.011
FN = np.array([10.0, 73.0, 100.0, 300.0, 1000.0])


def half_sine(samples):
    t = np.linspace(0.0, TAU, samples + 1)
    return np.sin(np.pi * t / TAU), TAU / samples


@pytest.mark.parametrize("Q", [0.6, 2.0, 10.0, 100.0])
def test_a_half_sine_has_its_closed_form_to_the_error_of_straight_lines(Q):
    alone = [np.ones((1, 1, 1))]
    exact = [half_sine_sums(alone, [fn], Q, 1.0, TAU)[0] for fn in FN]
    _, _, spring = shock_response_spectrum(*half_sine(400), FN, Q)
    # chords of a sine of n steps lie (π/n)²/12 of its size below it, its turns are found to 6e-5
    chord = (np.pi / 400) ** 2 / 12.0
    assert spring == pytest.approx(np.array(exact), rel=1.2 * chord + 6e-5)


def test_a_sudden_velocity_gives_v_times_omega():
    dt, fn = 1e-6, 20.0
    record = np.concatenate([[0.0, 1.0 / dt, 0.0], np.zeros(50)])  # an impulse of 1 m/s
    up, down, _ = shock_response_spectrum(record, dt, [fn], 1e5)
    assert max(up[0], down[0]) == pytest.approx(
        float(velocity_shock_acceleration(1.0, fn)), rel=1e-3
    )


def test_turns_are_those_of_an_integrator_of_the_same_straight_lines():
    rng, dt, fn, Q = np.random.default_rng(3), 0.004, 31.0, 8.0
    a = np.append(rng.normal(size=40), np.zeros(20))  # the motion dies out
    t = dt * np.arange(a.size)
    omega = 2.0 * np.pi * fn

    def motion(time, y):
        return [y[1], -np.interp(time, t, a) - omega / Q * y[1] - omega**2 * y[0]]

    y = np.zeros(2)
    greatest = 0.0
    for i in range(a.size - 1):  # from sample to sample, where the input has its corners
        run = solve_ivp(motion, (t[i], t[i + 1]), y, rtol=1e-10, atol=1e-14, dense_output=True)
        fine = run.sol(np.linspace(t[i], t[i + 1], 400))
        greatest = max(greatest, np.abs(omega / Q * fine[1] + omega**2 * fine[0]).max())
        y = run.y[:, -1]
    during = record_turns(a, dt, fn, Q, rest=1e-9)
    assert np.abs(during).max() == pytest.approx(greatest, rel=1e-4)


def test_spectra_grow_with_the_record_and_turn_over_with_it():
    a = np.random.default_rng(5).normal(size=300)
    up, down, spring = shock_response_spectrum(a, 1e-3, FN, 10.0)
    again = shock_response_spectrum(-3.0 * a, 1e-3, FN, 10.0)
    assert again[0] == pytest.approx(3.0 * down, rel=1e-12)
    assert again[1] == pytest.approx(3.0 * up, rel=1e-12)
    assert again[2] == pytest.approx(3.0 * spring, rel=1e-12)


def test_a_record_in_other_units_of_time_has_the_same_spectrum_at_scaled_frequencies():
    a = np.random.default_rng(7).normal(size=300)
    slow = shock_response_spectrum(a, 1.0, FN / 1000.0, 10.0)
    fast = shock_response_spectrum(a, 1e-3, FN, 10.0)
    for one, other in zip(slow, fast, strict=True):
        assert one == pytest.approx(other, rel=1e-9)


@pytest.mark.parametrize(
    ("record", "Q", "word"), [([1.0], 10.0, "two samples"), ([0.0, np.nan], 10.0, "finite"),
                              ([0.0, 1.0], 0.5, "critical")],
)  # fmt: skip
def test_what_is_no_record_or_no_oscillator_is_refused(record, Q, word):
    with pytest.raises(ValueError, match=word):
        record_turns(record, 0.001, 10.0, Q)


def test_pyyeti_has_the_same_spectrum():
    """Of its 'steady' start as ours, from rest; its peaks lie on samples, 1/40 period apart."""
    srs = pytest.importorskip("pyyeti.srs")
    dt, Q = 1.0 / 40_000.0, 25.0
    t = np.arange(8000) * dt
    a = np.exp(-30.0 * t) * np.sin(2.0 * np.pi * 120.0 * t)
    f = np.array([20.0, 60.0, 119.0, 400.0, 1000.0])
    up, down, _ = shock_response_spectrum(a, dt, f, Q)
    theirs = srs.srs(a[:, None], 1.0 / dt, f, Q, ic="zero", stype="absacce", time="total")[:, 0]
    assert np.maximum(up, down) == pytest.approx(theirs, rel=0.5 * (np.pi / 40.0) ** 2 + 1e-4)


@pytest.mark.parametrize("signal", ["absolute", "relative"])
@pytest.mark.parametrize(("fn", "Q"), [(31.0, 0.6), (5.0, 0.6), (31.0, 8.0)])
def test_turns_of_a_rough_record_are_those_of_the_same_lines_with_more_samples(fn, Q, signal):
    # noise that changes from sample to sample turns what is damped much in every step
    dt, more = 0.004, 32
    a = np.append(np.random.default_rng(3).normal(size=60), [0.0, 0.0])
    t = dt * np.arange(a.size)
    fine = np.interp(np.linspace(0.0, t[-1], (a.size - 1) * more + 1), t, a)
    rough = record_turns(a, dt, fn, Q, signal=signal, rest=1e-9)[1:-1]
    exact = record_turns(fine, dt / more, fn, Q, signal=signal)  # followed longer
    near = np.abs(rough[:, None] - exact).min(axis=1).max() / np.abs(exact).max()
    assert near < 5e-3
