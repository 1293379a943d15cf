"""Blades and notches as solids of high order: how much longer what holds their ends across makes.

By Betti's theorem that is, per strain, the work of the tractions by which rigid ends hold a body
across that is pulled: the mean of the stresses across over the pull, in all of what grows.
"""

import numpy as np
from numpy.polynomial.legendre import Legendre, leggauss

from flexcli.mechanics.solids.lagrange import element, places_along
from flexcli.mechanics.solids.neck import Neck, neck_lattice
from flexcli.mechanics.solids.octant import Lattice, Octant

ORDERS = (4, 8, 4)
FIRST, GROWING = 0.15, (2.0, 2.5)
POINTS = 24


def lengthening(lattice, nu, end=np.inf):
    """Return it of all of a body up to a place along it [m], its octant a lattice."""
    stress = Octant(lattice, 1.0, nu).moved(0).stress
    along = integral(lattice, stress[..., 0], np.inf) / lattice.x[-1, 0]
    return 2.0 * integral(lattice, stress[..., 1] + stress[..., 2], end) / along


def bar(*, l, h, b):
    """Return the octant of a blade, its bricks small at its end and sides, one to its thickness."""
    x, z = (
        places_along(cuts(size / 2.0, FIRST * min(h, b), ratio), order)
        for size, ratio, order in zip((l, b), GROWING, ORDERS[::2], strict=True)
    )
    y = places_along(np.array([0.0, h / 2.0]), ORDERS[1])
    return Lattice(*np.meshgrid(x, y, indexing="ij"), z, ORDERS)


def notch(**sizes):
    """Return the octant of a notch, with blocks beside it or without."""
    return neck_lattice(Neck(**sizes), (5, 3, 3))


def cuts(half, first, ratio):
    """Return the ends of bricks from the middle, which grow from the edge inwards."""
    cuts, size = [0.0], first
    while cuts[-1] + 1.6 * size < half:
        cuts.append(cuts[-1] + size)
        size *= ratio
    return half - np.array([*cuts, half])[::-1]


def integral(lattice, values, end):
    """Return the integral over the octant, up to a place along it, of values at its nodes."""
    along, across, wide = lattice.orders
    last = element(wide).nodes
    weights = 2.0 / (wide * (wide + 1) * Legendre.basis(wide)(last) ** 2)
    points, shares = leggauss(POINTS)
    A, B = (np.vander(points, k + 1) @ np.linalg.inv(np.vander(element(k).nodes, k + 1))
            for k in (along, across))  # fmt: skip
    total = 0.0
    for i in range(0, lattice.x.shape[0] - 1, along):
        for j in range(0, lattice.x.shape[1] - 1, across):
            at = slice(i, i + along + 1), slice(j, j + across + 1)
            x, y = lattice.x[at], lattice.y[at]
            dx, dy = element(along).at_nodes, element(across).at_nodes
            area = np.abs((dx @ x) * (y @ dy.T) - (x @ dy.T) * (dx @ y))
            inside = (A @ x @ B.T < end) * np.outer(shares, shares)
            share = A.T @ ((A @ area @ B.T) * inside) @ B
            for k in range(0, lattice.z.size - 1, wide):
                over = slice(k, k + wide + 1)
                half = abs(lattice.z[over][-1] - lattice.z[k]) / 2.0
                total += half * np.einsum("ij,ijk,k->", share, values[(*at, over)], weights)
    return total
