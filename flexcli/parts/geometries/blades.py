"""What joints and stages of equal blades of constant thickness have in common."""

from abc import abstractmethod
from collections.abc import Mapping
from typing import Any, ClassVar, Literal, TypeAlias

from flexcli.formulas.buckling import EFFECTIVE_LENGTH, euler_load
from flexcli.formulas.card import SLENDER, Range
from flexcli.formulas.quantity import Computed
from flexcli.formulas.section import axial_stress, blade_volume, second_moment
from flexcli.parts.bending import Giving
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import ACROSS_WIDTH, Blade, Critical, Extent, Geometry, Sizes

__all__ = ["BladeGeometry", "ClampedBlades", "Clamps"]

Clamps: TypeAlias = Literal["rigid", "monolithic", "monolithic-flush"]


class ClampedBlades(Geometry):
    """A joint or stage whose blades end in bodies, by clamps or cut from one piece with them."""

    joined_in: ClassVar[frozenset[str]] = frozenset()
    """Bodies of its layout that are but blades which meet."""

    clamps: Clamps | None = None
    """How the blades end: between rigid clamps, or cut from one piece with their bodies, which
    give way at the roots; flush where a face is in line with a side of the body. Rigid where
    nothing is said, e.g. ``monolithic``.
    """

    def giving_clamps(self, sizes: Sizes, nu: float) -> Giving | None:
        """Return what roots in one piece with their bodies change."""
        if self.clamps in (None, "rigid"):
            return None
        from flexcli.parts.bending.giving import giving_clamps

        return giving_clamps(
            self.blades_layout(Elastic(1.0, nu), sizes),
            self.held(1.0),
            nu,
            flush=self.clamps == "monolithic-flush",
            joined=self.joined_in,
            shift=lambda pure, bent: self.shift_change(sizes, pure, bent),
        )

    def with_giving_clamps(self) -> Geometry | None:
        """Return it cut from one piece where nothing is said of its clamps."""
        return None if self.clamps else self.model_copy(update={"clamps": "monolithic"})

    def shift_change(self, sizes: Sizes, pure: float, bent: float) -> float | None:
        """Return the change of its shift, as a share, by how blades shorten.

        ``pure`` and ``bent`` are how much more they do when bent to an arc and to an S, as shares
        too. Nothing where it is not known.
        """
        return None


class BladeGeometry(ClampedBlades):
    """A joint or stage made of equal blades of thickness h, length l and width b."""

    dimensions: ClassVar[type[Any]] = Blade
    labels: ClassVar[Mapping[str, str]] = {
        "h": "blade thickness",
        "l": "blade length",
        "b": "blade width",
    }
    validity: ClassVar[tuple[Range, ...]] = (SLENDER,)

    h: Extent
    """Thickness, in the direction in which the blade bends, e.g. ``0.2 mm``."""
    l: Extent
    """Free length, along the blade from end to end, e.g. ``20 mm``."""
    b: Extent
    """Width, across the plane of the motion, e.g. ``10 mm``."""

    @property
    @abstractmethod
    def blade_count(self) -> int:
        """Return the number of blades."""

    def volume(self, sizes: Blade) -> Computed:
        """Return the volume of all blades [m³]."""
        return blade_volume(self.blade_count, sizes.h, sizes.l, sizes.b)

    def ratios(self, sizes: Blade) -> dict[str, Computed]:
        """Return l/h and b/h."""
        return {"l/h": sizes.l / sizes.h, "b/h": sizes.b / sizes.h}

    def axial_stress(self, force: float, sizes: Blade) -> Computed:
        """Return N/(h b) [Pa]."""
        return axial_stress(force, sizes.h, sizes.b)

    def critical(self, elastic: Elastic, sizes: Blade, ends: str) -> tuple[Critical, ...]:
        """Return Euler's loads of one blade about both axes of its section [N]."""
        h, l, b = sizes
        source = f"Euler, {ends} ends (effective length {EFFECTIVE_LENGTH[ends]:.3g} l)"
        return tuple(
            Critical(way, euler_load(E=elastic.E, I=inertia, l=l, ends=ends), source)
            for way, inertia in (
                ("across the thickness", second_moment(b, h)),
                (ACROSS_WIDTH, second_moment(h, b)),
            )
        )

    def blade(self, sizes: Blade) -> Blade:
        """Return the blade."""
        return sizes
