"""Peaks of a Gaussian signal over its root mean square: how high, how often, how likely."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive

__all__ = [
    "MINIMUM_CYCLES",
    "davenport_peak_factor",
    "peak_factor",
]

Floats = NDArray[np.float64]

MINIMUM_CYCLES = 10.0
"""Below some ten cycles the asymptotic peak factors lose meaning (Davenport 1964)."""

_EULER_GAMMA = 0.5772156649015329


def _more_than_one_cycle(f0: ArrayLike, T: ArrayLike) -> Floats:
    rate, time = positive(f0=f0, T=T)
    cycles: Floats = rate * time
    if not (cycles > 1).all():
        raise ValueError(
            f"a peak factor needs more than one cycle, and about {MINIMUM_CYCLES:g} to mean "
            f"much: f0·T = {cycles.min():g}"
        )
    return cycles


def peak_factor(f0: ArrayLike, T: ArrayLike) -> Floats:
    """Give the most probable greatest peak of a narrow-band Gaussian signal over its rms.

    c = sqrt(2 ln(f_0 T)): the level crossed upwards once, on average, in the time T.

    Parameters
    ----------
    f0 : array, any shape
        Rate of upward zero crossings, the natural frequency for a lightly damped one, [Hz].
    T : array that broadcasts with `f0`
        Duration, [s].

    Returns
    -------
    array
        Peak over root mean square, [-].

    Raises
    ------
    ValueError
        When f_0 T is not above 1.

    Notes
    -----
    Asymptotic: use from f_0 T = `MINIMUM_CYCLES` on. 3σ is reached at f_0 T = e^4.5 = 90.

    Examples
    --------
    >>> round(float(peak_factor(200, 60)), 2)
    4.33

    References
    ----------
    Rice 1945, Bell System Technical Journal 24, 46–156; Davenport 1964, Proc. Institution of
    Civil Engineers 28, 187–196, DOI 10.1680/iicep.1964.10112.
    """
    factor: Floats = np.sqrt(2 * np.log(_more_than_one_cycle(f0, T)))
    return factor


def davenport_peak_factor(f0: ArrayLike, T: ArrayLike) -> Floats:
    """Give the mean greatest peak of a Gaussian signal over its rms.

    c + γ/c with c = sqrt(2 ln(f_0 T)) and Euler's γ = 0.5772.

    Parameters
    ----------
    f0 : array, any shape
        Rate of upward zero crossings, [Hz].
    T : array that broadcasts with `f0`
        Duration, [s].

    Returns
    -------
    array
        Mean peak over root mean square, [-].

    Raises
    ------
    ValueError
        When f_0 T is not above 1.

    Notes
    -----
    Asymptotic: use from f_0 T = `MINIMUM_CYCLES` on; it grows without bound as f_0 T → 1.

    Examples
    --------
    >>> round(float(davenport_peak_factor(200, 60)), 2)
    4.47

    References
    ----------
    Davenport 1964, Proc. Institution of Civil Engineers 28, 187–196, equation 14,
    DOI 10.1680/iicep.1964.10112.
    """
    c = peak_factor(f0, T)
    return c + _EULER_GAMMA / c
