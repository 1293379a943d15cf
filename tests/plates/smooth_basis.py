"""Piecewise polynomials with a continuous slope on a line: cubics at the nodes, bubbles between.

Products of two such lines are the trial functions of a plate. Knots that crowd geometrically
towards an edge follow the singularities in its corners.
"""

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
        columns = []
        for index, c in enumerate(_shapes(self.bubbles)):
            scale = length / 2.0 if index in (1, 3) else 1.0
            found = legendre.legval(u, legendre.legder(c, order) if order else c)
            columns.append(scale * found * (2.0 / length) ** order)
        return np.array(columns).T

    def products(self, i, j):
        """Return ∫ f⁽ⁱ⁾ f⁽ʲ⁾ dx of all pairs of functions."""
        found = np.zeros((self.size, self.size))
        for place, u, w, length, _ in self._elements():
            left, right = (self._local(u, length, order) for order in (i, j))
            found[np.ix_(place, place)] += (left.T * w) @ right
        return found

    def moments(self, order, load):
        """Return ∫ f⁽ᵒʳᵈᵉʳ⁾ load(x) dx of all functions."""
        found = np.zeros(self.size)
        for place, u, w, length, x in self._elements():
            found[place] += self._local(u, length, order).T @ (w * load(x))
        return found

    def _elements(self):
        u, gauss = legendre.leggauss(self.bubbles + 6)
        for element, (start, end) in enumerate(zip(self.knots[:-1], self.knots[1:], strict=True)):
            length = end - start
            x = start + (u + 1.0) * length / 2.0
            yield self.places(element), u, gauss * length / 2.0, length, x


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


def _shapes(bubbles):
    """Return Legendre coefficients of Hermite's four cubics and of the bubbles, on [−1, 1]."""
    cubics = [[2, -3, 0, 1], [1, -1, -1, 1], [2, 3, 0, -1], [-1, -1, 1, 1]]
    found = [legendre.poly2leg(np.array(c) / 4.0) for c in cubics]
    for k in range(2, bubbles + 2):
        bend = np.zeros(k + 1)
        bend[k] = np.sqrt((2 * k + 1) / 2.0)
        found.append(legendre.legint(bend, 2, lbnd=-1))
    return found
