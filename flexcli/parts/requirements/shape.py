"""Shape of the blade: its slenderness l/h and its width to thickness b/h."""

from collections.abc import Iterator
from typing import Annotated, ClassVar

from flexcli.parts.base import QuantityOf
from flexcli.parts.requirements.base import Ask, Bound, Limit

__all__ = ["Slenderness", "WidthRatio"]

_Ratio = Annotated[float, QuantityOf("ratio", above=0.0)]


class _Shape(Bound):
    min: _Ratio | None = None
    max: _Ratio | None = None
    equals: _Ratio | None = None


class Slenderness(_Shape):
    """Bounds on l/h."""

    label: ClassVar[str] = "l/h"

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on l/h."""
        yield from self.bounds(
            ask.blade.l / ask.blade.h, case="", quantity="l/h", unit="", source="geometry"
        )


class WidthRatio(_Shape):
    """Bounds on b/h."""

    label: ClassVar[str] = "b/h"

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on b/h."""
        yield from self.bounds(
            ask.blade.b / ask.blade.h, case="", quantity="b/h", unit="", source="geometry"
        )
