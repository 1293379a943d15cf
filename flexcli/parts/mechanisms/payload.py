"""A payload on one joint or stage: a mass to hold and an inertia to turn."""

from math import pi, sqrt
from typing import ClassVar, Literal

from pydantic import model_validator

from flexcli.formulas.quantity import Quantity
from flexcli.mechanics.layout import Body, Layout
from flexcli.mechanics.single_freedom import SingleFreedom
from flexcli.parts.base import Inertia, Mass, spec_error
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import Geometry, Sizes
from flexcli.parts.mechanisms.base import Mechanism, MechanismError, Mode
from flexcli.parts.mechanisms.carried import body_on, carried
from flexcli.parts.stroke import Stroke
from flexcli.parts.structure import Structure
from flexcli.results import QuantityKind, Value

__all__ = ["Payload"]


class Payload(Mechanism):
    """A rigid body on one joint, its centre of mass in the centre of the joint."""

    joints: ClassVar[int] = 1
    joint_motion: ClassVar[str | None] = None

    kind: Literal["payload"]
    mass: Mass
    """Mass of the body that the joint carries, e.g. ``20 g``."""
    inertia: Inertia | None = None
    """Moment of inertia about the axis of rotation, e.g. ``5e-6 kg*m^2``."""

    @model_validator(mode="after")
    def _has_mass(self) -> "Payload":
        if self.mass == 0.0:
            raise spec_error("a payload without mass", "give its mass, e.g. 0.8 kg", at=("mass",))
        return self

    @property
    def turning_inertia(self) -> float | None:
        """Return its inertia [kg·m²]."""
        return self.inertia

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
        if not self.inertia:
            raise MechanismError(
                "inertia", "the frequency of a rotation needs the payload's inertia", "add inertia:"
            )
        return Mode(joint_stiffness, self.inertia)

    def locked_forces(self, body: str, acceleration: float) -> dict[str, float]:
        """Refuse: a locked payload loads no blade."""
        raise MechanismError(
            "lock", f"locking '{body}' would unload the joint", "leave the lock out"
        )

    def free_force(self, acceleration: float) -> float:
        """Return mass times acceleration, through the centre of the joint."""
        return self.mass * acceleration

    def carried_body(self, geometry: Geometry, layout: Layout) -> Body:
        """Return the body with what it is fixed to, in the joint's axes."""
        return body_on(
            geometry, layout, "payload", mass=self.mass, inertia=self.inertia or 0.0, offset=0.0
        )

    def structure(
        self,
        geometry: Geometry,
        elastic: Elastic,
        sizes: Sizes,
        lock: str | None,
        density: float = 0.0,
        *,
        thick: bool = False,
    ) -> Structure:
        """Return the payload on its joint: a stage moves along x, a pivot's bisector is x."""
        if lock is not None:
            raise MechanismError("lock", "a locked payload loads no blade", "leave the lock out")
        return carried(
            geometry, elastic, sizes,
            mass=self.mass, inertia=self.inertia or 0.0, density=density, thick=thick,
        )  # fmt: skip

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

    def hanging_mass(self) -> float:
        """Return the payload's mass."""
        return self.mass

    def values(self, joint_stiffness: float, geometry: Geometry) -> dict[str, Value]:
        """Return the natural frequency where the payload's inertia is known."""
        if geometry.motion == "rotation" and not self.inertia:
            return {}
        mode = self.mode(joint_stiffness, geometry)
        frequency = sqrt(mode.stiffness / mode.mass) / (2 * pi)
        return {
            "f_0": Value(
                frequency,
                "Hz",
                "natural frequency",
                source="√(k/m)/2π",
                kind=QuantityKind.FREQUENCY,
            )
        }
