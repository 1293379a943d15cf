"""Support: the stiffness of a joint across its motion, from its 6×6 compliance at rest.

They judge a given design; a 6×6 compliance is no posynomial, so they cannot size one.
"""

from abc import abstractmethod
from collections.abc import Callable, Iterator
from contextlib import suppress
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self, TypeAlias, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import field_validator, model_validator

from flexcli.errors import SolveError
from flexcli.formulas.rigid_motion import axes_about_z, motion_along, motion_at
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
from flexcli.parts.elastic import Buckled, NotAvailable
from flexcli.parts.requirements.ask import Ask, RequirementError, Told
from flexcli.parts.requirements.base import Bound, BoundAtStroke, Limit
from flexcli.parts.scene import LoadKind, Scene
from flexcli.parts.space_joint import Form, SpaceJoint, joint_in_space, joint_of
from flexcli.parts.strained_compliance import beside_wrench, beyond_first_order, changed_beside
from flexcli.results import EXACT, ErrorRange, QuantityKind, error_of_ratio

if TYPE_CHECKING:
    from flexcli.mechanics.space.linear import SpaceAssembly

__all__ = [
    "CENTRE",
    "DIRECTIONS",
    "Deflection",
    "Direction",
    "LengthOrAngle",
    "MotionBound",
    "Place",
    "Support",
    "compliance_of",
    "deflection_form",
    "form_in",
    "joint_of_model",
    "turns",
]

Direction = Literal["x", "y", "z", "theta_x", "theta_y", "theta_z"]
"""Direction of a motion or a load: x along the stroke of a stage, or the bisector of a pivot; z
along the width of the blades, the axis of a pivot; y completes them. A layout has its drawing's
axes."""

DIRECTIONS = get_args(Direction)

Place = tuple[Length, Length, Length]

_Given = Ratio | Stiffness | RotationalStiffness
LengthOrAngle: TypeAlias = PositiveLength | Annotated[float, QuantityOf("angle", above=0.0)]

CENTRE = (0.0, 0.0, 0.0)
"""The moving body's point in the layout of its joint."""

HELD = 1e-14
"""Share of the compliance below which a guide or the drive holds a direction."""

OUT = [2, 3, 4]
"""Motions and loads out of the plane, among six along the axes of cases."""

BY_BEAMS = "exact beams in space under the wrench, and their tangent at stroke"


def compliance_of(
    ask: Ask,
    point: Place = CENTRE,
    *,
    assembly: "SpaceAssembly | None" = None,
    locked: bool = False,
    in_plane: bool = False,
) -> NDArray[np.float64]:
    """Return the 6×6 compliance of the joint at rest, along the axes of cases.

    Parameters
    ----------
    ask : Ask
        The joint with its sizes.
    point : tuple of float
        Where, from the moving body's point, along the same axes [m].
    assembly : SpaceAssembly, optional
        The joint with other springs than its best ones.
    locked : bool
        Whether the drive holds its motion; else all is free but for a guide.
    in_plane : bool
        Whether nothing is asked but of a joint's motion in the plane of which it is its own image.

    Raises
    ------
    NotAvailable
        When the joint has no layout, no shear modulus, or a freedom without any spring.

    """
    joint = joint_of_model(ask, in_plane=in_plane)
    drive = joint.layout.drive
    axes = axes_about_z(ask.geometry.axes)
    place = _at(joint.layout.body(drive.body).point + axes.T @ np.array(point))
    try:
        found = (assembly or joint.assembly).compliance(drive.body, place, locked=locked)
    except SolveError as error:
        raise NotAvailable(f"has no stiffness: {error}") from error
    turned = motion_along(axes)
    C = turned @ found @ turned.T
    if ask.geometry.is_guided:
        # what guides it keeps it from turning about z
        C = C - np.outer(C[:, 5], C[5]) / C[5, 5]
        C[5], C[:, 5] = 0.0, 0.0
    return np.asarray(C)


