"""A real function of time as the real part of a sum of polynomials times exponentials."""

from cmath import exp
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

__all__ = ["ExponentialSum", "Jet", "Term", "derivative_of_term", "polynomial_at"]

Term: TypeAlias = tuple[complex, Sequence[complex]]
"""Rate λ [1/s] and coefficients of p: the function p(t) exp(λt)."""

EPS = 2.0**-52


class Jet(NamedTuple):
    """Value, first and second derivative at a time, and a bound of the third from then on."""

    value: float
    first: float
    second: float
    third_bound: float


def polynomial_at(coefficients: Sequence[complex], t: float) -> complex:
    """Return the value of a polynomial, lowest power first."""
    value = 0j
    for c in reversed(coefficients):
        value = value * t + c
    return value


def derivative_of_term(rate: complex, coefficients: Sequence[complex]) -> list[complex]:
    """Return the coefficients of (p' + λp), the derivative of p(t) exp(λt) over exp(λt)."""
    last = len(coefficients) - 1
    return [
        rate * c + ((k + 1) * coefficients[k + 1] if k < last else 0.0)
        for k, c in enumerate(coefficients)
    ]


class ExponentialSum:
    """The real part of ``Σ p_j(t) exp(λ_j t)`` on 0 ≤ t ≤ horizon, no rate growing.

    Kept as Python numbers: a handful of terms is evaluated an order of magnitude faster than
    through arrays, and a search for a crossing asks one time after another.
    """

    def __init__(self, terms: Sequence[Term], horizon: float) -> None:
        """Prepare derivatives, the bound of the third one, and the size of rounding."""
        self.horizon = horizon
        self.terms = tuple(terms)
        self._pure: list[tuple[complex, complex, float]] = []
        self._mixed: list[tuple[complex, tuple[Sequence[complex], ...], float]] = []
        size = 0.0
        for rate, coefficients in terms:
            size += self._size(coefficients)
            if len(coefficients) == 1:
                self._pure.append((rate, coefficients[0], abs(rate) ** 3))
                continue
            first = derivative_of_term(rate, coefficients)
            second = derivative_of_term(rate, first)
            third = self._size(derivative_of_term(rate, second))
            self._mixed.append((rate, (coefficients, first, second), third))
        self.rounding = 4.0 * EPS * size
        """Rounding error of a value: closer to zero than this is zero."""

    def _size(self, coefficients: Sequence[complex]) -> float:
        size = 0.0
        for c in reversed(coefficients):
            size = size * self.horizon + abs(c)
        return size

    def plus(self, term: Term) -> "ExponentialSum":
        """Return the sum with one more term."""
        return ExponentialSum((*self.terms, term), self.horizon)

    def jet(self, t: float) -> Jet:
        """Return value and derivatives at a time; the bound holds from there to the horizon."""
        value = first = second = bound = 0.0
        for rate, coefficient, cube in self._pure:
            a = coefficient * exp(rate * t)
            value += a.real
            bound += abs(a) * cube
            a *= rate
            first += a.real
            second += (a * rate).real
        for rate, (p, p1, p2), third in self._mixed:
            turn = exp(rate * t)
            value += (polynomial_at(p, t) * turn).real
            first += (polynomial_at(p1, t) * turn).real
            second += (polynomial_at(p2, t) * turn).real
            bound += third * abs(turn)
        return Jet(value, first, second, bound)

    def __call__(self, t: float) -> float:
        """Return the value at a time."""
        return self.jet(t).value
