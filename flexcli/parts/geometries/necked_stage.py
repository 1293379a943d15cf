"""Parallel stage on necked-down blades: a short thin hinge at each end of a thick middle."""

from collections.abc import Mapping
from math import inf
from typing import Annotated, Any, ClassVar, Literal, NamedTuple

import numpy as np
from pydantic import Field, model_validator

from flexcli.formulas import necked_buckling, necked_size, necked_stage
from flexcli.formulas.card import Card, Range
from flexcli.formulas.profile import NeckedDown, per_design
from flexcli.formulas.quantity import Computed
from flexcli.formulas.section import axial_stress
from flexcli.mechanics.layout import Blade as Strip
from flexcli.mechanics.layout import Body, Layout
from flexcli.numerics.rows import number
from flexcli.parts.base import PositiveLength, spec_error
from flexcli.parts.bending import Bending, WideBlades
from flexcli.parts.bending.straight import Necked
from flexcli.parts.bending.wide import wide_necks
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.ends import ENDS
from flexcli.parts.geometries.base import GROUND, MOVING, Blade, Critical, Extent
from flexcli.parts.geometries.blades import ClampedBlades
from flexcli.parts.geometries.joint_buckling import CARRIED, pulled_critical
from flexcli.parts.geometries.parallel import (
    SagsAlongStroke,
    force_share,
    is_push,
    lever,
    places,
    pulled_evenly,
)
from flexcli.results import ErrorRange, Value

__all__ = ["NeckedDownStage"]

SOURCE = "the beam's equation with a rigid middle"


class NeckedSizes(NamedTuple):
    """Thickness and length of a hinge, length and width of a whole blade [m]."""

    h: Computed
    l_c: Computed
    l: Computed
    b: Computed

    @property
    def xi(self) -> Computed:
        """Return ξ = 2 l_c/l."""
        return 2.0 * self.l_c / self.l


