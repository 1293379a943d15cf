"""Any spectral density as straight lines on log-log axes, and the sum of several."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.spectrum import Scale, Side, checked_profile, spectral_level

__all__ = ["power_sum", "straight_lines"]

Floats = NDArray[np.float64]

_MOST_HALVINGS = 14
_INSIDE = (0.25, 0.5, 0.75)


def straight_lines(
    level: Callable[[Floats, Side], Floats], cuts: ArrayLike, *, tolerance: float = 1e-3
) -> tuple[Floats, Floats]:
    """Give breakpoints between which straight lines on log-log axes follow a density.

    Parameters
    ----------
    level : callable
        Density [x²/Hz] at frequencies [Hz]; the second argument says the side of a step.
    cuts : array, shape (n,)
        Frequencies that become breakpoints: ends of the band, steps, corners, [Hz].
    tolerance : float
        Most that a line may be off, a share of the density, [-].

    Returns
    -------
    tuple of arrays
        Frequency [Hz] and level [x²/Hz]; a step has two points.

    Examples
    --------
    >>> f, g = straight_lines(lambda f, side: f**-1.5, [10.0, 1000.0])
    >>> f.tolist()
    [10.0, 1000.0]
    """
    x = np.log(np.unique(np.asarray(cuts, dtype=np.float64)))
    start, end = x[:-1], x[1:]
    done: list[tuple[Floats, Floats]] = []
    for halving in range(_MOST_HALVINGS + 1):
        low, high = np.log(level(np.exp(start), "right")), np.log(level(np.exp(end), "left"))
        off = np.zeros(start.size)
        for share in _INSIDE:
            true = np.log(level(np.exp(start + share * (end - start)), "right"))
            off = np.maximum(off, np.abs(low + share * (high - low) - true))
        open_ = (off > tolerance) & (halving < _MOST_HALVINGS)
        kept = ~open_
        done.append((np.stack([start[kept], end[kept]], 1), np.stack([low[kept], high[kept]], 1)))
        middle = 0.5 * (start[open_] + end[open_])
        start, end = np.append(start[open_], middle), np.append(middle, end[open_])
        if not start.size:
            break
    places, levels = (np.concatenate(each) for each in zip(*done, strict=True))
    order = np.argsort(places[:, 0], kind="stable")
    f, g = np.exp(places[order].ravel()), np.exp(levels[order].ravel())
    # ends of neighbours are the same point, unless the density steps there
    again = np.concatenate([[False], (f[1:] == f[:-1]) & (np.abs(g[1:] / g[:-1] - 1.0) < 1e-12)])
    f, g = f[~again], g[~again]
    corners = np.unique(np.asarray(cuts, dtype=np.float64))
    nearest = corners[np.clip(np.searchsorted(corners, f * (1.0 - 1e-14)), 0, corners.size - 1)]
    return np.where(np.abs(nearest / f - 1.0) < 1e-13, nearest, f), g


def power_sum(
    profiles: Sequence[tuple[ArrayLike, ArrayLike, Scale]],
) -> tuple[Floats, Floats]:
    """Give the sum of several densities: environments that act at once and are independent.

    G(f) = Σ G_i(f)

    Parameters
    ----------
    profiles : sequence of (frequency, level, scale)
        At least one profile, [Hz] and [x²/Hz], with the axes in which it is straight.

    Returns
    -------
    tuple of arrays
        Frequency [Hz] and level [x²/Hz], straight on log-log axes.

    Raises
    ------
    ValueError
        When a profile is not sound, none is given, or bands leave a gap.

    Notes
    -----
    The sum of straight lines on log-log axes is no straight line: points are added until it
    follows within 1e-3 of it.

    Examples
    --------
    >>> f, g = power_sum([([10, 100], [1.0, 1.0], "log"), ([10, 100], [2.0, 2.0], "log")])
    >>> f.tolist(), g.round(12).tolist()
    ([10.0, 100.0], [3.0, 3.0])
    """
    sound = [(*checked_profile(f, g, scale=scale), scale) for f, g, scale in profiles]
    if not sound:
        raise ValueError("a sum needs at least one profile")
    cuts = np.unique(np.concatenate([f for f, _, _ in sound]))
    middle = np.sqrt(cuts[1:] * cuts[:-1])
    covered = np.any([(f[0] <= middle) & (middle <= f[-1]) for f, _, _ in sound], axis=0)
    if not covered.all():
        at = int(np.argmin(covered))
        raise ValueError(f"no profile covers {cuts[at]:g} to {cuts[at + 1]:g} Hz")

    def level(at: Floats, side: Side) -> Floats:
        total = np.zeros(at.size)
        for f, g, scale in sound:
            # an end of a band belongs to it on its inner side alone
            inside = (at >= f[0]) & (at < f[-1]) if side == "right" else (at > f[0]) & (at <= f[-1])
            total += np.where(inside, spectral_level(at, f, g, scale=scale, side=side), 0.0)
        return total

    return straight_lines(lambda f, side: level(_snapped(f, cuts), side), cuts)


def _snapped(f: Floats, cuts: Floats) -> Floats:
    """Frequencies that went through logarithms put back onto the cuts that they are."""
    near = cuts[np.clip(np.searchsorted(cuts, f * (1.0 - 1e-13)), 0, cuts.size - 1)]
    return np.where(np.abs(near / f - 1.0) < 1e-13, near, f)
