"""A required factor of safety against one of the material's strengths."""

from typing import Any

from pydantic import model_validator

from flexcli.parts.base import Part, Ratio
from flexcli.parts.material import Material
from flexcli.parts.requirements.yielding import Allowable

__all__ = ["Strength"]


class Strength(Part):
    """The factor and what it is against; a plain number stands for {factor: number}."""

    factor: Ratio
    allowable: Allowable = "yield-strength"

    @model_validator(mode="before")
    @classmethod
    def _from_plain(cls, data: Any) -> Any:
        return data if isinstance(data, dict) else {"factor": data}

    def of(self, material: Material) -> float:
        """Return the strength [Pa], or raise :class:`MissingProperty`."""
        return material.strength(self.allowable.replace("-", "_"))
