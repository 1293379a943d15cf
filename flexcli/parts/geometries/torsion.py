"""Torsion bars on one axis that hold a body, and those of round and crossed section."""

from abc import abstractmethod
from collections.abc import Mapping
from math import hypot, pi, sqrt
from typing import Annotated, Any, ClassVar, Literal, NamedTuple

import numpy as np
from pydantic import Field

from flexcli.formulas import (
    torsion_bar,
    torsion_fibres,
    torsion_shapes,
)
from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed
from flexcli.mechanics.space.layout import (
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
    SpaceRod,
    SpaceStar,
    Vector,
)
from flexcli.parts.bending import Bending, WideBlades
from flexcli.parts.bending.twist import EndErrors, Twist
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.base import (
    GROUND,
    MOVING,
    Blade,
    Extent,
    Geometry,
    TwistingBars,
)
from flexcli.results import Value

__all__ = ["NARROW_SIDE", "RoundTorsionBar", "Section", "TorsionGeometry", "TorsionStar"]

Bars = Annotated[int, Field(strict=True, ge=1, le=1000)]


NARROW_SIDE = 0.743
"""Shear stress in the middle of a thin strip's narrow sides over that of the broad ones: 8/π²
times Catalan's constant, Saint-Venant's series there."""

MOST_LAID = 24
"""Bars in a row that are laid out in space."""


class Section(NamedTuple):
    """What a section is to its long fibres: area [m²], I_p/A [m²], ∫r⁴ dA [m⁶], most r² [m²]."""

    area: Computed
    mean: Computed
    fourth: Computed
    edge: Computed
    sheared: float
    """Shear stress at the farthest fibres over the largest of the section."""


