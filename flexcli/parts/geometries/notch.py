"""Notch hinges: short thin places of a body that turns about their throat."""

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Final, Literal, NamedTuple, cast

import numpy as np
from pydantic import Field, GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema

from flexcli.formulas import fillet, hinge_shift, notch, notch_compliance, thick_notch
from flexcli.formulas.card import Card, Range
from flexcli.formulas.profile import Filleted, Notch, Profile, per_design
from flexcli.formulas.quantity import Computed, Numbers, Quantity
from flexcli.formulas.thick_notch import Blocks as BesideNotch
from flexcli.mechanics.layout import Blade as Strip
from flexcli.mechanics.layout import Body, Layout
from flexcli.numerics.rows import larger, number, one_by_one
from flexcli.parts.base import Part, QuantityOf, spec_error
from flexcli.parts.bending import Bending, Thick, WideBlades, thick
from flexcli.parts.bending.arc import Arc
from flexcli.parts.bending.wide import middle_bears
from flexcli.parts.bending.wide_notch import wide_notch
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import (
    GROUND,
    MOVING,
    Extent,
    Geometry,
    NeckSizes,
    Solids,
)
from flexcli.parts.geometries.parallel import straight_share
from flexcli.results import Value

if TYPE_CHECKING:
    from flexcli.mechanics.space.layout import SpaceBlade, SpaceLayout

__all__ = [
    "CONCENTRATION",
    "CircularHinge",
    "Concentration",
    "EllipticHinge",
    "FilletedHinge",
    "NotchGeometry",
    "fillet_peaks",
    "throat_factor",
    "throat_peaks",
]

Concentration = Literal["deep-notch", "none"]
"""How the peak of the stress in a throat over the nominal 6M/(b e²) is counted."""

CONCENTRATION: Concentration = "deep-notch"

MASSIVE: Final = "massive"

SOURCE = "Paros & Weisbord 1965, Machine Design 37; Neuber 1958 for the peak of the stress"


def throat_factor(way: Concentration, e: Quantity, r: Quantity) -> Computed:
    """Return K_t by Neuber's deep notch of radius r, or 1 for the nominal stress."""
    return 1.0 if way == "none" else notch.bending_factor(e=e, r=r)


def throat_peaks(way: Concentration, e: Quantity, r: Quantity) -> tuple[Computed, Computed]:
    """Return the factors of the peak over the nominal stress in bending and along the hinge."""
    along = 1.0 if way == "none" else notch.axial_factor(e=e, r=r)
    return throat_factor(way, e, r), along


def fillet_peaks(
    way: Concentration, *, h: Numbers, l: Numbers, r: Numbers
) -> tuple[Computed, Computed]:
    """Return the factors where fillets begin, or 1 for the nominal stress."""
    if way == "none":
        return 1.0, 1.0
    return fillet.bending_factor(h=h, l=l, r=r), fillet.axial_factor(h=h, l=l, r=r)


class Blocks(Part):
    """The blocks beside a notch: massive, or as high as its mouth, with their length."""

    is_plain: ClassVar[bool] = True

    length: Annotated[float, QuantityOf("length", at_least=0.0)] | None = None

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any) -> Any:
        if data == MASSIVE:
            return {}
        if isinstance(data, str) and data.strip().isalpha():
            raise spec_error(f"'{data}' is not a length", "write 5 mm, or massive")
        return {"length": data}

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return {"anyOf": [QuantityOf("length", at_least=0.0).json_schema(), {"const": MASSIVE}]}

    @property
    def beside(self) -> BesideNotch:
        """Return the blocks in the form that formulas take."""
        return MASSIVE if self.length is None else self.length


