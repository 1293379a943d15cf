"""A linkage followed over its input from the assembled pose, to where the input stops and why."""

from dataclasses import dataclass
from enum import Enum
from math import inf
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.linkages.equations import Loops, loops
from flexcli.mechanics.linkages.linkage import Linkage
from flexcli.mechanics.linkages.mobility import require_one_freedom
from flexcli.mechanics.linkages.motion import LinkageMotion, motion_of
from flexcli.numerics.loop_closure import Curve, follow, solve_at

__all__ = ["Stop", "Travel", "TravelLimit", "motion", "travel"]

Floats = NDArray[np.float64]

DEAD = 1e-3
"""Ratio of the smallest singular values with and without the input's row that tells a dead point
(only the input stands still: the ratio tends to zero) from a branch point (it tends to a constant).
"""


class TravelLimit(Enum):
    """Why a linkage is followed no farther."""

    RANGE = "the end asked for"
    DEAD_POINT = "the input has reached an extreme of its own motion and cannot drive past it"
    BRANCH_POINT = "links line up and the linkage may go on in either of two ways"


class Stop(NamedTuple):
    """Where the input stops [rad or m], and why."""

    input: float
    end: TravelLimit


@dataclass(frozen=True, eq=False)
class Travel:
    """A linkage followed from its assembled pose to a stop of the input on either side."""

    linkage: Linkage
    low: Stop
    high: Stop
    curve: Curve

    @property
    def nodes(self) -> Floats:
        """Return the inputs at which the travel stepped, from stop to stop."""
        equations = loops(self.linkage)
        return self.curve.parameters * float(equations.units()[equations.input])

    def at(self, inputs: ArrayLike) -> LinkageMotion:
        """Return the motion at values of the input [rad or m], of any shape.

        Raises
        ------
        SolveError
            When a value lies beyond a stop; its code is ``dead-point``, ``branch-point``, or
            ``not-followed`` when the travel was asked for no farther.
        """
        values = np.asarray(inputs, dtype=np.float64)
        for stop, beyond in ((self.low, values < self.low.input),
                             (self.high, values > self.high.input)):  # fmt: skip
            if np.any(beyond):
                raise _refusal(self.linkage, stop)
        equations = loops(self.linkage)
        unit = equations.units()
        # the clip takes back what the change of units rounds beyond an end
        scaled = np.clip(values.ravel() / unit[equations.input], *self.curve.parameters[[0, -1]])
        return motion_of(self.linkage, values, solve_at(equations, self.curve, scaled))


def travel(linkage: Linkage, start: float, end: float) -> Travel:
    """Return the linkage followed from rest to both ends of a range of its input.

    The branch is that of the assembled pose; where a singular pose comes before an end the travel
    stops there, and its stop says why.

    Parameters
    ----------
    linkage : Linkage
        With one degree of freedom.
    start, end : float
        Range of the input's deflection [rad or m], start ≤ end; rest (0) may lie outside.

    Returns
    -------
    Travel
        To be asked for motions and extremes.

    Notes
    -----
    A dead point is found to some 1e-11, a branch point, where rounding moves the links, to some
    1e-7 of the input's unit (1 rad, or the size of the linkage).

    Raises
    ------
    ValueError
        When an end is not finite or start ≤ end does not hold.
    SolveError
        When the linkage has not one degree of freedom that its input drives.

    Examples
    --------
    >>> from flexcli.mechanics.linkages.linkage import Prismatic, Revolute
    >>> slider_crank = Linkage(
    ...     (Revolute("theta", "base", "crank", (0.0, 0.0)),
    ...      Revolute("elbow", "crank", "rod", (0.0, 1.0)),
    ...      Revolute("wrist", "rod", "stage", (1.0, 0.0)),
    ...      Prismatic("z", "base", "stage", (1.0, 0.0))),
    ...     ground="base", input="z")
    >>> reached = travel(slider_crank, -0.5, 2.0)
    >>> reached.high.end.name, round(reached.high.input, 9)
    ('DEAD_POINT', 1.414213562)

    """
    if not -inf < start <= end < inf:
        raise ValueError(f"no range of the input goes from {start:g} to {end:g}")
    require_one_freedom(linkage)
    equations = loops(linkage)
    unit = float(equations.units()[equations.input])
    low, high = min(start, 0.0), max(end, 0.0)
    curve = follow(
        equations, np.zeros(3 * equations.moving), start=0.0, low=low / unit, high=high / unit
    )
    return Travel(
        linkage,
        _stop(equations, curve, 0, low / unit, low, unit),
        _stop(equations, curve, -1, high / unit, high, unit),
        curve,
    )


def motion(linkage: Linkage, inputs: ArrayLike) -> LinkageMotion:
    """Return the deflection of every joint at values of the input, from the assembled pose.

    Parameters
    ----------
    linkage : Linkage
        With one degree of freedom.
    inputs : array_like
        Deflections of the input joint [rad or m].

    Returns
    -------
    LinkageMotion
        Deflections, their first and second derivatives, and poses.

    Raises
    ------
    SolveError
        When a value lies beyond a dead point (``dead-point``) or a branch point
        (``branch-point``), or the linkage has not one degree of freedom.

    """
    values = np.asarray(inputs, dtype=np.float64)
    return travel(linkage, float(values.min(initial=0.0)), float(values.max(initial=0.0))).at(
        values
    )


def _stop(
    equations: Loops, curve: Curve, index: int, asked: float, value: float, unit: float
) -> Stop:
    """Return the stop at one end of a curve, told apart by what turns singular there."""
    reached = float(curve.parameters[index])
    if reached == asked:
        return Stop(value, TravelLimit.RANGE)
    J = equations.jacobian(curve.points.q[index])
    smallest = np.linalg.svd(J, compute_uv=False)[-1]
    closed = np.linalg.svd(J[:-1], compute_uv=False)[-1]
    end = TravelLimit.DEAD_POINT if smallest < DEAD * closed else TravelLimit.BRANCH_POINT
    return Stop(reached * unit, end)


def _refusal(linkage: Linkage, stop: Stop) -> SolveError:
    codes = {
        TravelLimit.RANGE: ("not-followed", "follow the linkage over a wider range"),
        TravelLimit.DEAD_POINT: ("dead-point", "shorten the range, or drive another joint"),
        TravelLimit.BRANCH_POINT: ("branch-point", "shorten the range, or change a link's length"),
    }
    code, remedy = codes[stop.end]
    text = f"the input '{linkage.input}' stops at {stop.input:.9g}: {stop.end.value}"
    return SolveError(code, text, remedy)
