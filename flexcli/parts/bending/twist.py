"""Torsion bars: what the long fibres of a wide section add at large twist."""

from math import pi
from typing import ClassVar

from flexcli.parts.bending.base import Bending, Change, Changes
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.torsion import TorsionGeometry

__all__ = ["Twist"]

RESTRAINED = 0.01
"""Of the stiffness of a strip whose ends cannot warp, against a clamped plate."""

RESTRAINED_STRESS = 0.05
"""Of its stresses, whose rate of twist the long fibres even out along the bar."""


class Twist(Bending):
    """Bars twisted by θ; ν is that of the material, or unknown to its closed forms as well."""

    travel_most: ClassVar[float] = 2.0 * pi

    def __init__(
        self, geometry: TorsionGeometry, elastic: Elastic, sizes: object, theta: float
    ) -> None:
        self.geometry = geometry
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
        edge = self.geometry.section(self.sizes).edge
        return float(edge**0.5 * self.theta / self.sizes.l)  # type: ignore[attr-defined]

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
        restrained = self.geometry.is_restrained
        found = {"stiffness": Change(0.0, 0.0, RESTRAINED if restrained else 0.0)}
        if not self.theta:
            return found
        plain = max(
            abs(float(s))
            for s in self.geometry.end_stresses(self.elastic, self.sizes, self.theta).values()
        )
        ends = [
            float(self.geometry.fibre_stress(self.elastic, self.sizes, self.theta, free=free))
            for free in self.geometry.may_shorten
        ]
        low, high = (max(end(ends), plain) / plain for end in (min, max))
        value = (low + high) / 2.0 - 1.0
        error = (high - low) / (high + low) + self.ratio + RESTRAINED_STRESS * restrained
        found["stress"] = Change(value, value, error, 1)
        return found

    def tension(self) -> Changes:
        """Return nothing: it is with the long fibres."""
        return {}

    def load(self, n: float) -> Changes:
        """Return nothing: no force acts along them."""
        return {}
