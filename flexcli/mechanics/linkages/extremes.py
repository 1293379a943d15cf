"""The extremes that every joint's deflection goes through over a range of the input."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.linkages.travel import Travel

__all__ = ["Extremes", "extremes"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

FINENESS = 4
"""Samples in each step of the travel; a step turns no link by more than some 0.3 rad."""
HALVINGS = 22
"""Cuts a bracket down to 1e-7 of itself: a Newton step then ends at rounding."""


class Extremes(NamedTuple):
    """Least and greatest deflection of a joint [rad or m], and the inputs at which they occur."""

    least: float
    at_least: float
    greatest: float
    at_greatest: float

    @property
    def largest(self) -> float:
        """Return the largest magnitude, which the joint is sized for."""
        return max(-self.least, self.greatest)

    @property
    def at_largest(self) -> float:
        """Return the input at the largest magnitude."""
        return self.at_least if -self.least > self.greatest else self.at_greatest


def extremes(travel: Travel, start: float, end: float) -> dict[str, Extremes]:
    """Return the extremes of every joint's deflection over a range of the input, to rounding.

    They lie at the ends of the range or where the first derivative vanishes. Inflections, zeros
    of the second derivative, part two such turning points that lie between the same samples.

    Parameters
    ----------
    travel : Travel
        The linkage followed over the range.
    start, end : float
        Range of the input [rad or m], start ≤ end.

    Returns
    -------
    dict
        Extremes by joint.

    Raises
    ------
    ValueError
        When start ≤ end does not hold.
    SolveError
        When the range goes beyond a stop of the travel.

    Examples
    --------
    >>> from flexcli.mechanics.linkages.linkage import Linkage, Prismatic, Revolute
    >>> from flexcli.mechanics.linkages.travel import travel
    >>> stage = Linkage(
    ...     (Revolute("theta", "crank", "base", (0.0, 0.0)),
    ...      Revolute("beta", "rod", "crank", (0.0, 50e-3)),
    ...      Revolute("alpha", "stage", "rod", (-50e-3, 50e-3)),
    ...      Prismatic("z", "base", "stage", (1.0, 0.0))),
    ...     ground="base", input="theta")
    >>> end = np.radians(15.0)
    >>> found = extremes(travel(stage, -end, end), -end, end)
    >>> round(found["z"].largest * 1e3, 2), round(float(np.degrees(found["beta"].largest)), 2)
    (12.97, 16.95)

    References
    ----------
    Exercise 12 C takes the extremes at the ends of the range, where they are for its stage.

    """
    if not start <= end:
        raise ValueError(f"no range of the input goes from {start:g} to {end:g}")
    samples = _samples(travel, start, end)
    low, high, _ = _zeros(travel, samples, order=2)
    low, high, joint = _zeros(travel, np.union1d(samples, (low + high) / 2.0), order=1)
    turning = (low + high) / 2.0
    at = travel.at(turning)
    rows = np.arange(turning.size)
    slope, bend = (_table(x)[rows, joint] for x in (at.ratios, at.curvatures))
    newton = np.divide(slope, bend, out=np.zeros_like(slope), where=bend != 0.0)
    turning = np.clip(turning - newton, low, high)
    inputs = np.concatenate([[start, end], turning])
    values = _table(travel.at(inputs).deflections)
    own = np.concatenate([np.full(2, -1), joint])
    found = {}
    for i, each in enumerate(travel.linkage.joints):
        candidates = (own == i) | (own == -1)
        found[each.name] = _extremes(inputs[candidates], values[candidates, i])
    return found


def _extremes(inputs: Floats, values: Floats) -> Extremes:
    least, greatest = int(np.argmin(values)), int(np.argmax(values))
    return Extremes(
        float(values[least]), float(inputs[least]), float(values[greatest]), float(inputs[greatest])
    )


def _samples(travel: Travel, start: float, end: float) -> Floats:
    """Return inputs over the range, a few in each step of the travel."""
    steps = travel.nodes
    index = np.arange((steps.size - 1) * FINENESS + 1) / FINENESS
    fine = np.interp(index, np.arange(steps.size), steps)
    return np.concatenate([[start], fine[(fine > start) & (fine < end)], [end]])


def _table(by_joint: Mapping[str, Floats]) -> Floats:
    return np.stack(list(by_joint.values()), axis=-1)


def _zeros(travel: Travel, samples: Floats, order: int) -> tuple[Floats, Floats, Integers]:
    """Return brackets of the zeros of a derivative of the deflections, and the joint of each."""

    def derivative(inputs: Floats) -> Floats:
        at = travel.at(inputs)
        return _table(at.ratios if order == 1 else at.curvatures)

    values = derivative(samples)
    place, joint = np.nonzero(values[:-1] * values[1:] <= 0.0)
    low, high, sign = samples[place], samples[place + 1], np.sign(values[place, joint])
    rows = np.arange(place.size)
    for _ in range(HALVINGS if place.size else 0):
        middle = (low + high) / 2.0
        before = np.sign(derivative(middle)[rows, joint]) == sign
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    return low, high, joint
