"""A required factor of safety against one of the material's strengths."""

from typing import ClassVar

from flexcli.parts.base import Ratio, Shorthand
from flexcli.parts.material import Material
from flexcli.parts.requirements.yielding import Allowable

__all__ = ["Strength"]


class Strength(Shorthand):
    """The factor and what it is against; a plain number stands for {factor: number}."""

    stands_for: ClassVar[str] = "factor"

    factor: Ratio
    """How many times the stress the strength must be, e.g. ``1.5``."""
    allowable: Allowable = "yield-strength"
    """Strength that the stress is held against, e.g. ``tensile-strength``."""

    def of(self, material: Material) -> float:
        """Return the strength [Pa], or raise :class:`MissingProperty`."""
        return material.strength(self.allowable.replace("-", "_"))
