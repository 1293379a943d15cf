"""Newton's method for many designs at once: each converges, or fails, alone."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import Outcome

__all__ = [
    "BENDS",
    "CONTRACTION",
    "FLOOR",
    "REACH",
    "RESTLESS",
    "NewtonResult",
    "newton",
]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

REACH = 3.0
"""Longest step; a longer one is shortened to it (the unknowns are scaled to order one)."""

RESTLESS = 3
"""Steps in a row that may be longer than the one before."""

CONTRACTION = 0.5
"""Largest ratio of consecutive steps for which Newton's method stays on its path."""

FLOOR = 1e-9
"""Length below which a step that no longer shrinks is rounding, and the design is done."""

BENDS = 100.0
"""Initial bound of a step over the square of the one before."""


_TINY = 1e-300
"""Least divisor of a length."""


class NewtonResult(NamedTuple):
    """Points reached (designs, m), how each ended, iterations, lengths of two steps.

    ``bend`` is the length of the second step, zero where the first was enough; ``last_step`` that
    of the last, ``bends`` what a step is over the square of the one before: the next would be
    ``bends last_step²``. ``length`` is that of the last point that a step led to.
    """

    x: Floats
    end: NDArray[np.object_]
    iterations: Integers
    last_step: Floats
    bend: Floats
    bends: Floats
    length: Floats

    @property
    def converged(self) -> NDArray[np.bool_]:
        """Return which designs converged."""
        return np.asarray(self.end == Outcome.CONVERGED)


def newton(
    step: Callable[[Floats, Integers], Floats],
    length: Callable[[Floats, Floats], Floats],
    start: Floats,
    *,
    tolerance: float,
    scale: Floats | None = None,
    bends: Floats | None = None,
    trust: float = np.inf,
    most: int = 30,
) -> NewtonResult:
    """Return where Newton's method leads from each row of ``start``.

    A design is done when the step that would come next, ``|s_k| (|s_k|/|s_{k−1}|)²`` by the
    quadratic convergence seen so far (``bends |s_0|²`` after the first step), is below the
    tolerance times the scale.

    Parameters
    ----------
    step : callable
        ``step(x, rows)`` gives the Newton steps of the points x, which belong to the designs
        ``rows``; NaN where the Jacobian is singular.
    length : callable
        ``length(x, s)`` gives the length [-] of each step, in scaled unknowns.
    start : array, shape (designs, m)
        Starting points.
    tolerance : float
        Length [-] of the error at which a design is done, over its scale.
    scale : array, shape (designs,), optional
        Length [-] of what each design is about, by default zero; the length of the point itself
        where that is longer, but at most one.
    bends : array, shape (designs,), optional
        Length of a step over the square of the one before, at most; ``BENDS`` by default.
    trust : float
        Longest second step [-]. From a solution nearby the first step is the tangent of the
        path, the second measures how far the path bends away: beyond this, or where any step is
        longer than half the one before, another branch may be near, and the design ends as
        OFF_PATH. Without it, any solution will do.
    most : int
        Most iterations.

    Returns
    -------
    NewtonResult
        Points, ends, iterations and last steps of all designs.

    References
    ----------
    Deuflhard (2011), Newton Methods for Nonlinear Problems, sections 2.1 and 5.1.

    """
    if len(start) == 1:
        least, bent = (0.0 if scale is None else scale[0]), (BENDS if bends is None else bends[0])
        return _of_one(step, length, start, tolerance, least, bent, trust, most)
    x = start.copy()
    designs = x.shape[0]
    end = np.full(designs, Outcome.STALLED, dtype=object)
    iterations = np.full(designs, most, dtype=np.intp)
    last = np.full(designs, np.inf)
    bend, lengths = np.zeros(designs), np.zeros(designs)
    bends = np.full(designs, BENDS) if bends is None else bends.copy()
    # of the designs that go on: points, lengths of the last steps and what they are over squares
    rows, y, before, bent = np.arange(designs), x, last, bends
    restless = np.zeros(designs, dtype=np.intp)
    least = np.zeros(designs) if scale is None else scale
    for count in range(most if designs else 0):
        # a design that diverges may overflow: it ends by its length, and warns of nothing
        with np.errstate(all="ignore"):
            s = step(y, rows)
            size = length(y, s)
        if count == 1:
            bend[rows] = size
        longest, kept = size.max(), size < np.inf
        end[rows[~kept]] = Outcome.SINGULAR
        if count > 0 and trust < np.inf:
            near = size <= np.minimum(trust, np.maximum(CONTRACTION * before, FLOOR))
            end[rows[kept & ~near]] = Outcome.OFF_PATH
            kept &= near
        if not kept.all():
            gone = rows[~kept]
            x[gone], last[gone], bends[gone] = y[~kept], before[~kept], bent[~kept]
            iterations[gone] = count + 1
            rows, restless = rows[kept], restless[kept]
            y, s, size, before, bent, least = (
                each[kept] for each in (y, s, size, before, bent, least)
            )
            if rows.size == 0:
                break
            longest = size.max()
        if longest > REACH:
            s = s * np.minimum(1.0, REACH / np.maximum(size, REACH))[:, None]
        y = y + s
        lengths[rows] = length(y, y)
        unit = np.minimum(1.0, np.maximum(least, lengths[rows]))
        if count > 0:
            ratio = size / before
            bent = np.minimum(ratio, 1.0) ** 2 / np.maximum(size, _TINY)
            done = (size <= FLOOR * unit) & (ratio > 0.5)
            restless = (restless + 1) * (ratio > 1.0)
        else:
            done = np.zeros(rows.size, dtype=np.bool_)
        done |= bent * size**2 <= tolerance * unit
        before = size
        kept = ~done & (restless < RESTLESS)
        if count + 1 == most or not kept.all():
            gone = ~kept | (count + 1 == most)
            at = rows[gone]
            end[rows[done]] = Outcome.CONVERGED
            x[at], last[at], bends[at], iterations[at] = y[gone], size[gone], bent[gone], count + 1
            rows, restless = rows[kept], restless[kept]
            y, before, bent, least = (each[kept] for each in (y, before, bent, least))
        if rows.size == 0:
            break
    return NewtonResult(x, end, iterations, last, bend, bends, lengths)