def stays_in_plane(ask: Ask, sought: NDArray[np.float64], load: NDArray[np.float64]) -> bool:
    """Return whether no motion out of the plane has a part in what a load does to what is sought.

    Both are along the axes of cases (6,).
    """
    if sought[OUT].any() or load[OUT].any():
        return False
    return joint_in_space(ask.geometry, ask.material, ask.sizes).is_mirrored


def deflection_form(ask: Ask, sought: NDArray[np.float64], load: NDArray[np.float64]) -> Form:
    """Return the displacement sought per wrench at the moving body's point, at rest.

    Both are along the axes of cases (6,), all free but for a guide.
    """
    joint = joint_of_model(ask, in_plane=stays_in_plane(ask, sought, load))
    return form_in(ask, joint, sought, load)


def form_in(
    ask: Ask, joint: SpaceJoint, sought: NDArray[np.float64], load: NDArray[np.float64]
) -> Form:
    """Return it of a joint that may have moved, or have springs of its own."""
    strained = _strained(ask, joint, joint.assembly, sought, load)
    form, stiff = joint.form(strained[:, 0], strained[:, 1]), joint.rigid_crossings
    if form.off is None or stiff is None or not _is_along(sought, load):
        return form
    # a motion along its own load is no less than where more is rigid
    held = _strained(ask, joint, stiff, sought, load)[:, 1]
    share = float(stiff.stiffness @ held**2 / (joint.assembly.stiffness @ strained[:, 1] ** 2))
    (low, high), less = form.off, (share - 1.0) * form.found
    return form._replace(off=(max(low, less), high) if less < 0.0 else (low, min(high, less)))


