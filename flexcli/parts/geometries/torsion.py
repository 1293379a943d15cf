"""Torsion bars: a body turns about the axis of the bars that hold it."""

from abc import abstractmethod
from collections.abc import Mapping
from math import pi, sqrt
from typing import Annotated, Any, ClassVar, Literal, NamedTuple

import numpy as np
from pydantic import Field

from flexcli.formulas import restrained_torsion, torsion_bar, torsion_section, torsion_shapes
from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Quantity
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import Blade, Extent, Geometry

__all__ = ["RoundTorsionBar", "TorsionBar", "TorsionStar"]

Bars = Annotated[int, Field(strict=True, ge=1, le=1000)]


class _Torsion(Geometry):
    motion: ClassVar[str] = "rotation"
    source: ClassVar[str] = "Timoshenko & Goodier 1970, Theory of Elasticity, chapter 10"
    strain: ClassVar[str] = "twist"
    posynomial: ClassVar[bool] = False

    bars: Bars = Field(1, description="on one axis; 2 hold the body between them")

    @abstractmethod
    def torsion_constant(self, sizes: Any) -> Quantity:
        """Return J of one bar [m⁴]."""

    @abstractmethod
    def shear(self, elastic: Elastic, sizes: Any, twist: float) -> Quantity:
        """Return the largest shear stress [Pa] at a twist, the ends free to warp."""

    def stiffness(self, elastic: Elastic, sizes: Any) -> Quantity:
        """Return the rotational stiffness, the ends free to warp [N·m/rad]."""
        return torsion_bar.torsional_stiffness(
            G=elastic.G, J=self.torsion_constant(sizes), l=sizes.l, bars=self.bars
        )

    def end_stresses(self, elastic: Elastic, sizes: Any, travel: float) -> dict[str, Quantity]:
        """Return von Mises' equivalent of the shear stress [Pa]."""
        return {"broad side": sqrt(3.0) * self.shear(elastic, sizes, travel)}

    def thin(self, sizes: Any) -> Quantity:
        """Return the thin side of the section [m]."""
        return sizes.h

    def indicators(self, sizes: Any, travel: float) -> dict[str, Quantity]:
        """Return what its closed forms are valid in: shape and twist."""
        return {**self.ratios(sizes), "h θ/l": self.thin(sizes) * travel / sizes.l}


class TorsionBar(_Torsion):
    """Torsion bar of rectangular section h × b; ``warping`` says what its clamps hold."""

    dimensions: ClassVar[type[Any]] = Blade
    labels: ClassVar[Mapping[str, str]] = {"h": "thickness", "l": "length of a bar", "b": "width"}
    cards: ClassVar[tuple[Card, ...]] = (
        *torsion_bar.CARDS,
        *torsion_section.CARDS,
        *restrained_torsion.CARDS,
    )
    validity: ClassVar[tuple[Range, ...]] = (torsion_bar.THIN_TWIST,)

    kind: Literal["torsion-bar"]
    h: Extent
    l: Extent
    b: Extent
    warping: Literal["free", "restrained"] = "free"

    def thin(self, sizes: Blade) -> Quantity:
        """Return the lesser of h and b [m]."""
        return np.minimum(sizes.h, sizes.b)

    def torsion_constant(self, sizes: Blade) -> Quantity:
        """Return J by Saint-Venant's series [m⁴]."""
        return torsion_section.torsion_constant(sizes.h, sizes.b)

    def shear(self, elastic: Elastic, sizes: Blade, twist: float) -> Quantity:
        """Return the largest shear stress, at the middle of the broad sides [Pa]."""
        h, l, b = sizes
        factor = torsion_section.shear_factor(h, b)
        return torsion_bar.shear_stress(
            G=elastic.G, h=self.thin(sizes), l=l, theta=twist, factor=factor
        )

    def stiffness(self, elastic: Elastic, sizes: Blade) -> Quantity:
        """Return the rotational stiffness [N·m/rad]."""
        if self.warping == "free":
            return super().stiffness(elastic, sizes)
        h, l, b = sizes
        return self.bars * restrained_torsion.restrained_stiffness(
            E=elastic.E, G=elastic.G, h=h, b=b, l=l
        )

    def end_stresses(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Quantity]:
        """Return von Mises' equivalent stress at mid-length and, where clamped, at the ends."""
        if self.warping == "free":
            return super().end_stresses(elastic, sizes, travel)
        h, l, b = sizes
        found = restrained_torsion.restrained_stresses(
            E=elastic.E, G=elastic.G, h=h, b=b, l=l, theta=travel
        )
        return {"broad side": sqrt(3.0) * found.shear, "corners at the clamps": found.normal}

    def volume(self, sizes: Blade) -> Quantity:
        """Return the volume of the bars [m³]."""
        return self.bars * sizes.h * sizes.l * sizes.b

    def ratios(self, sizes: Blade) -> dict[str, Quantity]:
        """Return l/h and b/h."""
        return {"l/h": sizes.l / sizes.h, "b/h": sizes.b / sizes.h}


