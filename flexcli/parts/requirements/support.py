"""Support: how stiff a joint is against loads off its motion, from its 6×6 compliance at rest.

They judge a given design; a 6×6 compliance is no posynomial, so they cannot size one. What
assembles it is imported where it is called: few designs ask, and all would wait for it.
"""

from collections.abc import Iterator
from dataclasses import replace
from math import cos, inf, sin
from typing import Annotated, Any, ClassVar, Literal, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import field_validator, model_validator

from flexcli.errors import SolveError
from flexcli.formulas.rigid_motion import motion_at
from flexcli.parts.base import (
    Length,
    PositiveLength,
    QuantityOf,
    Ratio,
    RotationalStiffness,
    Stiffness,
    in_either,
    spec_error,
)
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import Bound, Limit
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["Deflection", "Direction", "Support", "compliance_of"]

Direction = Literal["x", "y", "z", "theta_x", "theta_y", "theta_z"]
"""Of a motion or a load: x along the stroke of a stage, or the bisector of a pivot; z along the
width of the blades, the axis of a pivot; y completes them. A layout has its drawing's axes.
"""

DIRECTIONS = get_args(Direction)

Place = tuple[Length, Length, Length]

_Given = Ratio | Stiffness | RotationalStiffness
_Moved = PositiveLength | Annotated[float, QuantityOf("angle", above=0.0)]

CENTRE = (0.0, 0.0, 0.0)
"""The moving body's point in the layout of its joint."""

STIFFER, SOFTER = ErrorRange(0.0, inf), ErrorRange(-1.0, 0.0)
"""Clamps keep a wide blade from narrowing and from warping, so that it is stiffer than the beams
here and moves less, by how much they do not tell."""

IN_PLANE = {"x", "y", "theta_z"}
"""Directions in which the blades bend and stretch, and do not twist."""

SOURCE = "linear beams with shear, assembled in space at rest"


def compliance_of(ask: Ask, point: tuple[float, float, float] = CENTRE) -> NDArray[np.float64]:
    """Return the 6×6 compliance of the joint, free but for its guide, along the axes of cases.

    Parameters
    ----------
    ask : Ask
        The joint with its sizes.
    point : tuple of float
        Where, from the moving body's point, along the same axes [m].

    Raises
    ------
    NotAvailable
        When the joint has no layout, no shear modulus, or a freedom without any spring.

    """
    from flexcli.mechanics.support import support_compliance

    layout = ask.geometry.layout(ask.material.elastic, ask.sizes)
    if layout.G is None:
        raise NotAvailable("needs material.poisson_ratio for its shear and torsion")
    c, s = cos(ask.geometry.axes), sin(ask.geometry.axes)
    axes = ((c, s, 0.0), (-s, c, 0.0), (0.0, 0.0, 1.0))
    (x, y), (p, q, z) = layout.body(MOVING).point, point
    place = (x + c * p - s * q, y + s * p + c * q, z)
    try:
        C = support_compliance(layout, MOVING, place, axes)
    except SolveError as error:
        raise NotAvailable(f"has no stiffness: {error}") from error
    if ask.geometry.motion == "translation" and ask.geometry.held(0.0)[2] is not None:
        # what guides it keeps it from turning about z
        C = C - np.outer(C[:, 5], C[5]) / C[5, 5]
        C[5], C[:, 5] = 0.0, 0.0
    return C


def compliance(ask: Ask, point: tuple[float, float, float]) -> NDArray[np.float64]:
    """Return the 6×6 compliance of the joint at a point, or raise why there is none."""
    try:
        return compliance_of(ask, point)
    except NotAvailable as error:
        hint = "complete the design, or leave this requirement out"
        raise RequirementError(f"a {ask.geometry.name} {error}", hint) from error


def _index(direction: Direction) -> int:
    return DIRECTIONS.index(direction)


def _turns(direction: Direction) -> bool:
    return direction.startswith("theta")


def _along(direction: Direction) -> str:
    return f"about {direction[-1]}" if _turns(direction) else f"along {direction}"


