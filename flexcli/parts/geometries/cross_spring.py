"""Generalised cross-spring pivot: two blades that cross, or would, at any place."""

from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from flexcli.formulas import pivot
from flexcli.formulas.card import SLENDER, Card, Range
from flexcli.formulas.pivot import SYMMETRIC_CARDS, stiffness_ratio, stroke_ratio
from flexcli.formulas.quantity import Computed
from flexcli.numerics.rows import number, tan
from flexcli.parts.base import Length, QuantityOf, spec_error
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import Blade
from flexcli.parts.geometries.pivots import PairFormulas, SideBySide
from flexcli.results import QuantityKind, Value

__all__ = ["CrossSpringPivot"]

MIDDLE = -0.5
"""δ of blades that cross half-way."""

LEADING = "|9δ² + 9δ + 1| tan² α/θ"
"""The shift's leading term over some ten times the next one, near Wittrick's crossing."""


class CrossSpringPivot(PairFormulas, SideBySide):
    """Cross-spring pivot of separate blades: the centre is placed by p or by delta = p/l."""

    also: ClassVar[tuple[str, ...]] = ("generalized-cross-spring", "generalised-cross-spring")
    source: ClassVar[str] = (
        "Henein & Thalmann, Dimensioning of flexure joints; Zhao & Bi 2010, Mech. Mach. Theory 45"
    )

    cards: ClassVar[tuple[Card, ...]] = (*pivot.CARDS, *SYMMETRIC_CARDS)
    validity: ClassVar[tuple[Range, ...]] = (
        SLENDER,
        Range(
            LEADING,
            least=1.0,
            why="the leading term of the parasitic shift all but vanishes at Wittrick's crossing; "
            "the next order in the rotation rules (shift_across)",
            kind=QuantityKind.SHIFT,
        ),
    )

    kind: Literal["cross-spring"]
    """Separate blades that cross, or would cross, in the centre of rotation,
    e.g. ``kind: cross-spring, delta: -0.5``.
    """
    p: Length | None = None
    """Distance from the centre of rotation to the near end of each blade, negative where they
    cross,
    e.g. ``p: -10 mm, half_angle: 45 deg``.
    """
    delta: Annotated[float, QuantityOf("ratio")] | None = None
    """Place of the centre as p/l, in place of p: -0.5 is the middle of the blades,
    e.g. ``delta: -0.5, half_angle: 45 deg``.
    """
    pairs: Annotated[int, Field(strict=True, ge=1, le=1000)] = 1
    """Number of equal pairs of blades, side by side along the axis,
    e.g. ``pairs: 2, delta: -0.5``.
    """

    @model_validator(mode="after")
    def _one_crossing(self) -> "CrossSpringPivot":
        if (self.p is None) == (self.delta is None):
            raise spec_error(
                "the crossing is placed by p or by delta", "give one, e.g. delta: -0.5 (symmetric)"
            )
        return self

    @property
    def blade_angles(self) -> tuple[float, ...]:
        """Return the directions from the bisector [rad]."""
        return super().blade_angles * self.pairs

    def may_tilt(self, *, loaded: bool) -> bool:
        """Return that its blades pass beside each other, where nothing holds the body upright.

        Those that cross in the middle a stroke bends to arcs, which pull at nothing.
        """
        return self.tilt == "free" and (loaded or self.delta != MIDDLE)

    def offset(self, sizes: Blade) -> Computed:
        """Return p [m], as given or as delta times the length."""
        return self.p if self.p is not None else self.delta * sizes.l

    def indicators(self, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the quantities of its validity; those of its shift only where it turns."""
        found = super().indicators(sizes, travel)
        if travel == 0.0:
            return found
        delta = found["delta"]
        bracket = abs(9.0 * delta * (delta + 1.0) + 1.0)
        return {**found, LEADING: bracket * tan(self.half_angle) ** 2 / travel}

    def values(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Value]:
        """Return δ, the shift across, and ratios to the symmetric pivot."""
        delta = number(self.offset(sizes) / sizes.l)
        return {
            **super().values(elastic, sizes, travel),
            "stiffness_ratio": Value(
                stiffness_ratio(delta), "", "stiffness over that of the symmetric pivot"
            ),
            "stroke_ratio": Value(
                number(stroke_ratio(delta)), "", "stroke over that of the symmetric pivot"
            ),
        }
