"""What ``flexure balance`` is asked beside the mechanism: frequencies, tolerances, surroundings."""

from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import AliasPath, Field, GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema

from flexcli.parts.asd import RandomVibration
from flexcli.parts.base import Acceleration, Frequency, Part, QuantityOf, spec_error
from flexcli.units import STANDARD_GRAVITY

__all__ = ["BalanceOptions", "Frequencies", "Tolerances"]

LengthTolerance = Annotated[float, QuantityOf("length", at_least=0.0)]
MassTolerance = Annotated[float, QuantityOf("mass", at_least=0.0)]

MOST_POINTS = 100_000

DECADES = (1.0, 10.0, 100.0, 1000.0)
"""Frequencies where nothing else is asked [Hz]."""


class Tolerances(Part):
    """How far the numbers of the built stage may be off, ±, each on its own."""

    mass: MassTolerance = 0.0
    """Tolerance of the mass of every body, ±, e.g. ``50 mg``."""
    com: LengthTolerance = 0.0
    """Tolerance of the centres of mass of solids 1 and 3, ±, e.g. ``50 um``."""
    arm: LengthTolerance = 0.0
    """Tolerance of the arms of the balancing masses, ±, e.g. ``50 um``."""
    height: LengthTolerance = 0.0
    """Tolerance of the height of the levers, ±, e.g. ``10 um``."""

    @property
    def any(self) -> bool:
        """Return whether one is given."""
        return any((self.mass, self.com, self.arm, self.height))


class Frequencies(Part):
    """Where the transfer function is asked: a list, or {from, to, points} in even ratios."""

    is_plain: ClassVar[bool] = True

    listed: tuple[Frequency, ...] = ()
    lowest: Frequency | None = Field(None, validation_alias=AliasPath("sweep", "from"))
    highest: Frequency | None = Field(None, validation_alias=AliasPath("sweep", "to"))
    points: Annotated[int, Field(strict=True, ge=2, le=MOST_POINTS)] = Field(
        100, validation_alias=AliasPath("sweep", "points")
    )

    @model_validator(mode="before")
    @classmethod
    def _list_or_sweep(cls, data: Any) -> Any:
        if isinstance(data, list) and data:
            return {"listed": data}
        if isinstance(data, dict) and {"from", "to"} <= set(data) <= {"from", "to", "points"}:
            return {"sweep": data}
        raise spec_error(
            "frequencies are a list, or a sweep",
            "write [10 Hz, 100 Hz], or {from: 10 Hz, to: 1 kHz, points: 100}",
        )

    @model_validator(mode="after")
    def _in_order(self) -> "Frequencies":
        if self.lowest is not None and self.highest is not None and self.lowest >= self.highest:
            raise spec_error("the sweep does not rise", "write {from: lowest, to: highest}")
        return self

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        one = QuantityOf("frequency", above=0.0).json_schema()
        points = {
            "type": "integer",
            "minimum": 2,
            "maximum": MOST_POINTS,
            "description": "Number of frequencies, in equal ratios",
            "examples": [100],
        }
        sweep = {
            "type": "object",
            "properties": {
                "from": {"allOf": [one], "description": "Lowest frequency"},
                "to": {"allOf": [one], "description": "Highest frequency"},
                "points": points,
            },
            "required": ["from", "to"],
            "additionalProperties": False,
        }
        return {"anyOf": [{"type": "array", "items": one, "minItems": 1}, sweep]}

    def values(self) -> tuple[float, ...]:
        """Return the frequencies [Hz]."""
        if self.lowest is None or self.highest is None:
            return self.listed
        return tuple(float(f) for f in np.geomspace(self.lowest, self.highest, self.points))


class BalanceOptions(Part):
    """The section ``balance``: what is reported of the mechanism on its shaking base."""

    frequencies: Frequencies | None = None
    """Where the transfer function is printed: a list, or a sweep,
    e.g. ``{from: 1 Hz, to: 1 kHz, points: 50}``.
    """
    tolerances: Tolerances = Tolerances.model_construct()
    """How far the built stage may be off, e.g. ``{mass: 50 mg, arm: 50 um}``."""
    asd: RandomVibration | None = None
    """Vibration of the base while the mechanism is free to move,
    e.g. ``{profile: gevs-qualification, q: 100}``.
    """
    gravity: Acceleration = STANDARD_GRAVITY
    """Gravity that the orientation of the stage turns about, e.g. ``9.81 m/s^2``."""

    def asked(self) -> tuple[float, ...]:
        """Return the frequencies of the transfer function [Hz]."""
        return self.frequencies.values() if self.frequencies else DECADES