class Support(Bound):
    """Bounds on the stiffness in a direction, all others free; or on its ratio to another's."""

    label: ClassVar[str] = "support"
    closed_form: ClassVar[bool] = False

    direction: Direction
    """Direction of the force or moment, e.g. ``direction: z, min: 1 N/um``."""
    over: Direction | None = None
    """Direction whose stiffness it is compared with; the bounds are then plain ratios,
    e.g. ``over: x, direction: y, min: 100``.
    """
    point: Place = CENTRE
    """Point on the moving body where it is asked, from the centre of a pivot or of a stage, or
    from a tip,
    e.g. ``[0 mm, 5 mm, 0 mm]``.
    """

    @field_validator("min", "max", "equals", mode="before", json_schema_input_type=_Given)
    @classmethod
    def _stiffness_or_ratio(cls, data: Any) -> Any:
        """Return value and SI unit, of whichever it is."""
        kinds = ("ratio", "stiffness", "rotational stiffness")
        return None if data is None else in_either(data, *kinds)

    @model_validator(mode="after")
    def _in_its_unit(self) -> "Support":
        if self.over is not None and _turns(self.over) != _turns(self.direction):
            raise spec_error(
                "a ratio is of two forces or of two moments", "e.g. theta_x over theta_z",
                at=("over",),
            )  # fmt: skip
        for name in ("min", "max", "equals"):
            given = getattr(self, name)
            if given is not None and given[1] != self.unit:
                ratio = "" if given[1] else ", or give over: for a ratio"
                raise spec_error(
                    f"the bound on the {self.spoken} is in {self.unit or 'plain numbers'}",
                    f"write e.g. {self.example}{ratio}",
                    at=(name,),
                )
        return self

    @property
    def unit(self) -> str:
        """Return the SI unit of what is bounded."""
        if self.over is not None:
            return ""
        return "N*m/rad" if _turns(self.direction) else "N/m"

    @property
    def example(self) -> str:
        """Return a bound as one would write it."""
        return {"": "100", "N/m": "1 N/um", "N*m/rad": "1 N*m/rad"}[self.unit]

    @property
    def spoken(self) -> str:
        """Return what is bounded, in words."""
        over = f" over that {_along(self.over)}" if self.over is not None else ""
        return f"stiffness {_along(self.direction)}{over}"

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on the stiffness or on the ratio."""
        C = compliance(ask, self.point)
        for each in (self.direction, self.over):
            if each is not None and C[_index(each), _index(each)] == 0.0:
                raise RequirementError(
                    f"the guide of a {ask.geometry.name} lets it not move {_along(each)}",
                    "ask for another direction",
                )
        value = 1.0 / C[_index(self.direction), _index(self.direction)]
        if self.over is not None:
            value *= C[_index(self.over), _index(self.over)]
        plain = {
            name: given[0]
            for name in ("min", "max", "equals")
            if (given := getattr(self, name)) is not None
        }
        name = f"{self.label} {self.direction}" + (f"/{self.over}" if self.over else "")
        for limit in self.model_copy(update=plain).bounds(
            float(value),
            case="",
            quantity=self.spoken,
            unit=self.unit,
            source=SOURCE,
            kind=QuantityKind.SUPPORT,
            error=self._error(ask),
        ):
            yield replace(limit, requirement=name)

    def _error(self, ask: Ask) -> ErrorRange | None:
        """Return how far real blades are off: of a ratio only in the plane, where no blade twists.

        There each is stiffer than its beam by at most 1/(1 − ν²), and so is the joint. Clamps
        that give way make it softer, and a ratio anything between.
        """
        softer = 1.0 / (1.0 + ask.clamps_give) - 1.0
        if self.over is None:
            return STIFFER + ErrorRange(softer, 0.0)
        nu = ask.material.elastic.nu
        if nu is None or not {self.direction, self.over} <= IN_PLANE:
            return None
        stiffer = (1.0 + ask.clamps_give) / (1.0 - nu**2) - 1.0
        return ErrorRange(1.0 / (1.0 + stiffer) - 1.0, stiffer)


class Deflection(Bound):
    """A bound on how far a case's wrench, at the centre, moves a point in a direction."""

    label: ClassVar[str] = "deflection"
    per_case: ClassVar[bool] = True
    closed_form: ClassVar[bool] = False

    min: None = None
    max: Any
    """The most that the point may move or turn, e.g. ``max: 5 um, direction: z``."""
    equals: None = None
    direction: Direction
    """Direction of the motion, e.g. ``direction: z, max: 5 um``."""
    point: Place = CENTRE
    """Point on the moving body that is asked about, from the centre of a pivot or of a stage, or
    from a tip,
    e.g. ``[0 mm, 5 mm, 0 mm]``.
    """

    @field_validator("max", mode="before", json_schema_input_type=_Moved)
    @classmethod
    def _length_or_angle(cls, data: Any) -> Any:
        """Return value and SI unit, of whichever it is."""
        return in_either(data, "length", "angle")

    @model_validator(mode="after")
    def _in_its_unit(self) -> "Deflection":
        if self.max[1] != self.unit:
            raise spec_error(
                f"a deflection {_along(self.direction)} is in {self.unit}, not {self.max[1]}",
                f"write {'1 mrad' if self.unit == 'rad' else '1 um'}",
                at=("max",),
            )
        return self

    @property
    def unit(self) -> str:
        """Return the SI unit of the deflection."""
        return "rad" if _turns(self.direction) else "m"

    def applies(self, scene: Scene) -> bool:
        """Return whether the case has a wrench."""
        return scene.wrench is not None

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the wrench."""
        return frozenset({LoadKind.WRENCH})

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the deflection, with either sign, against its bound."""
        assert ask.scene.wrench is not None  # it applies
        centre = compliance(ask, CENTRE) @ np.array(ask.scene.wrench)
        moved = float(motion_at(self.point)[_index(self.direction)] @ centre)
        plain = self.model_copy(update={"max": self.max[0]})
        for sign in (1.0, -1.0):
            for limit in plain.bounds(
                sign * moved,
                case=ask.scene.case,
                quantity=f"deflection {_along(self.direction)} under the wrench",
                unit=self.unit,
                source=SOURCE,
                kind=QuantityKind.SUPPORT,
                error=SOFTER + ErrorRange(0.0, ask.clamps_give),
            ):
                yield replace(limit, requirement=f"{self.label} {self.direction}")
