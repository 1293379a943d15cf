"""Following one path of solutions by arc length, past points where the parameter turns back."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["CLOSE", "Hyperplane", "correct_on", "follow"]

Floats = NDArray[np.float64]

Steps = Callable[[Floats, float], tuple[Floats, Floats]]
"""``steps(x, λ)`` gives Newton's step at constant λ and dx/dλ, both (m,)."""

_MOST_ITERATIONS = 12
_WANTED = 4
"""Iterations of the corrector that the step length aims for."""

CLOSE = 0.02
"""Step, over the longest allowed, below which a change of the solution's kind need not be a
turn."""

_FLOOR = 1e-6
"""Length below which a step that no longer shrinks is rounding (much near critical points)."""


class Hyperplane(NamedTuple):
    """Points (x, λ) with ``tangent·(x − x_0) weight + slope (λ − λ_0) = 0``."""

    x: Floats
    parameter: float
    tangent: Floats
    slope: float
    weight: Floats


class Corrected(NamedTuple):
    """A point (x, λ) of a path, dx/dλ before the last step that led there, and the iterations."""

    x: Floats
    parameter: float
    rate: Floats
    iterations: int


def correct_on(plane: Hyperplane, steps: Steps, tolerance: float) -> "Corrected | None":
    """Return where the path meets the hyperplane, from its foot; None when the steps don't shrink.

    Parameters
    ----------
    plane : Hyperplane
        Its foot is the first guess.
    steps : callable
        Newton's step at constant λ and dx/dλ.
    tolerance : float
        Length of the step [-] that ends the iteration.

    """
    x, parameter = plane.x.copy(), plane.parameter
    before = np.inf
    for count in range(1, _MOST_ITERATIONS + 1):
        step, rate = steps(x, parameter)
        gap = plane.tangent @ (plane.weight * (x - plane.x + step))
        gap += plane.slope * (parameter - plane.parameter)
        d = -gap / (plane.tangent @ (plane.weight * rate) + plane.slope)
        change = step + rate * d
        size = max(float(np.sqrt(change @ (plane.weight * change))), abs(float(d)))
        restless = size > before
        if not np.isfinite(size) or (count > 2 and restless and size > _FLOOR):
            return None
        x, parameter, before = x + change, parameter + float(d), size
        if size <= tolerance or (restless and size <= _FLOOR):
            return Corrected(x, parameter, rate, count)
    return None


def follow(
    steps: Steps,
    start: tuple[Floats, float],
    weight: Floats,
    *,
    stride: float,
    longest: float,
    goal: Callable[[Floats, float], bool],
    kind: Callable[[Floats, float], int],
    tolerance: float,
    most: int,
    close: float = CLOSE,
) -> list[Hyperplane]:
    """Return the points of a path, each with its tangent, from the start until the goal is met.

    Parameters
    ----------
    steps : callable
        Newton's step at constant λ and dx/dλ.
    start : tuple
        A solution x (m,) and its λ; the path leaves it towards larger λ.
    weight : array, shape (m,)
        Weight of each unknown in the arc length; λ has weight one.
    stride, longest : float
        First and longest step of arc length [-].
    goal : callable
        ``goal(x, λ)`` says whether the path has gone far enough.
    kind : callable
        ``kind(x, λ)`` gives a number that changes only where λ turns or paths branch: elsewhere a
        step is shortened until nothing but a branching point can lie on it, so that a path which
        bends sharply away from such a point is not left for its other half.
    tolerance : float
        Length of the error of a point [-].
    most : int
        Most points.
    close : float
        Step over the longest [-] on which the kind may change without a turn.

    Returns
    -------
    list of Hyperplane
        The points; the last meets the goal unless the path was lost or ``most`` reached.

    References
    ----------
    Allgower & Georg (2003), Introduction to Numerical Continuation Methods, chapter 4.

    """
    x, parameter = start
    points = [_tangent(x, parameter, steps(x, parameter)[1], weight, None)]
    here = kind(x, parameter)
    while len(points) < most and not goal(points[-1].x, points[-1].parameter):
        last = points[-1]
        guess = last._replace(
            x=last.x + stride * last.tangent, parameter=last.parameter + stride * last.slope
        )
        found = correct_on(guess, steps, tolerance)
        if found is not None:
            x, parameter, rate, iterations = found
            point = _tangent(x, parameter, rate, weight, last)
            # a sharp bend means that the path was lost for another one
            bend = point.tangent @ (weight * last.tangent) + point.slope * last.slope
            off = x - guess.x
            astray = float(np.hypot(np.sqrt(off @ (weight * off)), parameter - guess.parameter))
            if bend > _STRAIGHT and astray < _ASTRAY * stride:
                there = kind(x, parameter)
                if there == here or point.slope * last.slope < 0.0 or stride <= close * longest:
                    points.append(point)
                    here = there
                    stride = min(longest, stride * float(np.clip(_WANTED / iterations, 0.5, 2.0)))
                    continue
        stride /= 2.0
        if stride < _SHORTEST * longest:
            break
    return points


_STRAIGHT = 0.9
"""Cosine of the largest angle between neighbouring tangents."""

_ASTRAY = 0.3
"""Distance of a point from the tangent's prediction, over the step, above which it is rejected."""

_SHORTEST = 1e-6


def _tangent(
    x: Floats, parameter: float, rate: Floats, weight: Floats, last: Hyperplane | None
) -> Hyperplane:
    """Return the point with the unit tangent along dx/dλ, in the direction of the last one."""
    length = float(np.sqrt(rate @ (weight * rate) + 1.0))
    tangent, slope = rate / length, 1.0 / length
    if last is not None and tangent @ (weight * last.tangent) + slope * last.slope < 0.0:
        tangent, slope = -tangent, -slope
    return Hyperplane(x, parameter, tangent, slope, weight)
