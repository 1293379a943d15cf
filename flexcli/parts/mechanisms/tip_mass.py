"""A tip mass: a rigid body on the end of a cantilever, its centre beyond the blade's end."""

from math import sqrt
from typing import Annotated, ClassVar, Literal

from flexcli.formulas.quantity import Quantity
from flexcli.mechanics.single_freedom import SingleFreedom
from flexcli.parts.base import Inertia, Length, QuantityOf
from flexcli.parts.geometries.base import Geometry
from flexcli.parts.mechanisms.base import MechanismError, Mode
from flexcli.parts.mechanisms.carried import CarriedBody
from flexcli.parts.stroke import Stroke

__all__ = ["TipMass"]

BodyMass = Annotated[float, QuantityOf("mass", above=0.0)]


class TipMass(CarriedBody):
    """A body on the end of a cantilever that bends along x; y is along the blade."""

    body_name: ClassVar[str] = "tip mass"
    joint_name: ClassVar[str] = "blade"
    frequency_source: ClassVar[str] = "massless cantilever, body beyond its end, T ± √(T² − 4D)"
    joint_kind: ClassVar[str | None] = "cantilever"

    kind: Literal["tip-mass"]
    mass: BodyMass
    """Mass on the end of the blade, e.g. ``3 g``."""
    offset: Length = 0.0
    """Distance of its centre beyond the end of the blade, e.g. ``2 mm``."""
    inertia: Inertia = 0.0
    """Moment of inertia about its centre, around the axis of bending, e.g. ``1e-8 kg*m^2``."""

    @property
    def is_point(self) -> bool:
        """Return whether it is a mass point on the blade's end."""
        return self.offset == 0.0 and self.inertia == 0.0

    @property
    def turning_inertia(self) -> float | None:
        """Return its inertia about the axis of bending [kg·m²]."""
        return self.inertia

    @property
    def arm(self) -> float:
        """Return the offset [m]."""
        return self.offset

    def equivalent_mass(self, l: float) -> float:
        """Return k/ω² of the first mode on a blade of length l [kg]."""
        m, a, r = self.mass, self.offset / l, self.inertia / l**2
        trace = m * (1.0 + 3.0 * a * (1.0 + a)) + 3.0 * r
        return (trace + sqrt(trace**2 - 3.0 * m * r)) / 2.0

    def joint_travel(self, stroke: Stroke, geometry: Geometry) -> tuple[float, float]:
        """Return the stroke of the blade's end, a translation."""
        if stroke.motion != "translation":
            raise MechanismError(
                "stroke", "the end of a cantilever is moved, not turned", "give translation:"
            )
        return stroke.amplitude, stroke.mean

    def mode(self, joint_stiffness: Quantity, geometry: Geometry) -> Mode:
        """Return the tip's stiffness with the equivalent mass of the first mode."""
        if self.is_point:
            return Mode(joint_stiffness, self.mass)
        length = geometry.extents["l"].fixed
        if length is None:
            raise MechanismError(
                "mechanism",
                "the frequency with an offset or inertia needs the blade's length",
                "give geometry.l, or leave offset and inertia out",
            )
        return Mode(joint_stiffness, self.equivalent_mass(length))

    def freedom(
        self,
        joint_stiffness: float,
        geometry: Geometry,
        *,
        balanced: bool = True,
        shift: float = 0.0,
    ) -> SingleFreedom:
        """Refuse: there is nothing to balance on a single blade."""
        raise MechanismError(
            "mechanism", "a tip mass on one blade cannot be balanced", "take flexure stops"
        )
