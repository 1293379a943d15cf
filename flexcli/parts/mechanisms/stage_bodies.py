"""The bodies of a parallel stage as a spec writes them."""

from typing import Annotated

from flexcli.mechanics.layout import Body
from flexcli.parts.base import Length, Mass, Part
from flexcli.parts.mechanisms.free_value import Free, OrFree
from flexcli.parts.mechanisms.inertia_tensor import InertiaTensor

__all__ = ["BalancingMass", "Lever", "Platform"]


class Lever(Part):
    """Solid 1 or 3: it turns about its pivot on the base."""

    mass: Mass
    """Mass of the lever, e.g. ``17.1 g``."""
    com: Length
    """Height of its centre of mass over the base pivot, positive towards solid 2,
    e.g. ``10.4 mm``.
    """
    offset: Length = 0.0
    """Distance of the centre of mass from the line through the lever's pivots, positive along x,
    e.g. ``0.1 mm``.
    """
    inertia: InertiaTensor
    """Moment of inertia about its own centre of mass, around the axis of the plane,
    e.g. ``5.4e-6 kg*m^2``.
    """

    @property
    def body(self) -> Body:
        """Return the body at rest, from its base pivot along y."""
        return Body("solid", (0.0, 0.0), self.mass, self.inertia.zz, (self.offset, self.com))


class Platform(Part):
    """Solid 2: it moves along x without turning."""

    mass: Mass
    """Mass of the body, e.g. ``68 g``."""
    com: Length = 0.0
    """Height of its centre of mass over the upper pivots, for reaction torques, e.g. ``5 mm``."""


class BalancingMass(Part):
    """A mass on a lever beyond its base pivot, away from solid 2; mass or arm may be free."""

    mass: Annotated[float | Free, OrFree("mass", at_least=0.0)]
    """Mass, given or free, e.g. ``free``."""
    arm: Annotated[float | Free, OrFree("length")]
    """Distance from the base pivot, positive away from solid 2, given or free, e.g. ``15 mm``."""
    offset: Length = 0.0
    """Distance of the centre of mass from the line through the lever's pivots, positive along x,
    e.g. ``0.1 mm``.
    """
    inertia: InertiaTensor
    """Moment of inertia about its own centre of mass, around the axis of the plane,
    e.g. ``5.4e-6 kg*m^2``.
    """

    @property
    def body(self) -> Body:
        """Return the body at rest, from the base pivot along y; what is free counts as zero."""
        mass = 0.0 if isinstance(self.mass, Free) else self.mass
        arm = 0.0 if isinstance(self.arm, Free) else self.arm
        return Body("balance", (0.0, 0.0), mass, self.inertia.zz, (self.offset, -arm))
