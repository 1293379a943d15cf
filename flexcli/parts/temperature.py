"""A change of temperature from assembly, of blades and bodies, and how far each would grow."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace
from math import copysign, cos, hypot, inf, sin
from typing import Annotated, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, model_validator

from flexcli.formulas.profile import Constant, Filleted, Notch
from flexcli.formulas.sheet_factors import held_growth
from flexcli.mechanics.layout import Blade, Layout
from flexcli.mechanics.mesh import column, single
from flexcli.mechanics.space.layout import SpaceBlade, SpaceLayout, SpaceRod, SpaceStar
from flexcli.parts.base import Part, QuantityOf, spec_error
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import GROUND
from flexcli.parts.material import Material
from flexcli.parts.over_temperature import Kelvin

__all__ = [
    "Temperature",
    "alike",
    "held_bending",
    "held_lengths",
    "held_share",
    "sheared_across",
]

Floats = NDArray[np.float64]

Change = Annotated[float, QuantityOf("temperature change")]
Slope = Annotated[float, QuantityOf("temperature gradient")]
Coefficient = Annotated[float, QuantityOf("expansion")]

ALONG_PIECE = np.array([[-1.0, 0.0, 1.0]])
"""Places along each piece of a blade where its thickness is sampled: its ends and its middle."""

HELD_ERROR = 0.04
"""Relative error of the lengthening of a blade by clamps that hold it across, see ``held_growth``;
that of the sheet in a crystal is DIRECTED_ERROR."""

DIRECTED_ERROR = 0.1
"""Of a blade of a crystal or a sheet, the error of what holding its width makes."""

DEEP = 0.4
"""Largest throat of a notch over the height of its mouths; fillets on thicker blades are roots."""

ROUND = 0.5, 2.5
"""Least and largest length over depth of the half-ellipses of notches, of which solids were made.
"""

NOTCH_ERROR = 0.2
"""Error of how much longer clamps make a notch, over the larger of both ends of ``_of_notch``.

Solids of high order differ by 0.19 from them: throats of 0.03 and 0.35 of the mouths' height H,
widths of 0.1 to 4 H, ν of 0 to 0.45, half-ellipses apart by up to 4 times their depth."""

ROOT_ERROR = 0.12
"""The same of blades with fillets at their roots, which are as high as the clamps there: solids
were at most 0.11 longer, widths of 1.3 to 8 H."""

VARYING_ERROR = 1.0, 2.0
"""Of other thicknesses that vary, of which it is left out: of 0.15 + ν times the largest thickness,
and of what holding the width of a sheet makes, of which solids of notches had at most 0.5 and 1.64.
"""

DIGITS = 9
"""Of sizes that count as the same."""

MIDDLE_NU = 0.25
"""Poisson's ratio amid those from 0 to ½."""

AnyLayout = TypeVar("AnyLayout", bound=Layout | SpaceLayout)


class Changes(NamedTuple):
    """Change of temperature of each blade and of each body, the ground among them [K]."""

    blades: dict[str, float]
    bodies: dict[str, float]


class Growths(NamedTuple):
    """Strain by which each blade and each body would grow by itself, the ground among them [-]."""

    blades: dict[str, float]
    bodies: dict[str, float]


def held_share(blade: Blade | SpaceBlade | SpaceRod, nu: float) -> float:
    """Return the relative lengthening of a blade per strain across it that its clamps hold [-].

    Of a notch it is amid what rigid blocks beside it make and what such as high as it is.
    """
    if isinstance(blade, SpaceRod) and not isinstance(blade, SpaceStar):
        return 0.0
    l, b, h = _length(blade), blade.b, 0.0
    if not isinstance(blade, SpaceStar):
        notch = _of_notch(blade, nu)
        if notch is not None:
            return sum(notch) / 2.0
        if not _has_one_height(blade):
            return 0.0
        h = blade.profile.mouth(l)
    return float(held_growth(b=b, h=h, l=l, poisson_ratio=nu))