def _of_one(
    step: Callable[[Floats, Integers], Floats],
    length: Callable[[Floats, Floats], Floats],
    x: Floats,
    tolerance: float,
    least: float,
    bends: float,
    trust: float,
    most: int,
) -> NewtonResult:
    """Return the same of a single design, without the arrays that keep many apart."""
    alone, end, count = np.arange(1), Outcome.STALLED, 0
    last, bend, restless, far = np.inf, 0.0, 0, 0.0
    with np.errstate(all="ignore"):
        for count in range(1, most + 1):
            s = step(x, alone)
            size = float(length(x, s)[0])
            if count == 2:
                bend = size
            if not size < np.inf:
                end = Outcome.SINGULAR
                break
            if count > 1 and trust < np.inf and size > min(trust, max(CONTRACTION * last, FLOOR)):
                end = Outcome.OFF_PATH
                break
            x = x + (s if size <= REACH else s * (REACH / size))
            far = float(length(x, x)[0])
            unit, ratio = min(1.0, max(least, far)), size / last
            if count > 1:
                bends = min(ratio, 1.0) ** 2 / max(size, _TINY)
                restless = restless + 1 if ratio > 1.0 else 0
            last = size
            small = count > 1 and size <= FLOOR * unit and ratio > 0.5
            if small or bends * size**2 <= tolerance * unit:
                end = Outcome.CONVERGED
                break
            if restless >= RESTLESS:
                break
    numbers = (np.array([each]) for each in (last, bend, bends, far))
    return NewtonResult(x, np.array([end], dtype=object), np.array([count]), *numbers)
