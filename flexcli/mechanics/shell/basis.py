"""Polynomials over the middle surface of a blade: smooth along it between clamps, any across it.

Along the blade, u from 0 to 1, functions have a continuous slope: Hermite's cubics for values and
slopes at the knots, and on each piece twice integrated Legendre polynomials, which vanish with
their slopes at its ends and whose second derivatives are orthogonal. Across it, t from −1 to 1,
they are Legendre's polynomials. A finer basis has all functions of a coarser one.
"""

import functools
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Legendre
from numpy.typing import NDArray

from flexcli.numerics.collocation import gauss_nodes

__all__ = ["Basis", "Sampled", "basis_of"]

Floats = NDArray[np.float64]

_HERMITE = 4
"""Functions along a blade that its clamps take part in: values and slopes at both ends."""


class Sampled(NamedTuple):
    """Functions along and across (order of derivative, functions, points), and the weights."""

    along: Floats
    across: Floats
    weight_along: Floats
    weight_across: Floats


class Basis(NamedTuple):
    """Functions on pieces between ``knots``, ``degrees`` + 1 on each, and ``across`` of them.

    Those along a blade stand in the order: value at 0, slope at 0, value at 1, slope at 1, values
    and slopes at the knots between, then the bubbles by degree, piece by piece.
    """

    knots: tuple[float, ...]
    modes: int
    across: int

    @property
    def along(self) -> int:
        """Return the number of functions along the blade."""
        pieces = len(self.knots) - 1
        return 2 * (pieces + 1) + (self.modes - _HERMITE) * pieces

    def at(self, u: Floats, t: Floats) -> tuple[Floats, Floats]:
        """Return values and two derivatives along at u, and across at t (3, functions, points)."""
        rows = np.zeros((3, self.along, u.size))
        last = len(self.knots) - 2
        at = np.clip(np.searchsorted(self.knots, u, side="right") - 1, 0, last)
        inner = 2 * (last + 2)
        for k, (a, b) in enumerate(pairwise(self.knots)):
            own, long = np.flatnonzero(at == k), b - a
            xi = 2.0 * (u[own] - a) / long - 1.0
            for order in range(3):
                by = (2.0 / long) ** order
                cubics = np.array([f.deriv(order)(xi) if order else f(xi) for f in _hermite()])
                for end in range(2):
                    knot = self._place(k + end)
                    rows[order, knot, own] = by * cubics[2 * end]
                    rows[order, knot + 1, own] = by * cubics[2 * end + 1] * long / 2.0
                for n in range(self.modes - _HERMITE):
                    f = _bubble(n + 2)
                    place = inner + n * (last + 1) + k
                    rows[order, place, own] = by * (f.deriv(order)(xi) if order else f(xi))
        lines = [Legendre.basis(j) for j in range(self.across)]
        columns = [[f.deriv(order)(t) if order else f(t) for f in lines] for order in range(3)]
        return rows, np.array(columns)

    def _place(self, knot: int) -> int:
        """Return where the value at a knot stands."""
        last = len(self.knots) - 1
        return {0: 0, last: 2}.get(knot, 2 + 2 * knot)

    def sampled(self) -> Sampled:
        """Return the functions at Gauss points that integrate the energy of stretching exactly."""
        return _sampled(self)


@functools.cache
def basis_of(knots: tuple[float, ...], modes: int) -> Basis:
    """Return ``modes`` functions along each piece between knots, and half as many across."""
    return Basis(knots, modes, modes // 2)


@functools.cache
def _sampled(basis: Basis) -> Sampled:
    xi, weight = gauss_nodes(2 * basis.modes - 1)
    u = [a + (b - a) * (xi + 1.0) / 2.0 for a, b in pairwise(basis.knots)]
    w = [(b - a) / 2.0 * weight for a, b in pairwise(basis.knots)]
    t, weight_across = gauss_nodes(2 * basis.across - 1)
    along, across = basis.at(np.concatenate(u), t)
    return Sampled(along, across, np.concatenate(w), weight_across)


@functools.cache
def _hermite() -> tuple[Legendre, ...]:
    """Return value and slope at −1, value and slope at 1."""
    ends = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    rows = []
    for n in range(4):
        f = Legendre.basis(n)
        rows.append([f(-1.0), f.deriv()(-1.0), f(1.0), f.deriv()(1.0)])
    return tuple(Legendre(c) for c in np.linalg.solve(np.array(rows).T, np.array(ends)).T)


@functools.cache
def _bubble(n: int) -> Legendre:
    """Return what has √(n + ½) P_n for its second derivative and vanishes at ±1 with its slope."""
    return Legendre.basis(n).integ(2, lbnd=-1) * float(np.sqrt(n + 0.5))