class NeckedDownStage(SagsAlongStroke, ClampedBlades):
    """n parallel blades of length l, each flexible over l_c at both ends: ξ = 2 l_c/l ≤ 1."""

    motion: ClassVar[str] = "translation"
    source: ClassVar[str] = "Henein & Thalmann, Dimensioning of flexure joints"
    dimensions: ClassVar[type[Any]] = NeckedSizes
    labels: ClassVar[Mapping[str, str]] = {
        "h": "hinge thickness",
        "l_c": "hinge length",
        "l": "blade length",
        "b": "blade width",
    }
    cards: ClassVar[tuple[Card, ...]] = (
        *necked_stage.CARDS,
        *necked_size.CARDS,
        *necked_buckling.CARDS,
    )
    validity: ClassVar[tuple[Range, ...]] = (
        Range("xi", most=1.0, why="two hinges make up at most the whole blade"),
        Range("l_c/h", least=5.0, why="a stubby hinge is no beam, and its roots give way as well"),
    )
    posynomial: ClassVar[bool] = False
    told_across_width: ClassVar[bool] = False

    kind: Literal["necked-down-stage"]
    h: Extent
    """Thickness of the hinges, e.g. ``0.1 mm``."""
    l_c: Extent
    """Length of a hinge, at each end of a blade, e.g. ``4 mm``."""
    l: Extent
    """Length of a whole blade, hinges and middle, e.g. ``40 mm``."""
    b: Extent
    """Width, across the plane of the motion, e.g. ``10 mm``."""
    blades: Annotated[int, Field(strict=True, ge=2, le=1000)] = 2
    """Number of equal blades, e.g. ``2``."""
    spacing: PositiveLength | None = None
    """Distance from each blade to the next, e.g. ``30 mm``."""

    @model_validator(mode="after")
    def _hinges_fit(self) -> "NeckedDownStage":
        hinge, whole = self.l_c.fixed, self.l.fixed
        if hinge is not None and whole is not None and 2.0 * hinge > whole:
            raise spec_error(
                "two hinges are longer than the blade", "l_c is at most l/2", at=("l_c",)
            )
        return self

    def stiffness(self, elastic: Elastic, sizes: NeckedSizes) -> Computed:
        """Return the stiffness along the stroke [N/m]."""
        return necked_stage.translational_stiffness(
            E=elastic.E, h=sizes.h, l=sizes.l, b=sizes.b, xi=sizes.xi, blades=self.blades
        )

    def end_stresses(
        self, elastic: Elastic, sizes: NeckedSizes, travel: float
    ) -> dict[str, Computed]:
        """Return the bending stress, equal and opposite at the two ends [Pa]."""
        stress = necked_stage.end_stress(E=elastic.E, h=sizes.h, l=sizes.l, x=travel, xi=sizes.xi)
        return {"both ends": stress}

    def bending(self, elastic: Elastic, sizes: NeckedSizes, travel: float) -> Bending:
        """Return the bending of guided blades that are stiff in the middle."""
        h, l, xi = number(sizes.h), number(sizes.l), number(sizes.xi)
        return Necked(h=h, l=l, travel=travel, xi=xi, lever=lever(l, self.spacing))

    def wide_blades(self, sizes: NeckedSizes, nu: float) -> WideBlades | None:
        """Return the plate factors of the hinges."""
        found = wide_necks(Blade(sizes.h, sizes.l_c, sizes.b), nu, l=sizes.l)
        return pulled_evenly(found, sizes.h, self.spacing, fillet=self.fillet(sizes))

    def volume(self, sizes: NeckedSizes) -> Computed:
        """Return the volume of the hinges [m³]; the middles are bodies."""
        return self.blades * 2.0 * sizes.h * sizes.l_c * sizes.b

    def fits(self, sizes: NeckedSizes) -> tuple[tuple[str, Computed, Computed], ...]:
        """Return that two hinges fit in a blade."""
        return (("two hinges in a blade, 2 l_c ≤ l", 2.0 * sizes.l_c, sizes.l),)

    def ratios(self, sizes: NeckedSizes) -> dict[str, Computed]:
        """Return ξ and the aspect ratios of a hinge."""
        return {
            "xi": sizes.xi,
            "l_c/h": sizes.l_c / sizes.h,
            "l/h": sizes.l / sizes.h,
            "b/h": sizes.b / sizes.h,
        }

    def indicators(self, sizes: NeckedSizes, travel: float) -> dict[str, Computed]:
        """Return the quantities of its validity: shape and stroke."""
        return {**self.ratios(sizes), "x/l": travel / sizes.l}

    def clearances(self, sizes: NeckedSizes) -> tuple[tuple[str, Computed], ...]:
        """Return the room between neighbours."""
        if self.spacing is None:
            return ()
        return (("neighbouring blades", self.spacing - sizes.h),)

    def axial_share(self, direction: float) -> float:
        """Return the axial force in a blade per force on the stage along the blades [-]."""
        return force_share(direction, self.blades)

    def axial_stress(self, force: float, sizes: NeckedSizes) -> Computed:
        """Return N/(h b) in a hinge [Pa]."""
        return axial_stress(force, sizes.h, sizes.b)

    def critical(self, elastic: Elastic, sizes: NeckedSizes, ends: str) -> tuple[Critical, ...]:
        """Return the load at which the hinges buckle across their thickness [N]."""
        forces = {
            "clamped-guided": necked_buckling.guided_critical_load,
            "clamped-clamped": necked_buckling.locked_critical_load,
        }
        if ends not in forces:
            raise NotAvailable(f"has no closed form for {ends} ends ({', '.join(forces)} only)")
        # hinges that do not fit are refused by their own shape; a search may still try them
        xi = np.minimum(sizes.xi, 1.0)
        force = forces[ends](E=elastic.E, h=sizes.h, l=sizes.l, b=sizes.b, xi=xi)
        return (Critical("across the thickness", force, f"{SOURCE}, {ends} ends"),)

    def joint_critical(
        self, elastic: Elastic, sizes: NeckedSizes, ends: str, direction: float
    ) -> Critical:
        """Return the force along the blades at which the stage buckles [N].

        Shear in the hinges lowers it by less than Engesser's N/κGA, their shortening raises it by
        less than their strain; a stage that may turn is kept upright by its blades' stretching.
        """
        hold, push = ENDS[ends], is_push(direction, "blades")
        if hold.hinged:
            raise NotAvailable("has no closed form for blades on hinges")
        if not (push or hold.turn):
            stand = None if self.spacing is None else places(self.blades, self.spacing, "blade")
            blade = Blade(sizes.h, sizes.l, sizes.b)
            xi = np.minimum(sizes.xi, 1.0)
            return pulled_critical(elastic, blade, stand, self.blades, ends, xi=number(xi))
        held = "clamped-clamped" if hold.across else "clamped-guided"
        (found,) = self.critical(elastic, sizes, held)
        source, stress = f"{SOURCE}, {hold.spoken}", 1.0 / (self.blades * sizes.h * sizes.b)
        if not push:
            error = ErrorRange(0.0, 0.0)
            return Critical("in the plane", inf, source, stress, error, CARRIED)
        strain = number(found.force) / (elastic.E * sizes.h * sizes.b)
        sheared = strain * 2.0 * (1.0 + elastic.most_nu) * 1.2
        known = ErrorRange(-sheared, strain) if hold.turn else None
        force = self.blades * found.force
        return Critical("in the plane", force, source, stress, known, CARRIED)

    def parasitic_shift(self, sizes: NeckedSizes, travel: float) -> Computed:
        """Return the motion towards the base [m]."""
        return necked_stage.shortening(l=sizes.l, x=travel, xi=sizes.xi)

    def slenderness(self, sizes: NeckedSizes) -> float | None:
        """Return thickness over length of a hinge [-]."""
        return number(sizes.h / sizes.l_c)

    def layout(self, elastic: Elastic, sizes: NeckedSizes) -> Layout:
        """Return the blades along x; the stage's point is at half their height."""
        h, l_c, l, b = sizes
        profile = NeckedDown(per_design(h), per_design(l_c))
        blades = tuple(
            Strip(f"blade {index}", GROUND, MOVING, (0.0, y), (l, y), profile, b)
            for index, y in enumerate(places(self.blades, self.spacing, "blade"), 1)
        )
        return Layout((Body(MOVING, (l / 2.0, 0.0)),), blades, elastic.E, elastic.shear)

    def values(self, elastic: Elastic, sizes: NeckedSizes, travel: float) -> dict[str, Value]:
        """Return ξ and the stiffness along the blades."""
        along = necked_stage.compression_stiffness(
            E=elastic.E, h=sizes.h, l=sizes.l, b=sizes.b, xi=sizes.xi, blades=self.blades
        )
        return {
            "xi": Value(
                number(sizes.xi), "", "share of the blade that bends, 2 l_c/l", estimated_error=0.0
            ),
            "k_along": Value(number(along), "N/m", "stiffness along the blades at rest"),
        }
