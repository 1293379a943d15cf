"""Shock response spectra given by a table."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.spectrum import checked_profile, spectral_level

__all__ = ["srs_level"]

Floats = NDArray[np.float64]


def srs_level(fn: ArrayLike, frequency: ArrayLike, level: ArrayLike) -> Floats:
    """Interpolate a shock response spectrum given by a table, in log-log axes.

    S(f) = S_1 (f/f_1)^m, m = ln(S_2/S_1)/ln(f_2/f_1)

    Parameters
    ----------
    fn : array, any shape
        Natural frequency, [Hz].
    frequency : array, shape (n,)
        Breakpoints, non-decreasing, [Hz].
    level : array, shape (n,)
        Peak acceleration of an oscillator of that frequency, [m/s²].

    Returns
    -------
    array
        Peak acceleration; at a step the greater, [m/s²].

    Raises
    ------
    ValueError
        When the table is not sound, or `fn` lies outside it: a shock response spectrum is not
        zero there, it is unknown.

    Examples
    --------
    >>> round(float(srs_level(1000.0, [100, 10000], [20.0, 2000.0])), 9)
    200.0
    """
    f, s = checked_profile(frequency, level)
    (asked,) = positive(fn=fn)
    if asked.size and not (asked.min() >= f[0] and asked.max() <= f[-1]):
        raise ValueError(
            f"the table spans {f[0]:g} to {f[-1]:g} Hz, asked {asked.min():g} to {asked.max():g} Hz"
        )
    return spectral_level(asked, f, s, side="upper")
