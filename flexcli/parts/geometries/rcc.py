"""Remote-centre-of-compliance pivot: two blades that point at a centre outside them."""

from math import pi
from typing import Annotated, ClassVar, Literal

from flexcli.formulas import pivot
from flexcli.formulas.quantity import Quantity
from flexcli.parts.base import QuantityOf
from flexcli.parts.geometries.base import Blade
from flexcli.parts.geometries.pivots import BladePivot, crossing_pair

__all__ = ["RCCPivot"]


class RCCPivot(BladePivot):
    """RCC pivot: p ≥ 0 from the centre of rotation to the near end of each blade."""

    also: ClassVar[tuple[str, ...]] = ("rcc-pivot",)
    source: ClassVar[str] = "Henein & Thalmann, Dimensioning of flexure joints; exercise 9 part II"

    kind: Literal["rcc"]
    p: Annotated[float, QuantityOf("length", at_least=0.0)]
    half_angle: Annotated[float, QuantityOf("angle", above=0.0, below=pi / 2)]

    @property
    def blade_angles(self) -> tuple[float, ...]:
        """Return the two directions from the bisector [rad]."""
        return crossing_pair(self.half_angle)

    def offset(self, sizes: Blade) -> Quantity:
        """Return p [m]."""
        return self.p

    def parasitic_shift(self, sizes: Blade, travel: float) -> Quantity:
        """Return the signed shift of the centre along the bisector [m]."""
        return pivot.parasitic_shift(l=sizes.l, p=self.p, theta=travel, half_angle=self.half_angle)
