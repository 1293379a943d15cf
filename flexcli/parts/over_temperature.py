"""Properties of a material over temperature: points with their source, lines between them."""

from collections.abc import Iterable
from itertools import pairwise
from math import inf
from typing import Annotated, Any

import numpy as np
from pydantic import Field, model_validator

from flexcli.parts.base import Part, QuantityOf, Stress, spec_error
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.sourced import WithSource

__all__ = ["Kelvin", "OverTemperature", "Points"]

Kelvin = Annotated[float, QuantityOf("temperature", at_least=0.0)]
Share = Annotated[float, QuantityOf("ratio", above=-0.5, below=0.5)]

CONTINUED = frozenset({"elongation", "youngs_modulus"})
"""What is taken beyond its hottest point, and said so; a strength is not."""

ROUNDING = 1e-9
"""Of temperatures that are sums [K]."""


class Points(WithSource):
    """A property at temperatures, with straight lines between and nothing beyond."""

    points: Any

    @model_validator(mode="after")
    def _rises(self) -> "Points":
        for index, ((low, _), (high, _)) in enumerate(pairwise(self.points)):
            if low >= high:
                raise spec_error(
                    "temperatures must rise from point to point",
                    "put the points in order",
                    at=("points", index + 1),
                )
        return self

    @property
    def range(self) -> tuple[float, float]:
        """Return the lowest and the highest temperature of the points [K]."""
        return self.points[0][0], self.points[-1][0]

    def holds(self, temperature: float) -> bool:
        """Return whether a temperature lies between the points."""
        low, high = self.range
        return low - ROUNDING <= temperature <= high + ROUNDING

    def at(self, temperature: float) -> float:
        """Return the property at a temperature between the points.

        Raises
        ------
        NotAvailable
            Beyond them.

        """
        if not self.holds(temperature):
            low, high = self.range
            text = f"the material is given from {low:g} to {high:g} K, not at {temperature:g} K"
            raise NotAvailable(text)
        T, values = zip(*self.points, strict=True)
        return float(np.interp(temperature, T, values))


class Elongations(Points):
    """Change of length over the length at any one temperature, at temperatures."""

    points: Annotated[tuple[tuple[Kelvin, Share], ...], Field(min_length=2)]
    """Temperatures, rising, and ΔL/L there, e.g. ``[[80 K, -0.391 %], [293 K, 0 %]]``."""


class Stresses(Points):
    """A modulus or a strength at temperatures."""

    points: Annotated[tuple[tuple[Kelvin, Stress], ...], Field(min_length=2)]
    """Temperatures, rising, and the value there, e.g. ``[[80 K, 77.1 GPa], [293 K, 70.4 GPa]]``."""


class OverTemperature(Part):
    """What changes with temperature; what is not given stays as it is at assembly.

    Strengths and moduli count by their ratio to the curve at assembly, so that the values of the
    material hold there.
    """

    elongation: Elongations | None = None
    """Change of length over the length at any one temperature, ΔL/L: its differences count,
    e.g. ``{points: [[80 K, -0.391 %], [293 K, 0 %]], status: handbook, source: my handbook}``.
    """
    youngs_modulus: Stresses | None = None
    """Young's modulus, e.g. ``{points: [[80 K, 77.1 GPa], [293 K, 70.4 GPa]]}``."""
    yield_strength: Stresses | None = None
    """Yield strength, e.g. ``{points: [[77 K, 330 MPa], [293 K, 276 MPa]]}``."""
    tensile_strength: Stresses | None = None
    """Tensile strength, e.g. ``{points: [[77 K, 410 MPa], [293 K, 310 MPa]]}``."""
    fatigue_amplitude: Stresses | None = None
    """Fatigue strength, of which an S-N curve changes by the same ratio,
    e.g. ``{points: [[77 K, 140 MPa], [293 K, 97 MPa]]}``.
    """

    @model_validator(mode="after")
    def _says_something(self) -> "OverTemperature":
        if not any(getattr(self, name) for name in type(self).model_fields):
            raise spec_error(
                "nothing is given over temperature", "give e.g. elongation: {points: …}"
            )
        return self

    def refused(self, temperatures: Iterable[float]) -> tuple[str, ...]:
        """Return the properties, with their ranges, that do not reach to all temperatures [K]."""
        asked, found = tuple(temperatures), []
        for name, points in self._given().items():
            top = max(asked) if name in CONTINUED else points.range[1]
            if min(asked) < points.range[0] - ROUNDING or max(asked) > top + ROUNDING:
                low, high = points.range
                found.append(f"{name} ({low:g} to {high:g} K)")
        return tuple(found)

    def continued(self, temperatures: Iterable[float]) -> tuple[str, ...]:
        """Return the properties, with the end of their points, that are taken as beyond it."""
        hottest = max(temperatures)
        return tuple(
            f"{name} ({points.range[1]:g} K)"
            for name, points in self._given().items()
            if name in CONTINUED and hottest > points.range[1] + ROUNDING
        )

    @property
    def given(self) -> frozenset[str]:
        """Return the properties that have points."""
        return frozenset(self._given())

    def _given(self) -> dict[str, Points]:
        each = {name: getattr(self, name) for name in type(self).model_fields}
        return {name: points for name, points in each.items() if points is not None}

    def ratio(self, name: str, temperature: float, assembly: float) -> float:
        """Return a property at a temperature over that at assembly [-]; 1 where it is not given.

        Young's modulus stays beyond its hottest point as it is there.
        """
        points: Points | None = getattr(self, name)
        if points is None:
            return 1.0
        top = points.range[1] if name in CONTINUED else inf
        return points.at(min(temperature, top)) / points.at(min(assembly, top))

    def growth(self, temperature: float, assembly: float, beyond: float | None) -> float | None:
        """Return the change of length from assembly over the length there [-], where given.

        Parameters
        ----------
        temperature, assembly : float
            Temperature, and that of assembly [K].
        beyond : float or None
            Coefficient of expansion beyond the hottest point [1/K].

        """
        points = self.elongation
        if points is None:
            return None

        def length(T: float) -> float:
            top = points.range[1]
            if top >= T or beyond is None:
                return points.at(T)
            return points.at(top) + beyond * (T - top)

        start = length(assembly)
        return (length(temperature) - start) / (1.0 + start)
