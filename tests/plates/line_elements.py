"""Shape functions of high order along a line, for elements that are products of them."""

import numpy as np
from numpy.polynomial import legendre

__all__ = ["line_element"]


def line_element(p):
    """Return nodes from −1 to 1, Gauss's points and weights, and functions of degree p with slopes.

    The nodes are Lobatto's; functions and slopes (points, nodes) are of a function that is one at
    its node and none at the others.
    """
    nodes = np.concatenate([[-1], legendre.legroots(legendre.legder([0] * p + [1])), [1]])
    to_legendre = np.linalg.inv(legendre.legvander(nodes, p))
    g, w = legendre.leggauss(p + 2)
    N = legendre.legvander(g, p) @ to_legendre
    D = np.transpose([legendre.legval(g, legendre.legder(c)) for c in np.eye(p + 1)]) @ to_legendre
    return nodes, g, w, N, D
