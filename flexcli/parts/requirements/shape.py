"""Shape of the blade: its slenderness l/h and its width to thickness b/h."""

from collections.abc import Iterator
from typing import Annotated, ClassVar

from flexcli.parts.base import QuantityOf
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import Bound, Limit
from flexcli.results import EXACT

__all__ = ["Slenderness", "WidthRatio"]

_Ratio = Annotated[float, QuantityOf("ratio", above=0.0)]


class _Shape(Bound):
    of_the_drawing: ClassVar[bool] = True

    min: _Ratio | None = None
    max: _Ratio | None = None
    equals: _Ratio | None = None

    def ratio_bounds(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on the ratio that the requirement is named after."""
        ratios = ask.geometry.ratios(ask.sizes)
        if self.label not in ratios:
            raise RequirementError(
                f"a {ask.geometry.name} has no {self.label}", f"it has {', '.join(ratios)}"
            )
        yield from self.bounds(
            ratios[self.label],
            case="",
            quantity=self.label,
            unit="",
            source="geometry",
            error=EXACT,
        )


class Slenderness(_Shape):
    """Bounds on l/h."""

    label: ClassVar[str] = "l/h"

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on l/h."""
        yield from self.ratio_bounds(ask)


class WidthRatio(_Shape):
    """Bounds on b/h."""

    label: ClassVar[str] = "b/h"

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on b/h."""
        yield from self.ratio_bounds(ask)
