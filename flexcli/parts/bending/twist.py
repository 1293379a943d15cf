"""Torsion bars: the longitudinal fibres of a wide section at large twist."""

from math import isfinite, pi
from typing import Any, ClassVar, NamedTuple, Protocol

from flexcli.parts.bending.base import UNKNOWN, Bending, Change, Changes
from flexcli.parts.elastic import Elastic

__all__ = ["EndErrors", "Twist", "TwistedBars"]


class EndErrors(NamedTuple):
    """Relative errors of stiffness and stress by ends that cannot warp [-]."""

    stiffness: float = 0.0
    stress: float = 0.0


class TwistedBars(Protocol):
    """The bars on one axis, as the effects of twist need them."""

    @property
    def may_shorten(self) -> tuple[bool, ...]:
        """Return whether the ends may approach each other; None where it is unknown."""

    def farthest(self, sizes: Any) -> float:
        """Return how far the farthest fibre is from the axis [m]."""

    def core_error(self, sizes: Any) -> float:
        """Return the relative error of the stiffness that crossing strips add at their core [-]."""

    def side_error(self, sizes: Any) -> float:
        """Return the relative error of the stress in the middle of its sides [-]."""

    def end_errors(self, sizes: Any, nu: float | None) -> "EndErrors":
        """Return the errors of stiffness and stress by ends that cannot warp."""

    def end_stresses(self, elastic: Elastic, sizes: Any, travel: float) -> dict[str, Any]:
        """Return the stress at each place [Pa]."""

    def fibre_stress(self, elastic: Elastic, sizes: Any, twist: float, *, free: bool) -> Any:
        """Return the stress with that of the longitudinal fibres [Pa]."""

    def fibre_error(self, elastic: Elastic, sizes: Any, twist: float, *, free: bool) -> float:
        """Return the error of what fibres add, over the stress with them [-]."""


class Twist(Bending):
    """Bars twisted by θ; ν is that of the material, or unknown."""

    travel_most: ClassVar[float] = 2.0 * pi

    def __init__(self, bars: TwistedBars, elastic: Elastic, sizes: Any, theta: float) -> None:
        self.bars = bars
        self.elastic = elastic
        self.sizes = sizes
        self.theta = theta

    @property
    def ratio(self) -> float:
        """Return the square of the steepest fibre."""
        return self._steep**2

    @property
    def _steep(self) -> float:
        """Return the slope of the outermost fibre."""
        return self.bars.farthest(self.sizes) * self.theta / float(self.sizes.l)

    def shear(self, poisson_ratio: float) -> Changes:
        """Return no change: shear is how they twist."""
        return {}

    def extension(self) -> Changes:
        """Return nothing at rest."""
        return {}

    def stretched(self, n: float, direction: float | None) -> Changes:
        """Return no change: no force acts along them."""
        return {}

    def rotation(self) -> Changes:
        """Return the stress with that of the longitudinal fibres.

        Where the spec leaves open whether the ends may approach each other, it lies between both
        cases.
        """
        ends = self.bars.end_errors(self.sizes, self.elastic.nu)
        error = self.bars.core_error(self.sizes) + ends.stiffness
        found = {"stiffness": Change(0.0, error, error) if isfinite(error) else UNKNOWN}
        if not self.theta:
            return found
        plain = max(
            abs(float(s))
            for s in self.bars.end_stresses(self.elastic, self.sizes, self.theta).values()
        )
        found_at = [
            float(self.bars.fibre_stress(self.elastic, self.sizes, self.theta, free=free))
            for free in self.bars.may_shorten
        ]
        low, high = (max(end(found_at), plain) / plain for end in (min, max))
        value = (low + high) / 2.0 - 1.0
        error = (high - low) / (high + low) + self.ratio
        of_section = self.bars.side_error(self.sizes) + ends.stress
        error += of_section
        error += max(
            self.bars.fibre_error(self.elastic, self.sizes, self.theta, free=free)
            for free in self.bars.may_shorten
        )
        # fibres only add to a stress, whose own error is to either side
        sign = 0 if of_section else 1
        found["stress"] = Change(value, value + error, error, sign) if isfinite(error) else UNKNOWN
        return found

    def tension(self) -> Changes:
        """Return no change: :meth:`rotation` includes it."""
        return {}

    def load(self, n: float) -> Changes:
        """Return no change: no force acts along them."""
        return {}