def _of_notch(blade: Blade | SpaceBlade, nu: float) -> tuple[float, float] | None:
    """Return how much longer a notch is whose mouths are held across, over its length [-].

    That is between rigid blocks, ``H (0.04 + 0.40 ν s/(s + 0.73)) + 1.41 ν ρ l``, and between such
    as high as its mouths, ``0.116 H + 0.89 ν ρ l/(1 + 4.6 H²/b²)``: H is their height, s the length
    over depth of its half-ellipses, ρ that of a sheet. None of others than solids were made of.
    """
    profile, l, s = blade.profile, _length(blade), 1.0
    if isinstance(profile, Notch):
        e, s = single(profile.e), l / (2.0 * single(profile.depth))
    elif isinstance(profile, Filleted):
        e = single(profile.h)
    else:
        return None
    H, b, (least, most) = profile.mouth(l), single(blade.b), ROUND
    if e > DEEP * H or not least <= s <= most:
        return None
    wide = float(held_growth(b=b, l=l, poisson_ratio=nu))
    rigid = H / l * (0.04 + 0.40 * nu * s / (s + 0.73)) + 1.41 * wide
    return rigid, 0.116 * H / l + 0.89 * wide / (1.0 + 4.6 * (H / b) ** 2)


def _has_one_height(blade: Blade | SpaceBlade) -> bool:
    """Return whether a blade is as thick all along, or but for fillets at its roots."""
    return isinstance(blade.profile, Constant | Filleted)


def alike(blades: Iterable[Blade | SpaceBlade | SpaceRod]) -> list[list[str]]:
    """Return the names of blades of the same sizes, together."""
    found = dict[tuple[str, ...], list[str]]()
    for blade in blades:
        l = _length(blade)
        if isinstance(blade, SpaceRod):
            sizes = [blade.d]
        else:
            thick = (np.ravel(each.thickness(ALONG_PIECE)) for each in blade.profile.pieces(l))
            sizes = [single(blade.b), *np.concatenate(list(thick)).tolist()]
        kind = blade if isinstance(blade, SpaceRod) else blade.profile
        key = (type(kind).__name__, *(f"{size:.{DIGITS}g}" for size in (l, *sizes)))
        found.setdefault(key, []).append(blade.name)
    return list(found.values())


def held_lengths(layout: Layout | SpaceLayout, material: Material) -> dict[str, float]:
    """Return by how much the growth of each blade is unsure by clamps that hold it across [-].

    It has the sign of what the blade grows more than its clamps. All of what any Poisson's ratio
    makes counts where it is not given; so does what holding the thickness makes of a crystal or a
    sheet, which have another one there.
    """
    found = dict[str, float]()
    for blade in layout.blades:
        own, first, second = (
            single(strain)
            for strain in (
                layout.blade_growth[blade.name],
                layout.body_growth[blade.first],
                layout.body_growth[blade.second],
            )
        )
        unsure = _unsure_share(blade, material)
        if material.elastic.nu is None:
            least, middle, most = (held_share(blade, nu) for nu in (0.0, MIDDLE_NU, 0.5))
            unsure += max(middle - least, most - middle)
        found[blade.name] = (own - (first + second) / 2.0) * unsure
    return found


def usual_nu(elastic: Elastic) -> float:
    """Return Poisson's ratio; where the material gives none, amid all that it may be."""
    return MIDDLE_NU if elastic.nu is None else elastic.nu


def _unsure_share(blade: Blade | SpaceBlade | SpaceRod, material: Material) -> float:
    """Return the error of ``held_share`` of a blade of a known Poisson's ratio [-]."""
    l, nu = _length(blade), material.elastic.most_nu
    if isinstance(blade, SpaceRod):
        return HELD_ERROR * held_share(blade, nu)
    is_even, notch = isinstance(blade.profile, Constant), _of_notch(blade, nu)
    if notch is not None and not material.is_directed:
        rigid, soft = notch
        return abs(rigid - soft) / 2.0 + NOTCH_ERROR * max(rigid, soft)
    if _has_one_height(blade) and not material.is_directed:
        return (HELD_ERROR if is_even else ROOT_ERROR) * held_share(blade, nu)
    of_thick, of_wide = VARYING_ERROR
    of_wide, thick = (DIRECTED_ERROR, nu) if is_even else (of_wide, 0.15 + nu)
    wide = float(held_growth(b=single(blade.b), l=l, poisson_ratio=nu))
    return of_thick * thick * _thickest(blade, l) / l + of_wide * wide


