"""Damage of a sine on random stress: Rice's moments, and cycles of a record that was made."""

from math import gamma, sqrt

import numpy as np
import pytest
from scipy.special import hyp1f1

from flexcli.formulas.sine_on_random import rice_damage_rate, rice_density


@pytest.mark.parametrize("k", [3.0, 6.5, 14.0])
@pytest.mark.parametrize("sine", [0.0, 0.5, 4.0, 60.0])
def test_on_one_line_the_damage_is_rice_s_moment(k, sine):
    sigma, curve = 1.3, ((1.0, 100.0), (100.0**k, 1.0))  # N = (100/a)^k
    x = -0.5 * (sine / sigma) ** 2
    moment = (sqrt(2.0) * sigma) ** k * gamma(1.0 + k / 2.0) * hyp1f1(-k / 2.0, 1.0, x)
    expected = 7.0 * moment / 100.0**k
    assert rice_damage_rate(sigma, sine, 7.0, curve) == pytest.approx(expected, rel=1e-8)


def test_the_density_is_one_in_all_and_normal_about_a_strong_sine():
    a = np.linspace(0.0, 40.0, 40001)
    assert np.trapezoid(rice_density(a, 1.0, 3.0), a) == pytest.approx(1.0, rel=1e-9)
    normal = np.exp(-0.5 * (a - 30.0) ** 2) / sqrt(2.0 * np.pi)
    # Rice's density tends to it as σ/A
    assert np.abs(rice_density(a, 1.0, 30.0) - normal).max() < 1.0 / 30.0 * normal.max()


@pytest.mark.parametrize(("sine_at", "tightest"), [(100.0, 0.75), (37.0, 0.0), (300.0, 0.0)])
def test_it_is_no_less_than_the_rainflow_damage_of_a_record(sine_at, tightest):
    rainflow = pytest.importorskip("rainflow")
    rng = np.random.default_rng(3)
    f_s, duration, k, A = 2000.0, 60.0, 5.0, 2.0
    t = np.arange(0.0, duration, 1.0 / f_s)
    f = np.fft.rfftfreq(t.size, 1.0 / f_s)
    band = (f > 95.0) & (f < 105.0)
    parts = np.where(band, rng.normal(size=f.size) + 1j * rng.normal(size=f.size), 0.0)
    noise = np.fft.irfft(parts, t.size)
    record = noise / noise.std() + A * np.sin(2.0 * np.pi * sine_at * t + 1.0)
    cycles = rainflow.extract_cycles(record)
    counted = sum((size / 2.0) ** k * count for size, _, count, _, _ in cycles) / duration
    told = rice_damage_rate(1.0, A, max(100.0, sine_at), ((1.0, 1.0), (2.0**k, 0.5)))
    # one record of 600 independent bandwidths scatters by some 10 %
    assert tightest * told < counted < 1.15 * told
