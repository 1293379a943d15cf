"""Remote-centre-of-compliance pivot: two blades that point at a centre outside them."""

from typing import Annotated, ClassVar, Literal

from flexcli.formulas.quantity import Computed
from flexcli.parts.base import QuantityOf
from flexcli.parts.geometries.base import Blade
from flexcli.parts.geometries.pivots import BladePivot, PairFormulas

__all__ = ["RCCPivot"]


class RCCPivot(PairFormulas, BladePivot):
    """RCC pivot: p ≥ 0 from the centre of rotation to the near end of each blade."""

    also: ClassVar[tuple[str, ...]] = ("rcc-pivot",)
    source: ClassVar[str] = "Henein & Thalmann, Dimensioning of flexure joints; exercise 9 part II"

    kind: Literal["rcc"]
    p: Annotated[float, QuantityOf("length", at_least=0.0)]
    """Distance from the centre of rotation to the near end of each blade, e.g. ``2 mm``."""

    def offset(self, sizes: Blade) -> Computed:
        """Return p [m]."""
        return self.p
