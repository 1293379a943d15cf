import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.numerics.exponential_sum import ExponentialSum
from flexcli.numerics.signal_pieces import (
    Piece,
    Samples,
    half_sine,
    linear_sweep,
    logarithmic_sweep,
    sine,
)

LOG = np.log(4.0) / 9.0
CASES = [
    (lambda: sine(amplitude=2.0, angular=3.0, duration=9.0, phase=0.4), lambda t: 3 * t + 0.4),
    (
        lambda: linear_sweep(amplitude=2.0, start=1.0, end=4.0, duration=9.0),
        lambda t: t + t * t / 6,
    ),
    (
        lambda: logarithmic_sweep(amplitude=2.0, start=1.0, end=4.0, duration=9.0),
        lambda t: np.expm1(LOG * t) / LOG,
    ),
]


@pytest.mark.parametrize(("pieces", "phase"), CASES, ids=["sine", "linear", "logarithmic"])
def test_pieces_of_a_sweep_join_to_the_sine_of_its_phase(pieces, phase):
    t = 0.0
    for piece in pieces():
        for part in (0.0, 0.3, 1.0):
            expected = 2.0 * np.sin(phase(t + part * piece.duration))
            assert piece(part * piece.duration) == pytest.approx(expected, abs=1e-12)
        t += piece.duration
    assert t == pytest.approx(9.0, rel=1e-12)


@pytest.mark.parametrize("power", [1, 2])
@pytest.mark.parametrize("ends", [(1.0, 4.0), (4.0, 1.0)])
def test_the_amplitude_of_a_sweep_goes_with_a_power_of_its_frequency(power, ends):
    start, end = ends
    how = {"amplitude": 2.0, "start": start, "end": end, "duration": 9.0, "power": power}
    k = np.log(end / start) / 9.0
    for pieces, omega, phase in (
        (linear_sweep(**how, phase=0.3), lambda t: start + (end - start) * t / 9.0,
         lambda t: start * t + (end - start) * t * t / 18.0),
        (logarithmic_sweep(**how, phase=0.3), lambda t: start * np.exp(k * t),
         lambda t: start * np.expm1(k * t) / k),
    ):  # fmt: skip
        t = 0.0
        for piece in pieces:
            at = t + 0.3 * piece.duration
            expected = 2.0 * omega(at) ** power * np.sin(0.3 + phase(at))
            assert piece(0.3 * piece.duration) == pytest.approx(expected, abs=1e-11)
            t += piece.duration


@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0))
def test_what_is_left_of_a_piece_is_the_same_signal(start, more):
    for make, _ in CASES:
        piece = next(iter(make()))
        begin = start * piece.duration
        left = piece.after(begin)
        t = more * left.duration
        assert left(t) == pytest.approx(piece(begin + t), abs=1e-12)
        assert begin + left.duration == pytest.approx(piece.duration)


def test_samples_are_joined_by_straight_lines():
    first, second = Samples(np.array([1.0, 3.0, -1.0]), 0.5).lines()
    assert (first(0.0), first(0.25), first(0.5)) == (1.0, 2.0, 3.0)
    assert second(0.25) == 1.0


def test_a_half_sine_is_a_pulse_and_then_nothing():
    pulse, silence = half_sine(amplitude=5.0, width=2.0, duration=6.0)
    assert pulse(1.0) == pytest.approx(5.0)
    assert pulse(2.0) == pytest.approx(0.0, abs=1e-15)
    assert silence == Piece(4.0, ())
    assert silence(1.0) == 0.0


@given(st.floats(0.0, 3.0))
def test_derivatives_and_bound_of_a_sum_hold(t):
    terms = [(complex(-0.3, 2.0), (1.0, -0.5j, 0.2)), (0j, (1.0, 2.0)), (3j, (0.4 + 0.1j,))]
    total = ExponentialSum(terms, 4.0)
    h = 1e-4
    jet, before, after = total.jet(t), total.jet(t - h), total.jet(t + h)
    assert jet.first == pytest.approx((after.value - before.value) / (2 * h), abs=1e-6)
    assert jet.second == pytest.approx((after.first - before.first) / (2 * h), abs=1e-6)
    later = np.linspace(t, 4.0, 50)
    seconds = [total.jet(u).second for u in later]
    assert np.abs(np.diff(seconds) / np.diff(later)).max() <= jet.third_bound * (1 + 1e-9)
