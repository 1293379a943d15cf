"""Dirlik's density of amplitude: its area, its printed form, amplitude against range."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from scipy.integrate import quad
from scipy.special import gamma
from stresses import ROUNDING, SPECTRA, spectra, spectral_moments

from flexcli.formulas import dirlik as module
from flexcli.formulas.dirlik import dirlik_damage_rate, dirlik_density
from flexcli.formulas.spectral_moments import Moments


@pytest.mark.slow
@given(moments=spectra)
@settings(deadline=None, max_examples=40)
def test_dirlik_density_of_amplitude_over_rms_has_unit_area(moments):
    sigma = float(np.sqrt(moments.m0))
    cuts = np.concatenate([[0.0], sigma * np.geomspace(1e-6, 40, 40)])
    area = sum(
        quad(lambda a: float(dirlik_density(a, moments)), x, y, epsabs=1e-13)[0]
        for x, y in itertools.pairwise(cuts)
    )
    assert area == pytest.approx(1.0, abs=1e-9)


@given(moments=spectra)
@settings(deadline=None, max_examples=40)
def test_dirlik_closed_form_is_the_one_printed(moments):
    k, C = 4.2, 1e6
    m0, m1, m2, m4 = (float(getattr(moments, name)) for name in ("m0", "m1", "m2", "m4"))
    g, xm = m2 / np.sqrt(m0 * m4), m1 / m0 * np.sqrt(m2 / m4)
    D1 = 2 * (xm - g**2) / (1 + g**2)
    R = (g - xm - D1**2) / (1 - g - D1 + D1**2)
    D2 = (1 - g - D1 + D1**2) / (1 - R)
    D3 = 1 - D1 - D2
    Q = 1.25 * (g - D3 - D2 * R) / D1
    printed = (
        np.sqrt(m4 / m2)
        / C
        * m0 ** (k / 2)
        * (D1 * Q**k * gamma(1 + k) + np.sqrt(2) ** k * gamma(1 + k / 2) * (D2 * abs(R) ** k + D3))
    )
    # the printed form loses digits in its quotients
    assert float(dirlik_damage_rate(moments, k, C)) == pytest.approx(printed, rel=1e-8)


def test_a_curve_in_range_needs_the_factor_two_to_the_k():
    # N = C_s s^(−k) in range s = 2a is N = (C_s 2^(−k)) a^(−k) in amplitude
    moments, k, in_range = spectral_moments(*SPECTRA["flat"]), 5.0, 3e8
    fit = module._dirlik(moments)
    ranges = np.linspace(0, 80 * float(np.sqrt(moments.m0)), 2_000_001)
    density_of_range = dirlik_density(ranges / 2, moments) / 2
    damage = float(moments.peak_rate) * np.trapezoid(ranges**k * density_of_range, ranges)
    assert float(dirlik_damage_rate(moments, k, in_range * 2.0**-k)) == pytest.approx(
        damage / in_range, rel=1e-8
    )
    assert float(fit.Q / fit.D1) == pytest.approx(1.25, rel=ROUNDING)


def test_a_single_frequency_has_no_density():
    with pytest.raises(ValueError, match="rayleigh_density"):
        dirlik_density(1.0, Moments(1, 1, 1, 1))
