"""Random vibration of the base along several axes, each with a profile of its own."""

from collections.abc import Mapping
from dataclasses import dataclass

from pydantic import model_validator

from flexcli.parts.asd import (
    AppliedASD,
    ASDProfile,
    Axis,
    Gain,
    ItemMass,
    Margin,
    RandomVibration,
    Vibration,
    refuse_mass,
)
from flexcli.parts.base import Duration, Part, spec_error
from flexcli.parts.quality import Quality

__all__ = ["Axes", "AxesVibration", "AxisVibration"]


class AxisVibration(Part):
    """The profile of one axis, and what the case applies to it."""

    asd: ASDProfile
    """The profile: inline, the name of a shipped one, or a path, e.g. ``gevs-qualification``."""
    scale: Gain = 0.0
    """Raises the whole level, e.g. ``-3 dB``."""
    tolerance: Margin = 0.0
    """Raises the level to the upper edge of the test's tolerance, e.g. ``3 dB``."""
    mass: ItemMass | None = None
    """Mass of the item, where the profile scales with it,
    e.g. ``mass: 45 kg, asd: gevs-qualification``.
    """
    duration: Duration | None = None
    """Time it lasts, in place of the profile's, e.g. ``60 s``."""

    def vibration(self, axis: Axis, q: Quality, sigma: float) -> RandomVibration:
        """Return it along its axis."""
        return RandomVibration.model_construct(
            profile=self.asd, q=q, sigma=sigma, axis=axis,
            scale=self.scale, tolerance=self.tolerance, mass=self.mass, duration=self.duration,
        )  # fmt: skip

    @model_validator(mode="after")
    def _mass_can_be_applied(self) -> "AxisVibration":
        refuse_mass(self.asd, self.mass)
        return self


class Axes(Part):
    """Profiles by axis; the axes are independent of each other."""

    x: AxisVibration | None = None
    """Along the stroke of a stage, or a pivot's bisector, e.g. ``{asd: gevs-qualification}``."""
    y: AxisVibration | None = None
    """In the plane across x, e.g. ``{asd: gevs-qualification, scale: -3 dB}``."""
    z: AxisVibration | None = None
    """Along the width of the blades, e.g. ``{asd: gevs-qualification, scale: -3 dB}``."""

    @model_validator(mode="after")
    def _shakes_something(self) -> "Axes":
        if not self.each:
            raise spec_error("no axis is shaken", "give x, y or z a profile, e.g. x: {asd: …}")
        return self

    @property
    def each(self) -> dict[Axis, AxisVibration]:
        """Return the axes that have a profile."""
        given: dict[Axis, AxisVibration | None] = {"x": self.x, "y": self.y, "z": self.z}
        return {axis: own for axis, own in given.items() if own is not None}

    def vibration(self, q: Quality, sigma: float) -> "AxesVibration":
        """Return the vibration of modes with quality factors, designed for so many rms."""
        each = {axis: own.vibration(axis, q, sigma) for axis, own in self.each.items()}
        return AxesVibration(each, q, sigma)


@dataclass(frozen=True, eq=False)
class AxesVibration(Vibration):
    """Several axes, each with a density of its own."""

    each: Mapping[Axis, RandomVibration]
    q: Quality
    sigma: float

    def by_axis(self) -> dict[Axis, AppliedASD]:
        """Return the density along each axis."""
        return {axis: own.applied() for axis, own in self.each.items()}

    def alone(self, axis: Axis) -> RandomVibration:
        """Return what it does along one axis."""
        return self.each[axis]
