import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oscillators import polynomial
from scipy.integrate import solve_ivp

from flexcli.numerics.linear_response import respond
from flexcli.numerics.linear_system import second_order_system
from flexcli.numerics.response_batch import ResponseBatch, greatest_values
from flexcli.numerics.signal_pieces import (
    Samples,
    half_sine,
    linear_sweep,
    logarithmic_sweep,
    sine,
)

REFERENCE = 1e-9
"""Relative: what the adaptive integrator with a tolerance of 1e-12 is good for."""

SIGNALS = {
    "sine": lambda: sine(amplitude=2.0, angular=1.3, duration=9.0, phase=0.4),
    "linear sweep": lambda: linear_sweep(amplitude=2.0, start=1.0, end=4.0, duration=9.0),
    "log sweep": lambda: logarithmic_sweep(amplitude=2.0, start=4.0, end=1.0, duration=9.0),
    "samples": lambda: Samples(np.array([1.0, 2.0, 0.0, 3.0]), 3.0).lines(),
    "polynomial": lambda: polynomial([1.0, 2.0, -1.0, 0.3], 9.0),
    "half sine": lambda: half_sine(amplitude=2.0, width=2.0, duration=9.0),
}


def random_system(seed, damping):
    generator = np.random.default_rng(seed)
    A, B = generator.normal(size=(2, 3, 3))
    K = A @ A.T + np.eye(3)
    C = {"none": 0.0 * K, "modal": 0.1 * K, "coupled": 0.05 * B @ B.T, "heavy": 3.0 * B @ B.T}
    return K, C[damping], generator.normal(size=3), generator.normal(size=(2, 3))


@pytest.mark.slow
@pytest.mark.parametrize("signal", SIGNALS)
@pytest.mark.parametrize("damping", ["none", "modal", "coupled", "heavy"])
def test_the_exact_response_is_that_of_an_adaptive_integrator(damping, signal):
    K, C, b, (q, rate) = random_system(3, damping)
    system = second_order_system(K, C)
    w, y = system.drive(b), system.project(q, rate)
    x = np.concatenate([q, rate])
    for piece in SIGNALS[signal]():
        y = respond(system, w, y, piece).amplitudes(piece.duration)

        def slope(t, x, piece=piece):
            return np.concatenate([x[3:], b * piece(t) - C @ x[3:] - K @ x[:3]])

        solution = solve_ivp(slope, (0, piece.duration), x, "DOP853", rtol=1e-12, atol=1e-12)
        x = solution.y[:, -1]
    found = np.concatenate(system.state(y))
    np.testing.assert_allclose(found, x, rtol=REFERENCE, atol=REFERENCE * np.abs(x).max())


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**32 - 1), st.sampled_from(["none", "modal", "coupled"]))
def test_a_state_survives_the_way_to_amplitudes_and_back(seed, damping):
    K, C, _, (q, rate) = random_system(seed, damping)
    system = second_order_system(K, C)
    back = system.state(system.project(q, rate))
    np.testing.assert_allclose(back, [q, rate], atol=1e-9)


def test_resonance_without_damping_grows_with_time():
    # q'' + q = sin t from rest: q = (sin t − t cos t)/2
    system = second_order_system(np.eye(1), np.zeros((1, 1)))
    w, y, t = system.drive(np.ones(1)), system.project(np.zeros(1), np.zeros(1)), 0.0
    for piece in sine(amplitude=1.0, angular=1.0, duration=40.0):
        y = respond(system, w, y, piece).amplitudes(piece.duration)
        t += piece.duration
        expected = (np.sin(t) - t * np.cos(t)) / 2
        assert system.state(y)[0][0] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("detuning", [1e-3, 1e-6, 1e-9, 1e-12])
def test_near_resonance_loses_no_digits(detuning):
    # from rest: q = (sin Ωt − Ω sin t)/(1 − Ω²), which tends to the resonant growth
    system = second_order_system(np.eye(1), np.zeros((1, 1)))
    omega = 1.0 + detuning
    (piece,) = sine(amplitude=1.0, angular=omega, duration=2 * np.pi / omega)
    response = respond(system, system.drive(np.ones(1)), np.zeros(1, complex), piece)
    t = piece.duration
    x = (omega - 1) * t / 2
    # sin Ωt − sin t and (1 − Ω) sin t apart, each without cancellation
    beat = -t * np.sinc(x / np.pi) * np.cos((omega + 1) * t / 2) + np.sin(t)
    q = system.state(response.amplitudes(t))[0][0]
    assert q == pytest.approx(beat / (1 + omega), rel=1e-12)


def test_critical_damping_is_refused_by_name():
    with pytest.raises(ValueError, match="critically damped"):
        second_order_system(np.eye(1), 2.0 * np.eye(1))


def test_what_nothing_holds_is_refused():
    with pytest.raises(ValueError, match="not positive definite"):
        second_order_system(np.diag([0.0, 1.0]), np.zeros((2, 2)))


@pytest.mark.parametrize("signal", SIGNALS)
def test_a_batch_gives_what_each_response_gives(signal):
    K, C, b, (q, rate) = random_system(5, "coupled")
    system = second_order_system(K, C)
    w, y = system.drive(b), system.project(q, rate)
    pieces = list(SIGNALS[signal]())
    responses = [respond(system, w, y, piece) for piece in pieces]
    times = np.array([np.linspace(0.0, piece.duration, 5) for piece in pieces])
    batch = ResponseBatch(responses)
    for s, response in enumerate(responses):
        for i, t in enumerate(times[s]):
            found = batch.amplitudes(times)[s, :, i]
            np.testing.assert_allclose(found, response.amplitudes(t), atol=1e-13)
            assert batch.signal(times)[s, i] == pytest.approx(pieces[s](t), abs=1e-13)


def test_an_output_is_its_row_of_the_amplitudes():
    K, C, b, (q, rate) = random_system(5, "coupled")
    system = second_order_system(K, C)
    row = np.array([1.0, 2.0, -1.0]) @ system.shapes
    (piece,) = polynomial([1.0, -2.0], 3.0)
    response = respond(system, system.drive(b), system.project(q, rate), piece)
    output = response.output(row.tolist(), 0.7, 0.3)
    for t in (0.0, 1.0, 3.0):
        expected = 0.7 + (row @ response.amplitudes(t)).real + 0.3 * piece(t)
        assert output(t) == pytest.approx(expected, abs=1e-13)


def test_greatest_values_are_found_inside_and_at_the_ends():
    times = np.linspace(0.0, 1.0, 9) * np.ones((3, 1))
    centre = np.array([[0.43], [-1.0], [2.0]])

    def hill(t):
        return np.cos(t - centre)

    values, at = greatest_values(hill, times, hill(times))
    np.testing.assert_allclose(values, [1.0, np.cos(1.0), np.cos(1.0)], rtol=1e-14)
    np.testing.assert_allclose(at, [0.43, 0.0, 1.0], atol=1e-6)
