"""The greatest value of a function of one variable that is smooth between given points."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

__all__ = ["greatest"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

_PIECES = 8
"""Number of parts of a bracket in each pass; the two beside the greatest point are kept."""
_HOPELESS = 0.1
"""Relative deficit of a bracket's best point below the best of all from which it is dropped."""
TOLERANCE = 1e-11
"""Relative error of the greatest value."""
_MOST_BRACKETS = 64
_MOST_PASSES = 40


def greatest(
    function: Callable[[Floats, Integers], Floats], grid: Floats, piece: Integers
) -> tuple[float, float, int]:
    """Find the greatest value of a function on pieces of a line.

    Every local maximum of the grid is narrowed until the values of its bracket agree within
    `TOLERANCE`; the end points of a piece count. A smooth maximum is flat, so its place is known to
    some √TOLERANCE of its width.

    Parameters
    ----------
    function : callable
        Takes points and the piece of each, shapes (n,), and gives values (n,), at least zero.
    grid : array, shape (n,)
        Points, rising within each piece, ends included; dense enough that a maximum between two
        points shows as a local maximum of the grid, at most a tenth above it.
    piece : array of int, shape (n,)
        The piece of each point, not falling.

    Returns
    -------
    tuple of float, float, int
        Value, place (the first of several) and piece.

    Examples
    --------
    >>> value, place, _ = greatest(lambda x, _: 2 - (x - 1 / 3) ** 2, np.linspace(0, 1, 7),
    ...                            np.zeros(7, dtype=np.intp))
    >>> round(value, 9), round(place, 5)
    (2.0, 0.33333)

    """
    values = function(grid, piece)
    best = int(np.argmax(values))
    found = (float(values[best]), float(grid[best]), int(piece[best]))
    low, high, on = _brackets(values, grid, piece)
    share = np.linspace(0.0, 1.0, _PIECES + 1)
    for _ in range(_MOST_PASSES):
        if low.size == 0:
            break
        x = low[:, None] + (high - low)[:, None] * share
        y = function(x.ravel(), np.repeat(on, share.size)).reshape(x.shape)
        row, column = np.unravel_index(int(np.argmax(y)), y.shape)
        if y[row, column] > found[0]:
            found = (float(y[row, column]), float(x[row, column]), int(on[row]))
        peak = np.argmax(y, axis=1)
        rows = np.arange(peak.size)
        left, right = np.maximum(peak - 1, 0), np.minimum(peak + 1, _PIECES)
        # at an end both points of a bracket may lie as high on either side of what is between
        beside = np.where(peak == 0, 2, right), np.where(peak == _PIECES, _PIECES - 2, left)
        spread = y[rows, peak] - np.minimum(*(y[rows, each] for each in beside))
        # what is left to gain in a bracket is less than its spread
        alive = (spread > TOLERANCE * found[0]) & (y[rows, peak] + spread > found[0])
        low, high, on = x[rows, left][alive], x[rows, right][alive], on[alive]
    return found


def _brackets(values: Floats, grid: Floats, piece: Integers) -> tuple[Floats, Floats, Integers]:
    """Return the neighbours of every local maximum that may hold the greatest value."""
    last = values.size - 1
    index = np.arange(values.size)
    before = np.where(np.diff(piece, prepend=-1) == 0, index - 1, index)
    after = np.where(np.diff(piece, append=piece[-1] + 1) == 0, np.minimum(index + 1, last), index)
    is_peak = (values >= values[before]) & (values >= values[after]) & (before < after)
    peaks = np.flatnonzero(is_peak & (values >= (1.0 - _HOPELESS) * values.max()))
    peaks = np.sort(peaks[np.argsort(-values[peaks], kind="stable")][:_MOST_BRACKETS])
    return grid[before[peaks]], grid[after[peaks]], piece[peaks]
