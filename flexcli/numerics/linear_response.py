"""The exact response of a linear system to a piece of a signal, from a given state."""

from collections.abc import Sequence
from itertools import zip_longest
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.exponential_sum import ExponentialSum, Term, polynomial_at
from flexcli.numerics.linear_system import LinearSystem
from flexcli.numerics.signal_pieces import Piece

__all__ = ["LinearResponse", "respond"]

Complexes = NDArray[np.complex128]

_MOST_CANCELLATION = 100.0
"""Largest forced part, over the response, that the free motion may cancel."""
_SMALLEST = 1e-18


class LinearResponse(NamedTuple):
    """Amplitudes ``y_j = own_j(t) exp(μ_j t) + Σ_k forced_jk(t) exp(λ_k t)`` over a piece."""

    system: LinearSystem
    piece: Piece
    own: tuple[Sequence[complex], ...]
    forced: tuple[tuple[Sequence[complex], ...], ...]

    def amplitudes(self, t: float) -> Complexes:
        """Return y at a time."""
        turns = [np.exp(rate * t) for rate, _ in self.piece.terms]
        y = np.empty(len(self.own), dtype=np.complex128)
        for j, own in enumerate(self.own):
            y[j] = polynomial_at(own, t) * np.exp(self.system.roots[j] * t)
            for turn, p in zip(turns, self.forced[j], strict=True):
                y[j] += polynomial_at(p, t) * turn
        return y

    def span(self, row: Sequence[complex]) -> tuple[float, float]:
        """Return ``Re(row · y)`` at the start, and a bound of its change, no root growing."""
        start = reach = 0.0
        T = self.piece.duration
        for r, root, own, forced in zip(row, self.system.roots, self.own, self.forced, strict=True):
            found, size = _start_and_change(own, root, T)
            for (rate, _), p in zip(self.piece.terms, forced, strict=True):
                value, more = _start_and_change(p, rate, T)
                found, size = found + value, size + more
            start += (r * found).real
            reach += abs(r) * size
        return start, reach

    def output(
        self, row: Sequence[complex], constant: float = 0.0, direct: float = 0.0
    ) -> ExponentialSum:
        """Return ``constant + Re(row · y) + direct f`` as a function of time."""
        terms: list[Term] = [(0j, (complex(constant),))] if constant else []
        for j, (r, own) in enumerate(zip(row, self.own, strict=True)):
            terms.append((complex(self.system.roots[j]), [r * c for c in own]))
        for k, (rate, f) in enumerate(self.piece.terms):
            total = [direct * c for c in f]
            for j, r in enumerate(row):
                p = self.forced[j][k]
                for i, c in enumerate(p):
                    total[i] += r * c
            terms.append((rate, total))
        return ExponentialSum(terms, self.piece.duration)


def respond(system: LinearSystem, w: Complexes, y: Complexes, piece: Piece) -> LinearResponse:
    """Return the response from amplitudes y to a force f(t) that drives them by w.

    For ``y' = μ y + w p(t) exp(λt)`` the forced part is P(t) exp(λt) with ``P' + (λ − μ) P = w p``,
    solved from the highest power down. Where λ lies so close to μ that P and the free motion
    would cancel, ``∫ p(t) exp((λ − μ)t) dt`` joins the free motion as a Taylor series instead:
    resonance without damping is no special case.
    """
    own, forced = [], []
    drive, begin = w.tolist(), y.tolist()
    for j, root in enumerate(system.roots.tolist()):
        start = begin[j]
        secular: list[complex] = []
        parts: list[Sequence[complex]] = []
        for rate, p in piece.terms:
            gap = rate - root
            P = _forced_part(p, gap, piece.duration)
            if P:
                start -= drive[j] * P[0]
            else:
                more = _integral(p, gap, piece.duration)
                secular = [a + b for a, b in zip_longest(secular, more, fillvalue=0j)]
            parts.append([drive[j] * c for c in P])
        own.append([start, *(drive[j] * c for c in secular[1:])])
        forced.append(tuple(parts))
    return LinearResponse(system, piece, tuple(own), tuple(forced))


def _start_and_change(p: Sequence[complex], rate: complex, T: float) -> tuple[complex, float]:
    """Return p(t) exp(λt) at zero, and a bound of its change until T, Re λ ≤ 0."""
    if not p:
        return 0j, 0.0
    size, power = abs(p[0]) * min(2.0, abs(rate) * T), 1.0
    for c in p[1:]:
        power *= T
        size += abs(c) * power
    return p[0], size


def _forced_part(p: Sequence[complex], gap: complex, T: float) -> list[complex]:
    """Return P of ``P' + gap P = p``, or nothing when P is much larger than the integral of p."""
    natural = size = 0.0
    P = [0j] * len(p)
    above = 0j
    if gap == 0.0:
        return []
    for k in range(len(p) - 1, -1, -1):
        P[k] = above = (p[k] - (k + 1) * above) / gap
        size = size * T + abs(P[k])
        natural = natural * T + abs(p[k])
    return P if size <= _MOST_CANCELLATION * T * natural else []


def _integral(p: Sequence[complex], gap: complex, T: float) -> list[complex]:
    """Return the coefficients of ``∫₀ᵗ p(s) exp(gap s) ds``, good to rounding for t up to T."""
    series = [1.0 + 0j]
    while abs(series[-1]) * T ** (len(series) - 1) > _SMALLEST:
        series.append(series[-1] * gap / len(series))
    product = [0j] * (len(p) + len(series) - 1)
    for i, a in enumerate(p):
        for k, b in enumerate(series):
            product[i + k] += a * b
    return [0j, *(c / (k + 1) for k, c in enumerate(product))]
