"""A sinusoidal motion of the base: at one frequency, or sweeping from one to another."""

import re
from math import log2
from typing import Annotated, Any, NamedTuple

from pydantic import BeforeValidator, Field, GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema

from flexcli.parts.base import Frequency, Part, QuantityOf, spec_error

__all__ = ["Sine", "Sweep", "SweepRate"]

Amplitude = Annotated[float, QuantityOf("acceleration", above=0.0)]

_OCTAVES = re.compile(r"\s*(\S+)\s*oct/min\s*")

LONGEST_SWEEP = 1e6
"""Time [s] beyond which a sweep rate is hardly meant."""


class Sine(Part):
    """A sine of the base's acceleration along x, its amplitude and frequency."""

    acceleration: Amplitude
    """Amplitude of the acceleration, e.g. ``2 g``."""
    frequency: Frequency
    """Frequency of the sine, e.g. ``60 Hz``."""


class SweepRate(NamedTuple):
    """How fast the frequency goes: Hz/s where it is linear, octaves per second where not."""

    speed: float
    is_linear: bool

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        from flexcli.unit_patterns import number_pattern  # loads Pint

        linear = QuantityOf("sweep rate", above=0.0).json_schema()
        octaves = {"type": "string", "pattern": f"^\\s*{number_pattern('+')}\\s*oct/min\\s*$"}
        return {"anyOf": [linear, octaves], "examples": ["0.05 Hz/s", "2 oct/min"]}


def _rate(value: Any) -> SweepRate:
    # octaves are a logarithm, no unit that could be converted to others
    octaves = _OCTAVES.fullmatch(value) if isinstance(value, str) else None
    if octaves is None:
        return SweepRate(QuantityOf("sweep rate", above=0.0).read(value), is_linear=True)
    number = QuantityOf("ratio", above=0.0).read(octaves[1])
    return SweepRate(number / 60.0, is_linear=False)


class Sweep(Part):
    """A sine of constant acceleration whose frequency goes from one value to another."""

    start: Frequency = Field(alias="from")
    """Frequency where the sweep starts, e.g. ``5 Hz``."""
    end: Frequency = Field(alias="to")
    """Frequency where the sweep ends, e.g. ``100 Hz``."""
    rate: Annotated[SweepRate, BeforeValidator(_rate)]
    """How fast the frequency goes: in Hz/s, or oct/min for equal ratios in equal times,
    e.g. ``2 oct/min``.
    """
    acceleration: Amplitude
    """Amplitude of the acceleration, e.g. ``1 g``."""

    @model_validator(mode="after")
    def _goes_somewhere(self) -> "Sweep":
        if self.start == self.end:
            raise spec_error("the sweep does not move", "give two frequencies", at=("to",))
        if self.duration > LONGEST_SWEEP:
            raise spec_error(
                f"this sweep takes {self.duration:.3g} s", "check the rate's unit", at=("rate",)
            )
        return self

    @property
    def duration(self) -> float:
        """Return the time from one end to the other [s]."""
        if self.rate.is_linear:
            return abs(self.end - self.start) / self.rate.speed
        return abs(log2(self.end / self.start)) / self.rate.speed
