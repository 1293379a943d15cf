"""A measured spectral density against the limits of a test around its profile."""

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.spectrum import Scale, checked_profile, spectral_level

__all__ = ["LevelDeviation", "level_deviation"]

Floats = NDArray[np.float64]

_BETWEEN = 16
_FLOOR = 1e-300


class LevelDeviation(NamedTuple):
    """Greatest and least ratio of two densities, where, and for how much of the band beyond.

    Attributes
    ----------
    most, least : float
        Greatest and least measured level over the profile's, 0 where nothing was measured, [-].
    f_most, f_least : float
        Frequencies of both, [Hz].
    above, below : float
        Width of the band above the upper and below the lower limit, [Hz].
    """

    most: float
    f_most: float
    least: float
    f_least: float
    above: float
    below: float


def level_deviation(
    measured: tuple[ArrayLike, ArrayLike, Scale],
    profile: tuple[ArrayLike, ArrayLike, Scale],
    upper: float,
    lower: float,
    band: tuple[float, float] | None = None,
) -> LevelDeviation:
    """Give how far a measured density is off the profile of a test.

    Parameters
    ----------
    measured, profile : tuple of (frequency, level, scale)
        Densities, [Hz] and [x²/Hz], each straight on its axes.
    upper, lower : float
        Greatest and least ratio that is allowed, [-].
    band : tuple of float, optional
        Part of the profile's band to look at, [Hz].

    Returns
    -------
    LevelDeviation
        Extremes over the band of the profile.

    Notes
    -----
    On log-log axes the ratio of two lines is a line: the extremes are at breakpoints of either,
    and are exact. On linear axes 16 points are looked at between two breakpoints.

    Examples
    --------
    >>> flat = [20.0, 2000.0], [1.0, 1.0], "log"
    >>> found = level_deviation(([20.0, 2000.0], [0.5, 3.0], "log"), flat, 2.0, 0.5)
    >>> round(found.most, 9), found.f_most, round(found.least, 9)
    (3.0, 2000.0, 0.5)
    """
    f_m, g_m = checked_profile(measured[0], measured[1], scale=measured[2])
    f_p, g_p = checked_profile(profile[0], profile[1], scale=profile[2])
    low, high = (f_p[0], f_p[-1]) if band is None else (max(band[0], f_p[0]), min(band[1], f_p[-1]))
    cuts = np.unique(np.concatenate([f_m, f_p, [low, high]]))
    cuts = cuts[(cuts >= low) & (cuts <= high)]
    if "linear" in (measured[2], profile[2]):
        share = np.arange(1, _BETWEEN) / _BETWEEN
        inner = cuts[:-1, None] + np.diff(cuts)[:, None] * share
        cuts = np.unique(np.concatenate([cuts, inner.ravel()]))
    start, end = cuts[:-1], cuts[1:]
    there = (start >= f_m[0]) & (end <= f_m[-1])
    ends = []
    sides: tuple[tuple[Floats, Literal["left", "right"]], ...] = ((start, "right"), (end, "left"))
    for at, side in sides:
        found = spectral_level(at, f_m, g_m, scale=measured[2], side=side)
        asked = spectral_level(at, f_p, g_p, scale=profile[2], side=side)
        ratio = np.divide(found, asked, out=np.ones_like(found), where=asked > 0.0)
        ends.append(np.where(there, ratio, 0.0))
    places, ratios = np.concatenate([start, end]), np.concatenate(ends)
    most, least = int(np.argmax(ratios)), int(np.argmin(ratios))
    return LevelDeviation(
        most=float(ratios[most]),
        f_most=float(places[most]),
        least=float(ratios[least]),
        f_least=float(places[least]),
        above=_beyond(start, end, ends[0] / upper, ends[1] / upper),
        below=_beyond(start, end, lower / _sized(ends[0]), lower / _sized(ends[1])),
    )


def _sized(ratio: Floats) -> Floats:
    return np.maximum(ratio, _FLOOR)


def _beyond(start: Floats, end: Floats, first: Floats, last: Floats) -> float:
    """Width on which a line on log-log axes, given at both ends, is above 1 [Hz]."""
    a, b = np.log(_sized(first)), np.log(_sized(last))
    # rounding of a level that is just met
    a, b = (np.where(np.abs(each) < 1e-12, 0.0, each) for each in (a, b))
    share = np.divide(a, a - b, out=np.ones_like(a), where=(a * b < 0.0))
    crossing = start * (end / start) ** share
    both, falls, rises = (a > 0.0) | (b > 0.0), (a > 0.0) & (b < 0.0), (a < 0.0) & (b > 0.0)
    width = np.where(falls, crossing - start, np.where(rises, end - crossing, end - start))
    return float((width * both).sum())
