"""Layout: a mechanism drawn in the spec, as rigid bodies and the blades between them."""

from math import cos, pi, sin
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, ValidationError, model_validator
from pydantic_core import InitErrorDetails

from flexcli.formulas.quantity import Computed, Quantity
from flexcli.mechanics.layout import Blade, Body, Layout, Number, Point, Support
from flexcli.numerics.collocation import gauss_nodes
from flexcli.numerics.rows import larger, number
from flexcli.parts.base import spec_error
from flexcli.parts.bending import Thick, WideBlades
from flexcli.parts.bending.thick import thick_linked
from flexcli.parts.bending.wide import wide_by_shapes, wide_drawn
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.base import GROUND, MOVING, ROUNDING, Critical, Extent, Sizes
from flexcli.parts.geometries.base import Blade as WideBlade
from flexcli.parts.geometries.blade_profile import FilletedProfile
from flexcli.parts.geometries.blades import ClampedBlades
from flexcli.parts.geometries.layout_clearances import rooms
from flexcli.parts.geometries.layout_faults import Drawing, faults
from flexcli.parts.geometries.layout_parts import (
    DrawnBlade,
    DrawnBody,
    DrawnSupport,
    Motion,
    Name,
    Place,
    corners_of,
)
from flexcli.parts.geometries.notch import CONCENTRATION, Concentration
from flexcli.parts.geometries.redrawn import Drawn

__all__ = ["FreeLayout"]

GUIDES = 10.0
"""Distance of blades side by side over their thickness from which on what they stretch turns the
body by a hundredth of what bends them at most."""

_NODES = 24
"""Gauss nodes on a piece of a blade for its volume, exact to rounding for every profile."""


