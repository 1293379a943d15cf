"""What every part is made of: a frozen model, and quantities that carry their units."""

from collections.abc import Mapping, Sequence
from math import isfinite, nan
from typing import Annotated, Any, ClassVar, TypeAlias

import numpy as np
from pydantic import (
    BaseModel,
    ConfigDict,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    model_validator,
)
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from flexcli.numerics.rows import Diverged, Rows
from flexcli.units import (
    DIMENSIONS,
    LARGEST,
    MAX_LENGTH,
    QuantityError,
    number_and_unit,
    parse_quantity,
    show,
)

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
    "OfTable",
    "OneOrMore",
    "OrTable",
    "Part",
    "PositiveLength",
    "QuantityOf",
    "Ratio",
    "RotationalStiffness",
    "Shorthand",
    "Stiffness",
    "Stress",
    "Texts",
    "in_either",
    "or_free",
    "said",
    "spec_error",
]


class Part(BaseModel):
    """A frozen, validated piece of a spec that refuses keys it does not know.

    A default that is a part itself is made by ``model_construct``: to validate it at import would
    build its schema apart from the design's, at every start.
    """

    is_plain: ClassVar[bool] = False
    """Whether a spec writes it as a plain value or a list, without field names."""

    model_config = ConfigDict(
        frozen=True, extra="forbid", arbitrary_types_allowed=True, defer_build=True
    )


class Shorthand(Part):
    """A part that may be written as the plain value of one of its fields."""

    stands_for: ClassVar[str]
    """The field that a plain value gives."""

    @model_validator(mode="before")
    @classmethod
    def _from_plain(cls, data: Any) -> Any:
        return data if isinstance(data, dict) else {cls.stands_for: data}

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        whole = handler.resolve_ref_schema(handler(schema))
        plain = {k: v for k, v in whole["properties"][cls.stands_for].items() if k != "title"}
        return {"anyOf": [plain, whole]}


def spec_error(text: str, hint: str = "", at: tuple[str | int, ...] = ()) -> PydanticCustomError:
    """Return a finding for a validator to raise: what is wrong and what would be right.

    ``at`` is the path of the value at fault, below the model whose validator raises.
    """
    message = text.replace("{", "(").replace("}", ")")
    return PydanticCustomError("spec", "{text}", {"text": message, "hint": hint, "at": list(at)})


class OneOrMore:
    """A type marker of lists: in a spec one value stands for a list of it alone."""

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        several = {"minItems": 1, **handler(schema)}
        return {"anyOf": [several["items"], several]}


class OrTable:
    """A type marker of lists of points: in a spec a table of them may be named in their place."""

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return {"anyOf": [{"minItems": 2, **handler(schema)}, self.schema()]}

    @staticmethod
    def schema() -> dict[str, Any]:
        """Return the JSON Schema of a table's name."""
        suffix = r"\.([cC][sS][vV]|[tT][sS][vV]|[tT][xX][tT]|[pP][aA][rR][qQ][uU][eE][tT])$"
        path = {"type": "string", "pattern": suffix, "examples": ["psd.csv"]}
        text = {"type": "string"}
        told = {
            "type": "object",
            "properties": {
                "file": {**path, "description": "Path of the table, from the spec's folder"},
                "units": {
                    "type": "array",
                    "items": text,
                    "minItems": 2,
                    "maxItems": 2,
                    "description": "Units of both columns, where the heading tells none",
                    "examples": [["Hz", "g^2/Hz"]],
                },
                "column": {
                    "anyOf": [text, {"type": "integer"}],
                    "description": "Name or number of the column to take, of several",
                    "examples": [2],
                },
            },
            "required": ["file"],
            "additionalProperties": False,
        }
        return {"anyOf": [path, told]}


class OfTable:
    """A type marker of what only a table can give: in a spec the table is named."""

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return OrTable.schema()


