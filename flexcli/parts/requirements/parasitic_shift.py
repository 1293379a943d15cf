"""Parasitic shift: how far the centre or the stage leaves its ideal path over the stroke."""

from collections.abc import Iterator
from typing import Annotated, ClassVar

from flexcli.parts.base import QuantityOf
from flexcli.parts.requirements.ask import Ask
from flexcli.parts.requirements.base import Bound, Limit
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import QuantityKind

__all__ = ["ParasiticShift"]

_Length = Annotated[float, QuantityOf("length", above=0.0)]


class ParasiticShift(Bound):
    """An upper bound on the magnitude of the shift at the largest travel."""

    label: ClassVar[str] = "parasitic shift"
    per_case: ClassVar[bool] = True
    by_shells: ClassVar[QuantityKind | None] = QuantityKind.SHIFT
    by_solids: ClassVar[bool] = True

    min: None = None
    max: _Length
    equals: None = None

    def applies(self, scene: Scene) -> bool:
        """Return whether the case has a stroke, or a temperature that moves the joint by itself."""
        return scene.travel > 0.0 or scene.temperature is not None

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the stroke, and the temperature that moves the joint besides."""
        return frozenset({LoadKind.STROKE, LoadKind.TEMPERATURE})

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the shift, with either sign, against its bound."""
        scene = ask.scene
        shift = ask.joint_model.parasitic_shift(ask)
        quantity = f"parasitic shift {'at full stroke' if scene.moves else 'by the temperature'}"
        for sign in (1.0, -1.0):
            yield from self.bounds(
                sign * shift,
                case=scene.case,
                quantity=quantity,
                unit="m",
                source=ask.geometry.source,
                kind=QuantityKind.SHIFT,
            )
