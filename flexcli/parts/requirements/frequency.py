"""Natural frequency of the mechanism's own motion."""

from collections.abc import Iterator
from typing import Annotated, ClassVar

from flexcli.parts.base import QuantityOf
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import Bound, Limit
from flexcli.parts.scene import Scene
from flexcli.results import QuantityKind

__all__ = ["Frequency"]

_Hertz = Annotated[float, QuantityOf("frequency", above=0.0)]


class Frequency(Bound):
    """Bounds on √(k/m)/2π of the free mechanism."""

    label: ClassVar[str] = "frequency"
    by_solids: ClassVar[bool] = True
    falls_with_mass: ClassVar[bool] = True
    is_warmed: ClassVar[bool] = True

    min: _Hertz | None = None
    max: _Hertz | None = None
    equals: _Hertz | None = None

    def weighs(self, scene: Scene) -> bool:
        """Return True."""
        return True

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on the frequency, squared."""
        try:
            squared = ask.joint_model.frequency_squared(ask)
        except MechanismError as error:
            raise RequirementError(str(error), error.hint) from error
        yield from self.bounds(
            squared,
            case=self.case_of(ask.scene),
            quantity="natural frequency",
            unit="Hz",
            source="√(k/m)/2π",
            power=2,
            kind=QuantityKind.FREQUENCY,
        )
