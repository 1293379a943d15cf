"""Damage spectra: Lalanne's closed form for a flat density, scaling, counted cycles."""

from math import gamma

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.damage_spectrum import (
    damage_spectrum,
    equal_damage_factor,
    extreme_spectrum,
)
from flexcli.formulas.miles import miles

WIDE = np.array([1e-3, 1e7])
exponents = st.floats(2.0, 16.0)


@pytest.mark.parametrize("b", [3.0, 6.4, 12.0])
@pytest.mark.parametrize("Q", [10.0, 200.0])
def test_a_flat_density_has_lalanne_s_closed_form(b, Q):
    f, G, T = np.array([50.0, 300.0]), 3.0, 120.0
    closed = f * T * (Q * G / (2.0 * (2.0 * np.pi * f) ** 3)) ** (b / 2) * gamma(1.0 + b / 2)
    # outside the band lacks some f/1e7 and (1e-3/f) of the response; the rate of crossings more
    found = damage_spectrum(WIDE, np.full(2, G), f, Q, T, b)
    assert found == pytest.approx(closed, rel=2e-3)


def test_the_extreme_of_a_flat_density_is_miles_times_the_peak_factor():
    f, G, T, Q = np.array([50.0, 300.0]), 3.0, 120.0, 50.0
    expected = miles(f, Q, G) * np.sqrt(2.0 * np.log(f * T))
    assert extreme_spectrum(WIDE, np.full(2, G), f, Q, T) == pytest.approx(expected, rel=1e-3)


@given(exponents, st.floats(-20.0, 20.0), st.floats(1.0, 1e5))
def test_damage_grows_with_the_level_s_power_and_the_time(b, db, time):
    f, g, fn = np.array([20.0, 200.0, 2000.0]), np.array([0.1, 1.0, 0.2]), np.array([30.0, 900.0])
    factor = 10.0 ** (db / 10.0)
    one = damage_spectrum(f, g, fn, 20.0, 1.0, b)
    assert damage_spectrum(f, factor * g, fn, 20.0, time, b) == pytest.approx(
        one * factor ** (b / 2.0) * time, rel=1e-9
    )


@given(exponents, st.floats(1e-6, 1e6), st.floats(1e-6, 1e6))
def test_equal_damage_goes_back_to_where_it_came_from(b, one, other):
    there, back = equal_damage_factor(one, other, b), equal_damage_factor(other, one, b)
    assert float(there * back) == pytest.approx(1.0, rel=1e-12)
    assert one * float(there) ** (b / 2.0) == pytest.approx(other, rel=1e-9)


def test_gunfire_of_a_tenth_of_the_time_is_louder_by_the_exponent():
    # ten times shorter at b = 8: 10^(2/8) = 1.778 in density, 2.5 dB
    assert 10.0 * np.log10(float(equal_damage_factor(1.0, 10.0, 8.0))) == pytest.approx(2.5)


@pytest.mark.slow
def test_cycles_counted_in_records_agree_with_the_narrow_band():
    """Of a lightly damped oscillator; the scatter of damage is some sqrt(Q/(f T)) times b."""
    rainflow = pytest.importorskip("rainflow")
    from flexcli.formulas.record_spectrum import record_turns

    rng, dt, count, b, Q, fn = np.random.default_rng(11), 1.0 / 1000.0, 2**17, 4.0, 15.0, 40.0
    G = 2.0 * dt  # one-sided, of samples of unit variance
    a = rng.normal(size=count)
    turns = record_turns(a, dt, fn, Q, signal="relative")
    cycles = np.array([(size, n) for size, _, n, *_ in rainflow.extract_cycles(turns)])
    counted = float(((0.5 * cycles[:, 0]) ** b) @ cycles[:, 1])
    expected = float(damage_spectrum([1e-2, 500.0], [G, G], fn, Q, count * dt, b))
    assert counted == pytest.approx(expected, rel=0.15)
