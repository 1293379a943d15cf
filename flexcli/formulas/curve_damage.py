"""Damage rate of any density of stress amplitude on a life curve of straight log-log lines.

Stress is an AMPLITUDE everywhere, never a range: half of peak to valley.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.quadrature import gauss_rule

__all__ = ["curve_damage_rate", "cycles_on_curve", "damage_of_a_cycle"]

Floats = NDArray[np.float64]
# Amplitudes from 1e-6 to 60 scales, panels growing by half: a^k p(a) is then smooth on each.
_SMALLEST, _GREATEST, _GROWTH, _NODES = 1e-6, 60.0, 1.5, 16


def curve_damage_rate(
    density: Callable[[Floats], Floats],
    cycle_rate: float,
    points: tuple[tuple[float, float], ...],
    *,
    scale: float,
) -> float:
    """Give the damage rate of any amplitude density on a life curve of straight log-log lines.

    d = ν ∫ p(a)/N(a) da over all amplitudes

    Parameters
    ----------
    density : callable
        p(a) of the stress AMPLITUDE, array [Pa] → array [1/Pa].
    cycle_rate : float
        Cycles per second ν to which the density belongs: ν_0 for Rayleigh, ν_p for Dirlik and
        Tovo–Benasciutti, [Hz].
    points : tuple of (float, float)
        The life curve, two points or more: cycles rising [-], AMPLITUDE falling [Pa]. The
        first and last lines go on beyond their points.
    scale : float
        Size of the amplitudes, such as the root mean square, [Pa].

    Returns
    -------
    float
        Damage per second, [1/s].

    Raises
    ------
    ValueError
        When the curve does not fall, or the rate or the scale is not positive.

    Notes
    -----
    Integrated from 1e-6 to 60 scales on Gauss panels that end at the points of the curve:
    relative error about 1e-12 for the densities of Rayleigh, Dirlik and Tovo–Benasciutti and
    slopes k from 1 to 30. The
    first line extended upwards gives no static limit: check yield apart.

    Examples
    --------
    >>> from flexcli.formulas.narrow_band import rayleigh_density
    >>> d = curve_damage_rate(lambda a: rayleigh_density(a, 1.0), 100.0,
    ...                       ((1e2, 10.0), (1e6, 1.0)), scale=1.0)
    >>> round(d, 12)
    0.0008
    """
    if not (np.isfinite(cycle_rate) and cycle_rate > 0 and np.isfinite(scale) and scale > 0):
        raise ValueError(f"rate and scale must be positive, got {cycle_rate} and {scale}")
    corners = np.exp(_logarithms(points)[1][1:-1])
    low, high = scale * _SMALLEST, scale * _GREATEST
    count = int(np.ceil(np.log(high / low) / np.log(_GROWTH))) + 1
    edges = np.concatenate([np.geomspace(low, high, count), corners])
    edges = np.unique(np.clip(edges, low, high))
    return cycle_rate * damage_of_a_cycle(density, edges, points)


def damage_of_a_cycle(
    density: Callable[[Floats], Floats], edges: Floats, points: tuple[tuple[float, float], ...]
) -> float:
    """Give the mean damage of a cycle, ``∫ p(a)/N(a) da``, by Gauss's rule between edges.

    Parameters
    ----------
    density : callable
        p(a) of the stress AMPLITUDE, array [Pa] → array [1/Pa].
    edges : array, shape (n,)
        Amplitudes, rising, between which p(a)/N(a) is smooth: 16 nodes each, [Pa].
    points : tuple of (float, float)
        The life curve, two points or more: cycles rising [-], AMPLITUDE falling [Pa].

    Returns
    -------
    float
        [-].

    Raises
    ------
    ValueError
        When the curve does not fall.

    Examples
    --------
    >>> even = np.array([1.0, 2.0])
    >>> round(damage_of_a_cycle(np.ones_like, even, ((1e2, 10.0), (1e6, 1.0))) * 1e6, 6)
    6.2
    """
    x, w = gauss_rule(_NODES)
    amplitude = edges[:-1, None] + np.diff(edges)[:, None] * x
    damage = (density(amplitude) / cycles_on_curve(amplitude, points)) @ w
    return float(damage @ np.diff(edges))


def cycles_on_curve(amplitude: float | Floats, points: tuple[tuple[float, float], ...]) -> Floats:
    """Return the cycles to failure at stress amplitudes, on straight log-log lines.

    Parameters
    ----------
    amplitude : array
        Stress AMPLITUDE, [Pa].
    points : tuple of (float, float)
        The life curve, two points or more: cycles rising [-], AMPLITUDE falling [Pa]. The
        first and last lines go on beyond their points.

    Returns
    -------
    array
        Cycles, [-].

    Raises
    ------
    ValueError
        When the curve does not fall.

    Examples
    --------
    >>> [round(float(n), 6) for n in cycles_on_curve([10.0, 1.0], ((1e2, 10.0), (1e6, 1.0)))]
    [100.0, 1000000.0]
    """
    log_n, log_a = _logarithms(points)
    a = np.log(np.asarray(amplitude, dtype=np.float64))
    # the line of each amplitude; the outer two are extended
    line = (log_a[1:-1] > a[..., None]).sum(axis=-1)
    slope = np.diff(log_n) / np.diff(log_a)
    return np.asarray(np.exp(log_n[line] + slope[line] * (a - log_a[line])))


def _logarithms(points: tuple[tuple[float, float], ...]) -> tuple[Floats, Floats]:
    """Return the logarithms of cycles and amplitudes, or raise where they are no life curve."""
    curve = np.array(points, dtype=np.float64)
    if curve.ndim != 2 or curve.shape[0] < 2 or not (np.isfinite(curve).all() and curve.min() > 0):
        raise ValueError("a life curve needs two points or more, positive and finite")
    log_n, log_a = np.log(curve.T)
    if not ((np.diff(log_n) > 0).all() and (np.diff(log_a) < 0).all()):
        raise ValueError("along a life curve, cycles rise and amplitude falls")
    return log_n, log_a
