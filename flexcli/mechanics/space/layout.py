"""A mechanism in space at rest: rigid bodies, blades and rods between them, and its motion.

One description for every solver in space. Positions and directions are those of the drawing, in
the pose in which nothing is strained; a body of no listed name is the ground.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import hypot, inf, pi
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.clamped_blade import Across
from flexcli.formulas.profile import Profile
from flexcli.formulas.torsion_shapes import (
    circle_torsion_constant,
    star_area,
    star_fourth_moment,
    star_polar_moment,
    star_torsion_constant,
)

__all__ = [
    "BeamEffects",
    "Directed",
    "Drive",
    "Isotropic",
    "Matrix3",
    "MissedSeat",
    "SpaceBlade",
    "SpaceBody",
    "SpaceLayout",
    "SpaceLoad",
    "SpaceRod",
    "SpaceSpring",
    "SpaceStar",
    "Vector",
    "along",
    "grown_ends",
    "seats_grown",
    "vector",
    "without",
]

Floats = NDArray[np.float64]

Vector: TypeAlias = tuple[float, float, float]
"""Coordinates or components along x, y and z."""

Matrix3: TypeAlias = tuple[Vector, Vector, Vector]
"""A symmetric matrix, by rows."""

UNBENT = 1e-2
"""Share of what makes the arms of a star buckle in bending that is as good as none."""

_NONE: Matrix3 = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0))


class Isotropic(NamedTuple):
    """Material of a blade: Young's and shear modulus [Pa], density [kg/m³]."""

    E: float
    G: float
    density: float = 0.0

    @property
    def nu(self) -> float:
        """Return Poisson's ratio, E/2G − 1 [-]."""
        return self.E / (2.0 * self.G) - 1.0

    @property
    def wider(self) -> float:
        """Return the width of its isotropic plate over its own [-]."""
        return 1.0

    @property
    def shear(self) -> float:
        """Return G over that of its isotropic plate [-]."""
        return 1.0


class Directed(NamedTuple):
    """Material of a blade that is stiffer one way: E along it, G of its broad faces [Pa]."""

    E: float
    G: float
    density: float
    across: Across

    @property
    def nu(self) -> float:
        """Return Poisson's ratio of the isotropic plate that is as stiff where it is wide [-]."""
        return self.across.nu

    @property
    def wider(self) -> float:
        """Return the width of that plate over its own, (E_1/E_3)^¼ [-]."""
        return self.across.wider

    @property
    def shear(self) -> float:
        """Return G over that of the same plate, √(E_1 E_3)/(2 (1 + ν)) [-]."""
        return 2.0 * (1.0 + self.nu) * self.G * self.wider**2 / self.E


class BeamEffects(NamedTuple):
    """What a blade feels besides bending and Saint-Venant's torsion.

    ``plate`` multiplies bending, stretching and shear by what rigid clamps do to a wide blade;
    ``warping`` keeps clamped ends from warping, ``long_fibres`` is the stretch of the fibres that
    twist makes into helices (Wagner's term). ``curling`` joins it with the flattening of a curved
    section (:mod:`flexcli.mechanics.space.exact.section_law`); where a blade bends to and fro, it
    costs more nodes.
    """

    extension: bool = True
    shear: bool = True
    plate: bool = True
    warping: bool = True
    long_fibres: bool = True
    curling: bool = True

    def and_(self, other: "BeamEffects") -> "BeamEffects":
        """Return what both have."""
        return BeamEffects(*(one and two for one, two in zip(self, other, strict=True)))


_EVERYTHING = BeamEffects()


class SpaceBody(NamedTuple):
    """A rigid body: the point its motion is stated at [m], mass [kg] and its centre [m].

    ``inertia`` is the tensor about the centre of mass along the axes of the drawing [kg·m²]; its
    products stand with their sign as entries, −∫xy dm.
    """

    name: str
    point: Vector
    com: Vector
    mass: float = 0.0
    inertia: Matrix3 = _NONE


@dataclass(frozen=True, eq=False)
class SpaceBlade:
    """A straight blade of rectangular section from body ``first`` to body ``second``.

    ``profile`` is the thickness from ``start`` to ``end`` [m], ``b`` the width [m] in the
    direction ``width`` (of any length; what it has along the blade plays no part). ``peak`` are
    the factors by which its shape raises the stress of a section: in bending across the
    thickness, and along the blade. ``warps`` says that its clamps do not keep its ends flat.
    ``blocks`` is between which lengths lie blocks, as thick as the ends of a hinge, on either side
    of it up to the rigid bodies [m]. ``feels`` is what models do not leave out of it, ``crossed``
    the range of its stiffness over a beam's where it is one piece with a blade that it crosses,
    and ``shared`` the length from its start and its end that both share [m].
    """

    name: str
    first: str
    second: str
    start: Vector
    end: Vector
    width: Vector
    profile: Profile
    b: float
    material: Isotropic | Directed
    peak: tuple[float, float] = (1.0, 1.0)
    warps: bool = False
    blocks: tuple[float, float] = (0.0, 0.0)
    feels: BeamEffects = _EVERYTHING
    crossed: tuple[float, float] = (1.0, 1.0)
    shared: tuple[float, float] = (0.0, 0.0)

    @property
    def warps_freely(self) -> bool:
        """Return whether nothing is counted that keeps its ends flat."""
        return self.warps or not self.feels.warping

    @property
    def area(self) -> float:
        """Return the least area of its sections [m²]."""
        l = float(np.linalg.norm(np.subtract(self.end, self.start)))
        return float(self.b * self.profile.least_thickness(l))

    @cached_property
    def axes(self) -> Floats:
        """Its axes as rows, not writable: x along it, y across its thickness, z its width."""
        x = along(self.start, self.end)
        z = np.asarray(self.width, dtype=np.float64)
        return _rows(x, z - (z @ x) * x)


