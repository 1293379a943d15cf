"""A shock of the base: a half-sine, a change of velocity, a response spectrum, or a record."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import BeforeValidator, Field, model_validator

from flexcli.formulas.record_spectrum import shock_response_spectrum
from flexcli.formulas.shock import half_sine_sums, srs_level, velocity_shock_acceleration
from flexcli.parts.base import (
    Duration,
    Frequency,
    OfTable,
    OrTable,
    Part,
    QuantityOf,
    said,
    spec_error,
)
from flexcli.parts.record import Record

__all__ = ["HalfSine", "Shock", "SpectrumPoint"]

Floats = NDArray[np.float64]

LARGEST_HALF_SINE = 1.7685
"""Largest response of any undamped oscillator to a half-sine pulse, over its peak (Ayre 1961)."""

SAME = 1e-6
"""Of a natural frequency: so close together oscillators swing as one while a shock is felt."""


def _recorded(value: Any) -> Record:
    if not isinstance(value, Record):
        text = f"a table over time is expected here, not {said(value)}"
        raise spec_error(text, "write base.csv, or {file: base.csv, units: [s, g]}")
    return value


PeakAcceleration = Annotated[float, QuantityOf("acceleration", above=0.0)]


class HalfSine(Part):
    """A half-sine pulse of the base acceleration."""

    acceleration: PeakAcceleration
    """Peak of the pulse, e.g. ``30 g``."""
    duration: Duration
    """Time that the pulse lasts, e.g. ``11 ms``."""


class SpectrumPoint(Part):
    """One point of a shock response spectrum; log-log lines between points."""

    frequency: Frequency
    """Frequency of the point, e.g. ``100 Hz``."""
    acceleration: PeakAcceleration
    """Peak acceleration of an oscillator of that frequency, e.g. ``50 g``."""


class Shock(Part):
    """One shock, along one axis; Q of the response."""

    half_sine: HalfSine | None = Field(None, alias="half-sine")
    """A half-sine pulse of the base; or give velocity or srs,
    e.g. ``{acceleration: 30 g, duration: 11 ms}``.
    """
    velocity: Annotated[float, QuantityOf("velocity", above=0.0)] | None = None
    """A sudden change of the base's velocity, e.g. ``velocity: 1 m/s``."""
    srs: Annotated[tuple[SpectrumPoint, ...], OrTable()] = ()
    """A shock response spectrum, two points or more, or a table of them, ``srs.csv``,
    e.g. ``srs: [{frequency: 10 Hz, acceleration: 5 g}, {frequency: 2 kHz, acceleration: 900 g}]``.
    """
    record: Annotated[Record, BeforeValidator(_recorded), OfTable()] | None = None
    """Measured acceleration of the base at equal steps of time, a table of time and acceleration,
    straight lines between its samples, e.g. ``record: base.csv``.
    """
    q: Annotated[float, QuantityOf("ratio", at_least=0.5)] = 10.0
    """Quality factor Q of the response; left out, the case's (the largest of its modes), else the
    mechanism's, else 10,
    e.g. ``q: 10, half-sine: {acceleration: 30 g, duration: 11 ms}``.
    """
    axis: Literal["x", "y", "z"] = "x"
    """Axis along which the base is shocked,
    e.g. ``axis: y, half-sine: {acceleration: 30 g, duration: 11 ms}``.
    """

    @model_validator(mode="after")
    def _one_description(self) -> "Shock":
        given = (self.half_sine, self.velocity, self.srs or None, self.record)
        if sum(each is not None for each in given) != 1:
            text = "a shock is a half-sine, a velocity, an srs or a record"
            raise spec_error(text, "give one of the four")
        if len(self.srs) == 1:
            raise spec_error("a spectrum needs two points or more", "add a point", at=("srs",))
        for index, (first, second) in enumerate(pairwise(self.srs)):
            if second.frequency <= first.frequency:
                raise spec_error(
                    "frequencies must rise", "put them in order", at=("srs", index + 1, "frequency")
                )
        return self

    def worst_acceleration(self) -> float | None:
        """Return the largest acceleration of any oscillator [m/s²], where it is known at once."""
        if self.half_sine is not None:
            return LARGEST_HALF_SINE * self.half_sine.acceleration
        return max(p.acceleration for p in self.srs) if self.srs else None

    def peaks(self, coefficients: Sequence[Floats], fn: Floats) -> list[float]:
        """Return the greatest sums of ω_n² z of oscillators, times coefficients.

        Within a half-sine pulse they are added at each moment. Of other shocks nobody knows when
        each has its peak, or whether they meet: the peaks are added, which none exceeds.

        Parameters
        ----------
        coefficients : sequence of array, each of shape (places, components, n)
            Share of each oscillator; the components at a place are those of a vector.
        fn : array, shape (n,)
            Natural frequencies, rising [Hz].

        Returns
        -------
        list of float
            The greatest at any place, [m/s²] times the coefficients' unit.

        """
        if self.half_sine is not None:
            pulse = self.half_sine
            return half_sine_sums(coefficients, fn, self.q, pulse.acceleration, pulse.duration)
        # oscillators of one frequency move as one
        first = np.flatnonzero(np.diff(fn, prepend=-1.0) > SAME * fn)
        each = self._pseudo_acceleration(fn[first])
        found = (np.abs(np.add.reduceat(c, first, axis=-1)) @ each for c in coefficients)
        return [float(np.linalg.norm(peaks, axis=-1).max()) for peaks in found]

    def unstated(self, fn: Floats) -> NDArray[np.bool_]:
        """Return of which natural frequencies [Hz], above its end, a spectrum states nothing.

        Raises ValueError where it starts above one: slow oscillators may swing by anything.
        """
        if not self.srs:
            return np.zeros(fn.shape, dtype=bool)
        low, high = self.srs[0].frequency, self.srs[-1].frequency
        if fn.size and fn.min() < low:
            raise ValueError(f"the spectrum starts at {low:g} Hz, above a mode at {fn.min():g} Hz")
        return np.asarray(fn > high)

    def _pseudo_acceleration(self, fn: Floats) -> Floats:
        """Return the peak of ω_n² z of oscillators of natural frequencies fn [Hz], [m/s²]."""
        if self.velocity is not None:
            return velocity_shock_acceleration(self.velocity, fn)
        if self.record is not None:
            _, _, pseudo = shock_response_spectrum(
                self.record.acceleration, self.record.step, fn, self.q
            )
            return pseudo
        frequencies = np.array([p.frequency for p in self.srs])
        levels = np.array([p.acceleration for p in self.srs])
        # beyond its end a spectrum is taken to rise as before it, or to stay
        slope = np.log(levels[-1] / levels[-2]) / np.log(frequencies[-1] / frequencies[-2])
        beyond = np.maximum(fn / frequencies[-1], 1.0) ** max(slope, 0.0)
        return np.asarray(beyond * srs_level(np.minimum(fn, frequencies[-1]), frequencies, levels))
