"""Parts of a layout in a spec: bodies, blades between them, springs to the ground."""

from collections.abc import Sequence
from itertools import product
from typing import Annotated, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema

from flexcli.parts.base import (
    Angle,
    Inertia,
    Length,
    Mass,
    Part,
    PositiveLength,
    QuantityOf,
    RotationalStiffness,
    Stiffness,
    spec_error,
)
from flexcli.parts.geometries.base import Extent
from flexcli.parts.geometries.blade_profile import AnyProfile, BladeProfile, ConstantProfile

__all__ = [
    "DrawnBlade",
    "DrawnBody",
    "DrawnSupport",
    "Motion",
    "Name",
    "Place",
    "corners_of",
    "distance",
    "refuse_no_blade",
]

Name: TypeAlias = Annotated[str, Field(pattern=r"^[A-Za-z][A-Za-z0-9-]*$")]
Place: TypeAlias = tuple[Length, Length]


class Motion(Part):
    """What the moving body does: a rotation, or a translation in a direction from x."""

    translation: Angle | None = None

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any) -> Any:
        if data == "rotation":
            return {}
        if not isinstance(data, dict) or set(data) != {"translation"}:
            raise spec_error(
                "a motion is a rotation, or a translation in a direction",
                "write rotation, or {translation: 90 deg}",
            )
        return data

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        direction = {
            "type": "object",
            "properties": {
                "translation": {
                    "allOf": [QuantityOf("angle").json_schema()],
                    "description": "Direction of the travel, as an angle from x",
                }
            },
            "required": ["translation"],
            "additionalProperties": False,
        }
        return {"anyOf": [{"const": "rotation"}, direction]}


class DrawnBody(Part):
    """A rigid body: its point, its mass and its inertia about its centre of mass."""

    at: Place
    """Point of the body in the drawing, x and y, e.g. ``[0 mm, 20 mm]``."""
    mass: Mass = 0.0
    """Mass of the body, e.g. ``50 g``."""
    inertia: Inertia = 0.0
    """Moment of inertia about its centre of mass, around the axis of the plane,
    e.g. ``5e-6 kg*m^2``.
    """
    com: Place | None = None
    """Centre of mass; left out, the point of the body, e.g. ``[0 mm, 22 mm]``."""
    box: tuple[PositiveLength, PositiveLength, PositiveLength] | None = None
    """Sides of a box along x, y and z about the centre of mass that it fills, for an envelope,
    e.g. ``[20 mm, 40 mm, 10 mm]``.
    """


def corners_of(box: tuple[float, float, float]) -> NDArray[np.float64]:
    """Return the corners of a box of given sides about the origin, shape (8, 3) [m]."""
    return np.array([np.multiply(box, each) for each in product((-0.5, 0.5), repeat=3)])


def distance(start: Sequence[float], end: Sequence[float]) -> float:
    """Return the distance of two points [m], or those of many designs."""
    found: float = np.sqrt(sum((b - a) ** 2 for a, b in zip(start, end, strict=True)))
    return found


def refuse_no_blade(between: tuple[str, str], length: float) -> None:
    """Raise a finding where a part joins a body to itself, or has no length."""
    if between[0] == between[1]:
        raise spec_error(
            f"both ends of this blade are on {between[0]}", "name two bodies, or ground",
            at=("between",),
        )  # fmt: skip
    if length == 0.0:
        raise spec_error("this blade has no length", "give its two ends", at=("to",))


class DrawnBlade(Part):
    """A straight blade from one body to another, or to the ground."""

    between: tuple[Name, Name]
    """The two bodies that it joins; ground is the base, e.g. ``[ground, stage]``."""
    start: Place = Field(alias="from")
    """Where it starts, on the first body, e.g. ``[-10 mm, 0 mm]``."""
    end: Place = Field(alias="to")
    """Where it ends, on the second body, e.g. ``[-10 mm, 20 mm]``."""
    b: PositiveLength
    """Width, across the plane of the motion, e.g. ``10 mm``."""
    z: Length = 0.0
    """Height of its middle over the plane of the mechanism, e.g. ``5 mm``."""
    h: Extent | None = None
    """Thickness, where it is constant; else give a profile, e.g. ``0.2 mm``."""
    profile: AnyProfile | None = None
    """Thickness along the blade, where it is not constant,
    e.g. ``profile: {kind: necked-down, h: 0.1 mm, l_c: 5 mm}``.
    """

    @model_validator(mode="after")
    def _is_a_blade(self) -> "DrawnBlade":
        refuse_no_blade(self.between, self.length)
        if (self.h is None) == (self.profile is None):
            raise spec_error("a thickness is h or a profile", "give one of them, e.g. h: 0.2 mm")
        misfit = self.thickness.misfit(self.length)
        if misfit:
            raise spec_error(misfit, "draw it longer, or shorten them", at=("profile",))
        return self

    @property
    def length(self) -> float:
        """Return its length [m]."""
        return distance(self.start, self.end)

    @property
    def thickness(self) -> BladeProfile:
        """Return its profile, which is constant where h is given."""
        if self.profile is not None:
            return self.profile
        assert self.h is not None  # one of both is given
        return ConstantProfile.model_construct(kind="constant", h=self.h)


class DrawnSupport(Part):
    """Springs from a body to the ground at a point: along x, along y and in rotation."""

    body: Name
    """Body that the springs hold, e.g. ``stage``."""
    at: Place
    """Point where they hold it, e.g. ``[0 mm, 20 mm]``."""
    x: Stiffness | None = None
    """Stiffness along x, e.g. ``1 N/mm``."""
    y: Stiffness | None = None
    """Stiffness along y, e.g. ``1 N/mm``."""
    theta: RotationalStiffness | None = None
    """Stiffness in rotation, e.g. ``1 N*m/rad``."""

    @model_validator(mode="after")
    def _is_a_spring(self) -> "DrawnSupport":
        if self.x is self.y is self.theta is None:
            raise spec_error("a support without stiffness", "give x, y or theta, e.g. x: 1 N/um")
        return self
