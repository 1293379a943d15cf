"""Generalised cross-spring pivot: two separate blades that cross, or would, at any place."""

from math import pi
from typing import Annotated, ClassVar, Literal

from pydantic import model_validator

from flexcli.formulas import pivot
from flexcli.formulas.quantity import Quantity
from flexcli.parts.base import Length, QuantityOf, spec_error
from flexcli.parts.geometries.base import Blade
from flexcli.parts.geometries.pivots import BladePivot, crossing_pair

__all__ = ["CrossSpringPivot"]


class CrossSpringPivot(BladePivot):
    """Cross-spring pivot: the crossing is placed by p (a length) or by delta = p/l."""

    source: ClassVar[str] = (
        "Henein & Thalmann, Dimensioning of flexure joints; Zhao & Bi 2010, Mech. Mach. Theory 45"
    )

    kind: Literal["cross-spring"]
    p: Length | None = None
    delta: Annotated[float, QuantityOf("ratio")] | None = None
    half_angle: Annotated[float, QuantityOf("angle", above=0.0, below=pi / 2)]

    @model_validator(mode="after")
    def _one_crossing(self) -> "CrossSpringPivot":
        if (self.p is None) == (self.delta is None):
            raise spec_error(
                "the crossing is placed by p or by delta", "give one, e.g. delta: -0.5 (symmetric)"
            )
        return self

    @property
    def blade_angles(self) -> tuple[float, ...]:
        """Return the two directions from the bisector [rad]."""
        return crossing_pair(self.half_angle)

    def offset(self, blade: Blade) -> Quantity:
        """Return p [m], as given or as delta times the length."""
        return self.p if self.p is not None else self.delta * blade.l

    def parasitic_shift(self, blade: Blade, travel: float) -> Quantity:
        """Return the signed shift of the centre along the bisector [m], leading order."""
        return pivot.parasitic_shift(
            l=blade.l, p=self.offset(blade), theta=travel, half_angle=self.half_angle
        )
