"""A payload on one joint or stage: a mass to hold and an inertia to turn."""

from typing import ClassVar, Literal

from pydantic import model_validator

from flexcli.formulas.quantity import Quantity
from flexcli.mechanics.layout import Body
from flexcli.mechanics.single_freedom import SingleFreedom
from flexcli.parts.base import Mass, spec_error
from flexcli.parts.geometries.base import Geometry
from flexcli.parts.mechanisms.base import MechanismError, Mode
from flexcli.parts.mechanisms.carried import CarriedBody
from flexcli.parts.mechanisms.inertia_tensor import InertiaTensor
from flexcli.parts.stroke import Stroke

__all__ = ["Payload"]


class Payload(CarriedBody):
    """A rigid body on one joint, its centre of mass in the centre of the joint."""

    body_name: ClassVar[str] = "payload"
    joint_name: ClassVar[str] = "joint"
    frequency_source: ClassVar[str] = "√(k/m)/2π"

    kind: Literal["payload"]
    mass: Mass
    """Mass of the body that the joint carries, e.g. ``20 g``."""
    inertia: InertiaTensor | None = None
    """Moment of inertia about the axis of rotation, or moments about all three axes of the joint
    where it is shaken out of its plane or tilts, e.g. ``5e-6 kg*m^2``.
    """

    @model_validator(mode="after")
    def _has_mass(self) -> "Payload":
        if self.mass == 0.0:
            raise spec_error("a payload without mass", "give its mass, e.g. 0.8 kg", at=("mass",))
        return self

    @property
    def turning_inertia(self) -> float | None:
        """Return its inertia about the axis of rotation [kg·m²]."""
        return None if self.inertia is None else self.inertia.zz

    @property
    def tilting_inertia(self) -> tuple[float, float] | None:
        """Return its inertia about x and y [kg·m²], where both are stated."""
        if self.inertia is None or self.inertia.xx is None or self.inertia.yy is None:
            return None
        return self.inertia.xx, self.inertia.yy

    def joint_travel(self, stroke: Stroke, geometry: Geometry) -> tuple[float, float]:
        """Return the stroke itself, which must be the joint's kind of motion."""
        if stroke.motion != geometry.motion:
            raise MechanismError(
                "stroke", f"this joint's motion is a {geometry.motion}", f"give {geometry.motion}:"
            )
        return stroke.amplitude, stroke.mean

    def mode(self, joint_stiffness: Quantity, geometry: Geometry) -> Mode:
        """Return the joint's stiffness with the inertia (rotation) or the mass (translation)."""
        if geometry.motion == "translation":
            return Mode(joint_stiffness, self.mass)
        if not self.turning_inertia:
            raise MechanismError(
                "inertia", "the frequency of a rotation needs the payload's inertia", "add inertia:"
            )
        return Mode(joint_stiffness, self.turning_inertia)

    def shaken_by(self, geometry: Geometry) -> Literal["translation", "rotation"]:
        """Return the joint's own kind of motion."""
        return "rotation" if geometry.motion == "rotation" else "translation"

    def freedom(
        self,
        joint_stiffness: float,
        geometry: Geometry,
        *,
        balanced: bool = True,
        shift: float = 0.0,
    ) -> SingleFreedom:
        """Return the payload on its joint: it moves along x, or turns about its centre of mass.

        The parasitic motion is towards the base of a stage, along the bisector of a pivot.
        """
        body = Body("payload", (0.0, 0.0), self.mass)
        if geometry.motion == "rotation":
            body = body._replace(inertia=self.mode(joint_stiffness, geometry).mass)
            moving = (body, lambda q: (q * q * shift, 0.0, q))
        else:
            moving = (body, lambda q: (q, q * q * -shift, 0.0))
        return SingleFreedom([moving], joint_stiffness, lambda q: q)
