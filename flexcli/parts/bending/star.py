"""Pivots of three or more blades that point at one centre."""

from collections.abc import Sequence
from math import inf
from typing import ClassVar

from flexcli.formulas import held_blades, star_next_order
from flexcli.formulas.section import shear_parameter
from flexcli.numerics.rows import number, one_by_one
from flexcli.parts.bending.base import UNKNOWN, Bending, Change, Changes, whole

__all__ = ["Star"]

EVEN = 1e-9
"""How far the shares of blades evenly around their centre may be from 1 by rounding."""

WEAK = -4.0, 15.0
"""Range of tensions [EI/l²] in which the second order describes how the blades hold the centre."""


class Star(Bending):
    """Blades in given directions, the inner ends p from the centre, turned by θ.

    Evenly around the centre they hold it, and stretch with the square of the rotation; otherwise it
    shifts as well, and their stress at large rotation has not been derived.
    """

    travel_most: ClassVar[float] = 0.35

    def __init__(
        self, *, h: float, l: float, p: float, theta: float, angles: Sequence[float]
    ) -> None:
        self.slender = h / l
        self.gamma = 1.0 + 2.0 * p / l
        self.theta = theta
        self.angles = tuple(angles)
        self.blade = {"h": h, "l": l, "p": p, "theta": theta}
        shares = star_next_order.held_shares(self.angles)
        self.even = all(abs(share - 1.0) < EVEN for share in shares)

    @property
    def ratio(self) -> float:
        """Return θ, with an unknown order where the blades are uneven."""
        return abs(self.theta) if self.even else inf

    def shear(self, poisson_ratio: float) -> Changes:
        """Return the changes by shear in the S-shaped bending, exactly at small rotation."""
        Phi = shear_parameter(depth=self.blade["h"], l=self.blade["l"], poisson_ratio=poisson_ratio)
        soft, plain = self._at_rest(Phi, self.slender), self._at_rest(0.0, self.slender)
        found = {"stiffness": whole(soft.stiffness / plain.stiffness - 1.0)}
        if self.theta:
            found["stress"] = whole(soft.bending / plain.bending - 1.0)
        return found

    def extension(self) -> Changes:
        """Return the changes by stretching where the centre shifts, exactly at small rotation."""
        plain, stiff = self._at_rest(0.0, self.slender), self._at_rest(0.0, STIFF)
        found = {"stiffness": whole(plain.stiffness / stiff.stiffness - 1.0)}
        if self.theta:
            found["stress"] = whole(plain.bending / stiff.bending - 1.0)
        return found

    def stretched(self, n: float, direction: float | None) -> Changes:
        """Return an unknown change: it has not been derived."""
        return {"stress": UNKNOWN} if n else {}

    def rotation(self) -> Changes:
        """Return the change of the bending by the tension, and the axial stress itself."""
        if not self.theta:
            return {}
        if not self.even:
            return {"stress": UNKNOWN}
        n = number(star_next_order.tension(**self.blade))
        if not WEAK[0] < n < WEAK[1]:
            return {"stress": UNKNOWN}
        bends = number(star_next_order.stress_change(angles=self.angles, **self.blade))
        most = 1.0 + 3.0 * abs(self.gamma)
        pulls = abs(n) * self.slender / (6.0 * abs(self.theta) * most)
        size = abs(bends) + pulls
        error = (0.035 * abs(n) + 10.0 * self.slender**2) * size + 0.5 * self.theta**2
        return {"stress": Change(bends + pulls, size, error)}

    def tension(self) -> Changes:
        """Return the axial stress of blades whose centre shifts, at small rotation."""
        if not self.theta:
            return {}
        found = self._at_rest(0.0, self.slender)
        return {"stress": whole(found.stress / found.bending - 1.0)}

    def load(self, n: float) -> Changes:
        """Return an unknown change: it has not been derived."""
        return {"stress": UNKNOWN} if n else {}

    def _at_rest(self, Phi: float, slender: float) -> held_blades.AtRest:
        def at_rest(slender: float, gamma: float, Phi: float) -> held_blades.AtRest:
            return held_blades.at_rest(slender=slender, gamma=gamma, angles=self.angles, Phi=Phi)

        found: held_blades.AtRest = one_by_one(at_rest, slender, self.gamma, Phi)
        return found


STIFF = 1e-6
"""h/l of blades with negligible stretching."""