class TorsionGeometry(Geometry):
    """Bars on one axis between the base and the body that turns about it."""

    motion: ClassVar[str] = "rotation"
    source: ClassVar[str] = "Timoshenko & Goodier 1970, Theory of Elasticity, chapter 10"
    strain: ClassVar[str] = "twist"
    has_plane: ClassVar[bool] = False
    posynomial: ClassVar[bool] = False

    bars: Bars = 1
    """Number of bars on the axis, end to end; base and body take turns between them, so that two
    hold the body between them, e.g. ``2``.
    """
    shortening: Literal["free", "held"] | None = None
    """Whether the ends of the bars may come closer as they twist; two bars hold each other, of one
    bar it is open unless stated,
    e.g. ``held``.
    """

    @abstractmethod
    def torsion_constant(self, sizes: Any) -> Computed:
        """Return J of one bar [m⁴]."""

    @abstractmethod
    def shear(self, elastic: Elastic, sizes: Any, twist: float) -> Computed:
        """Return the largest shear stress [Pa] at a twist, the ends free to warp."""

    @abstractmethod
    def section(self, sizes: Any) -> Section:
        """Return what its long fibres need of the section."""

    @property
    def is_restrained(self) -> bool:
        """Return whether the clamps keep the section from warping."""
        return False

    @property
    def may_shorten(self) -> tuple[bool, ...]:
        """Return whether the ends may come closer, both where nothing says so."""
        if self.shortening is not None:
            return (self.shortening == "free",)
        return (False,) if self.bars > 1 else (False, True)

    def bending(self, elastic: Elastic, sizes: Any, travel: float) -> Bending:
        """Return that of twisted bars."""
        return Twist(self, elastic, sizes, travel)

    def core_error(self, sizes: Any) -> float:
        """Return 0: one section has no core where others cross [-]."""
        return 0.0

    def side_error(self, sizes: Any) -> float:
        """Return 0: the stress is that of the section [-]."""
        return 0.0

    def end_errors(self, sizes: Any, nu: float | None) -> EndErrors:
        """Return none: the ends are free to warp."""
        return EndErrors()

    def wide_blades(self, sizes: Any, nu: float) -> WideBlades | None:
        """Return nothing: bars twist."""
        return None

    @abstractmethod
    def polar_moment(self, sizes: Any) -> Computed:
        """Return ∫r² dA of the section of a bar about its axis [m⁴]."""

    def twisting_bars(self, sizes: Any) -> TwistingBars | None:
        """Return all bars."""
        polar = self.bars * self.polar_moment(sizes) * sizes.l
        return TwistingBars(polar, self.is_restrained)

    def farthest(self, sizes: Any) -> float:
        """Return how far the farthest fibre is from the axis [m]."""
        return float(self.section(sizes).edge ** 0.5)

    def rate(self, elastic: Elastic, sizes: Any, twist: float) -> Computed:
        """Return the largest twist per length [rad/m]."""
        return twist / sizes.l

    def edge_shear(self, elastic: Elastic, sizes: Any, twist: float) -> Computed:
        """Return the shear stress at the farthest fibres [Pa]."""
        at_rate = self.rate(elastic, sizes, twist) * sizes.l
        return self.section(sizes).sheared * self.shear(elastic, sizes, at_rate)

    def fibre_stress(self, elastic: Elastic, sizes: Any, twist: float, *, free: bool) -> Computed:
        """Return von Mises' equivalent stress with that of the long fibres, the worst place [Pa].

        Wide bars are worst at their edges, where little shear is left; near the axis the fibres
        of a bar that may shorten are pushed.
        """
        section, rate = self.section(sizes), self.rate(elastic, sizes, twist)
        mean = section.mean if free else 0.0
        at = {"E": elastic.E, "rate": rate, "mean_square": mean}
        shear = self.shear(elastic, sizes, rate * sizes.l)
        edge = torsion_fibres.fibre_stress(square=section.edge, **at)
        middle = torsion_fibres.fibre_stress(square=self.thin(sizes) ** 2 / 4.0, **at)
        return np.maximum(
            np.hypot(edge, sqrt(3.0) * self.edge_shear(elastic, sizes, twist)),
            np.hypot(middle, sqrt(3.0) * shear),
        )

    def fibre_error(self, elastic: Elastic, sizes: Any, twist: float, *, free: bool) -> float:
        """Return none: twist and fibres are even along the bar."""
        return 0.0

    def fibre_stiffening(
        self, elastic: Elastic, sizes: Any, twist: float, *, free: bool
    ) -> Computed:
        """Return the torque of all bars at a twist over the twist [N·m/rad]."""
        section = self.section(sizes)
        torque = torsion_fibres.fibre_moment(
            E=elastic.E, rate=twist / sizes.l, area=section.area, fourth=section.fourth,
            mean_square=section.mean if free else 0.0,
        )  # fmt: skip
        return self.stiffness(elastic, sizes) + self.bars * torque / twist

    @abstractmethod
    def member(
        self, name: str, start: Vector, end: Vector, elastic: Elastic, sizes: Any, density: float
    ) -> SpaceBlade | SpaceRod:
        """Return a bar, from its start on the base to where the body is."""

    def laid_in_space(self, elastic: Elastic, sizes: Any, density: float) -> SpaceLayout:
        """Return the bars in a row along z, the middle of what they hold of the body at the origin.

        Of two that is where they meet.
        """
        if self.bars > MOST_LAID:
            raise NotAvailable(f"has more than {MOST_LAID} bars, too many for a layout")
        if self.bars == 1 and self.shortening == "held":
            raise NotAvailable("has an axial support that the spec does not state")
        l, at = float(sizes.l), (0.0, 0.0, 0.0)
        middle = (self.bars + 1) // 2
        names = ("below", "above") if self.bars <= 2 else [f"bar {k + 1}" for k in range(self.bars)]
        members = []
        for k, name in zip(range(self.bars), names, strict=False):
            # an even end of a bar is on the base, an odd one on the body
            base, body = (k, k + 1) if k % 2 == 0 else (k + 1, k)
            start, end = ((0.0, 0.0, (each - middle) * l) for each in (base, body))
            members.append(self.member(name, start, end, elastic, sizes, density))
        drive = Drive(MOVING, True, (0.0, 0.0, 1.0), at)
        return SpaceLayout((SpaceBody(MOVING, at, at),), tuple(members), drive)

    def values(self, elastic: Elastic, sizes: Any, travel: float) -> dict[str, Value]:
        """Return the moment over the rotation at full stroke, with the long fibres."""
        if not travel:
            return {}
        free = self.may_shorten[0]
        stiff = self.fibre_stiffening(elastic, sizes, travel, free=free)
        ends = "may come closer" if free else "are held apart"
        text = f"moment over rotation at full stroke, ends that {ends}"
        return {"k_stroke": Value(float(stiff), self.stiffness_unit, text)}

    def stiffness(self, elastic: Elastic, sizes: Any) -> Computed:
        """Return the rotational stiffness, the ends free to warp [N·m/rad]."""
        return torsion_bar.torsional_stiffness(
            G=elastic.G, J=self.torsion_constant(sizes), l=sizes.l, bars=self.bars
        )

    def end_stresses(self, elastic: Elastic, sizes: Any, travel: float) -> dict[str, Computed]:
        """Return von Mises' equivalent of the shear stress [Pa]."""
        return {"broad side": sqrt(3.0) * self.shear(elastic, sizes, travel)}

    def thin(self, sizes: Any) -> Computed:
        """Return the thin side of the section [m]."""
        return sizes.h

    def sections(self, sizes: Any) -> tuple[tuple[str, float, float], ...]:
        """Return the thin side, whichever it is called: a bar twists alike about both [m]."""
        thin = float(self.thin(sizes))
        return (("", thin, max(thin, float(getattr(sizes, "b", thin)))),)

    def indicators(self, sizes: Any, travel: float) -> dict[str, Computed]:
        """Return what its closed forms are valid in: shape and twist."""
        far = self.section(sizes).edge ** 0.5
        return {
            **self.ratios(sizes),
            "h θ/l": self.thin(sizes) * travel / sizes.l,
            "r θ/l": far * travel / sizes.l,
        }


