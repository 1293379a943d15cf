"""Unseparated cross-spring pivot: crossed blades joined where they cross, cut from one plane."""

from math import pi
from typing import Annotated, ClassVar, Literal

from flexcli.formulas import pivot
from flexcli.formulas import unseparated as joined
from flexcli.formulas.card import Card
from flexcli.formulas.quantity import Quantity
from flexcli.mechanics.layout import Body, Layout
from flexcli.parts.base import QuantityOf
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.base import GROUND, MOVING, Blade
from flexcli.parts.geometries.pivots import BladePivot, crossing_pair
from flexcli.parts.structure import Spring
from flexcli.results import Value

__all__ = ["UnseparatedPivot"]

CROSS = "cross"


class UnseparatedPivot(BladePivot):
    """Two RCC pivots of p = 0 in series: l is the length of a blade from end to end."""

    source: ClassVar[str] = "Henein & Thalmann, Dimensioning of flexure joints"

    cards: ClassVar[tuple[Card, ...]] = joined.CARDS

    kind: Literal["unseparated-cross"]
    half_angle: Annotated[float, QuantityOf("angle", above=0.0, below=pi / 2)]
    crossing: Annotated[float, QuantityOf("ratio", above=0.0, below=1.0)] = 0.5
    """Share of the blades on the side of the base."""

    @property
    def blade_angles(self) -> tuple[float, ...]:
        """Return the two directions from the bisector [rad]."""
        return crossing_pair(self.half_angle)

    def offset(self, sizes: Blade) -> Quantity:
        """Return minus the length on the side of the base [m]."""
        return -self.crossing * sizes.l

    def stiffness(self, elastic: Elastic, sizes: Blade) -> Quantity:
        """Return the rotational stiffness [N·m/rad]."""
        return joined.unseparated_stiffness(E=elastic.E, h=sizes.h, l=sizes.l, b=sizes.b)

    def end_stresses(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Quantity]:
        """Return the signed bending stress where the blades cross and at their ends [Pa]."""
        crossing, ends = joined.unseparated_stresses(
            E=elastic.E, h=sizes.h, l=sizes.l, theta=travel
        )
        return {"crossing": crossing, "ends": ends}

    def s_bending_share(self, sizes: Blade) -> float:
        """Return ¾, that of a pivot with its centre at the end of the blades."""
        return 0.75

    def spring(self, elastic: Elastic, sizes: Blade) -> Spring:
        """Refuse: the small cross between the halves makes it no single spring."""
        raise NotAvailable("has no linear spring in its plane yet")

    def axial_share(self, direction: float) -> float:
        """Return the axial force in a half-blade per force on the pivot, as of one pair [-]."""
        return super().axial_share(direction)

    def parasitic_shift(self, sizes: Blade, travel: float) -> Quantity:
        """Return the signed shift of the centre along the bisector [m], leading order."""
        return joined.unseparated_shift(
            l=sizes.l, crossing=self.crossing, theta=travel, half_angle=self.half_angle
        )

    def layout(self, elastic: Elastic, sizes: Blade) -> Layout:
        """Return four part-blades around the cross."""
        blades = []
        for index, angle in enumerate(self.blade_angles, 1):
            near, far = self.crossing * sizes.l, (1.0 - self.crossing) * sizes.l
            blades += [
                self.strip(f"blade {index} base", (GROUND, CROSS), angle, (-near, 0.0), sizes),
                self.strip(f"blade {index} stage", (CROSS, MOVING), angle, (0.0, far), sizes),
            ]
        bodies = (Body(CROSS, (0.0, 0.0)), Body(MOVING, (0.0, 0.0)))
        return Layout(bodies, tuple(blades), elastic.E, elastic.shear)

    def values(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Value]:
        """Return stiffness and stroke over those of the same blades, separated."""
        ratio = self.stiffness(elastic, sizes) / pivot.rotational_stiffness(
            E=elastic.E, h=sizes.h, l=sizes.l, b=sizes.b, p=-0.5 * sizes.l
        )
        return {
            "stiffness_ratio": Value(
                float(ratio), "", "stiffness over that of the same blades, separated"
            )
        }
