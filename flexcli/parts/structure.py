"""A mechanism as a linear structure: rigid bodies on the blades of its joints, in one plane.

Bodies, blades and supports are those of :mod:`flexcli.mechanics.layout`, here with several copies
of one joint put together, and reduced to matrices.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import cos, sin
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.layout import Blade, Body, Layout, Point, Support
from flexcli.mechanics.stresses import beside_beam_rows
from flexcli.mechanics.vibrating_layout import vibrating_layout
from flexcli.parts.geometries.base import GROUND, MOVING

__all__ = [
    "MOTIONS",
    "Answer",
    "OwnMotion",
    "PlacedJoint",
    "Structure",
    "assemble",
    "bending_rows",
    "joined",
    "largest_of",
    "on_joints",
    "turned",
]

Floats = NDArray[np.float64]


class PlacedJoint(NamedTuple):
    """Place of a copy of the joint: its two bodies, its centre [m], its turn from x [rad]."""

    name: str
    first: str
    second: str
    point: Point
    orientation: float


class OwnMotion(NamedTuple):
    """The mechanism's driven motion: its body, direction (x, y, φ), and name as an output."""

    body: str
    direction: tuple[float, float, float]
    name: str


@dataclass(frozen=True, eq=False)
class Structure:
    """Matrices of the free coordinates, what shakes them, and rows of outputs.

    Coordinates are relative to the base. ``pull`` is the inertial force per acceleration of the
    base along an axis, ``moved`` the mass that it moves [kg]. ``outputs`` holds rows (k, n): the
    mechanism's own motion [m or rad], per joint the force on it [N], axial stress and stress at
    the faces [Pa]; or rows (k, c, n) of what has c components at each of k places, a vector's or
    those of an equivalent stress. ``motion`` (n,) is the row of the own motion, nothing where that
    is locked. ``bodies`` holds rows of the motion of each body's point in ``directions``,
    relative to the base; ``wrenches`` (3, n) by joint the force on what it carries [N] and the
    moment about the point of the joint's moving body [N·m], along the axes of its own drawing, and
    ``joint_motions`` how far that point moves from its base [m, rad]. ``unsure`` are rows of
    stress (k, n) whose peaks, added up over those of one joint, the stress there may be off by
    either way, by joint and what they are of.
    """

    mass: Floats
    stiffness: Floats
    pull: Mapping[str, Floats]
    moved: Mapping[str, float]
    outputs: Mapping[str, Floats] = field(default_factory=dict)
    motion: Floats | None = None
    bodies: Mapping[str, Floats] = field(default_factory=dict)
    directions: tuple[str, ...] = ("x", "y", "theta_z")
    wrenches: Mapping[str, Floats] = field(default_factory=dict)
    joint_motions: Mapping[str, Floats] = field(default_factory=dict)
    unsure: Mapping[tuple[str, int], Floats] = field(default_factory=dict)

    def stiffened(self, factor: float) -> "Structure":
        """Return the structure with all of its stiffness, and so its stresses, times a factor."""
        outputs = {
            name: rows if name in MOTIONS else rows * factor for name, rows in self.outputs.items()
        }
        wrenches = {name: rows * factor for name, rows in self.wrenches.items()}
        unsure = {name: rows * factor for name, rows in self.unsure.items()}
        return replace(
            self, stiffness=self.stiffness * factor, outputs=outputs, wrenches=wrenches,
            unsure=unsure,
        )  # fmt: skip

    def softened_along(self, share: float) -> "Structure":
        """Return a structure in a plane whose blades give way along themselves by a share more.

        Its own motion, where it has one, keeps its stiffness and its stress.
        """
        lost = share / (1.0 + share)
        stiffness = (1.0 - lost) * self.stiffness
        if self.motion is not None:
            stiffness += lost * self.motion_stiffness * np.outer(self.motion, self.motion)
        outputs = {}
        for name, rows in self.outputs.items():
            if name.startswith("stress"):  # at both faces
                outputs[name] = rows - lost * np.concatenate(2 * [self.outputs[f"axial {name}"]])
            else:
                outputs[name] = rows if name in MOTIONS else (1.0 - lost) * rows
        wrenches = {name: (1.0 - lost) * rows for name, rows in self.wrenches.items()}
        return replace(self, stiffness=stiffness, outputs=outputs, wrenches=wrenches)

    def mixed(self, other: "Structure", share: float) -> "Structure":
        """Return the structure between this one and another with the same rows and mass."""

        def between(one: Mapping[Any, Floats], two: Mapping[Any, Floats]) -> dict[Any, Floats]:
            return {key: (1.0 - share) * one[key] + share * two[key] for key in one}

        return replace(
            self,
            stiffness=(1.0 - share) * self.stiffness + share * other.stiffness,
            pull=between(self.pull, other.pull),
            outputs=between(self.outputs, other.outputs),
            wrenches=between(self.wrenches, other.wrenches),
            unsure=between(self.unsure, other.unsure),
        )

    def without_motion(self) -> "Structure":
        """Return the structure without a driven motion, as where it is locked."""
        outputs = {name: rows for name, rows in self.outputs.items() if name not in MOTIONS}
        return replace(self, outputs=outputs, motion=None)

    def in_mode(self, angular: float, shape: Floats) -> "Structure":
        """Return the structure restricted to one of its modes, of unit modal mass."""
        return Structure(
            np.ones((1, 1)),
            np.array([[angular**2]]),
            {axis: np.array([pull @ shape]) for axis, pull in self.pull.items()},
            self.moved,
            {name: (rows @ shape)[..., None] for name, rows in self.outputs.items()},
        )

    @property
    def motion_stiffness(self) -> float:
        """Return the static stiffness along the driven motion, all else free [N/m or N·m/rad]."""
        assert self.motion is not None  # not locked
        return float(1.0 / (self.motion @ np.linalg.solve(self.stiffness, self.motion)))