class FreeLayout(Drawn, ClampedBlades):
    """Rigid bodies and the blades between them as the spec draws them; the stroke moves one.

    The spec draws it in coordinates of its own, which are those of its loads and requirements
    too: a load's direction is from the drawing's x. The model takes a pivot's ``centre`` as its
    origin and keeps the directions; it turns a stage until its travel is along y. A stage's
    shift is positive to the left of its travel.
    """

    closed_forms: ClassVar[bool] = False
    posynomial: ClassVar[bool] = False
    is_linear: ClassVar[bool] = False
    told_across_width: ClassVar[bool] = False
    source: ClassVar[str] = "the bodies and blades of the spec"

    kind: Literal["layout"]
    bodies: Annotated[dict[Name, DrawnBody], Field(min_length=1, max_length=100)]
    """Rigid bodies by names of your own; ground is there already,
    e.g. ``{stage: {at: [0 mm, 20 mm], mass: 50 g}}``.
    """
    blades: Annotated[dict[Name, DrawnBlade], Field(min_length=1, max_length=300)]
    """Blades by names of your own, each between two bodies,
    e.g. ``{left: {between: [ground, stage], from: [-10 mm, 0 mm], to: [-10 mm, 20 mm], h: 0.2 mm,
    b: 10 mm}}``.
    """
    moving: Name
    """Body that the stroke moves, e.g. ``stage``."""
    moves: Motion = Field(alias="motion")
    """What the stroke makes it do: a rotation, or a translation in a direction from x,
    e.g. ``{translation: 0 deg}``.
    """
    centre: Place | None = None
    """Centre of a rotation; left out, the point of the moving body,
    e.g. ``centre: [0 mm, 0 mm], motion: rotation``.
    """
    supports: tuple[DrawnSupport, ...] = ()
    """Springs from bodies to the ground,
    e.g. ``[{body: stage, at: [0 mm, 20 mm], x: 1 N/mm, y: 1 N/mm}]``.
    """
    concentration: Concentration = Field(CONCENTRATION, alias="stress-concentration")
    """How the peak of the stress in a notch counts: by Neuber's deep notch, of fillets by their
    own factor, or not at all, e.g. ``none``.
    """

    tilt: Literal["free", "held"] = "free"
    """Whether nothing but blades at different heights z, which pull beside each other, keeps the
    bodies from tilting, or something holds them in their plane, e.g. ``held``.
    """

    @model_validator(mode="before")
    @classmethod
    def _is_plane(cls, data: Any) -> Any:
        bodies = data.get("bodies") if isinstance(data, dict) else None
        for name, body in bodies.items() if isinstance(bodies, dict) else ():
            place = body.get("at") if isinstance(body, dict) else None
            if isinstance(place, list | tuple) and len(place) == 3:
                raise spec_error(
                    "three coordinates do not lie in the plane of a layout",
                    "write kind: space-layout, or x and y alone", at=("bodies", name, "at"),
                )  # fmt: skip
        return data

    @model_validator(mode="after")
    def _fits_together(self) -> "FreeLayout":
        along = self.moves.translation
        drawing = Drawing(self.bodies, self.blades, self.supports, self.moving, along, self.centre)
        found = [InitErrorDetails(type=fault, input=None) for fault in faults(drawing)]
        if found:
            raise ValidationError.from_exception_data("layout", found)
        return self

    @property
    def axes(self) -> float:
        """Return the turn from the model's x to the drawing's [rad]."""
        return self._turn

    @property
    def symmetry_axis(self) -> float:
        """Return zero: a load's direction is from the drawing's x [rad]."""
        return self._turn

    @property
    def own_mass(self) -> float:
        """Return the mass of all bodies [kg]."""
        return sum(body.mass for body in self.bodies.values())

    @property
    def has_masses(self) -> bool:
        """Return whether any body has mass or inertia."""
        return any(body.mass or body.inertia for body in self.bodies.values())

    @property
    def drawn_turn(self) -> float:
        """Return the angle from the layout's x to x as it is drawn [rad]."""
        return self._turn

    @property
    def moving_name(self) -> str:
        """Return the spec's name for the moving body."""
        return self.moving

    # which motion it is depends on the drawing, as no other geometry's but a linkage's does
    @property
    def motion(self) -> str:  # type: ignore[override]
        """Return the kind of motion of the moving body."""
        return "rotation" if self.moves.translation is None else "translation"

    @property
    def outlines(self) -> dict[str, NDArray[np.float64]]:
        """Return the corners of its bodies that have a box, in the model's frame."""
        found = {}
        for name, body in self.bodies.items():
            if body.box is not None:
                x, y = body.at if body.com is None else body.com
                corners = np.array([x, y, 0.0]) + corners_of(body.box)
                corners[:, :2] = [self._placed((x, y)) for x, y in corners[:, :2].tolist()]
                found[self._called(name)] = corners
        return found

    @property
    def drawn_extents(self) -> dict[str, Extent]:
        """Return the thicknesses by symbol and blade."""
        return {
            _size(name, blade): extent
            for name, blade in self.blades.items()
            if (extent := blade.thickness.extent) is not None
        }

    def may_tilt(self, *, loaded: bool) -> bool:
        """Return that blades at different heights pull beside each other."""
        apart = len({blade.z for blade in self.blades.values()}) > 1
        return self.tilt == "free" and apart

    def drawn_label(self, name: str) -> str:
        """Return the name of a thickness, in words."""
        return f"thickness of blade {name.partition('_')[2].replace('_', '-')}"

    def drawn_place(self, name: str) -> tuple[str, ...]:
        """Return the place of a thickness in the spec."""
        of, blade = next(each for each in self.blades.items() if _size(*each) == name)
        inside = ("profile",) if blade.profile is not None else ()
        return ("geometry", "blades", of, *inside, blade.thickness.symbol)

    def stiffness(self, elastic: Elastic, sizes: Sizes) -> Computed:
        """Refuse: a drawn layout has no closed form."""
        raise NotAvailable("is described by its bodies and blades: take --model linear or exact")

    def end_stresses(self, elastic: Elastic, sizes: Sizes, travel: float) -> dict[str, Computed]:
        """Refuse: a drawn layout has no closed form."""
        raise NotAvailable("is described by its bodies and blades: take --model linear or exact")

    def parasitic_shift(self, sizes: Sizes, travel: float) -> Computed:
        """Refuse: a shift is of second order, beyond closed forms and the linear model."""
        raise NotAvailable("has its shift from --model exact alone")

    def critical(self, elastic: Elastic, sizes: Sizes, ends: str) -> tuple[Critical, ...]:
        """Refuse: the share of the force in each blade is not known."""
        raise NotAvailable("has no closed form for its buckling")

    def axial_share(self, direction: float) -> float:
        """Return 1: the upper limit, since models give the share of each blade."""
        return 1.0

    def wide_blades(self, sizes: Sizes, nu: float) -> WideBlades | None:
        """Return the range of the factors of its blades."""
        blades = [
            (
                WideBlade(
                    drawn.thickness.thinnest(self.size_of(name, sizes)), drawn.length, drawn.b
                ),
                drawn.thickness.straight(drawn.length),
            )
            for name, drawn in self.blades.items()
        ]
        plain = wide_drawn(blades, nu, springs=bool(self.supports))
        even = [
            (WideBlade(*map(float, blade)), straight)
            for blade, straight in blades
            if straight is not None
        ]
        if len(even) < len(blades):
            return plain
        layout = self.layout(Elastic(1.0, nu), sizes)
        return wide_by_shapes(plain, even, nu, layout, self.held(1.0))

    @property
    def has_fillets(self) -> bool:
        """Return whether any of its blades has fillets at its ends."""
        return any(isinstance(blade.profile, FilletedProfile) for blade in self.blades.values())

    def shift_change(self, sizes: Sizes, pure: float, bent: float) -> float | None:
        """Return that of blades bent to an S, where alike ones guide the body's point amid them."""
        along = self.moves.translation
        if along is None or self.supports or len(self.blades) < 2:
            return None
        alike, places = set(), list[float]()
        for name, blade in self.blades.items():
            ends = dict(zip(blade.between, (blade.start, blade.end), strict=True))
            if set(ends) != {GROUND, self.moving}:
                return None
            l = blade.length
            arm = np.subtract(ends[self.moving], ends[GROUND]) / l
            if abs(arm[0] * cos(along) + arm[1] * sin(along)) > ROUNDING:
                return None
            h = number(blade.thickness.thinnest(self.size_of(name, sizes)))
            straight = blade.thickness.straight(l)
            if straight is None:
                return None
            of_whole = np.array([h, l, blade.b, straight]) / self.length(sizes)
            alike.add((*np.round(of_whole, 9), *np.round(arm, 9)))
            away = np.subtract(blade.start, self.bodies[self.moving].at)
            places.append(float(away[0] * cos(along) + away[1] * sin(along)))
        places.sort()
        # else the point leaves its path as the body turns
        even = np.allclose(places, np.negative(places[::-1]), rtol=0.0, atol=ROUNDING * l)
        far = places[-1] - places[0] >= GUIDES * h
        return bent if even and far and len(alike) == 1 else None

    def thick_notches(self, sizes: Sizes) -> Thick | None:
        """Return the range of the factors of its blades that are notches."""
        each = [
            blade.thickness.thick(self.size_of(name, sizes), blade.length)
            for name, blade in self.blades.items()
        ]
        return thick_linked([*each, None] if self.supports else each)

    def volume(self, sizes: Sizes) -> Computed:
        """Return the volume of all blades, without their rigid parts [m³]."""
        u, weight = gauss_nodes(_NODES)
        return sum(
            blade.b * ((piece.thickness(u) * piece.slope(u)) @ weight)
            for name, blade in self.blades.items()
            for piece in blade.thickness.shape(_column(self.size_of(name, sizes))).pieces(
                _column(blade.length)
            )
        )

    def ratios(self, sizes: Sizes) -> dict[str, Computed]:
        """Return l/h and b/h of every blade where it is thinnest."""
        found: dict[str, Quantity] = {}
        for name, blade in self.blades.items():
            h = blade.thickness.thinnest(self.size_of(name, sizes))
            found |= {f"l/h {name}": blade.length / h, f"b/h {name}": blade.b / h}
        return found

    def sections(self, sizes: Sizes) -> tuple[tuple[str, float, float], ...]:
        """Return the blades where they are thinnest: name, thickness and width [m]."""
        return tuple(
            (name, float(blade.thickness.thinnest(self.size_of(name, sizes))), float(blade.b))
            for name, blade in self.blades.items()
        )

    def clearances(self, sizes: Sizes) -> tuple[tuple[str, Computed], ...]:
        """Return the room between blades at one height, where they are thinnest [m]."""
        thinnest = {
            name: blade.thickness.thinnest(self.size_of(name, sizes))
            for name, blade in self.blades.items()
        }
        return tuple(rooms(self.blades, thinnest))

    def radii(self, sizes: Sizes) -> dict[str, Computed]:
        """Return the radii of shaped blades, and of others where they are cut from one piece."""
        is_cut = self.clamps not in (None, "rigid")
        each = {name: blade.thickness.radius(blade.length) for name, blade in self.blades.items()}
        return {name: radius for name, radius in each.items() if radius or is_cut}

    def slenderness(self, sizes: Sizes) -> float | None:
        """Return thickness over length of the stockiest blade [-]."""
        return max(
            float(blade.thickness.thinnest(self.size_of(name, sizes))) / blade.length
            for name, blade in self.blades.items()
        )

    def length(self, sizes: Sizes) -> float:
        """Return the length of the shortest blade [m]."""
        return min(blade.length for blade in self.blades.values())

    def layout(self, elastic: Elastic, sizes: Sizes) -> Layout:
        """Return the drawing in the model's frame; the moving body's point is a pivot's centre."""
        return Layout(
            bodies=tuple(self._body(name, body) for name, body in self.bodies.items()),
            blades=tuple(
                Blade(
                    name,
                    self._called(blade.between[0]),
                    self._called(blade.between[1]),
                    self._placed(blade.start),
                    self._placed(blade.end),
                    blade.thickness.shape(_column(self.size_of(name, sizes))),
                    blade.b,
                    blade.z,
                    self._peak(name, sizes),
                )
                for name, blade in self.blades.items()
            ),
            E=elastic.E,
            G=elastic.shear,
            supports=tuple(self._support(support) for support in self.supports),
        )

    def _peak(self, name: str, sizes: Sizes) -> tuple[Computed, Computed]:
        """Return the stress concentration factors of a blade's shape."""
        blade = self.blades[name]
        if self.concentration == "none":
            return 1.0, 1.0
        return blade.thickness.peaks(self.size_of(name, sizes), blade.length)

    def peaks_above(self, sizes: Sizes) -> tuple[Computed, Computed]:
        """Return what those of the blades' shapes may be less, at most."""
        if self.concentration == "none":
            return 0.0, 0.0
        clamped = self.clamps in (None, "rigid")
        bent, along = zip(
            *(
                blade.thickness.peaks_above(self.size_of(name, sizes), blade.length, clamped)
                for name, blade in self.blades.items()
            ),
            strict=True,
        )
        return larger(0.0, *bent), larger(0.0, *along)

    def _body(self, name: str, body: DrawnBody) -> Body:
        at = self._centre if name == self.moving and self.motion == "rotation" else body.at
        com = body.at if body.com is None else body.com
        return Body(
            self._called(name), self._placed(at), body.mass, body.inertia, self._placed(com)
        )

    def _support(self, support: DrawnSupport) -> Support:
        stiffness = (support.x or 0.0, support.y or 0.0, support.theta or 0.0)
        if abs(sin(self._turn)) > 0.5:
            # a quarter turn; on any other turn both are equal
            stiffness = (stiffness[1], stiffness[0], stiffness[2])
        return Support(self._called(support.body), self._placed(support.at), stiffness)

    def _called(self, name: str) -> str:
        return MOVING if name == self.moving else GROUND if name == GROUND else name

    def size_of(self, name: str, sizes: Sizes) -> Any:
        """Return the size of a blade, None where it is tabulated."""
        return getattr(sizes, _size(name, self.blades[name]), None)

    @property
    def _centre(self) -> Point:
        return self.centre if self.centre is not None else self.bodies[self.moving].at

    @property
    def _turn(self) -> float:
        """Return the turn from the drawing to the model [rad]."""
        along = self.moves.translation
        return 0.0 if along is None else pi / 2.0 - along

    def _placed(self, point: Point) -> Point:
        x, y = point
        if self.motion == "rotation":
            return x - self._centre[0], y - self._centre[1]
        c, s = cos(self._turn), sin(self._turn)
        return c * x - s * y, s * x + c * y


def _size(name: str, blade: DrawnBlade) -> str:
    return f"{blade.thickness.symbol}_{name.replace('-', '_')}"


def _column(size: Any) -> Number:
    """Return a thickness with a trailing axis along the blade where it is of many designs."""
    return size if size is None or np.ndim(size) == 0 else np.asarray(size)[..., None]
