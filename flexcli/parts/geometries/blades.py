"""What joints and stages of equal blades of constant thickness have in common."""

from abc import abstractmethod
from collections.abc import Mapping
from typing import Any, ClassVar

from flexcli.formulas.buckling import EFFECTIVE_LENGTH, euler_load
from flexcli.formulas.card import SLENDER, Range
from flexcli.formulas.quantity import Computed
from flexcli.formulas.section import axial_stress, blade_volume, second_moment
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import ACROSS_WIDTH, Blade, Critical, Extent, Geometry

__all__ = ["BladeGeometry"]


class BladeGeometry(Geometry):
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
