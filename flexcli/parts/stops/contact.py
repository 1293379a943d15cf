"""What a stop is where the blade touches it: rigid, a spring, a ball or a cylinder."""

from typing import Annotated, ClassVar, Literal, NamedTuple, TypeAlias

from pydantic import AfterValidator, Field

from flexcli.formulas.contact import contact_modulus, line_contact, point_contact
from flexcli.parts.base import Part, PositiveLength, QuantityOf, Stiffness, spec_error
from flexcli.parts.elastic import Elastic
from flexcli.parts.material import Material

__all__ = ["AnyContact", "Ball", "Contact", "ContactStress", "Cylinder", "Rigid", "Spring"]


def _at_most_one(value: float) -> float:
    if value > 1.0:
        raise spec_error(f"a restitution of {value:g} would make energy", "write 0 to 1")
    return value


Restitution = Annotated[float, QuantityOf("ratio", at_least=0.0), AfterValidator(_at_most_one)]
Bounce = Annotated[float, QuantityOf("ratio", at_least=0.14), AfterValidator(_at_most_one)]
"""A restitution that a dashpot can have: e⁻² = 0.135 is that of a critical one."""


class ContactStress(NamedTuple):
    """Peak pressure and greatest shear below the surface [Pa]."""

    pressure: float
    shear: float


class Contact(Part):
    """A stop's head; without a radius it has no stress."""

    has_stress: ClassVar[bool] = False

    def stress(self, force: float, blade: Elastic) -> ContactStress | None:
        """Return the stress under a force [N], where the head has a shape."""
        return None


class Rigid(Contact):
    """A stop that does not give; a restitution makes each contact an impact without duration."""

    kind: Literal["rigid"]
    restitution: Restitution | None = None
    """Share of the speed that is left after an impact, from 0 to 1, e.g. ``0.5``."""


class Spring(Contact):
    """A stop on a spring, whose dashpot gives the restitution of the first mode."""

    kind: Literal["spring"]
    stiffness: Stiffness
    """Stiffness of the stop, e.g. ``100 N/mm``."""
    restitution: Bounce = 1.0
    """Share of the speed that its dashpot leaves, e.g. ``0.5``."""


class _Round(Contact):
    has_stress: ClassVar[bool] = True

    radius: PositiveLength
    """Radius of the stop's head, e.g. ``5 mm``."""
    material: Material
    """Material of the stop: inline, the name of a shipped one, or a path, e.g. ``17-4ph-h900``."""

    def modulus(self, blade: Elastic) -> float:
        """Return the contact modulus E* of blade and stop [Pa]."""
        stop = self.material.elastic
        assert blade.nu is not None  # the design refuses a contact without Poisson's ratios
        assert stop.nu is not None
        return float(contact_modulus(E_1=blade.E, nu_1=blade.nu, E_2=stop.E, nu_2=stop.nu))


class Ball(_Round):
    """A ball against the flat of the blade."""

    kind: Literal["ball"]

    def stress(self, force: float, blade: Elastic) -> ContactStress:
        """Return Hertz' point contact."""
        found = point_contact(F=force, R=self.radius, E_star=self.modulus(blade))
        return ContactStress(float(found.pressure), float(found.shear))


class Cylinder(_Round):
    """A cylinder along the width of the blade, aligned with it."""

    kind: Literal["cylinder"]
    width: PositiveLength
    """Length of the line of contact, e.g. ``5 mm``."""

    def stress(self, force: float, blade: Elastic) -> ContactStress:
        """Return Hertz' line contact."""
        found = line_contact(F=force, b=self.width, R=self.radius, E_star=self.modulus(blade))
        return ContactStress(float(found.pressure), float(found.shear))


AnyContact: TypeAlias = Annotated[Rigid | Spring | Ball | Cylinder, Field(discriminator="kind")]
