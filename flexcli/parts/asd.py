"""The acceleration spectral density of a vibration environment, and how a case uses it."""

from itertools import pairwise
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import model_validator

from flexcli.parts.base import (
    Acceleration,
    AccelerationDensity,
    Duration,
    Frequency,
    Mass,
    Part,
    Ratio,
    spec_error,
)

__all__ = ["ASDProfile", "Breakpoint", "MassScaling", "RandomVibration"]


class Breakpoint(Part):
    """One corner of a profile."""

    frequency: Frequency
    level: AccelerationDensity


class MassScaling(Part):
    """How the level falls for items heavier than a reference mass: level ∝ reference/mass."""

    reference: Mass
    limit: Mass


class ASDProfile(Part):
    """Breakpoints of an acceleration spectral density; a repeated frequency is a step."""

    name: str = ""
    standard: str = ""
    revision: str = ""
    location: str = ""
    status: Literal["verified", "unverified", "reconstructed", "given"] = "given"
    note: str = ""
    points: tuple[Breakpoint, ...]
    interpolation: Literal["log-log", "linear"] = "log-log"
    duration: Duration | None = None
    axis: str = ""
    published_grms: Acceleration | None = None
    mass_scaling: MassScaling | None = None

    @model_validator(mode="after")
    def _points_in_order(self) -> "ASDProfile":
        if len(self.points) < 2:
            raise spec_error(
                "a profile needs two points or more",
                "add the other end of the band",
                at=("points",),
            )
        for index, (first, second) in enumerate(pairwise(self.points)):
            at = ("points", index + 1, "frequency")
            if second.frequency < first.frequency:
                raise spec_error("frequencies must rise", "put the points in order", at=at)
            if second.frequency == first.frequency:
                if second.level == first.level:
                    raise spec_error("this point stands twice", "remove one of them", at=at)
                if index and self.points[index - 1].frequency == first.frequency:
                    raise spec_error("three points share this frequency", "a step has two", at=at)
        if self.points[0].frequency == self.points[-1].frequency:
            raise spec_error("the band has no width", "add a second frequency", at=("points",))
        return self

    @property
    def frequencies(self) -> NDArray[np.float64]:
        """Return the frequencies of the breakpoints [Hz]."""
        return np.array([p.frequency for p in self.points])

    @property
    def scale(self) -> Literal["log", "linear"]:
        """Return the axes in which the profile is straight."""
        return "linear" if self.interpolation == "linear" else "log"

    @property
    def levels(self) -> NDArray[np.float64]:
        """Return the levels of the breakpoints [(m/s²)²/Hz]."""
        return np.array([p.level for p in self.points])


class RandomVibration(Part):
    """A profile, the quality factor of the response, and how many sigma are designed for."""

    profile: ASDProfile
    q: Ratio
    sigma: Ratio = 3.0
    axis: Literal["x"] = "x"

    @model_validator(mode="before")
    @classmethod
    def _say_what_is_needed(cls, data: Any) -> Any:
        if not isinstance(data, dict):
            raise spec_error(
                "a vibration case needs its profile and Q", "write {profile: my.yaml, q: 100}"
            )
        return data