class NotchGeometry(Geometry):
    """One hinge between the base and a body that turns about its throat."""

    motion: ClassVar[str] = "rotation"
    source: ClassVar[str] = SOURCE
    posynomial: ClassVar[bool] = False
    solids: ClassVar[Solids | None] = "notch"
    told_across_width: ClassVar[bool] = False

    concentration: Concentration = Field(CONCENTRATION, alias="stress-concentration")
    """How the peak of the stress in a throat counts: by Neuber's deep notch, of fillets by their
    own factor, or not at all, e.g. ``none``.
    """

    blocks: Blocks | None = None
    """What the notch is cut into on either side: blocks as high as its mouth, of a length up to
    the rigid bodies behind them, 0 mm where the mouth itself is clamped; or massive ones, at least
    twice as high within half the height of the mouth. Left out, any of these, e.g. ``5 mm``.
    """

    @property
    def unstated(self) -> tuple[str, ...]:
        """Return the key of the blocks where they are unstated."""
        return () if self.blocks is not None else ("blocks",)

    @property
    def _beside(self) -> BesideNotch:
        return self.blocks.beside if self.blocks is not None else None

    @abstractmethod
    def profile(self, sizes: Any) -> tuple[Profile, Computed]:
        """Return the thickness along the hinge and its length [m]."""

    @abstractmethod
    def throat(self, sizes: Any) -> tuple[Computed, Computed]:
        """Return thickness of the throat and radius of the notch there [m]."""

    def _column(self, sizes: Any) -> tuple[Profile, Computed]:
        """Return the profile of each design, with a trailing axis along the hinge, and length."""
        profile, l = self.profile(
            sizes._make(np.asarray(size, dtype=np.float64)[..., None] for size in sizes)
        )
        return profile, np.asarray(l, dtype=np.float64)[..., 0]

    def _neck(
        self, e: Computed, depth: Computed, l: Computed, b: Computed, straight: Computed = 0.0
    ) -> NeckSizes:
        """Return a neck of these sizes with the blocks beside it."""
        e, depth, l, beside = number(e), number(depth), number(l), self._beside
        blocks = (beside,) if isinstance(beside, float) else (0.0, e + 2.0 * depth)
        turning = blocks
        if isinstance(beside, str):
            turning = thick_notch.massive_bars(e=e, depth=depth, l=l)
        has_peaks = self.concentration != "none"
        return NeckSizes(e, depth, l, number(b), number(straight), blocks, turning, has_peaks)

    def compliance(self, elastic: Elastic, sizes: Any) -> Computed:
        """Return the planar compliance about the middle of the hinge, without shear."""
        profile, length = self._column(sizes)
        return notch_compliance.planar_compliance(
            profile, E=elastic.E, l=length, b=sizes.b, a=length / 2.0
        )

    def stiffness(self, elastic: Elastic, sizes: Any) -> Computed:
        """Return the rotational stiffness, by the exact integral [N·m/rad]."""
        return 1.0 / self.compliance(elastic, sizes)[..., 2, 2]

    def end_stresses(self, elastic: Elastic, sizes: Any, travel: float) -> dict[str, Computed]:
        """Return the bending stress in the throat [Pa]."""
        e, _ = self.throat(sizes)
        stress = notch.throat_stress(
            K=self.stiffness(elastic, sizes), b=sizes.b, e=e, theta=travel,
            factor=self.peaks(sizes)[0],
        )  # fmt: skip
        return {"throat": stress}

    def peaks(self, sizes: Any) -> tuple[Computed, Computed]:
        """Return the stress concentration factors of its shape in bending and along it."""
        return throat_peaks(self.concentration, *self.throat(sizes))

    def radii(self, sizes: Any) -> dict[str, Computed]:
        """Return the radius of its throat, or of its fillets."""
        return {"the throat": self.throat(sizes)[1]}

    def bending(self, elastic: Elastic, sizes: Any, travel: float) -> Bending:
        """Return the bending of an arc: the moment is constant."""
        return Arc(theta=travel)

    def wide_blades(self, sizes: Any, nu: float) -> WideBlades | None:
        """Return the plate factors of the throat."""
        profile, length = self.profile(sizes._make(map(number, sizes)))
        throat, turn = self.throat(sizes)[0], self.stiffness(Elastic(1.0), sizes)
        return wide_notch(nu, profile, throat=throat, length=length, b=sizes.b, turn=turn)

    def turn(self, sizes: Any) -> float:
        """Return the rotational stiffness of the beam at E b = 1 [m²]."""
        return number(self.stiffness(Elastic(1.0), sizes)) / number(sizes.b)

    def axial_share(self, direction: float) -> float:
        """Return 1: a force along the hinge acts in the throat as a whole."""
        return straight_share(direction, "axis")

    def axial_stress(self, force: float, sizes: Any) -> Computed:
        """Return N/(e b) in the throat, with the peak beside the notches [Pa]."""
        return force / (self.throat(sizes)[0] * sizes.b) * self.peaks(sizes)[1]

    def indicators(self, sizes: Any, travel: float) -> dict[str, Computed]:
        """Return the quantities of its validity: shape and rotation."""
        return {**self.ratios(sizes), "theta": travel}

    def parasitic_shift(self, sizes: Any, travel: float) -> Computed:
        """Return the shift of the middle along the hinge: away from the base [m]."""
        profile, l = self._column(sizes)
        return -hinge_shift.profile_shift(profile, l=l, theta=travel)

    def slenderness(self, sizes: Any) -> float | None:
        """Return thickness of the throat over length of the hinge [-]."""
        return number(self.throat(sizes)[0]) / self.length(sizes)

    def length(self, sizes: Any) -> float:
        """Return the length of the hinge [m]."""
        return number(self.profile(sizes)[1])

    def layout(self, elastic: Elastic, sizes: Any) -> Layout:
        """Return the hinge along x, its middle in the origin."""
        profile, _ = self.profile(sizes._make(per_design(size) for size in sizes))
        _, l = self.profile(sizes)
        strip = Strip(
            "hinge", GROUND, MOVING, (-l / 2.0, 0.0), (l / 2.0, 0.0), profile, sizes.b,
            peak=self.peaks(sizes),
        )  # fmt: skip
        return Layout((Body(MOVING, (0.0, 0.0)),), (strip,), elastic.E, elastic.shear)

    def laid_in_space(self, elastic: Elastic, sizes: Any, density: float) -> "SpaceLayout":
        """Return the hinge in space, with the blocks that may be beside it."""
        layout, beside = super().laid_in_space(elastic, sizes, density), self._beside
        hinge = cast("SpaceBlade", layout.blades[0])
        profile, l = self.profile(sizes)
        # massive blocks give way less than bars as long as high
        blocks = (beside, beside) if isinstance(beside, float) else (0.0, profile.mouth(number(l)))
        return replace(layout, blades=(replace(hinge, blocks=blocks),))

    def values(self, elastic: Elastic, sizes: Any, travel: float) -> dict[str, Value]:
        """Return the stiffness along the hinge and the stress concentration factor."""
        C = self.compliance(elastic, sizes)
        factor, _ = self.peaks(sizes)
        return {
            "k_along": Value(number(1.0 / C[..., 0, 0]), "N/m", "stiffness along the hinge"),
            "K_t": Value(number(factor), "", "stress concentration factor in the throat"),
        }


