"""What a mechanism offers: how the joint's motion and load follow from those of the bodies."""

from abc import abstractmethod
from typing import ClassVar

from flexcli.formulas.quantity import Quantity
from flexcli.parts.base import Part
from flexcli.parts.geometries.base import Geometry
from flexcli.parts.stroke import Stroke
from flexcli.results import Value

__all__ = ["Mechanism", "MechanismError", "Mode"]


class MechanismError(ValueError):
    """A case asks of a mechanism what it can't do; ``at`` is the key of the case at fault."""

    def __init__(self, at: str, text: str, hint: str) -> None:
        super().__init__(text)
        self.at = at
        self.hint = hint


class Mode:
    """Stiffness and mass of the one degree of freedom: f = √(k/m)/2π."""

    def __init__(self, stiffness: Quantity, mass: float) -> None:
        self.stiffness = stiffness
        self.mass = mass


class Mechanism(Part):
    """Bodies that joints of one geometry carry."""

    joints: ClassVar[int]
    joint_motion: ClassVar[str | None]

    @abstractmethod
    def joint_travel(self, stroke: Stroke, geometry: Geometry) -> tuple[float, float]:
        """Return amplitude and mean of the travel of each joint [rad or m]."""

    @abstractmethod
    def mode(self, joint_stiffness: Quantity, geometry: Geometry) -> Mode:
        """Return stiffness and mass of the mechanism's own motion, every part mounted."""

    @abstractmethod
    def locked_forces(self, body: str, acceleration: float) -> dict[str, float]:
        """Return the force at each joint [N] when a body is locked and the base accelerates."""

    @abstractmethod
    def free_force(self, acceleration: float) -> float:
        """Return the force on the joint [N] when the free mechanism is accelerated in its plane."""

    @abstractmethod
    def hanging_mass(self) -> float:
        """Return the mass that the joints carry against gravity [kg]."""

    def body_forces(self, acceleration: float) -> dict[str, tuple[float, str]]:
        """Return forces at the bodies worth reporting [N], with what they are."""
        return {}

    def values(self, joint_stiffness: float, geometry: Geometry) -> dict[str, Value]:
        """Return the mechanism's own numbers worth reporting."""
        return {}
