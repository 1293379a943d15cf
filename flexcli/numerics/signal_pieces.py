"""Signals of time as pieces in closed form: sines, sweeps, samples, polynomials, pulses."""

from cmath import exp
from collections.abc import Iterator, Sequence
from math import ceil, comb, log, pi, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.exponential_sum import Term, polynomial_at

__all__ = [
    "Piece",
    "Samples",
    "half_sine",
    "linear_sweep",
    "logarithmic_sweep",
    "sine",
]

_MOST_TURN = 0.25
"""Phase [rad] of a sweep against its carrier in one piece; some 8 terms represent it."""
_SMALLEST = 1e-18
"""Terms below that share of the whole are left out."""


class Piece(NamedTuple):
    """A real signal ``Σ p(t) exp(λt)``, conjugate terms included, for 0 ≤ t ≤ duration."""

    duration: float
    terms: tuple[Term, ...]

    def __call__(self, t: float) -> float:
        """Return the value at a time."""
        return sum((polynomial_at(p, t) * exp(rate * t)).real for rate, p in self.terms)

    def after(self, start: float) -> "Piece":
        """Return what is left of the piece from a time on, with its own time from zero."""
        terms = []
        for rate, p in self.terms:
            turn = exp(rate * start)
            terms.append((rate, [turn * c for c in _shifted(p, start)]))
        return Piece(self.duration - start, tuple(terms))


class Samples(NamedTuple):
    """Equidistant values joined by straight lines, and the step between them [s]."""

    values: NDArray[np.float64]
    step: float

    def line(self, index: int) -> Piece:
        """Return the straight line from a value to the next."""
        here, there = float(self.values[index]), float(self.values[index + 1])
        return Piece(self.step, ((0j, [complex(here), complex((there - here) / self.step)]),))

    def lines(self) -> Iterator[Piece]:
        """Yield all the lines."""
        return (self.line(index) for index in range(self.values.size - 1))


def _shifted(p: Sequence[complex], start: float) -> list[complex]:
    """Return the coefficients of p(start + t)."""
    return [
        sum(comb(j, k) * p[j] * start ** (j - k) for j in range(k, len(p))) for k in range(len(p))
    ]


def _conjugates(rate: complex, p: Sequence[complex]) -> tuple[Term, Term]:
    """Return the two terms whose sum is the real part of one."""
    half = [c / 2.0 for c in p]
    return (rate, half), (rate.conjugate(), [c.conjugate() for c in half])


def sine(
    *, amplitude: float, angular: float, duration: float, phase: float = 0.0
) -> Iterator[Piece]:
    """Yield ``A sin(ωt + φ)`` in pieces of one period."""
    terms = _conjugates(1j * angular, [-1j * amplitude * exp(1j * phase)])
    period = 2.0 * pi / angular
    whole = int(duration / period * (1.0 + 1e-12))
    for _ in range(whole):
        yield Piece(period, terms)
    rest = duration - whole * period
    if rest > 1e-9 * period:
        yield Piece(rest, terms)


def half_sine(*, amplitude: float, width: float, duration: float) -> Iterator[Piece]:
    """Yield a pulse ``A sin(πt/τ)`` and the silence after it, to the end of the duration."""
    yield Piece(width, _conjugates(1j * pi / width, [-1j * amplitude]))
    yield Piece(duration - width, ())


def linear_sweep(
    *,
    amplitude: float,
    start: float,
    end: float,
    duration: float,
    power: int = 0,
    phase: float = 0.0,
) -> Iterator[Piece]:
    """Yield a sine whose angular frequency ω goes from start to end at a steady rate.

    Its amplitude goes with ω to a power. Each piece is a carrier times the Taylor series of the
    slow turn against it, to rounding.
    """
    rate = (end - start) / duration
    t = 0.0
    while t < duration:
        omega = start + rate * t
        length = _piece_length(omega, rate, duration - t)
        at, turn = phase + t * (start + rate * t / 2.0), [0.0, 0.0, rate / 2.0]
        swell = [comb(power, j) * omega ** (power - j) * rate**j for j in range(power + 1)]
        yield _chirp([amplitude * c for c in swell], at, omega, turn, length)
        t += length


def logarithmic_sweep(
    *,
    amplitude: float,
    start: float,
    end: float,
    duration: float,
    power: int = 0,
    phase: float = 0.0,
) -> Iterator[Piece]:
    """Yield a sine whose angular frequency goes from start to end by equal ratios in equal times.

    Amplitude and pieces as in ``linear_sweep``.
    """
    k = log(end / start) / duration
    t = 0.0
    while t < duration:
        omega = start * exp(k * t).real
        length = _piece_length(omega, k * omega, duration - t)
        turn = [0.0, 0.0]
        coefficient = omega
        while abs(coefficient) * length ** (len(turn) - 1) > _SMALLEST:
            coefficient *= k / len(turn)
            turn.append(coefficient)
        swell = [amplitude * omega**power]
        while power and abs(swell[-1]) * length ** (len(swell) - 1) > _SMALLEST * abs(swell[0]):
            swell.append(swell[-1] * power * k / len(swell))
        yield _chirp(swell, phase + (omega - start) / k, omega, turn, length)
        t += length


def _piece_length(omega: float, rate: float, rest: float) -> float:
    """Return a period of the carrier, or less for a fast sweep; parts of the rest are equal."""
    longest = min(2.0 * pi / omega, sqrt(2.0 * _MOST_TURN / abs(rate)) if rate else 2.0 * pi)
    return rest if rest <= longest else rest / ceil(rest / longest)


def _chirp(
    swell: Sequence[float], phase: float, omega: float, turn: Sequence[float], length: float
) -> Piece:
    """Return ``A(t) sin(φ + ωt + ψ(t))`` for a small polynomial ψ, A exp(iψ) in powers of t."""
    # E = exp(iψ) obeys E' = iψ'E, which gives its coefficients one after another
    series = [1.0 + 0j]
    slope = [1j * k * c for k, c in enumerate(turn)][1:]
    quiet = 0
    while quiet < len(turn):
        k = len(series)
        total = sum(slope[j] * series[k - 1 - j] for j in range(min(k, len(slope))))
        series.append(total / k)
        quiet = quiet + 1 if abs(series[-1]) * length**k < _SMALLEST else 0
    found = np.convolve(series[: -quiet or None], swell) * (-1j * exp(1j * phase))
    return Piece(length, _conjugates(1j * omega, found.tolist()))
