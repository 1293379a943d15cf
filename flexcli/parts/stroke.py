"""The stroke: what the joint or stage must do, how far and how often."""

from typing import Any, ClassVar, Generic, TypeVar

from pydantic import AliasChoices, AliasPath, Field, GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema

from flexcli.numerics.rows import number
from flexcli.parts.base import Angle, Count, Length, Part, QuantityOf, spec_error

__all__ = ["Stroke"]

Number = TypeVar("Number")


class Travel(Part, Generic[Number]):
    """From where to where; one value v stands for −v to +v."""

    is_plain: ClassVar[bool] = True

    start: Number | None = Field(None, validation_alias=AliasPath("range", 0))
    end: Number = Field(validation_alias=AliasChoices("end", AliasPath("range", 1)))

    @model_validator(mode="before")
    @classmethod
    def _from_amplitude_or_range(cls, data: Any) -> Any:
        if isinstance(data, list):
            if len(data) != 2 or None in data:
                raise spec_error("a range has two values", "write [from, to]")
            return {"range": data}
        if isinstance(data, dict):
            raise spec_error("a travel is a value or a range", "write 410 um, or [0 um, 820 um]")
        if isinstance(data, str) and data.strip().startswith("-"):
            raise spec_error(f"the amplitude {data} is negative", "write it without the sign")
        return {"end": data}

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        value = next(m for m in cls.model_fields["end"].metadata if isinstance(m, QuantityOf))
        both = {"type": "array", "items": value.json_schema(), "minItems": 2, "maxItems": 2}
        amplitude = QuantityOf(value.dimension, at_least=0.0).json_schema()
        return {"anyOf": [amplitude, both]}


class Stroke(Part):
    """Travel of the stage (translation) or of the joint (rotation) and its number of cycles."""

    translation: Travel[Length] | None = None
    """Travel of a stage: an amplitude, or a range, e.g. ``translation: [0 um, 820 um]``."""
    rotation: Travel[Angle] | None = None
    """Turn of a pivot: an amplitude, or a range from rest, e.g. ``rotation: 5 deg``."""
    cycles: Count | None = None
    """Number of cycles, which fatigue asks for, e.g. ``cycles: 1e6, rotation: 5 deg``."""

    @model_validator(mode="after")
    def _one_motion(self) -> "Stroke":
        if (self.translation is None) == (self.rotation is None):
            raise spec_error(
                "a stroke is a translation or a rotation", "give one of them, e.g. rotation: 5 deg"
            )
        if self.amplitude == 0.0 and self.mean == 0.0:
            raise spec_error("the stroke is zero", "give its amplitude, e.g. 410 um")
        return self

    @property
    def motion(self) -> str:
        """Return ``"translation"`` or ``"rotation"``."""
        return "translation" if self.translation is not None else "rotation"

    @property
    def _ends(self) -> tuple[float, float]:
        travel: Travel[Any] | None = self.translation or self.rotation
        assert travel is not None  # held by the validator
        return -travel.end if travel.start is None else travel.start, travel.end

    @property
    def amplitude(self) -> float:
        """Return half of the travel [m or rad]."""
        start, end = self._ends
        return number(abs(end - start) / 2.0)

    @property
    def middle(self) -> float:
        """Return the middle of the travel, with its sign [m or rad]."""
        start, end = self._ends
        return number(end + start) / 2.0

    @property
    def mean(self) -> float:
        """Return the distance of the middle of the travel from rest [m or rad]."""
        return abs(self.middle)
