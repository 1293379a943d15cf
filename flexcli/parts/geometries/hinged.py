"""Stages and pivots of rigid limbs that have a right-circular notch hinge at each end."""

from collections.abc import Mapping
from dataclasses import replace
from math import pi
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, NamedTuple, cast

import numpy as np
from pydantic import Field, model_validator

from flexcli.formulas import hinge_shift, hinged_pivot, hinged_stage, notch
from flexcli.formulas.card import Card, Range
from flexcli.formulas.notch_compliance import bending_reach, circular_compliance
from flexcli.formulas.profile import Notch, per_design
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.formulas.thick_notch import Blocks as BesideNotch
from flexcli.formulas.thick_notch import massive_bars
from flexcli.mechanics.layout import Blade as Strip
from flexcli.mechanics.layout import Body, Layout, Point
from flexcli.numerics.rows import cos, larger, number, sin, smaller, tan
from flexcli.parts.base import (
    Inertia,
    Length,
    Mass,
    Part,
    PositiveLength,
    QuantityOf,
    spec_error,
)
from flexcli.parts.bending import Bending, Thick, WideBlades
from flexcli.parts.bending.limbs import Hinge, LimbPivot, LimbStage
from flexcli.parts.bending.thick_limbs import thick_limb_pivot, thick_limb_stage
from flexcli.parts.bending.wide_notch import wide_notch
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import (
    GROUND,
    MOVING,
    Extent,
    Geometry,
    LimbSpan,
    NeckSizes,
    Solids,
)
from flexcli.parts.geometries.notch import (
    CONCENTRATION,
    Blocks,
    Concentration,
    throat_factor,
    throat_peaks,
)
from flexcli.parts.geometries.parallel import SagsAlongStroke, force_share, places
from flexcli.results import Value

if TYPE_CHECKING:
    from flexcli.mechanics.space.layout import SpaceBlade, SpaceLayout

__all__ = ["HingedPivot", "HingedStage"]


class LimbSizes(NamedTuple):
    """Throat and radius of a hinge, distance between the hinges of a limb, width [m]."""

    e: Computed
    r: Computed
    l: Computed
    b: Computed


class Limb(Part):
    """The rigid part between the two hinges of a limb, with half of each hinge."""

    mass: Mass
    """Mass of a limb, e.g. ``4 g``."""
    inertia: Inertia
    """Moment of inertia about its centre of mass, around the axis of the plane,
    e.g. ``2e-7 kg*m^2``.
    """
    com: PositiveLength | None = None
    """Distance of its centre of mass from the inner hinge; left out, half way to the outer one,
    e.g. ``com: 8 mm, mass: 4 g, inertia: 2e-7 kg*m^2``.
    """