class CircularSizes(NamedTuple):
    """Thickness of the throat, radius of the notches and width [m]."""

    e: Computed
    r: Computed
    b: Computed


class CircularHinge(NotchGeometry):
    """Right-circular notch hinge: two half-circles of radius r leave a throat of thickness e."""

    dimensions: ClassVar[type[Any]] = CircularSizes
    labels: ClassVar[Mapping[str, str]] = {
        "e": "throat thickness",
        "r": "notch radius",
        "b": "width",
    }
    also: ClassVar[tuple[str, ...]] = ("circular-hinge", "right-circular-hinge")
    cards: ClassVar[tuple[Card, ...]] = (
        notch.CARDS[0],
        *notch.CARDS[2:],
        *notch_compliance.CARDS,
        *notch.LAW_CARDS,
        *hinge_shift.CARDS,
        *notch.CONCENTRATION_CARDS,
    )
    validity: ClassVar[tuple[Range, ...]] = (
        Range("e/r", most=0.2, why="a thicker throat is no beam: `thick-notch` adds 7 % here"),
    )

    kind: Literal["notch-hinge"]
    e: Extent
    """Thickness of the throat, e.g. ``0.1 mm``."""
    r: Extent
    """Radius of the notches, e.g. ``2 mm``."""
    b: Extent
    """Width, across the plane of the motion, e.g. ``10 mm``."""

    def profile(self, sizes: CircularSizes) -> tuple[Profile, Computed]:
        """Return two half-circles."""
        return Notch(sizes.e, sizes.r), 2.0 * sizes.r

    def throat(self, sizes: CircularSizes) -> tuple[Computed, Computed]:
        """Return e and r."""
        return sizes.e, sizes.r

    def stiffness(self, elastic: Elastic, sizes: CircularSizes) -> Computed:
        """Return the rotational stiffness, by the exact integral in closed form [N·m/rad]."""
        return notch.circular_stiffness(E=elastic.E, b=sizes.b, e=sizes.e, r=sizes.r)

    def thick_notches(self, sizes: CircularSizes) -> Thick | None:
        """Return the factor of its throat."""
        e, r, _ = sizes
        at = {"e": e, "depth": r, "l": 2.0 * r, "turn": self.turn(sizes)}
        return thick.thick_notch(**at, blocks=self._beside)

    def neck(self, sizes: CircularSizes) -> NeckSizes:
        """Return two half-circles."""
        return self._neck(sizes.e, sizes.r, 2.0 * sizes.r, sizes.b)

    def volume(self, sizes: CircularSizes) -> Computed:
        """Return the volume between the notches [m³]."""
        return sizes.b * (2.0 * sizes.r * (sizes.e + 2.0 * sizes.r) - np.pi * sizes.r**2)

    def ratios(self, sizes: CircularSizes) -> dict[str, Computed]:
        """Return e/r and b/e."""
        return {"e/r": sizes.e / sizes.r, "b/e": sizes.b / sizes.e}


