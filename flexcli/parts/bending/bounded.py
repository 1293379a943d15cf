"""Blades of other joints: bounds of what the effects change, where no formula has the value."""

from collections.abc import Sequence
from math import inf, tan
from typing import ClassVar

from flexcli.formulas import star_next_order
from flexcli.parts.bending.base import Bending, Change, Changes
from flexcli.parts.bending.pair import under_tension

__all__ = ["Bounded"]


class Bounded(Bending):
    """Orders of magnitude: Φ, (h/l)², the travel itself; nothing to correct by.

    ``angles`` are the directions of three or more blades that hold their centre against its
    shift, whose tension grows with (θ l/h)².
    """

    is_estimate: ClassVar[bool] = False

    def __init__(
        self,
        *,
        h: float,
        l: float,
        travel: float,
        share: float,
        p: float = 0.0,
        angles: Sequence[float] = (),
    ) -> None:
        self.h = h
        self.l = l
        self.travel = travel
        self.share = share
        self.p = p
        self.angles = tuple(angles)

    @property
    def ratio(self) -> float:
        """Return the travel, an angle or over the length."""
        return self.travel

    def shear(self, Phi: float) -> Changes:
        """Return Φ times the S-shaped share of the stiffness, Φ of the rest."""
        change = Change(None, self.share * Phi)
        return {"stiffness": change, "stress": Change(None, Phi), "shift": Change(None, Phi)}

    def extension(self) -> Changes:
        """Return (h/l)² over the squared tangent of the narrowest angle between two blades."""
        bound = Change(None, (self.h / self.l) ** 2 * self._narrow)
        return {"stiffness": bound, "stress": bound, "shift": bound}

    def stretched(self, n: float) -> Changes:
        """Return the strain of the force over the travel, six times as for a guided blade."""
        if not self.travel:
            return {}
        strain = n * (self.h / self.l) ** 2 / 12.0
        return {"stress": Change(None, 6.0 * strain * self._narrow / self.travel)}

    def pulled(self, n: float) -> Changes:
        """Return the same as of a pair, by the narrowest angle between two blades."""
        return {"stress": Change(None, 3.0 * self.h / self.l * self._narrow**0.5, sign=1)}

    def amplified(self, n: float) -> Changes:
        """Return nothing known."""
        return {"stress": Change(None, inf)}

    def rotation(self) -> Changes:
        """Return the travel for stress and shift, and the tension of blades that hold a centre."""
        if not self.travel:
            return {}
        stress = self.travel + (self._held_stress() if len(self.angles) > 2 else 0.0)
        return {"stress": Change(None, stress), "shift": Change(None, self.travel)}

    def tension(self) -> Changes:
        """Return h/l over the tangent of that angle."""
        bound = Change(None, self.h / self.l * self._narrow**0.5)
        return {"stress": bound} if self.travel else {}

    def load(self, n: float) -> Changes:
        """Return the change of the end moments of a blade that bends in an S and uniformly."""
        gamma = 1.0 + 2.0 * self.p / self.l
        return {"stress": Change(None, under_tension(n, gamma))}

    @property
    def _narrow(self) -> float:
        """Return max 1/tan² of half the angle between blades, at least 1."""
        apart = [
            abs(tan((one - other) / 2.0))
            for i, one in enumerate(self.angles)
            for other in self.angles[:i]
        ]
        least = min(apart, default=1.0)
        return max(1.0, least**-2) if least else inf

    def _held_stress(self) -> float:
        """Return tension over bending stress, and what the tension adds to the bending."""
        blade = {"h": self.h, "l": self.l, "p": self.p, "theta": self.travel}
        shares = star_next_order.held_shares(self.angles)
        n = max(abs(float(star_next_order.tension(share=share, **blade))) for share in shares)
        most = 1.0 + 3.0 * abs(1.0 + 2.0 * self.p / self.l)
        bends = abs(float(star_next_order.stress_change(angles=self.angles, **blade)))
        return n * self.h / (6.0 * self.l * self.travel * most) + bends
