"""Unseparated cross-spring pivot: crossed blades joined where they cross, cut from one plane."""

from dataclasses import replace
from typing import Annotated, ClassVar, Literal

from pydantic import model_validator

from flexcli.formulas import pivot
from flexcli.formulas import unseparated as joined
from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed
from flexcli.formulas.solid_crossing import OfHalves, crossed_blades, crossing_reach
from flexcli.mechanics.layout import Body, Layout
from flexcli.numerics.rows import number, one_by_one, smaller
from flexcli.parts.base import QuantityOf, spec_error
from flexcli.parts.bending import Bending, CompliantClamps, WideBlades
from flexcli.parts.bending.joined import Joined
from flexcli.parts.bending.joined_halves import halves_apart, plates_of_halves, wide_halves
from flexcli.parts.elastic import Elastic
from flexcli.parts.ends import ENDS
from flexcli.parts.geometries.base import GROUND, MOVING, Blade, Critical, CrossSizes, Solids
from flexcli.parts.geometries.joint_buckling import pivot_critical
from flexcli.parts.geometries.pivots import BladePair, largest_share, on_ray
from flexcli.results import ErrorRange, Value

__all__ = ["UnseparatedPivot"]

CROSS = "cross"


class UnseparatedPivot(BladePair):
    """Two RCC pivots of p = 0 in series: l is the length of a blade from end to end."""

    source: ClassVar[str] = "Henein & Thalmann, Dimensioning of flexure joints"

    cards: ClassVar[tuple[Card, ...]] = joined.CARDS
    validity: ClassVar[tuple[Range, ...]] = (
        Range("part l/h", least=10.0, why="a part of a blade this short is no slender beam"),
    )

    joined_in: ClassVar[frozenset[str]] = frozenset({CROSS})
    solids: ClassVar[Solids | None] = "cross"

    kind: Literal["unseparated-cross"]
    crossing: Annotated[float, QuantityOf("ratio", above=0.0, below=1.0)] = 0.5
    """Share of the blades' length on the side of the base, e.g. ``0.5``."""

    @model_validator(mode="after")
    def _has_sharp_roots(self) -> "UnseparatedPivot":
        if self.root_radius is not None:
            raise spec_error(
                "root_radius is of blades that end in two bodies, not where they cross",
                "leave it out, or draw a layout",
                at=("root_radius",),
            )
        return self

    def offset(self, sizes: Blade) -> Computed:
        """Return minus the length on the side of the base [m]."""
        return -self.crossing * sizes.l

    def stiffness(self, elastic: Elastic, sizes: Blade) -> Computed:
        """Return the rotational stiffness [N·m/rad]."""
        return joined.unseparated_stiffness(E=elastic.E, h=sizes.h, l=sizes.l, b=sizes.b)

    def end_stresses(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the signed bending stress where the blades cross and at their ends [Pa]."""
        crossing, ends = joined.unseparated_stresses(
            E=elastic.E, h=sizes.h, l=sizes.l, theta=travel
        )
        return {"crossing": crossing, "ends": ends}

    def bending(self, elastic: Elastic, sizes: Blade, travel: float) -> Bending:
        """Return the bending of two pivots in series."""
        h, l, _ = map(number, self.blade(sizes))
        return Joined(h=h, l=l, crossing=self.crossing, theta=travel, half_angle=self.half_angle)

    def wide_blades(self, sizes: Blade, nu: float) -> WideBlades:
        """Return the plate factors of its part-blades."""
        return wide_halves(sizes, nu, self.crossing, self.half_angle)

    def compliant_clamps(self, sizes: Blade, nu: float) -> CompliantClamps:
        """Return the changes by the solid crossing and by compliant roots."""
        from flexcli.parts.bending.solid_cross import solid_cross, with_roots

        blade, at = self.blade(sizes), (nu, self.crossing, self.half_angle)

        def halves(rigid: float) -> OfHalves:
            return plates_of_halves(blade, *at, rigid).value

        crossed = solid_cross(blade, *at, halves, halves_apart(blade, *at))
        roots = super().compliant_clamps(sizes, nu)
        return crossed if roots is None else with_roots(crossed, roots)

    @property
    def has_solids(self) -> bool:
        """Return whether its ends are rigid, as those of its solids are."""
        return self.clamps in (None, "rigid")

    def solid_cross(self, sizes: Blade) -> CrossSizes:
        """Return the sizes of its blades."""
        h, l, b = map(number, self.blade(sizes))
        return CrossSizes(h, l, b, self.crossing, self.half_angle)

    def crossed(self, sizes: Blade) -> tuple[Computed, Computed]:
        """Return what their solid crossing makes of the stiffness of its blades, any way."""
        h, l, _ = self.blade(sizes)
        least, most = one_by_one(crossed_blades, h, l, self.crossing, self.half_angle)
        return least, most

    def s_bending_share(self, sizes: Blade) -> float:
        """Return ¾ (1/c + 1/(1 − c)): ¾ of each part, whose Φ is that of its own length."""
        return 0.75 / self.crossing + 0.75 / (1.0 - self.crossing)

    def axial_share(self, direction: float) -> float:
        """Return the axial force in a part-blade per force: both halves bear all of it [-]."""
        return largest_share(self.blade_angles, direction)

    def joint_critical(
        self, elastic: Elastic, sizes: Blade, ends: str, direction: float
    ) -> Critical:
        """Return the force that buckles a blade on pins, as if no other were joined to it [N].

        That can only raise it, to no more than what the longer part bears between its pin and a
        cross that stands still.
        """
        if not ENDS[ends].hinged:
            return super().joint_critical(elastic, sizes, ends, direction)
        p = number(self.offset(sizes))
        found = pivot_critical(elastic, sizes, p, self.blade_angles, ends, direction)
        if found.error is None:
            return found
        part = EFFECTIVE_LENGTH["clamped-pinned"] * max(self.crossing, 1.0 - self.crossing)
        low, high = found.error
        return found._replace(error=ErrorRange(low, (1.0 + high) / part**2 - 1.0))

    def parasitic_shift(self, sizes: Blade, travel: float) -> Computed:
        """Return the signed shift of the centre along the bisector [m], leading order."""
        return joined.unseparated_shift(
            l=sizes.l, crossing=self.crossing, theta=travel, half_angle=self.half_angle
        )

    def indicators(self, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the quantities of its validity, with l/h of the shorter part."""
        part = smaller(self.crossing, 1.0 - self.crossing) * sizes.l / sizes.h
        return {**super().indicators(sizes, travel), "part l/h": part}

    def layout(self, elastic: Elastic, sizes: Blade) -> Layout:
        """Return four part-blades around the cross."""
        crossed, blades = self.crossed(sizes), []
        shared = crossing_reach(half_angle=self.half_angle) * sizes.h
        for index, angle in enumerate(self.blade_angles, 1):
            near, far = self.crossing * sizes.l, (1.0 - self.crossing) * sizes.l
            blades += [
                self.strip(
                    f"blade {index} base", (GROUND, CROSS), on_ray(angle, (-near, 0.0)), sizes
                ),
                self.strip(
                    f"blade {index} stage", (CROSS, MOVING), on_ray(angle, (0.0, far)), sizes
                ),
            ]
        ends = {GROUND: (0.0, shared), CROSS: (shared, 0.0)}
        blades = [replace(blade, crossed=crossed, shared=ends[blade.first]) for blade in blades]
        bodies = (Body(CROSS, (0.0, 0.0)), Body(MOVING, (0.0, 0.0)))
        return Layout(bodies, tuple(blades), elastic.E, elastic.shear)

    def values(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Value]:
        """Return stiffness and stroke relative to those of the same blades, separated."""
        same = {"E": elastic.E, "h": sizes.h, "l": sizes.l, "p": -0.5 * sizes.l}
        stiffer = self.stiffness(elastic, sizes) / pivot.rotational_stiffness(b=sizes.b, **same)
        stress, *_ = pivot.end_stresses(theta=1.0, **same)
        stroke = stress / self.end_stresses(elastic, sizes, 1.0)["crossing"]
        return {
            "stiffness_ratio": Value(
                number(stiffer), "", "stiffness over that of the same blades, separated"
            ),
            "stroke_ratio": Value(
                number(stroke), "", "stroke over that of the same blades, separated"
            ),
        }
