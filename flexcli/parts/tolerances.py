"""Tolerances: the variation from part to part of the numbers that a spec states."""

from collections.abc import Mapping, Sequence
from math import isfinite, sqrt
from typing import Annotated, Any, Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, GetJsonSchemaHandler, field_validator, model_validator
from pydantic_core import CoreSchema

from flexcli.numerics.rows import Rows, number
from flexcli.parts.base import Part, QuantityOf, spec_error
from flexcli.parts.named import marked
from flexcli.units import (
    DIMENSIONS,
    MAX_LENGTH,
    QuantityError,
    number_and_unit,
    parse_quantity,
)

__all__ = ["Place", "Robust", "Spread", "Tolerance", "place_of", "refuse_misfit", "with_number"]

Floats = NDArray[np.float64]

SIGMAS = 3.0
"""Standard deviations from the mean at which the worst case of a normal distribution lies."""

Kind = Literal["uniform", "normal", "measured"]

WRITTEN = (
    "write 5 um, 2 %, [-2 um, 5 um], {normal: 3 um} of one standard deviation, "
    "or {measured: [0.198 mm, 0.203 mm]}"
)

MEASURED_LEAST = 2
"""Least number of measured values that give a distribution."""


class Spread(NamedTuple):
    """Distribution of deviations from nominal [SI]: uniform, normal about zero, or as measured.

    ``low`` and ``high`` are the ends, of a normal one those of :data:`SIGMAS`; ``values`` are the
    measured deviations, each equally likely.
    """

    kind: Kind
    low: float
    high: float
    values: tuple[float, ...] = ()

    @property
    def sigma(self) -> float:
        """Return the standard deviation [SI]."""
        if self.kind == "uniform":
            return (self.high - self.low) / sqrt(12.0)
        if self.kind == "normal":
            return self.high / SIGMAS
        return float(np.std(np.asarray(self.values)))

    def ppf(self, shares: Any) -> Floats:
        """Return the quantiles of the deviations at these probabilities."""
        q = np.asarray(shares, dtype=np.float64)
        if self.kind == "uniform":
            return np.asarray(self.low + (self.high - self.low) * q)
        if self.kind == "normal":
            from scipy.special import ndtri

            return np.asarray(self.sigma * ndtri(q))
        each = np.sort(np.asarray(self.values))
        return np.asarray(each[np.minimum((q * each.size).astype(int), each.size - 1)])

    def scaled(self, factor: float) -> "Spread":
        """Return the same distribution, its width multiplied by a factor."""
        values = tuple(factor * value for value in self.values)
        return Spread(self.kind, factor * self.low, factor * self.high, values)


