"""Spectral densities given by breakpoints: level, moments, envelope, scaling, slopes.

A profile is two arrays of one length: `frequency` [Hz], non-decreasing, where a pair of
equal values is a step, and `level` [x²/Hz], one-sided, in any squared unit x² per hertz.
Between breakpoints the density is a straight line, in log-log axes (`scale="log"`, the
convention of vibration specifications) or in linear axes (`scale="linear"`). Outside the
band it is zero.
"""

import itertools
from collections.abc import Sequence
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.numerics.quadrature import gauss_rule

__all__ = [
    "Scale",
    "Side",
    "checked_profile",
    "clip_profile",
    "db_per_octave_from_slope",
    "envelope",
    "levels_from_slopes",
    "rms",
    "rms_displacement",
    "rms_velocity",
    "scale_level",
    "segment_slopes",
    "slope_from_db_per_octave",
    "spectral_level",
    "spectral_moment",
]

Floats = NDArray[np.float64]
Scale = Literal["log", "linear"]
Side = Literal["left", "right", "upper"]

# Two points closer than this (relative) are one point, three on one line are two.
_SAME = 1e-12
# Gauss points for f^n times a straight line over less than an octave: the nearest
# singularity, f = 0, is 3 half-widths off, so the error falls as (3 + √8)^(-2·16) ~ 1e-24.
_NARROW_NODES = 16


def checked_profile(
    frequency: ArrayLike, level: ArrayLike, *, scale: Scale = "log"
) -> tuple[Floats, Floats]:
    """Return a profile as two float arrays, or say what is wrong with it.

    Parameters
    ----------
    frequency : array, shape (n,)
        Breakpoints, non-decreasing, at most two equal (a step), [Hz].
    level : array, shape (n,)
        One-sided density at the breakpoints, [x²/Hz].
    scale : "log" or "linear"
        Axes in which the density is straight between breakpoints.

    Returns
    -------
    tuple of arrays, shape (n,)
        Frequency [Hz] and level [x²/Hz].

    Raises
    ------
    ValueError
        When shapes differ, a value is not finite, frequencies fall or three are equal; when
        `scale` is "log" and a value is not positive, or "linear" and one is negative.

    Examples
    --------
    >>> checked_profile([20, 2000], [0.1, 0.1])[0].tolist()
    [20.0, 2000.0]
    """
    f = np.asarray(frequency, dtype=np.float64)
    g = np.asarray(level, dtype=np.float64)
    if scale not in ("log", "linear"):
        raise ValueError(f"scale must be 'log' or 'linear', got {scale!r}")
    if f.ndim != 1 or f.shape != g.shape or f.size == 0:
        raise ValueError(
            "frequency and level must be one-dimensional, of one length and not empty, "
            f"got shapes {f.shape} and {g.shape}"
        )
    if not (np.isfinite(f).all() and np.isfinite(g).all()):
        raise ValueError("frequency and level must be finite")
    if (np.diff(f) < 0).any():
        where = int(np.argmax(np.diff(f) < 0))
        raise ValueError(f"frequency must not fall: {f[where]:g} Hz then {f[where + 1]:g} Hz")
    if f.size > 2 and (f[2:] == f[:-2]).any():
        where = int(np.argmax(f[2:] == f[:-2]))
        raise ValueError(f"{f[where]:g} Hz appears three times: a step has two levels")
    if scale == "log" and not ((f > 0).all() and (g > 0).all()):
        raise ValueError("frequency and level must be positive on log-log axes")
    if scale == "linear" and not ((f >= 0).all() and (g >= 0).all()):
        raise ValueError("frequency and level must not be negative")
    return f, g


def _along(start: Floats, end: Floats, fraction: Floats, scale: Scale) -> Floats:
    """Go from `start` to `end`, linearly or geometrically; exact at fractions 0 and 1."""
    if scale == "log":
        between: Floats = start * (end / start) ** fraction
    else:
        between = start + (end - start) * fraction
    return np.where(fraction == 1, end, between)


