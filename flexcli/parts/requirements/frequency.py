"""Natural frequency of the mechanism's own motion."""

from collections.abc import Iterator
from math import pi
from typing import Annotated, ClassVar

from flexcli.parts.base import QuantityOf
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.own_motion import own_mode
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import Bound, Limit
from flexcli.results import QuantityKind

__all__ = ["Frequency"]

_Hertz = Annotated[float, QuantityOf("frequency", above=0.0)]


class Frequency(Bound):
    """Bounds on √(k/m)/2π of the free mechanism."""

    label: ClassVar[str] = "frequency"

    min: _Hertz | None = None
    max: _Hertz | None = None
    equals: _Hertz | None = None

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on the frequency, squared."""
        try:
            stiffness, elastic = ask.joint_model.stiffness(ask), ask.material.elastic
            mode = own_mode(ask.mechanism, stiffness, ask.geometry, elastic, ask.sizes)
        except MechanismError as error:
            raise RequirementError(str(error), error.hint) from error
        factor = ask.joint_model.frequency_factor(ask)
        yield from self.bounds(
            mode.stiffness * (factor**2 / (mode.mass * (2.0 * pi) ** 2)),
            case="",
            quantity="natural frequency",
            unit="Hz",
            source="√(k/m)/2π",
            power=2,
            kind=QuantityKind.FREQUENCY,
        )
