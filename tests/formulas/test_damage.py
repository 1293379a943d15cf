"""All methods together: their common limit, scaling, and a rainflow count."""

import numpy as np
import pytest
import rainflow
from stresses import ROUNDING, SPECTRA, spectral_moments, times

from flexcli.formulas.damage import METHODS, damage_rates
from flexcli.formulas.dirlik import dirlik_damage_rate
from flexcli.formulas.narrow_band import narrow_band_damage_rate
from flexcli.formulas.spectral_moments import Moments
from flexcli.formulas.spectrum import spectral_level
from flexcli.formulas.tovo_benasciutti import tovo_benasciutti_damage_rate
from flexcli.formulas.wirsching_light import wirsching_light_damage_rate

RAINFLOW = 0.15  # scatter of one record of 1e5 cycles at k = 4, and the methods' own error


def record(frequency, level, *, seed, count=2**19):
    """Give a Gaussian record of a profile: random phases and amplitudes, 16 points per period."""
    rate = 16 * frequency[-1]
    f = np.fft.rfftfreq(count, 1 / rate)
    g = spectral_level(np.maximum(f, 1e-300), frequency, level)
    random = np.random.default_rng(seed)
    size = np.sqrt(g * rate * count / 4)
    phases = random.standard_normal((2, f.size))
    return np.fft.irfft(size * (phases[0] + 1j * phases[1]), count), count / rate


@pytest.mark.parametrize("k", [3, 6.4, 12])
def test_all_continuous_methods_agree_as_the_band_narrows(k):
    for width, wirsching, others in ((1e-3, 0.02, 1e-5), (1e-6, 2e-5, 1e-10), (1e-9, 2e-6, 1e-10)):
        moments = spectral_moments([100, 100 * (1 + width)], [1.0, 1.0])
        narrow = float(narrow_band_damage_rate(moments, k, 1.0))
        # ε = sqrt(1 − α_2²) shrinks with the band's width, Dirlik's and Tovo's terms with its
        # square; at 1e-9 rounding of the moments leaves ε of some 1e-8
        assert float(wirsching_light_damage_rate(moments, k, 1.0)) == pytest.approx(
            narrow, rel=wirsching
        )
        for method in (dirlik_damage_rate, tovo_benasciutti_damage_rate):
            assert float(method(moments, k, 1.0)) == pytest.approx(narrow, rel=others)


def test_a_single_frequency_is_narrow_band_for_every_method():
    moments = Moments(2.0, 2e2, 2e4, 2e8)
    rates = damage_rates(moments, 5.0, 1e6)
    for name in ("wirsching-light", "dirlik", "tovo-benasciutti"):
        assert float(rates[name]) == pytest.approx(float(rates["narrow-band"]), rel=ROUNDING)


# not "falling": its record has too few of the large cycles that do the damage
@pytest.mark.parametrize("spectrum", ["flat", "low-pass", "two modes"])
def test_rainflow_of_a_record_agrees_with_dirlik_and_tovo_benasciutti(spectrum):
    frequency, level = SPECTRA[spectrum]
    signal, time = record(frequency, level, seed=2024)
    moments, k = spectral_moments(frequency, level), 4.0
    assert signal.std() == pytest.approx(float(np.sqrt(moments.m0)), rel=0.02)
    cycles = np.array([(rng / 2, count) for rng, _, count, _, _ in rainflow.extract_cycles(signal)])
    counted = float(cycles[:, 0] ** k @ cycles[:, 1]) / time
    for method in (dirlik_damage_rate, tovo_benasciutti_damage_rate):
        assert float(method(moments, k, 1.0)) == pytest.approx(counted, rel=RAINFLOW)
    # Rychlik's bound, but for the record's scatter
    assert counted <= float(narrow_band_damage_rate(moments, k, 1.0)) * (1 + 0.05)


@pytest.mark.parametrize(("name", "method"), METHODS)
def test_the_unit_of_stress_scales_out(name, method):
    moments, k = spectral_moments(*SPECTRA["flat"]), 6.4
    in_pascal = times(1e6, moments)
    assert float(method(in_pascal, k, 1e20 * 1e6**k)) == pytest.approx(
        float(method(moments, k, 1e20)), rel=ROUNDING
    )


@pytest.mark.parametrize(("name", "method"), METHODS)
def test_methods_broadcast_over_designs_and_exponents(name, method):
    moments = times(np.array([[1.0], [2.0], [3.0]]), spectral_moments(*SPECTRA["flat"]))
    rates = method(moments, np.array([3.0, 8.0]), 1.0)
    assert rates.shape == (3, 2)
    np.testing.assert_allclose(rates[1] / rates[0], [2.0**3, 2.0**8], rtol=ROUNDING)
