"""Torsion bars: what the long fibres of a wide section add at large twist."""

from math import isfinite, pi
from typing import Any, ClassVar, NamedTuple, Protocol

from flexcli.parts.bending.base import UNKNOWN, Bending, Change, Changes
from flexcli.parts.elastic import Elastic

__all__ = ["EndErrors", "Twist", "TwistedBars"]

UNEVEN = 0.05
"""Of the stresses of a strip whose ends cannot warp, at the most, as the long fibres even out its
rate of twist along the bar; no more than they change by themselves."""


class EndErrors(NamedTuple):
    """What ends that cannot warp leave unsure of stiffness and stress [-]."""

    stiffness: float = 0.0
    stress: float = 0.0


class TwistedBars(Protocol):
    """What bars on one axis tell of their twist."""

    @property
    def is_restrained(self) -> bool:
        """Return whether the clamps keep the section from warping."""

    @property
    def may_shorten(self) -> tuple[bool, ...]:
        """Return whether the ends may come closer, both where nothing says so."""

    def farthest(self, sizes: Any) -> float:
        """Return how far the farthest fibre is from the axis [m]."""

    def core_error(self, sizes: Any) -> float:
        """Return how far off what strips that cross add to their stiffness may be [-]."""

    def side_error(self, sizes: Any) -> float:
        """Return how far off the stress in the middle of its sides may be [-]."""

    def end_errors(self, sizes: Any, nu: float | None) -> "EndErrors":
        """Return what ends that cannot warp leave unsure."""

    def end_stresses(self, elastic: Elastic, sizes: Any, travel: float) -> dict[str, Any]:
        """Return the stress at each place [Pa]."""

    def fibre_stress(self, elastic: Elastic, sizes: Any, twist: float, *, free: bool) -> Any:
        """Return the stress with that of the long fibres [Pa]."""


class Twist(Bending):
    """Bars twisted by θ; ν is that of the material, or unknown to its closed forms as well."""

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
        """Return the slope of the fibre that is farthest from the axis."""
        return self.bars.farthest(self.sizes) * self.theta / float(self.sizes.l)

    def shear(self, poisson_ratio: float) -> Changes:
        """Return nothing: shear is what twists them."""
        return {}

    def extension(self) -> Changes:
        """Return nothing at rest."""
        return {}

    def stretched(self, n: float, direction: float | None) -> Changes:
        """Return nothing: no force acts along them."""
        return {}

    def rotation(self) -> Changes:
        """Return the stress with that of the long fibres.

        It is between ends that may come closer and such that may not, where the spec leaves it
        open.
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
        error += self.bars.side_error(self.sizes) + ends.stress
        error += min(UNEVEN, value) * self.bars.is_restrained
        found["stress"] = Change(value, value + error, error, 1) if isfinite(error) else UNKNOWN
        return found

    def tension(self) -> Changes:
        """Return nothing: it is with the long fibres."""
        return {}

    def load(self, n: float) -> Changes:
        """Return nothing: no force acts along them."""
        return {}