@dataclass(frozen=True, eq=False)
class SpaceRod:
    """A straight rod of round section of diameter ``d`` [m] from ``first`` to ``second``."""

    name: str
    first: str
    second: str
    start: Vector
    end: Vector
    d: float
    material: Isotropic

    @property
    def area(self) -> float:
        """Return the area of its section [m²]."""
        return pi * self.d**2 / 4.0

    @property
    def bent(self) -> float:
        """Return the second moment of its section about any axis across it [m⁴]."""
        return pi * self.d**4 / 64.0

    @property
    def fourth(self) -> float:
        """Return ∫r⁴ dA of its section [m⁶]."""
        return pi * self.d**6 / 192.0

    @property
    def torsion(self) -> float:
        """Return the torsion constant of its section [m⁴]."""
        return float(circle_torsion_constant(self.d))

    @property
    def sheared(self) -> float:
        """Return the shear of torsion at its faces over G times the twist per length [m]."""
        return self.d / 2.0

    @cached_property
    def axes(self) -> Floats:
        """Its axes as rows, not writable: x along it; y and z are any two across."""
        x = along(self.start, self.end)
        return _rows(x, np.cross(x, np.eye(3)[int(np.argmin(np.abs(x)))]))


@dataclass(frozen=True, eq=False)
class SpaceStar(SpaceRod):
    """A straight bar whose section is strips that cross on its axis, which its ends let warp.

    It bends alike in every direction, as a rod does. ``strips`` of thickness ``h`` and full width
    ``b`` [m] stand at even angles, the first along the bar's z; ``d`` is the diameter of the circle
    around them [m].
    """

    h: float
    b: float
    strips: int

    @property
    def area(self) -> float:
        """Return the area of its section [m²]."""
        return float(star_area(self.h, self.b, self.strips))

    @property
    def bent(self) -> float:
        """Return the second moment of its section about any axis across it [m⁴]."""
        return float(star_polar_moment(self.h, self.b, self.strips)) / 2.0

    @property
    def fourth(self) -> float:
        """Return ∫r⁴ dA of its section [m⁶]."""
        return float(star_fourth_moment(self.h, self.b, self.strips))

    @property
    def torsion(self) -> float:
        """Return the torsion constant of its section [m⁴]."""
        return float(star_torsion_constant(self.h, self.b, self.strips))

    @property
    def sheared(self) -> float:
        """Return the shear of torsion at its faces over G times the twist per length [m]."""
        return self.h

    def arms_bent(self, N: float, M: float) -> float:
        """Return the share of what makes its arms buckle that a bending moment may be [-].

        They surely do not below the even stress ``G J/I_p`` = 4 G (h/b)² at which the star twists
        aside as a column, whose arms hold each other no more than hinges on its axis; an axial
        force ``N`` takes its share of it. No bending is none of it.
        """
        most = self.material.G * self.torsion / (2.0 * self.bent)
        left = 1.0 - max(-N / self.area, 0.0) / most
        bent = M * self.d / 2.0 / self.bent / most
        if bent <= UNBENT:
            return 0.0
        return bent / left if left > 0.0 else inf

    def arms_bent_by(self, l: float, forces: Floats) -> float:
        """Return the same of the forces of its six springs at its middle, its length given."""
        N, V_y, V_z, _, M_y, M_z = (float(force) for force in forces)
        ends = abs(M_y) + abs(V_z) * l / 2.0, abs(M_z) + abs(V_y) * l / 2.0
        return self.arms_bent(N, hypot(*ends))

    @property
    def arms(self) -> Floats:
        """Return the directions of its arms in its y and z (arms, 2)."""
        turn = np.arange(2 * self.strips) * (pi / self.strips)
        return np.stack([np.sin(turn), np.cos(turn)], axis=-1)


class SpaceSpring(NamedTuple):
    """Springs from a body to the ground at a point, along and about x, y, z [N/m, N·m/rad]."""

    body: str
    point: Vector
    stiffness: tuple[float, float, float, float, float, float]