def spectral_level(
    f: ArrayLike,
    frequency: ArrayLike,
    level: ArrayLike,
    *,
    scale: Scale = "log",
    side: Side = "right",
) -> Floats:
    """Interpolate a profile.

    G(f) = G_1 (f/f_1)^m with m = ln(G_2/G_1)/ln(f_2/f_1) on log-log axes;
    G(f) = G_1 + (G_2 − G_1)(f − f_1)/(f_2 − f_1) on linear axes; 0 outside the band, whose
    edges belong to it.

    Parameters
    ----------
    f : array, any shape
        Frequencies asked, [Hz].
    frequency, level : arrays, shape (n,)
        The profile, [Hz] and [x²/Hz].
    scale : "log" or "linear"
        Axes of straight lines.
    side : "left", "right" or "upper"
        At a step: the level just below it, just above it, or the greater of both.

    Returns
    -------
    array, shape of `f`
        Density, [x²/Hz].

    Raises
    ------
    ValueError
        When the profile is not sound (see `checked_profile`).

    Examples
    --------
    >>> spectral_level([10, 40, 80, 3000], [20, 80, 2000], [0.01, 0.04, 0.04]).round(4).tolist()
    [0.0, 0.02, 0.04, 0.0]
    """
    fs, gs = checked_profile(frequency, level, scale=scale)
    if side not in ("left", "right", "upper"):
        raise ValueError(f"side must be 'left', 'right' or 'upper', got {side!r}")
    if side == "upper":
        return np.maximum(
            spectral_level(f, fs, gs, scale=scale, side="left"),
            spectral_level(f, fs, gs, scale=scale, side="right"),
        )
    asked = np.asarray(f, dtype=np.float64)
    inside = (asked >= fs[0]) & (asked <= fs[-1])
    at = np.where(inside, asked, fs[0])
    last = fs.size - 1
    if side == "right":
        i = np.searchsorted(fs, at, side="right") - 1
        j = np.minimum(i + 1, last)
    else:
        j = np.searchsorted(fs, at, side="left")
        i = np.maximum(j - 1, 0)
    span = fs[j] - fs[i]
    fraction = np.divide(at - fs[i], span, out=np.zeros_like(at), where=span > 0)
    if scale == "log":
        # log1p keeps the digits of lines that are nearly vertical
        ratio = np.log1p(span / fs[i])
        fraction = np.divide(
            np.log1p((at - fs[i]) / fs[i]), ratio, out=np.zeros_like(at), where=ratio > 0
        )
        fraction = np.where(at == fs[j], 1.0, fraction)
    fraction = np.where(at == fs[i], 0.0, fraction)
    return np.where(inside, _along(gs[i], gs[j], fraction, scale), 0.0)


def segment_slopes(frequency: ArrayLike, level: ArrayLike) -> Floats:
    """Give the log-log slope of each segment.

    m = ln(G_2/G_1)/ln(f_2/f_1); ±inf at a step, 0 at a repeated point.

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        The profile, [Hz] and [x²/Hz].

    Returns
    -------
    array, shape (n − 1,)
        Slopes, [-].

    Raises
    ------
    ValueError
        When the profile is not sound on log-log axes.

    Examples
    --------
    >>> segment_slopes([20, 80, 500, 2000], [0.01, 0.04, 0.04, 0.01]).round(12).tolist()
    [1.0, 0.0, -1.0]
    """
    f, g = checked_profile(frequency, level)
    rise = np.log(g[1:] / g[:-1])
    run = np.log1p(np.diff(f) / f[:-1])
    return np.divide(rise, run, out=np.where(rise == 0, 0.0, np.copysign(np.inf, rise)),
                     where=run > 0)  # fmt: skip


def clip_profile(
    frequency: ArrayLike,
    level: ArrayLike,
    *,
    lower: float | None = None,
    upper: float | None = None,
    scale: Scale = "log",
) -> tuple[Floats, Floats]:
    """Cut a profile to a band; both levels of a step at the band's edge stay.

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        The profile, [Hz] and [x²/Hz].
    lower, upper : float, optional
        Edges of the band; the profile's own where left out, [Hz].
    scale : "log" or "linear"
        Axes of straight lines.

    Returns
    -------
    tuple of arrays
        Frequency [Hz] and level [x²/Hz] of the part inside.

    Raises
    ------
    ValueError
        When the profile is not sound or has nothing in the band.

    Examples
    --------
    >>> f, g = clip_profile([20, 2000], [0.1, 0.1], lower=50)
    >>> f.tolist(), g.tolist()
    ([50.0, 2000.0], [0.1, 0.1])
    """
    f, g = checked_profile(frequency, level, scale=scale)
    low = f[0] if lower is None else max(float(lower), f[0])
    high = f[-1] if upper is None else min(float(upper), f[-1])
    if not low <= high:
        raise ValueError(
            f"the profile spans {f[0]:g} to {f[-1]:g} Hz, nothing between "
            f"{lower if lower is not None else f[0]:g} and "
            f"{upper if upper is not None else f[-1]:g} Hz"
        )
    keep = (f >= low) & (f <= high)
    ends = [end for end in (low, high) if not (f == end).any()]
    if not ends:
        return f[keep], g[keep]
    cut = np.concatenate([f[keep], ends])
    order = np.argsort(cut, kind="stable")
    levels = np.concatenate([g[keep], spectral_level(ends, f, g, scale=scale)])
    return cut[order], levels[order]


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


