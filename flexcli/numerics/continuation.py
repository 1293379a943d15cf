"""Following solutions of many designs as a parameter goes from 0 to 1, with step control."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import Outcome
from flexcli.numerics.newton import CONTRACTION, NewtonResult

__all__ = ["BENT", "TRUST", "March", "march"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

TRUST = 0.3
"""Longest correction [-] of a step along the tangent: a longer one may reach another branch."""

_SMALLEST = 1e-5
"""Share of the way below which a step is no longer halved: the path turns or ends there."""

BENT = 0.02
"""Correction [-] above which the step is checked backwards, to a solution of the same kind."""

_MOST_STEPS = 120


class March(NamedTuple):
    """Points reached (designs, m), the parameter there (1: all the way), outcomes, iterations."""

    x: Floats
    reached: Floats
    end: NDArray[np.object_]
    iterations: Integers
    last_step: Floats


def march(
    correct: Callable[[Floats, Floats, Integers], NewtonResult],
    step: Callable[[Floats, Floats, Integers], Floats],
    length: Callable[[Floats, Floats], Floats],
    kind: Callable[[Floats, Floats, Integers], Integers],
    start: Floats,
) -> March:
    """Return where the path from ``start`` at parameter 0 leads at parameter 1.

    Parameters
    ----------
    correct : callable
        ``correct(x, parameter, rows)`` runs Newton's method from x at the parameters given, for
        the designs ``rows``; its first step must be the tangent of the path.
    step, length : callable
        One step of Newton's method at the parameters given, and its length.
    kind : callable
        ``kind(x, parameter, rows)`` gives a number for each solution that stays the same along a
        path without critical points (the number of negative directions; zero where stable).
    start : array, shape (designs, m)
        Solutions at parameter 0.

    Returns
    -------
    March
        The last solution found of each design and the parameter it belongs to.

    Notes
    -----
    A step's correction grows with the square of its length: after a step that was corrected by c
    the next one is ``√(TRUST/2c)`` as long, between a tenth and three times. A step along a bent
    path must lead back: one step of Newton's method from its end to the parameter of its start,
    along the tangent there, must come as near as the step itself was allowed to be off. From
    behind a limit point it does not. Nor may it lead to an unstable solution of another kind; a
    short step may, so that a path which goes straight on through a branching point is followed.

    References
    ----------
    Allgower & Georg (2003), Introduction to Numerical Continuation Methods, section 6.1.

    """
    x = start.copy()
    designs = x.shape[0]
    reached = np.zeros(designs)
    stride = np.ones(designs)
    end = np.full(designs, Outcome.CONVERGED, dtype=object)
    iterations = np.zeros(designs, dtype=np.intp)
    last_step = np.zeros(designs)
    rows = np.arange(designs)
    for _ in range(_MOST_STEPS):
        target = np.minimum(1.0, reached[rows] + stride[rows])
        found = correct(x[rows], target, rows)
        iterations[rows] += found.iterations
        good = found.converged
        bent = np.flatnonzero(good & (found.bend > BENT))
        if bent.size:
            back = found.x[bent] + step(found.x[bent], reached[rows[bent]], rows[bent])
            origin = x[rows[bent]]
            off = length(origin, back - origin)
            allowed = np.minimum(TRUST, CONTRACTION * length(origin, found.x[bent] - origin))
            good[bent] = off <= allowed
            # the ground state needs no comparison: to gain stability is no jump
            led = bent[good[bent]]
            at = kind(found.x[led], target[led], rows[led])
            led, at = led[at > 0], at[at > 0]
            if led.size:
                good[led] = at == kind(x[rows[led]], reached[rows[led]], rows[led])
        there = rows[good]
        x[there], reached[there] = found.x[good], target[good]
        last_step[there] = found.last_step[good]
        end[rows] = found.end
        measured = good | (found.end == Outcome.OFF_PATH)
        wanted = np.sqrt(TRUST / 2.0 / np.maximum(found.bend, 1e-3 * TRUST))
        factor = np.where(measured, np.clip(wanted, 0.1, 3.0), 0.25)
        factor = np.where(good, factor, np.minimum(factor, 0.5))
        stride[rows] *= factor
        rows = rows[(reached[rows] < 1.0) & (stride[rows] >= _SMALLEST)]
        if rows.size == 0:
            break
    return March(x, reached, end, iterations, last_step)
