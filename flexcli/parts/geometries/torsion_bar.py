"""Torsion bar of rectangular section, its ends free to warp or held flat by their clamps."""

from collections.abc import Mapping
from math import sqrt
from typing import Any, ClassVar, Literal, NamedTuple

import numpy as np

from flexcli.formulas import restrained_torsion, torsion_bar, torsion_fibres, torsion_section
from flexcli.formulas.card import Card, Range
from flexcli.formulas.profile import Constant as Thickness
from flexcli.formulas.quantity import Computed
from flexcli.formulas.section import second_moment
from flexcli.mechanics.space.layout import Isotropic, SpaceBlade, Vector
from flexcli.parts.bending.twist import EndErrors
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import GROUND, MOVING, Blade, Extent
from flexcli.parts.geometries.torsion import NARROW_SIDE, Section, TorsionGeometry

__all__ = ["TorsionBar"]

UNEVEN = 0.05
"""Relative change of stress in a strip with restrained ends, at most, as the fibres even out its
rate of twist along the bar; no more than their own."""


class ClampedCorners(NamedTuple):
    """Stress in the corners of clamps, what fibres add [Pa], and its error as a share of it."""

    plain: Computed
    rise: Computed
    error: Computed


class TorsionBar(TorsionGeometry):
    """Torsion bar of rectangular section h × b; ``warping`` says what its clamps hold."""

    dimensions: ClassVar[type[Any]] = Blade
    labels: ClassVar[Mapping[str, str]] = {"h": "thickness", "l": "length of a bar", "b": "width"}
    cards: ClassVar[tuple[Card, ...]] = (
        *torsion_bar.CARDS,
        *torsion_section.CARDS,
        *restrained_torsion.CARDS,
        *torsion_fibres.CARDS,
    )
    validity: ClassVar[tuple[Range, ...]] = (torsion_bar.THIN_TWIST,)

    kind: Literal["torsion-bar"]
    h: Extent
    """Thickness of the section, e.g. ``0.3 mm``."""
    l: Extent
    """Length of a bar, e.g. ``20 mm``."""
    b: Extent
    """Width of the section, e.g. ``3 mm``."""
    warping: Literal["free", "restrained"] = "free"
    """Whether the clamps keep the end sections flat, e.g. ``restrained``."""

    def thin(self, sizes: Blade) -> Computed:
        """Return the lesser of h and b [m]."""
        return np.minimum(sizes.h, sizes.b)

    def section(self, sizes: Blade) -> Section:
        """Return that of a rectangle."""
        h, b = sizes.h, sizes.b
        square = h**2 + b**2
        fourth = torsion_fibres.rectangle_fourth_moment(h, b)
        return Section(h * b, square / 12.0, fourth, square / 4.0, NARROW_SIDE)

    @property
    def is_restrained(self) -> bool:
        """Return what the spec says of the clamps, unless it leaves warping out."""
        return self.warping == "restrained" and EffectName.WARPING not in self.omitted

    def rate(self, elastic: Elastic, sizes: Blade, twist: float) -> Computed:
        """Return the twist per length, that at mid-length where the ends cannot warp [rad/m]."""
        if not self.is_restrained:
            return super().rate(elastic, sizes, twist)
        found = self._restrained(elastic, sizes, twist)
        plain = self.shear(elastic, sizes, twist)
        return np.maximum(found.shear / plain, 1.0) * twist / sizes.l

    def fibre_stress(self, elastic: Elastic, sizes: Blade, twist: float, *, free: bool) -> Computed:
        """Return that of the worst place, in clamps that hold it the corners' as well [Pa]."""
        along = super().fibre_stress(elastic, sizes, twist, free=free)
        if not self.is_restrained:
            return along
        corners = self._clamped_corners(elastic, sizes, twist, free=free)
        return np.maximum(along, corners.plain + corners.rise)

    def fibre_error(self, elastic: Elastic, sizes: Blade, twist: float, *, free: bool) -> float:
        """Return that of the corners' rise in clamps that hold it, and of uneven fibres."""
        if not self.is_restrained:
            return 0.0
        along = super().fibre_stress(elastic, sizes, twist, free=free)
        corners = self._clamped_corners(elastic, sizes, twist, free=free)
        plain = max(self.end_stresses(elastic, sizes, twist).values())
        uneven = min(UNEVEN * along, max(along - plain, 0.0))
        low, found, high = (
            max(along + side * uneven, corners.plain + (1.0 + side * corners.error) * corners.rise)
            for side in (-1.0, 0.0, 1.0)
        )
        return float(max(high - found, found - low) / found)

    def _clamped_corners(
        self, elastic: Elastic, sizes: Blade, twist: float, *, free: bool
    ) -> ClampedCorners:
        plain = self.end_stresses(elastic, sizes, twist)["corners at the clamps"]
        section = self.section(sizes)
        fibre = torsion_fibres.fibre_stress(
            E=elastic.E, rate=twist / sizes.l, square=section.edge,
            mean_square=section.mean if free else 0.0,
        ) / plain  # fmt: skip
        stiffening = self.fibre_stiffening(elastic, sizes, twist, free=free)
        rise = torsion_fibres.clamped_rise(
            fibre=fibre, stiffening=stiffening / self.stiffness(elastic, sizes) - 1.0, free=free,
            **sizes._asdict(),
        )  # fmt: skip
        return ClampedCorners(plain, plain * rise, torsion_fibres.clamped_rise_error(fibre))

    def edge_shear(self, elastic: Elastic, sizes: Blade, twist: float) -> Computed:
        """Return that of the narrow sides; short bars that cannot warp are sheared more [Pa]."""
        plain = super().edge_shear(elastic, sizes, twist)
        if not self.is_restrained:
            return plain
        return np.maximum(self._restrained(elastic, sizes, twist).narrow, plain)

    def polar_moment(self, sizes: Blade) -> Computed:
        """Return that of a rectangle [m⁴]."""
        return second_moment(sizes.h, sizes.b) + second_moment(sizes.b, sizes.h)

    def torsion_constant(self, sizes: Blade) -> Computed:
        """Return J by Saint-Venant's series [m⁴]."""
        return torsion_section.torsion_constant(sizes.h, sizes.b)

    def shear(self, elastic: Elastic, sizes: Blade, twist: float) -> Computed:
        """Return the largest shear stress, at the middle of the broad sides [Pa]."""
        h, l, b = sizes
        factor = torsion_section.shear_factor(h, b)
        return torsion_bar.shear_stress(
            G=elastic.G, h=self.thin(sizes), l=l, theta=twist, factor=factor
        )

    def stiffness(self, elastic: Elastic, sizes: Blade) -> Computed:
        """Return the rotational stiffness [N·m/rad]."""
        if not self.is_restrained:
            return super().stiffness(elastic, sizes)
        h, l, b = sizes
        stiff = restrained_torsion.restrained_stiffness(E=elastic.E, G=elastic.G, h=h, b=b, l=l)
        changed = self._restraint(elastic, sizes).stiffness.middle
        return self.bars * stiff * (1.0 + changed)

    def end_stresses(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return von Mises' equivalent stress at mid-length and, where clamped, at the ends."""
        if not self.is_restrained:
            return super().end_stresses(elastic, sizes, travel)
        found = self._restrained(elastic, sizes, travel)
        corners = found.normal * (1.0 + self._restraint(elastic, sizes).normal.middle)
        return {
            "broad side": sqrt(3.0) * found.shear,
            "corners at the clamps": corners,
            "narrow side": sqrt(3.0) * found.narrow,
        }

    def _restrained(
        self, elastic: Elastic, sizes: Blade, twist: float
    ) -> restrained_torsion.TwistStress:
        return restrained_torsion.restrained_stresses(
            E=elastic.E, G=elastic.G, theta=twist, **sizes._asdict()
        )

    def _restraint(self, elastic: Elastic, sizes: Blade) -> restrained_torsion.RestraintError:
        nu = elastic.E / (2.0 * elastic.G) - 1.0
        return restrained_torsion.restraint_error(nu=nu, **sizes._asdict())

    def indicators(self, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return what its closed forms are valid in; of clamps that hold it, the sides as well."""
        found = super().indicators(sizes, travel)
        if self.is_restrained:
            found["l/b"] = sizes.l / np.maximum(sizes.h, sizes.b)
        return found

    def end_errors(self, sizes: Blade, nu: float | None) -> EndErrors:
        """Return what blocks between rigid bodies showed; of the stress, where it is largest."""
        if not self.is_restrained:
            return EndErrors()
        elastic = Elastic(1.0, 0.5 if nu is None else nu)
        error = self._restraint(elastic, sizes)
        left = error.normal.left
        values = np.array(list(self.end_stresses(elastic, sizes, 1.0).values()))
        low, high = (
            float(np.max(values * (1.0 + np.array(ends))) / np.max(values)) - 1.0
            for ends in (
                (error.shear.low, left.low, error.narrow.low),
                (error.shear.high, left.high, error.narrow.high),
            )
        )
        return EndErrors(float(error.stiffness.around), max(-low, high))

    def member(
        self, name: str, start: Vector, end: Vector, elastic: Elastic, sizes: Blade, density: float
    ) -> SpaceBlade:
        """Return a strip, its h along x and its b along y."""
        h, b = float(sizes.h), float(sizes.b)
        width = (0.0, 1.0, 0.0) if h <= b else (1.0, 0.0, 0.0)
        return SpaceBlade(
            name, GROUND, MOVING, start, end, width, Thickness(min(h, b)), max(h, b),
            Isotropic(float(elastic.E), float(elastic.G), density), warps=not self.is_restrained,
        )  # fmt: skip

    def volume(self, sizes: Blade) -> Computed:
        """Return the volume of the bars [m³]."""
        return self.bars * sizes.h * sizes.l * sizes.b

    def ratios(self, sizes: Blade) -> dict[str, Computed]:
        """Return l/h and b/h."""
        return {"l/h": sizes.l / sizes.h, "b/h": sizes.b / sizes.h}
