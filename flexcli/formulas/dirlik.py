"""Dirlik's rainflow amplitudes of a wide-band Gaussian stress: density and damage rate."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import basquin
from flexcli.formulas.spectral_moments import Moments
from flexcli.numerics.gamma import gamma

__all__ = ["dirlik_damage_rate", "dirlik_density", "is_single_frequency"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class _Dirlik:
    """Weights and scales of Dirlik's density, with `excess` = D_2 (1 − R)."""

    D1: Floats
    Q: Floats
    R: Floats
    excess: Floats


def _dirlik(moments: Moments) -> _Dirlik:
    # D_2 (1 − R) = 1 − γ − D_1 + D_1² by their definitions, so that the printed
    # Q = 1.25 (γ − D_3 − D_2 R)/D_1 is 1.25 D_1 exactly, without 0/0 as γ → 1.
    gamma = moments.alpha2
    mean_ratio = np.maximum(moments.alpha1, gamma) * gamma  # x_m = m_1/m_0 · sqrt(m_2/m_4)
    D1 = 2 * (mean_ratio - gamma**2) / (1 + gamma**2)
    excess = 1 - gamma - D1 + D1**2
    gone = np.abs(excess) < 1e-15
    # for a single frequency R → 1 and D_2, D_3 are one Rayleigh part
    R = np.where(gone, 1.0, (gamma - mean_ratio - D1**2) / np.where(gone, 1.0, excess))
    return _Dirlik(D1, 1.25 * D1, R, excess)


def dirlik_damage_rate(moments: Moments, k: ArrayLike, C: ArrayLike) -> Floats:
    """Give the damage rate from Dirlik's fit to rainflow amplitudes.

    d = ν_p/C · m_0^(k/2) [D_1 Q^k Γ(1 + k) + 2^(k/2) Γ(1 + k/2)(D_2 |R|^k + D_3)]

    Parameters
    ----------
    moments : Moments
        Of the stress, [Pa² Hz^n].
    k : array
        Exponent of the life curve, [-].
    C : array
        Its constant for stress AMPLITUDE, [Pa^k].

    Returns
    -------
    array
        Damage per second, [1/s].

    Raises
    ------
    ValueError
        When k or C is not positive.

    Notes
    -----
    Dirlik's variable is Z = range/(2 sqrt(m_0)) = amplitude/sqrt(m_0), see `dirlik_density`.
    With a life curve in range the factor (2 sqrt(m_0))^k stands instead of m_0^(k/2); mixing
    the two is an error of 2^k in life. Evaluated as
    D_2 |R|^k + D_3 = 1 − D_1 − D_2(1 − R) · (|R|^k − 1)/(R − 1), regular for a single frequency.

    Against rainflow counts of generated records (tests/benchmarks/spectral_fatigue.py) it gives
    0.92 to 1.0 of the damage for one band, but 0.67 for two bands far apart or a falling
    spectrum with a steep curve (k = 8): keep a factor on life, and mind the spread of methods.

    Examples
    --------
    >>> m = Moments(1.0, 100.0, 1e4, 1e8)
    >>> round(float(dirlik_damage_rate(m, 4, 1e6)), 12)
    0.0008

    References
    ----------
    Dirlik 1985, Application of Computers in Fatigue Analysis, PhD thesis, University of
    Warwick.
    """
    exponent, constant = basquin(k, C)
    fit = _dirlik(moments)
    step = fit.R - 1
    near = np.abs(step) < 1e-3
    # |R|^k − 1 without cancellation where R is near 1; the limit of the quotient is k
    power = np.where(
        near,
        np.expm1(exponent * np.log1p(np.where(near, step, 0.0))),
        np.abs(fit.R) ** exponent - 1,
    )
    quotient = np.where(step == 0, exponent, power / np.where(step == 0, 1.0, step))
    rayleigh = 1 - fit.D1 - fit.excess * quotient
    body = fit.D1 * fit.Q**exponent * gamma(1 + exponent) + 2 ** (exponent / 2) * rayleigh * (
        gamma(1 + exponent / 2)
    )
    rate: Floats = moments.peak_rate / constant * moments.m0 ** (exponent / 2) * body
    return rate


def is_single_frequency(moments: Moments) -> bool:
    """Return whether any of the stresses has no width: then the parts of the fit merge."""
    fit = _dirlik(moments)
    return not ((np.abs(fit.R - 1) > 0).all() and (fit.D1 > 0).all())


def dirlik_density(amplitude: ArrayLike, moments: Moments) -> Floats:
    """Give Dirlik's density of rainflow amplitude.

    p(a) = [D_1/Q e^(−Z/Q) + D_2 Z/R² e^(−Z²/(2R²)) + D_3 Z e^(−Z²/2)]/sqrt(m_0),
    Z = a/sqrt(m_0)

    Parameters
    ----------
    amplitude : array, any shape
        Stress AMPLITUDE, [Pa].
    moments : Moments
        Scalar moments of the stress, 0 < α_2 < 1, [Pa² Hz^n].

    Returns
    -------
    array
        Density, [1/Pa]; with cycles at the rate of peaks ν_p.

    Raises
    ------
    ValueError
        For a single frequency (α_2 = 1), where the parts of the fit merge: use
        `rayleigh_density`.

    Notes
    -----
    Each part integrates to its weight over 0 < a < ∞ and D_1 + D_2 + D_3 = 1, so p is a
    density in a when Z = a/sqrt(m_0). As α_2 → 1, D_1 → 0 and R → 1 and p → Z e^(−Z²/2)/sqrt(m_0),
    the Rayleigh density of the amplitude (not the range) of a narrow-band stress.

    Examples
    --------
    >>> m = Moments(100.0, 1e4, 2e6, 2e11)
    >>> a = np.linspace(0, 100, 200001)
    >>> round(float(np.sum(dirlik_density(a, m)) * 100 / 200000), 3)
    1.0

    References
    ----------
    Dirlik 1985, Application of Computers in Fatigue Analysis, PhD thesis, University of
    Warwick.
    """
    fit = _dirlik(moments)
    if is_single_frequency(moments):
        raise ValueError("a single frequency has no Dirlik density: use rayleigh_density")
    sigma = np.sqrt(moments.m0)
    z = np.asarray(amplitude, dtype=np.float64) / sigma
    D2 = fit.excess / (1 - fit.R)
    exponential = fit.D1 / fit.Q * np.exp(-z / fit.Q)
    narrow = D2 * z / fit.R**2 * np.exp(-0.5 * (z / fit.R) ** 2)
    wide = (1 - fit.D1 - D2) * z * np.exp(-0.5 * z**2)
    density: Floats = (exponential + narrow + wide) / sigma
    return density