class Tolerance(Part):
    """Variation of one number from part to part.

    A plain quantity is the greatest deviation either way, uniformly distributed.
    """

    uniform: tuple[str, ...] = ()
    """Most that it is off by, or least and most, all between as likely, e.g. ``[-2 um, 5 um]``."""
    normal: str = ""
    """Standard deviation of a normal spread, e.g. ``3 um``."""
    measured: tuple[str, ...] = ()
    """Values as measured on parts, each as likely, e.g. ``[0.198 mm, 0.203 mm, 0.201 mm]``."""
    nominal: str = ""
    """What the measured parts were made to; left out, their values count as they are,
    e.g. ``nominal: 0.2 mm, measured: [0.198 mm, 0.203 mm]``.
    """
    each: Literal["part", "blade"] = "part"
    """Whether all blades of a part are off alike, or each by itself,
    e.g. ``each: blade, normal: 3 um``.
    """

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any) -> Any:
        if isinstance(data, str | int | float | list) and not isinstance(data, bool):
            data = {"uniform": data}
        if not isinstance(data, dict):
            raise spec_error("a tolerance is a quantity or says its spread", WRITTEN)
        found = dict(data)
        for name in ("uniform", "measured"):
            given = found.get(name, ())
            found[name] = [str(x) for x in (given if isinstance(given, list | tuple) else [given])]
        for name in ("normal", "nominal"):
            found[name] = str(found.get(name, ""))
        return found

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        from flexcli.unit_patterns import number_pattern  # loads Pint

        whole = handler.resolve_ref_schema(handler(schema))
        text = {"type": "string", "pattern": f"^{number_pattern('')}", "maxLength": MAX_LENGTH}
        one = {"anyOf": [text, {"type": "number"}]}
        ends = {"type": "array", "items": one, "minItems": 1, "maxItems": 2}
        several = {"type": "array", "items": one, "minItems": MEASURED_LEAST}
        given: dict[str, dict[str, Any]] = {
            "uniform": {"anyOf": [one, ends]},
            "normal": one,
            "measured": several,
            "nominal": one,
        }
        said = {name: {**whole["properties"][name], **form} for name, form in given.items()}
        for form in said.values():
            form.pop("type", None)
            form.pop("default", None)
        said["measured"] = {**said["measured"], "type": "array"}
        mapping = {
            **whole,
            "properties": {**whole["properties"], **said},
            "oneOf": [{"required": [name]} for name in ("uniform", "normal", "measured")],
        }
        return {"anyOf": [one, ends, mapping]}

    @model_validator(mode="after")
    def _is_one(self) -> "Tolerance":
        if sum(map(bool, (self.uniform, self.normal, self.measured))) != 1:
            raise spec_error("a tolerance has one spread", WRITTEN)
        if len(self.uniform) > 2:
            raise spec_error("a spread between ends has two", "write [-2 um, 5 um]")
        if self.nominal and not self.measured:
            raise spec_error("'nominal' is what measured parts were made to", "leave it out")
        if self.measured and len(self.measured) < MEASURED_LEAST:
            raise spec_error("one measured part tells no spread", "give the values of more")
        return self

    @field_validator("uniform", "measured")
    @classmethod
    def _are_numbers(cls, value: tuple[str, ...]) -> tuple[str, ...]:
        for text in value:
            _refuse_text(text)
        return value

    @field_validator("normal", "nominal")
    @classmethod
    def _is_number(cls, value: str) -> str:
        if value:
            _refuse_text(value)
        return value

    def spread(self, dimension: str, nominal: float) -> Spread:
        """Return the distribution of the deviations of a number of a dimension [SI].

        Raises a finding where the units do not fit, or the number would change its sign.
        """
        if self.measured:
            at = _read(self.nominal, dimension, nominal) if self.nominal else nominal
            values = tuple(_read(text, dimension, nominal) - at for text in self.measured)
            found = Spread("measured", min(values), max(values), values)
        elif self.normal:
            sigma = _read(self.normal, dimension, nominal)
            found = Spread("normal", -SIGMAS * sigma, SIGMAS * sigma)
        else:
            ends = [_read(text, dimension, nominal) for text in self.uniform]
            found = Spread("uniform", ends[0] if len(ends) == 2 else -ends[0], ends[-1])
        if not found.low < found.high:
            raise spec_error("a tolerance is above zero, its ends in order", WRITTEN)
        if nominal > 0.0 and nominal + found.low <= 0.0:
            raise spec_error("a tolerance as large as the number itself", "check both units")
        return found


def _refuse_text(text: str) -> None:
    parts = number_and_unit(text)
    if parts is None or not isfinite(parts[0]):
        raise spec_error(f"'{text}' is no number with a unit", WRITTEN)


def _read(text: str, dimension: str, nominal: float) -> float:
    """Return a quantity of a dimension [SI], or a share of the nominal where it is in per cent."""
    parts = number_and_unit(text)
    if parts is not None and parts[1] == "%":
        return parse_quantity(text, "ratio") * abs(nominal)
    try:
        return parse_quantity(text, dimension)
    except QuantityError as error:
        example = DIMENSIONS[dimension].example
        raise spec_error(str(error), f"write it like {example}, or in %") from None


class Robust(Part):
    """What share of the parts shall pass, or all of them up to the ends of their tolerances."""

    parts: Annotated[float, QuantityOf("ratio", above=0.0, below=1.0)] | None = None
    """Share of the parts, made within the tolerances, that shall pass, e.g. ``99.7 %``."""

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any) -> Any:
        if data == "worst-case":
            return {}
        if not isinstance(data, dict) or set(data) != {"parts"}:
            raise spec_error("robust is a share of parts or the worst case",
                             "write {parts: 99.7 %} or worst-case")  # fmt: skip
        return data

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        whole = handler.resolve_ref_schema(handler(schema))
        return {"anyOf": [{"const": "worst-case"}, {**whole, "required": ["parts"]}]}


class Place(NamedTuple):
    """Place of a number in a design: the steps to it, its dimension, its value if any."""

    path: tuple[str | int, ...]
    dimension: str
    value: float | None


INSIDE = ("value", "fixed", "end")
"""Fields that hold the number of a part that a spec writes as one: of a property, of a size, of
a travel."""


