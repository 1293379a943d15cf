"""A mechanism for drawing: at rest and moved, in metres, in the axes of the spec."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from flexcli.results.shown import rendered

__all__ = [
    "XY",
    "Drawing",
    "DrawnAngle",
    "DrawnBlade",
    "DrawnBody",
    "DrawnCut",
    "DrawnEdge",
    "DrawnForce",
    "DrawnGuide",
    "DrawnInSpace",
    "DrawnLength",
    "DrawnMass",
    "DrawnState",
]

XY = tuple[float, float]
"""A place [m] in the plane."""


class DrawnEdge(NamedTuple):
    """Part of an outline: straight, or a quarter of an ellipse about a centre.

    Its half-axes are those from the centre to the start and to the end.
    """

    start: XY
    end: XY
    centre: XY | None = None


@dataclass(frozen=True, eq=False)
class DrawnBlade:
    """A blade at rest: its axis from end to end, the thickness at each place of it.

    ``outlines`` are closed, anticlockwise, one of each stretch that flexes, exactly. Where
    ``thickness`` is zero the blade is rigid, and the spec does not say how thick. ``width`` is that
    across the plane, ``height`` that of its middle over the plane [m]. Of one that is seen from
    somewhere, ``surface`` are the corners of its middle surface, ``length`` how long it is [m].
    """

    name: str
    first: str
    second: str
    axis: tuple[XY, ...]
    thickness: tuple[float, ...]
    width: float
    height: float = 0.0
    outlines: tuple[tuple[DrawnEdge, ...], ...] = ()
    surface: tuple[XY, ...] = ()
    length: float | None = None


class DrawnInSpace(NamedTuple):
    """A blade or rod in its own plane, and where that stands.

    ``axes`` are the plane's x and y and the normal, as rows; ``origin`` [m] is their place.
    """

    blade: DrawnBlade
    axes: tuple[tuple[float, float, float], ...]
    origin: tuple[float, float, float]


class DrawnMass(NamedTuple):
    """A mass [kg] at its centre; its name where it is not that of its body."""

    name: str
    at: XY
    mass: float


class DrawnLength(NamedTuple):
    """A length of the mechanism with its name, from one place to another."""

    name: str
    start: XY
    end: XY


@dataclass(frozen=True, eq=False)
class DrawnBody:
    """A rigid body, or the ground: where blades are clamped to it, and the ways they leave it.

    ``clamps`` are the places, ``ways`` the unit vectors from the blade into the body, zero about a
    pin, ``depths`` the thickness of each blade there, ``point`` its reference point.
    """

    name: str
    clamps: tuple[XY, ...]
    ways: tuple[XY, ...]
    depths: tuple[float, ...]
    point: XY
    is_ground: bool = False
    masses: tuple[DrawnMass, ...] = ()


class DrawnCut(NamedTuple):
    """How a wire cuts it from a plate: width of the slots, narrowest gap, least inner radius [m].

    ``outlines`` are the corners of bodies by the names of the spec.
    """

    slot: float
    gap: float
    radius: float
    outlines: Mapping[str, tuple[XY, ...]]


@dataclass(frozen=True, eq=False)
class DrawnState:
    """The mechanism moved by ``travel``: axes of the blades, stress [Pa] there, bodies' motions.

    ``motions`` are (x, y, φ) of each body's point [m, m, rad].
    """

    travel: float
    axes: Mapping[str, tuple[XY, ...]]
    stress: Mapping[str, tuple[float, ...]]
    motions: Mapping[str, tuple[float, float, float]]


@dataclass(frozen=True, eq=False)
class DrawnForce:
    """A force [N] at a place, with its name; its direction is a unit vector."""

    name: str
    at: XY
    way: XY
    newtons: float


class DrawnGuide(NamedTuple):
    """A stage between two bodies: its name, its place, and the unit vector along which it moves.

    One that ``is_ideal`` has no blades, and stands on the ground or (``on_ground`` false) a body.
    """

    name: str
    at: XY
    way: XY
    is_ideal: bool
    on_ground: bool


@dataclass(frozen=True, eq=False)
class DrawnAngle:
    """An angle at a place, from one direction to another [rad], with its name."""

    name: str
    at: XY
    start: float
    end: float


@dataclass(frozen=True, eq=False)
class Drawing:
    """A joint, stage or layout as it is drawn.

    ``sizes`` are (symbol, value [m]) as the spec names them; ``states`` are in the order + end, −
    end of the stroke, ``path`` is where the centre or moving point goes between them; ``unit`` is
    that of the travel, ``pivots`` the named centres of several joints, ``guides`` what moves along
    a line where the blades do not say so alone, ``missed`` why a case has no
    states, ``cut`` how a wire makes it. A bar that twists is a blade on its axis; ``twists`` says
    so. ``axes`` are those that are seen and where they point; ``is_a_view`` says that it is of a
    mechanism in space, seen from one side, ``views`` has those from others by name. Plain bodies
    are in proportion to ``joint_size`` [m], or to all.
    """

    kind: str
    motion: str
    blades: tuple[DrawnBlade, ...]
    bodies: tuple[DrawnBody, ...]
    sizes: tuple[tuple[str, float], ...]
    centre: XY
    case: str = ""
    unit: str = "m"
    states: tuple[DrawnState, ...] = ()
    path: tuple[XY, ...] = ()
    forces: tuple[DrawnForce, ...] = ()
    angles: tuple[DrawnAngle, ...] = ()
    lengths: tuple[DrawnLength, ...] = ()
    pivots: tuple[tuple[str, XY], ...] = ()
    guides: tuple[DrawnGuide, ...] = ()
    missed: str = ""
    axes: tuple[tuple[str, XY], ...] = (("x", (1.0, 0.0)), ("y", (0.0, 1.0)))
    is_a_view: bool = False
    views: Mapping[str, "Drawing"] = field(default_factory=dict)
    in_space: tuple[DrawnInSpace, ...] = ()
    joint_size: float | None = None
    twists: bool = False
    strength: float | None = None
    notes: tuple[str, ...] = ()
    cut: DrawnCut | None = None

    def _repr_svg_(self) -> str | None:
        svg: str | None = rendered(self, "svg")
        return svg
