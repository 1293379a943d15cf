"""Blades and notch hinges bent by a moment alone: no force, no stretching, no shear."""

from math import pi
from typing import ClassVar

from flexcli.parts.bending.base import UNKNOWN, Bending, Change, Changes

__all__ = ["Arc"]


class Arc(Bending):
    """A hinge between its base and a body that follows it freely, turned by θ.

    The moment is constant along it, so that stiffness and stress are exact at any rotation.
    """

    travel_most: ClassVar[float] = pi / 2.0

    def __init__(self, *, theta: float) -> None:
        self.theta = theta

    @property
    def ratio(self) -> float:
        """Return θ²: odd orders vanish by symmetry."""
        return self.theta**2

    def shear(self, poisson_ratio: float) -> Changes:
        """Return nothing: no force shears it."""
        return {}

    def extension(self) -> Changes:
        """Return nothing: no force stretches it."""
        return {}

    def stretched(self, n: float, direction: float | None) -> Changes:
        """Return no change: a force through its middle moves the body along it."""
        return {}

    def rotation(self) -> Changes:
        """Return −θ²/32 of the shift: a part between 1/48 (blade) and 1/24 (point) of θ².

        The length of the shift is ``∫cos(θ(f − ½)) ds − l cos(θ/2)``, f the share of the rotation
        up to s.
        """
        square = self.theta**2
        return {"shift": Change(-square / 32.0, square / 24.0, square / 90.0)} if square else {}

    def tension(self) -> Changes:
        """Return nothing: the rotation makes no force."""
        return {}

    def load(self, n: float) -> Changes:
        """Return an unknown change: it has not been derived."""
        return {"stress": UNKNOWN} if n else {}

    def pulled(self, n: float) -> Changes:
        """Return no change: a force along the hinge does not bend it."""
        return {}

    def amplified(self, n: float) -> Changes:
        """Return no change up to half its buckling load with a free end: it is not bent by then."""
        return {} if n < pi**2 / 8.0 else {"stress": UNKNOWN}
