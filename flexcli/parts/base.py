"""What every part is made of: a frozen model, and quantities that carry their units."""

from collections.abc import Mapping
from math import isfinite
from typing import Annotated, Any, TypeAlias

from pydantic import BaseModel, ConfigDict, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from flexcli.units import DIMENSIONS, QuantityError, parse_quantity

__all__ = [
    "Acceleration",
    "AccelerationDensity",
    "Angle",
    "Count",
    "Density",
    "Duration",
    "Expansion",
    "Force",
    "Frequency",
    "Inertia",
    "Length",
    "Mass",
    "Part",
    "PositiveLength",
    "QuantityOf",
    "Ratio",
    "RotationalStiffness",
    "Stiffness",
    "Stress",
    "spec_error",
]


class Part(BaseModel):
    """A frozen, validated piece of a spec that refuses keys it does not know."""

    model_config = ConfigDict(
        frozen=True, extra="forbid", arbitrary_types_allowed=True, defer_build=True
    )


def spec_error(text: str, hint: str = "", at: tuple[str | int, ...] = ()) -> PydanticCustomError:
    """Return a finding for a validator to raise: what is wrong and what would be right.

    ``at`` is the path of the value at fault, below the model whose validator raises.
    """
    message = text.replace("{", "(").replace("}", ")")
    return PydanticCustomError("spec", "{text}", {"text": message, "hint": hint, "at": list(at)})


class QuantityOf:
    """A type marker: a text with a unit in the spec, an SI float in the model."""

    def __init__(
        self,
        dimension: str,
        *,
        above: float | None = None,
        at_least: float | None = None,
        below: float | None = None,
    ) -> None:
        self.dimension = dimension
        self.above = above
        self.at_least = at_least
        self.below = below

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.read)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        expected = DIMENSIONS[self.dimension]
        described = f"{self.dimension}, e.g. {expected.example}"
        if self.dimension == "ratio":
            return {"type": ["number", "string"], "description": described}
        return {"type": "string", "description": described, "examples": [expected.example]}

    def read(self, value: Any) -> float:
        """Return the SI value of what the spec says, or raise what is wrong with it."""
        expected = DIMENSIONS[self.dimension]
        if isinstance(value, str):
            try:
                number = parse_quantity(value, self.dimension)
            except QuantityError as error:
                raise spec_error(str(error), error.hint) from None
        elif isinstance(value, bool) or not isinstance(value, int | float):
            raise spec_error(
                f"a {self.dimension} is expected here, not {_kind(value)}",
                f"write e.g. {expected.example}",
            )
        elif not isfinite(value):
            raise spec_error(f"a {self.dimension} must be finite", f"write e.g. {expected.example}")
        elif self.dimension != "ratio":
            unit = expected.example.split(" ", 1)[-1]
            raise spec_error(
                f"{value} has no unit", f"a {self.dimension} needs a unit, e.g. {value} {unit}"
            )
        else:
            number = float(value)
        self._refuse_outside(number, value)
        return number

    def _refuse_outside(self, number: float, value: Any) -> None:
        if self.above is not None and not number > self.above:
            raise spec_error(f"{value} must be above {self.above:g}", self._example())
        if self.at_least is not None and not number >= self.at_least:
            raise spec_error(f"{value} must be at least {self.at_least:g}", self._example())
        if self.below is not None and not number < self.below:
            raise spec_error(f"{value} must be below {self.below:g}", self._example())

    def _example(self) -> str:
        return f"write e.g. {DIMENSIONS[self.dimension].example}"


def _kind(value: Any) -> str:
    if value is None:
        return "nothing"
    if isinstance(value, bool):
        return f"{str(value).lower()} (true or false)"
    if isinstance(value, Mapping):
        return "a mapping"
    if isinstance(value, list):
        return "a list"
    return repr(value)


Length: TypeAlias = Annotated[float, QuantityOf("length")]
PositiveLength: TypeAlias = Annotated[float, QuantityOf("length", above=0.0)]
Angle: TypeAlias = Annotated[float, QuantityOf("angle")]
Mass: TypeAlias = Annotated[float, QuantityOf("mass", at_least=0.0)]
Inertia: TypeAlias = Annotated[float, QuantityOf("inertia", at_least=0.0)]
Duration: TypeAlias = Annotated[float, QuantityOf("time", above=0.0)]
Frequency: TypeAlias = Annotated[float, QuantityOf("frequency", above=0.0)]
Force: TypeAlias = Annotated[float, QuantityOf("force", at_least=0.0)]
Acceleration: TypeAlias = Annotated[float, QuantityOf("acceleration", at_least=0.0)]
AccelerationDensity: TypeAlias = Annotated[float, QuantityOf("acceleration density", above=0.0)]
Stress: TypeAlias = Annotated[float, QuantityOf("stress", above=0.0)]
Density: TypeAlias = Annotated[float, QuantityOf("density", above=0.0)]
Expansion: TypeAlias = Annotated[float, QuantityOf("expansion")]
Stiffness: TypeAlias = Annotated[float, QuantityOf("stiffness", above=0.0)]
RotationalStiffness: TypeAlias = Annotated[float, QuantityOf("rotational stiffness", above=0.0)]
Ratio: TypeAlias = Annotated[float, QuantityOf("ratio", above=0.0)]
Count: TypeAlias = Annotated[float, QuantityOf("ratio", at_least=1.0)]
