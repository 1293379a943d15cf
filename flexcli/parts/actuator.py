"""An actuator that drives the stroke: its force falls in a straight line as it goes out."""

from typing import Literal

from pydantic import model_validator

from flexcli.parts.base import (
    Expansion,
    Part,
    PositiveForce,
    PositiveLength,
    Stiffness,
    spec_error,
)
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import GROUND, Geometry
from flexcli.parts.material import Material
from flexcli.parts.mechanisms import Mechanism
from flexcli.parts.temperature import Temperature

__all__ = ["Actuator"]


class Actuator(Part):
    """What drives the stroke, at full drive: two of its force at rest, free stroke, stiffness."""

    blocking_force: PositiveForce | None = None
    """Force of the actuator held at rest; or give free_stroke and stiffness, e.g. ``5.5 N``."""
    free_stroke: PositiveLength | None = None
    """How far it goes without any load, from rest, e.g. ``85 um``."""
    stiffness: Stiffness | None = None
    """Stiffness of the actuator k_T, in place of force or stroke: the one is k_T times the other,
    e.g. ``stiffness: 60 N/um, free_stroke: 15 um``.
    """
    drives: Literal["one-way", "both-ways"] = "one-way"
    """Whether it pushes out from rest alone, as a stack does, or either way, as a bender may,
    e.g. ``both-ways``.
    """
    arm: PositiveLength | None = None
    """Distance of its force from the axis of a joint that turns, e.g. ``12 mm``."""
    length: PositiveLength | None = None
    """Length along the stroke that grows with the temperature, between the base and what it
    drives,
    e.g. ``length: 20 mm, thermal_expansion: -5e-6 1/K, blocking_force: 5.5 N, free_stroke: 85 um``.
    """
    thermal_expansion: Expansion | None = None
    """Thermal expansion along the stroke; a stack of ceramics shrinks as it warms,
    e.g. ``thermal_expansion: -5e-6 1/K, length: 20 mm, blocking_force: 5.5 N, free_stroke: 85 um``.
    """

    @model_validator(mode="after")
    def _two_of_three(self) -> "Actuator":
        line = {
            "blocking_force": self.blocking_force,
            "free_stroke": self.free_stroke,
            "stiffness": self.stiffness,
        }
        given = [name for name, value in line.items() if value is not None]
        if len(given) != 2:
            raise spec_error(
                "blocking force, free stroke and stiffness follow from two of them",
                "give e.g. blocking_force: 5.5 N and free_stroke: 85 um",
                at=(given[-1],) if given else (),
            )
        for one, other in (("length", "thermal_expansion"), ("thermal_expansion", "length")):
            if getattr(self, one) is not None and getattr(self, other) is None:
                raise spec_error(
                    f"{one} gives the actuator's growth only with {other}",
                    f"give {other} as well",
                    at=(one,),
                )
        return self

    @property
    def force(self) -> float:
        """Return the blocking force [N]."""
        if self.blocking_force is not None:
            return self.blocking_force
        assert self.stiffness is not None  # held by the validator
        assert self.free_stroke is not None
        return self.stiffness * self.free_stroke

    @property
    def k_T(self) -> float:  # noqa: N802 - the source's symbol
        """Return its stiffness [N/m]."""
        if self.stiffness is not None:
            return self.stiffness
        assert self.free_stroke is not None  # held by the validator
        return self.force / self.free_stroke

    def available(self, travel: float, growth: float = 0.0) -> float:
        """Return the force that it has left at a travel of its own, either way [N].

        ``growth`` is how far a change of temperature alone moves it [m], which reduces the force.
        """
        return max(self.force - self.k_T * (abs(travel) + abs(growth)), 0.0)

    def refuse_misfit(self, geometry: Geometry, mechanism: Mechanism | None) -> None:
        """Refuse an arm for a translation, or a rotation without an arm."""
        turns = geometry.motion == "rotation" and (mechanism is None or mechanism.joints == 1)
        if turns and self.arm is None:
            raise spec_error(
                f"a {geometry.name} turns, and the actuator's force has no arm",
                "give its distance from the axis, e.g. arm: 12 mm",
                at=("actuator",),
            )
        if not turns and self.arm is not None:
            raise spec_error(
                "the stroke that is driven is a translation, which has no arm",
                "leave arm out",
                at=("actuator", "arm"),
            )

    def growth(self, temperature: Temperature | None, material: Material) -> float:
        """Return the thermal growth of the actuator less that of the base beside it [m].

        Raises
        ------
        NotAvailable
            When it is not known how it grows, or how warm it is.

        """
        if temperature is None:
            return 0.0
        if self.length is None or self.thermal_expansion is None:
            raise NotAvailable("has an actuator without a stated thermal expansion")
        if temperature.rises or temperature.gradient.z:
            raise NotAvailable("has an actuator whose temperature a gradient does not state")
        base = temperature.uniform + temperature.bodies.get(GROUND, 0.0)
        given = temperature.expansion.get(GROUND)
        frame = material.growth(base, temperature.assembly) if given is None else given * base
        return self.length * (self.thermal_expansion * temperature.uniform - frame)
