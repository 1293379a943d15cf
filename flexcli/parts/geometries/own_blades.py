"""A joint as made: each of its blades with its own sizes."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, ClassVar

from flexcli.formulas.profile import Constant
from flexcli.formulas.quantity import Computed
from flexcli.mechanics.layout import Layout, Point
from flexcli.parts.bending import WideBlades
from flexcli.parts.bending.wide import wide_by_shapes, wide_drawn
from flexcli.parts.elastic import ANY, Elastic, NotAvailable
from flexcli.parts.geometries.base import Blade, Extent, Geometry, Held, Sizes

__all__ = ["OwnBlades", "blade_names"]


def blade_names(geometry: Geometry) -> tuple[str, ...]:
    """Return the names of the blades that a joint of given sizes is drawn with.

    Raises :class:`NotAvailable` where it is not made of blades of constant thickness in a plane.
    """
    blades = geometry.layout(ANY, geometry.sized({})).blades
    if not all(isinstance(blade.profile, Constant) for blade in blades):
        raise NotAvailable("has blades whose thickness is not the same all along")
    return tuple(blade.name for blade in blades)


class OwnBlades(Geometry):
    """The layout of a joint in which each blade is taken from a drawing of its own.

    A joint whose blades differ shifts and tilts under its stroke, which no closed form includes.
    """

    closed_forms: ClassVar[bool] = False
    posynomial: ClassVar[bool] = False
    is_linear: ClassVar[bool] = False
    source: ClassVar[str] = "the blades of the joint, each by itself"

    whole: Any
    """The joint that provides the bodies."""
    each: Mapping[str, Any]
    """By the name of a blade, the joint whose drawing it is taken from."""

    @property
    def name(self) -> str:
        """Return the kind of the joint."""
        return str(self.whole.name)

    @property
    def motion(self) -> str:  # type: ignore[override]
        """Return the kind of motion of the joint."""
        return str(self.whole.motion)

    @property
    def extents(self) -> dict[str, Extent]:
        """Return the sizes of the joint as drawn."""
        found: dict[str, Extent] = self.whole.extents
        return found

    def label(self, name: str) -> str:
        """Return what a size is, in words."""
        return str(self.whole.label(name))

    def sized(self, values: Mapping[str, Any]) -> Sizes:
        """Return the sizes of the joint as drawn."""
        return self.whole.sized(values)

    @property
    def axes(self) -> float:
        """Return that of the joint."""
        return float(self.whole.axes)

    @property
    def symmetry_axis(self) -> float:
        """Return that of the joint."""
        return float(self.whole.symmetry_axis)

    def held(self, travel: float) -> Held:
        """Return what a stroke imposes on the moving body of the joint."""
        found: Held = self.whole.held(travel)
        return found

    def payload_point(self, moving: Point) -> Point:
        """Return that of the joint."""
        found: Point = self.whole.payload_point(moving)
        return found

    def layout(self, elastic: Elastic, sizes: Sizes) -> Layout:
        """Return the joint with each blade as in the drawing of its own."""
        found: Layout = self.whole.layout(elastic, sizes)
        own = {
            name: {blade.name: blade for blade in joint.layout(elastic, joint.sized({})).blades}
            for name, joint in self.each.items()
        }
        return replace(
            found,
            blades=tuple(
                own[blade.name][blade.name] if blade.name in own else blade
                for blade in found.blades
            ),
        )

    def blade_sizes(self, sizes: Sizes) -> dict[str, Blade]:
        """Return thickness, length and width of each blade [m]."""
        found = {}
        for blade in self.layout(ANY, sizes).blades:
            assert isinstance(blade.profile, Constant)  # held where the blades are named
            (x, y), (u, v) = blade.start, blade.end
            length = ((u - x) ** 2 + (v - y) ** 2) ** 0.5
            found[blade.name] = Blade(float(blade.profile.h), float(length), float(blade.b))
        return found

    def wide_blades(self, sizes: Sizes, nu: float) -> WideBlades | None:
        """Return the range of the plate factors of its blades."""
        blades = [(blade, blade.l) for blade in self.blade_sizes(sizes).values()]
        plain = wide_drawn(blades, nu, springs=False)
        layout = self.layout(Elastic(1.0, nu), sizes)
        return wide_by_shapes(plain, blades, nu, layout, self.held(1.0))

    def volume(self, sizes: Sizes) -> Computed:
        """Return the volume of all blades [m³]."""
        return sum(h * l * b for h, l, b in self.blade_sizes(sizes).values())

    def ratios(self, sizes: Sizes) -> dict[str, Computed]:
        """Return l/h and b/h of every blade."""
        found: dict[str, Computed] = {}
        for name, (h, l, b) in self.blade_sizes(sizes).items():
            found |= {f"l/h {name}": l / h, f"b/h {name}": b / h}
        return found

    def sections(self, sizes: Sizes) -> tuple[tuple[str, float, float], ...]:
        """Return the sections of the blades: name, thickness and width [m]."""
        each = self.blade_sizes(sizes).items()
        return tuple((name, float(h), float(b)) for name, (h, _, b) in each)

    def slenderness(self, sizes: Sizes) -> float | None:
        """Return thickness over length of the stockiest blade [-]."""
        return max(float(h / l) for h, l, _ in self.blade_sizes(sizes).values())

    def length(self, sizes: Sizes) -> float:
        """Return the length of the shortest blade [m]."""
        return min(float(l) for _, l, _ in self.blade_sizes(sizes).values())

    def axial_share(self, direction: float) -> float:
        """Return 1: the upper limit, since models give the share of each blade."""
        return 1.0

    def stiffness(self, elastic: Elastic, sizes: Sizes) -> Computed:
        """Refuse: blades that differ have no closed form."""
        raise NotAvailable("with blades that differ has no closed form")

    def end_stresses(self, elastic: Elastic, sizes: Sizes, travel: float) -> dict[str, Computed]:
        """Refuse: blades that differ have no closed form."""
        raise NotAvailable("with blades that differ has no closed form")
