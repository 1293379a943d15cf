"""Parasitic motion and frequency of a mechanism in space: those beside its stroke."""

from collections.abc import Iterator
from math import isfinite
from typing import Annotated, ClassVar

import numpy as np

from flexcli.parts.base import QuantityOf
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import BoundAtStroke, Limit
from flexcli.parts.requirements.support import CENTRE, DIRECTIONS, MotionBound, Place
from flexcli.parts.scene import LoadKind, Scene
from flexcli.parts.space_joint import joint_of
from flexcli.parts.space_own_motion import parasitic_frequency
from flexcli.parts.space_states import motions
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["ParasiticFrequency", "ParasiticMotion"]

_Hertz = Annotated[float, QuantityOf("frequency", above=0.0)]

IN_SPACE = "is judged in its plane alone"


class ParasiticMotion(MotionBound):
    """An upper bound on the motion or rotation of a point in a direction at the stroke's ends."""

    label: ClassVar[str] = "parasitic motion"

    point: Place = CENTRE
    """Point on the moving body that is asked about, from its point, e.g. ``[0 mm, 5 mm, 0 mm]``."""

    @property
    def spoken(self) -> str:
        """Return the bounded quantity in words, with its direction."""
        return f"motion in {self.direction}"

    def applies(self, scene: Scene) -> bool:
        """Return whether the case has a stroke, or a temperature that moves the body by itself."""
        return scene.moves or scene.temperature is not None

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the stroke and the temperature."""
        return frozenset({LoadKind.STROKE, LoadKind.TEMPERATURE})

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the motion at either end, with either sign, against its bound."""
        if not ask.geometry.in_space:
            hint = "ask for parasitic_shift, or draw it as a space-layout"
            raise RequirementError(f"a {ask.geometry.name} {IN_SPACE}", hint)
        joint = joint_of(ask)
        when = "at the end of the stroke" if ask.scene.moves else "by the temperature"
        held = "drive locked" if ask.scene.moves else "drive free"
        row = np.eye(6)[[DIRECTIONS.index(self.direction)]]
        for motion in motions(joint, ask.scene, ask.material, ask.geometry.axes):
            (moved,), (off,) = motion.at(self.point, row)
            for sign in (1.0, -1.0):
                # its error is a length or an angle of its own, however little it moves
                at = max(sign * float(moved), 0.0)
                error = None
                if isfinite(off):
                    most = at + float(off)
                    error = ErrorRange(at / most - 1.0 if at else -1.0, 0.0)
                    at = most
                yield from self.bounds_in_direction(
                    at,
                    case=ask.scene.case,
                    quantity=f"{self.spoken} {when} and its error",
                    source=f"second order of blades between rigid clamps in space, {held}",
                    error=error,
                )


class ParasiticFrequency(BoundAtStroke):
    """Bounds on the lowest frequency with the drive locked: of all but its own motion.

    That is at rest, or at both ends of each case's stroke.
    """

    label: ClassVar[str] = "parasitic frequency"
    closed_form: ClassVar[bool] = False
    is_warmed: ClassVar[bool] = True

    min: _Hertz | None = None
    max: _Hertz | None = None
    equals: _Hertz | None = None

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on the frequency."""
        if not ask.geometry.in_space:
            hint = "draw it as a space-layout, whose bodies have all their inertia"
            raise RequirementError(f"a {ask.geometry.name} {IN_SPACE}", hint)
        if self.at == "full-stroke":
            for value, error in ask.joint_model.parasitic_frequency_at_stroke(ask):
                yield from self._bounds(
                    value, error, ask.scene.case, "at full stroke", ask.joint_model.at_stroke
                )
            return
        try:
            found = parasitic_frequency(ask.geometry, ask.material, ask.sizes)
            if ask.scene.temperature is not None:
                found = found.times(*ask.joint_model.warm_frequency_ratio(ask, locked=True))
        except NotAvailable as error:
            raise RequirementError(f"a {ask.geometry.name} {error}") from error
        case, source = self.case_of(ask.scene), "modes of bodies and blades in space"
        yield from self._bounds(found.value, found.error, case, "at rest", source)

    def _bounds(
        self, value: float, error: ErrorRange | None, case: str, where: str, source: str
    ) -> Iterator[Limit]:
        """Yield the bounds on a frequency."""
        for limit in self.bounds(
            value,
            case=case,
            quantity=f"lowest frequency, drive locked {where}",
            unit="Hz",
            source=source,
            kind=QuantityKind.SUPPORT,
            error=error,
        ):
            yield (
                limit
                if self.at == "rest"
                else limit._replace(requirement=f"{limit.requirement} at stroke")
            )
