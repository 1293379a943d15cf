"""Demand on a mechanism in space: motions held and loads, blended from a start to an end.

A share λ of the way in [0, 1] goes from what holds at the start (rest, or an earlier equilibrium
with its reactions) to what is asked. A body's motion is that of a point of it, along and about
three axes: shift, and rotation vector. Where rotations are held, moments are those that work on the
rotation vector; where none is, those about fixed axes.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.layout import Drive, MissedSeat, SpaceLayout, SpaceLoad, Vector

__all__ = ["Demand", "Force", "Frame", "Held", "Spring", "demand_of", "drive_frame"]

Floats = NDArray[np.float64]

Held: TypeAlias = Mapping[str, Sequence[float | None]]
"""Shift [m] and rotation vector [rad] of bodies along the axes of their frames; None is free."""


_ALONG_Z = 0.9
"""Component of a direction above which it counts as one along z."""


@dataclass(frozen=True, eq=False)
class Frame:
    """The point of a body at rest [m] and the axes (rows) that its motion is stated by."""

    point: Vector
    axes: Floats


class Force(NamedTuple):
    """A force and a moment on a body at an arm from its point; all scaled; sizes at λ = 0 and 1."""

    body: int
    arm: Floats
    force: Floats
    moment: Floats
    before: float
    after: float

    def size(self, share: float) -> float:
        """Return the factor on force and moment at the share λ."""
        return self.before + share * (self.after - self.before)


class Spring(NamedTuple):
    """Springs along and about the axes from a body, at an arm from its point, to the ground."""

    body: int
    arm: Floats
    shift: Floats
    turn: Floats


class Demand(NamedTuple):
    """Coordinates held (6 body + 0…5), the free ones, values before and after, loads, springs.

    ``turned`` are the bodies whose rotation vector is held in part. ``grown`` says that bodies and
    blades have their temperature from the start; else it comes on the way, as a ``missed`` seat.
    """

    held: NDArray[np.intp]
    free: NDArray[np.intp]
    before: Floats
    after: Floats
    forces: tuple[Force, ...]
    springs: tuple[Spring, ...]
    turned: NDArray[np.bool_]
    grown: bool = False
    missed: MissedSeat | None = None

    def off(self, share: float) -> MissedSeat | None:
        """Return the seat that is off as far as it is at the share λ of the way."""
        return None if self.missed is None else self.missed.times(self.warmth(share))

    def warmth(self, share: float) -> float:
        """Return the share of the temperature that is there at the share λ of the way."""
        return 1.0 if self.grown else share


def drive_frame(drive: Drive) -> dict[str, Frame]:
    """Return the frame of the driven body: its point, the drive's direction as first axis.

    Its third axis is z where the drive is across z.
    """
    x = np.asarray(drive.direction, dtype=np.float64)
    x = x / np.linalg.norm(x)
    other = np.eye(3)[2 if abs(x[2]) < _ALONG_Z else 0]
    z = other - (other @ x) * x
    z /= np.linalg.norm(z)
    return {drive.body: Frame(drive.point, np.stack([x, np.cross(z, x), z]))}


def demand_of(
    layout: SpaceLayout,
    held: Held,
    loads: Sequence[SpaceLoad],
    points: Floats,
    length: float,
    force: float,
    factor: float = 1.0,
    missed: MissedSeat | None = None,
) -> Demand:
    """Return what is asked, from rest, scaled by a length [m] and a force [N]; points as scaled."""
    names = [body.name for body in layout.bodies]
    for name in (
        *held,
        *(load.body for load in loads),
        *(spring.body for spring in layout.springs),
    ):
        if name not in names:
            raise KeyError(f"{name!r} is no body of the layout")
    index, values = [], []
    turned = np.zeros(len(names), dtype=bool)
    for body, name in enumerate(names):
        for axis, value in enumerate(held.get(name, ())):
            if value is not None:
                index.append(6 * body + axis)
                values.append(value / (length if axis < 3 else 1.0))
                turned[body] |= axis >= 3
    coordinates = np.array(index, dtype=np.intp)
    arm = {name: points[i] for i, name in enumerate(names)}
    return Demand(
        held=coordinates,
        free=np.setdiff1d(np.arange(6 * len(names)), coordinates),
        before=np.zeros(len(values)),
        after=np.array(values),
        forces=tuple(
            Force(
                names.index(load.body),
                np.asarray(load.point) / length - arm[load.body],
                np.asarray(load.force, dtype=np.float64) / force,
                np.asarray(load.moment, dtype=np.float64) / (force * length),
                0.0,
                factor,
            )
            for load in loads
        ),
        springs=tuple(
            Spring(
                names.index(spring.body),
                np.asarray(spring.point) / length - arm[spring.body],
                np.asarray(spring.stiffness[:3]) * length / force,
                np.asarray(spring.stiffness[3:]) / (force * length),
            )
            for spring in layout.springs
        ),
        turned=turned,
        missed=missed,
    )