class Texts:
    """The texts at one place of the spec, one for each of many designs."""

    def __init__(self, texts: Sequence[str]) -> None:
        self.texts = texts


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
        return self.json_schema()

    def json_schema(self) -> dict[str, Any]:
        """Return the JSON Schema of how a spec writes it; its title names it among all."""
        from flexcli.unit_patterns import quantity_pattern  # loads Pint

        expected = DIMENSIONS[self.dimension]
        pattern = quantity_pattern(self.dimension, self._sign)
        text = {"type": "string", "pattern": pattern, "maxLength": MAX_LENGTH}
        bounds = [(words, bound) for words, bound, _ in self._bounds(0.0) if bound is not None]
        title = {"title": " ".join([self.dimension, *(f"{w} {x:g}" for w, x in bounds)])}
        if expected.si:
            wrong = f"{expected.named} with its unit, e.g. {expected.example}"
            return {**title, **text, "patternErrorMessage": wrong, "examples": [expected.example]}
        ends = {
            "exclusiveMinimum": self.above,
            "minimum": self.at_least,
            "exclusiveMaximum": self.below,
            "maximum": LARGEST,
        }
        number = {"type": "number"} | {key: x for key, x in ends.items() if x is not None}
        inside = 0.5 * (self.below or self.above or 0.0)
        shown = float(expected.example) if self.below is None else inside
        return {**title, "anyOf": [number, text], "examples": [shown]}

    @property
    def _sign(self) -> str:
        """Return the sign that the bounds allow, as the patterns of quantities name it."""
        least = next((x for x in (self.above, self.at_least) if x is not None), -1.0)
        if self.below is not None and self.below <= 0.0:
            return "-"
        return "" if least < 0.0 else "0+" if self.at_least == 0.0 else "+"

    def _bounds(self, number: float) -> tuple[tuple[str, float | None, bool], ...]:
        """Return each bound in words, its value, and whether a number satisfies it."""
        return (
            ("above", self.above, self.above is None or number > self.above),
            ("at least", self.at_least, self.at_least is None or number >= self.at_least),
            ("below", self.below, self.below is None or number < self.below),
        )

    def read(self, value: Any) -> float:
        """Return the SI value of the text of a spec, or raise what is wrong with it."""
        expected = DIMENSIONS[self.dimension]
        if isinstance(value, Texts):
            return self._read_each(value.texts)
        if isinstance(value, str):
            number = self._parsed(value)
        elif isinstance(value, bool) or not isinstance(value, int | float):
            raise spec_error(
                f"{expected.named} is expected here, not {said(value)}",
                f"write e.g. {expected.example}",
            )
        elif not isfinite(value):
            raise spec_error(f"{expected.named} must be finite", f"write e.g. {expected.example}")
        elif self.dimension != "ratio":
            raise spec_error(
                f"{value} has no unit",
                f"{expected.named} needs a unit, e.g. {value} {expected.unit}",
            )
        else:
            number = self._parsed(repr(value))
        self._refuse_outside(number, value)
        return number

    def _read_each(self, texts: Sequence[str]) -> float:
        """Return the values of many designs; those that cannot be read are split off."""
        found, fails = [], []
        for text in texts:
            try:
                found.append(self.read(text))
            except PydanticCustomError as error:
                fails.append(error)
                found.append(nan)
        if len(fails) == len(texts):
            raise fails[0]
        if fails:
            raise Diverged(np.isnan(found))
        each: float = Rows.of(found)
        return each

    def _parsed(self, text: str) -> float:
        try:
            return parse_quantity(text, self.dimension)
        except QuantityError as error:
            raise spec_error(str(error), error.hint) from None

    def _refuse_outside(self, number: float, value: Any) -> None:
        expected = DIMENSIONS[self.dimension]
        bounds = {
            f"{words} {show(bound, expected.si) if bound else 0}": holds
            for words, bound, holds in self._bounds(number)
            if bound is not None
        }
        for bound, holds in bounds.items():
            if not holds:
                example = f", e.g. {expected.example}" if expected.si else ""
                hint = f"write {expected.named} {' and '.join(bounds)}{example}"
                raise spec_error(f"{value} must be {bound}", hint)