def held_bending(layout: Layout, nu: float) -> float:
    """Return the relative change of the bending stiffness by clamps that hold blades across.

    Tension across pulls a blade flat, compression lets it curl, between a beam and a plate: the
    more, the larger strain · (b/h)² is. CalculiX had 0.7 % where this has 3 %.
    """
    doubt = 0.0
    for blade in layout.blades:
        l = _length(blade)
        own = float(column(layout.blade_growth[blade.name])[0])
        held = max(
            abs(own - float(column(layout.body_growth[body])[0]))
            for body in (blade.first, blade.second)
        )
        slender = float(column(blade.b)[0]) / _thickest(blade, l)
        doubt = max(doubt, min(1.0, HELD_ERROR * held * slender**2))
    return doubt * nu**2 / (1.0 - nu**2)


def sheared_across(layout: Layout) -> float:
    """Return the largest strain by which bodies that grow along the axis bend blades aside [-].

    Of an upright body whose blades stand at several heights z: ``3 b w/l²``, as both ends of a
    blade are kept from turning and w apart. Where its thickness varies nobody knows: infinite.
    """
    heights = [float(column(blade.z)[0]) for blade in layout.blades]
    middle, found = (max(heights) + min(heights)) / 2.0, 0.0
    for blade, height in zip(layout.blades, heights, strict=True):
        first, second = (
            float(column(layout.body_growth[body])[0]) for body in (blade.first, blade.second)
        )
        w = abs((height - middle) * (first - second))
        l = _length(blade)
        strain = 3.0 * float(column(blade.b)[0]) * w / l**2
        found = max(found, strain if isinstance(blade.profile, Constant) or not w else inf)
    return found


def _length(blade: Blade | SpaceBlade | SpaceRod) -> float:
    return hypot(*(float(e - s) for s, e in zip(blade.start, blade.end, strict=True)))


def _thickest(blade: Blade | SpaceBlade, l: float) -> float:
    pieces = blade.profile.pieces(l)
    return max(float(np.max(piece.thickness(ALONG_PIECE))) for piece in pieces)


class Gradient(Part):
    """Rise of temperature from the origin of the joint's drawing."""

    x: Slope = 0.0
    """Rise along x: the stroke of a stage, the bisector of a pivot, e.g. ``40 K/m``."""
    y: Slope = 0.0
    """Rise in the plane across x, e.g. ``-10 K/m``."""
    z: Slope = 0.0
    """Rise along z, of a mechanism that is drawn in space, e.g. ``5 K/m``."""


