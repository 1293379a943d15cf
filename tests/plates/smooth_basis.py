"""Piecewise polynomials with a continuous slope on a line: cubics at the nodes, bubbles between.

Products of two such lines are the trial functions of a plate. Knots that crowd geometrically
towards an edge follow the singularities in its corners.
"""

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre

__all__ = ["Basis", "graded", "smooth_basis"]

SHARE = 0.15
"""Each element towards a corner over the last, as is best for powers of the distance."""


class Basis(NamedTuple):
    """Knots and the number of bubbles an element; function 2i and 2i + 1 are value and slope."""

    knots: np.ndarray
    bubbles: int

    @property
    def size(self):
        return 2 * len(self.knots) + self.bubbles * (len(self.knots) - 1)

    def places(self, element):
        """Return which functions live on an element."""
        first = 2 * len(self.knots) + self.bubbles * element
        return [*range(2 * element, 2 * element + 4), *range(first, first + self.bubbles)]

    def at(self, x, order):
        """Return a derivative of all functions at places, shape (places, functions)."""
        x = np.atleast_1d(x)
        element = np.clip(np.searchsorted(self.knots, x, side="right") - 1, 0, len(self.knots) - 2)
        rows = np.zeros((x.size, self.size))
        for i in np.unique(element):
            here = element == i
            length = self.knots[i + 1] - self.knots[i]
            u = 2.0 * (x[here] - self.knots[i]) / length - 1.0
            rows[np.ix_(here, self.places(i))] = self._local(u, length, order)
        return rows

    def _local(self, u, length, order):
        return _scaled(_values(u, self.bubbles, order), length, order)

    def products(self, i, j):
        """Return ∫ f⁽ⁱ⁾ f⁽ʲ⁾ dx of all pairs of functions."""
        found = np.zeros((self.size, self.size))
        left, right = (_at_gauss(self.bubbles, order) for order in (i, j))
        for place, w, length, _ in self._elements():
            one = _scaled(left, length, i).T * w
            found[np.ix_(place, place)] += one @ _scaled(right, length, j)
        return found

    def moments(self, order, load):
        """Return ∫ f⁽ᵒʳᵈᵉʳ⁾ load(x) dx of all functions."""
        found, values = np.zeros(self.size), _at_gauss(self.bubbles, order)
        for place, w, length, x in self._elements():
            found[place] += _scaled(values, length, order).T @ (w * load(x))
        return found

    def _elements(self):
        u, gauss = _gauss(self.bubbles + 6)
        for element, (start, end) in enumerate(zip(self.knots[:-1], self.knots[1:], strict=True)):
            length = end - start
            x = start + (u + 1.0) * length / 2.0
            yield self.places(element), gauss * length / 2.0, length, x


def smooth_basis(knots, bubbles):
    """Return the functions on given knots."""
    return Basis(np.asarray(knots, dtype=float), bubbles)


def graded(length, scale, levels, *, both):
    """Return knots on [0, length], from a scale before its end on; before both ends if asked."""
    near = min(scale, length / 3.0)
    layer = near * SHARE ** np.arange(levels, dtype=float)
    end = length - layer
    start = layer[::-1] if both else np.empty(0)
    return np.unique(np.concatenate([[0.0], start, end, [length]]))


_gauss = cache(legendre.leggauss)


def _values(u, bubbles, order):
    """Return a derivative by u of the functions of an element at places (places, functions)."""
    each = [legendre.legder(c, order) if order else c for c in _shapes(bubbles)]
    return np.array([legendre.legval(u, c) for c in each]).T


@cache
def _at_gauss(bubbles, order):
    """Return these at the nodes of the rule that integrates products; shared, do not write."""
    return _values(_gauss(bubbles + 6)[0], bubbles, order)


def _scaled(values, length, order):
    """Return the derivative by x on an element of a length; slopes at its ends are by x."""
    found = values * (2.0 / length) ** order
    found[:, [1, 3]] *= length / 2.0
    return found


@cache
def _shapes(bubbles):
    """Return Legendre coefficients of Hermite's four cubics and of the bubbles, on [−1, 1]."""
    cubics = [[2, -3, 0, 1], [1, -1, -1, 1], [2, 3, 0, -1], [-1, -1, 1, 1]]
    found = [legendre.poly2leg(np.array(c) / 4.0) for c in cubics]
    for k in range(2, bubbles + 2):
        bend = np.zeros(k + 1)
        bend[k] = np.sqrt((2 * k + 1) / 2.0)
        found.append(legendre.legint(bend, 2, lbnd=-1))
    return found
