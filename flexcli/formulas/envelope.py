"""The envelope of several spectral densities."""

import itertools
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.spectrum import Scale, along, checked_profile, spectral_level

__all__ = ["envelope"]

Floats = NDArray[np.float64]

# Two points closer than this (relative) are one point, three on one line are two.
_SAME = 1e-12


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
        at = along(np.full_like(fractions, a), np.full_like(fractions, b), fractions, scale)
        values = along(left[:, None], right[:, None], fractions[None, :], scale)
        points_f += at.tolist()
        points_g += values.max(axis=0).tolist()
    return _thinned(np.array(points_f), np.array(points_g), scale)
