"""Spectral fatigue: limits, densities integrated independently, and a rainflow count."""

import doctest
import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.special import gamma, gammainc

from flexcli.formulas import spectral_fatigue as module
from flexcli.formulas.spectral_fatigue import (
    METHODS,
    Moments,
    curve_damage_rate,
    damage_rates,
    dirlik_damage_rate,
    dirlik_density,
    goodman_factor,
    life,
    narrow_band_damage_rate,
    rayleigh_density,
    spectral_moments,
    spread,
    steinberg_damage_rate,
    tovo_benasciutti_damage_rate,
    tovo_benasciutti_density,
    wirsching_light_damage_rate,
)

ROUNDING = 1e-11  # gamma functions and powers up to 20
QUADRATURE = 1e-9
RAINFLOW = 0.15  # scatter of one record of 1e5 cycles at k = 4, and the methods' own error

SPECTRA = {
    "flat": ([10, 300], [1.0, 1.0]),
    "low-pass": ([0.1, 100], [1.0, 1.0]),
    "two modes": ([10, 12, 12, 90, 90, 100], [10.0, 10.0, 1e-6, 1e-6, 1.0, 1.0]),
    "falling": ([5, 500], [1.0, 1e-4]),
}

spectra = st.builds(
    lambda ratio, rise: spectral_moments([10.0, 10.0 * ratio], [1.0, rise]),
    st.floats(1.5, 100),
    st.floats(1e-4, 10),
)


def rainflow_amplitudes(signal):
    """Amplitudes of closed cycles and of the residue's half cycles: (amplitude, count)."""
    turning = np.flatnonzero(np.diff(np.sign(np.diff(signal)))) + 1
    full, stack = [], []
    for value in signal[turning].tolist():
        stack.append(value)
        while len(stack) >= 4:
            a, b, c, d = stack[-4:]
            if not (min(a, d) <= min(b, c) and max(b, c) <= max(a, d)):
                break
            full.append(abs(b - c) / 2)
            del stack[-3:-1]
    return np.array(full), np.abs(np.diff(stack)) / 2


def record(frequency, level, *, seed, count=2**19):
    """Give a Gaussian record of a profile: random phases and amplitudes, 16 points per period."""
    from flexcli.formulas.spectrum import spectral_level

    rate = 16 * frequency[-1]
    f = np.fft.rfftfreq(count, 1 / rate)
    g = spectral_level(np.maximum(f, 1e-300), frequency, level)
    random = np.random.default_rng(seed)
    size = np.sqrt(g * rate * count / 4)
    phases = random.standard_normal((2, f.size))
    return np.fft.irfft(size * (phases[0] + 1j * phases[1]), count), count / rate


def test_docstring_examples_run():
    assert doctest.testmod(module).failed == 0


def test_bandwidth_of_ideal_low_pass_noise():
    # α_1 = √3/2, α_2 = √5/3 (Lutes and Sarkani 2004, section 4)
    moments = spectral_moments([1e-9, 1.0], [1.0, 1.0])
    assert float(moments.alpha1) == pytest.approx(np.sqrt(3) / 2, rel=1e-8)
    assert float(moments.alpha2) == pytest.approx(np.sqrt(5) / 3, rel=1e-8)


def test_narrow_band_damage_is_the_rayleigh_integral():
    moments, k, C = spectral_moments(*SPECTRA["flat"]), 5.3, 1e9
    sigma = float(np.sqrt(moments.m0))
    integral = quad(lambda a: a**k * float(rayleigh_density(a, sigma)), 0, 40 * sigma)[0]
    assert float(narrow_band_damage_rate(moments, k, C)) == pytest.approx(
        float(moments.crossing_rate) * integral / C, rel=QUADRATURE
    )


def test_steinberg_counts_three_bands_as_printed():
    moments = Moments(4.0, 400.0, 4e4, 4e8)
    by_hand = 100.0 * (0.683 * 2**6.4 + 0.271 * 4**6.4 + 0.0433 * 6**6.4) / 1e12
    assert float(steinberg_damage_rate(moments, 6.4, 1e12)) == pytest.approx(by_hand, rel=ROUNDING)


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


@given(moments=spectra)
@settings(deadline=None, max_examples=40)
def test_tovo_benasciutti_closed_form_is_the_one_printed(moments):
    k = 4.2
    a1, a2 = float(moments.alpha1), float(moments.alpha2)
    b = (
        (a1 - a2)
        * (1.112 * (1 + a1 * a2 - (a1 + a2)) * np.exp(2.11 * a2) + (a1 - a2))
        / (a2 - 1) ** 2
    )
    factor = tovo_benasciutti_damage_rate(moments, k, 1.0) / narrow_band_damage_rate(
        moments, k, 1.0
    )
    assert float(factor) == pytest.approx(b + (1 - b) * a2 ** (k - 1), rel=ROUNDING)


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
    # with the knee as endurance limit only the first term is left
    limited = curve_damage_rate(
        lambda a: rayleigh_density(a, sigma), rate, points, scale=sigma, endurance=knee
    )
    assert limited == pytest.approx(rate / N * above / knee**k1, rel=1e-11)


