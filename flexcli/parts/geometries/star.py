"""Pivot of any number of equal blades that point at one centre, in directions of choice."""

from typing import Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from flexcli.formulas import pivot
from flexcli.formulas.quantity import Computed
from flexcli.numerics.rows import number
from flexcli.numerics.signomial import Signomial
from flexcli.parts.base import Angle, Length, QuantityOf, spec_error
from flexcli.parts.bending import Bending
from flexcli.parts.bending.star import Star
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import Blade
from flexcli.parts.geometries.pivots import PivotFormulas, SideBySide

__all__ = ["StarFormulas", "StarPivot"]


class StarFormulas(PivotFormulas):
    """Closed forms of such blades in any directions, with their errors."""

    def bending(self, elastic: Elastic, sizes: Blade, travel: float) -> Bending:
        """Return the bending of blades in any directions."""
        h, l, _ = map(number, self.blade(sizes))
        p = number(self.offset(sizes))
        return Star(h=h, l=l, p=p, theta=travel, angles=self.blade_angles)


class StarPivot(StarFormulas, SideBySide):
    """n blades at given angles from the x axis; p or delta places the centre for all of them.

    Where they cross in it, they pass side by side along the axis, in the order of their angles.
    """

    source: ClassVar[str] = "Henein & Thalmann, Dimensioning of flexure joints; exercise 12 B"

    kind: Literal["star"]
    """Blades at given angles around one centre, e.g. ``kind: star, p: 2 mm``."""
    angles: Annotated[tuple[Angle, ...], Field(min_length=2, max_length=1000)]
    """Direction of each blade from x, e.g. ``angles: [0 deg, 120 deg, 240 deg], p: 2 mm``."""
    p: Length | None = None
    """Distance from the centre of rotation to the near end of each blade,
    e.g. ``p: 2 mm, angles: [0 deg, 120 deg, 240 deg]``.
    """
    delta: Annotated[float, QuantityOf("ratio")] | None = None
    """Place of the centre as p/l, in place of p,
    e.g. ``delta: 0.1, angles: [0 deg, 120 deg, 240 deg]``.
    """

    @model_validator(mode="after")
    def _one_centre(self) -> "StarPivot":
        if (self.p is None) == (self.delta is None):
            raise spec_error("the centre is placed by p or by delta", "give one, e.g. p: 2 mm")
        return self

    @model_validator(mode="after")
    def _holds_its_centre(self) -> "StarPivot":
        try:
            pivot.axial_share(self.angles, 0.0)
        except ValueError as error:
            raise spec_error(
                "parallel blades leave the centre free across them",
                "give a blade another direction, e.g. angles: [45 deg, -45 deg]",
                at=("angles",),
            ) from error
        return self

    @property
    def blade_angles(self) -> tuple[float, ...]:
        """Return the directions [rad]."""
        return self.angles

    def offset(self, sizes: Blade) -> Computed:
        """Return p [m], as given or as delta times the length."""
        return self.p if self.p is not None else self.delta * sizes.l

    def heights(self, sizes: Blade) -> tuple[float, ...]:
        """Return heights of blades side by side where they cross, all in one plane otherwise."""
        p, l = self.offset(sizes), sizes.l
        # of a length that is still to be found blades with an end before the centre cross
        crossed = self._crosses and (isinstance(l, Signomial) or p + l > 0.0)
        return super().heights(sizes) if crossed else (0.0,) * self.blade_count

    def may_tilt(self, *, loaded: bool) -> bool:
        """Return that blades which cross pass beside each other, where nothing holds the body."""
        return self.tilt == "free" and self._crosses

    @property
    def _crosses(self) -> bool:
        """Return whether blades that are long enough cross in the centre."""
        if self.delta is not None:
            return -1.0 < self.delta < 0.0
        return self.p is not None and self.p < 0.0
