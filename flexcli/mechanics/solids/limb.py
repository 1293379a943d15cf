"""A limb that is rigid between its two necks, under six unit loads about its middle."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.solids.neck import Neck
from flexcli.mechanics.solids.unit_loads import NeckUnderLoads

__all__ = ["RigidLimb", "about"]

Floats = NDArray[np.float64]

LEVERS = {1: 5, 2: 4}
"""Of a force across the limb, the moment that it bends each neck by."""


class RigidLimb:
    """Two equal necks, their throats ``l`` [m] apart: what each gives way adds up."""

    def __init__(self, each: NeckUnderLoads, l: float) -> None:
        self.each = each
        self.l = l

    @property
    def neck(self) -> Neck:
        """Return either neck."""
        return self.each.neck

    def solve(self, indices: Iterable[int]) -> None:
        """Solve loads that will be asked for, told by their places in a wrench."""
        self.each.solve({at for index in indices for at in (index, LEVERS.get(index, index))})

    def compliance(self, index: int) -> tuple[float, float]:
        """Return the compliance to a unit load about the middle, and its relative error."""
        found, error = self.each.compliance(index)
        if index in LEVERS:
            turned, off = self.each.compliance(LEVERS[index])
            turned *= (self.l / 2.0) ** 2
            error = (error * found + off * turned) / (found + turned)
            found += turned
        return 2.0 * found, error

    def stresses(self, wrenches: Floats, orders: tuple[int, int, int]) -> tuple[Floats, Floats]:
        """Return the stresses of wrenches about the middle, as those of the necks.

        The neck beyond the middle comes first, as the octants of a whole limb do.
        """
        either = [self.each.stresses(each, orders) for each in self._about_necks(wrenches)]
        stress, last = zip(*either, strict=True)
        return np.concatenate(stress, axis=1), np.concatenate(last)

    def at_mouth(self, wrenches: Floats) -> float:
        """Return the most that a beam as high as a mouth is stressed there by wrenches [Pa]."""
        return max(self.each.at_mouth(each) for each in self._about_necks(wrenches))

    def apart(self, index: int) -> float:
        """Return by how much the largest stresses of a unit load differ at most by mesh [Pa]."""
        found = self.each.apart(index)
        if index in LEVERS:
            found += self.l / 2.0 * self.each.apart(LEVERS[index])
        return found

    def _about_necks(self, wrenches: Floats) -> tuple[Floats, Floats]:
        return about(wrenches, self.l / 2.0), about(wrenches, -self.l / 2.0)


def about(wrenches: Floats, x: Floats | float) -> Floats:
    """Return wrenches (..., 6) about a place farther along by x [m]."""
    found = np.array(wrenches, dtype=np.float64)
    found[..., 4] += x * found[..., 2]
    found[..., 5] -= x * found[..., 1]
    return found
