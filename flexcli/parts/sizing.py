"""What to choose the blades by: the objective and the grid that they can be made on."""

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Literal, NamedTuple, TypeAlias

from pydantic import (
    BeforeValidator,
    Discriminator,
    Field,
    GetJsonSchemaHandler,
    Tag,
    model_validator,
)
from pydantic_core import CoreSchema

from flexcli.formulas.quantity import Computed, Quantity
from flexcli.parts.base import Part, PositiveLength, QuantityOf, spec_error
from flexcli.results import Check

__all__ = [
    "QUANTITIES",
    "Correction",
    "Grid",
    "Minimize",
    "Objective",
    "SizeOptions",
]

Named = Literal["balanced", "least-volume", "least-stiffness", "shortest"]
QUANTITIES = ("volume", "mass", "k_pivot")
"""What can be least beside a size."""


class Grid(Part):
    """Sizes that can be made: multiples of a step, or the sizes in stock."""

    is_plain: ClassVar[bool] = True

    step: PositiveLength | None = None
    stock: tuple[PositiveLength, ...] = ()

    @model_validator(mode="before")
    @classmethod
    def _step_or_stock(cls, data: Any) -> Any:
        if isinstance(data, list):
            if not data:
                raise spec_error("the list of stock sizes is empty", "write e.g. [0.2 mm, 0.3 mm]")
            return {"stock": data}
        if isinstance(data, dict):
            raise spec_error(
                "a grid is a step or a list of sizes", "write 1 um, or [0.2 mm, 0.3 mm]"
            )
        return {"step": data}

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        size = QuantityOf("length", above=0.0).json_schema()
        return {"anyOf": [size, {"type": "array", "items": size, "minItems": 1}]}


class Correction(NamedTuple):
    """How many times more a check uses of what it allows than its formulas say, near a design.

    ``factor`` · Π (x/x₀)^slope over the sizes x, ``about`` are the x₀ [m]. Where no formula
    stands behind it, it is itself what is used of what a check asks (``alone``). ``spread`` is the
    relative error of a target's number, by which its tolerance is narrowed.
    """

    factor: float
    about: Mapping[str, float]
    slopes: Mapping[str, float]
    alone: Check | None = None
    spread: float = 0.0

    def at(self, sizes: Any) -> Computed:
        """Return the correction at sizes: floats, arrays or signomials."""
        found: Quantity = self.factor
        for name, slope in self.slopes.items():
            found = found * (getattr(sizes, name) * (1.0 / self.about[name])) ** slope
        return found


class Minimize(Part):
    """An objective by the name of a quantity: the least of it, or the most."""

    minimize: str | None = None
    """A size, volume, mass, k_pivot or a requirement with a ``max``, e.g. ``parasitic_shift``."""
    maximize: str | None = None
    """A size, volume, mass, k_pivot, a requirement with a ``min`` or a factor, e.g. ``yield``."""

    @model_validator(mode="after")
    def _one(self) -> "Minimize":
        if (self.minimize is None) == (self.maximize is None):
            raise spec_error("an objective names one quantity", "write {minimize: k_pivot}")
        return self


def _listed(data: Any) -> Any:
    if not isinstance(data, list) or len(data) < 2:
        raise spec_error("a choice is among two or more", "write [ti-6al-4v, maraging-300]")
    return tuple(data)


class _AnyValues:
    """A type marker of lists of what may stand at any place of a spec."""

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        items = {"anyOf": [{"type": kind} for kind in ("string", "number", "object")]}
        return {"type": "array", "items": items, "minItems": 2}


Options: TypeAlias = Annotated[tuple[Any, ...], BeforeValidator(_listed), _AnyValues()]
"""What may stand at a place of the spec."""


def _way(data: Any) -> str:
    return "mapping" if isinstance(data, dict | Minimize) else "name"


Objective: TypeAlias = Annotated[
    Annotated[Named, Tag("name")] | Annotated[Minimize, Tag("mapping")], Discriminator(_way)
]
"""Named, or by a quantity; the discriminator keeps the findings to the way that was taken."""


AS_QUANTITIES = {"least-volume": "volume", "least-stiffness": "k_pivot", "shortest": "l"}


class SizeOptions(Part):
    """How ``flexure size`` chooses the sizes.

    ``rounding`` is the grid of each; a size that is left out stays continuous.
    """

    objective: Objective = "least-volume"
    """What the free sizes are chosen for, e.g. ``{minimize: k_pivot}``."""
    against: Minimize | None = None
    """Second objective, a requirement whose own bound is the loosest: the designs that are best in
    both make a Pareto front, e.g. ``{minimize: parasitic_shift}``.
    """
    points: Annotated[int, Field(strict=True, ge=3, le=200)] = 9
    """How many designs of a front there are, e.g. ``15``."""
    among: dict[str, Options] = Field({})
    """Places of the spec and what may stand there: every combination is sized, the best is taken,
    e.g. ``{material: [ti-6al-4v, maraging-300]}``.
    """
    rounding: dict[str, Grid] = Field({}, alias="round")
    """Grid of each size: a step, or the sizes in stock; continuous where left out,
    e.g. ``{h: [0.1 mm, 0.2 mm, 0.3 mm]}``.
    """

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        whole = handler.resolve_ref_schema(handler(schema))
        given = whole["properties"]["objective"]
        rest = {key: form for key, form in given.items() if key not in ("allOf", "oneOf")}
        forms = given.get("allOf", [given])[0]["oneOf"]
        one = {"anyOf": [{"type": "string"}, forms[-1]]}
        both = {"type": "array", "items": one, "minItems": 2, "maxItems": 2}
        properties = {**whole["properties"], "objective": {**rest, "anyOf": [*forms, both]}}
        return {**whole, "properties": properties}

    @model_validator(mode="before")
    @classmethod
    def _two_objectives(cls, data: Any) -> Any:
        if not isinstance(data, dict) or not isinstance(data.get("objective"), list):
            return data
        both = data["objective"]
        if len(both) != 2 or "against" in data:
            hint = "write [volume, parasitic_shift]"
            raise spec_error("a list of objectives has two", hint, at=("objective",))
        first, second = (
            {"minimize": AS_QUANTITIES.get(goal, goal)} if isinstance(goal, str) else goal
            for goal in both
        )
        names = [{*goal.values()} if isinstance(goal, dict) else {goal} for goal in (first, second)]
        if names[0] == names[1]:
            text = f"both objectives are {' '.join(map(str, names[0]))}"
            raise spec_error(text, "write [volume, parasitic_shift]", at=("objective",))
        return {**data, "objective": first, "against": second}
