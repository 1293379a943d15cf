"""Parasitic motion and frequency of a mechanism in space: what it does beside its stroke."""

from collections.abc import Iterator
from dataclasses import replace
from math import isfinite
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import field_validator, model_validator

from flexcli.parts.base import QuantityOf, in_either, spec_error
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import Bound, Limit
from flexcli.parts.requirements.support import (
    CENTRE,
    DIRECTIONS,
    Direction,
    LengthOrAngle,
    Place,
    turns,
)
from flexcli.parts.scene import LoadKind, Scene
from flexcli.parts.space_joint import joint_in_space
from flexcli.parts.space_states import motions, parasitic_frequency
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["ParasiticFrequency", "ParasiticMotion"]

_Hertz = Annotated[float, QuantityOf("frequency", above=0.0)]

IN_SPACE = "is judged in its plane alone"


class ParasiticMotion(Bound):
    """An upper bound on what a point moves or turns in a direction at the ends of the stroke."""

    label: ClassVar[str] = "parasitic motion"
    per_case: ClassVar[bool] = True
    closed_form: ClassVar[bool] = False

    min: None = None
    max: Any
    """The most that the point may move or turn, e.g. ``max: 5 um, direction: z``."""
    equals: None = None
    direction: Direction
    """Direction of the motion, e.g. ``direction: z, max: 5 um``."""
    point: Place = CENTRE
    """Point on the moving body that is asked about, from its point, e.g. ``[0 mm, 5 mm, 0 mm]``."""

    @field_validator("max", mode="before", json_schema_input_type=LengthOrAngle)
    @classmethod
    def _length_or_angle(cls, data: Any) -> Any:
        """Return value and SI unit, of whichever it is."""
        return in_either(data, "length", "angle")

    @model_validator(mode="after")
    def _in_its_unit(self) -> "ParasiticMotion":
        if self.max[1] != self.unit:
            raise spec_error(
                f"a motion in {self.direction} is in {self.unit}, not {self.max[1]}",
                f"write {'1 mrad' if self.unit == 'rad' else '1 um'}",
                at=("max",),
            )
        return self

    @property
    def unit(self) -> str:
        """Return the SI unit of the motion."""
        return "rad" if turns(self.direction) else "m"

    def applies(self, scene: Scene) -> bool:
        """Return whether the case has a stroke."""
        return scene.moves

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the stroke."""
        return frozenset({LoadKind.STROKE})

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the motion at either end, with either sign, against its bound."""
        if not ask.geometry.in_space:
            hint = "ask for parasitic_shift, or draw it as a space-layout"
            raise RequirementError(f"a {ask.geometry.name} {IN_SPACE}", hint)
        joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
        row = np.eye(6)[[DIRECTIONS.index(self.direction)]]
        plain = self.model_copy(update={"max": self.max[0]})
        for motion in motions(joint, ask.scene, ask.geometry.axes):
            (moved,), (off,) = motion.at(self.point, row)
            for sign in (1.0, -1.0):
                # its error is a length or an angle of its own, however little it moves
                at = max(sign * float(moved), 0.0)
                error = None
                if isfinite(off):
                    most = at + float(off)
                    error = ErrorRange(at / most - 1.0 if at else -1.0, 0.0)
                    at = most
                for limit in plain.bounds(
                    at,
                    case=ask.scene.case,
                    quantity=f"motion in {self.direction} at the end of the stroke and its error",
                    unit=self.unit,
                    source="second order of blades between rigid clamps in space, drive locked",
                    kind=QuantityKind.SUPPORT,
                    error=error,
                ):
                    yield replace(limit, requirement=f"{self.label} {self.direction}")


class ParasiticFrequency(Bound):
    """Bounds on the lowest frequency with the drive locked at rest: of all but its own motion."""

    label: ClassVar[str] = "parasitic frequency"
    closed_form: ClassVar[bool] = False

    min: _Hertz | None = None
    max: _Hertz | None = None
    equals: _Hertz | None = None

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on the frequency."""
        if not ask.geometry.in_space:
            hint = "draw it as a space-layout, whose bodies have all their inertia"
            raise RequirementError(f"a {ask.geometry.name} {IN_SPACE}", hint)
        try:
            found = parasitic_frequency(ask.geometry, ask.material, ask.sizes)
        except NotAvailable as error:
            raise RequirementError(f"a {ask.geometry.name} {error}") from error
        yield from self.bounds(
            found.value,
            case="",
            quantity="lowest frequency, drive locked at rest",
            unit="Hz",
            source="modes of bodies and blades in space",
            kind=QuantityKind.SUPPORT,
            error=found.error,
        )
