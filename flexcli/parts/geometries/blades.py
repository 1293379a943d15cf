"""Joints and stages of equal blades of constant thickness: sizes, fillets, clamps."""

from abc import abstractmethod
from collections.abc import Mapping
from functools import partial
from math import pi
from typing import TYPE_CHECKING, Any, ClassVar, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.buckling import EFFECTIVE_LENGTH, euler_load
from flexcli.formulas.card import SLENDER, Range
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.formulas.section import axial_stress, blade_volume, second_moment
from flexcli.numerics.rows import one_by_one
from flexcli.numerics.signomial import Signomial
from flexcli.parts.bending import CompliantClamps, FilletedRoots
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import (
    ACROSS_WIDTH,
    Blade,
    Critical,
    Extent,
    Geometry,
    RootedBlade,
    Sizes,
)

if TYPE_CHECKING:
    from flexcli.mechanics.layout import Blade as Strip
    from flexcli.mechanics.layout import Number, Point
    from flexcli.parts.bending.compliant_clamps import Roots

__all__ = ["BladeGeometry", "ClampedBlades", "Clamps"]

Floats = NDArray[np.float64]

Clamps: TypeAlias = Literal["rigid", "monolithic", "monolithic-flush"]


class ClampedBlades(Geometry):
    """A joint or stage whose blades end in bodies, by clamps or cut from one piece with them."""

    clamps: Clamps | None = None
    """How the blades end: between rigid clamps, or cut from one piece with their bodies, which
    give way at the roots; flush where a face is in line with a side of the body. Rigid where
    nothing is said, e.g. ``monolithic``.
    """

    def compliant_clamps(self, sizes: Sizes, nu: float) -> CompliantClamps | None:
        """Return the changes by roots in one piece with bodies, and fillets beyond their beam."""
        roots = self._roots(nu)
        if roots is None:
            return None
        from flexcli.parts.bending.compliant_clamps import compliant_clamps

        return compliant_clamps(
            self.blades_layout(Elastic(1.0, nu), sizes),
            self.held(1.0),
            roots,
            lambda pure, bent: self.shift_change(sizes, pure, bent),
        )

    def root_springs(self, sizes: Sizes, nu: float) -> Floats | None:
        """Return what roots in one piece with bodies, and fillets beyond their beam, add."""
        roots = self._roots(nu)
        if roots is None:
            return None
        from flexcli.parts.bending.compliant_clamps import root_springs

        return root_springs(self.blades_layout(Elastic(1.0, nu), sizes), roots)

    def _roots(self, nu: float) -> "Roots | None":
        """Return how its blades end, None where that is in rigid clamps, without fillets."""
        is_rigid = self.clamps in (None, "rigid")
        if is_rigid and not self.has_fillets:
            return None
        from flexcli.parts.bending.compliant_clamps import Roots

        return Roots(nu, is_rigid, self.clamps == "monolithic-flush", self.joined_in)

    def with_compliant_clamps(self) -> Geometry | None:
        """Return it cut from one piece where the spec does not state its clamps."""
        return None if self.clamps else self.model_copy(update={"clamps": "monolithic"})

    @property
    def says_rigid(self) -> bool:
        """Return whether the spec says so."""
        return self.clamps == "rigid"

    def radii(self, sizes: Sizes) -> dict[str, Computed]:
        """Return the radii of its roots where they are cut from one piece, or have fillets."""
        is_cut = self.clamps not in (None, "rigid")
        radius = self.fillet(sizes)
        has_fillets = isinstance(radius, Signomial) or bool(np.any(radius))
        return {"the roots": radius} if is_cut or has_fillets else {}

    def shift_change(self, sizes: Sizes, pure: float, bent: float) -> float | None:
        """Return the relative change of its shift by the shortening of its blades.

        ``pure`` and ``bent`` are the relative increases of the shortening when bent to an arc and
        to an S. None where it is not known.
        """
        return None


