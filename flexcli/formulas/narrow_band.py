"""Damage rate of a narrow-band Gaussian stress, whose amplitudes follow Rayleigh's density.

Stress is an AMPLITUDE everywhere, never a range: half of peak to valley. A life curve is
N = C · a^(−k) in that amplitude a. Damage follows Palmgren and Miner: one cycle of amplitude a
does 1/N(a).
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import basquin
from flexcli.formulas.spectral_moments import Moments
from flexcli.numerics.gamma import gamma

__all__ = ["narrow_band_damage_rate", "rayleigh_density"]

Floats = NDArray[np.float64]


def narrow_band_damage_rate(moments: Moments, k: ArrayLike, C: ArrayLike) -> Floats:
    """Give the damage rate when each zero crossing is a cycle with a Rayleigh amplitude.

    d = ν_0/C · (sqrt(2 m_0))^k · Γ(1 + k/2)

    Parameters
    ----------
    moments : Moments
        Of the stress, [Pa² Hz^n].
    k : array
        Exponent of the life curve N = C a^(−k), [-].
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
    Exact for a single mode of high Q; an upper bound of rainflow damage for any bandwidth.

    Examples
    --------
    >>> m = Moments(1.0, 100.0, 1e4, 1e8)
    >>> round(float(narrow_band_damage_rate(m, 4, 1e6)), 12)
    0.0008

    References
    ----------
    Bendat 1964, Probability Functions for Random Responses, NASA CR-33; Rychlik 1993,
    Probabilistic Engineering Mechanics 8, 1–4 (the bound).
    """
    exponent, constant = basquin(k, C)
    rate: Floats = (
        moments.crossing_rate
        / constant
        * (2 * moments.m0) ** (exponent / 2)
        * gamma(1 + exponent / 2)
    )
    return rate


def rayleigh_density(amplitude: ArrayLike, sigma: ArrayLike) -> Floats:
    """Give the density of the amplitude of a narrow-band Gaussian stress.

    p(a) = a/σ² · exp(−a²/(2σ²))

    Parameters
    ----------
    amplitude : array, any shape
        Stress AMPLITUDE, [Pa].
    sigma : array that broadcasts with `amplitude`
        Root mean square, [Pa].

    Returns
    -------
    array
        Density, [1/Pa]; with cycles at the rate ν_0.

    Examples
    --------
    >>> round(float(rayleigh_density(1.0, 1.0)), 4)
    0.6065
    """
    width = np.asarray(sigma, dtype=np.float64)
    z = np.asarray(amplitude, dtype=np.float64) / width
    density: Floats = z * np.exp(-0.5 * z**2) / width
    return density
