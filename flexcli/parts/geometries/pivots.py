"""Pivots of equal blades that point at one centre: layout, closed forms, validity."""

from abc import abstractmethod
from collections.abc import Sequence
from itertools import combinations
from math import pi
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

import numpy as np

from flexcli.formulas import pivot, pivot_next_order, thick_blades
from flexcli.formulas.card import Card
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.formulas.thick_blades import s_bending_share
from flexcli.numerics.rows import cos, design_by_design, larger, number, sin
from flexcli.numerics.signomial import Signomial, as_signomial
from flexcli.parts.base import QuantityOf
from flexcli.parts.bending import Bending, WideBlades, whole
from flexcli.parts.bending.pair import Pair
from flexcli.parts.bending.wide import wide_pivot
from flexcli.parts.elastic import ANY, Elastic, NotAvailable
from flexcli.parts.geometries.base import GROUND, MOVING, Blade, Critical
from flexcli.parts.geometries.blades import BladeGeometry
from flexcli.parts.geometries.joint_buckling import pivot_critical
from flexcli.results import Value

if TYPE_CHECKING:
    from flexcli.mechanics.layout import Layout, Point

__all__ = [
    "BladePair",
    "BladePivot",
    "CentredBlades",
    "PairFormulas",
    "PivotFormulas",
    "SideBySide",
    "largest_share",
    "on_ray",
]


