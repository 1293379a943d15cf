"""One load case on each joint: travel, forces, accelerations and end conditions."""

from collections.abc import Iterable, Mapping
from enum import StrEnum
from itertools import product
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from flexcli.numerics.rows import atan2, cos, hypot, sin
from flexcli.parts.ends import ENDS, FREE
from flexcli.results import Value

if TYPE_CHECKING:
    from flexcli.parts.asd import Vibration
    from flexcli.parts.excitation import Sine, Sweep, Tone
    from flexcli.parts.quality import Quality
    from flexcli.parts.shock import Shock
    from flexcli.parts.temperature import Temperature

__all__ = [
    "IN_PLANE",
    "NO_WRENCH",
    "ROUNDING",
    "STATED",
    "WARM",
    "LoadKind",
    "Push",
    "Scene",
    "Wrench",
    "axes_off_plane",
    "components_across",
    "components_along",
    "largest_travel",
]


IN_PLANE = (0, 1, 5)
"""Components of a wrench in the joint's plane."""

ROUNDING = 1e-12
"""Relative size of a component below which it is rounding."""


WARM = "has no closed form for a temperature"
"""Why the closed forms do not cover a case with a temperature."""

STATED = "stated in the case"
"""Why a case has the ends that it states."""


class LoadKind(StrEnum):
    """Kinds of loads of a case, by their keys in the spec."""

    STROKE = "stroke"
    LOAD = "load"
    WRENCH = "wrench"
    ACCELERATION = "acceleration"
    ASD = "asd"
    SHOCK = "shock"
    SINE = "sine"
    SWEEP = "sweep"
    AXES = "axes"
    SINES = "sines"
    TEMPERATURE = "temperature"


Wrench: TypeAlias = tuple[float, float, float, float, float, float]
"""Forces along x, y, z [N] and moments about them [N·m] on the joint's moving body."""

NO_WRENCH: Wrench = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class Push(NamedTuple):
    """A force in the plane [N] and its direction from x of the joint's layout [rad]."""

    force: float
    direction: float