def or_free(quantity: QuantityOf) -> dict[str, Any]:
    """Return the JSON Schema of a quantity, ``free``, or free between bounds."""
    given = quantity.json_schema()
    ends = {"type": "array", "items": {"anyOf": [given, {"type": "null"}]}}
    free = {
        **ends,
        "minItems": 2,
        "maxItems": 2,
        "description": "Bounds between which it is chosen, least and most; null is no bound",
        "examples": [[None, DIMENSIONS[quantity.dimension].example]],
    }
    bounded = {
        "type": "object",
        "properties": {"free": free},
        "required": ["free"],
        "additionalProperties": False,
    }
    title = {"title": f"{given['title']}, or free"}
    return {**title, "anyOf": [given, {"const": "free"}, bounded]}


def in_either(value: Any, *dimensions: str) -> tuple[float, str]:
    """Return a positive value with its SI unit, of whichever of the dimensions it has."""
    if isinstance(value, str):
        _, unit = number_and_unit(value) or (0.0, "")
        # an everyday unit is known without the library of all others
        for dimension in sorted(dimensions, key=lambda name: unit not in DIMENSIONS[name].units):
            try:
                number = parse_quantity(value, dimension)
            except QuantityError:
                continue
            if number <= 0.0:
                raise spec_error(
                    f"{value} must be above 0", f"write e.g. {DIMENSIONS[dimension].example}"
                )
            return number, DIMENSIONS[dimension].si
        examples = " or ".join(DIMENSIONS[dimension].example for dimension in dimensions)
        named = " nor ".join(DIMENSIONS[dimension].named for dimension in dimensions)
        raise spec_error(f"'{value[:60]}' is neither {named}", f"write e.g. {examples}")
    return QuantityOf(dimensions[0], above=0.0).read(value), DIMENSIONS[dimensions[0]].si


def said(value: Any) -> str:
    """Return a value of a spec as text for a message, shortened."""
    if value is None:
        return "nothing"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, Mapping):
        return "a mapping"
    if isinstance(value, list):
        return "a list"
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:59]}…"


Length: TypeAlias = Annotated[float, QuantityOf("length")]
PositiveLength: TypeAlias = Annotated[float, QuantityOf("length", above=0.0)]
Angle: TypeAlias = Annotated[float, QuantityOf("angle")]
Mass: TypeAlias = Annotated[float, QuantityOf("mass", at_least=0.0)]
Inertia: TypeAlias = Annotated[float, QuantityOf("inertia", at_least=0.0)]
Duration: TypeAlias = Annotated[float, QuantityOf("time", above=0.0)]
Frequency: TypeAlias = Annotated[float, QuantityOf("frequency", above=0.0)]
Force: TypeAlias = Annotated[float, QuantityOf("force", at_least=0.0)]
PositiveForce: TypeAlias = Annotated[float, QuantityOf("force", above=0.0)]
Acceleration: TypeAlias = Annotated[float, QuantityOf("acceleration", at_least=0.0)]
AccelerationDensity: TypeAlias = Annotated[float, QuantityOf("acceleration density", above=0.0)]
Stress: TypeAlias = Annotated[float, QuantityOf("stress", above=0.0)]
Density: TypeAlias = Annotated[float, QuantityOf("density", above=0.0)]
Expansion: TypeAlias = Annotated[float, QuantityOf("expansion")]
Stiffness: TypeAlias = Annotated[float, QuantityOf("stiffness", above=0.0)]
RotationalStiffness: TypeAlias = Annotated[float, QuantityOf("rotational stiffness", above=0.0)]
Ratio: TypeAlias = Annotated[float, QuantityOf("ratio", above=0.0)]
Count: TypeAlias = Annotated[float, QuantityOf("ratio", at_least=1.0)]