Answer = Callable[[Structure], Mapping[str, float]]
"""Function that returns one number for each output of a structure, as its peak."""


def largest_of(answers: Mapping[str, float], prefix: str) -> float:
    """Return the largest number of the outputs whose name starts so, zero where there is none."""
    return max((each for name, each in answers.items() if name.startswith(prefix)), default=0.0)


MOTIONS = ("travel", "rotation")
"""Names of outputs that are motions."""


def assemble(
    bodies: Sequence[Body],
    joints: Sequence[PlacedJoint],
    joint: Layout,
    motion: OwnMotion | None,
    *,
    density: float = 0.0,
    thick: bool = False,
    held: Sequence[tuple[str, int]] = (),
) -> Structure:
    """Return the structure of bodies on alike joints.

    Parameters
    ----------
    bodies : sequence of Body
        Those that the joints connect; no other body moves but those within a joint.
    joints : sequence of PlacedJoint
        Where copies of the joint stand.
    joint : Layout
        The joint between the ground and its moving body.
    motion : OwnMotion or None
        The mechanism's own motion, nothing where it is locked.
    density : float
        Of the blades [kg/m³]; 0 leaves their mass out.
    thick : bool
        Whether blades shear and their sections have rotary inertia.
    held : sequence of (str, int)
        Coordinates of bodies that cannot move.

    Returns
    -------
    Structure
        Matrices and rows.

    """
    copies = [_placed(joint, at) for at in joints]
    found = vibrating_layout(_whole(bodies, copies), density, held, thick=thick)
    outputs, wrenches, motions = (dict[str, Floats]() for _ in range(3))
    unsure = dict[tuple[str, int], Floats]()
    places = {body.name: body.point for body in bodies}
    for at, copy in zip(joints, copies, strict=True):
        point = turned(joint.body(MOVING).point, at.orientation, at.point)
        wrench = np.zeros((3, found.mass.shape[0]))
        for blade in copy.blades:
            if at.second in (blade.first, blade.second):
                sign = 1.0 if blade.second == at.second else -1.0
                end = found.end_force[blade.name]
                x, y = np.subtract(blade.end, point)
                wrench += sign * np.stack([end[0], end[1], end[2] + x * end[1] - y * end[0]])
        outputs[f"force {at.name}"] = wrench[None, :2]
        wrenches[at.name] = np.stack([*turned((wrench[0], wrench[1]), -at.orientation), wrench[2]])
        motions[at.name] = np.zeros_like(wrench)
        for body, sign in ((at.second, 1.0), (at.first, -1.0)):
            if body in places:
                u, v, phi = found.motions[body]
                x, y = np.subtract(point, places[body])
                moved = turned((u - y * phi, v + x * phi), -at.orientation)
                motions[at.name] += sign * np.stack([*moved, phi])
        axial = np.concatenate([found.axial[blade.name] * blade.peak[1] for blade in copy.blades])
        each = [
            (blade, *found.places[blade.name], found.bending[blade.name] * blade.peak[0])
            for blade in copy.blades
        ]
        bending, off = bending_rows(each)
        outputs[f"axial stress {at.name}"] = axial
        outputs[f"stress {at.name}"] = np.concatenate([axial + bending, axial - bending])
        unsure |= {(at.name, k): rows for k, rows in enumerate(off)}
    own = None
    if motion is not None:
        own = np.array(motion.direction) @ found.motions[motion.body]
        outputs[motion.name] = own[None, :]
    return Structure(
        found.mass, found.stiffness, found.pull, found.moved, outputs, own, found.motions,
        wrenches=wrenches, joint_motions=motions, unsure=unsure,
    )  # fmt: skip