def scale_level(level: ArrayLike, db: ArrayLike) -> Floats:
    """Scale a density by decibels of power.

    G' = G · 10^(dB/10): +3 dB is a factor 1.995 on the density, 1.413 on the rms.

    Parameters
    ----------
    level : array, any shape
        Density, [x²/Hz].
    db : array that broadcasts with `level`
        Gain, [dB].

    Returns
    -------
    array
        Density, [x²/Hz].

    Examples
    --------
    >>> round(float(scale_level(0.04, 3)), 5)
    0.07981
    """
    scaled: Floats = np.asarray(level, np.float64) * 10 ** (np.asarray(db, np.float64) / 10)
    return scaled


def slope_from_db_per_octave(db_per_octave: ArrayLike) -> Floats:
    """Turn a slope in decibels per octave into a log-log exponent.

    m = (dB/octave)/(10 log10 2), since 10 log10(2^m) dB is one octave's rise.

    Parameters
    ----------
    db_per_octave : array, any shape
        Slope, [dB/octave].

    Returns
    -------
    array
        Exponent m of G ∝ f^m, [-].

    Examples
    --------
    >>> round(float(slope_from_db_per_octave(6)), 4)
    1.9932
    """
    slope: Floats = np.asarray(db_per_octave, dtype=np.float64) / (10 * np.log10(2))
    return slope


def db_per_octave_from_slope(slope: ArrayLike) -> Floats:
    """Turn a log-log exponent into decibels per octave.

    dB/octave = 10 log10(2) · m

    Parameters
    ----------
    slope : array, any shape
        Exponent m of G ∝ f^m, [-].

    Returns
    -------
    array
        Slope, [dB/octave].

    Examples
    --------
    >>> round(float(db_per_octave_from_slope(-1)), 4)
    -3.0103
    """
    db: Floats = np.asarray(slope, dtype=np.float64) * (10 * np.log10(2))
    return db


def levels_from_slopes(
    frequency: ArrayLike,
    db_per_octave: ArrayLike,
    *,
    known_index: int,
    known_level: float,
) -> Floats:
    """Give the levels at the edges of segments specified in dB per octave.

    G_{i+1} = G_i (f_{i+1}/f_i)^{m_i}, from the one known level outwards.

    Parameters
    ----------
    frequency : array, shape (n,)
        Edges of the segments, strictly increasing, [Hz].
    db_per_octave : array, shape (n − 1,)
        Slope of each segment, 0 for a plateau, [dB/octave].
    known_index : int
        Edge at which the level is known.
    known_level : float
        Level there, [x²/Hz].

    Returns
    -------
    array, shape (n,)
        Levels, [x²/Hz].

    Raises
    ------
    ValueError
        When lengths do not fit, edges do not rise, the index is not an edge, or the level is
        not positive.

    Examples
    --------
    >>> levels_from_slopes([20, 50, 800, 2000], [6, 0, -6], known_index=1,
    ...                    known_level=0.16).round(3).tolist()
    [0.026, 0.16, 0.16, 0.026]

    References
    ----------
    NASA GSFC-STD-7000A (GEVS) 2013, table 2.4-3.
    """
    f = np.asarray(frequency, dtype=np.float64)
    m = slope_from_db_per_octave(db_per_octave)
    if f.ndim != 1 or m.shape != (f.size - 1,):
        raise ValueError(
            f"{f.size} edges bound {f.size - 1} segments, got slopes of shape {m.shape}"
        )
    if not (np.isfinite(f).all() and f[0] > 0 and (np.diff(f) > 0).all()):
        raise ValueError("edges must be finite, positive and strictly increasing")
    if not np.isfinite(m).all():
        raise ValueError("slopes must be finite; write a step as two profiles' edges")
    if not 0 <= known_index < f.size:
        raise ValueError(f"known_index must lie in 0 to {f.size - 1}, got {known_index}")
    if not (np.isfinite(known_level) and known_level > 0):
        raise ValueError(f"the known level must be positive, got {known_level}")
    rise = np.concatenate([[0.0], np.cumsum(m * np.log(f[1:] / f[:-1]))])
    levels: Floats = known_level * np.exp(rise - rise[known_index])
    return levels


