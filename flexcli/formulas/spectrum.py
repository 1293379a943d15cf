"""Spectral densities given by breakpoints: what a sound one is, its level, its slopes, its cuts.

A profile is two arrays of one length: `frequency` [Hz], non-decreasing, where a pair of
equal values is a step, and `level` [x²/Hz], one-sided, in any squared unit x² per hertz.
Between breakpoints the density is a straight line, in log-log axes (`scale="log"`, the
convention of vibration specifications) or in linear axes (`scale="linear"`). Outside the
band it is zero.
"""

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "Scale",
    "Side",
    "along",
    "checked_profile",
    "clip_profile",
    "segment_slopes",
    "spectral_level",
]

Floats = NDArray[np.float64]
Scale = Literal["log", "linear"]
Side = Literal["left", "right", "upper"]


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


def along(start: Floats, end: Floats, fraction: Floats, scale: Scale) -> Floats:
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
    return np.where(inside, along(gs[i], gs[j], fraction, scale), 0.0)


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
