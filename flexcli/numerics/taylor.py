"""Truncated Taylor series in one variable: every derivative of a formula, exact to rounding."""

from collections.abc import Iterable
from math import cos as _cos
from math import sin as _sin
from typing import TypeAlias

__all__ = ["Scalar", "Taylor", "cos", "lifted", "sin"]


class Taylor:
    """Coefficients c_k of Σ c_k t^k, t the distance from the point of expansion.

    Sums, products and quotients keep as many orders as both operands know; a coefficient is the
    derivative over k!, without the subtraction of nearly equal numbers of a finite difference.
    """

    def __init__(self, coefficients: Iterable[float]) -> None:
        self.coefficients = tuple(coefficients)

    @classmethod
    def variable(cls, at: float, order: int) -> "Taylor":
        """Return the variable itself, expanded about a point up to an order of 1 or more."""
        return cls((at, 1.0, *(0.0,) * (order - 1)))

    @property
    def order(self) -> int:
        """Return the highest power kept."""
        return len(self.coefficients) - 1

    @property
    def value(self) -> float:
        """Return the value at the point of expansion."""
        return self.coefficients[0]

    def derivative(self) -> "Taylor":
        """Return the series of the derivative, one order shorter."""
        return Taylor(k * c for k, c in enumerate(self.coefficients[1:], start=1))

    def __neg__(self) -> "Taylor":
        return Taylor(-c for c in self.coefficients)

    def __add__(self, other: "Scalar") -> "Taylor":
        second = lifted(other, self.order)
        return Taylor(a + b for a, b in zip(self.coefficients, second.coefficients, strict=False))

    def __sub__(self, other: "Scalar") -> "Taylor":
        return self + -other

    def __rsub__(self, other: float) -> "Taylor":
        return -self + other

    def __mul__(self, other: "Scalar") -> "Taylor":
        if not isinstance(other, Taylor):
            return Taylor(c * other for c in self.coefficients)
        a, b = self.coefficients, other.coefficients
        return Taylor(
            sum(a[i] * b[k - i] for i in range(k + 1)) for k in range(min(len(a), len(b)))
        )

    def __truediv__(self, other: "Scalar") -> "Taylor":
        if not isinstance(other, Taylor):
            return Taylor(c / other for c in self.coefficients)
        a, b = self.coefficients, other.coefficients
        quotient: list[float] = []
        for k in range(min(len(a), len(b))):
            known = sum(quotient[i] * b[k - i] for i in range(k))
            quotient.append((a[k] - known) / b[0])
        return Taylor(quotient)

    __radd__ = __add__
    __rmul__ = __mul__


Scalar: TypeAlias = Taylor | float


def lifted(value: Scalar, order: int) -> Taylor:
    """Return a number as the series of a constant; a series as it is."""
    return value if isinstance(value, Taylor) else Taylor((value, *(0.0,) * order))


def _sin_cos(angle: Taylor) -> tuple[Taylor, Taylor]:
    """Return sine and cosine together, from s' = c a' and c' = −s a'."""
    rate = angle.derivative().coefficients
    s, c = [_sin(angle.value)], [_cos(angle.value)]
    for k in range(1, angle.order + 1):
        s.append(sum(c[k - 1 - j] * rate[j] for j in range(k)) / k)
        c.append(-sum(s[k - 1 - j] * rate[j] for j in range(k)) / k)
    return Taylor(s), Taylor(c)


def sin(angle: Taylor) -> Taylor:
    """Return the sine of a series."""
    return _sin_cos(angle)[0]


def cos(angle: Taylor) -> Taylor:
    """Return the cosine of a series."""
    return _sin_cos(angle)[1]