class Temperature(Part):
    """Changes of temperature from assembly, which add up: bodies and blades grow, and may not fit.

    Stiffness and strength follow what the material states over temperature.
    """

    uniform: Change = 0.0
    """Change of everything, e.g. ``-60 K``."""
    bodies: Mapping[str, Change] = Field(default_factory=dict)
    """Change of single bodies besides, by their names; ``ground`` is the base,
    e.g. ``{moving: 12 K}``.
    """
    gradient: Gradient = Gradient()
    """Rise from place to place, taken at the middle of each blade and at each body's point,
    e.g. ``gradient: {x: 40 K/m}, uniform: -60 K``.
    """
    expansion: Mapping[str, Coefficient] = Field(default_factory=dict)
    """Thermal expansion of bodies that are of another material than the blades, the mean of this
    change,
    e.g. ``{moving: 23.6e-6 1/K}``.
    """
    assembly: Kelvin = 293.0
    """Temperature of assembly, at which the material's values hold, e.g. ``295 K``."""

    @model_validator(mode="after")
    def _changes_something(self) -> "Temperature":
        slopes = (self.gradient.x, self.gradient.y, self.gradient.z)
        if not any((self.uniform, *self.bodies.values(), *slopes)):
            raise spec_error("this temperature changes nothing", "give it e.g. uniform: -60 K")
        if self.assembly + self.uniform < 0.0:
            raise spec_error(
                "this is below absolute zero", "check the change and assembly:", at=("uniform",)
            )
        return self

    @property
    def rises(self) -> bool:
        """Return whether it rises from place to place in the plane."""
        return bool(self.gradient.x or self.gradient.y)

    @property
    def names(self) -> frozenset[str]:
        """Return the bodies that it names."""
        return frozenset((*self.bodies, *self.expansion))

    def changes(self, layout: Layout | SpaceLayout, axes: float) -> Changes:
        """Return the rise of temperature of each blade and body.

        Parameters
        ----------
        layout : Layout or SpaceLayout
            The joint at assembly.
        axes : float
            Angle of the x of cases from that of the layout [rad].

        """
        slopes = self._slopes(axes)

        def at(point: Iterable[float]) -> float:
            rises = (slope * place for slope, place in zip(slopes, point, strict=False))
            return self.uniform + sum(rises)

        points = {GROUND: (0.0, 0.0)} | {body.name: body.point for body in layout.bodies}
        return Changes(
            {
                blade.name: at((s + e) / 2.0 for s, e in zip(blade.start, blade.end, strict=True))
                for blade in layout.blades
            },
            {name: at(point) + self.bodies.get(name, 0.0) for name, point in points.items()},
        )

    def growths(
        self,
        layout: Layout | SpaceLayout,
        material: Material,
        axes: float,
        of_bodies: Mapping[str, Material] | None = None,
    ) -> Growths:
        """Return by what strain each blade and body would grow by itself."""
        changes, others = self.changes(layout, axes), of_bodies or {}
        return Growths(
            {name: material.growth(T, self.assembly) for name, T in changes.blades.items()},
            {
                name: self.expansion[name] * change
                if name in self.expansion
                else others.get(name, material).growth(change, self.assembly)
                for name, change in changes.bodies.items()
            },
        )

    def held_across(
        self,
        layout: Layout | SpaceLayout,
        material: Material,
        axes: float,
        of_bodies: Mapping[str, Material] | None = None,
    ) -> float:
        """Return the largest strain by which a clamp keeps a blade from growing [-].

        What that makes the blade longer is no strain that its clamp holds.
        """
        free = self.growths(layout, material, axes, of_bodies)
        return max(
            abs(free.blades[blade.name] - free.bodies[body])
            for blade in layout.blades
            for body in (blade.first, blade.second)
        )

    def warmed(
        self,
        layout: AnyLayout,
        material: Material,
        axes: float,
        of_bodies: Mapping[str, Material] | None = None,
    ) -> AnyLayout:
        """Return a layout whose blades and bodies have grown.

        A body grows about its reference point, the ground about the origin of the layout. Clamps
        that keep a blade from growing across make it longer. ``of_bodies`` are the materials of
        bodies other than that of the blades.
        """
        changes, free = self.changes(layout, axes), self.growths(layout, material, axes, of_bodies)
        bodies, blades = free.bodies, {}
        for blade in layout.blades:
            own = free.blades[blade.name]
            held = own - (bodies[blade.first] + bodies[blade.second]) / 2.0
            blades[blade.name] = own + held * held_share(blade, usual_nu(material.elastic))
        if not isinstance(layout, SpaceLayout):
            return replace(layout, body_growth=bodies, blade_growth=blades)
        slopes, curl = np.array(self._slopes(axes)), {}
        for blade in layout.blades if slopes.any() else ():
            change, more = changes.blades[blade.name], _rise_in_section(blade, slopes)
            rate = self._growth_towards_assembly(material, change, more) / more if more else 0.0
            x, y, z = (rate * slopes).tolist()
            curl[blade.name] = (x, y, z)
        return replace(layout, body_growth=bodies, blade_growth=blades, blade_curl=curl)

    def stiffer(self, layout: AnyLayout, material: Material, axes: float) -> dict[str, float]:
        """Return Young's modulus of each blade over that of ``material`` [-].

        That is :meth:`of_blades`, between the coldest and the hottest of them.
        """
        changes = self.changes(layout, axes).blades
        return {name: material.stiffer(T, self.assembly) for name, T in changes.items()}

    def unlike(self, layout: AnyLayout, material: Material, axes: float) -> dict[str, float]:
        """Return by how much the modulus of each blade may differ from the others' besides [-].

        That is where nobody gave it over temperature.
        """
        changes = self.changes(layout, axes).blades
        middle = (min(changes.values()) + max(changes.values())) / 2.0
        return {name: material.drift(middle, T, self.assembly) for name, T in changes.items()}

    def across_thickness(self, layout: Layout, material: Material, axes: float) -> float:
        """Return the largest strain by which a blade's face would grow more than its middle [-].

        The gradient through its thickness would bend it so where it is free, and stresses it by
        that where it is held: :meth:`warmed` leaves it out.
        """
        rise_x, rise_y, _ = self._slopes(axes)
        changes, found = self.changes(layout, axes).blades, 0.0
        for blade in layout.blades:
            x, y = (float(e - s) for s, e in zip(blade.start, blade.end, strict=True))
            l = _length(blade)
            more = abs(rise_y * x - rise_x * y) / l * _thickest(blade, l) / 2.0
            found = max(found, self._growth_towards_assembly(material, changes[blade.name], more))
        return found

    def _growth_towards_assembly(self, material: Material, change: float, less: float) -> float:
        """Return the reduced growth of a blade that is less warm, or less cold [-].

        It is towards assembly, where the material is known.
        """
        other = change - copysign(less, change)
        grown = (material.growth(each, self.assembly) for each in (change, other))
        return abs(next(grown) - next(grown))

    def _slopes(self, axes: float) -> tuple[float, float, float]:
        """Return the rise along the axes of the layout [K/m]."""
        c, s = cos(axes), sin(axes)
        return (
            c * self.gradient.x - s * self.gradient.y,
            s * self.gradient.x + c * self.gradient.y,
            self.gradient.z,
        )

    def of_blades(self, material: Material, layout: Layout | SpaceLayout, axes: float) -> Material:
        """Return the material of the blades at their temperatures, and their clamps'."""
        changes = self.changes(layout, axes)
        each, clamps = changes.blades.values(), changes.bodies.values()
        coldest, hottest, clamped = (
            self.assembly + change for change in (min(each), max(each), max(clamps))
        )
        return material.at(self.assembly, coldest, hottest, clamped)

    def temperatures(
        self, layout: Layout | SpaceLayout, axes: float, others: Collection[str] = ()
    ) -> tuple[float, ...]:
        """Return the temperatures at which material data are needed: of assembly, blades, bodies.

        ``others`` are bodies of another material.
        """
        changes, apart = self.changes(layout, axes), {*self.expansion, *others}
        own = [change for name, change in changes.bodies.items() if name not in apart]
        found = (0.0, *changes.blades.values(), *own)
        return tuple(self.assembly + change for change in dict.fromkeys(found))


def _rise_in_section(blade: SpaceBlade | SpaceRod, slopes: Floats) -> float:
    """Return the temperature of a corner of a section over its middle [K]."""
    _, y, z = np.abs(blade.axes @ slopes)
    if isinstance(blade, SpaceRod):
        return float(np.hypot(y, z)) * blade.d / 2.0
    l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
    h = max(float(np.max(piece.thickness(ALONG_PIECE))) for piece in blade.profile.pieces(l))
    return float(y * h + z * blade.b) / 2.0
