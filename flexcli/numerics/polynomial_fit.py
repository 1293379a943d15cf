"""Polynomials in several variables by least squares, with bounds over a box."""

from itertools import combinations_with_replacement
from math import comb
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["PolynomialFit", "polynomial_fit", "terms"]

Floats = NDArray[np.float64]

CHUNK = 65_536
"""Points per pass, which bounds the memory."""


def terms(count: int, degree: int) -> int:
    """Return the number of coefficients of a polynomial in so many variables."""
    return comb(count + degree, degree)


class PolynomialFit(NamedTuple):
    """p_r(u) = Σ_t c_tr Π_i u_i^e_ti, several rows r of the same variables.

    ``exponents`` has the shape (terms, variables), ``coefficients`` (terms, rows).
    """

    exponents: NDArray[np.int64]
    coefficients: Floats

    def at(self, u: Floats) -> Floats:
        """Return the values at points, (points, variables) to (points, rows)."""
        found = np.empty((len(u), self.coefficients.shape[1]))
        for start in range(0, len(u), CHUNK):
            part = slice(start, start + CHUNK)
            found[part] = _monomials(u[part], self.exponents) @ self.coefficients
        return found

    def slope(self, i: int) -> "PolynomialFit":
        """Return the derivative along a variable."""
        e = self.exponents
        lower = e - np.eye(e.shape[1], dtype=np.int64)[i]
        slopes: Floats = self.coefficients * e[:, i : i + 1].astype(np.float64)
        return PolynomialFit(np.maximum(lower, 0), slopes)

    def bounds(self, low: Floats, high: Floats) -> tuple[Floats, Floats]:
        """Return lower and upper bounds of the values over a box, (rows,).

        Each term is bounded by itself over the box, about its middle.
        """
        moved = self._about((low + high) / 2.0)
        reach = _monomials((high - low)[None, :] / 2.0, moved.exponents)[0]
        even = (moved.exponents % 2 == 0).all(axis=1)
        c = moved.coefficients * reach[:, None]
        constant = ~moved.exponents.any(axis=1)
        least = np.where(even[:, None], np.minimum(c, 0.0), -np.abs(c))
        most = np.where(even[:, None], np.maximum(c, 0.0), np.abs(c))
        at = c[constant].sum(axis=0)
        return at + least[~constant].sum(axis=0), at + most[~constant].sum(axis=0)

    def _about(self, middle: Floats) -> "PolynomialFit":
        """Return the same polynomial in u − middle."""
        if not middle.any():
            return self
        degree = int(self.exponents.sum(axis=1).max())
        exponents = _exponents(len(middle), degree)
        at = {tuple(e): k for k, e in enumerate(exponents.tolist())}
        c = np.zeros((len(exponents), self.coefficients.shape[1]))
        for e, row in zip(self.exponents.tolist(), self.coefficients, strict=True):
            for lower in np.ndindex(*(k + 1 for k in e)):
                share = 1.0
                for k, j, m in zip(e, lower, middle, strict=True):
                    share *= comb(k, j) * float(m) ** (k - j)
                c[at[tuple(lower)]] += share * row
        return PolynomialFit(exponents, c)


def polynomial_fit(u: Floats, values: Floats, degree: int) -> PolynomialFit:
    """Return the polynomials nearest to values at points, in least squares.

    Its error falls with the (degree + 1)-th power of the width of the box, where the values are
    smooth.

    Parameters
    ----------
    u : array, shape (points, variables)
        Points, best within [-1, 1], at least as many as :func:`terms` says.
    values : array, shape (points, rows)
        What is fitted.
    degree : int
        Total degree.

    """
    exponents = _exponents(u.shape[1], degree)
    found = np.linalg.lstsq(_monomials(u, exponents), values, rcond=None)[0]
    return PolynomialFit(exponents, np.asarray(found, dtype=np.float64))


def _exponents(count: int, degree: int) -> NDArray[np.int64]:
    found = [
        np.bincount(np.array(chosen, dtype=np.int64), minlength=count)
        for total in range(degree + 1)
        for chosen in combinations_with_replacement(range(count), total)
    ]
    return np.array(found, dtype=np.int64).reshape(len(found), count)


def _monomials(u: Floats, exponents: NDArray[np.int64]) -> Floats:
    found = np.ones((len(u), len(exponents)))
    for i in range(u.shape[1]):
        powers = [np.ones(len(u))]
        for _ in range(int(exponents[:, i].max(initial=0))):
            powers.append(powers[-1] * u[:, i])
        found *= np.stack(powers, axis=1)[:, exponents[:, i]]
    return found
