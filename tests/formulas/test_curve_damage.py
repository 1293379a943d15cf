"""Damage on a life curve of several lines, against closed forms and incomplete gamma functions."""

import numpy as np
import pytest
from scipy.special import gamma, gammainc
from stresses import SPECTRA, spectral_moments

from flexcli.formulas.curve_damage import curve_damage_rate
from flexcli.formulas.dirlik import dirlik_damage_rate, dirlik_density
from flexcli.formulas.narrow_band import narrow_band_damage_rate, rayleigh_density
from flexcli.formulas.tovo_benasciutti import (
    tovo_benasciutti_damage_rate,
    tovo_benasciutti_density,
)


@pytest.mark.parametrize("spectrum", SPECTRA)
@pytest.mark.parametrize("k", [1.0, 3.0, 6.4, 20.0])
def test_densities_integrate_to_the_closed_forms(spectrum, k):
    moments = spectral_moments(*SPECTRA[spectrum])
    sigma, C = float(np.sqrt(moments.m0)), 2.0e7
    points = ((C * (3 * sigma) ** -k, 3 * sigma), (C * sigma**-k, sigma))
    for method, density, rate in (
        (narrow_band_damage_rate, lambda a: rayleigh_density(a, sigma), moments.crossing_rate),
        (dirlik_damage_rate, lambda a: dirlik_density(a, moments), moments.peak_rate),
        (
            tovo_benasciutti_damage_rate,
            lambda a: tovo_benasciutti_density(a, moments),
            moments.peak_rate,
        ),
    ):
        numeric = curve_damage_rate(density, float(rate), points, scale=sigma)
        assert numeric == pytest.approx(float(method(moments, k, C)), rel=1e-10)


def test_bilinear_curve_agrees_with_incomplete_gamma_functions():
    sigma, rate, k1, k2, knee, N = 30.0, 120.0, 5.0, 9.0, 55.0, 1e6
    x = (knee / sigma) ** 2 / 2
    above = (2 * sigma**2) ** (k1 / 2) * gamma(1 + k1 / 2) * (1 - gammainc(1 + k1 / 2, x))
    below = (2 * sigma**2) ** (k2 / 2) * gamma(1 + k2 / 2) * gammainc(1 + k2 / 2, x)
    exact = rate / N * (above / knee**k1 + below / knee**k2)
    points = ((N * 4**-k1, 4 * knee), (N, knee), (N * 2**k2, knee / 2))
    numeric = curve_damage_rate(lambda a: rayleigh_density(a, sigma), rate, points, scale=sigma)
    assert numeric == pytest.approx(exact, rel=1e-11)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: curve_damage_rate(abs, 1.0, ((1, 1),), scale=1.0), "two points"),
        (lambda: curve_damage_rate(abs, 1.0, ((1, 1), (2, 1)), scale=1.0), "falls"),
        (lambda: curve_damage_rate(abs, 0.0, ((1, 2), (2, 1)), scale=1.0), "rate and scale"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
