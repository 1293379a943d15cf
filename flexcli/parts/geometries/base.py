"""The interface of joints and stages: stiffness, stresses and loads in terms of the sizes."""

from abc import abstractmethod
from collections.abc import Mapping
from math import cos, inf, pi
from typing import TYPE_CHECKING, Any, ClassVar, Literal, NamedTuple, Self, TypeAlias

import numpy as np
from numpy.typing import NDArray
from pydantic import AliasPath, Field, GetJsonSchemaHandler, PrivateAttr, model_validator
from pydantic_core import CoreSchema

from flexcli.formulas.card import Card, Range, outside
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.numerics.rows import hypot, number
from flexcli.parts.base import Part, PositiveLength, QuantityOf, or_free, spec_error
from flexcli.parts.bending import Bending, CompliantClamps, FilletedRoots, Thick, WideBlades
from flexcli.parts.bending.unknown import NotEstimated
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.results import ErrorRange, QuantityKind, Value

if TYPE_CHECKING:
    from flexcli.mechanics.layout import Layout, Point
    from flexcli.mechanics.space.layout import SpaceLayout
    from flexcli.parts.material import Material

Floats = NDArray[np.float64]

THICKNESSES = ("h", "e", "d")
"""Symbols of sizes that are the thickness of what flexes."""

GROUND, MOVING = "ground", "moving"
"""Names of the base and of the moving body in every layout of a joint."""

PIECE = np.array([-1.0, 1.0])
"""Both ends of a piece of a profile."""

ROUNDING = 1e-9
"""Share of a blade's length that no piece covers, from which a part of it is rigid."""

RIGHT = 1e-9
"""Cosine of an angle that counts as a right one."""

BEAM_EFFECTS = {
    EffectName.PLATE_WIDENING: "plate",
    EffectName.ANTICLASTIC: "curling",
    EffectName.WARPING: "warping",
}
"""Effects of blades in space that a spec may leave out, by their names for beams."""

AT_REST = frozenset({QuantityKind.STIFFNESS, QuantityKind.FREQUENCY, QuantityKind.SAG})
"""Kinds of numbers that closed forms state at rest, whatever the travel."""

FOLLOWS = {
    QuantityKind.FREQUENCY: (QuantityKind.STIFFNESS,),
    QuantityKind.SAG: (QuantityKind.STIFFNESS,),
}
"""Kinds of numbers that follow from another: they are unknown where that one is."""

TRAVELS = frozenset({"theta", "x/l"})
"""Quantities whose range of validity the next order of a closed form extends."""

FORMULAS = (
    "axial_share", "axial_stress", "bending", "blade", "cards", "clearances", "critical",
    "end_stresses", "joint_critical", "keeps_level", "parasitic_shift", "s_bending_share",
    "sag_bends_width", "sag_stiffness", "stiffness", "stroke_stresses", "thick_notches",
    "twisting_bars", "validity", "values", "volume", "wide_blades",
)  # fmt: skip
"""Methods that state a joint's formulas, which hold for the body drawn by its own layout only."""

ACROSS_WIDTH = "across the width"
"""How a blade buckles out of the plane."""

__all__ = [
    "ACROSS_WIDTH",
    "BEAM_EFFECTS",
    "GROUND",
    "MOVING",
    "Blade",
    "Critical",
    "Extent",
    "Geometry",
    "Held",
    "LimbSpan",
    "NeckSizes",
    "RootedBlade",
    "Sizes",
    "TwistingBars",
]


class Blade(NamedTuple):
    """Dimensions of the equal blades: floats, arrays of many designs, or signomials [m]."""

    h: Computed
    l: Computed
    b: Computed


Held: TypeAlias = tuple[float | None, float | None, float | None]
"""Motion (x, y, φ) that a stroke imposes on the moving body; None where it is free."""

Sizes: TypeAlias = Any
"""A named tuple of the dimensions that sizing may choose, like :class:`Blade`."""