class _Hinged(Geometry):
    swaying: ClassVar[tuple[str, ...]] = ()
    """Ends of a case by which its limbs sway as they buckle."""
    source: ClassVar[str] = "Henein & Thalmann, Dimensioning of flexure joints; Paros & Weisbord"
    dimensions: ClassVar[type[Any]] = LimbSizes
    labels: ClassVar[Mapping[str, str]] = {
        "e": "throat thickness",
        "r": "notch radius",
        "l": "distance between the hinges of a limb",
        "b": "width",
    }
    validity: ClassVar[tuple[Range, ...]] = (
        Range("e/r", most=0.2, why="a thicker throat is no beam: `thick-notch` adds 7 % here"),
        Range("2r/l", most=1.0, why="the hinges of a limb overlap"),
    )
    posynomial: ClassVar[bool] = False
    solids: ClassVar[Solids | None] = "limbs"
    told_across_width: ClassVar[bool] = False

    e: Extent
    """Thickness of the throats, e.g. ``0.1 mm``."""
    r: Extent
    """Radius of the notches, e.g. ``1 mm``."""
    l: Extent
    """Distance between the hinges of a limb, throat to throat, e.g. ``20 mm``."""
    b: Extent
    """Width, across the plane of the motion, e.g. ``10 mm``."""
    concentration: Concentration = Field(CONCENTRATION, alias="stress-concentration")
    """How the peak of the stress in a throat counts: Neuber's deep notch, or not at all,
    e.g. ``none``.
    """
    blocks: Blocks | None = None
    """What the outer sides of the hinges are cut into: blocks as high as the mouths of the notches,
    of a length up to the rigid bodies behind them, 0 mm where the mouths themselves are clamped; or
    massive ones, at least twice as high within half the height of the mouth. The limb is then a bar
    as high as the mouths. Left out, blocks and limb are anything from rigid to that, e.g. ``5 mm``.
    """
    limb: Limb | None = None
    """Mass of each limb, which frequencies and vibration turn on; left out, nobody knows it,
    e.g. ``{mass: 4 g, inertia: 2e-7 kg*m^2}``.
    """

    @model_validator(mode="after")
    def _hinges_fit(self) -> "_Hinged":
        radius, limb = self.r.fixed, self.l.fixed
        if radius is not None and limb is not None and 2.0 * radius > limb:
            raise spec_error("the hinges of a limb overlap", "r is at most l/2", at=("r",))
        return self

    @property
    def unstated(self) -> tuple[str, ...]:
        """Return the keys that a layout lacks, and that of the blocks where they are unstated."""
        return (*super().unstated, *(() if self.blocks is not None else ("blocks",)))

    @property
    def _beside(self) -> BesideNotch:
        return self.blocks.beside if self.blocks is not None else None

    def hinge(self, elastic: Elastic, sizes: LimbSizes) -> tuple[Computed, Computed]:
        """Return stiffness of a hinge [N·m/rad] and reach of its bending about its centre [m]."""
        C = circular_compliance(E=elastic.E, b=sizes.b, e=sizes.e, r=sizes.r)
        return 1.0 / C.turn, bending_reach(across=C.across, turn=C.turn)

    def neck(self, sizes: LimbSizes) -> NeckSizes:
        """Return two half-circles at either end of a limb, with the blocks outside them."""
        e, r, l, b = map(number, sizes)
        beside = self._beside
        blocks = (beside,) if isinstance(beside, float) else (0.0, e + 2.0 * r)
        turning = blocks
        if isinstance(beside, str):
            turning = massive_bars(e=e, depth=r, l=2.0 * r)
        has_peaks = self.concentration != "none"
        limb = LimbSpan(l, beside is None)
        return NeckSizes(e, r, 2.0 * r, b, 0.0, blocks, turning, has_peaks, limb)

    def has_limbs(self, elastic: Elastic, sizes: LimbSizes) -> bool:
        """Return whether the mass of its limbs is unstated."""
        return self.limb is None

    @property
    def limb_count(self) -> int:
        """Return how many limbs it has."""
        return 2

    @property
    def own_mass(self) -> float:
        """Return the mass of all limbs [kg]."""
        return self.limb_count * self.limb.mass if self.limb is not None else 0.0

    @property
    def has_masses(self) -> bool:
        """Return whether its limbs have a stated mass."""
        return self.limb is not None

    def hinge_in_limbs(self, sizes: LimbSizes) -> Hinge:
        """Return a hinge in lengths of the limb."""
        e, r, l, _ = map(number, sizes)
        C = circular_compliance(E=1.0, b=1.0, e=e, r=r)
        stretch = number(C.along / C.turn) ** 0.5 / l
        return Hinge(
            reach=number(bending_reach(across=C.across, turn=C.turn)) / l,
            sheared=2.4**0.5 * stretch,
            stretch=stretch,
            spread=2.0 * number(hinge_shift.circular_shift(e=e, r=r, theta=1.0)) / l,
            throat=e / l,
            peak=e * r / l**2,
        )

    def wide_blades(self, sizes: LimbSizes, nu: float) -> WideBlades | None:
        """Return the plate factors of the throats."""
        e, r, l, b = map(number, sizes)
        turn, _ = self.hinge(Elastic(1.0), sizes)
        C = circular_compliance(E=1.0, b=1.0, e=e, r=r)
        # a force across the limb bends its hinges by a moment that is not the same all along
        reach = number(bending_reach(across=C.across, turn=C.turn)) / l
        at = {"throat": e, "length": 2.0 * r, "b": b, "turn": turn, "uneven": 4.0 * reach**2}
        return wide_notch(nu, Notch(e, r), **at, swaying=self.swaying)

    def radii(self, sizes: LimbSizes) -> dict[str, Computed]:
        """Return that of its notches."""
        return {"the notches": sizes.r}

    def throat_stress(self, sizes: LimbSizes, moment: Quantity) -> Computed:
        """Return the stress in a throat that bears a moment [Pa]."""
        factor = throat_factor(self.concentration, sizes.e, sizes.r)
        return notch.throat_stress(K=moment, b=sizes.b, e=sizes.e, theta=1.0, factor=factor)

    def hinges_volume(self, sizes: LimbSizes, hinges: int) -> Computed:
        """Return the volume between the notches of all hinges [m³]."""
        e, r, _, b = sizes
        return hinges * b * (2.0 * r * (e + 2.0 * r) - pi * r**2)

    def axial_stress(self, force: float, sizes: LimbSizes) -> Computed:
        """Return N/(e b) in a throat, with the peak beside the notches [Pa]."""
        _, along = throat_peaks(self.concentration, sizes.e, sizes.r)
        return force / (sizes.e * sizes.b) * along

    def fits(self, sizes: LimbSizes) -> tuple[tuple[str, Computed, Computed], ...]:
        """Return that the hinges of a limb do not overlap."""
        return (("two half hinges in a limb, 2 r ≤ l", 2.0 * sizes.r, sizes.l),)

    def ratios(self, sizes: LimbSizes) -> dict[str, Computed]:
        """Return e/r, b/e and the share of the hinges in a limb."""
        return {
            "e/r": sizes.e / sizes.r,
            "b/e": sizes.b / sizes.e,
            "2r/l": 2.0 * sizes.r / sizes.l,
        }

    def slenderness(self, sizes: LimbSizes) -> float | None:
        """Return e/(2r), thickness over length of a hinge [-]."""
        return number(sizes.e / (2.0 * sizes.r))

    def reach(self, sizes: LimbSizes) -> Computed:
        """Return how far a hinge bends about its centre over the length of a limb [-]."""
        return self.hinge(Elastic(1.0), sizes)[1] / sizes.l

    def laid_in_space(self, elastic: Elastic, sizes: LimbSizes, density: float) -> "SpaceLayout":
        """Return bodies and hinges in space, with what they are cut into on either side.

        Nothing on one side of a hinge gives way more than as much on both.
        """
        layout, (e, r, l, _) = super().laid_in_space(elastic, sizes, density), map(number, sizes)
        beside, limb, mouth = self._beside, l / 2.0 - r, e + 2.0 * r
        if isinstance(beside, float):
            blocks = (smaller(limb, beside), larger(limb, beside))
        else:  # as of a single notch, whether they are massive or not stated
            blocks = (0.0, larger(limb, mouth))
        hinges = (replace(cast("SpaceBlade", each), blocks=blocks) for each in layout.blades)
        return replace(layout, blades=tuple(hinges))

    def hinged_limb(
        self, name: str, start: Point, end: Point, sizes: LimbSizes
    ) -> tuple[Body, list[Strip]]:
        """Return a limb between two centres as a body, and its two hinges."""
        (x_0, y_0), (x_1, y_1) = start, end
        u, v = (x_1 - x_0) / sizes.l, (y_1 - y_0) / sizes.l
        body = Body(name, (x_0 + sizes.l / 2.0 * u, y_0 + sizes.l / 2.0 * v))
        if self.limb is not None:
            com = sizes.l / 2.0 if self.limb.com is None else self.limb.com
            place = (x_0 + com * u, y_0 + com * v)
            body = body._replace(mass=self.limb.mass, inertia=self.limb.inertia, com=place)
        r, profile = sizes.r, Notch(per_design(sizes.e), per_design(sizes.r))
        peak = throat_peaks(self.concentration, sizes.e, sizes.r)
        strips = [
            Strip(
                f"{name} {place}", first, second,
                (x - r * u, y - r * v), (x + r * u, y + r * v), profile, sizes.b,
                peak=peak,
            )
            for place, first, second, x, y in (
                ("inner hinge", GROUND, name, x_0, y_0),
                ("outer hinge", name, MOVING, x_1, y_1),
            )
        ]  # fmt: skip
        return body, strips


