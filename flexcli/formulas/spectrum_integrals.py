"""Moments of a spectral density given by breakpoints, and the rms values they make."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.spectrum import Scale, checked_profile
from flexcli.numerics.quadrature import gauss_rule

__all__ = ["rms", "rms_displacement", "rms_velocity", "spectral_moment"]

Floats = NDArray[np.float64]

# Gauss points for f^n times a straight line over less than an octave: the nearest
# singularity, f = 0, is 3 half-widths off, so the error falls as (3 + √8)^(-2·16) ~ 1e-24.
_NARROW_NODES = 16


def _growth(x: Floats) -> Floats:
    """(eˣ − 1)/x: expm1 keeps all digits as x → 0, where the limit is 1."""
    return np.divide(np.expm1(x), x, out=np.ones_like(x), where=x != 0)


def _log_segment_moments(f: Floats, g: Floats, n: Floats) -> Floats:
    """Integrate f^n G over log-log segments; taken from the greater end, so no overflow."""
    run = np.log1p(np.diff(f) / f[:-1])
    x = np.log(g[1:] / g[:-1]) + (n + 1) * run
    start, end = g[:-1] * f[:-1] ** (n + 1), g[1:] * f[1:] ** (n + 1)
    total: Floats = run * np.where(x > 0, end, start) * _growth(-np.abs(x))
    return total


def _power_integral(f1: Floats, f2: Floats, p: Floats) -> Floats:
    """∫ f^p df from f1 ≥ 0 to f2 > 0; inf where it diverges at f1 = 0."""
    from_zero = f1 == 0
    a = np.where(from_zero, 1.0, f1)
    run = np.log(f2 / a)
    x = (p + 1) * run
    greater = np.where(x > 0, f2, a) ** (p + 1)
    body = run * greater * _growth(-np.abs(x))
    q = np.where(p > -1, p + 1, 1.0)
    return np.where(from_zero, np.where(p > -1, f2**q / q, np.inf), body)


def _linear_segment_moments(f: Floats, g: Floats, n: Floats) -> Floats:
    """Integrate f^n G over straight segments of linear axes."""
    wide = np.diff(f) > 0
    f1, f2, g1, g2 = f[:-1][wide], f[1:][wide], g[:-1][wide], g[1:][wide]
    span = f2 - f1
    intercept, slope = (g1 * f2 - g2 * f1) / span, (g2 - g1) / span
    first, second = _power_integral(f1, f2, n), _power_integral(f1, f2, n + 1)
    # from 0 Hz: a level there decides on divergence, and without one its term is absent
    first = np.where(intercept == 0, 0.0, first)
    second = np.where((slope == 0) | np.isinf(first), 0.0, second)
    closed = intercept * first + slope * second
    # within an octave the two terms cancel; a Gauss rule does not
    x, w = gauss_rule(_NARROW_NODES)
    narrow = f2 < 2 * f1
    at = np.where(narrow, f1, 1.0)[:, None] + span[:, None] * x
    line = g1[:, None] + (g2 - g1)[:, None] * x
    gauss = span * ((at ** n[..., None] * line) @ w)
    return np.where(narrow, gauss, closed)


def spectral_moment(
    frequency: ArrayLike,
    level: ArrayLike,
    order: ArrayLike = 0.0,
    *,
    scale: Scale = "log",
) -> Floats:
    """Integrate f^n G(f), segment by segment, in closed form.

    m_n = ∫ f^n G df. On a log-log segment, with L = ln(f_2/f_1) and
    x = ln(G_2/G_1) + (n + 1) L, this is G_1 f_1^(n+1) L (eˣ − 1)/x, regular through x = 0
    (slope −1 for n = 0).

    Parameters
    ----------
    frequency, level : arrays, shape (k,)
        The profile, [Hz] and [x²/Hz].
    order : array, any shape
        Order n, any real number, [-].
    scale : "log" or "linear"
        Axes of straight lines.

    Returns
    -------
    array, shape of `order`
        Moments, [x² Hz^n]; inf where a linear profile from 0 Hz makes it diverge.

    Raises
    ------
    ValueError
        When the profile is not sound or an order is not finite.

    Notes
    -----
    Moments are of frequency in hertz, not of angular frequency: multiply by (2π)^n for those.

    Examples
    --------
    >>> round(float(spectral_moment([20, 80, 500, 2000], [0.01, 0.04, 0.04, 0.01])) ** 0.5, 1)
    6.8

    References
    ----------
    NASA-STD-7001A 2011, table of the minimum workmanship vibration (6.8 g rms).
    """
    f, g = checked_profile(frequency, level, scale=scale)
    n = np.asarray(order, dtype=np.float64)
    if not np.isfinite(n).all():
        raise ValueError("the order of a moment must be finite")
    each = _log_segment_moments if scale == "log" else _linear_segment_moments
    total: Floats = each(f, g, n[..., None]).sum(axis=-1)
    return total


def rms(frequency: ArrayLike, level: ArrayLike, *, scale: Scale = "log") -> float:
    """Give the root mean square of a signal from its density (GRMS for an ASD in g²/Hz).

    x_rms = sqrt(m_0)

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        The profile, [Hz] and [x²/Hz].
    scale : "log" or "linear"
        Axes of straight lines.

    Returns
    -------
    float
        Root mean square, [x].

    Raises
    ------
    ValueError
        When the profile is not sound.

    Examples
    --------
    >>> rms([100, 200], [0.04, 0.04])
    2.0
    """
    return float(np.sqrt(spectral_moment(frequency, level, 0.0, scale=scale)))


def rms_velocity(frequency: ArrayLike, level: ArrayLike, *, scale: Scale = "log") -> float:
    """Give the root-mean-square velocity behind an acceleration density.

    v_rms = sqrt(m_{−2})/(2π)

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        Acceleration density, [Hz] and [(m/s²)²/Hz].
    scale : "log" or "linear"
        Axes of straight lines.

    Returns
    -------
    float
        Velocity, [m/s].

    Raises
    ------
    ValueError
        When the profile is not sound.

    Examples
    --------
    >>> round(rms_velocity([10, 1000], [1.0, 1.0]), 6)
    0.050077
    """
    return float(np.sqrt(spectral_moment(frequency, level, -2.0, scale=scale))) / (2 * np.pi)


def rms_displacement(frequency: ArrayLike, level: ArrayLike, *, scale: Scale = "log") -> float:
    """Give the root-mean-square displacement behind an acceleration density.

    d_rms = sqrt(m_{−4})/(2π)²

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        Acceleration density, [Hz] and [(m/s²)²/Hz].
    scale : "log" or "linear"
        Axes of straight lines.

    Returns
    -------
    float
        Displacement, [m].

    Raises
    ------
    ValueError
        When the profile is not sound.

    Examples
    --------
    >>> round(rms_displacement([10, 1000], [1.0, 1.0]), 8)
    0.00046247
    """
    return float(np.sqrt(spectral_moment(frequency, level, -4.0, scale=scale))) / (2 * np.pi) ** 2
