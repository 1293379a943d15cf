"""The excitation of a case as pieces of time: legs of the same length, peaks taken of each."""

from collections.abc import Iterable, Iterator
from math import ceil, log, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.random_base import random_samples
from flexcli.numerics.signal_pieces import (
    Piece,
    Samples,
    half_sine,
    linear_sweep,
    logarithmic_sweep,
    sine,
)
from flexcli.parts.asd import RandomVibration
from flexcli.parts.case import Case
from flexcli.parts.excitation import Sine, Sweep
from flexcli.parts.shock import Shock
from flexcli.parts.stops.stops import Simulation

__all__ = ["Excitation", "excitation", "sweep_pieces"]

STEADY_PERIODS = 20
DIED = 1e-3
"""Share of the first transient that is left when a sine counts as steady."""
RUNG_DOWN = 1e-2
"""Share of the first swing that is left when a shock counts as over."""
PER_PERIOD = 16.0
"""Samples per period of the blade: the images of lines between samples lie far above it."""
PER_BAND_END = 4.0
"""Samples per period of the profile's last frequency."""


MOST_SAMPLES = 100_000
"""Samples of one stretch of a random signal; stretches are independent of each other."""
MEMORIES = 50.0
"""Least length of a stretch in times Q/f_0, in which the blade forgets where it came from."""


class Excitation(NamedTuple):
    """What shakes the base: legs of pieces [s, m/s²], all of them ``planned`` long.

    ``exposure`` is the length of a leg that stands for one exposure; ``settles`` says that the
    last leg is a steady motion; ``rate`` are the modal rates at the start.
    """

    kind: str
    planned: float
    legs: Iterator[Iterable[Piece | Samples]]
    exposure: float | None = None
    seed: int | None = None
    settles: bool = False
    rate: NDArray[np.float64] | None = None


def excitation(
    name: str, case: Case, blade: ModalBlade, options: Simulation, sign: int
) -> Iterator[Excitation]:
    """Yield each excitation of a case; a sign of −1 turns it round.

    Raises
    ------
    SolveError
        ``no-time`` for a description that is no motion in time, or has no duration.
    """
    quality = 0.5 / float(blade.damping[0])
    # a random one has either sign itself; along the blade (y) nothing bends it
    if case.asd is not None and "x" in case.asd.axes and sign > 0:
        yield _random(name, case.asd, blade, options)
    if case.sine is not None:
        yield _sine(case.sine, quality, sign)
    if case.sweep is not None:
        kind = f"sweep from {case.sweep.start:g} to {case.sweep.end:g} Hz{_turned(sign)}"
        pieces = sweep_pieces(case.sweep, sign=sign)
        yield Excitation(kind, case.sweep.duration, iter([pieces]))
    if case.shock is not None and case.shock.axis == "x":
        yield _shock(name, case.shock, blade, sign)


def sweep_pieces(sweep: Sweep, *, sign: int = 1, backwards: bool = False) -> Iterator[Piece]:
    """Yield a sweep from its start to its end, or back."""
    start, end = (2.0 * pi * f for f in (sweep.start, sweep.end))
    if backwards:
        start, end = end, start
    by_rate = linear_sweep if sweep.rate.is_linear else logarithmic_sweep
    return by_rate(
        amplitude=sign * sweep.acceleration, start=start, end=end, duration=sweep.duration
    )


def exposures(confidence: float) -> int:
    """Return how many exposures have a higher peak than one more with that confidence.

    Of N + 1 alike exposures each is as likely to have the highest peak: the chance that the next
    one exceeds the N simulated is 1/(N + 1), whatever the distribution.
    """
    return ceil(confidence / (1.0 - confidence) * (1.0 - 1e-12))


def _sine(given: Sine, quality: float, sign: int) -> Excitation:
    """Return the way from rest to the steady motion, and some periods of that."""
    transient = ceil(log(1.0 / DIED) * quality / pi)
    legs = (
        sine(
            amplitude=sign * given.acceleration,
            angular=2.0 * pi * given.frequency,
            duration=periods / given.frequency,
        )
        for periods in (transient, STEADY_PERIODS)
    )
    kind = f"sine at {given.frequency:g} Hz{_turned(sign)}"
    planned = (transient + STEADY_PERIODS) / given.frequency
    return Excitation(kind, planned, legs, settles=True)


def _turned(sign: int) -> str:
    return "" if sign > 0 else ", turned round"


def _shock(name: str, shock: Shock, blade: ModalBlade, sign: int) -> Excitation:
    """Return a pulse, or a jump of the base's speed, and the silence in which the blade rings."""
    period = 2.0 * pi / float(blade.angular[0])
    periods = ceil(log(1.0 / RUNG_DOWN) * 0.5 / float(blade.damping[0]) / pi)
    silence = [Piece(period, ())] * periods
    if shock.half_sine is not None:
        width = shock.half_sine.duration
        amplitude = sign * shock.half_sine.acceleration
        pulse = next(half_sine(amplitude=amplitude, width=width, duration=width))
        planned = width + periods * period
        return Excitation(f"half-sine shock{_turned(sign)}", planned, iter([[pulse, *silence]]))
    if shock.velocity is not None:
        rate = -sign * blade.base * shock.velocity
        kind = f"velocity shock{_turned(sign)}"
        return Excitation(kind, periods * period, iter([silence]), rate=rate)
    raise SolveError(
        "no-time", f"case '{name}': a response spectrum is no motion in time",
        "give the shock as half-sine or velocity",
    )  # fmt: skip


def _random(
    name: str, vibration: RandomVibration, blade: ModalBlade, options: Simulation
) -> Excitation:
    """Return exposures one after another, each made of stretches that memory holds."""
    applied = vibration.applied()
    if applied.duration is None:
        raise SolveError(
            "no-time", f"case '{name}': nothing says how long the vibration lasts",
            "give asd.duration, the time of one exposure",
        )  # fmt: skip
    if applied.scale != "log":
        raise SolveError(
            "no-time", f"case '{name}': a profile on linear axes cannot be simulated",
            "give it by points on log-log axes",
        )  # fmt: skip
    length, count = applied.duration, exposures(options.confidence)
    generator = np.random.default_rng(options.seed)
    f_0, f_end = float(blade.angular[0]) / (2.0 * pi), float(applied.frequency[-1])
    rate = max(PER_BAND_END, PER_PERIOD * f_0 / f_end) * f_end
    longest = max(MOST_SAMPLES / rate, MEMORIES * 0.5 / float(blade.damping[0]) / f_0)
    parts = ceil(length / longest)

    def exposure() -> Iterator[Samples]:
        for _ in range(parts):
            yield random_samples(
                applied.frequency,
                applied.level,
                duration=length / parts,
                generator=generator,
                oversampling=rate / f_end,
            )

    text = f"random, {count} exposures of {length:g} s"
    legs = (exposure() for _ in range(count))
    return Excitation(text, count * length, legs, exposure=length, seed=options.seed)
