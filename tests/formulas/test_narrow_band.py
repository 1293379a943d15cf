"""Narrow-band damage: the Rayleigh integral."""

import numpy as np
import pytest
from scipy.integrate import quad
from stresses import SPECTRA, spectral_moments

from flexcli.formulas.narrow_band import narrow_band_damage_rate, rayleigh_density
from flexcli.formulas.spectral_moments import Moments

QUADRATURE = 1e-9


def test_narrow_band_damage_is_the_rayleigh_integral():
    moments, k, C = spectral_moments(*SPECTRA["flat"]), 5.3, 1e9
    sigma = float(np.sqrt(moments.m0))
    integral = quad(lambda a: a**k * float(rayleigh_density(a, sigma)), 0, 40 * sigma)[0]
    assert float(narrow_band_damage_rate(moments, k, C)) == pytest.approx(
        float(moments.crossing_rate) * integral / C, rel=QUADRATURE
    )


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: narrow_band_damage_rate(Moments(1, 1, 1, 1), -1, 1), "exponent"),
        (lambda: narrow_band_damage_rate(Moments(1, 1, 1, 1), 3, 0), "constant"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
