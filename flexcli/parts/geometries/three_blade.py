"""Three-blade pivot: three equal blades at 120° around the axis of rotation."""

from collections.abc import Mapping
from math import pi
from typing import Annotated, ClassVar, Literal

from flexcli.formulas import pivot, three_blade
from flexcli.formulas.card import Card
from flexcli.formulas.quantity import Computed
from flexcli.numerics.rows import number
from flexcli.parts.base import QuantityOf
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.base import Blade
from flexcli.parts.geometries.pivots import BladePivot
from flexcli.parts.geometries.star import StarFormulas
from flexcli.results import Value

__all__ = ["ThreeBladePivot"]


class ThreeBladePivot(StarFormulas, BladePivot):
    """Overconstrained pivot of three blades; p is from the axis to the inner ends."""

    source: ClassVar[str] = "exercise 12 B"
    cards: ClassVar[tuple[Card, ...]] = (
        *pivot.CARDS,
        *pivot.ALONG_CARDS,
        *three_blade.CARDS,
    )
    extends: ClassVar[Mapping[str, float]] = {"b/l": 1.0}
    sag_bends_width: ClassVar[bool] = True

    kind: Literal["three-blade"]
    p: Annotated[float, QuantityOf("length", at_least=0.0)] = 0.0
    """Distance from the axis to the inner ends of the blades, e.g. ``2 mm``."""

    @property
    def blade_angles(self) -> tuple[float, ...]:
        """Return the three directions [rad]."""
        return (0.0, 2.0 * pi / 3.0, 4.0 * pi / 3.0)

    def offset(self, sizes: Blade) -> Computed:
        """Return p [m]."""
        return self.p

    def indicators(self, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the quantities of its validity; along the axis its blades are wide beams."""
        return {**super().indicators(sizes, travel), "b/l": sizes.b / sizes.l}

    def sag_stiffness(self, elastic: Elastic, sizes: Blade, axis: str) -> Computed:
        """Return the stiffness along the axis of rotation z [N/m]."""
        if axis != "z":
            raise NotAvailable(f"has no closed form for its sag along {axis}, only along z")
        return pivot.out_of_plane_stiffness(
            E=elastic.E, h=sizes.h, l=sizes.l, b=sizes.b, blades=self.blade_count
        )

    def values(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Value]:
        """Return the stiffness along the axis with the shear of its wide blades."""
        found = super().values(elastic, sizes, travel)
        if elastic.shear is None:
            return found
        h, l, b = self.blade(sizes)
        stiffness = three_blade.out_of_plane_stiffness(
            E=elastic.E, G=elastic.shear, h=h, l=l, b=b, blades=self.blade_count
        )
        text = "stiffness along z with the shear across the width"
        return {**found, "k_z_shear": Value(number(stiffness), "N/m", text)}
