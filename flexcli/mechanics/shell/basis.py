"""Polynomials over the middle surface of a blade: smooth along it between clamps, any across it.

Along the blade, u from −1 to 1: Hermite's cubics for value and slope at both ends, and twice
integrated Legendre polynomials, which vanish with their slopes at the ends and whose second
derivatives are orthogonal. Across it, t from −1 to 1, Legendre's polynomials. A finer basis has
all functions of a coarser one.
"""

import functools
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Legendre
from numpy.typing import NDArray

from flexcli.numerics.collocation import gauss_nodes

__all__ = ["AT_ENDS", "Basis", "Sampled", "basis_of"]

Floats = NDArray[np.float64]

AT_ENDS = 4
"""Functions along that are not zero, with their slopes, at both ends."""


class Sampled(NamedTuple):
    """Functions along and across (order of derivative, functions, points), and the weights."""

    along: Floats
    across: Floats
    weight_along: Floats
    weight_across: Floats


class Basis(NamedTuple):
    """Numbers of functions: along, and across.

    Those along stand in the order: value at the start, slope there, value at the end, slope there,
    then those that vanish at the ends by degree. Derivatives along are by the length from 0 to 1.
    """

    along: int
    across: int

    def at(self, s: Floats, t: Floats) -> tuple[Floats, Floats]:
        """Return values and two derivatives along at s in [0, 1] and across at t in [−1, 1].

        Each (3, functions, points).
        """
        lines = [_function_along(i) for i in range(self.along)]
        rows = [_sample(lines, order, 2.0 * s - 1.0) * 2.0**order for order in range(3)]
        for row in rows:
            row[1:AT_ENDS:2] /= 2.0  # slopes by the length
        lines = [Legendre.basis(j) for j in range(self.across)]
        return np.array(rows), np.array([_sample(lines, order, t) for order in range(3)])

    def sampled(self) -> Sampled:
        """Return the functions at Gauss points that integrate the energy of stretching exactly."""
        return _sampled(self)


def basis_of(modes: int) -> Basis:
    """Return ``modes`` functions along and half as many across."""
    return Basis(modes, modes // 2)


@functools.cache
def _sampled(basis: Basis) -> Sampled:
    u, weight_along = gauss_nodes(2 * basis.along - 1)
    t, weight_across = gauss_nodes(2 * basis.across - 1)
    along, across = basis.at((u + 1.0) / 2.0, t)
    return Sampled(along, across, weight_along / 2.0, weight_across)


def _sample(lines: list[Legendre], order: int, u: Floats) -> Floats:
    return np.array([line.deriv(order)(u) if order else line(u) for line in lines])


@functools.cache
def _function_along(i: int) -> Legendre:
    """Return a function along; the first four have value or slope one at one end."""
    if i >= AT_ENDS:
        n = i - AT_ENDS + 2
        return Legendre.basis(n).integ(2, lbnd=-1) * float(np.sqrt(n + 0.5))
    at_ends = []
    for n in range(AT_ENDS):
        f = Legendre.basis(n)
        at_ends.append([f(-1.0), f.deriv()(-1.0), f(1.0), f.deriv()(1.0)])
    return Legendre(np.linalg.solve(np.transpose(at_ends), np.eye(AT_ENDS)[i]))
