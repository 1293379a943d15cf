"""Envelope: the box that blades and bodies fill, at rest, over the stroke and under loads."""

from collections.abc import Iterator
from typing import ClassVar

from flexcli.parts.base import PositiveLength, Shorthand
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import Limit, Requirement
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import ErrorRange

__all__ = ["Envelope"]


BORNE = frozenset({
    LoadKind.LOAD, LoadKind.WRENCH, LoadKind.ACCELERATION, LoadKind.TEMPERATURE
})  # fmt: skip
"""Loads whose motion is in the box."""


class Envelope(Requirement, Shorthand):
    """The sides of a box along x, y and z in which the mechanism stays, wherever the box is."""

    closed_form: ClassVar[bool] = False
    label: ClassVar[str] = "envelope"
    stands_for: ClassVar[str] = "sides"

    sides: tuple[PositiveLength, PositiveLength, PositiveLength]
    """Longest that it may be along x, y and z, e.g. ``[80 mm, 40 mm, 30 mm]``."""
    cases: tuple[str, ...] | None = None
    """Cases of whose strokes and loads it is asked; all, if left out,
    e.g. ``cases: [operation], sides: [80 mm, 40 mm, 30 mm]``.
    """

    def applies(self, scene: Scene) -> bool:
        """Return whether it is asked of this case."""
        return self.cases is None or scene.case in self.cases

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield each side of the box against the longest that it may be."""
        try:
            box, bare = ask.joint_model.envelope(ask)
        except NotAvailable as error:
            raise RequirementError(f"a {ask.geometry.name} {error}") from error
        scene = ask.scene
        what = "at rest and over the stroke" if scene.moves else "at rest"
        if acting := scene.loads & BORNE:
            what += f" and under its {' and '.join(sorted(acting))}"
        if shaken := scene.loads - BORNE - {LoadKind.STROKE, LoadKind.AXES}:
            what += f", without the motion by its {' and '.join(sorted(shaken))}"
        without = f"; without the outline of {', '.join(bare)}, which has none" if bare else ""
        sides = (each.tolist() for each in box[:3])
        for axis, side, least, most, allowed in zip("xyz", *sides, self.sides, strict=True):
            known = box.is_known and side > 0.0
            yield Limit(
                f"envelope {axis}", scene.case, f"length along {axis} {what}{without}",
                side, allowed, "m", "edges of blades and corners of bodies", variant="max",
                error=ErrorRange(least / side - 1.0, most / side - 1.0) if known else None,
            )  # fmt: skip