def place_of(design: Any, name: str) -> Place:
    """Return the place of a tolerance's number: a size, a property, or a path of the spec.

    Raises a finding where there is no such number.
    """
    if "." in name:
        steps: list[str | int] = []
        for word in name.split("."):
            key, *indices = word.rstrip("]").replace("]", "").split("[")
            steps += [key, *map(int, indices)]
        found = _number_at(design, tuple(steps))
        cases = design.cases
        if found is None and len(cases) == 1:  # which may stand at the top level
            found = _number_at(design, ("cases", *cases, *steps))
    else:
        geometry = design.geometry
        inside = geometry.place(name) if name in geometry.extents else ("geometry", name)
        found = _number_at(design, inside) or _number_at(design, ("material", name))
    if found is None:
        hint = "name a size (h), a property of the material (youngs_modulus), or a path of the spec"
        raise spec_error(f"there is no number '{name}' here", hint)
    return found


def _number_at(part: Any, path: tuple[str | int, ...]) -> Place | None:
    steps: list[str | int] = []
    marker: QuantityOf | None = None
    for step in path:
        if isinstance(part, BaseModel):
            field = _field(part, str(step))
            if field is None:
                return None
            info = type(part).model_fields[field]
            marker = _marker(marked(info.annotation, info.metadata), info.metadata)
            steps.append(field)
            part = getattr(part, field)
        elif _holds(part, step):
            steps.append(step)
            part = part[step]
        else:
            return None
    if isinstance(part, BaseModel):
        if getattr(part, "start", None) is not None:
            return None  # a range has two numbers
        inner = next((name for name in INSIDE if name in type(part).model_fields), None)
        inside = None if inner is None else _number_at(part, (inner,))
        return None if inside is None else inside._replace(path=(*steps, *inside.path))
    if marker is None or not isinstance(part, float | int | Rows | None):
        return None
    if part is None and steps[-1] not in INSIDE:
        return None
    return Place(tuple(steps), marker.dimension, None if part is None else number(part))


def _holds(part: Any, step: str | int) -> bool:
    if isinstance(part, Mapping):
        return step in part
    return isinstance(part, Sequence) and isinstance(step, int) and step < len(part)


def _field(part: BaseModel, key: str) -> str | None:
    """Return the field that a key of the spec names."""
    for name, info in type(part).model_fields.items():
        if key in (name, info.alias):
            return name
    return None


def _marker(annotation: Any, metadata: Sequence[Any]) -> QuantityOf | None:
    found = next((each for each in metadata if isinstance(each, QuantityOf)), None)
    if found is not None:
        return found
    for each in (*getattr(annotation, "__metadata__", ()), *get_args(annotation)):
        inner = each if isinstance(each, QuantityOf) else _marker(each, ())
        if inner is not None:
            return inner
    return None


def with_number(part: Any, path: tuple[str | int, ...], value: float) -> Any:
    """Return a part with the number at a path replaced, without values derived from the old one."""
    if not path:
        return value
    step, *rest = path
    if isinstance(part, Mapping):
        return {**part, step: with_number(part[step], tuple(rest), value)}
    if isinstance(part, BaseModel):
        field = str(step)
        new = with_number(getattr(part, field), tuple(rest), value)
        found = part.model_copy(update={field: new})
        for name in set(found.__dict__) - set(type(part).model_fields):
            found.__dict__.pop(name)  # a cached property
        return found
    items = list(part)
    items[int(step)] = with_number(items[int(step)], tuple(rest), value)
    return tuple(items)


def refuse_misfit(design: Any) -> None:
    """Raise a finding where a tolerance names no number of the design, or has another unit."""
    for name, tolerance in design.tolerances.items():
        try:
            place = place_of(design, name)
            tolerance.spread(place.dimension, 1.0 if place.value is None else place.value)
        except Exception as error:
            context = getattr(error, "context", None)
            if context is None:
                raise
            raise spec_error(context["text"], context["hint"], at=("tolerances", name)) from None
        if place.value is None and tolerance.measured and not tolerance.nominal:
            raise spec_error(
                f"{name} is chosen: say what the measured parts were made to",
                "add nominal: 0.2 mm", at=("tolerances", name),
            )  # fmt: skip
        if tolerance.each == "blade" and place.path[0] != "geometry":
            text = f"{name} is not of a blade: it is one number of the whole design"
            raise spec_error(text, "leave 'each' out", at=("tolerances", name))
    if design.robust is not None and not design.tolerances:
        raise spec_error("robust against what? there are no tolerances",
                         "add tolerances: {h: 5 um}", at=("robust",))  # fmt: skip
