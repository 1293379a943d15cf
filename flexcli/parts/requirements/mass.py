"""Mass of the blades."""

from collections.abc import Iterator
from typing import Annotated, ClassVar

from flexcli.parts.base import QuantityOf
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import Bound, Limit
from flexcli.results import EXACT

__all__ = ["Mass"]

_Mass = Annotated[float, QuantityOf("mass", above=0.0)]


class Mass(Bound):
    """Bounds on the mass of the blades of one joint."""

    label: ClassVar[str] = "mass"
    of_the_drawing: ClassVar[bool] = True

    min: _Mass | None = None
    max: _Mass | None = None
    equals: _Mass | None = None

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on ρ n h l b."""
        if ask.material.density is None:
            raise RequirementError("the material has no density", "give material.density")
        yield from self.bounds(
            ask.material.density.value * ask.geometry.volume(ask.sizes),
            case="",
            quantity="mass of the blades of a joint",
            unit="kg",
            source="ρ n h l b",
            error=EXACT,
        )