class HingedStage(SagsAlongStroke, _Hinged):
    """Parallel stage of n limbs with a notch hinge at each end (four hinges for two limbs)."""

    motion: ClassVar[str] = "translation"
    swaying: ClassVar[tuple[str, ...]] = ("clamped-guided", "clamped-free")
    cards: ClassVar[tuple[Card, ...]] = (*hinged_stage.CARDS, notch.CARDS[0], *notch.CARDS[2:])
    also: ClassVar[tuple[str, ...]] = ("four-hinge-stage",)

    kind: Literal["hinged-stage"]
    limbs: Annotated[int, Field(strict=True, ge=2, le=1000)] = 2
    """Number of equal limbs, e.g. ``2``."""
    spacing: PositiveLength | None = None
    """Distance from each limb to the next, e.g. ``30 mm``."""

    @property
    def limb_count(self) -> int:
        """Return the stated number of limbs."""
        return self.limbs

    def stiffness(self, elastic: Elastic, sizes: LimbSizes) -> Computed:
        """Return the stiffness along the stroke [N/m]."""
        K, c = self.hinge(elastic, sizes)
        return hinged_stage.translational_stiffness(K=K, l=sizes.l, c=c, limbs=self.limbs)

    def end_stresses(
        self, elastic: Elastic, sizes: LimbSizes, travel: float
    ) -> dict[str, Computed]:
        """Return the bending stress in the throats [Pa]."""
        force = self.stiffness(elastic, sizes) * travel / self.limbs
        return {"throats": self.throat_stress(sizes, force * sizes.l / 2.0)}

    def bending(self, elastic: Elastic, sizes: LimbSizes, travel: float) -> Bending:
        """Return the bending of parallel limbs."""
        return LimbStage(hinge=self.hinge_in_limbs(sizes), travel=travel / number(sizes.l))

    def thick_notches(self, sizes: LimbSizes) -> Thick | None:
        """Return the factors of limbs that bend like an S."""
        e, r, l, _ = sizes
        return thick_limb_stage(e=e, r=r, l=l, blocks=self._beside, swaying=self.swaying)

    def volume(self, sizes: LimbSizes) -> Computed:
        """Return the volume of the hinges [m³]; the limbs are bodies."""
        return self.hinges_volume(sizes, 2 * self.limbs)

    def clearances(self, sizes: LimbSizes) -> tuple[tuple[str, Computed], ...]:
        """Return the room between neighbours."""
        if self.spacing is None:
            return ()
        return (("neighbouring limbs", self.spacing - sizes.e - 2.0 * sizes.r),)

    def axial_share(self, direction: float) -> float:
        """Return the axial force in a limb per force on the stage along the limbs [-]."""
        return force_share(direction, self.limbs)

    def parasitic_shift(self, sizes: LimbSizes, travel: float) -> Computed:
        """Return the motion towards the base, x²/(2l) as of pins [m]."""
        return travel**2 / (2.0 * sizes.l)

    def indicators(self, sizes: LimbSizes, travel: float) -> dict[str, Computed]:
        """Return the quantities of its validity: shape and stroke."""
        return {**self.ratios(sizes), "x/l": travel / sizes.l, "c/l": self.reach(sizes)}

    def layout(self, elastic: Elastic, sizes: LimbSizes) -> Layout:
        """Return limbs along x between their hinges; the stage's point is at half their height."""
        bodies, strips = [], []
        for index, y in enumerate(places(self.limbs, self.spacing, "limb"), 1):
            body, hinges = self.hinged_limb(f"limb {index}", (0.0, y), (sizes.l, y), sizes)
            bodies.append(body)
            strips += hinges
        bodies.append(Body(MOVING, (sizes.l / 2.0, 0.0)))
        return Layout(tuple(bodies), tuple(strips), elastic.E, elastic.shear)

    def values(self, elastic: Elastic, sizes: LimbSizes, travel: float) -> dict[str, Value]:
        """Return the stiffness of one hinge."""
        K, _ = self.hinge(elastic, sizes)
        return {"k_hinge": Value(number(K), "N*m/rad", "rotational stiffness of a hinge")}