class EllipticSizes(NamedTuple):
    """Thickness of the throat, depth and length of the notches, width [m]."""

    e: Computed
    depth: Computed
    l: Computed
    b: Computed


class EllipticHinge(NotchGeometry):
    """Elliptic notch hinge: two half-ellipses of a depth leave a throat of thickness e."""

    dimensions: ClassVar[type[Any]] = EllipticSizes
    labels: ClassVar[Mapping[str, str]] = {
        "e": "throat thickness",
        "depth": "notch depth",
        "l": "hinge length",
        "b": "width",
    }
    cards: ClassVar[tuple[Card, ...]] = (notch.CARDS[1], *notch.CARDS[2:])
    validity: ClassVar[tuple[Range, ...]] = (
        Range("e/radius", most=0.2, why="where the throat is as thick as its curve, no beam"),
    )

    kind: Literal["elliptic-hinge"]
    e: Extent
    """Thickness of the throat, e.g. ``0.1 mm``."""
    depth: Extent
    """Depth of the notches, half an axis of the ellipse, e.g. ``2 mm``."""
    l: Extent
    """Length of the hinge, the other axis of the ellipse, e.g. ``6 mm``."""
    b: Extent
    """Width, across the plane of the motion, e.g. ``10 mm``."""

    def profile(self, sizes: EllipticSizes) -> tuple[Profile, Computed]:
        """Return two half-ellipses."""
        return Notch(sizes.e, sizes.depth), sizes.l

    def throat(self, sizes: EllipticSizes) -> tuple[Computed, Computed]:
        """Return e and the radius of curvature (l/2)²/depth."""
        return sizes.e, sizes.l**2 / (4.0 * sizes.depth)

    def stiffness(self, elastic: Elastic, sizes: EllipticSizes) -> Computed:
        """Return the rotational stiffness, by the exact integral in closed form [N·m/rad]."""
        e, depth, l, b = sizes
        return notch.elliptic_stiffness(E=elastic.E, b=b, e=e, l=l, depth=depth)

    def thick_notches(self, sizes: EllipticSizes) -> Thick | None:
        """Return the factor of its throat."""
        e, depth, l, _ = sizes
        at = {"e": e, "depth": depth, "l": l, "turn": self.turn(sizes)}
        return thick.thick_notch(**at, blocks=self._beside)

    def neck(self, sizes: EllipticSizes) -> NeckSizes:
        """Return two half-ellipses."""
        return self._neck(*sizes)

    def volume(self, sizes: EllipticSizes) -> Computed:
        """Return the volume between the notches [m³]."""
        e, depth, l, b = sizes
        return b * l * (e + 2.0 * depth - np.pi / 2.0 * depth)

    def ratios(self, sizes: EllipticSizes) -> dict[str, Computed]:
        """Return e over the throat's radius, and b/e."""
        e, r = self.throat(sizes)
        return {"e/radius": e / r, "b/e": sizes.b / sizes.e}


class FilletedSizes(NamedTuple):
    """Thickness, radius of the fillets, length over all and width [m]."""

    h: Computed
    r: Computed
    l: Computed
    b: Computed


