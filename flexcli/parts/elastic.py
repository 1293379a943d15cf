"""What the stiffness of a material is made of."""

from typing import NamedTuple

__all__ = ["Elastic", "NotAvailable"]


class NotAvailable(ValueError):
    """A quantity that a geometry has no closed form for."""


class Elastic(NamedTuple):
    """Young's modulus [Pa] and Poisson's ratio, where the material gives it."""

    E: float
    nu: float | None = None

    @property
    def shear(self) -> float | None:
        """Return the shear modulus [Pa], or nothing without Poisson's ratio."""
        return None if self.nu is None else self.E / (2.0 * (1.0 + self.nu))

    @property
    def G(self) -> float:  # noqa: N802 - the field's symbol
        """Return the shear modulus [Pa]."""
        if self.shear is None:
            raise NotAvailable("needs material.poisson_ratio for its shear modulus")
        return self.shear