def _strained(
    ask: Ask,
    joint: SpaceJoint,
    assembly: "SpaceAssembly",
    sought: NDArray[np.float64],
    load: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Return the deformations of all springs under what is sought, and under the load."""
    body = joint.layout.body(joint.layout.drive.body)
    turned = motion_along(axes_about_z(ask.geometry.axes))
    rows = turned @ assembly.motion(body.name, body.point)
    wrenches = np.stack([sought, load, np.eye(6)[5]], axis=1)
    try:
        moved = assembly.moved(rows.T @ wrenches)
    except SolveError as error:
        raise NotAvailable(f"has no stiffness: {error}") from error
    strained = moved.deformations
    if ask.geometry.is_guided:
        # what guides it keeps it from turning about z
        turns = rows[5] @ moved.coordinates
        strained = strained - np.outer(strained[:, 2], turns / turns[2])
    return np.asarray(strained[:, :2])


def _at(place: NDArray[np.float64]) -> Place:
    x, y, z = map(float, place)
    return x, y, z


def joint_of_model(ask: Ask, *, in_plane: bool = False) -> SpaceJoint:
    """Return the joint in space, with the springs of its model where that has its own."""
    own = ask.joint_model.own_joint(ask)
    if own is not None:
        return SpaceJoint(*own)
    joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
    springs = ask.joint_model.springs(ask, in_plane=in_plane)
    return joint if springs is None else SpaceJoint(joint.layout, springs)


def space_joint(ask: Ask) -> SpaceJoint:
    """Return the joint in space, or raise why there is none."""
    try:
        return joint_of_model(ask)
    except NotAvailable as error:
        raise _refused(ask, error) from error


def compliance(ask: Ask, point: Place, **how: Any) -> NDArray[np.float64]:
    """Return the 6×6 compliance of the joint at a point, or raise why there is none."""
    try:
        return compliance_of(ask, point, **how)
    except NotAvailable as error:
        raise _refused(ask, error) from error


def _refused(ask: Ask, error: NotAvailable) -> RequirementError:
    hint = "complete the design, or leave this requirement out"
    return RequirementError(f"a {ask.geometry.name} {error}", hint)


def turns(direction: Direction) -> bool:
    """Return whether a direction is a rotation."""
    return direction.startswith("theta")


def spoken_place(point: Place) -> str:
    """Return the place of a point off the centre in words, which tell requirements apart."""
    if point == CENTRE:
        return ""
    return f" at ({', '.join(f'{1e3 * c:g}' for c in point)}) mm"


def _is_along(one: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    """Return whether two wrenches, or rows of motions, are multiples of each other."""
    return bool(np.linalg.matrix_rank(np.stack([one, other])) < 2)


def _along(direction: Direction) -> str:
    return f"about {direction[-1]}" if turns(direction) else f"along {direction}"


class Support(BoundAtStroke):
    """Bounds on the stiffness in a direction, all others free; or on its ratio to another's.

    That is at rest, or at both ends of each case's stroke; the drive is free as well unless it is
    said to be locked.
    """

    label: ClassVar[str] = "support"
    by_solids: ClassVar[bool] = True
    by_shells: ClassVar[QuantityKind | None] = QuantityKind.SUPPORT
    closed_form: ClassVar[bool] = False
    is_warmed: ClassVar[bool] = True

    direction: Direction
    """Direction of the force or moment, e.g. ``direction: z, min: 1 N/um``."""
    drive: Literal["free", "locked"] = "free"
    """Whether the drive holds the motion of the stroke meanwhile, e.g. ``locked``."""
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
        """Return value and SI unit, of stiffness or ratio."""
        kinds = ("ratio", "stiffness", "rotational stiffness")
        return None if data is None else in_either(data, *kinds)

    @model_validator(mode="before")
    @classmethod
    def _names_its_direction(cls, data: Any) -> Any:
        if isinstance(data, dict) and "about" in data and "direction" not in data:
            axis = data["about"] if data["about"] in ("x", "y", "z") else "x"
            raise spec_error(
                "a direction of turning has a name of its own",
                f"write direction: theta_{axis}", at=("about",),
            )  # fmt: skip
        return data

    @model_validator(mode="after")
    def _in_its_unit(self) -> "Support":
        if self.over is not None and turns(self.over) != turns(self.direction):
            raise spec_error(
                "a ratio is of two forces or of two moments", "e.g. theta_x over theta_z",
                at=("over",),
            )  # fmt: skip
        if self.over is not None and self.at == "full-stroke":
            raise spec_error(
                "a ratio is asked at rest alone", "ask for both stiffnesses at stroke",
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
        return "N*m/rad" if turns(self.direction) else "N/m"

    @property
    def example(self) -> str:
        """Return a bound as one would write it."""
        return {"": "100", "N/m": "1 N/um", "N*m/rad": "1 N*m/rad"}[self.unit]

    @property
    def spoken(self) -> str:
        """Return the bounded quantity in words."""
        over = f" over that {_along(self.over)}" if self.over is not None else ""
        return f"stiffness {_along(self.direction)}{over}"

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on the stiffness or on the ratio."""
        if self.at == "full-stroke":
            yield from self._limits_at_stroke(ask)
            return
        joint = space_joint(ask)
        value, error = self._at_rest(ask, joint, self.direction)
        if self.over is not None:
            other = self._at_rest(ask, joint, self.over)
            value, error = value / other.value, error_of_ratio(error, other.error)
        case, quantity = self.case_of(ask.scene), f"{self.spoken}, drive {self.drive}"
        for limit in self._bounds(value, error, case, quantity, ask.joint_model.at_rest):
            yield limit._replace(is_directed=joint.is_directed)

    def _at_rest(self, ask: Ask, joint: SpaceJoint, direction: Direction) -> Told:
        """Return a stiffness at rest, with what a temperature strains makes of it."""
        stiffness, locked = self._stiffness(ask, direction), self.drive == "locked"
        found = Told(stiffness(joint.assembly), joint.error(stiffness))
        if ask.scene.temperature is None:
            return found
        with suppress(NotAvailable):
            index = DIRECTIONS.index(direction)
            heat = ask.joint_model.warm_support_ratio(ask, index, self.point, locked=locked)
            return found.times(heat.value, heat.error)
        softer = changed_beside(joint_of(ask), ask.scene, locked=locked)
        return found.times(1.0, error_of_ratio(EXACT, softer))

    def _limits_at_stroke(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on the stiffness at both ends of the case's stroke."""
        index = DIRECTIONS.index(self.direction)
        locked = self.drive == "locked"
        quantity = f"{self.spoken} at full stroke, drive {self.drive}"
        source = f"tangent of {ask.joint_model.at_stroke}"
        directed = (
            ask.material.is_directed
            and ask.joint_model.directs_blades
            and space_joint(ask).is_directed
        )
        for value, error in ask.joint_model.support_at_stroke(
            ask, index, self.point, locked=locked
        ):
            told = _with_clamps(ask, error)
            for limit in self._bounds(value, told, ask.scene.case, quantity, source):
                yield limit._replace(is_directed=directed)

    def _bounds(
        self, value: float, error: ErrorRange | None, case: str, quantity: str, source: str
    ) -> Iterator[Limit]:
        """Yield the bounds on a stiffness or ratio."""
        plain = {
            name: given[0]
            for name in ("min", "max", "equals")
            if (given := getattr(self, name)) is not None
        }
        name = f"{self.label} {self.direction}" + (f"/{self.over}" if self.over else "")
        name += spoken_place(self.point)
        locked = " locked" if self.drive == "locked" else ""
        there = " at stroke" if self.at == "full-stroke" else ""
        for limit in self.model_copy(update=plain).bounds(
            value,
            case=case,
            quantity=quantity,
            unit=self.unit,
            source=source,
            kind=QuantityKind.SUPPORT,
            error=error,
        ):
            yield limit._replace(requirement=f"{name}{there}{locked}")

    def _stiffness(self, ask: Ask, direction: Direction) -> Callable[["SpaceAssembly"], float]:
        """Return the stiffness in a direction as a function of the springs."""
        index = DIRECTIONS.index(direction)

        def stiffness(assembly: "SpaceAssembly") -> float:
            C = compliance(ask, self.point, assembly=assembly, locked=self.drive == "locked")
            if C[index, index] <= HELD * np.trace(np.abs(C)[_kind(index)]):
                raise RequirementError(
                    f"the guide or drive of a {ask.geometry.name} lets it not move "
                    f"{_along(direction)}",
                    "ask for another direction",
                )
            return float(1.0 / C[index, index])

        return stiffness


def _kind(index: int) -> tuple[slice, slice]:
    """Return the block of the compliance that has the unit of an entry on its diagonal."""
    block = slice(0, 3) if index < 3 else slice(3, 6)
    return block, block


def _with_clamps(ask: Ask, error: ErrorRange | None) -> ErrorRange | None:
    """Return the error of a stiffness including the possible compliance of clamps."""
    if error is None:
        return None
    return error._replace(low=(1.0 + error.low) / (1.0 + ask.clamp_softening) - 1.0)


class MotionBound(Bound):
    """An upper bound on how far a point of the moving body goes in a direction, or turns."""

    per_case: ClassVar[bool] = True
    closed_form: ClassVar[bool] = False

    min: None = None
    max: Any
    """The most that the point may move or turn, e.g. ``max: 5 um, direction: z``."""
    equals: None = None
    direction: Direction
    """Direction of the motion, e.g. ``direction: z, max: 5 um``."""
    point: Place = CENTRE
    """Point on the moving body that is asked about, e.g. ``[0 mm, 5 mm, 0 mm]``."""

    @field_validator("max", mode="before", json_schema_input_type=LengthOrAngle)
    @classmethod
    def _length_or_angle(cls, data: Any) -> Any:
        """Return value and SI unit, of length or angle."""
        return in_either(data, "length", "angle")

    @model_validator(mode="after")
    def _in_its_unit(self) -> Self:
        if self.max[1] != self.unit:
            raise spec_error(
                f"a {self.spoken} is in {self.unit}, not {self.max[1]}",
                f"write {'1 mrad' if self.unit == 'rad' else '1 um'}",
                at=("max",),
            )
        return self

    @property
    def unit(self) -> str:
        """Return the SI unit of the motion."""
        return "rad" if turns(self.direction) else "m"

    @property
    @abstractmethod
    def spoken(self) -> str:
        """Return the bounded quantity in words, with its direction."""

    def bounds_in_direction(self, value: float, **of: Any) -> Iterator[Limit]:
        """Yield a motion [m or rad] against its bound, named by its direction."""
        plain = self.model_copy(update={"max": self.max[0]})
        for limit in plain.bounds(value, unit=self.unit, kind=QuantityKind.SUPPORT, **of):
            name = f"{self.label} {self.direction}{spoken_place(self.point)}"
            yield limit._replace(requirement=name)


class Deflection(MotionBound):
    """A bound on how far a case's wrench, at the centre, moves a point in a direction."""

    label: ClassVar[str] = "deflection"
    by_solids: ClassVar[bool] = True
    by_shells: ClassVar[QuantityKind | None] = QuantityKind.SUPPORT

    point: Place = CENTRE
    """Point on the moving body that is asked about, from the centre of a pivot or of a stage, or
    from a tip,
    e.g. ``[0 mm, 5 mm, 0 mm]``.
    """

    @property
    def spoken(self) -> str:
        """Return the bounded quantity in words, with its direction."""
        return f"deflection {_along(self.direction)}"

    def applies(self, scene: Scene) -> bool:
        """Return whether the case has a wrench."""
        return scene.wrench is not None

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the wrench, and what strains the joint that it moves."""
        beside = {LoadKind.LOAD, LoadKind.ACCELERATION, LoadKind.TEMPERATURE}
        return frozenset({LoadKind.WRENCH, *beside})

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the deflection, whichever way it goes, against its bound."""
        assert ask.scene.wrench is not None  # it applies
        try:
            found, source = ask.joint_model.deflections(ask, self.point, self.direction), BY_BEAMS
        except Buckled:
            raise
        except NotAvailable as reason:
            found, source = (self._at_rest(ask),), ask.joint_model.at_rest
            if found[0][1] is None:
                source += f"; the joint {reason}"
        for value, error in found:
            yield from self.bounds_in_direction(
                abs(value),
                case=ask.scene.case,
                quantity=f"{self.spoken} under the wrench, drive free",
                source=source,
                error=error,
            )

    def _at_rest(self, ask: Ask) -> tuple[float, ErrorRange | None]:
        """Return the deflection of straight blades and its error.

        Over a stroke the stiffness changes, by an amount that a linear model does not give.
        """
        load = np.array(ask.scene.wrench)
        sought = motion_at(self.point)[DIRECTIONS.index(self.direction)]
        form = deflection_form(ask, sought, load)
        error: ErrorRange | None = None
        if not ask.scene.moves and form.error is not None:
            moved = compliance(ask, CENTRE, in_plane=stays_in_plane(ask, sought, load)) @ load
            more = beyond_first_order(ask, moved, sought, load)
            joint, along = joint_of(ask), motion_along(axes_about_z(ask.geometry.axes))
            drive = along @ joint.layout.drive.motion
            driven = all(_is_along(each, drive) for each in (load, sought))
            beside = beside_wrench(ask)
            strained = changed_beside(joint, ask.scene, beside, driven=driven)
            if more is not None and strained is not None:
                # of a motion that is not along its load, of what both would do
                more += strained.largest * form.work / abs(form.found)
                error = form.error + ErrorRange(-more, more)
        return form.found, error
