"""Many exact responses of one linear system, evaluated at once."""

from collections.abc import Callable, Sequence
from copy import copy

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.linear_response import LinearResponse

__all__ = ["ResponseBatch", "greatest_values"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Ragged = Sequence[Sequence[complex]]

_ZOOMS = 4
"""Parabolas through ever closer points: a smooth maximum is found to rounding."""
_CLOSER = 0.1


class ResponseBatch:
    """Responses (S of them) of one system as arrays; times have the shape (S, N)."""

    def __init__(self, responses: Sequence[LinearResponse]) -> None:
        """Gather the coefficients, padded with zeros to a common number of terms and degree."""
        self.roots = responses[0].system.roots
        terms = [r.piece.terms for r in responses]
        most = max(map(len, terms))
        self._rates = np.zeros((len(responses), most), dtype=np.complex128)
        for row, those in zip(self._rates, terms, strict=True):
            row[: len(those)] = [rate for rate, _ in those]
        self._signal = _padded([[p for _, p in those] for those in terms], most)
        self._own = _padded([r.own for r in responses], self.roots.size)
        self._forced = [
            _padded([r.forced[j] for r in responses], most) for j in range(self.roots.size)
        ]

    def of(self, rows: NDArray[np.intp]) -> "ResponseBatch":
        """Return the responses of some rows, of some more than once if they are named so."""
        found = copy(self)
        found._rates, found._signal = self._rates[rows], self._signal[rows]
        found._own, found._forced = self._own[rows], [each[rows] for each in self._forced]
        return found

    def amplitudes(self, times: Floats) -> Complexes:
        """Return y at times, shape (S, m, N)."""
        t = times[:, None, :]
        y = _polynomials(self._own, t) * np.exp(self.roots[:, None] * t)
        turns = np.exp(self._rates[:, :, None] * t)
        for j, forced in enumerate(self._forced):
            y[:, j] += (_polynomials(forced, t) * turns).sum(axis=1)
        return y

    def signal(self, times: Floats) -> Floats:
        """Return the signal f at times, shape (S, N)."""
        t = times[:, None, :]
        turns = np.exp(self._rates[:, :, None] * t)
        total: Floats = (_polynomials(self._signal, t) * turns).sum(axis=1).real
        return total


def _padded(rows: Sequence[Ragged], most: int) -> Complexes:
    """Return coefficients as (S, most, degrees), zero where there is nothing."""
    degrees = max((len(p) for row in rows for p in row), default=0)
    array = np.zeros((len(rows), most, max(degrees, 1)), dtype=np.complex128)
    for s, row in enumerate(rows):
        for k, p in enumerate(row):
            array[s, k, : len(p)] = p
    return array


def _polynomials(coefficients: Complexes, t: Floats) -> Complexes:
    """Return the polynomials (S, k, degree) at times (S, 1, N), shape (S, k, N)."""
    value = np.zeros(1, dtype=np.complex128)
    for degree in range(coefficients.shape[2] - 1, -1, -1):
        value = value * t + coefficients[:, :, degree, None]
    return np.broadcast_to(value, (*coefficients.shape[:2], t.shape[2]))


def greatest_values(
    function: Callable[[Floats], Floats], times: Floats, values: Floats
) -> tuple[Floats, Floats]:
    """Return the greatest value of each row of a smooth function, and its time.

    ``values`` are those at ``times`` (S, N), rising, dense enough that the greatest sample is next
    to the greatest value; ``function`` takes times (S, n). Refined by parabolas.
    """
    rows = np.arange(times.shape[0])
    at = np.argmax(values, axis=1)
    best_time, best = times[rows, at], values[rows, at]
    last = times.shape[1] - 1
    reach = np.maximum(
        best_time - times[rows, np.maximum(at - 1, 0)],
        times[rows, np.minimum(at + 1, last)] - best_time,
    )
    first_time, last_time = times[:, 0], times[:, -1]
    for _ in range(_ZOOMS):
        middle = np.clip(best_time, first_time + reach, last_time - reach)
        middle = np.where(last_time - first_time > 2.0 * reach, middle, best_time)
        points = middle[:, None] + reach[:, None] * np.array([-1.0, 0.0, 1.0])
        points = np.clip(points, first_time[:, None], last_time[:, None])
        left, here, right = function(points).T
        bend = left - 2.0 * here + right
        shift = np.where(bend < 0.0, 0.5 * (left - right) / np.where(bend < 0.0, bend, 1.0), 0.0)
        vertex = np.clip(middle + reach * np.clip(shift, -1.0, 1.0), first_time, last_time)
        found = function(vertex[:, None])[:, 0]
        better = found > best
        best_time, best = np.where(better, vertex, best_time), np.where(better, found, best)
        reach = reach * _CLOSER
    return best, best_time
