"""Parts of a layout in space: bodies, blades and rods, copies of them, and the motion."""

from collections.abc import Iterator
from typing import Annotated, Any, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray
from pydantic import BeforeValidator, Field, GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema

from flexcli.mechanics.space.layout import Matrix3, Vector
from flexcli.parts.base import (
    Density,
    Inertia,
    Length,
    Mass,
    Part,
    PositiveLength,
    QuantityOf,
    spec_error,
)
from flexcli.parts.geometries.base import Extent
from flexcli.parts.geometries.layout_parts import Name, distance, refuse_no_blade
from flexcli.parts.material import Material

__all__ = [
    "Axis",
    "DrawnSpaceBlade",
    "DrawnSpaceBody",
    "DrawnSpaceRod",
    "Placed",
    "SpaceMotion",
    "Way",
]

Floats = NDArray[np.float64]

Axis = Literal["x", "y", "z"]

Place3: TypeAlias = tuple[Length, Length, Length]

AXES = ("x", "y", "z")

ALONG = 1e-6
"""Sine of the angle between width and blade below which they count as parallel."""

_Number = Annotated[float, QuantityOf("ratio")]


def _direction(data: Any) -> Any:
    """Return the components of a named axis; any other value unchanged."""
    if isinstance(data, str) and data in AXES:
        return [float(data == axis) for axis in AXES]
    if isinstance(data, str):
        raise spec_error(f"'{data}' is no direction", "write x, y, z or three numbers")
    if isinstance(data, list) and len(data) == 3 and not any(data):
        raise spec_error("this direction is zero", "write x, y, z or three numbers")
    return data


Way: TypeAlias = Annotated[
    tuple[_Number, _Number, _Number],
    BeforeValidator(_direction, json_schema_input_type=Axis | tuple[_Number, _Number, _Number]),
]
"""A direction: an axis by its name, or three numbers."""


class _Turn(Part):
    """An axis of rotation in the drawing."""

    about: Way
    """Direction of the axis: x, y, z or three numbers, e.g. ``z``."""
    at: Place3 = (0.0, 0.0, 0.0)
    """A point of the axis, e.g. ``[0 mm, 0 mm, 0 mm]``."""


class SpaceMotion(Part):
    """What the stroke makes the moving body do: a translation, or a rotation about an axis."""

    translation: Way | None = None
    """Direction of the travel: x, y, z or three numbers, e.g. ``translation: y``."""
    rotation: _Turn | None = None
    """Axis that it turns about, e.g. ``rotation: {about: z, at: [0 mm, 0 mm, 0 mm]}``."""

    @model_validator(mode="before")
    @classmethod
    def _one_of_them(cls, data: Any) -> Any:
        if not isinstance(data, dict) or len(data) != 1:
            raise spec_error(
                "a motion in space is a translation or a rotation",
                "write {translation: y} or {rotation: {about: z, at: [0 mm, 0 mm, 0 mm]}}",
            )
        return data

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return {**handler.resolve_ref_schema(handler(schema)), "minProperties": 1}


class DrawnSpaceBody(Part):
    """A rigid body in space, with its mass given or that of a box."""

    at: Place3
    """Point of the body, where motions of it are stated, e.g. ``[0 mm, 20 mm, 0 mm]``."""
    mass: Mass = 0.0
    """Mass of the body, e.g. ``50 g``."""
    com: Place3 | None = None
    """Centre of mass; left out, the point of the body, e.g. ``[0 mm, 22 mm, 0 mm]``."""
    inertia: tuple[Inertia, Inertia, Inertia] | None = None
    """Moments of inertia about the centre of mass, around x, y and z; left out, none,
    e.g. ``inertia: [2e-5 kg*m^2, 3e-5 kg*m^2, 4e-5 kg*m^2], mass: 50 g``.
    """
    box: tuple[PositiveLength, PositiveLength, PositiveLength] | None = None
    """Sides of a solid box along x, y and z, of which mass and inertia are,
    e.g. ``box: [20 mm, 40 mm, 10 mm], density: 2810 kg/m^3``.
    """
    density: Density | None = None
    """Density of the box, e.g. ``density: 2810 kg/m^3, box: [20 mm, 40 mm, 10 mm]``."""
    material: Material | None = None
    """Material of the body, where it is not that of the blades: inline, the name of a shipped one,
    or a path. A box has its density, and the body grows as it does,
    e.g. ``material: 7075-t6, box: [20 mm, 40 mm, 10 mm]``.
    """

    @model_validator(mode="after")
    def _mass_is_one(self) -> "DrawnSpaceBody":
        if self.density is not None and self.material is not None:
            raise spec_error(
                "the density is given twice", "keep density or material", at=("density",)
            )
        if self.material is not None and self.material.density is None and self.box is not None:
            raise spec_error("its material has no density", "give it one, or mass and inertia")
        if (self.density is not None and self.box is None) or (
            self.box is not None and self._density is None
        ):
            raise spec_error(
                "a box and its density go together",
                "give both, a box and a material, or mass and inertia",
            )
        if self.box is not None and (self.mass or self.inertia is not None):
            raise spec_error("the mass is given twice", "give mass and inertia, or box and density")
        if self.inertia is not None:
            one, other, most = sorted(self.inertia)
            if one + other < most * (1.0 - 1e-9):
                raise spec_error(
                    "no body has these moments of inertia: the largest is above the sum of the "
                    "other two", "check the three values", at=("inertia",),
                )  # fmt: skip
            if most and not self.mass:
                raise spec_error("an inertia without a mass", "give mass", at=("inertia",))
        return self

    @property
    def _density(self) -> float | None:
        """Return the density of its box [kg/m³]."""
        of_material = self.material.density if self.material is not None else None
        return of_material.value if of_material is not None else self.density

    @property
    def weight(self) -> float:
        """Return its mass [kg]."""
        if self.box is None or self._density is None:
            return self.mass
        return float(np.prod(self.box)) * self._density

    @property
    def tensor(self) -> Matrix3:
        """Return its inertia about the centre of mass [kg·m²]."""
        moments: Any = self.inertia or (0.0, 0.0, 0.0)
        if self.box is not None:
            x, y, z = (side**2 for side in self.box)
            moments = (self.weight / 12.0 * each for each in (y + z, z + x, x + y))
        a, b, c = moments
        return (a, 0.0, 0.0), (0.0, b, 0.0), (0.0, 0.0, c)


