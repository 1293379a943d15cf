"""Fatigue of a blade: S-N interpolation and the corrections for a mean stress."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from stresses import SPECTRA, spectral_moments, times

from flexcli.formulas.fatigue import (
    amplitude_at_life,
    fully_reversed_amplitude,
    goodman_amplitude,
    goodman_factor,
    swt_amplitude_squared,
)
from flexcli.formulas.narrow_band import narrow_band_damage_rate

ROUNDING = 1e-12
CURVE = ((1e4, 800e6), (1e5, 500e6), (1e7, 400e6))
stresses = st.floats(1.0, 1e9)  # Pa


def test_points_of_the_curve_come_back_exactly():
    for cycles, amplitude in CURVE:
        assert amplitude_at_life(CURVE, cycles) == amplitude


def test_between_points_the_curve_is_straight_in_logarithms():
    # halfway in log N, so the geometric mean of the amplitudes
    assert amplitude_at_life(CURVE, 1e6) == pytest.approx((500e6 * 400e6) ** 0.5, rel=ROUNDING)


@given(st.floats(1e4, 1e7), st.floats(1e4, 1e7))
def test_a_longer_life_bears_no_more(n, m):
    short, long = sorted((n, m))
    assert amplitude_at_life(CURVE, long) <= amplitude_at_life(CURVE, short) * (1 + ROUNDING)


@pytest.mark.parametrize("cycles", [9.99e3, 1.01e7])
def test_a_life_outside_the_curve_is_refused(cycles):
    with pytest.raises(ValueError, match="outside"):
        amplitude_at_life(CURVE, cycles)


def test_an_amplitude_at_another_stress_ratio_is_on_goodmans_line():
    amplitude, ratio, tensile = 300e6, 0.1, 900e6
    mean = amplitude * (1 + ratio) / (1 - ratio)
    reversed_amplitude = fully_reversed_amplitude(amplitude, ratio, tensile)
    # Goodman: σ_a/σ_D + σ_m/R_m = 1
    assert amplitude / reversed_amplitude + mean / tensile == pytest.approx(1.0, rel=ROUNDING)


def test_a_mean_at_the_tensile_strength_is_refused():
    with pytest.raises(ValueError, match="tensile"):
        fully_reversed_amplitude(300.0, 0.5, 900.0)


@given(amplitude=stresses, mean=stresses)
def test_goodmans_factor_is_by_how_much_both_may_grow(amplitude, mean):
    strength, tensile = 500e6, 900e6
    equivalent = goodman_amplitude(
        amplitude=amplitude, mean=mean, reversed_strength=strength, limit=tensile
    )
    n = strength / equivalent
    assert n * amplitude / strength + n * mean / tensile == pytest.approx(1.0, rel=ROUNDING)


@given(amplitude=stresses)
def test_without_a_mean_every_method_is_the_amplitude(amplitude):
    plain = goodman_amplitude(amplitude=amplitude, mean=0.0, reversed_strength=1e8, limit=1e9)
    assert plain == amplitude
    squared = swt_amplitude_squared(amplitude=amplitude, mean=0.0)
    assert squared == pytest.approx(amplitude**2, rel=ROUNDING)


def test_swt_is_the_root_of_largest_stress_times_amplitude():
    # Smith, Watson & Topper: σ_ar = √(σ_max σ_a)
    squared = swt_amplitude_squared(amplitude=100.0, mean=300.0)
    assert squared**0.5 == pytest.approx((400.0 * 100.0) ** 0.5, rel=ROUNDING)


def test_goodman_scales_the_amplitude_and_compression_earns_nothing():
    moments, k = spectral_moments(*SPECTRA["flat"]), 5.0
    rate = narrow_band_damage_rate(moments, k, 1.0)
    loaded = narrow_band_damage_rate(times(goodman_factor(450e6, 900e6), moments), k, 1.0)
    assert float(loaded / rate) == pytest.approx(2**k, rel=ROUNDING)
    assert goodman_factor([-1e6, -1e9], 900e6).tolist() == [1.0, 1.0]


@pytest.mark.parametrize(
    ("mean", "strength", "text"),
    [(9e8, 9e8, "reaches"), (9e8, 0, "tensile strength must be positive")],
)
def test_a_goodman_factor_without_meaning_is_refused(mean, strength, text):
    with pytest.raises(ValueError, match=text):
        goodman_factor(mean, strength)
