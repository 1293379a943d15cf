"""The exact response of a linear system to straight lines between equidistant samples, at once."""

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.linear_system import LinearSystem

__all__ = ["SampledResponse"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]

_SMALL = 0.5
_TERMS = 18
"""Terms of the series below that argument: 0.5^18/18! is far below rounding."""
_FADED = 200.0
"""Exponent to which the free motion may decay in one block: its inverse is still finite."""


class SampledResponse:
    """A system driven by w times lines between samples, a step [s] apart.

    ``y' = μ y + w a(t)`` has ``y(ch) = exp(cz) y_0 + w h (A(c) a_0 + B(c) a_1)`` in a step of
    length h, z = μh and 0 ≤ c ≤ 1: exact, so that only rounding adds up over the steps.
    """

    def __init__(self, system: LinearSystem, drive: Complexes, step: float) -> None:
        """Prepare the coefficients of a whole step."""
        self.step = step
        self._roots, self._drive = system.roots, drive * step
        self._z = system.roots * step
        self._whole = self._shares(np.ones(1))
        fastest = float(np.abs(self._z.real).max(initial=0.0))
        self.most = int(_FADED / fastest) + 1 if fastest else 10**9
        """Steps that one call of ``at_samples`` can take."""

    def at_samples(self, y: Complexes, a: Floats) -> Complexes:
        """Return y at every sample from that at the first, shape (m, samples)."""
        before, after = self._whole
        forced = self._drive[:, None] * (before * a[:-1] + after * a[1:])
        count = np.arange(a.size)
        # y_n = E^n (y_0 + Σ E^-k u_k): rounding in the sum is relative to its latest, largest term
        grown = np.exp(-self._z[:, None] * count)
        kicks = np.concatenate([y[:, None], forced * grown[:, 1:]], axis=1)
        found: Complexes = np.cumsum(kicks, axis=1, dtype=np.complex128) / grown
        return found

    def within(self, y: Complexes, before: Floats, after: Floats, shares: Floats) -> Complexes:
        """Return y at shares of steps, shape (steps, m, shares).

        ``y`` (m, steps) is that at the start of each, before and after are the signal's ends.
        """
        first, second = self._shares(shares)
        found: Complexes = y.T[:, :, None] * np.exp(self._z[:, None] * shares)
        found += (self._drive[:, None] * first) * before[:, None, None]
        found += (self._drive[:, None] * second) * after[:, None, None]
        return found

    def stray(
        self, row: Complexes, y: Complexes, before: Floats, after: Floats, spacing: float
    ) -> Floats:
        """Return a bound of the distance of ``Re(row · y)``, in each step, from its chords.

        The points are at most ``spacing`` [s] apart, the rest is as in ``within``. A function
        differs from its chord by at most an eighth of its second derivative times the square of
        that, or twice its size: the free part of each root by the lesser of both, and so the forced
        part, which starts from zero.
        """
        eighth = spacing**2 / 8.0
        pushed = row * self._drive
        free = np.abs(row) * np.minimum(eighth * np.abs(self._roots) ** 2, 2.0)
        bent = np.abs(pushed * self._roots**2) + np.abs((pushed * self._roots).real) / self.step
        forced = np.minimum(eighth * bent, 2.0 * np.abs(pushed)).sum()
        # a velocity is not pushed at once: zero but for two real roots taken one by one
        turned = eighth * np.abs(pushed.real).sum() / self.step**2
        found: Floats = free @ np.abs(y)
        found += forced * np.maximum(np.abs(before), np.abs(after))
        found += turned * np.abs(after - before)
        return found

    def _shares(self, c: Floats) -> tuple[Complexes, Complexes]:
        """Return A and B at shares of a step, shape (m, shares)."""
        x = self._z[:, None] * c
        first, second = _phi(x)
        rising: Complexes = c**2 * second
        return c * first - rising, rising


def _phi(x: Complexes) -> tuple[Complexes, Complexes]:
    """Return ``(exp(x) − 1)/x`` and ``(exp(x) − 1 − x)/x²``, from their series near zero."""
    small = np.abs(x) < _SMALL
    near = np.where(small, x, 0.0)
    series = np.zeros_like(x)
    for k in range(_TERMS, 0, -1):
        series = (1.0 + near * series) / (k + 1)  # 1/2! + x/3! + …, by Horner's rule
    far = np.where(small, 1.0, x)
    second = np.where(small, series, (np.expm1(far) - far) / far**2)
    return 1.0 + x * second, second
