"""Polynomials of Lagrange on Gauss–Lobatto points, strung together along a line of elements."""

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

__all__ = ["Element", "element", "places_along"]

Floats = NDArray[np.float64]

BEYOND = 2
"""Gauss points more than the order: what maps an element is no polynomial of its own."""


class Element(NamedTuple):
    """An element of a line on [−1, 1]: its nodes, and its functions (points, nodes) at Gauss's.

    ``at_nodes`` (nodes, nodes) are slopes at the nodes themselves.
    """

    nodes: Floats
    weights: Floats
    values: Floats
    slopes: Floats
    at_nodes: Floats


@cache
def element(order: int) -> Element:
    """Return the element of an order; do not write to it: it is shared."""
    last = legendre.Legendre.basis(order)
    nodes = np.concatenate([[-1.0], np.sort(last.deriv().roots().real), [1.0]])
    gauss, weights = legendre.leggauss(order + BEYOND)
    # Legendre's polynomials at the nodes turn values into coefficients
    inverse = np.linalg.inv(legendre.legvander(nodes, order))
    sloped = legendre.legder(np.eye(order + 1))
    return Element(
        nodes,
        weights,
        legendre.legvander(gauss, order) @ inverse,
        legendre.legvander(gauss, order - 1) @ sloped @ inverse,
        legendre.legvander(nodes, order - 1) @ sloped @ inverse,
    )


def places_along(cuts: Floats, order: int) -> Floats:
    """Return the nodes of a line of elements that end at ``cuts``."""
    share = (element(order).nodes[:-1] + 1.0) / 2.0
    inner = cuts[:-1, None] + share * np.diff(cuts)[:, None]
    return np.append(inner.ravel(), cuts[-1])
