"""A body on one joint, together with the bodies that the joint itself is drawn of."""

from math import pi, sqrt
from typing import ClassVar

from flexcli.mechanics.layout import Body, Layout
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import GROUND, MOVING, Geometry, Sizes
from flexcli.parts.mechanisms.base import Mechanism, MechanismError
from flexcli.parts.structure import OwnMotion, PlacedJoint, Structure, assemble, joined, turned
from flexcli.results import QuantityKind, Value

__all__ = [
    "CarriedBody",
    "carried",
    "is_guided",
]


class CarriedBody(Mechanism):
    """A rigid body on one joint: what is the same wherever its centre of mass is."""

    joints: ClassVar[int] = 1
    joint_motion: ClassVar[str | None] = None
    body_name: ClassVar[str]
    joint_name: ClassVar[str]
    """Names of the body and of what carries it, in outputs and findings."""
    frequency_source: ClassVar[str]
    """Where its natural frequency comes from."""

    mass: float

    def locked_forces(self, body: str, acceleration: float) -> dict[str, float]:
        """Refuse: a locked body loads no blade."""
        text = f"locking '{body}' would unload the {self.joint_name}"
        raise MechanismError("lock", text, "leave the lock out")

    def free_force(self, acceleration: float) -> float:
        """Return mass times acceleration."""
        return self.mass * acceleration

    def hanging_mass(self) -> float:
        """Return its mass."""
        return self.mass

    def carried_body(self, geometry: Geometry, layout: Layout) -> Body:
        """Return the body with what it is fixed to, in the joint's axes."""
        return _body_on(
            geometry, layout, self.body_name,
            mass=self.mass, inertia=self.turning_inertia or 0.0, offset=self.arm,
        )  # fmt: skip

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
        """Return the body on its joint: a stage moves along x, a pivot's bisector is x."""
        if lock is not None:
            text = f"a locked {self.body_name} loads no blade"
            raise MechanismError("lock", text, "leave the lock out")
        return carried(
            geometry, elastic, sizes,
            name=self.body_name, joint=self.joint_name,
            mass=self.mass, inertia=self.turning_inertia or 0.0, offset=self.arm,
            density=density, thick=thick,
        )  # fmt: skip

    def values(self, joint_stiffness: float, geometry: Geometry) -> dict[str, Value]:
        """Return the natural frequency, where the spec says enough for it."""
        try:
            mode = self.mode(joint_stiffness, geometry)
        except MechanismError:
            return {}
        return {
            "f_0": Value(
                sqrt(float(mode.stiffness) / mode.mass) / (2 * pi),
                "Hz",
                "natural frequency",
                source=self.frequency_source,
                kind=QuantityKind.FREQUENCY,
            )
        }


def carried(
    geometry: Geometry,
    elastic: Elastic,
    sizes: Sizes,
    *,
    name: str = "payload",
    joint: str = "joint",
    mass: float = 0.0,
    inertia: float = 0.0,
    offset: float = 0.0,
    density: float = 0.0,
    thick: bool = False,
) -> Structure:
    """Return a rigid body fixed to the moving body of a joint, as a structure.

    Parameters
    ----------
    geometry : Geometry
        The joint; bodies that a layout draws with mass move as well.
    elastic : Elastic
        Of its blades.
    sizes : Sizes
        The joint's sizes.
    name, joint : str
        Of the body and of the joint, in the names of the outputs.
    mass, inertia : float
        Of the body [kg], about its centre of mass [kg·m²].
    offset : float
        Of its centre of mass beyond the joint's centre, along the blades [m].
    density : float
        Of the blades [kg/m³]; 0 leaves their mass out.
    thick : bool
        Whether blades shear and their sections have rotary inertia.

    Raises
    ------
    NotAvailable
        When the joint is not made of blades in a plane.

    """
    layout = geometry.blades_layout(elastic, sizes)
    both = _body_on(geometry, layout, name, mass=mass, inertia=inertia, offset=offset)
    turn = -geometry.axes
    body = both._replace(point=turned(both.point, turn), com=turned(both.com, turn))
    stroke = turned((0.0, 1.0), turn)
    rotates = geometry.motion == "rotation"
    return assemble(
        [body],
        [PlacedJoint(joint, GROUND, name, (0.0, 0.0), turn)],
        layout,
        OwnMotion(name, (0.0, 0.0, 1.0), "rotation")
        if rotates
        else OwnMotion(name, (*stroke, 0.0), "travel"),
        density=density,
        thick=thick,
        held=[(name, 2)] if is_guided(geometry) else [],
    )


def _body_on(
    geometry: Geometry, layout: Layout, name: str, *, mass: float, inertia: float, offset: float
) -> Body:
    """Return a body with the moving body of a joint that it is fixed to, in the joint's axes."""
    moving = layout.body(MOVING)
    centre = geometry.payload_point(moving.point)
    com = centre[0] + offset, centre[1]
    own = moving._replace(com=moving.com if moving.mass else com)
    return joined(name, centre, [own, Body(name, centre, mass, inertia, com)])


def is_guided(geometry: Geometry) -> bool:
    """Return whether its blades, or what drives it, keep the body from turning."""
    return geometry.is_guided or geometry.keeps_level
