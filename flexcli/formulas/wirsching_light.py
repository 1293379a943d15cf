"""Wirsching and Light's damage rate of a wide-band Gaussian stress; stress as an amplitude."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import basquin
from flexcli.formulas.narrow_band import narrow_band_damage_rate
from flexcli.formulas.spectral_moments import Moments

__all__ = ["wirsching_light_damage_rate"]

Floats = NDArray[np.float64]


def wirsching_light_damage_rate(moments: Moments, k: ArrayLike, C: ArrayLike) -> Floats:
    """Give the narrow-band damage rate times Wirsching and Light's rainflow factor.

    λ = a + (1 − a)(1 − ε)^b, ε = sqrt(1 − α_2²), a = 0.926 − 0.033 k, b = 1.587 k − 2.323

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
    Fitted for 3 ≤ k ≤ 6 and four shapes of spectrum. ε → 0 slowly: at 1 − α_2 = 1e-4 it is
    already 0.014.

    Examples
    --------
    >>> m = Moments(1.0, 100.0, 1e4, 1e8)
    >>> round(float(wirsching_light_damage_rate(m, 4, 1e6)), 12)
    0.0008

    References
    ----------
    Wirsching, Light 1980, J. Structural Division ASCE 106(7), 1593–1607.
    """
    exponent, _ = basquin(k, C)
    a = 0.926 - 0.033 * exponent
    b = 1.587 * exponent - 2.323
    width = np.sqrt((1 - moments.alpha2) * (1 + moments.alpha2))
    factor = a + (1 - a) * (1 - width) ** b
    return factor * narrow_band_damage_rate(moments, k, C)
