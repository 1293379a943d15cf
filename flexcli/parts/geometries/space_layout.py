"""Layout in space: a mechanism of bodies, blades and rods drawn in the spec in three dimensions."""

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, GetJsonSchemaHandler, ValidationError, model_validator
from pydantic_core import CoreSchema, InitErrorDetails, PydanticCustomError

from flexcli.formulas.card import Range
from flexcli.formulas.clamped_blade import VALIDITY
from flexcli.formulas.profile import Constant
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.mechanics.space.layout import (
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
    SpaceRod,
    Vector,
)
from flexcli.parts.base import spec_error
from flexcli.parts.bending import WideBlades
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.base import GROUND, Extent, Sizes
from flexcli.parts.geometries.layout_parts import Name, corners_of
from flexcli.parts.geometries.redrawn import Drawn
from flexcli.parts.geometries.space_parts import (
    DrawnSpaceBlade,
    DrawnSpaceBody,
    DrawnSpaceRod,
    Placed,
    SpaceMotion,
)
from flexcli.parts.material import Material
from flexcli.results import Value

__all__ = ["SpaceDrawing"]

MOST = 300
"""Most blades and rods with all their copies."""


class SpaceDrawing(Drawn):
    """Rigid bodies, blades and rods in space as the spec draws them; the stroke moves one body.

    All coordinates, loads and requirements are along the axes of the drawing. The linear model
    judges it: small motion, at rest and with an estimate of what the stroke leaves out.
    """

    closed_forms: ClassVar[bool] = False
    posynomial: ClassVar[bool] = False
    is_linear: ClassVar[bool] = False
    in_space: ClassVar[bool] = True
    source: ClassVar[str] = "the bodies, blades and rods of the spec"
    validity: ClassVar[tuple[Range, ...]] = VALIDITY

    kind: Literal["space-layout"]
    bodies: Annotated[dict[Name, DrawnSpaceBody], Field(min_length=1, max_length=100)]
    """Rigid bodies by names of your own; ground is there already,
    e.g. ``{stage: {at: [0 mm, 20 mm, 0 mm], mass: 50 g}}``.
    """
    blades: Annotated[dict[Name, DrawnSpaceBlade], Field(max_length=MOST)] = Field({})
    """Blades by names of your own, each between two bodies,
    e.g. ``{left: {between: [ground, stage], from: [-10 mm, 0 mm, 0 mm],
    to: [-10 mm, 20 mm, 0 mm], h: 0.2 mm, b: 10 mm, width: z, mirror: [x]}}``.
    """
    rods: Annotated[dict[Name, DrawnSpaceRod], Field(max_length=MOST)] = Field({})
    """Round rods by names of your own, each between two bodies,
    e.g. ``{brace: {between: [ground, stage], from: [0 mm, 0 mm, 0 mm], to: [0 mm, 20 mm, 0 mm],
    d: 0.5 mm}}``.
    """
    moving: Name
    """Body that the stroke moves, and wrenches act on, e.g. ``stage``."""
    moves: SpaceMotion = Field(alias="motion")
    """What the stroke makes it do, e.g. ``{translation: x}``."""

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        whole = handler.resolve_ref_schema(handler(schema))
        return {**whole, "anyOf": [{"required": ["blades"]}, {"required": ["rods"]}]}

    @model_validator(mode="after")
    def _fits_together(self) -> "SpaceDrawing":
        found = [InitErrorDetails(type=fault, input=None) for fault in self._faults()]
        if found:
            raise ValidationError.from_exception_data("space-layout", found)
        return self

    def _faults(self) -> Iterator[PydanticCustomError]:
        """Yield the faults between the parts, each with its path in the spec."""
        names = list(self._unknown())
        yield from names
        if not names:
            yield from self._loose()
            yield from self._doubles()

    def _unknown(self) -> Iterator[PydanticCustomError]:
        known = f"bodies are: {', '.join(self.bodies)}"
        if GROUND in self.bodies:
            hint = "give the body another name; blades name ground as it is"
            yield spec_error("the ground is no body", hint, at=("bodies", GROUND))
        if self.moving not in self.bodies:
            yield spec_error(f"there is no body '{self.moving}'", known, at=("moving",))
        for section, members in (("blades", self.blades), ("rods", self.rods)):
            for name, member in members.items():
                for index, end in enumerate(member.between):
                    if end != GROUND and end not in self.bodies:
                        at = (section, name, "between", index)
                        yield spec_error(f"there is no body '{end}'", f"{known}, or ground", at=at)
        for name in set(self.blades) & set(self.rods):
            yield spec_error("a blade has this name", "give it another", at=("rods", name))
        if not self.blades and not self.rods:
            yield spec_error("nothing joins the bodies", "draw blades or rods", at=("blades",))

    def _loose(self) -> Iterator[PydanticCustomError]:
        """Yield the bodies that no chain of blades holds to the ground."""
        groups = [{name} for name in (GROUND, *self.bodies)]
        for member in (*self.blades.values(), *self.rods.values()):
            joined = [group for group in groups if group & set(member.between)]
            groups = [g for g in groups if g not in joined] + [set().union(*joined)]
        for name in self.bodies:
            if not any({name, GROUND} <= group for group in groups):
                hint = "lead a blade from it to what is held"
                text = f"body {name} is not held to the ground"
                yield spec_error(text, hint, at=("bodies", name))

    def _doubles(self) -> Iterator[PydanticCustomError]:
        placed = list(self.placed())
        if len(placed) > MOST:
            hint = f"at most {MOST} with all their copies"
            yield spec_error(f"there are {len(placed)} blades and rods", hint, at=("blades",))
        seen: dict[object, str] = {}
        for one in placed:
            ends = frozenset(tuple(np.round(end, 12) + 0.0) for end in (one.start, one.end))
            first = seen.setdefault(ends, one.name)
            if first != one.name:
                section = "blades" if one.drawn in self.blades else "rods"
                hint = "draw it elsewhere, or take out a mirror image that falls on itself"
                yield spec_error(
                    f"{one.name} lies where {first} does", hint, at=(section, one.drawn)
                )

    # which motion it is depends on the drawing
    @property
    def motion(self) -> str:  # type: ignore[override]
        """Return the kind of motion of the moving body."""
        return "rotation" if self.moves.translation is None else "translation"

    @property
    def axes(self) -> float:
        """Return 0: cases are in the axes of the drawing [rad]."""
        return 0.0

    @property
    def own_mass(self) -> float:
        """Return the mass of all bodies [kg]."""
        return sum(body.weight for body in self.bodies.values())

    @property
    def has_blades(self) -> bool:
        """Return whether any blade is drawn besides the rods."""
        return bool(self.blades)

    @property
    def has_masses(self) -> bool:
        """Return whether any body has mass."""
        return self.own_mass > 0.0

    @property
    def outlines(self) -> dict[str, NDArray[np.float64]]:
        """Return the corners of its boxes."""
        return {
            name: np.asarray(body.com or body.at) + corners_of(body.box)
            for name, body in self.bodies.items()
            if body.box is not None
        }

    @property
    def body_materials(self) -> dict[str, Material]:
        """Return the materials of its bodies that are not of that of the blades, by name."""
        stated = {name: body.material for name, body in self.bodies.items()}
        return {name: material for name, material in stated.items() if material is not None}

    @property
    def drawn_extents(self) -> dict[str, Extent]:
        """Return thicknesses and diameters by symbol and name."""
        blades = {_symbol("h", name): blade.h for name, blade in self.blades.items()}
        return blades | {_symbol("d", name): rod.d for name, rod in self.rods.items()}

    def drawn_label(self, name: str) -> str:
        """Return the name of a thickness, in words."""
        symbol, _, of = name.partition("_")
        what = "thickness of blade" if symbol == "h" else "diameter of rod"
        return f"{what} {of.replace('_', '-')}"

    def drawn_place(self, name: str) -> tuple[str, ...]:
        """Return the place of a thickness or diameter in the spec."""
        symbol, _, of = name.partition("_")
        members: Mapping[str, Any] = self.blades if symbol == "h" else self.rods
        drawn = next(each for each in members if _symbol(symbol, each) == f"{symbol}_{of}")
        return ("geometry", "blades" if symbol == "h" else "rods", drawn, symbol)

    def stiffness(self, elastic: Elastic, sizes: Sizes) -> Computed:
        """Refuse: a drawn layout has no closed form."""
        raise NotAvailable("is described by its bodies and blades: take --model linear")

    def end_stresses(self, elastic: Elastic, sizes: Sizes, travel: float) -> dict[str, Computed]:
        """Refuse: a drawn layout has no closed form."""
        raise NotAvailable("is described by its bodies and blades: take --model linear")

    def axial_share(self, direction: float) -> float:
        """Return 1: the upper limit, since models give the share of each blade."""
        return 1.0

    def wide_blades(self, sizes: Sizes, nu: float) -> WideBlades | None:
        """Return None: the springs of its model include the width of each blade."""
        return None

    def volume(self, sizes: Sizes) -> Computed:
        """Return the volume of all blades and rods [m³]."""
        blades = [
            blade.count * blade.b * self._size("h", name, sizes) * blade.length
            for name, blade in self.blades.items()
        ]
        rods = [
            rod.count * np.pi / 4.0 * self._size("d", name, sizes) ** 2 * rod.length
            for name, rod in self.rods.items()
        ]
        return sum([*blades, *rods])

    def ratios(self, sizes: Sizes) -> dict[str, Computed]:
        """Return l/h and b/h of every drawn blade, l/d of every rod."""
        found: dict[str, Quantity] = {}
        for name, blade in self.blades.items():
            h = self._size("h", name, sizes)
            found |= {f"l/h {name}": blade.length / h, f"b/h {name}": blade.b / h}
        for name, rod in self.rods.items():
            found[f"l/d {name}"] = rod.length / self._size("d", name, sizes)
        return found

    def indicators(self, sizes: Sizes, travel: float) -> dict[str, Computed]:
        """Return the largest b/l and h/l (or d/l), the quantities of the springs' validity."""
        widest = max((blade.b / blade.length for blade in self.blades.values()), default=0.0)
        thick = [
            float(self._size("h", name, sizes)) / blade.length
            for name, blade in self.blades.items()
        ]
        thick += [float(self._size("d", name, sizes)) / r.length for name, r in self.rods.items()]
        return {"b/l": widest, "h/l": max(thick)}

    def sections(self, sizes: Sizes) -> tuple[tuple[str, float, float], ...]:
        """Return the blades and rods: name, thickness and width [m]."""
        blades = [
            (name, float(self._size("h", name, sizes)), float(blade.b))
            for name, blade in self.blades.items()
        ]
        rods = [(name, d, d) for name in self.rods for d in [float(self._size("d", name, sizes))]]
        return (*blades, *rods)

    def length(self, sizes: Sizes) -> float:
        """Return the length of the shortest blade or rod [m]."""
        return min(member.length for member in (*self.blades.values(), *self.rods.values()))

    def placed(self) -> Iterator[Placed]:
        """Yield every blade and rod with its copies."""
        for name, blade in self.blades.items():
            yield from blade.copies(name, blade.width)
        for name, rod in self.rods.items():
            yield from rod.copies(name, None)

    def laid_in_space(self, elastic: Elastic, sizes: Sizes, density: float) -> SpaceLayout:
        """Return the drawing in the form that the solvers take."""
        material = Isotropic(elastic.E, elastic.G, density)
        members: list[SpaceBlade | SpaceRod] = []
        for one in self.placed():
            if one.width is None:
                rod = self.rods[one.drawn]
                d = float(self._size("d", one.drawn, sizes))
                members.append(SpaceRod(one.name, *rod.between, one.start, one.end, d, material))
                continue
            blade, h = self.blades[one.drawn], float(self._size("h", one.drawn, sizes))
            members.append(
                SpaceBlade(
                    one.name, *blade.between, one.start, one.end, one.width, Constant(h), blade.b,
                    material,
                )
            )  # fmt: skip
        bodies = tuple(
            SpaceBody(name, body.at, body.com or body.at, body.weight, body.tensor)
            for name, body in self.bodies.items()
        )
        return SpaceLayout(bodies, tuple(members), self._drive)

    @property
    def _drive(self) -> Drive:
        turn = self.moves.rotation
        if turn is None:
            assert self.moves.translation is not None  # one of both is given
            at = self.bodies[self.moving].at
            return Drive(self.moving, False, _unit(self.moves.translation), at)
        return Drive(self.moving, True, _unit(turn.about), turn.at)

    def _size(self, symbol: str, name: str, sizes: Sizes) -> Any:
        return getattr(sizes, _symbol(symbol, name))

    def values(self, elastic: Elastic, sizes: Sizes, travel: float) -> dict[str, Value]:
        """Return freedoms and over-constraints of its ideal blades."""
        from flexcli.mechanics.space.freedoms import freedoms
        from flexcli.mechanics.space.linear import assemble

        found = freedoms(assemble(self.space_layout(elastic, sizes)))
        told = {
            "freedoms": (found.of_moving, f"freedoms of {self.moving}"),
            "freedoms_all": (found.of_all, "freedoms of all bodies together"),
            "overconstraints": (found.overconstraints, "constraints beyond those that count"),
            "constraint_least": (found.weakest, "least singular value that counts, over the most"),
            "freedom_most": (found.none, "largest one that does not count, over the most"),
        }
        return {
            name: Value(value, "", label, "ideal blades", estimated_error=0.0)
            for name, (value, label) in told.items()
        }


def _symbol(symbol: str, name: str) -> str:
    return f"{symbol}_{name.replace('-', '_')}"


def _unit(direction: Vector) -> Vector:
    x, y, z = (float(c) for c in np.asarray(direction) / np.linalg.norm(direction))
    return x, y, z