class Repeat(Part):
    """Equal copies around an axis through the origin of the drawing."""

    count: Annotated[int, Field(ge=2, le=100)]
    """How many there are, evenly spread over the whole turn, e.g. ``3``."""
    about: Way
    """Direction of the axis: x, y, z or three numbers, e.g. ``z``."""


class Placed(NamedTuple):
    """One copy of a drawn blade or rod: its name, its ends, the direction of its width."""

    name: str
    drawn: str
    start: Vector
    end: Vector
    width: Vector | None


class _Member(Part):
    """A straight blade or rod from one body to another, or to the ground, and its copies."""

    between: tuple[Name, Name]
    """The two bodies that it joins; ground is the base, e.g. ``[ground, stage]``."""
    start: Place3 = Field(alias="from")
    """Where it starts, on the first body, e.g. ``[0 mm, 15 mm, 0 mm]``."""
    end: Place3 = Field(alias="to")
    """Where it ends, on the second body, e.g. ``[50 mm, 15 mm, 0 mm]``."""
    mirror: tuple[Axis, ...] = ()
    """Axes along which it has a mirror image across the origin, e.g. ``[y]``."""
    repeat: Repeat | None = None
    """Copies around an axis, e.g. ``{count: 3, about: z}``."""

    @model_validator(mode="after")
    def _joins_two(self) -> "_Member":
        refuse_no_blade(self.between, self.length)
        if len(set(self.mirror)) < len(self.mirror):
            raise spec_error("an axis is named twice", "name each axis once", at=("mirror",))
        return self

    @property
    def length(self) -> float:
        """Return its length [m]."""
        return distance(self.start, self.end)

    @property
    def count(self) -> int:
        """Return their number with all copies."""
        return (1 << len(self.mirror)) * (1 if self.repeat is None else self.repeat.count)

    def copies(self, name: str, width: Vector | None) -> Iterator[Placed]:
        """Yield it, or its copies by numbered names."""
        maps = [np.eye(3)]
        for axis in self.mirror:
            image = np.eye(3)
            image[AXES.index(axis), AXES.index(axis)] = -1.0
            maps += [image @ each for each in maps]
        if self.repeat is not None:
            turns = [
                _turned(self.repeat.about, 2.0 * np.pi * k / self.repeat.count)
                for k in range(self.repeat.count)
            ]
            maps = [turn @ each for turn in turns for each in maps]
        for number, each in enumerate(maps, 1):
            x_0, y_0, z_0 = map(float, each @ self.start)
            x_1, y_1, z_1 = map(float, each @ self.end)
            way = None
            if width is not None:
                w_x, w_y, w_z = map(float, each @ width)
                way = (w_x, w_y, w_z)
            called = name if len(maps) == 1 else f"{name}-{number}"
            yield Placed(called, name, (x_0, y_0, z_0), (x_1, y_1, z_1), way)


class DrawnSpaceBlade(_Member):
    """A straight blade of constant thickness and width."""

    h: Extent
    """Thickness of the blade, e.g. ``0.2 mm``."""
    b: PositiveLength
    """Width of the blade, e.g. ``10 mm``."""
    width: Way
    """Direction of the width: x, y, z or three numbers, e.g. ``z``."""

    @model_validator(mode="after")
    def _width_is_across(self) -> "DrawnSpaceBlade":
        along = np.subtract(self.end, self.start) / self.length
        width = np.asarray(self.width) / np.linalg.norm(self.width)
        if float(np.linalg.norm(np.cross(along, width))) < ALONG:
            raise spec_error(
                "the width points along the blade", "write a direction across it", at=("width",)
            )
        if self.h.fixed is not None and self.h.fixed > self.b:
            raise spec_error(
                "this blade is thicker than wide", "swap h and b, and turn its width", at=("b",)
            )
        return self


class DrawnSpaceRod(_Member):
    """A straight round rod."""

    d: Extent
    """Diameter of the rod, e.g. ``0.5 mm``."""


def _turned(about: Vector, angle: float) -> Floats:
    """Return the matrix of a rotation about a direction (Rodrigues)."""
    n = np.asarray(about) / np.linalg.norm(about)
    K = np.array([[0.0, -n[2], n[1]], [n[2], 0.0, -n[0]], [-n[1], n[0], 0.0]])
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K)
