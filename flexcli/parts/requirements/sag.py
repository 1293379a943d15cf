"""Sag: how far the weight of the moving body bends the joint."""

from collections.abc import Iterator
from typing import Annotated, ClassVar

from flexcli.formulas.quantity import Computed
from flexcli.parts.base import QuantityOf
from flexcli.parts.elastic import Buckled, NotAvailable
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import Bound, Limit
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["Sag"]

_Length = Annotated[float, QuantityOf("length", above=0.0)]


class Sag(Bound):
    """Bounds on m a / K along the axis of the case's acceleration."""

    label: ClassVar[str] = "sag"
    by_solids: ClassVar[bool] = True
    per_case: ClassVar[bool] = True

    min: _Length | None = None
    max: _Length | None = None
    equals: _Length | None = None

    def applies(self, scene: Scene) -> bool:
        """Return whether the case has a steady acceleration."""
        return scene.acceleration > 0.0

    def weighs(self, scene: Scene) -> bool:
        """Return True."""
        return True

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the steady acceleration."""
        return frozenset({LoadKind.ACCELERATION})

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on the sag."""
        scene = ask.scene
        if not scene.sags:
            raise RequirementError(
                f"a sag is along one axis, and the acceleration of case '{scene.case}' is not",
                "give that of the sag a case of its own, with level: and axis:",
            )
        try:
            found = self._found(ask)
        except MechanismError as failed:
            raise RequirementError(str(failed), failed.hint) from failed
        for sag, error in found:
            yield from self.bounds(
                sag,
                case=scene.case,
                quantity=f"sag along {scene.axis}",
                unit="m",
                source=ask.geometry.source,
                kind=QuantityKind.SAG,
                error=error,
            )

    def _found(self, ask: Ask) -> tuple[tuple[Computed, ErrorRange | None], ...]:
        """Return the sags, each with its error where that is not the model's."""
        try:
            return ask.joint_model.sags(ask)
        except Buckled:
            raise
        except NotAvailable:
            return ((ask.joint_model.sag(ask), None),)
