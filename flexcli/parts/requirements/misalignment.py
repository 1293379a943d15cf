"""Misalignment stress: the stress of blades whose ends are forced into seats that are off."""

from collections.abc import Iterator
from contextlib import suppress
from math import inf
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from pydantic import model_validator

from flexcli.errors import SolveError
from flexcli.parts.base import Part, QuantityOf, Ratio, spec_error
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.space_parts import Way
from flexcli.parts.material import MissingProperty
from flexcli.parts.requirements.ask import Ask, RequirementError, Told
from flexcli.parts.requirements.base import Limit, Requirement
from flexcli.parts.space_joint import joint_in_space
from flexcli.parts.space_misfits import guided_about, misfit_stresses, worst_misfit
from flexcli.results import QuantityKind

__all__ = ["MisalignmentStress"]


class Shifted(Part):
    """Offset of a seat, and its direction."""

    along: Way
    """Direction, along the axes of the layout: x, y, z or three numbers, e.g. ``z``."""
    by: Annotated[float, QuantityOf("length", above=0.0)]
    """How far, either way, e.g. ``10 um``."""


class Tilted(Part):
    """Tilt of a seat, and its axis."""

    about: Way
    """Direction of the axis, along the axes of the layout: x, y, z or three numbers,
    e.g. ``x``.
    """
    by: Annotated[float, QuantityOf("angle", above=0.0)]
    """Angle, either way, e.g. ``1 mrad``."""


class MisalignmentStress(Requirement):
    """Factor on the largest stress where the seat of a blade, at its end, is off by so much.

    The joint is at rest with its drive free, all else free but for a guide, and every blade of the
    name is tried alone.
    """

    label: ClassVar[str] = "misalignment stress"
    per_case: ClassVar[bool] = False
    closed_form: ClassVar[bool] = False
    by_solids: ClassVar[bool] = True
    by_shells: ClassVar[QuantityKind | None] = QuantityKind.SUPPORT

    of: str
    """Blade or rod whose end misses its seat; a drawn one stands for all its copies,
    e.g. ``outer-1``.
    """
    rotation: Tilted | None = None
    """Angle of the seat, e.g. ``{about: x, by: 1 mrad}``."""
    translation: Shifted | None = None
    """Shift of the seat, e.g. ``translation: {along: z, by: 10 um}, factor: 3, of: outer-1``."""
    factor: Ratio
    """How many times the stress the material must bear, e.g. ``3``."""
    allowable: Literal["yield-strength", "tensile-strength", "admissible-stress"] = "yield-strength"
    """Strength that the stress is held against, e.g. ``tensile-strength``."""

    @model_validator(mode="after")
    def _one_of_them(self) -> "MisalignmentStress":
        if (self.rotation is None) == (self.translation is None):
            raise spec_error(
                "a misalignment is a rotation or a translation",
                "give one of them, e.g. rotation: {about: x, by: 1 mrad}",
            )
        return self

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the largest stress against the strength."""
        try:
            strength = ask.material.strength(self.allowable.replace("-", "_"))
        except MissingProperty as missing:
            hint = f"give material.{missing.field}, or name another allowable"
            raise RequirementError(str(missing), hint) from missing
        try:
            joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
        except NotAvailable as error:
            hint = "complete the design, or leave this requirement out"
            raise RequirementError(f"a {ask.geometry.name} {error}", hint) from error
        names = [blade.name for blade in joint.layout.blades]
        meant = [
            index
            for index, name in enumerate(names)
            if name == self.of
            or (name.startswith(f"{self.of}-") and name[len(self.of) + 1 :].isdigit())
        ]
        if not meant:
            raise RequirementError(f"there is no blade '{self.of}'", f"one of {', '.join(names)}")
        kept = guided_about(ask.geometry)
        how = "linear blades between rigid clamps in space"
        try:
            each = tuple(misfit_stresses(joint, meant, self._motion, kept=kept))
            found, where = worst_misfit((Told(one.stress, one.error), one.where) for one in each)
            with suppress(NotAvailable):
                beyond, there = worst_misfit(ask.joint_model.misfit_stresses(ask, each))
                if found.error is None or _width(beyond) < _width(found):
                    found, where, how = beyond, there, f"{ask.joint_model.at_stroke}, the seat off"
        except SolveError as error:
            raise RequirementError(
                f"a {ask.geometry.name} has no stiffness: {error.text}", error.remedy
            ) from error
        yield Limit(
            f"{self.label} {self.of}, {self._spoken}",
            "",
            f"nominal stress, von Mises, drive free: {where}",
            found.value,
            strength,
            "Pa",
            f"allowable: {self.allowable}; {how}",
            required=self.factor,
            kind=QuantityKind.SUPPORT,
            error=found.error,
        )

    @property
    def _spoken(self) -> str:
        """Return the misalignment in words, which tell two checks apart."""
        way = self.rotation.about if self.rotation else self.translation and self.translation.along
        named = [axis for axis, unit in zip("xyz", np.eye(3), strict=True) if way == tuple(unit)]
        spoken = named[0] if named else f"({', '.join(f'{c:g}' for c in way or ())})"
        return f"{'about' if self.rotation else 'along'} {spoken}"

    @property
    def _motion(self) -> tuple[float, ...]:
        none = np.zeros(3)
        off: Any = self.rotation or self.translation
        way = np.asarray(off.about if self.rotation else off.along)
        way = off.by * way / np.linalg.norm(way)
        return tuple(map(float, np.concatenate([none, way] if self.rotation else [way, none])))


def _width(told: Told) -> float:
    """Return how wide the range of a stress is, over itself [-]."""
    return inf if told.error is None else told.error.high - told.error.low