# not "falling": its record has too few of the large cycles that do the damage
@pytest.mark.parametrize("spectrum", ["flat", "low-pass", "two modes"])
def test_rainflow_of_a_record_agrees_with_dirlik_and_tovo_benasciutti(spectrum):
    frequency, level = SPECTRA[spectrum]
    signal, time = record(frequency, level, seed=2024)
    moments, k = spectral_moments(frequency, level), 4.0
    assert signal.std() == pytest.approx(float(np.sqrt(moments.m0)), rel=0.02)
    full, half = rainflow_amplitudes(signal)
    counted = ((full**k).sum() + 0.5 * (half**k).sum()) / time
    for method in (dirlik_damage_rate, tovo_benasciutti_damage_rate):
        assert float(method(moments, k, 1.0)) == pytest.approx(counted, rel=RAINFLOW)
    # Rychlik's bound, but for the record's scatter
    assert counted <= float(narrow_band_damage_rate(moments, k, 1.0)) * (1 + 0.05)


def test_wirsching_light_lies_below_the_narrow_band_rate():
    for frequency, level in SPECTRA.values():
        moments = spectral_moments(frequency, level)
        assert wirsching_light_damage_rate(moments, 4, 1.0) < narrow_band_damage_rate(
            moments, 4, 1.0
        )


@pytest.mark.parametrize(("name", "method"), METHODS)
def test_the_unit_of_stress_scales_out(name, method):
    moments, k = spectral_moments(*SPECTRA["flat"]), 6.4
    in_pascal = moments.scaled(1e6)
    assert float(method(in_pascal, k, 1e20 * 1e6**k)) == pytest.approx(
        float(method(moments, k, 1e20)), rel=ROUNDING
    )


@pytest.mark.parametrize(("name", "method"), METHODS)
def test_methods_broadcast_over_designs_and_exponents(name, method):
    moments = spectral_moments(*SPECTRA["flat"]).scaled(np.array([[1.0], [2.0], [3.0]]))
    rates = method(moments, np.array([3.0, 8.0]), 1.0)
    assert rates.shape == (3, 2)
    np.testing.assert_allclose(rates[1] / rates[0], [2.0**3, 2.0**8], rtol=ROUNDING)


def test_goodman_scales_the_amplitude_and_compression_earns_nothing():
    moments, k = spectral_moments(*SPECTRA["flat"]), 5.0
    rate = narrow_band_damage_rate(moments, k, 1.0)
    loaded = narrow_band_damage_rate(moments.scaled(goodman_factor(450e6, 900e6)), k, 1.0)
    assert float(loaded / rate) == pytest.approx(2**k, rel=ROUNDING)
    assert goodman_factor([-1e6, -1e9], 900e6).tolist() == [1.0, 1.0]


def test_life_is_the_inverse_of_the_damage_rate():
    assert life([0.0, 0.5], critical_damage=0.7).tolist() == [np.inf, 1.4]


def test_spread_names_the_extremes():
    found = spread({"b": 3.0, "a": 1.5, "c": 2.0})
    assert (found.least_name, found.greatest_name, found.ratio) == ("a", "b", 2.0)
    assert spread({"a": 0.0, "b": 1.0}).ratio == np.inf


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: Moments(1.0, 2.0, 1.0, 1.0), "no spectrum"),
        (lambda: Moments(1.0, 0.5, 1.0, 1.0), "no spectrum"),
        (lambda: Moments(1.0, 1.0, 0.0, 1.0), "m2 must be positive"),
        (lambda: spectral_moments([100], [1.0]), "m0 must be positive"),
        (lambda: narrow_band_damage_rate(Moments(1, 1, 1, 1), -1, 1), "exponent"),
        (lambda: narrow_band_damage_rate(Moments(1, 1, 1, 1), 3, 0), "constant"),
        (lambda: dirlik_density(1.0, Moments(1, 1, 1, 1)), "rayleigh_density"),
        (lambda: goodman_factor(9e8, 9e8), "reaches"),
        (lambda: goodman_factor(9e8, 0), "tensile strength must be positive"),
        (lambda: life(-1.0), "negative"),
        (lambda: spread({}), "at least one"),
        (lambda: curve_damage_rate(abs, 1.0, ((1, 1),), scale=1.0), "two points"),
        (lambda: curve_damage_rate(abs, 1.0, ((1, 1), (2, 1)), scale=1.0), "falls"),
        (lambda: curve_damage_rate(abs, 0.0, ((1, 2), (2, 1)), scale=1.0), "rate and scale"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