class RoundSizes(NamedTuple):
    """Diameter and length [m]."""

    d: Quantity
    l: Quantity


class RoundTorsionBar(_Torsion):
    """Torsion bar of circular section, which does not warp."""

    dimensions: ClassVar[type[Any]] = RoundSizes
    labels: ClassVar[Mapping[str, str]] = {"d": "diameter", "l": "length of a bar"}
    cards: ClassVar[tuple[Card, ...]] = (*torsion_bar.CARDS, *torsion_shapes.CARDS)
    validity: ClassVar[tuple[Range, ...]] = (torsion_bar.THIN_TWIST,)

    kind: Literal["round-torsion-bar"]
    d: Extent
    l: Extent

    def thin(self, sizes: RoundSizes) -> Quantity:
        """Return the diameter [m]."""
        return sizes.d

    def torsion_constant(self, sizes: RoundSizes) -> Quantity:
        """Return π d⁴/32 [m⁴]."""
        return torsion_shapes.circle_torsion_constant(sizes.d)

    def shear(self, elastic: Elastic, sizes: RoundSizes, twist: float) -> Quantity:
        """Return the shear stress at the surface [Pa]."""
        return torsion_bar.shear_stress(G=elastic.G, h=sizes.d, l=sizes.l, theta=twist, factor=0.5)

    def volume(self, sizes: RoundSizes) -> Quantity:
        """Return the volume of the bars [m³]."""
        return self.bars * pi / 4.0 * sizes.d**2 * sizes.l

    def ratios(self, sizes: RoundSizes) -> dict[str, Quantity]:
        """Return l/d."""
        return {"l/d": sizes.l / sizes.d}


class TorsionStar(_Torsion):
    """Cross-arrangement: n thin strips of full width b that cross on the axis (2: cruciform)."""

    dimensions: ClassVar[type[Any]] = Blade
    labels: ClassVar[Mapping[str, str]] = {
        "h": "thickness of a strip",
        "l": "length",
        "b": "full width of a strip",
    }
    cards: ClassVar[tuple[Card, ...]] = (*torsion_bar.CARDS, *torsion_shapes.CARDS)
    validity: ClassVar[tuple[Range, ...]] = (
        torsion_bar.THIN_TWIST,
        Range("b/h", least=10.0, why="the strips' ends and their crossing count"),
    )

    kind: Literal["torsion-star"]
    h: Extent
    l: Extent
    b: Extent
    strips: Annotated[int, Field(strict=True, ge=2, le=100)] = 2

    def torsion_constant(self, sizes: Blade) -> Quantity:
        """Return n b h³/3 [m⁴]."""
        return torsion_shapes.star_torsion_constant(sizes.h, sizes.b, self.strips)

    def shear(self, elastic: Elastic, sizes: Blade, twist: float) -> Quantity:
        """Return the shear stress of the thin strips [Pa]."""
        return torsion_bar.shear_stress(G=elastic.G, h=sizes.h, l=sizes.l, theta=twist)

    def volume(self, sizes: Blade) -> Quantity:
        """Return the volume of the strips, their crossing counted once [m³]."""
        h, l, b = sizes
        return self.bars * l * (self.strips * h * b - (self.strips - 1) * h**2)

    def fits(self, sizes: Blade) -> tuple[tuple[str, Quantity, Quantity], ...]:
        """Return that a strip is no thicker than wide."""
        return (("a strip's thickness in its width, h ≤ b", sizes.h, sizes.b),)

    def ratios(self, sizes: Blade) -> dict[str, Quantity]:
        """Return l/h and b/h."""
        return {"l/h": sizes.l / sizes.h, "b/h": sizes.b / sizes.h}
