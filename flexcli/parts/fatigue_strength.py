"""Strength of a material as an amplitude: at one number of cycles, or over them."""

from itertools import pairwise
from typing import Annotated, Any

from pydantic import model_validator

from flexcli.parts.base import Count, Part, QuantityOf, Stress, spec_error
from flexcli.parts.sourced import WithSource

__all__ = ["Basquin", "FatigueAmplitude", "SNCurve", "SNPoint"]


class FatigueAmplitude(WithSource):
    """Stress amplitude (half of the range) that is borne for a number of cycles."""

    value: Stress
    """Stress amplitude, half of the range, e.g. ``510 MPa``."""
    cycles: Count | None = None
    """Number of cycles that it is borne for, e.g. ``1e7``."""
    stress_ratio: Annotated[float, QuantityOf("ratio", at_least=-1.0, below=1.0)] | None = None
    """Least over largest stress of the test: -1 is fully reversed, e.g. ``-1``."""

    @model_validator(mode="before")
    @classmethod
    def _must_be_mapping(cls, data: Any) -> Any:
        if not isinstance(data, dict):
            raise spec_error(
                "a fatigue amplitude holds for a number of cycles",
                "write {value: 510 MPa, cycles: 1e7}",
            )
        return data


class SNPoint(Part):
    """One point of an S-N curve: cycles to failure at a stress amplitude."""

    cycles: Count
    """Cycles to failure, e.g. ``1e4``."""
    amplitude: Stress
    """Stress amplitude, half of the range, e.g. ``700 MPa``."""


class Basquin(Part):
    """Amplitude = coefficient (2 N)^exponent between two lives."""

    coefficient: Stress
    """Stress amplitude at half a cycle, e.g. ``2000 MPa``."""
    exponent: Annotated[float, QuantityOf("ratio", above=-1.0, below=0.0)]
    """Exponent of 2 N, negative, e.g. ``-0.1``."""
    from_cycles: Count = 1e3
    """Life from which the line holds, e.g. ``1e3``."""
    to_cycles: Count
    """Life up to which the line holds, e.g. ``1e7``."""

    @model_validator(mode="after")
    def _in_order(self) -> "Basquin":
        if self.from_cycles >= self.to_cycles:
            raise spec_error(
                "from_cycles must be below to_cycles", "swap them", at=("from_cycles",)
            )
        return self

    def points(self) -> tuple[tuple[float, float], ...]:
        """Return the two ends of the line as (cycles, amplitude)."""
        return tuple(
            (n, self.coefficient * (2.0 * n) ** self.exponent)
            for n in (self.from_cycles, self.to_cycles)
        )


class SNCurve(WithSource):
    """S-N curve in amplitudes: points joined by log-log lines, or Basquin's law."""

    points: tuple[SNPoint, ...] = ()
    """Points of the curve by rising cycles; or give basquin,
    e.g. ``points: [{cycles: 1e4, amplitude: 700 MPa}, {cycles: 1e7, amplitude: 510 MPa}]``.
    """
    basquin: Basquin | None = None
    """Basquin's law, amplitude = coefficient (2 N)^exponent,
    e.g. ``{coefficient: 2000 MPa, exponent: -0.08, to_cycles: 1e7}``.
    """
    stress_ratio: Annotated[float, QuantityOf("ratio", at_least=-1.0, below=1.0)] | None = None
    """Least over largest stress of the tests: -1 is fully reversed,
    e.g. ``stress_ratio: -1, basquin: {coefficient: 2000 MPa, exponent: -0.08, to_cycles: 1e7}``.
    """

    @model_validator(mode="after")
    def _one_description(self) -> "SNCurve":
        if bool(self.points) == (self.basquin is not None):
            raise spec_error(
                "an S-N curve is given by 'points' or by 'basquin'", "give one of them"
            )
        if len(self.points) == 1:
            raise spec_error("an S-N curve needs two points or more", "add a point", at=("points",))
        for index, (first, second) in enumerate(pairwise(self.points)):
            if first.cycles >= second.cycles:
                raise spec_error(
                    "cycles must rise from point to point",
                    "put the points in order",
                    at=("points", index + 1, "cycles"),
                )
            if first.amplitude < second.amplitude:
                raise spec_error(
                    "the amplitude must not rise with the cycles",
                    "check the two points",
                    at=("points", index + 1, "amplitude"),
                )
        return self

    def times(self, factor: float) -> "SNCurve":
        """Return the curve with every amplitude times a factor."""
        if self.basquin is not None:
            coefficient = factor * self.basquin.coefficient
            changed = self.basquin.model_copy(update={"coefficient": coefficient})
            return self.model_copy(update={"basquin": changed})
        points = tuple(
            p.model_copy(update={"amplitude": factor * p.amplitude}) for p in self.points
        )
        return self.model_copy(update={"points": points})

    def curve(self) -> tuple[tuple[float, float], ...]:
        """Return the corners of the curve as (cycles, amplitude)."""
        if self.basquin is not None:
            return self.basquin.points()
        return tuple((p.cycles, p.amplitude) for p in self.points)
