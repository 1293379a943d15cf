"""Joints whose closed forms have no error estimates: every effect may change all their numbers."""

from math import inf
from typing import ClassVar

from flexcli.parts.bending.base import UNKNOWN, Bending, Changes

__all__ = ["NotEstimated"]


class NotEstimated(Bending):
    """Linkages, drawn layouts, stars of uneven blades: judged by a finer model."""

    is_estimate: ClassVar[bool] = False

    def __init__(self, *, travel: float) -> None:
        self.travel = travel

    @property
    def ratio(self) -> float:
        """Return that no order is known."""
        return inf

    def shear(self, poisson_ratio: float) -> Changes:
        """Return that it is unknown."""
        return {"stiffness": UNKNOWN, **self._moved()}

    def extension(self) -> Changes:
        """Return that it is unknown."""
        return {"stiffness": UNKNOWN, **self._moved()}

    def stretched(self, n: float, direction: float | None) -> Changes:
        """Return that it is unknown."""
        return {"stress": UNKNOWN} if n else {}

    def rotation(self) -> Changes:
        """Return that it is unknown."""
        return self._moved()

    def tension(self) -> Changes:
        """Return that it is unknown."""
        return {"stress": UNKNOWN} if self.travel else {}

    def load(self, n: float) -> Changes:
        """Return that it is unknown."""
        return {"stress": UNKNOWN} if n else {}

    def _moved(self) -> Changes:
        return {"stress": UNKNOWN, "shift": UNKNOWN} if self.travel else {}