class RoundSizes(NamedTuple):
    """Diameter and length [m]."""

    d: Computed
    l: Computed


class RoundTorsionBar(TorsionGeometry):
    """Torsion bar of circular section, which does not warp."""

    dimensions: ClassVar[type[Any]] = RoundSizes
    labels: ClassVar[Mapping[str, str]] = {"d": "diameter", "l": "length of a bar"}
    cards: ClassVar[tuple[Card, ...]] = (
        *torsion_bar.CARDS,
        *torsion_shapes.CIRCLE_CARDS,
        *torsion_fibres.CARDS,
    )
    validity: ClassVar[tuple[Range, ...]] = (torsion_bar.THIN_TWIST,)

    kind: Literal["round-torsion-bar"]
    d: Extent
    """Diameter of the bar, e.g. ``1 mm``."""
    l: Extent
    """Length of a bar, e.g. ``20 mm``."""

    def thin(self, sizes: RoundSizes) -> Computed:
        """Return the diameter [m]."""
        return sizes.d

    def section(self, sizes: RoundSizes) -> Section:
        """Return that of a circle."""
        square = sizes.d**2 / 4.0
        area = pi * square
        return Section(area, square / 2.0, area * square**2 / 3.0, square, 1.0)

    def polar_moment(self, sizes: RoundSizes) -> Computed:
        """Return π d⁴/32 [m⁴]."""
        return pi * sizes.d**4 / 32.0

    def torsion_constant(self, sizes: RoundSizes) -> Computed:
        """Return π d⁴/32 [m⁴]."""
        return torsion_shapes.circle_torsion_constant(sizes.d)

    def shear(self, elastic: Elastic, sizes: RoundSizes, twist: float) -> Computed:
        """Return the shear stress at the surface [Pa]."""
        return torsion_bar.shear_stress(G=elastic.G, h=sizes.d, l=sizes.l, theta=twist, factor=0.5)

    def member(
        self,
        name: str,
        start: Vector,
        end: Vector,
        elastic: Elastic,
        sizes: RoundSizes,
        density: float,
    ) -> SpaceRod:
        """Return a rod."""
        material = Isotropic(float(elastic.E), float(elastic.G), density)
        return SpaceRod(name, GROUND, MOVING, start, end, float(sizes.d), material)

    def volume(self, sizes: RoundSizes) -> Computed:
        """Return the volume of the bars [m³]."""
        return self.bars * pi / 4.0 * sizes.d**2 * sizes.l

    def ratios(self, sizes: RoundSizes) -> dict[str, Computed]:
        """Return l/d."""
        return {"l/d": sizes.l / sizes.d}


