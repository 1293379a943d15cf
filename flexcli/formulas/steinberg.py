"""Steinberg's three-band damage rate of a Gaussian stress; stress as an amplitude."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import basquin
from flexcli.formulas.spectral_moments import Moments

__all__ = ["STEINBERG", "steinberg_damage_rate"]

Floats = NDArray[np.float64]
# Steinberg's shares of the time at 1σ, 2σ and 3σ, as printed by him.
STEINBERG = ((1, 0.683), (2, 0.271), (3, 0.0433))


def steinberg_damage_rate(moments: Moments, k: ArrayLike, C: ArrayLike) -> Floats:
    """Give the damage rate of Steinberg's three bands: 68.3 % at 1σ, 27.1 % at 2σ, 4.33 % at 3σ.

    d = ν_0/C · σ^k · (0.683 + 0.271 · 2^k + 0.0433 · 3^k)

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
    A three-point stand-in for the Rayleigh amplitude, with shares that sum to 0.9974. Over the
    narrow-band value it is 1.07 at k = 3, 1.03 at k = 6, 0.92 at k = 8; for steep curves it is
    UNSAFE, since amplitudes above 3σ are missing: 0.74 at k = 10, 0.25 at k = 15.

    Examples
    --------
    >>> m = Moments(1.0, 100.0, 1e4, 1e8)
    >>> round(float(steinberg_damage_rate(m, 4, 1e6)), 6)
    0.000853

    References
    ----------
    Steinberg 2000, Vibration Analysis for Electronic Equipment, 3rd ed., section 9.
    """
    exponent, constant = basquin(k, C)
    bands: Floats = np.sum(
        [share * np.power(float(sigma), exponent) for sigma, share in STEINBERG], axis=0
    )
    rate: Floats = moments.crossing_rate / constant * moments.m0 ** (exponent / 2) * bands
    return rate