class BladeGeometry(ClampedBlades):
    """A joint or stage made of equal blades of thickness h, length l and width b."""

    dimensions: ClassVar[type[Any]] = Blade
    labels: ClassVar[Mapping[str, str]] = {
        "h": "blade thickness",
        "l": "blade length",
        "b": "blade width",
        "root_radius": "radius of the roots",
    }
    validity: ClassVar[tuple[Range, ...]] = (SLENDER,)

    h: Extent
    """Thickness, in the direction in which the blade bends, e.g. ``0.2 mm``."""
    l: Extent
    """Free length, along the blade from end to end, e.g. ``20 mm``."""
    b: Extent
    """Width, across the plane of the motion, e.g. ``10 mm``."""
    root_radius: Extent | None = None
    """Radius of the fillets at both ends of a blade, within its length; left out, sharp corners
    whose peak of stress nobody counts, e.g. ``0.2 mm``.
    """

    @property
    def extents(self) -> dict[str, Extent]:
        """Return the extents of the sizes, that of the fillets where the blades have some."""
        plain = super().extents
        return plain if self.root_radius is None else {**plain, "root_radius": self.root_radius}

    def sized(self, values: Mapping[str, Quantity]) -> Sizes:
        """Return the sizes of given values by symbol, with the fillets'."""
        if self.root_radius is None:
            return super().sized(values)
        given = {name: values.get(name, extent.fixed) for name, extent in self.extents.items()}
        return RootedBlade(**given)

    @property
    @abstractmethod
    def blade_count(self) -> int:
        """Return the number of blades."""

    @property
    def has_fillets(self) -> bool:
        """Return whether its blades have some."""
        return self.root_radius is not None

    def fillet(self, sizes: Sizes) -> Computed:
        """Return the radius of the fillets, 0 for sharp corners [m]."""
        return 0.0 if self.root_radius is None else sizes.root_radius

    def sharp(self) -> "BladeGeometry":
        """Return it without fillets, as closed forms assume."""
        return self.model_copy(update={"root_radius": None})

    def strip(
        self,
        name: str,
        bodies: tuple[str, str],
        ends: "tuple[Point, Point]",
        sizes: Blade,
        z: "Number" = 0.0,
    ) -> "Strip":
        """Return a blade of a layout from one place to another, with its fillets."""
        from flexcli.formulas.profile import Constant, Filleted, per_design
        from flexcli.mechanics.layout import Blade as Strip

        h, l, b = self.blade(sizes)
        if self.root_radius is None:
            return Strip(name, *bodies, *ends, Constant(per_design(h)), b, z)
        radius = np.minimum(per_design(self.fillet(sizes)), per_design(l) / 2.0)
        return Strip(name, *bodies, *ends, Filleted(per_design(h), radius), b, z, self.peaks(sizes))

    def peaks(self, sizes: Blade) -> tuple[Computed, Computed]:
        """Return the stress concentration factors of its fillets in bending and along a blade.

        A choice of sizes takes the nominal stress, and is corrected to the peak by slope and value.
        """
        at = {"h": sizes.h, "l": sizes.l, "r": self.fillet(sizes)}
        if self.root_radius is None or any(isinstance(size, Signomial) for size in at.values()):
            return 1.0, 1.0
        from flexcli.formulas.fillet import axial_factor, bending_factor

        return bending_factor(**at), axial_factor(**at)

    def peaks_above(self, sizes: Blade) -> tuple[Computed, Computed]:
        """Return what those of its fillets may be less."""
        if self.root_radius is None:
            return 0.0, 0.0
        from flexcli.formulas.fillet import factors_above

        above = partial(factors_above, clamped=self.clamps in (None, "rigid"))
        bent, along = one_by_one(above, sizes.h, sizes.l, self.fillet(sizes))
        return bent, along

    def filleted(self, sizes: Blade, nu: float) -> FilletedRoots | None:
        """Return the changes of its closed forms by its fillets."""
        if self.root_radius is None:
            return None
        from flexcli.parts.bending.filleted import filleted_roots

        elastic, plain = Elastic(1.0, nu), self.sharp()
        return filleted_roots(
            plain.blades_layout(elastic, sizes),
            self.blades_layout(elastic, sizes),
            self.held(1.0),
            lambda pure, bent: self.shift_change(sizes, pure, bent),
        )

    def fits(self, sizes: Blade) -> tuple[tuple[str, Computed, Computed], ...]:
        """Return that the fillets fit in a blade."""
        if self.root_radius is None:
            return ()
        return (("two fillets in a blade, 2 root_radius ≤ l", 2.0 * self.fillet(sizes), sizes.l),)

    def volume(self, sizes: Blade) -> Computed:
        """Return the volume of all blades with their fillets [m³]."""
        plain = blade_volume(self.blade_count, sizes.h, sizes.l, sizes.b)
        if self.root_radius is None:
            return plain
        corners = self.blade_count * 4.0 * (1.0 - pi / 4.0)
        return plain + corners * self.fillet(sizes) ** 2 * sizes.b

    def ratios(self, sizes: Blade) -> dict[str, Computed]:
        """Return l/h and b/h."""
        return {"l/h": sizes.l / sizes.h, "b/h": sizes.b / sizes.h}

    def axial_stress(self, force: float, sizes: Blade) -> Computed:
        """Return N/(h b), with the peak where its fillets begin [Pa]."""
        plain = axial_stress(force, sizes.h, sizes.b)
        return plain if self.root_radius is None else plain * self.peaks(sizes)[1]

    def critical(self, elastic: Elastic, sizes: Blade, ends: str) -> tuple[Critical, ...]:
        """Return Euler's loads of one blade about both axes of its section [N]."""
        h, l, b = self.blade(sizes)
        source = f"Euler, {ends} ends (effective length {EFFECTIVE_LENGTH[ends]:.3g} l)"
        return tuple(
            Critical(way, euler_load(E=elastic.E, I=inertia, l=l, ends=ends), source)
            for way, inertia in (
                ("across the thickness", second_moment(b, h)),
                (ACROSS_WIDTH, second_moment(h, b)),
            )
        )

    def blade(self, sizes: Blade) -> Blade:
        """Return the blade without its fillets."""
        return Blade(sizes.h, sizes.l, sizes.b)
