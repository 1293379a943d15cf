"""Elastic constants of a material, and what a geometry cannot give."""

from typing import NamedTuple

__all__ = ["ANY", "Buckled", "Elastic", "NotAvailable", "buckled"]


class NotAvailable(ValueError):
    """A number for which a geometry has no closed form."""


class Buckled(NotAvailable):
    """The loads of a case buckle the joint: ``share`` of them is where it loses its stability.

    It is proved on the path of the loads; a solver that does not converge does not prove it.
    It may be ``less`` or ``more`` by a share of itself.
    """

    def __init__(self, share: float, less: float = 0.0, more: float = 0.0) -> None:
        super().__init__(f"buckles at {share:.3g} of the forces of the case")
        self.share, self.less, self.more = share, less, more

    @property
    def between(self) -> tuple[float, float]:
        """Return the range of the share."""
        return self.share * max(1.0 - self.less, 0.0), self.share * (1.0 + self.more)


def buckled(share: float, *, less: float, more: float) -> NotAvailable:
    """Return that loads buckle a joint, or where that is unsure that nobody knows."""
    if share * (1.0 + more) < 1.0:
        return Buckled(share, less, more)
    return NotAvailable(f"may buckle, as beams do at {share:.3g} of the forces of the case")


class Elastic(NamedTuple):
    """Young's modulus [Pa] and Poisson's ratio, where the material gives it."""

    E: float
    nu: float | None = None

    @property
    def most_nu(self) -> float:
        """Return Poisson's ratio, or its upper limit ½ where the material gives none."""
        return 0.5 if self.nu is None else self.nu

    @property
    def likely(self) -> tuple["Elastic", ...]:
        """Return itself, or with 0 and ½ where the material gives no Poisson's ratio."""
        return (self,) if self.nu is not None else (Elastic(self.E, 0.0), Elastic(self.E, 0.5))

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


ANY = Elastic(1.0, 0.0)
"""Placeholder constants, to draw a joint whatever its material, or to find whether it has a
layout."""
