"""Signomials: sums of c·Π xᵢ^aᵢ over named positive variables, that pass through formulas."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

CANCELS = 4.0 * float(np.finfo(np.float64).eps)
"""A merged term below this share of what was added is rounding, not a term."""

SAME_EXPONENT = 12
"""Decimals to which exponents are compared: 1/3 + 2/3 is 1, whatever the rounding."""

CHEAP_POWER = 4
"""Up to this integer power, multiplying beats the general power (measured, NumPy 2)."""


@dataclass(frozen=True, eq=False, repr=False)
class Signomial:
    r"""A sum of power products of named positive variables.

    .. math:: s(x) = \sum_k c_k \prod_i x_i^{a_{ki}}

    A pure formula written for floats or arrays runs unchanged on signomials, which turns the
    formula into the data of a geometric program.

    Parameters
    ----------
    names
        The variables, one for each column of `exponents`.
    coefficients
        c, shape (K,). No two terms share their exponents and none is zero.
    exponents
        a, shape (K, n).

    Examples
    --------
    >>> h, l, b = variables("h", "l", "b")
    >>> 8 * b * h**3 / 12 / l * (1 + 3 * (2 / l))
    4*b*h^3/l^2 + 0.666667*b*h^3/l
    """

    names: tuple[str, ...]
    coefficients: Floats
    exponents: Floats

    # NumPy arrays and scalars on the left hand over to the reflected operators below.
    __array_ufunc__ = None

    def __post_init__(self) -> None:
        if self.exponents.shape != (self.coefficients.size, len(self.names)):
            raise ValueError(
                f"exponents have shape {self.exponents.shape}, "
                f"expected {(self.coefficients.size, len(self.names))}"
            )
        self.coefficients.flags.writeable = False
        self.exponents.flags.writeable = False

    # -- questions ---------------------------------------------------------------------------

    @property
    def is_monomial(self) -> bool:
        """Whether it is one term with a positive coefficient."""
        return self.coefficients.size == 1 and bool(self.coefficients[0] > 0)

    @property
    def is_posynomial(self) -> bool:
        """Whether it has at least one term and all coefficients are positive."""
        return self.coefficients.size > 0 and bool((self.coefficients > 0).all())

    @property
    def is_zero(self) -> bool:
        """Whether no term is left."""
        return self.coefficients.size == 0

    def positive_part(self) -> Signomial:
        """Return the terms with positive coefficients."""
        return self._terms(self.coefficients > 0, 1.0)

    def negative_part(self) -> Signomial:
        """Return the terms with negative coefficients, negated: s = positive − negative."""
        return self._terms(self.coefficients < 0, -1.0)

    def terms(self) -> tuple[Signomial, ...]:
        """Return the terms one by one."""
        every = range(self.coefficients.size)
        return tuple(
            Signomial(self.names, self.coefficients[k : k + 1], self.exponents[k : k + 1])
            for k in every
        )

    def at(self, **values: Any) -> Any:
        """Return the value at the given variables, broadcasting over arrays.

        Values of other names are ignored, so one design evaluates every formula. The loop runs
        over terms, never over designs, and holds one array per distinct power.

        Raises
        ------
        KeyError
            When a variable that occurs has no value.
        """
        powers: dict[tuple[str, float], Any] = {}
        total: Any = 0.0
        for coefficient, row in zip(
            self.coefficients.tolist(), self.exponents.tolist(), strict=True
        ):
            term: Any = coefficient
            for name, exponent in zip(self.names, row, strict=True):
                if exponent == 0.0:
                    continue
                key = (name, exponent)
                if key not in powers:
                    if name not in values:
                        raise KeyError(f"no value for {name!r}; it occurs in {self!r}")
                    powers[key] = _power(values[name], exponent)
                term = term * powers[key]
            total = total + term
        return total

    def aligned(self, names: tuple[str, ...]) -> Floats:
        """Return the exponents in columns for `names`, shape (K, len(names)).

        Raises
        ------
        ValueError
            When a variable that occurs is not among them.
        """
        if names == self.names:
            return self.exponents
        columns = np.zeros((self.coefficients.size, len(names)))
        for i, name in enumerate(self.names):
            if name in names:
                columns[:, names.index(name)] = self.exponents[:, i]
            elif self.exponents[:, i].any():
                raise ValueError(f"{name!r} occurs in {self!r} but is not among {names}")
        return columns

    # -- arithmetic --------------------------------------------------------------------------

    def __add__(self, other: object) -> Signomial:
        right = _lift(other)
        if right is None:
            return NotImplemented
        names = _union(self.names, right.names)
        return _collect(names, (*self._items(names), *right._items(names)))

    def __mul__(self, other: object) -> Signomial:
        right = _lift(other)
        if right is None:
            return NotImplemented
        names = _union(self.names, right.names)
        factors = list(right._items(names))
        return _collect(
            names,
            (
                (tuple(p + q for p, q in zip(a, b, strict=True)), c * d)
                for a, c in self._items(names)
                for b, d in factors
            ),
        )

    def __neg__(self) -> Signomial:
        return Signomial(self.names, -self.coefficients, self.exponents)

    def __pos__(self) -> Signomial:
        return self

    def __sub__(self, other: object) -> Signomial:
        right = _lift(other)
        return NotImplemented if right is None else self + (-right)

    def __rsub__(self, other: object) -> Signomial:
        return (-self) + other

    def __truediv__(self, other: object) -> Signomial:
        right = _lift(other)
        return NotImplemented if right is None else self * right._inverse()

    def __rtruediv__(self, other: object) -> Signomial:
        left = _lift(other)
        return NotImplemented if left is None else left * self._inverse()

    def __pow__(self, power: object) -> Signomial:
        if not isinstance(power, Real):
            return NotImplemented
        exponent = float(power)
        whole = exponent.is_integer()
        if self.coefficients.size == 1 and (whole or self.coefficients[0] > 0):
            (row,), (c,) = self.exponents.tolist(), self.coefficients.tolist()
            return _collect(self.names, [(tuple(a * exponent for a in row), c**exponent)])
        if not (whole and exponent >= 0):
            raise ArithmeticError(
                f"({self!r})**{exponent:g}: only a monomial with positive coefficient takes a "
                "negative or broken power; a sum takes whole powers from 0 on"
            )
        result = _constant(1.0)
        for _ in range(int(exponent)):
            result = result * self
        return result

    __radd__ = __add__
    __rmul__ = __mul__

    def __repr__(self) -> str:
        if self.is_zero:
            return "0"
        parts = [
            _term_text(c, dict(zip(self.names, row, strict=True)))
            for c, row in zip(self.coefficients.tolist(), self.exponents.tolist(), strict=True)
        ]
        return " + ".join(parts).replace("+ -", "- ")

    # -- inside ------------------------------------------------------------------------------

    def _items(self, names: tuple[str, ...]) -> Iterable[tuple[tuple[float, ...], float]]:
        rows = self.aligned(names).tolist()
        return zip(map(tuple, rows), self.coefficients.tolist(), strict=True)

    def _terms(self, mask: NDArray[np.bool_], sign: float) -> Signomial:
        return Signomial(self.names, sign * self.coefficients[mask], self.exponents[mask])

    def _inverse(self) -> Signomial:
        if self.is_zero:
            raise ZeroDivisionError("division by a signomial without terms")
        if self.coefficients.size > 1:
            raise ArithmeticError(
                f"division by the sum {self!r}: only a monomial divides a signomial; "
                "keep numerator and denominator apart in a Ratio"
            )
        return self**-1


def variables(*names: str) -> tuple[Signomial, ...]:
    """Return each name as the signomial that is that variable."""
    return tuple(Signomial((name,), np.ones(1), np.ones((1, 1))) for name in names)


def as_signomial(value: Signomial | float) -> Signomial:
    """Return a number as a constant signomial, a signomial as it is."""
    lifted = _lift(value)
    if lifted is None:
        raise TypeError(f"{value!r} is neither a number nor a signomial")
    return lifted


def _constant(value: float) -> Signomial:
    if not math.isfinite(value):
        raise ArithmeticError(f"{value} cannot be a coefficient")
    return _collect((), [((), value)])


def _lift(value: object) -> Signomial | None:
    if isinstance(value, Signomial):
        return value
    if isinstance(value, Real) or (isinstance(value, np.ndarray) and value.ndim == 0):
        return _constant(float(value))
    return None


def _union(left: tuple[str, ...], right: tuple[str, ...]) -> tuple[str, ...]:
    if left == right:
        return left
    return left + tuple(name for name in right if name not in left)


def _collect(names: tuple[str, ...], items: Iterable[tuple[tuple[float, ...], float]]) -> Signomial:
    """Merge like terms and drop those that cancel."""
    merged: dict[tuple[float, ...], list[Any]] = {}
    for row, coefficient in items:
        if not math.isfinite(coefficient):
            raise OverflowError("a coefficient left the range of floating-point numbers")
        entry = merged.setdefault(tuple(round(a, SAME_EXPONENT) for a in row), [row, 0.0, 0.0])
        entry[1] += coefficient
        entry[2] += abs(coefficient)
    kept = [(row, c) for row, c, size in merged.values() if abs(c) > CANCELS * size]
    return Signomial(
        names,
        np.array([c for _, c in kept], dtype=np.float64),
        np.array([row for row, _ in kept], dtype=np.float64).reshape(len(kept), len(names)),
    )


def _power(base: Any, exponent: float) -> Any:
    if not isinstance(base, Real):
        base = np.asarray(base, dtype=np.float64)
    if exponent.is_integer() and abs(exponent) <= CHEAP_POWER:
        result = base
        for _ in range(int(abs(exponent)) - 1):
            result = result * base
        return result if exponent > 0 else 1.0 / result
    return base**exponent


def _term_text(coefficient: float, powers: dict[str, float]) -> str:
    above = "*".join(_power_text(name, a) for name, a in powers.items() if a > 0)
    below = "".join("/" + _power_text(name, -a) for name, a in powers.items() if a < 0)
    if above and coefficient == 1.0:
        return above + below
    return f"{coefficient:.6g}" + ("*" + above if above else "") + below


def _power_text(name: str, exponent: float) -> str:
    return name if exponent == 1.0 else f"{name}^{exponent:.6g}"