class TorsionStar(TorsionGeometry):
    """Cross-arrangement: n thin strips of full width b that cross on the axis (2: cruciform)."""

    dimensions: ClassVar[type[Any]] = Blade
    labels: ClassVar[Mapping[str, str]] = {
        "h": "thickness of a strip",
        "l": "length",
        "b": "full width of a strip",
    }
    cards: ClassVar[tuple[Card, ...]] = (
        *torsion_bar.CARDS,
        *torsion_shapes.STAR_CARDS,
        *torsion_fibres.CARDS,
    )
    validity: ClassVar[tuple[Range, ...]] = (
        torsion_bar.THIN_TWIST,
        torsion_shapes.SHORT_ARM,
    )

    kind: Literal["torsion-star"]
    h: Extent
    """Thickness of a strip, e.g. ``0.2 mm``."""
    l: Extent
    """Length of a bar, e.g. ``20 mm``."""
    b: Extent
    """Full width of a strip, e.g. ``5 mm``."""
    strips: Annotated[int, Field(strict=True, ge=2, le=100)] = 2
    """Number of strips that cross on the axis: 2 make a cross, 3 a star, e.g. ``2``."""

    def section(self, sizes: Blade) -> Section:
        """Return that of its strips."""
        h, b = sizes.h, sizes.b
        area = torsion_shapes.star_area(h, b, self.strips)
        fourth = torsion_shapes.star_fourth_moment(h, b, self.strips)
        mean = self.polar_moment(sizes) / area
        return Section(area, mean, fourth, (h**2 + b**2) / 4.0, NARROW_SIDE)

    def polar_moment(self, sizes: Blade) -> Computed:
        """Return that of all strips [m⁴]."""
        return torsion_shapes.star_polar_moment(sizes.h, sizes.b, self.strips)

    def torsion_constant(self, sizes: Blade) -> Computed:
        """Return n b h³/3 with what their core adds [m⁴]."""
        return torsion_shapes.star_torsion_constant(sizes.h, sizes.b, self.strips)

    def core_error(self, sizes: Blade) -> float:
        """Return the error of the core over n b h³/3, endless where nobody knows it [-]."""
        error = torsion_shapes.star_core_error(float(self._arm(sizes)), self.strips)
        return 3.0 * error * float(sizes.h / sizes.b) / self.strips

    def side_error(self, sizes: Blade) -> float:
        """Return the error of the stress in the middle of an arm's sides, endless if unknown [-].

        The roots, whose stress is that of their fillet, are left out.
        """
        return torsion_shapes.star_side_error(float(self._arm(sizes)), self.strips)

    def _arm(self, sizes: Blade) -> Computed:
        return torsion_shapes.star_arm(sizes.h, sizes.b, self.strips)

    def shear(self, elastic: Elastic, sizes: Blade, twist: float) -> Computed:
        """Return the shear stress in the middle of an arm's sides [Pa]."""
        factor = torsion_shapes.star_shear_factor(sizes.h, sizes.b, self.strips)
        return torsion_bar.shear_stress(
            G=elastic.G, h=sizes.h, l=sizes.l, theta=twist, factor=factor
        )

    def member(
        self, name: str, start: Vector, end: Vector, elastic: Elastic, sizes: Blade, density: float
    ) -> SpaceStar:
        """Return its strips as one bar, the first of them wide along y."""
        h, b = float(sizes.h), float(sizes.b)
        material = Isotropic(float(elastic.E), float(elastic.G), density)
        return SpaceStar(name, GROUND, MOVING, start, end, hypot(h, b), material, h, b, self.strips)

    def volume(self, sizes: Blade) -> Computed:
        """Return the volume of the strips, their crossing counted once [m³]."""
        h, l, b = sizes
        return self.bars * l * torsion_shapes.star_area(h, b, self.strips)

    def fits(self, sizes: Blade) -> tuple[tuple[str, Computed, Computed], ...]:
        """Return that a strip is no thicker than wide."""
        return (("a strip's thickness in its width, h ≤ b", sizes.h, sizes.b),)

    def ratios(self, sizes: Blade) -> dict[str, Computed]:
        """Return l/h and b/h."""
        return {"l/h": sizes.l / sizes.h, "b/h": sizes.b / sizes.h}

    def indicators(self, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return what its closed forms are valid in; the free length of an arm as well."""
        return {**super().indicators(sizes, travel), "arm/h": self._arm(sizes)}
