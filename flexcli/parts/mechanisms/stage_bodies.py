"""The bodies of a parallel stage as a spec writes them."""

from typing import Annotated, ClassVar

from pydantic import Field

from flexcli.mechanics.layout import Body
from flexcli.parts.base import Inertia, Length, Mass, Part, Shorthand
from flexcli.parts.mechanisms.free_value import Free, OrFree

__all__ = ["BalancingMass", "InertiaTensor", "Lever", "Platform"]

ACROSS = "centre of mass off the line through the lever's pivots, positive along x"


class InertiaTensor(Shorthand):
    """Moments of inertia about the body's own centre of mass; a plain value stands for zz."""

    stands_for: ClassVar[str] = "zz"

    xx: Inertia | None = None
    yy: Inertia | None = None
    zz: Inertia


class Lever(Part):
    """Solid 1 or 3: it turns about its pivot on the base."""

    mass: Mass
    com: Length = Field(description="centre of mass from the base pivot, positive to solid 2")
    offset: Length = Field(0.0, description=ACROSS)
    inertia: InertiaTensor

    @property
    def body(self) -> Body:
        """Return the body at rest, from its base pivot along y."""
        return Body("solid", (0.0, 0.0), self.mass, self.inertia.zz, (self.offset, self.com))


class Platform(Part):
    """Solid 2: it moves along x without turning."""

    mass: Mass
    com: Length = Field(
        0.0, description="height of the centre of mass over the upper pivots, for reaction torques"
    )


class BalancingMass(Part):
    """A mass on a lever beyond its base pivot, away from solid 2; mass or arm may be free."""

    mass: Annotated[float | Free, OrFree("mass", at_least=0.0)]
    arm: Annotated[float | Free, OrFree("length")] = Field(
        description="from the base pivot, positive away from solid 2"
    )
    offset: Length = Field(0.0, description=ACROSS)
    inertia: InertiaTensor

    @property
    def body(self) -> Body:
        """Return the body at rest, from the base pivot along y; what is free counts as zero."""
        mass = 0.0 if isinstance(self.mass, Free) else self.mass
        arm = 0.0 if isinstance(self.arm, Free) else self.arm
        return Body("balance", (0.0, 0.0), mass, self.inertia.zz, (self.offset, -arm))
