"""A sinusoidal motion of the base: at one frequency, or sweeping from one to another."""

import re
from abc import abstractmethod
from itertools import combinations, pairwise
from math import log2, pi
from typing import Annotated, Any, ClassVar, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import BeforeValidator, Field, GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema

from flexcli.parts.base import Frequency, Part, QuantityOf, spec_error
from flexcli.units import STANDARD_GRAVITY, show

__all__ = ["Sine", "Sweep", "SweepRate", "Tone"]

Floats = NDArray[np.float64]

LEVELS = ("acceleration", "velocity", "displacement")

Amplitude = Annotated[float, QuantityOf("acceleration", above=0.0)]

_OCTAVES = re.compile(r"\s*(\S+)\s*oct/min\s*")

LONGEST_SWEEP = 1e6
"""Time [s] beyond which a sweep rate is hardly meant."""


class _Levels(Part):
    """Amplitudes of a sine: of acceleration, velocity or displacement.

    Of several the least counts at each frequency, as tests are specified: the displacement at low
    frequencies, the acceleration beyond the crossover.
    """

    word: ClassVar[str] = "sine"

    given_acceleration: Amplitude | None = Field(None, alias="acceleration")
    """Amplitude of the acceleration, e.g. ``2 g``."""
    velocity: Annotated[float, QuantityOf("velocity", above=0.0)] | None = None
    """Amplitude of the velocity, e.g. ``0.5 m/s``."""
    displacement: Annotated[float, QuantityOf("length", above=0.0)] | None = None
    """Amplitude of the displacement, half of peak to peak, e.g. ``10 mm``."""
    axis: Literal["x", "y", "z"] = "x"
    """Axis along which the base moves, e.g. ``axis: y, acceleration: 2 g``."""

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        whole = handler.resolve_ref_schema(handler(schema))
        return {**whole, "anyOf": [{"required": [key]} for key in LEVELS]}

    @model_validator(mode="after")
    def _has_a_level(self) -> "_Levels":
        if not any(self._given):
            raise spec_error(
                "nothing says how strong the sine is",
                f"give {' or '.join(LEVELS)}, e.g. acceleration: 2 g",
            )
        return self

    @property
    def _given(self) -> tuple[float | None, ...]:
        return self.given_acceleration, self.velocity, self.displacement

    def level(self, f: Floats) -> Floats:
        """Return the amplitude of the acceleration [m/s²] at frequencies [Hz], shape of f."""
        omega = 2.0 * np.pi * f
        each = [a * omega**n for n, a in enumerate(self._given) if a is not None]
        return np.asarray(np.minimum.reduce(each))

    def governing(self, f: float) -> tuple[int, float]:
        """Return which level is the least at a frequency [Hz], and its amplitude.

        It is 0 of the acceleration [m/s²], 1 of the velocity [m/s], 2 of the displacement [m].
        """
        omega = 2.0 * pi * f
        given = [(n, a) for n, a in enumerate(self._given) if a is not None]
        return min(given, key=lambda each: each[1] * omega ** each[0])

    @property
    @abstractmethod
    def band(self) -> tuple[float, float]:
        """Return the lowest and the highest frequency [Hz]."""

    @property
    def crossovers(self) -> tuple[float, ...]:
        """Return the frequencies at which another level takes over [Hz]."""
        low, high = self.band
        given = [(n, a) for n, a in enumerate(self._given) if a is not None]
        found = []
        for (n, a), (m, b) in combinations(given, 2):
            f = (a / b) ** (1.0 / (m - n)) / (2.0 * pi)
            is_least = abs(float(self.level(np.array(f))) / (a * (2.0 * pi * f) ** n) - 1.0) < 1e-9
            if low < f < high and is_least:
                found.append(f)
        return tuple(sorted(found))

    @property
    def told(self) -> str:
        """Return it in words, with its crossovers."""
        low, high = self.band
        if low == high:
            size = float(self.level(np.array(low))) / STANDARD_GRAVITY
            return f"{self.word} of {show(size, 'g')} at {low:g} Hz along {self.axis}"
        edges = [low, *self.crossovers, high]
        parts = []
        for a, b in pairwise(edges):
            n, size = self.governing((a * b) ** 0.5)
            unit = ("", "m/s", "m")[n]
            shown = show(size, unit) if n else show(size / STANDARD_GRAVITY, "g")
            parts.append(f"{shown} to {b:.4g} Hz")
        return f"{self.word} from {low:g} Hz, {', '.join(parts)}, along {self.axis}"


class Sine(_Levels):
    """A sine of the base: its amplitude and frequency."""

    frequency: Frequency
    """Frequency of the sine, e.g. ``60 Hz``."""

    @property
    def band(self) -> tuple[float, float]:
        """Return its frequency, twice [Hz]."""
        return self.frequency, self.frequency

    @property
    def acceleration(self) -> float:
        """Return the amplitude of the acceleration [m/s²]."""
        return float(self.level(np.array(self.frequency)))


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


class Sweep(_Levels):
    """A sine of the base whose frequency goes from one value to another."""

    word: ClassVar[str] = "sweep"

    start: Frequency = Field(alias="from")
    """Frequency where the sweep starts, e.g. ``5 Hz``."""
    end: Frequency = Field(alias="to")
    """Frequency where the sweep ends, e.g. ``100 Hz``."""
    rate: Annotated[SweepRate, BeforeValidator(_rate)]
    """How fast the frequency goes: in Hz/s, or oct/min for equal ratios in equal times,
    e.g. ``2 oct/min``.
    """

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
    def acceleration(self) -> float | None:
        """Return the amplitude of the acceleration [m/s²], nothing where it is not constant."""
        low, high = self.band
        governs = {self.governing(f) for f in (low, high)}
        constant = len(governs) == 1 and not self.crossovers and next(iter(governs))[0] == 0
        return self.given_acceleration if constant else None

    @property
    def band(self) -> tuple[float, float]:
        """Return the lowest and the highest frequency [Hz]."""
        return min(self.start, self.end), max(self.start, self.end)

    @property
    def duration(self) -> float:
        """Return the time from one end to the other [s]."""
        if self.rate.is_linear:
            return abs(self.end - self.start) / self.rate.speed
        return abs(log2(self.end / self.start)) / self.rate.speed


class Tone(_Levels):
    """A sine on random vibration: at one frequency, or anywhere between two."""

    at: Frequency | None = Field(None, alias="frequency")
    """Frequency of the sine; or give from and to,
    e.g. ``frequency: 60 Hz, acceleration: 3 g``.
    """
    start: Frequency | None = Field(None, alias="from")
    """Lowest frequency at which it may stand,
    e.g. ``from: 40 Hz, to: 60 Hz, acceleration: 3 g``.
    """
    end: Frequency | None = Field(None, alias="to")
    """Highest frequency at which it may stand,
    e.g. ``to: 60 Hz, from: 40 Hz, acceleration: 3 g``.
    """

    @model_validator(mode="after")
    def _stands_somewhere(self) -> "Tone":
        ends = (self.start, self.end)
        if (self.at is None) == (ends == (None, None)) or (self.at is None and None in ends):
            text = "a sine stands at one frequency, or between two"
            raise spec_error(text, "give frequency: 60 Hz, or from: 40 Hz and to: 60 Hz")
        return self

    @property
    def band(self) -> tuple[float, float]:
        """Return the lowest and the highest frequency [Hz]."""
        if self.at is not None:
            return self.at, self.at
        ends = [f for f in (self.start, self.end) if f is not None]
        return min(ends), max(ends)