def bending_rows(
    blades: Iterable[tuple[Blade, Floats, Floats, Floats]],
) -> tuple[Floats, list[Floats]]:
    """Return rows of the bending stress of blades with what no beam has of it, and its doubts.

    Each has its places, its thickness there [m], and the rows of its beam. The rows of a doubt are
    at the same places, nothing of blades that have none.
    """
    each = [(bending, *beside_beam_rows(blade, s, h, bending)) for blade, s, h, bending in blades]
    kinds = max((len(unsure) for *_, unsure in each), default=0)
    doubts = [
        np.concatenate([
            unsure[k] if k < len(unsure) else np.zeros_like(bending) for bending, _, unsure in each
        ])
        for k in range(kinds)
    ]  # fmt: skip
    return np.concatenate([bending + added for bending, added, _ in each]), doubts


def on_joints(bodies: Sequence[Body], joints: Sequence[PlacedJoint], joint: Layout) -> Layout:
    """Return bodies on copies of a joint as one layout, in the form that :func:`assemble` takes."""
    return _whole(bodies, [_placed(joint, at) for at in joints])


def _whole(bodies: Sequence[Body], copies: Sequence[Layout]) -> Layout:
    """Return the layout of bodies and of the joints that they are on."""
    return Layout(
        bodies=(*bodies, *(body for copy in copies for body in copy.bodies)),
        blades=tuple(blade for copy in copies for blade in copy.blades),
        E=copies[0].E,
        G=copies[0].G,
        supports=tuple(support for copy in copies for support in copy.supports),
    )


def joined(name: str, point: Point, parts: Sequence[Body]) -> Body:
    """Return the rigid body formed by several, its motion that of a point [m]."""
    mass = sum(part.mass for part in parts)
    if mass == 0.0:
        return Body(name, point, 0.0, sum(part.inertia for part in parts), point)
    x, y = (sum(part.mass * part.com[i] for part in parts) / mass for i in (0, 1))
    inertia = sum(
        part.inertia + part.mass * ((part.com[0] - x) ** 2 + (part.com[1] - y) ** 2)
        for part in parts
    )
    return Body(name, point, mass, inertia, (x, y))


def turned(place: Point, angle: float, shift: Point = (0.0, 0.0)) -> Point:
    """Return a place turned about the origin by an angle [rad], then shifted."""
    c, s = cos(angle), sin(angle)
    x, y = place
    return shift[0] + c * x - s * y, shift[1] + s * x + c * y


def _placed(joint: Layout, at: PlacedJoint) -> Layout:
    """Return a copy of a joint in its place, its own bodies renamed."""
    called = {GROUND: at.first, MOVING: at.second}
    called |= {b.name: f"{at.name} {b.name}" for b in joint.bodies if b.name != MOVING}

    def there(place: Point) -> Point:
        return turned(place, at.orientation, at.point)

    return Layout(
        bodies=tuple(
            body._replace(name=called[body.name], point=there(body.point), com=there(body.com))
            for body in joint.bodies
            if body.name != MOVING
        ),
        blades=tuple(
            replace(
                blade,
                name=f"{at.name} {blade.name}",
                first=called.get(blade.first, at.first),
                second=called.get(blade.second, at.first),
                start=there(blade.start),
                end=there(blade.end),
            )
            for blade in joint.blades
        ),
        E=joint.E,
        G=joint.G,
        supports=tuple(_support(s, called, there(s.point), at.orientation) for s in joint.supports),
    )


def _support(support: Support, called: Mapping[str, str], point: Point, angle: float) -> Support:
    """Return a support turned with its joint, by a quarter turn where its springs differ."""
    along, across, turn = support.stiffness
    if abs(sin(angle)) > 0.5:
        along, across = across, along
    return Support(called[support.body], point, (along, across, turn))
