"""The excitation of a case as pieces of time: legs of the same length, peaks taken of each."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from math import ceil, log, pi, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.random_base import random_samples, with_sine
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
from flexcli.parts.excitation import Sine, Sweep, Tone
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


PER_TONE = 8.0
"""Samples per period of a sine on it."""

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
    sine = case.sine if case.sine is not None and case.sine.axis == "x" else None
    vibration = case.vibration
    is_random = vibration is not None and "x" in vibration.axes
    if vibration is not None and is_random and sign > 0:
        on_it: list[Sine | Tone] = [each for each in case.sines if each.axis == "x"]
        on_it += [sine] if sine is not None else []
        yield _random(name, vibration.alone("x"), on_it, blade, options)
    if case.sines and not is_random:
        raise SolveError(
            "no-time", f"case '{name}': sines are simulated on a random vibration along x",
            "give one as sine: or sweep:, or add an asd",
        )  # fmt: skip
    if sine is not None and not is_random:
        yield _sine(sine, quality, sign)
    if case.sweep is not None and case.sweep.axis == "x":
        kind = f"sweep from {case.sweep.start:g} to {case.sweep.end:g} Hz{_sign_words(sign)}"
        pieces = sweep_pieces(case.sweep, sign=sign)
        yield Excitation(kind, case.sweep.duration, iter([pieces]))
    if case.shock is not None and case.shock.axis == "x":
        yield _shock(name, case.shock, blade, sign)


def sweep_pieces(sweep: Sweep, *, sign: int = 1, backwards: bool = False) -> Iterator[Piece]:
    """Yield a sweep from its start to its end, or back."""
    is_linear, phase = sweep.rate.is_linear, 0.0
    edges = sorted((*sweep.band, *sweep.crossovers), reverse=(sweep.end < sweep.start) != backwards)
    for first, last in pairwise(edges):
        power, level = sweep.governing(sqrt(first * last))
        start, end, ratio = 2.0 * pi * first, 2.0 * pi * last, log(last / first)
        octaves = ratio / log(2.0)
        duration = abs(last - first if is_linear else octaves) / sweep.rate.speed
        by_rate = linear_sweep if is_linear else logarithmic_sweep
        yield from by_rate(
            amplitude=sign * level, start=start, end=end, duration=duration,
            power=power, phase=phase,
        )  # fmt: skip
        phase += duration * ((start + end) / 2.0 if is_linear else (end - start) / ratio)


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
    kind = f"sine at {given.frequency:g} Hz{_sign_words(sign)}"
    planned = (transient + STEADY_PERIODS) / given.frequency
    return Excitation(kind, planned, legs, settles=True)


def _sign_words(sign: int) -> str:
    """Return what is said of an excitation that is turned round."""
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
        return Excitation(f"half-sine shock{_sign_words(sign)}", planned, iter([[pulse, *silence]]))
    if shock.velocity is not None:
        rate = -sign * blade.base * shock.velocity
        kind = f"velocity shock{_sign_words(sign)}"
        return Excitation(kind, periods * period, iter([silence]), rate=rate)
    if shock.record is not None:
        record, period = shock.record, 2.0 * pi / float(blade.angular[0])
        samples = Samples(sign * record.acceleration, record.step)
        kind = (
            f"record {record.name}, {record.acceleration.size} samples, straight lines between, "
            f"{period / record.step:.3g} a period of the blade{_sign_words(sign)}"
        )
        planned = record.duration + periods * period
        return Excitation(kind, planned, iter([[samples, *silence]]))
    raise SolveError(
        "no-time", f"case '{name}': a response spectrum is no motion in time",
        "give the shock as half-sine, velocity or record",
    )  # fmt: skip


def _random(
    name: str,
    vibration: RandomVibration,
    tones: Sequence[Sine | Tone],
    blade: ModalBlade,
    options: Simulation,
) -> Excitation:
    """Return exposures one after another, each made of stretches that memory holds.

    Sines stand on it with any phase, each at that frequency of its band next to the blade's.
    """
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
    standing = [(tone, min(max(f_0, tone.band[0]), tone.band[1])) for tone in tones]
    highest = max((f for _, f in standing), default=0.0)
    rate = max(PER_BAND_END * f_end, PER_PERIOD * f_0, PER_TONE * highest)
    longest = max(MOST_SAMPLES / rate, MEMORIES * 0.5 / float(blade.damping[0]) / f_0)
    parts = ceil(length / longest)

    def exposure() -> Iterator[Samples]:
        for _ in range(parts):
            samples = random_samples(
                applied.frequency,
                applied.level,
                duration=length / parts,
                generator=generator,
                oversampling=rate / f_end,
            )
            phases = generator.uniform(0.0, 2.0 * pi, len(standing))
            for (tone, f), phase in zip(standing, phases, strict=True):
                samples = with_sine(samples, float(tone.level(np.array(f))), f, phase)
            yield samples

    on_it = "".join(f" with a {tone.told}, here {f:.4g} Hz," for tone, f in standing)
    text = f"random{on_it}, {count} exposures of {length:g} s".replace(",,", ",")
    legs = (exposure() for _ in range(count))
    return Excitation(text, count * length, legs, exposure=length, seed=options.seed)
