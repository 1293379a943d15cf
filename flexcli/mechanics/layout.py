"""A planar mechanism at rest: rigid bodies, the blades between them, springs and loads.

One description for every solver: linear or exact, in the plane or (by width and height of each
blade) in space. Numbers are floats, or arrays of shape (designs,) for a batch of designs that
differ in nothing but numbers; positions are global, in the pose in which nothing is strained.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from flexcli.formulas.profile import Profile

__all__ = ["Blade", "Body", "Layout", "Load", "Number", "Point", "Support"]

Number: TypeAlias = Any
"""A float, or an array of shape (designs,)."""

Point: TypeAlias = tuple[Number, Number]
"""Coordinates (x, y) [m]."""


class Body(NamedTuple):
    """A rigid body: its reference point [m], mass [kg], inertia about the centre of mass [kg·m²].

    ``com`` is the centre of mass [m]. The body's motion is (x, y, φ) of the reference point.
    """

    name: str
    point: Point
    mass: Number = 0.0
    inertia: Number = 0.0
    com: Point = (0.0, 0.0)


@dataclass(frozen=True, eq=False)
class Blade:
    """A straight blade from a body to another; a body of no listed name is the ground.

    ``profile`` is the thickness from ``start`` to ``end`` [m], ``b`` the width [m], ``z`` the
    height of its middle plane over that of the mechanism [m]. ``peak`` are the factors by which
    its shape raises the stress of a section over that of a beam: in bending, along the blade.
    ``crossed`` is the range of its stiffness over a beam's of a blade that is one piece with
    another where they cross, ``shared`` the length from its start and its end that both share [m].
    ``stiffer`` are its moduli over those of its layout.
    """

    name: str
    first: str
    second: str
    start: Point
    end: Point
    profile: Profile
    b: Number
    z: Number = 0.0
    peak: tuple[Number, Number] = (1.0, 1.0)
    crossed: tuple[Number, Number] = (1.0, 1.0)
    shared: tuple[Number, Number] = (0.0, 0.0)
    stiffer: Number = 1.0

    @property
    def length(self) -> Number:
        """Return its length, or that of each of many designs of it [m]."""
        return np.hypot(*np.subtract(self.end, self.start))

    @property
    def least_thickness(self) -> Number:
        """Return its least thickness, or that of each of many designs of it [m]."""
        return self.profile.least_thickness(self.length)


class Support(NamedTuple):
    """Springs from a body to the ground at a point: along x, along y [N/m], in φ [N·m/rad]."""

    body: str
    point: Point
    stiffness: tuple[Number, Number, Number]


class Load(NamedTuple):
    """A force [N] at a point of a body [m] and a moment [N·m]; a following force turns with it."""

    body: str
    point: Point
    force: Point = (0.0, 0.0)
    moment: Number = 0.0
    follows: bool = False

    def times(self, share: Number) -> "Load":
        """Return it so many times as large."""
        x, y = self.force
        return self._replace(force=(share * x, share * y), moment=share * self.moment)


@dataclass(frozen=True, eq=False)
class Layout:
    """Bodies that may move, blades of one material, supports and dead or following loads.

    ``E`` and ``G`` [Pa] are the blades', each of which may be so many times as stiff (no G where
    the material gives none: then nothing that shear takes part in can be asked); ``acceleration``
    [m/s²] acts on every mass (gravity). ``guides`` are bodies on ideal joints to the ground: which
    of (x, y, φ) of their reference points cannot move in the plane. ``body_growth`` and
    ``blade_growth`` are the free strains that a temperature gives bodies and blades by name [-]: a
    body grows about its reference point, the ground about the origin, a blade along itself.
    ``prepared`` is what a solver keeps of a layout for its next use; nothing of a layout may be
    written to.
    """

    bodies: tuple[Body, ...]
    blades: tuple[Blade, ...]
    E: Number
    G: Number | None = None
    supports: tuple[Support, ...] = ()
    loads: tuple[Load, ...] = ()
    acceleration: Point = (0.0, 0.0)
    guides: Mapping[str, tuple[bool, bool, bool]] = field(default_factory=dict)
    body_growth: Mapping[str, Number] = field(default_factory=dict)
    blade_growth: Mapping[str, Number] = field(default_factory=dict)
    prepared: dict[Any, Any] = field(default_factory=dict, init=False, repr=False)

    def grown(self, share: Number) -> "Layout":
        """Return a layout that has grown by so many times as much."""
        if share == 1.0 or not (self.body_growth or self.blade_growth):
            return self
        each = (self.body_growth, self.blade_growth)
        of_bodies, of_blades = ({name: share * g for name, g in part.items()} for part in each)
        return replace(self, body_growth=of_bodies, blade_growth=of_blades)

    def index(self, name: str) -> int:
        """Return where a body stands among those that may move; it must be one of them."""
        return [body.name for body in self.bodies].index(name)

    def body(self, name: str) -> Body:
        """Return a body that may move."""
        return self.bodies[self.index(name)]