class FilletedHinge(NotchGeometry):
    """Corner-filleted hinge: a blade of thickness h whose roots are quarter circles of radius r."""

    dimensions: ClassVar[type[Any]] = FilletedSizes
    labels: ClassVar[Mapping[str, str]] = {
        "h": "thickness",
        "r": "fillet radius",
        "l": "hinge length, with the fillets",
        "b": "width",
    }
    cards: ClassVar[tuple[Card, ...]] = notch.CARDS[2:]
    validity: ClassVar[tuple[Range, ...]] = (
        Range("2r/l", most=1.0, why="the fillets are longer than the hinge"),
        Range("l/h", least=5.0, why="a stubby hinge is no beam"),
    )

    kind: Literal["filleted-hinge"]
    h: Extent
    """Thickness between the fillets, e.g. ``0.1 mm``."""
    r: Extent
    """Radius of the fillets, e.g. ``0.5 mm``."""
    l: Extent
    """Length of the hinge with its fillets, e.g. ``5 mm``."""
    b: Extent
    """Width, across the plane of the motion, e.g. ``10 mm``."""

    @model_validator(mode="after")
    def _fillets_fit(self) -> "FilletedHinge":
        fillet, whole = self.r.fixed, self.l.fixed
        if fillet is not None and whole is not None and 2.0 * fillet > whole:
            raise spec_error("two fillets are longer than the hinge", "r is at most l/2", at=("r",))
        return self

    def profile(self, sizes: FilletedSizes) -> tuple[Profile, Computed]:
        """Return the blade with its fillets, which end at its middle at the latest."""
        return Filleted(sizes.h, np.minimum(sizes.r, sizes.l / 2.0)), sizes.l

    def throat(self, sizes: FilletedSizes) -> tuple[Computed, Computed]:
        """Return h and r, at the start of a fillet."""
        return sizes.h, sizes.r

    def peaks(self, sizes: FilletedSizes) -> tuple[Computed, Computed]:
        """Return those of its fillets."""
        return fillet_peaks(self.concentration, h=sizes.h, l=sizes.l, r=sizes.r)

    def peaks_above(self, sizes: FilletedSizes) -> tuple[Computed, Computed]:
        """Return what those of its fillets may be less, on bars too unless blocks are massive."""
        if self.concentration == "none":
            return 0.0, 0.0
        above = partial(fillet.factors_above, bars=self._beside != MASSIVE)
        bent, along = one_by_one(above, sizes.h, sizes.l, sizes.r)
        return bent, along

    def thick_notches(self, sizes: FilletedSizes) -> Thick | None:
        """Return the factor of its fillets."""
        at = {"h": sizes.h, "r": sizes.r, "l": sizes.l, "turn": self.turn(sizes)}
        return thick.thick_fillets(**at, blocks=self._beside)

    def wide_blades(self, sizes: FilletedSizes, nu: float) -> WideBlades | None:
        """Return the factors of its blade, whose fillets bear more, as in the middle of a clamp."""
        found = super().wide_blades(sizes, nu)
        if found is None:
            return None
        h, r, l, b = map(number, sizes)
        more, wider = middle_bears(h, r, l, b, nu), found.stiffness.high - 1.0
        high = larger(found.stress.high, 1.0 + more)
        # what bends it to an S raises the middle of its fillets no more than a moment
        pulled = larger(found.pulled, more / wider) if wider > 0.0 else found.pulled
        return found._replace(stress=found.stress._replace(high=high), pulled=pulled)

    def neck(self, sizes: FilletedSizes) -> NeckSizes:
        """Return two halves of a half-circle, apart by the straight blade."""
        h, r, l, b = sizes
        return self._neck(h, r, 2.0 * r, b, l - 2.0 * r)

    def volume(self, sizes: FilletedSizes) -> Computed:
        """Return the volume of the blade and its fillets [m³]."""
        h, r, l, b = sizes
        return b * (l * h + 4.0 * r**2 * (1.0 - np.pi / 4.0))

    def fits(self, sizes: FilletedSizes) -> tuple[tuple[str, Computed, Computed], ...]:
        """Return that the fillets fit in the hinge."""
        return (("two fillets in the hinge, 2 r ≤ l", 2.0 * sizes.r, sizes.l),)

    def ratios(self, sizes: FilletedSizes) -> dict[str, Computed]:
        """Return l/h, b/h and the share of the fillets in the length."""
        h, r, l, b = sizes
        return {"l/h": l / h, "b/h": b / h, "2r/l": 2.0 * r / l}