class Scene(NamedTuple):
    """One case in the joint's own terms.

    ``travel`` and ``mean_travel`` are rotations [rad] or translations [m] of the joint, ``middle``
    is the mean travel with the sign of the stroke; ``force`` is the largest force on a joint in its
    plane [N], ``axial_share`` the largest axial force in a blade per unit of it. ``forces`` are its
    parts, each with its direction from the x of the joint's layout [rad], without those that only
    drive the stroke.

    ``stated`` is the wrench of load and wrench on the joint, ``inertial`` that of each
    acceleration; both in the frame of the joint's layout, at the moving body's point. Each may act
    in either sense, independently of the others. ``accelerations`` are those on the masses of the
    layout's own bodies [m/s²], one for each ``inertial``.
    """

    case: str
    travel: float
    mean_travel: float
    middle: float
    cycles: float | None
    force: float
    force_name: str
    axial_share: float
    ends: str | None
    ends_why: str
    acceleration: float
    """Size of the steady acceleration [m/s²]."""
    axis: str
    """Axis that it acts along, nothing where it is not along one."""
    vibration: "Vibration | None"
    shock: "Shock | None"
    lock: str | None
    wrench: tuple[float, ...] | None
    forces: tuple[tuple[float, float], ...]
    values: Mapping[str, Value]
    sine: "Sine | None" = None
    sweep: "Sweep | None" = None
    sines: "tuple[Tone, ...]" = ()
    quality: "Quality | None" = None
    shaken_axes: frozenset[str] = frozenset()
    in_turn: bool = False
    """Whether the axes along which the base is shaken act one after another."""
    temperature: "Temperature | None" = None
    loads: frozenset[LoadKind] = frozenset()
    """Kinds of loads of the case; some requirement has to look at each."""
    pushed_by: frozenset[LoadKind] = frozenset()
    """Those that are fully included in the stresses of the joint's plane."""
    across_by: frozenset[LoadKind] = frozenset()
    """Those that also act out of the plane, on a joint whose blades are judged in space."""
    tilts: bool = False
    """Whether what acts in the plane, or shakes it, may tilt the body out of it, and nothing says
    what holds it."""
    stated: Wrench = NO_WRENCH
    inertial: tuple[Wrench, ...] = ()
    accelerations: tuple[tuple[float, float, float], ...] = ()
    drive: int = 5
    """Component of a wrench that drives the stroke: the moment about z, or the force along y."""
    beyond: str = ""
    """Why the closed forms do not cover its loads, empty where they do."""
    in_space: bool = False
    """Whether the joint is drawn in space, where everything acts on it."""
    may_bow_aside: bool = False
    """Whether no formula tells what buckles its blades across their width, in a plane in which
    nothing guides it."""
    on_bodies: bool = False
    """Whether accelerations, along the axes of cases, act on all of a mechanism that is locked."""
    unjudged: str = ""
    """Why no model has an answer to all that acts in it, empty where one may."""
    directed: bool = False
    """Whether the first of ``forces`` acts in its stated sense only, not either way."""
    standing: "Scene | None" = None
    """What stands beside the vibrations of a case, if anything does: the case without them."""
    has_plane: bool = True
    """Whether the joint has a plane in which forces act on it, as bars along an axis do not."""

    @property
    def vibrates_in_space(self) -> bool:
        """Return whether the response of its modes leaves the plane, or has no model there."""
        off, shaken = axes_off_plane(self.lock), {*self.shaken_axes}
        return bool(self.in_space or off & shaken or (self.tilts and shaken))

    @property
    def leaves_plane(self) -> bool:
        """Return whether a force in the plane may buckle it out of it, by more than one blade."""
        free = (self.may_bow_aside or self.tilts) and self.ends == FREE
        return free and not self.across_by and self.blade_force > 0.0

    @property
    def has_one_sense(self) -> bool:
        """Return whether what it states acts in that sense alone; a wrench acts either way."""
        return self.directed and self.wrench is None

    @property
    def moves(self) -> bool:
        """Return whether the case has a stroke."""
        return bool(self.travel > 0.0 or self.mean_travel > 0.0)

    @property
    def hold(self) -> str:
        """Return what holds a mechanism in space where its loads may buckle it, in words."""
        if self.on_bodies:
            return f"{self.lock} locked"
        return "drive locked at its stroke" if self.moves else "drive free"

    @property
    def keeps(self) -> str:
        """Return what keeps it where its loads are looked at that buckle it, in words."""
        return "its stroke kept by a force" if self.moves and not self.on_bodies else self.hold

    @property
    def ends_and_rest(self) -> tuple[float, ...]:
        """Return the travels that a case may stand at: the ends of its stroke, and rest."""
        return tuple(dict.fromkeys((*self.stroke_ends, 0.0)))

    @property
    def stroke_ends(self) -> tuple[float, float]:
        """Return the travels of both ends of the stroke, rest without one [m or rad]."""
        return self.middle + self.travel, self.middle - self.travel

    @property
    def sags(self) -> bool:
        """Return whether a steady acceleration along one axis makes the body sag along it."""
        return self.acceleration > 0.0 and bool(self.axis)

    @property
    def states_ends(self) -> bool:
        """Return whether the case itself says what holds the blades' ends."""
        return self.ends is not None and self.ends_why == STATED

    @property
    def keeps_turn(self) -> bool:
        """Return whether the ends or the lock of the case keep the body from turning."""
        if self.lock is not None and not self.states_ends:
            return True
        return self.ends is not None and ENDS[self.ends].turn

    @property
    def push(self) -> float:
        """Return the largest load along the stroke itself [N or N·m]."""
        if self.lock is not None:
            return 0.0
        return abs(self.stated[self.drive]) + sum(abs(each[self.drive]) for each in self.inertial)

    @property
    def bends(self) -> bool:
        """Return whether the case moves the joint."""
        return self.moves or self.push > 0.0

    @property
    def is_stressed(self) -> bool:
        """Return whether anything stresses the joint: a stroke, or loads in any direction."""
        return self.moves or bool(self.across_by) or self.is_loaded

    @property
    def is_loaded(self) -> bool:
        """Return whether anything in the joint's plane, or space, acts besides the stroke."""
        if self.temperature is not None:
            return True
        acts = range(6) if self.in_space else [i for i in IN_PLANE if i not in self.across]
        own = any(each[i] for each in self.accelerations for i in acts if i < 3)
        return own or any(each[i] for each in (self.stated, *self.inertial) for i in acts)

    @property
    def is_accelerated(self) -> bool:
        """Return whether an acceleration in the joint's plane acts on its blades."""
        planar = self.has_plane and not self.on_bodies
        return planar and any(x or y for x, y, _ in self.accelerations)

    @property
    def across(self) -> tuple[int, ...]:
        """Return the components of a wrench that act out of the joint's plane, if it has one."""
        return components_across(has_plane=self.has_plane)

    def at_assembly(self) -> "Scene":
        """Return the same case without its temperature."""
        if self.temperature is None:
            return self
        return self._replace(
            temperature=None,
            loads=self.loads - {LoadKind.TEMPERATURE},
            beyond="" if self.beyond == WARM else self.beyond,
        )

    def without_loads(self) -> "Scene":
        """Return the same case with its stroke alone."""
        return self._replace(
            forces=(),
            force=0.0,
            stated=NO_WRENCH,
            inertial=(),
            accelerations=(),
            across_by=frozenset(),
            beyond="",
        )

    def with_loads(self, share: float) -> "Scene":
        """Return the same case with its loads times a share, its stroke as it is."""

        def part(wrench: Wrench) -> Wrench:
            x, y, z, *moments = (share * each for each in wrench)
            return x, y, z, moments[0], moments[1], moments[2]

        return self._replace(
            force=share * self.force,
            forces=tuple((share * force, direction) for force, direction in self.forces),
            stated=part(self.stated),
            inertial=tuple(map(part, self.inertial)),
            accelerations=tuple(
                (share * x, share * y, share * z) for x, y, z in self.accelerations
            ),
        )

    def in_plane(self) -> "Scene":
        """Return the same case without what acts, or tilts its body, out of the joint's plane."""
        acts = [float(i not in self.across) for i in range(6)]

        def kept(wrench: Wrench) -> Wrench:
            x, y, z, xx, yy, zz = (a * part for a, part in zip(acts, wrench, strict=True))
            return x, y, z, xx, yy, zz

        return self._replace(
            stated=kept(self.stated),
            inertial=tuple(map(kept, self.inertial)),
            accelerations=tuple((acts[0] * x, acts[1] * y, 0.0) for x, y, _ in self.accelerations),
            across_by=frozenset(),
            tilts=False,
        )

    def at_first_end(self) -> "Scene":
        """Return the same case with the first end of its stroke as all of it."""
        end = self.stroke_ends[0]
        return self._replace(travel=0.0, mean_travel=abs(end), middle=end)

    def pushes(self) -> tuple[Push, ...]:
        """Return the resultants of the forces for each combination of their senses."""
        found: list[Push] = []
        each: list[tuple[float, ...]] = [(1.0, -1.0)] * len(self.forces)
        if self.directed:
            each[0] = (1.0,)
        for signs in product(*each):
            x, y = (
                sum(s * f * trig(d) for s, (f, d) in zip(signs, self.forces, strict=True))
                for trig in (cos, sin)
            )
            size = hypot(x, y)
            if size > ROUNDING * self.force:
                found.append(Push(size, atan2(y, x)))
        return tuple(found)

    @property
    def driver(self) -> str:
        """Return the name of what the stresses of the case grow with."""
        return " and ".join(
            ["stroke"] * self.moves + ["force"] * bool(self.blade_force > 0.0 or self.push > 0.0)
        )

    @property
    def blade_force(self) -> float:
        """Return the largest axial force in a blade [N]."""
        return self.force * self.axial_share


def largest_travel(scenes: Iterable[Scene]) -> float:
    """Return the largest travel of the joint in any case, from rest [rad or m]."""
    return max((scene.travel + scene.mean_travel for scene in scenes), default=0.0)


def axes_off_plane(lock: str | None) -> frozenset[str]:
    """Return the axes along which a base that shakes is responded to in space alone.

    They are z, and of a locked mechanism all but x.
    """
    return frozenset("z" if lock is None else "yz")


def components_along(axis: str | None, level: float) -> tuple[float, float, float]:
    """Return the components along x, y and z of what acts along one of them."""
    x, y, z = (level if axis == each else 0.0 for each in "xyz")
    return x, y, z


def components_across(*, has_plane: bool) -> tuple[int, ...]:
    """Return the components of a wrench that act out of the joint's plane, if it has one."""
    return (2, 3, 4) if has_plane else (0, 1, 2, 3, 4)
