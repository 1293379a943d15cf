"""Fatigue of a blade: strength as a stress amplitude at a life, and corrections for mean stress.

Every stress here is an amplitude (half of the range).
"""

from itertools import pairwise
from math import exp, log

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.quantity import Computed, Quantity

__all__ = [
    "amplitude_at_life",
    "fully_reversed_amplitude",
    "goodman_amplitude",
    "goodman_factor",
    "swt_amplitude_squared",
    "swt_reversed_amplitude",
]

Floats = NDArray[np.float64]


def amplitude_at_life(points: tuple[tuple[float, float], ...], cycles: float) -> float:
    """Return the stress amplitude that an S-N curve of straight log-log lines bears for a life.

    Parameters
    ----------
    points : tuple of (float, float)
        Cycles [-], rising, and amplitude [Pa].
    cycles : float
        Asked number of cycles [-], inside the curve.

    Returns
    -------
    float
        Amplitude [Pa].

    Raises
    ------
    ValueError
        Outside the curve: a life is never extrapolated.

    Examples
    --------
    >>> round(amplitude_at_life(((1e3, 800.0), (1e7, 200.0)), 1e5), 9)
    400.0

    """
    if not points[0][0] <= cycles <= points[-1][0]:
        raise ValueError(f"{cycles:g} cycles are outside {points[0][0]:g} to {points[-1][0]:g}")
    if cycles == points[0][0]:
        return points[0][1]
    for (n1, s1), (n2, s2) in pairwise(points):
        if cycles <= n2:
            share = log(cycles / n1) / log(n2 / n1)
            return s2 if cycles == n2 else exp(log(s1) + share * log(s2 / s1))
    raise AssertionError("unreachable: the life is inside the curve")


def fully_reversed_amplitude(
    amplitude: float, stress_ratio: float, tensile_strength: float
) -> float:
    """Return the fully reversed amplitude that does the damage of one at another stress ratio.

    ``σ_ar = σ_a / (1 − σ_m/R_m)`` with ``σ_m = σ_a (1 + R)/(1 − R)`` (Goodman).

    Parameters
    ----------
    amplitude : float
        Strength as an amplitude [Pa] at the stress ratio R.
    stress_ratio : float
        R = σ_min/σ_max, −1 ≤ R < 1.
    tensile_strength : float
        R_m [Pa].

    Raises
    ------
    ValueError
        When the mean stress reaches R_m, where the correction has no meaning.

    Examples
    --------
    >>> fully_reversed_amplitude(300.0, -1.0, 900.0)
    300.0
    >>> round(fully_reversed_amplitude(300.0, 0.0, 900.0), 9)
    450.0

    References
    ----------
    Dowling, N. E. (2013), Mechanical Behavior of Materials, 4th ed., section 9.7.

    """
    mean = _mean_at(amplitude, stress_ratio)
    if mean >= tensile_strength:
        raise ValueError("the mean stress of this fatigue strength reaches the tensile strength")
    return amplitude / (1.0 - mean / tensile_strength)


def swt_reversed_amplitude(amplitude: float, stress_ratio: float) -> float:
    """Return the fully reversed amplitude that does the damage of one at another stress ratio.

    ``σ_ar = √(σ_max σ_a) = σ_a √(2/(1 − R))`` (Smith, Watson & Topper).

    Parameters
    ----------
    amplitude : float
        Strength as an amplitude [Pa] at the stress ratio R.
    stress_ratio : float
        R = σ_min/σ_max, −1 ≤ R < 1.

    Examples
    --------
    >>> swt_reversed_amplitude(300.0, -1.0)
    300.0
    >>> round(swt_reversed_amplitude(300.0, 0.5), 9)
    600.0

    References
    ----------
    Dowling, N. E. (2013), Mechanical Behavior of Materials, 4th ed., section 9.7.

    """
    mean = _mean_at(amplitude, stress_ratio)
    return float(np.sqrt(swt_amplitude_squared(amplitude=amplitude, mean=mean)))


def _mean_at(amplitude: float, stress_ratio: float) -> float:
    return amplitude * (1.0 + stress_ratio) / (1.0 - stress_ratio)


def goodman_amplitude(
    *, amplitude: Quantity, mean: Quantity, reversed_strength: float, limit: float
) -> Computed:
    """Return the fully reversed amplitude equal in damage, for loads that grow in proportion.

    ``σ_a + σ_m σ_D/L``: comparing it with the strength σ_D gives the factor
    1/(σ_a/σ_D + σ_m/L) by which amplitude and mean may grow together. L is R_m (Goodman) or
    R_p0.2 (Soderberg).

    Parameters
    ----------
    amplitude : Quantity
        Stress amplitude [Pa], ≥ 0.
    mean : Quantity
        Mean stress [Pa], ≥ 0; a compressive mean earns nothing here and is given as 0.
    reversed_strength : float
        σ_D: fully reversed strength at the asked life [Pa].
    limit : float
        L [Pa].

    Examples
    --------
    >>> goodman_amplitude(amplitude=100.0, mean=90.0, reversed_strength=500.0, limit=900.0)
    150.0

    References
    ----------
    Shigley, Mechanical Engineering Design, 10th ed., equations (6-45) and (6-46).

    """
    return amplitude + mean * (reversed_strength / limit)


def goodman_factor(mean: ArrayLike, tensile_strength: ArrayLike) -> Floats:
    """Give the factor on a stress amplitude that stands for a mean stress (Goodman).

    a_0 = a/(1 − σ_m/R_m)

    Parameters
    ----------
    mean : array, any shape
        Mean stress σ_m, [Pa].
    tensile_strength : array that broadcasts with `mean`
        R_m, [Pa].

    Returns
    -------
    array
        Factor, at least 1, [-]; give it to `Moments.scaled`.

    Raises
    ------
    ValueError
        When R_m is not positive or the mean reaches it.

    Notes
    -----
    Compression (σ_m < 0) earns nothing: the factor is 1.

    Examples
    --------
    >>> goodman_factor([300e6, -300e6], 900e6).round(12).tolist()
    [1.5, 1.0]

    References
    ----------
    Dowling 2013, Mechanical Behavior of Materials, 4th ed., section 9.7.
    """
    strength = np.asarray(tensile_strength, dtype=np.float64)
    tension = np.maximum(np.asarray(mean, dtype=np.float64), 0.0)
    if not (strength > 0).all():
        raise ValueError(f"the tensile strength must be positive, got {strength}")
    if not (tension < strength).all():
        raise ValueError(f"the mean stress {tension} reaches the tensile strength {strength}")
    factor: Floats = 1 / (1 - tension / strength)
    return factor


def swt_amplitude_squared(*, amplitude: Quantity, mean: Quantity) -> Computed:
    """Return the square of Smith, Watson and Topper's equivalent amplitude, (σ_a + σ_m) σ_a.

    Parameters
    ----------
    amplitude : Quantity
        Stress amplitude [Pa], ≥ 0.
    mean : Quantity
        Mean stress [Pa], ≥ 0.

    Examples
    --------
    >>> swt_amplitude_squared(amplitude=100.0, mean=300.0)
    40000.0

    References
    ----------
    Smith, Watson & Topper (1970), Journal of Materials 5, 767-778.

    """
    return (amplitude + mean) * amplitude
