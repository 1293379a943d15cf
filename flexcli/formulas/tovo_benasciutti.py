"""Tovo and Benasciutti's rainflow amplitudes of a Gaussian stress: density and damage rate."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import basquin
from flexcli.formulas.narrow_band import narrow_band_damage_rate, rayleigh_density
from flexcli.formulas.spectral_moments import Moments

__all__ = ["tovo_benasciutti_damage_rate", "tovo_benasciutti_density"]

Floats = NDArray[np.float64]


def _tovo_benasciutti_weight(moments: Moments) -> Floats:
    """Weight b of level-crossing counting; the quotient is bounded, any value does at α_2 = 1."""
    a1, a2 = moments.alpha1, moments.alpha2
    gap = 1 - a2
    quotient = np.where(gap > 0, np.maximum(a1 - a2, 0.0) / np.where(gap > 0, gap, 1.0), 1.0)
    # 1 + α_1 α_2 − α_1 − α_2 = (1 − α_1)(1 − α_2) takes one (1 − α_2) out of the printed form
    weight: Floats = quotient * (1.112 * (1 - a1) * np.exp(2.11 * a2) + quotient)
    return weight


def tovo_benasciutti_damage_rate(moments: Moments, k: ArrayLike, C: ArrayLike) -> Floats:
    """Give the damage rate between level-crossing and range counting, after Tovo and Benasciutti.

    d = [b + (1 − b) α_2^(k−1)] d_NB,
    b = (α_1 − α_2)[1.112 (1 + α_1 α_2 − α_1 − α_2) e^(2.11 α_2) + α_1 − α_2]/(α_2 − 1)²

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
    With the approximate b of 2005. Against the rainflow counts named at `dirlik_damage_rate`:
    0.82 to 1.0 for one band, 0.67 to 1.02 for two bands far apart.

    Examples
    --------
    >>> m = Moments(1.0, 100.0, 1e4, 1e8)
    >>> round(float(tovo_benasciutti_damage_rate(m, 4, 1e6)), 12)
    0.0008

    References
    ----------
    Benasciutti, Tovo 2005, Int. J. Fatigue 27(8), 867–877,
    DOI 10.1016/j.ijfatigue.2004.10.007.
    """
    exponent, _ = basquin(k, C)
    b = _tovo_benasciutti_weight(moments)
    factor = 1 - (1 - b) * (1 - moments.alpha2 ** (exponent - 1))
    return factor * narrow_band_damage_rate(moments, k, C)


def tovo_benasciutti_density(amplitude: ArrayLike, moments: Moments) -> Floats:
    """Give Tovo and Benasciutti's density of rainflow amplitude, for amplitudes above zero.

    p(a) = b α_2 p_R(a; σ) + (1 − b) p_R(a; α_2 σ), p_R Rayleigh's density

    Parameters
    ----------
    amplitude : array, any shape
        Stress AMPLITUDE, [Pa].
    moments : Moments
        Scalar moments of the stress, [Pa² Hz^n].

    Returns
    -------
    array
        Density, [1/Pa]; with cycles at the rate of peaks ν_p. Its area is 1 − b (1 − α_2): the
        rest are level-crossing cycles of amplitude zero, which do no damage.

    Examples
    --------
    >>> m = Moments(1.0, 100.0, 2e4, 2e9)
    >>> bool(tovo_benasciutti_density(5.0, m) > 0)
    True

    References
    ----------
    Benasciutti, Tovo 2005, Int. J. Fatigue 27(8), 867–877,
    DOI 10.1016/j.ijfatigue.2004.10.007.
    """
    b = _tovo_benasciutti_weight(moments)
    sigma = np.sqrt(moments.m0)
    whole = rayleigh_density(amplitude, sigma)
    small = rayleigh_density(amplitude, moments.alpha2 * sigma)
    return b * moments.alpha2 * whole + (1 - b) * small