class HingedPivot(_Hinged):
    """RCC (δ ≥ 0) or cross pivot (δ < 0) of two limbs with a notch hinge at each end."""

    motion: ClassVar[str] = "rotation"
    cards: ClassVar[tuple[Card, ...]] = (*hinged_pivot.CARDS, notch.CARDS[0], *notch.CARDS[2:])
    also: ClassVar[tuple[str, ...]] = ("hinged-rcc", "hinged-cross")

    kind: Literal["hinged-pivot"]
    """Two limbs with a notch hinge at each end, e.g. ``kind: hinged-pivot, p: 5 mm``."""
    p: Length | None = None
    """Distance from the centre of rotation to the inner hinges, negative where the limbs cross,
    e.g. ``p: 5 mm, half_angle: 45 deg``.
    """
    delta: Annotated[float, QuantityOf("ratio")] | None = None
    """Place of the centre as p/l, in place of p, e.g. ``delta: 0.2, half_angle: 45 deg``."""
    half_angle: Annotated[float, QuantityOf("angle", above=0.0, below=pi / 2)]
    """Angle between each limb and the bisector, e.g. ``45 deg``."""

    @model_validator(mode="after")
    def _one_centre(self) -> "HingedPivot":
        if (self.p is None) == (self.delta is None):
            raise spec_error("the centre is placed by p or by delta", "give one, e.g. p: 2 mm")
        return self

    def offset(self, sizes: LimbSizes) -> Computed:
        """Return p [m], as given or as delta times the distance of the hinges."""
        return self.p if self.p is not None else self.delta * sizes.l

    def stiffness(self, elastic: Elastic, sizes: LimbSizes) -> Computed:
        """Return the rotational stiffness [N·m/rad]."""
        K, c = self.hinge(elastic, sizes)
        return hinged_pivot.rotational_stiffness(K=K, l=sizes.l, p=self.offset(sizes), c=c)

    def end_stresses(
        self, elastic: Elastic, sizes: LimbSizes, travel: float
    ) -> dict[str, Computed]:
        """Return the bending stress in the inner and the outer throats [Pa]."""
        K, _ = self.hinge(elastic, sizes)
        turns = hinged_pivot.hinge_rotations(l=sizes.l, p=self.offset(sizes), theta=travel)
        places = ("inner hinge", "outer hinge")
        return {
            place: self.throat_stress(sizes, K * turn)
            for place, turn in zip(places, turns, strict=True)
        }

    def bending(self, elastic: Elastic, sizes: LimbSizes, travel: float) -> Bending:
        """Return the bending of two limbs that point at one centre."""
        delta, hinge = number(self.offset(sizes) / sizes.l), self.hinge_in_limbs(sizes)
        return LimbPivot(hinge=hinge, delta=delta, theta=travel, half_angle=self.half_angle)

    def thick_notches(self, sizes: LimbSizes) -> Thick | None:
        """Return the factors of two limbs that point at one centre."""
        e, r, l, _ = sizes
        gamma = 1.0 + 2.0 * self.offset(sizes) / l
        at = {"gamma": gamma, "slope": tan(self.half_angle)}
        return thick_limb_pivot(e=e, r=r, l=l, **at, blocks=self._beside)

    def volume(self, sizes: LimbSizes) -> Computed:
        """Return the volume of the hinges [m³]; the limbs are bodies."""
        return self.hinges_volume(sizes, 4)

    def parasitic_shift(self, sizes: LimbSizes, travel: float) -> Computed:
        """Return the signed shift of the centre along the bisector [m]."""
        return hinged_pivot.parasitic_shift(
            l=sizes.l, p=self.offset(sizes), theta=travel, half_angle=self.half_angle
        )

    def indicators(self, sizes: LimbSizes, travel: float) -> dict[str, Computed]:
        """Return the quantities of its validity: shape, rotation, place of the centre."""
        delta = self.offset(sizes) / sizes.l
        c = self.reach(sizes)
        return {**self.ratios(sizes), "theta": travel, "delta": delta, "c/l": c}

    def layout(self, elastic: Elastic, sizes: LimbSizes) -> Layout:
        """Return two limbs that point at the origin."""
        p, bodies, strips = self.offset(sizes), [], []
        for name, angle in (("limb 1", self.half_angle), ("limb 2", -self.half_angle)):
            start, end = ((q * cos(angle), q * sin(angle)) for q in (p, p + sizes.l))
            body, hinges = self.hinged_limb(name, start, end, sizes)
            bodies.append(body)
            strips += hinges
        bodies.append(Body(MOVING, (0.0, 0.0)))
        return Layout(tuple(bodies), tuple(strips), elastic.E, elastic.shear)

    def values(self, elastic: Elastic, sizes: LimbSizes, travel: float) -> dict[str, Value]:
        """Return δ, the stiffness of a hinge, and the pivot's rotation per rotation of a hinge."""
        K, _ = self.hinge(elastic, sizes)
        p = self.offset(sizes)
        gain = hinged_pivot.admissible_rotation(gamma=1.0, l=sizes.l, p=p)
        return {
            "delta": Value(
                number(p / sizes.l), "", "place of the centre, p/l", estimated_error=0.0
            ),
            "k_hinge": Value(number(K), "N*m/rad", "rotational stiffness of a hinge"),
            "theta_per_gamma": Value(
                number(np.asarray(gain)), "", "rotation of the pivot over its most turned hinge"
            ),
        }