class Critical(NamedTuple):
    """A critical force [N], on one blade or on a joint: its buckling mode, and its source.

    ``stress`` is the largest axial stress in a blade per critical force [1/m²], ``error`` that of
    the force where it is known, ``carries`` the effects that it includes.
    """

    way: str
    force: Computed
    source: str
    stress: Computed | None = None
    error: ErrorRange | None = None
    carries: frozenset[EffectName] = frozenset()

    @property
    def elastic(self) -> Floats | None:
        """Return the axial stress at the force, as if nothing yielded [Pa]."""
        if self.stress is None:
            return None
        return np.asarray(self.force, np.float64) * np.asarray(self.stress, np.float64)


class RootedBlade(NamedTuple):
    """Dimensions of equal blades whose roots have fillets of a radius [m]."""

    h: Computed
    l: Computed
    b: Computed
    root_radius: Computed


class TwistingBars(NamedTuple):
    """Bars that turn with the body: ∫r² dV about their axis [m⁵], whether clamps hold warping."""

    polar: Computed
    restrained: bool


Solids: TypeAlias = Literal["notch", "limbs", "cross"]
"""What of a joint there are solids of."""


class CrossSizes(NamedTuple):
    """Two crossed blades of one piece [m]: thickness, length from end to end, width.

    They cross at a share of their length from the base, each at the half-angle from the bisector.
    """

    h: float
    l: float
    b: float
    crossing: float
    half_angle: float


class LimbSpan(NamedTuple):
    """The distance between the two throats of a limb [m], and whether it may be rigid between them.

    It is a bar as high as the mouths, rigid at most where the blocks are shortest.
    """

    l: float
    may_be_rigid: bool


class NeckSizes(NamedTuple):
    """A notch of constant width: two half-ellipses, apart by a straight stretch [m].

    ``blocks`` are the least and the greatest length that each block beside it may have, as high as
    its mouth and rigid at its end, or the one that it has; ``turning`` what these are where blocks
    of another shape give way as much under a moment about the axis of the notch. ``has_peaks`` says
    that the peak of its stress counts. Two such notches make a ``limb``, the blocks at its ends.
    """

    e: float
    depth: float
    l: float
    b: float
    straight: float
    blocks: tuple[float, ...]
    turning: tuple[float, ...]
    has_peaks: bool
    limb: LimbSpan | None = None


class Extent(Part):
    """A dimension of the blade: fixed, free, or free between bounds [m]."""

    is_plain: ClassVar[bool] = True

    fixed: PositiveLength | None = None
    least: PositiveLength | None = Field(None, validation_alias=AliasPath("free", 0))
    most: PositiveLength | None = Field(None, validation_alias=AliasPath("free", 1))

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any) -> Any:
        if data == "free":
            return {}
        if not isinstance(data, dict):
            if isinstance(data, str) and data.strip().isalpha():
                raise spec_error(f"'{data}' is not a length", "write 0.2 mm, or free")
            return {"fixed": data}
        if set(data) != {"free"} or not isinstance(data["free"], list) or len(data["free"]) != 2:
            raise spec_error(
                "a dimension is a length, 'free', or free between bounds",
                "write 0.2 mm, free, or {free: [0.1 mm, 1 mm]} (null where there is no bound)",
            )
        return data

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return or_free(QuantityOf("length", above=0.0))

    @model_validator(mode="after")
    def _in_order(self) -> "Extent":
        if self.least is not None and self.most is not None and self.least >= self.most:
            raise spec_error("the lower bound is not below the upper one", "write [least, most]")
        return self


LAYOUT_KEYS = ("spacing",)
"""Keys that a closed form does without, but no layout."""


