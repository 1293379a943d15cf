"""Parallel leaf-spring stage: equal parallel blades that guide a straight motion."""

from typing import Annotated, ClassVar, Literal

from pydantic import Field

from flexcli.formulas import stage
from flexcli.formulas.card import Card
from flexcli.formulas.quantity import Computed
from flexcli.mechanics.layout import Body, Layout
from flexcli.numerics.rows import number
from flexcli.parts.base import Length, PositiveLength
from flexcli.parts.bending import Bending, WideBlades
from flexcli.parts.bending.straight import Straight
from flexcli.parts.bending.wide import wide_guided
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import GROUND, MOVING, Blade, Critical
from flexcli.parts.geometries.blades import BladeGeometry
from flexcli.parts.geometries.joint_buckling import row_critical
from flexcli.parts.geometries.parallel import (
    SagsAlongStroke,
    force_share,
    is_push,
    lever,
    places,
    pulled_evenly,
)
from flexcli.results import Value

__all__ = ["LeafSpringStage"]


class LeafSpringStage(SagsAlongStroke, BladeGeometry):
    """n parallel blades between the base and a stage that moves across them."""

    motion: ClassVar[str] = "translation"
    also: ClassVar[tuple[str, ...]] = ("parallel-stage", "leaf-stage")
    source: ClassVar[str] = "Henein & Thalmann, Dimensioning of flexure joints"
    cards: ClassVar[tuple[Card, ...]] = stage.CARDS
    keeps_level: ClassVar[bool] = True

    kind: Literal["leaf-spring-stage"]
    blades: Annotated[int, Field(strict=True, ge=2, le=1000)] = 2
    """Number of equal blades, e.g. ``2``."""
    spacing: PositiveLength | None = None
    """Distance from each blade to the next, e.g. ``30 mm``."""
    drive: Length | None = None
    """Height where the stage is driven, along the blades from the base, e.g. ``10 mm``."""

    @property
    def blade_count(self) -> int:
        """Return the number of blades."""
        return self.blades

    def stiffness(self, elastic: Elastic, sizes: Blade) -> Computed:
        """Return the stiffness along the stroke [N/m]."""
        h, l, b = self.blade(sizes)
        return stage.translational_stiffness(E=elastic.E, h=h, l=l, b=b, blades=self.blades)

    def end_stresses(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the bending stress, equal and opposite at the two ends [Pa]."""
        return {"both ends": stage.end_stress(E=elastic.E, h=sizes.h, l=sizes.l, x=travel)}

    def bending(self, elastic: Elastic, sizes: Blade, travel: float) -> Bending:
        """Return the bending of guided blades."""
        h, l, _ = map(number, self.blade(sizes))
        return Straight(h=h, l=l, travel=travel, lever=lever(l, self.spacing))

    def wide_blades(self, sizes: Blade, nu: float) -> WideBlades | None:
        """Return the plate factors of guided blades."""
        found = wide_guided(sizes, nu)
        return pulled_evenly(found, sizes.h, self.spacing, fillet=self.fillet(sizes))

    def shift_change(self, sizes: Blade, pure: float, bent: float) -> float:
        """Return the change of shortening of blades bent to an S."""
        return bent

    def indicators(self, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the quantities of its validity: shape and stroke."""
        return {**self.ratios(sizes), "x/l": travel / sizes.l}

    def s_bending_share(self, sizes: Blade) -> float:
        """Return 1: the blades bend in an S alone."""
        return 1.0

    def clearances(self, sizes: Blade) -> tuple[tuple[str, Computed], ...]:
        """Return the room between neighbours."""
        if self.spacing is None:
            return ()
        return (("neighbouring blades", self.spacing - sizes.h),)

    def axial_share(self, direction: float) -> float:
        """Return the axial force in a blade per force on the stage along the blades [-]."""
        return force_share(direction, self.blades)

    def joint_critical(
        self, elastic: Elastic, sizes: Blade, ends: str, direction: float
    ) -> Critical:
        """Return the force along the blades at which the stage buckles [N]."""
        places = self.places() if self.spacing is not None else None
        push = is_push(direction, "blades")
        return row_critical(elastic, sizes, places, self.blades, ends, push=push)

    def parasitic_shift(self, sizes: Blade, travel: float) -> Computed:
        """Return the motion towards the base [m]."""
        return stage.shortening(l=sizes.l, x=travel)

    def places(self) -> tuple[float, ...]:
        """Return where the blades stand across the stage [m], about its middle."""
        return places(self.blades, self.spacing, "blade")

    def layout(self, elastic: Elastic, sizes: Blade) -> Layout:
        """Return the blades along x; the stage's point is at half their height."""
        l = sizes.l
        blades = tuple(
            self.strip(f"blade {index}", (GROUND, MOVING), ((0.0, y), (l, y)), sizes)
            for index, y in enumerate(self.places(), 1)
        )
        return Layout((Body(MOVING, (l / 2.0, 0.0)),), blades, elastic.E, elastic.shear)

    def values(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Value]:
        """Return the rotation by the drive at full stroke, and the drive height without it."""
        if self.drive is None or self.spacing is None:
            return {}
        h, l, b = self.blade(sizes)
        turn = stage.drive_rotation(
            E=elastic.E, h=h, l=l, b=b, places=self.places(), drive=self.drive, x=travel
        )
        return {
            "phi_drive": Value(number(turn), "rad", "rotation of the stage at full stroke"),
            "drive_best": Value(number(l) / 2.0, "m", "drive height that does not turn the stage"),
        }