class SpaceLoad(NamedTuple):
    """A force at a point of a body [N, m] and a moment on it [N·m], constant in direction."""

    body: str
    point: Vector
    force: Vector = (0.0, 0.0, 0.0)
    moment: Vector = (0.0, 0.0, 0.0)

    def times(self, factor: float) -> "SpaceLoad":
        """Return a multiple of the load at its point."""
        force, moment = (vector(factor * np.asarray(each)) for each in (self.force, self.moment))
        return self._replace(force=force, moment=moment)


class MissedSeat(NamedTuple):
    """Offset of the seat of a blade, by its index, on its second body (6,) [m, rad].

    It is told at the blade's end, along the axes of the drawing, and moves with the body.
    """

    blade: int
    offset: Floats

    def times(self, factor: float) -> "MissedSeat":
        """Return a seat that is off by a multiple."""
        return self._replace(offset=factor * self.offset)


class Drive(NamedTuple):
    """The one motion that a stroke asks of a body: along, or about, a unit ``direction``.

    ``point`` is the point of the body that travels, or one on the axis it turns about [m].
    """

    body: str
    turns: bool
    direction: Vector
    point: Vector

    @property
    def motion(self) -> Floats:
        """Return it as a motion (6,) of its point along the axes of the drawing."""
        found = np.zeros(6)
        found[3 * self.turns : 3 * self.turns + 3] = self.direction
        return found


@dataclass(frozen=True, eq=False)
class SpaceLayout:
    """Bodies that may move, what joins them to each other and to the ground, and the drive.

    ``body_growth`` and ``blade_growth`` are the free strains that a temperature gives bodies and
    blades by name [-]: a body grows about its point, the ground about the origin, a blade along
    itself. ``blade_curl`` is by how much that strain rises from place to place in the section of a
    blade [1/m]: states leave it out, :meth:`SpaceAssembly.curl` tells what it would do.
    """

    bodies: tuple[SpaceBody, ...]
    blades: tuple[SpaceBlade | SpaceRod, ...]
    drive: Drive
    springs: tuple[SpaceSpring, ...] = ()
    body_growth: Mapping[str, float] = field(default_factory=dict)
    blade_growth: Mapping[str, float] = field(default_factory=dict)
    blade_curl: Mapping[str, Vector] = field(default_factory=dict)

    @property
    def grows(self) -> bool:
        """Return whether a temperature strains anything."""
        return any((*self.body_growth.values(), *self.blade_growth.values()))

    def grown(self, share: float) -> "SpaceLayout":
        """Return a layout that has grown by so many times as much."""
        if share == 1.0 or not (self.body_growth or self.blade_growth):
            return self
        each = (self.body_growth, self.blade_growth)
        of_bodies, of_blades = ({name: share * g for name, g in part.items()} for part in each)
        return replace(self, body_growth=of_bodies, blade_growth=of_blades)

    def index(self, name: str) -> int:
        """Return where a body stands among those that may move; it must be one of them."""
        return [body.name for body in self.bodies].index(name)

    def body(self, name: str) -> SpaceBody:
        """Return a body that may move."""
        return self.bodies[self.index(name)]


def without(layout: SpaceLayout, *effects: str) -> SpaceLayout:
    """Return a mechanism whose blades do not feel some effects, by their names in BeamEffects."""
    off = _EVERYTHING._replace(**dict.fromkeys(effects, False))
    blades = (
        replace(blade, feels=blade.feels.and_(off)) if isinstance(blade, SpaceBlade) else blade
        for blade in layout.blades
    )
    return replace(layout, blades=tuple(blades))


def seats_grown(layout: SpaceLayout, blade: SpaceBlade | SpaceRod) -> Floats:
    """Return how far growth moves the seats of a blade's start and end on their bodies (6,) [m]."""
    points = {body.name: body.point for body in layout.bodies}
    seats = [
        layout.body_growth.get(name, 0.0) * np.subtract(at, points.get(name, (0.0, 0.0, 0.0)))
        for name, at in ((blade.first, blade.start), (blade.second, blade.end))
    ]
    return np.concatenate(seats)


def grown_ends(layout: SpaceLayout, blade: SpaceBlade | SpaceRod) -> tuple[Floats, Floats]:
    """Return how far growth moves both ends of a blade against itself [m].

    The end's is less by what the blade itself grows, so that their difference is the misfit.
    """
    seats = seats_grown(layout, blade)
    own = layout.blade_growth.get(blade.name, 0.0) * np.subtract(blade.end, blade.start)
    return seats[:3], seats[3:] - own


def _rows(x: Floats, z: Floats) -> Floats:
    """Return the axes of a unit vector and of one across it, of any length."""
    z = z / np.linalg.norm(z)
    axes = np.stack([x, np.cross(z, x), z])
    axes.setflags(write=False)
    return axes


def along(start: Vector, end: Vector) -> Floats:
    """Return the unit vector from one point to another [-]."""
    r = np.subtract(end, start)
    return np.asarray(r / np.linalg.norm(r))


def vector(values: Floats) -> Vector:
    """Return coordinates or components (3,) as layouts take them."""
    x, y, z = map(float, values)
    return x, y, z