class CentredBlades(BladeGeometry):
    """Equal blades whose centre lines meet in the centre of a pivot, separate or joined."""

    motion: ClassVar[str] = "rotation"

    @property
    @abstractmethod
    def blade_angles(self) -> tuple[float, ...]:
        """Return the direction of each blade from the axis of symmetry [rad]."""

    @abstractmethod
    def offset(self, sizes: Blade) -> Computed:
        """Return p, from the centre to the inner ends of the blades [m]."""

    @property
    def blade_count(self) -> int:
        """Return the number of blades."""
        return len(self.blade_angles)

    def indicators(self, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the quantities of its validity: shape, rotation, place of the crossing."""
        delta = self.offset(sizes) / sizes.l
        return {**self.ratios(sizes), "theta": travel, "delta": delta}


class BladePivot(CentredBlades):
    """The drawing of a pivot whose blades all go from the base to the moving body."""

    def heights(self, sizes: Blade) -> tuple[float, ...]:
        """Return the height of each blade's middle plane over that of the pivot [m]."""
        return (0.0,) * self.blade_count

    def layout(self, elastic: Elastic, sizes: Blade) -> "Layout":
        """Return the blades from their inner ends on the ground to the moving body."""
        from flexcli.mechanics.layout import Body, Layout

        p = self.offset(sizes)
        blades = [
            self.strip(
                f"blade {index}", (GROUND, MOVING), on_ray(angle, (p, p + sizes.l)), sizes, z
            )
            for index, (angle, z) in enumerate(
                zip(self.blade_angles, self.heights(sizes), strict=True), 1
            )
        ]
        return Layout((Body(MOVING, (0.0, 0.0)),), tuple(blades), elastic.E, elastic.shear)

    def clearances(self, sizes: Blade) -> tuple[tuple[str, Computed], ...]:
        """Return the room between the inner ends of blades in one plane, and where they cross."""
        nearest = _nearest(self.offset(sizes), sizes.l)
        if nearest is None:
            return ()
        found, heights = [], self.heights(sizes._replace(b=1.0))
        for i, j in combinations(range(self.blade_count), 2):
            if heights[i] != heights[j]:
                continue
            apart = abs(sin((self.blade_angles[i] - self.blade_angles[j]) / 2.0))
            found.append((f"blades {i + 1} and {j + 1}", nearest * (2.0 * apart) - sizes.h))
        return tuple(found)


class SideBySide(BladePivot):
    """The drawing of a pivot whose blades pass beside each other along its axis."""

    tilt: Literal["free", "held"] = "free"
    """Whether nothing but its blades, which pass side by side and pull at different heights, keeps
    the body from tilting, or something holds it upright, such as a second pivot on its axis,
    e.g. ``held``.
    """

    def heights(self, sizes: Blade) -> tuple[float, ...]:
        """Return heights of blades that touch each other's planes, in the order they are given."""
        middle = (self.blade_count - 1) / 2.0
        return tuple((index - middle) * sizes.b for index in range(self.blade_count))


def _nearest(p: Computed, l: Computed) -> Computed | None:
    """Return the least distance of the blades' ends from the centre, None if sizing decides it."""
    if isinstance(l, Signomial):
        return p if as_signomial(p).is_posynomial else None
    inner, outer = np.asarray(p), np.asarray(p + l)
    beside = np.minimum(np.abs(inner), np.abs(outer))
    return np.where((inner < 0.0) & (outer > 0.0), 0.0, beside)[()]


class _PathLater:
    """The path of a pivot's centre by its blades as plates, found when its shift is asked for."""

    def __init__(self, geometry: "PivotFormulas", sizes: Blade, nu: float) -> None:
        self.geometry, self.sizes, self.nu = geometry, sizes, nu

    def change(self, ends: Sequence[float]) -> tuple[float, float] | None:
        """Return the relative change of the largest shift at travels, and its error [-]."""
        asked = self.geometry, self.sizes, self.nu, tuple(ends)
        return design_by_design(_path_change, *asked, name="path", about=self)


def _path_change(
    geometry: "PivotFormulas", sizes: Blade, nu: float, ends: Sequence[float]
) -> tuple[float, float] | None:
    from flexcli.parts.bending.drawn_shift import drawn_path

    each = [geometry.blade(sizes)] * geometry.blade_count
    path = drawn_path(each, nu, geometry.layout(Elastic(1.0, nu), sizes), geometry.held(1.0))
    return None if path is None else path.change(ends)


class PivotFormulas(CentredBlades):
    """Closed forms of blades that each go from the base to the moving body, at one distance p."""

    cards: ClassVar[tuple[Card, ...]] = pivot.CARDS

    def stiffness(self, elastic: Elastic, sizes: Blade) -> Computed:
        """Return the rotational stiffness [N·m/rad]."""
        h, l, b = self.blade(sizes)
        return pivot.rotational_stiffness(
            E=elastic.E, h=h, l=l, b=b, p=self.offset(sizes), blades=self.blade_count
        )

    def end_stresses(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the signed bending stress at the inner and the outer end [Pa]."""
        inner, outer = pivot.end_stresses(
            E=elastic.E, h=sizes.h, l=sizes.l, p=self.offset(sizes), theta=travel
        )
        return {"inner end": inner, "outer end": outer}

    def s_bending_share(self, sizes: Blade) -> float:
        """Return 3(1 + 2δ)²/(1 + 3(1 + 2δ)²): the rest is uniform bending, free of shear."""
        return number(s_bending_share(self.offset(sizes) / sizes.l))

    def axial_share(self, direction: float) -> float:
        """Return the largest axial force in a blade per force on the pivot in its plane [-]."""
        return largest_share(self.blade_angles, direction)

    def joint_critical(
        self, elastic: Elastic, sizes: Blade, ends: str, direction: float
    ) -> Critical:
        """Return the force at the centre at which the pivot turns away or a blade bows [N]."""
        p = number(self.offset(sizes))
        return pivot_critical(elastic, sizes, p, self.blade_angles, ends, direction)

    def wide_blades(self, sizes: Blade, nu: float) -> WideBlades | None:
        """Return the factors of its blades; that of the shift is of their path."""
        delta = number(self.offset(sizes)) / number(sizes.l)
        found = wide_pivot(
            sizes, nu, delta=delta, sags_wide=self.sag_bends_width, softer=self._softer(sizes, nu)
        )
        return found._replace(path=_PathLater(self, sizes, nu))

    def _softer(self, sizes: Blade, nu: float) -> tuple[Computed, Computed]:
        """Return the shares of the stiffness that the blades' stretching and shear take."""
        bending = self.bending(ANY, sizes, 0.0)
        found = (bending.extension(), bending.shear(nu))
        stretched, sheared = (changes.get("stiffness", whole(0.0)).value for changes in found)
        return 0.0 if stretched is None else -stretched, 0.0 if sheared is None else -sheared

    def values(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Value]:
        """Return δ."""
        return {
            "delta": Value(
                number(self.offset(sizes) / sizes.l),
                "",
                "place of the centre, p/l",
                estimated_error=0.0,
            )
        }


class BladePair(CentredBlades):
    """Pairs of blades at ± a half-angle from their bisector, separate or joined."""

    half_angle: Annotated[float, QuantityOf("angle", above=0.0, below=pi / 2)]
    """Angle between each blade and the bisector, e.g. ``45 deg``."""

    @property
    def blade_angles(self) -> tuple[float, ...]:
        """Return the two directions from the bisector [rad]."""
        return (self.half_angle, -self.half_angle)


class PairFormulas(PivotFormulas, BladePair):
    """Closed forms of such blades in pairs about a bisector."""

    def parasitic_shift(self, sizes: Blade, travel: float) -> Computed:
        """Return the signed shift of the centre along the bisector [m], leading order."""
        return pivot.parasitic_shift(
            l=sizes.l, p=self.offset(sizes), theta=travel, half_angle=self.half_angle
        )

    def bending(self, elastic: Elastic, sizes: Blade, travel: float) -> Bending:
        """Return the bending of two blades from one plane to another."""
        h, l, _ = map(number, self.blade(sizes))
        p = number(self.offset(sizes))
        return Pair(h=h, l=l, p=p, theta=travel, half_angle=self.half_angle)

    def wide_blades(self, sizes: Blade, nu: float) -> WideBlades | None:
        """Return the plate factors of its blades, with that of the shift along the bisector."""
        delta = number(self.offset(sizes)) / number(sizes.l)
        softer = self._softer(sizes, nu)
        return wide_pivot(sizes, nu, delta=delta, half_angle=self.half_angle, softer=softer)

    def shift_change(self, sizes: Blade, pure: float, bent: float) -> float | None:
        """Return that of 5 − 9γ², of which −5/2 and −9γ² are the shortenings of both shapes."""
        square = (1.0 + 2.0 * number(self.offset(sizes)) / number(sizes.l)) ** 2
        left = 5.0 - 9.0 * square
        return -(2.5 * pure + 9.0 * square * bent) / left if left else None

    def values(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Value]:
        """Return δ and the shift across the bisector, which the shift along it leaves out."""
        found, (h, l, _), p = (
            super().values(elastic, sizes, travel),
            self.blade(sizes),
            self.offset(sizes),
        )
        across = pivot_next_order.shift_across(l=l, p=p, theta=travel, half_angle=self.half_angle)
        if elastic.nu is not None:
            across = across + thick_blades.pivot_shift_across(
                h=h, l=l, p=p, theta=travel, half_angle=self.half_angle, poisson_ratio=elastic.nu
            )
        text = "parasitic shift across the bisector, by θ³ and by stretching"
        return {**found, "shift_across": Value(abs(number(across)), "m", text)}


def on_ray(angle: float, reach: tuple[Quantity, Quantity]) -> "tuple[Point, Point]":
    """Return two places on a ray from the centre, at two distances from it [m]."""
    start, end = ((r * cos(angle), r * sin(angle)) for r in reach)
    return start, end


def largest_share(angles: tuple[float, ...], direction: float) -> float:
    """Return the largest axial force in a blade per force on the centre in the plane [-]."""
    try:
        return larger(abs(share) for share in pivot.axial_share(angles, direction))
    except ValueError as error:
        raise NotAvailable("has blades too parallel to share a force") from error