class Geometry(Part):
    """A joint or stage whose sizes may be given or free.

    A class that draws a layout of its own states its own formulas, or names among its bases the
    classes that it takes them from, which draw nothing: formulas of another joint's body are not
    inherited. A formula that no class states is not available.
    """

    motion: ClassVar[str]
    source: ClassVar[str]
    dimensions: ClassVar[type[Any]]
    """The named tuple of its sizes; each names a field that is an :class:`Extent`."""
    labels: ClassVar[Mapping[str, str]]
    also: ClassVar[tuple[str, ...]] = ()
    """Other names by which ``explain`` finds it."""
    cards: ClassVar[tuple[Card, ...]] = ()
    """Its formulas, as ``explain`` prints them."""
    validity: ClassVar[tuple[Range, ...]] = ()
    """Where its closed forms hold, in terms of :meth:`ratios`."""
    extends: ClassVar[Mapping[str, float]] = {}
    """Factor by which a correction extends a formula's range of validity, by the range's
    quantity."""
    closed_forms: ClassVar[bool] = True
    """Whether it has closed forms at all; if not, the exact model judges it unless told
    otherwise."""
    posynomial: ClassVar[bool] = True
    """Whether its closed forms accept signomials."""
    is_linear: ClassVar[bool] = True
    """Whether its stresses grow in proportion to its travel."""
    strain: ClassVar[str] = "bending"
    """Name of its strain, bending or shear, in reports."""
    sag_bends_width: ClassVar[bool] = False
    """Whether its sag bends the blades across their width."""
    in_space: ClassVar[bool] = False
    """Whether it is drawn in space, where every load of a case acts on it; else in its plane."""
    solids: ClassVar[Solids | None] = None
    """What there are solids of: the single notch that it is, its limbs between two notches, or the
    whole of crossed blades."""
    joined_in: ClassVar[frozenset[str]] = frozenset()
    """Bodies of its layout that are but blades which meet."""
    told_across_width: ClassVar[bool] = True
    """Whether a formula tells what buckles its blades across their width."""
    has_plane: ClassVar[bool] = True
    """Whether forces bend it in a plane as its stroke does; bars along an axis only twist."""
    _omitted: frozenset[EffectName] = PrivateAttr(frozenset())

    turns_freely: ClassVar[bool] = False
    """Whether its formulas assume a body that turns freely as it moves, which a case may
    prevent."""
    held_by_one_blade: ClassVar[bool] = False
    """Whether nothing but one blade and the ends of a case hold its body out of its plane."""
    keeps_level: ClassVar[bool] = False
    """Whether its closed forms assume a body kept from turning, whatever the distance of its
    blades."""

    def __init_subclass__(cls, **options: Any) -> None:
        """Refuse formulas inherited from a joint that draws another body."""
        super().__init_subclass__(**options)
        if "layout" not in vars(cls):
            return
        named = {cls, Geometry}
        for base in cls.__bases__:
            if getattr(base, "layout", None) is Geometry.layout:
                named.update(base.__mro__)
        for formula in FORMULAS:
            owner = next(each for each in cls.__mro__ if formula in vars(each))
            if owner not in named:
                raise TypeError(
                    f"{cls.__name__} draws its own layout and inherits {formula} of "
                    f"{owner.__name__}: state it, or name a base without a layout that does"
                )

    @property
    def omitted(self) -> frozenset[EffectName]:
        """Return the effects left out of its formulas and its blades in space."""
        return self._omitted

    def omitting(self, effects: frozenset[EffectName]) -> Self:
        """Return it with exactly the named effects of ``BEAM_EFFECTS`` left out."""
        if effects == self._omitted:
            return self
        copied = self.model_copy()
        copied._omitted = effects
        return copied

    @property
    def name(self) -> str:
        """Return its kind."""
        return str(getattr(self, "kind", "geometry"))

    @property
    def extents(self) -> dict[str, Extent]:
        """Return the extents of the sizes by their symbols."""
        return {name: getattr(self, name) for name in self.dimensions._fields}

    @property
    def free(self) -> tuple[str, ...]:
        """Return the symbols of the sizes that sizing may choose."""
        return tuple(name for name, extent in self.extents.items() if extent.fixed is None)

    def label(self, name: str) -> str:
        """Return the name of a size, in words."""
        return self.labels[name]

    def place(self, name: str) -> tuple[str, ...]:
        """Return where a size stands in the spec."""
        return "geometry", name

    def dimension(self, name: str) -> str:
        """Return the dimension of a size."""
        return "length"

    def drawn(self, sizes: Sizes) -> tuple["Geometry", Sizes]:
        """Return it and its sizes as drawn at given values of its free parameters."""
        return self, sizes

    def in_the_middle(self) -> "Geometry":
        """Return it as drawn in the middle of the ranges of its free parameters."""
        return self

    def sized(self, values: Mapping[str, Quantity]) -> Sizes:
        """Return the sizes of given values by symbol; what is fixed stays so."""
        return self.dimensions(
            **{name: values.get(name, extent.fixed) for name, extent in self.extents.items()}
        )

    def probe(self) -> Sizes:
        """Return sizes to try on what a requirement asks for: 1 mm where they are free."""
        return self.sized(dict.fromkeys(self.free, 1e-3))

    @property
    def axes(self) -> float:
        """Return the angle from the layout's x to the x of cases and requirements [rad].

        That is the stroke of a stage, which the layout has along its y, and a pivot's bisector.
        """
        return 0.0 if self.motion == "rotation" else pi / 2.0

    @property
    def drawn_turn(self) -> float:
        """Return the angle from the layout's x to x as it is drawn [rad]."""
        return 0.0

    @property
    def moving_name(self) -> str:
        """Return the spec's name for the body that its layout calls ``moving``."""
        return MOVING

    @property
    def symmetry_axis(self) -> float:
        """Return the angle from the layout's x to where a load's direction is zero [rad]."""
        return 0.0

    @property
    def own_mass(self) -> float:
        """Return the mass of the bodies that the layout itself has [kg]."""
        return 0.0

    @property
    def has_masses(self) -> bool:
        """Return whether it draws bodies that have mass or inertia themselves."""
        return False

    @property
    def outlines(self) -> dict[str, NDArray[np.float64]]:
        """Return the corners of its bodies that have a stated outline, by name, (points, 3) [m].

        Names and places are those of its layout in space.
        """
        return {}

    @property
    def body_materials(self) -> dict[str, "Material"]:
        """Return the materials of its bodies that are not of that of the blades, by name."""
        return {}

    @property
    def travel_symbol(self) -> str:
        """Return the symbol of its travel in the names of values."""
        return "theta" if self.motion == "rotation" else "x"

    @property
    def travel_unit(self) -> str:
        """Return the SI unit of its travel."""
        return "rad" if self.motion == "rotation" else "m"

    @property
    def stiffness_unit(self) -> str:
        """Return the SI unit of the stiffness along the motion."""
        return "N*m/rad" if self.motion == "rotation" else "N/m"

    @abstractmethod
    def stiffness(self, elastic: Elastic, sizes: Sizes) -> Computed:
        """Return the stiffness along the motion [N·m/rad or N/m]."""

    @abstractmethod
    def end_stresses(self, elastic: Elastic, sizes: Sizes, travel: float) -> dict[str, Computed]:
        """Return the signed stress at each place that may be the worst [Pa], at a travel."""

    def stroke_stresses(
        self, elastic: Elastic, sizes: Sizes, amplitude: float, middle: float
    ) -> tuple[dict[str, Computed], dict[str, Computed]]:
        """Return amplitude and mean of the stress at each place [Pa]; no mean where it is zero.

        ``middle`` is that of the stroke from rest, with its sign.
        """
        return (
            self.end_stresses(elastic, sizes, amplitude),
            self.end_stresses(elastic, sizes, abs(middle)) if middle else {},
        )

    def joint_of(self, place: str) -> str:
        """Return the joint of a place of stress, where there are several."""
        return ""

    @abstractmethod
    def volume(self, sizes: Sizes) -> Computed:
        """Return the volume of what flexes [m³]."""

    @abstractmethod
    def ratios(self, sizes: Sizes) -> dict[str, Computed]:
        """Return the ratios of its shape, such as l/h and b/h, that can be bounded [-]."""

    def fits(self, sizes: Sizes) -> tuple[tuple[str, Computed, Computed], ...]:
        """Return pairs of lengths, the first no longer than the second in any real joint [m]."""
        return ()

    def thicknesses(self, sizes: Sizes) -> dict[str, Computed]:
        """Return the sizes that are thicknesses, by symbol [m]."""
        found: dict[str, Quantity] = sizes._asdict()
        return {name: x for name, x in found.items() if name.partition("_")[0] in THICKNESSES}

    def sections(self, sizes: Sizes) -> tuple[tuple[str, float, float], ...]:
        """Return the sections that flex: name, thickness and width [m]."""
        width = getattr(sizes, "b", None)
        if width is None:
            return ()
        return tuple(("", number(h), number(width)) for h in self.thicknesses(sizes).values())

    def radii(self, sizes: Sizes) -> dict[str, Computed]:
        """Return the inner radii of its outline by name, 0 for a sharp corner [m]."""
        return {}

    def clearances(self, sizes: Sizes) -> tuple[tuple[str, Computed], ...]:
        """Return the clearances between blades, with their names [m]."""
        return ()

    def axial_share(self, direction: float) -> float:
        """Return the largest axial force in a blade per force on the joint in its plane [-].

        ``direction`` [rad] is the angle of the force from the axis of symmetry.
        """
        raise NotAvailable("has no closed form for the axial force in its blades")

    def axial_stress(self, force: float, sizes: Sizes) -> Computed:
        """Return the largest axial stress of a force along one blade [Pa]."""
        raise NotAvailable("has no closed form for the axial stress")

    def critical(self, elastic: Elastic, sizes: Sizes, ends: str) -> tuple[Critical, ...]:
        """Return the axial forces that buckle one blade, whose ends are held as named."""
        raise NotAvailable("has no closed form for its buckling")

    def joint_critical(
        self, elastic: Elastic, sizes: Sizes, ends: str, direction: float
    ) -> Critical:
        """Return the force on the joint, in a direction [rad], at which it buckles at rest [N].

        The body is held as the ends of a case say (:data:`flexcli.parts.ends.ENDS`). Sizes are
        floats.
        """
        raise NotAvailable("has no closed form for the buckling of the whole joint")

    def blade(self, sizes: Sizes) -> Blade | None:
        """Return the slender blade that bends, where it is one of constant thickness."""
        return None

    def s_bending_share(self, sizes: Sizes) -> float:
        """Return the part of the stiffness that is S-shaped bending, which shear reduces [-]."""
        return 0.0

    def bending(self, elastic: Elastic, sizes: Sizes, travel: float) -> Bending:
        """Return the bending of its blades at a travel, for the effects left out.

        Unknown unless a joint gives it for its own formulas.
        """
        return NotEstimated(travel=travel)

    def is_known(self, elastic: Elastic, sizes: Sizes, travel: float, kind: QuantityKind) -> bool:
        """Return whether the error of a kind's closed form is known at a travel.

        It is not where the joint has no estimates, nor outside the formula's range of validity; a
        range of the travel is extended as far as its next order reaches.
        """
        bending = self.bending(elastic, sizes, travel)
        if not bending.is_estimate:
            return False
        reach = 0.0 if kind in AT_REST else travel
        return all(
            at
            <= (
                bending.travel_most
                if limits.quantity in TRAVELS
                else self.extends.get(limits.quantity, -inf)
            )
            for limits, at in self.outside_validity(sizes, reach, kind)
        )

    @abstractmethod
    def wide_blades(self, sizes: Sizes, nu: float) -> WideBlades | None:
        """Return the changes by the width of its blades, ν the material's Poisson's ratio or ½.

        None where no part of it bends across its thickness.
        """

    def neck(self, sizes: Sizes) -> NeckSizes:
        """Return the sizes of the notches of a joint of one or of limbs, and the blocks beside.

        Raises
        ------
        NotAvailable
            When it is anything else.

        """
        raise NotAvailable("has no notches, of which there are solids")

    @property
    def has_solids(self) -> bool:
        """Return whether there are solids of it, as its ends are."""
        return self.solids is not None

    def solid_cross(self, sizes: Sizes) -> CrossSizes:
        """Return the sizes of crossed blades of one piece.

        Raises
        ------
        NotAvailable
            When it is anything else.

        """
        raise NotAvailable("has no crossed blades of one piece, of which there are solids")

    def thick_notches(self, sizes: Sizes) -> Thick | None:
        """Return the changes by plane elasticity in its notch hinges, None where it has none."""
        return None

    def compliant_clamps(self, sizes: Sizes, nu: float) -> CompliantClamps | None:
        """Return the changes by the compliance of its blades' roots, None for rigid clamps."""
        return None

    def root_springs(self, sizes: Sizes, nu: float) -> Floats | None:
        """Return what its roots add to the compliances of its blades, None for rigid clamps.

        Times E, as :func:`flexcli.parts.bending.compliant_clamps.root_springs` has it.
        """
        return None

    def crossed(self, sizes: Sizes) -> tuple[Computed, Computed]:
        """Return the range of its blades' stiffness over beams' by being one piece, any way [-]."""
        return 1.0, 1.0

    @property
    def has_fillets(self) -> bool:
        """Return whether any of its blades has fillets at its roots."""
        return False

    def fillet(self, sizes: Sizes) -> Computed:
        """Return the radius of the fillets at the roots of all its blades, 0 for none [m]."""
        return 0.0

    def peaks_above(self, sizes: Sizes) -> tuple[Computed, Computed]:
        """Return by what share peaks of stress may be less than its factors say, bent and along."""
        return 0.0, 0.0

    def filleted(self, sizes: Sizes, nu: float) -> FilletedRoots | None:
        """Return the changes by fillets of its closed forms, None where these include them."""
        return None

    def joint_deflections(self, inputs: Floats) -> Mapping[str, tuple[str, Floats]]:
        """Return unit and deflections of every joint that an input moves [rad or m], by name.

        Empty where it is one joint. Links are taken as rigid.
        """
        return {}

    def with_compliant_clamps(self) -> "Geometry | None":
        """Return it cut from one piece with its bodies where the spec does not state its clamps."""
        return None

    @property
    def says_rigid(self) -> bool:
        """Return whether the spec says that its blades end in rigid clamps."""
        return False

    def has_blades_of(self, other: "Geometry") -> bool:
        """Return whether another has the same bodies and blades, whatever their end conditions."""
        if self is other:
            return True
        mine, theirs = self.with_compliant_clamps(), other.with_compliant_clamps()
        return (mine is None) != (theirs is None) and (mine == other or theirs == self)

    @property
    def unstated(self) -> tuple[str, ...]:
        """Return the optional keys that finer models need and the spec does not give."""
        return self.layout_lacks

    @property
    def has_blades(self) -> bool:
        """Return whether it has blades, not rods alone."""
        return True

    @property
    def layout_lacks(self) -> tuple[str, ...]:
        """Return the optional keys that a layout needs and closed forms do not."""
        return tuple(key for key in LAYOUT_KEYS if getattr(self, key, "") is None)

    def may_tilt(self, *, loaded: bool) -> bool:
        """Return whether blades at different heights may tilt its body, at a stroke or loaded."""
        return False

    def twisting_bars(self, sizes: Sizes) -> TwistingBars | None:
        """Return the bars whose torsion is its motion, where it has no other blades."""
        return None

    def parasitic_shift(self, sizes: Sizes, travel: float) -> Computed:
        """Return the parasitic motion at a travel [m], positive towards −x of the layout.

        It is that of a pivot's centre along the bisector, and of a stage's point along its
        blades; where the base is at the blades' start, that is towards the base.
        """
        raise NotAvailable("has no closed form for its parasitic shift")

    def sags_along_stroke(self, axis: str) -> bool:
        """Return whether a weight along an axis of cases bends it as its stroke does."""
        if self.motion == "rotation" or axis not in ("x", "y"):
            return False
        turn = self.axes + (pi / 2.0 if axis == "y" else 0.0)
        return abs(cos(turn)) < RIGHT

    def sag_stiffness(self, elastic: Elastic, sizes: Sizes, axis: str) -> Computed:
        """Return the stiffness against the weight of the moving body along an axis [N/m]."""
        raise NotAvailable(f"has no closed form for its stiffness along {axis}")

    def slenderness(self, sizes: Sizes) -> float | None:
        """Return thickness over length of the stockiest blade [-]."""
        blade = self.blade(sizes)
        return None if blade is None else number(blade.h / blade.l)

    def length(self, sizes: Sizes) -> float:
        """Return the length that a stroke is compared with [m]."""
        return number(sizes.l)

    def indicators(self, sizes: Sizes, travel: float) -> dict[str, Computed]:
        """Return the quantities of its closed forms' ranges of validity, at the largest travel."""
        return self.ratios(sizes)

    def ranges(self, kind: QuantityKind | None = None) -> tuple[Range, ...]:
        """Return the validity of its closed forms, for one kind of number or all.

        The ranges are its own and those that ``explain`` prints with its formulas.
        """
        of_cards = [
            limits._replace(kind=card.kind)
            for card in self.cards
            if card.kind is not None
            for limits in card.validity
        ]
        asked = None if kind is None else {None, kind, *FOLLOWS.get(kind, ())}
        each = (*self.validity, *of_cards)
        found = [r for r in each if asked is None or r.kind in asked]
        return tuple({(r.quantity, r.least, r.most): r for r in reversed(found)}.values())

    def outside_validity(
        self, sizes: Sizes, travel: float, kind: QuantityKind | None = None
    ) -> list[tuple[Range, float]]:
        """Return the ranges of validity that a design leaves at a travel, each with its value.

        Both warnings and verdicts use it: the closed forms of ``kind`` have no known error outside
        of theirs.
        """
        at = {name: number(value) for name, value in self.indicators(sizes, travel).items()}
        return [(limits, at[limits.quantity]) for limits in outside(self.ranges(kind), at)]

    def layout(self, elastic: Elastic, sizes: Sizes) -> "Layout":
        """Return the joint as rigid bodies and blades in its plane.

        Its base is the ground and its moving body is called ``moving``. A pivot has its centre
        in the origin and its axis of symmetry along x; a stage moves along y. Loads act at the
        moving body's point: a pivot's centre, a stage's middle, the tip of a single blade.
        """
        raise NotAvailable("is not made of straight blades in a plane")

    def plane_layout(self, elastic: Elastic, sizes: Sizes) -> "Layout":
        """Return the layout for loads in its plane, where ideal joints may guide bodies."""
        return self.layout(elastic, sizes)

    def blades_layout(self, elastic: Elastic, sizes: Sizes) -> "Layout":
        """Return the layout for numbers that do not depend on the distance between guiding blades.

        Where the spec does not state it, they are as far apart as long.
        """
        if not self.layout_lacks:
            return self.layout(elastic, sizes)
        apart = dict.fromkeys(self.layout_lacks, number(sizes.l))
        return self.model_copy(update=apart).layout(elastic, sizes)

    def space_layout(self, elastic: Elastic, sizes: Sizes, density: float = 0.0) -> "SpaceLayout":
        """Return the joint as bodies and blades in space, its plane being z = 0.

        Its base is the ground; the drive names its moving body and its motion. ``density`` is that
        of the blades [kg/m³]. The effects left out are left out of its blades.
        """
        layout = self.laid_in_space(elastic, sizes, density)
        if not self._omitted:
            return layout
        from flexcli.mechanics.space.layout import without

        return without(layout, *(BEAM_EFFECTS[name] for name in self._omitted))

    def laid_in_space(self, elastic: Elastic, sizes: Sizes, density: float) -> "SpaceLayout":
        """Return bodies and blades in space with all effects."""
        from flexcli.mechanics.space.planar import from_plane

        layout = self.layout(elastic, sizes)
        if layout.G is None:
            raise NotAvailable("needs material.poisson_ratio for its shear and torsion")
        return from_plane(layout, MOVING, turns=self.motion == "rotation", density=density)

    def has_limbs(self, elastic: Elastic, sizes: Sizes) -> bool:
        """Return whether rigid parts of unstated mass move between its hinges."""
        for blade in self.blades_layout(elastic, sizes).blades:
            l = hypot(*np.subtract(blade.end, blade.start))
            ends = [np.ravel(piece.position(PIECE)) for piece in blade.profile.pieces(l)]
            if sum(number(end - start) for start, end in ends) < (1.0 - ROUNDING) * l:
                return True
        return False

    def payload_point(self, moving: "Point") -> "Point":
        """Return the joint's centre, where a payload has its centre of mass: it only turns there.

        ``moving`` is the point of the moving body.
        """
        return moving

    def held(self, travel: float) -> Held:
        """Return the motion of the moving body that a stroke imposes."""
        return (None, None, travel) if self.motion == "rotation" else (None, travel, None)

    @property
    def is_guided(self) -> bool:
        """Return whether a guide keeps the body from turning, whatever a case holds."""
        return self.motion == "translation" and self.held(0.0)[2] is not None

    def values(self, elastic: Elastic, sizes: Sizes, travel: float) -> dict[str, Value]:
        """Return the joint's own numbers for reports, at the largest travel."""
        return {}