def _crossings(left: Floats, right: Floats) -> Floats:
    """Fractions of an interval at which straight lines with these end values cross."""
    gap_left = left[:, None] - left[None, :]
    gap_right = right[:, None] - right[None, :]
    i, j = np.nonzero(np.triu(gap_left * gap_right < 0))
    fractions: Floats = np.unique(gap_left[i, j] / (gap_left[i, j] - gap_right[i, j]))
    return fractions


def _thinned(f: Floats, g: Floats, scale: Scale) -> tuple[Floats, Floats]:
    """Drop repeated points and points on the line between their neighbours."""
    kept: list[int] = []
    for i in range(f.size):
        if kept and f[i] == f[kept[-1]] and abs(g[i] - g[kept[-1]]) <= _SAME * g[i]:
            continue
        if len(kept) > 1:
            a, b = kept[-2], kept[-1]
            if f[a] < f[b] < f[i]:
                on_line = spectral_level(f[b], f[[a, i]], g[[a, i]], scale=scale)
                if abs(on_line - g[b]) <= _SAME * g[b]:
                    kept.pop()
        kept.append(i)
    return f[kept], g[kept]


def envelope(
    profiles: Sequence[tuple[ArrayLike, ArrayLike]], *, scale: Scale = "log"
) -> tuple[Floats, Floats]:
    """Give the greatest of several profiles, with the exact points where they cross.

    G(f) = max_i G_i(f); where two lines cross, the envelope has a breakpoint.

    Parameters
    ----------
    profiles : sequence of (frequency, level)
        At least one profile, [Hz] and [x²/Hz].
    scale : "log" or "linear"
        Axes of straight lines.

    Returns
    -------
    tuple of arrays
        Frequency [Hz] and level [x²/Hz]; a profile that starts inside another's band and
        above it makes a step.

    Raises
    ------
    ValueError
        When a profile is not sound, none is given, or bands leave a gap on log-log axes
        (a level of zero has no logarithm).

    Examples
    --------
    >>> f, g = envelope([([10, 1000], [1.0, 0.01]), ([10, 1000], [0.01, 1.0])])
    >>> f.round(9).tolist(), g.round(9).tolist()
    ([10.0, 100.0, 1000.0], [1.0, 0.1, 1.0])
    """
    sound = [checked_profile(f, g, scale=scale) for f, g in profiles]
    if not sound:
        raise ValueError("an envelope needs at least one profile")
    cuts = np.unique(np.concatenate([f for f, _ in sound]))
    if cuts.size == 1:
        return cuts, np.array([max(g.max() for _, g in sound)])
    points_f: list[float] = []
    points_g: list[float] = []
    for a, b in itertools.pairwise(cuts):
        here = [(f, g) for f, g in sound if f[0] <= a and b <= f[-1]]
        if not here:
            if scale == "log":
                raise ValueError(f"no profile covers {a:g} to {b:g} Hz: the envelope has a gap")
            points_f += [a, b]
            points_g += [0.0, 0.0]
            continue
        left = np.array([spectral_level(a, f, g, scale=scale, side="right") for f, g in here])
        right = np.array([spectral_level(b, f, g, scale=scale, side="left") for f, g in here])
        straight = np.log if scale == "log" else np.positive
        fractions = np.concatenate([[0.0], _crossings(straight(left), straight(right)), [1.0]])
        fractions = fractions[np.concatenate([[True], np.diff(fractions) > 0])]
        at = _along(np.full_like(fractions, a), np.full_like(fractions, b), fractions, scale)
        values = _along(left[:, None], right[:, None], fractions[None, :], scale)
        points_f += at.tolist()
        points_g += values.max(axis=0).tolist()
    return _thinned(np.array(points_f), np.array(points_g), scale)
