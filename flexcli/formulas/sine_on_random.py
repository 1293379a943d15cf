"""Damage of a sine on a narrow-band Gaussian stress: amplitudes by Rice's law.

Stress is an AMPLITUDE everywhere, never a range: half of peak to valley.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.curve_damage import cycles_on_curve, damage_of_a_cycle

__all__ = ["rice_damage_rate", "rice_density"]

Floats = NDArray[np.float64]

REACH = 40.0
"""Root mean squares beyond the sine's amplitude up to which damage is counted."""


def rice_density(amplitude: ArrayLike, sigma: ArrayLike, sine: ArrayLike) -> Floats:
    """Give the density of the envelope of a sine on a narrow-band Gaussian stress.

    ``p(a) = a/σ² exp(−(a² + A²)/(2σ²)) I_0(a A/σ²)``

    Parameters
    ----------
    amplitude : array
        Stress AMPLITUDE a, [Pa].
    sigma : array that broadcasts with `amplitude`
        Root mean square of the Gaussian part, [Pa].
    sine : array that broadcasts with both
        Amplitude A of the sine, [Pa].

    Returns
    -------
    array
        Density, [1/Pa]; Rayleigh's where there is no sine.

    Notes
    -----
    The frequency of the sine lies within the narrow band of the Gaussian part.

    Examples
    --------
    >>> round(float(rice_density(1.0, 1.0, 0.0)), 4)
    0.6065

    References
    ----------
    Rice (1945), Mathematical Analysis of Random Noise, Bell System Technical Journal 24,
    section 3.10.
    """
    from scipy.special import i0e  # seldom wanted, and slow to import

    s = np.asarray(sigma, dtype=np.float64)
    z, u = np.asarray(amplitude) / s, np.asarray(sine) / s
    return np.asarray(z / s * np.exp(-0.5 * (z - u) ** 2) * i0e(z * u))


def rice_damage_rate(
    sigma: float, sine: float, cycle_rate: float, points: tuple[tuple[float, float], ...]
) -> float:
    """Give the damage rate of a sine on a Gaussian stress, on a life curve of log-log lines.

    ``d = ν ∫ p(a)/N(a) da`` with Rice's density of the envelope.

    Parameters
    ----------
    sigma : float
        Root mean square of the Gaussian part, 0 for a sine alone, [Pa].
    sine : float
        Amplitude of the sine, of several the sum of all, [Pa].
    cycle_rate : float
        Cycles per second ν: the greater of the sine's frequency and the Gaussian part's rate of
        zero crossings, [Hz].
    points : tuple of (float, float)
        The life curve, two points or more: cycles rising [-], AMPLITUDE falling [Pa].

    Returns
    -------
    float
        Damage per second, [1/s].

    Raises
    ------
    ValueError
        When the curve does not fall.

    Notes
    -----
    Exact where sine and narrow band have one frequency. Elsewhere it is on the safe side: all
    cycles then count as if each had both parts, at the higher rate of the two.

    Examples
    --------
    >>> curve = ((1e2, 10.0), (1e6, 1.0))
    >>> round(rice_damage_rate(0.0, 1.0, 100.0, curve) * 1e6, 6)
    100.0
    >>> round(rice_damage_rate(1.0, 0.0, 100.0, curve), 12)
    0.0008
    """
    if sigma == 0.0:
        return cycle_rate / float(cycles_on_curve(sine, points))
    steps = np.concatenate([np.arange(-12.0, 12.0, 0.5), np.arange(12.0, REACH + 1.0)])
    corners = np.array([amplitude for _, amplitude in points[1:-1]])
    edges = np.concatenate([sine + sigma * steps, sigma * np.geomspace(1e-6, 1.0, 35), corners])
    most = sine + REACH * sigma
    edges = np.unique(np.clip(edges, 1e-6 * sigma, most))
    return cycle_rate * damage_of_a_cycle(lambda a: rice_density(a, sigma, sine), edges, points)
