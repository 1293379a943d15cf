"""Elements of a plane figure that is drawn out along z, where z = 0 is a plane of symmetry.

Of loads in the plane motions in it are even in z, those along z odd; of loads out of it the other
way round. They are polynomials over the whole width, strung together. A plane figure has one
function that is even and none that is odd.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.solids.lagrange import BEYOND, element, places_along

__all__ = ["Law", "Width", "even_and_odd", "flat", "over_face", "plane_stress", "solid_law"]

Floats = NDArray[np.float64]


class Law(NamedTuple):
    """Lamé's constants λ and μ [Pa]."""

    lame: float
    mu: float


class Width(NamedTuple):
    """Functions over the width at Gauss's points of half of it, whose weights are of the whole.

    Motions in the plane have the functions ``plane``, those along z ``along`` (points, functions);
    ``plane_d`` and ``along_d`` are their slopes [1/m]. ``one`` and ``z`` are the parts of these in
    1 and in z [m], whichever of both are even.
    """

    weights: Floats
    plane: Floats
    plane_d: Floats
    along: Floats
    along_d: Floats
    one: Floats
    z: Floats
    is_aside: bool = False

    @property
    def each(self) -> int:
        """Return how many motions a node in the plane has."""
        return int(2 * self.plane.shape[1] + self.along.shape[1])

    @property
    def aside(self) -> "Width":
        """Return the same for loads out of the plane: motions in it are odd, those along z even."""
        return self._replace(
            plane=self.along, plane_d=self.along_d, along=self.plane, along_d=self.plane_d,
            is_aside=not self.is_aside,
        )  # fmt: skip

    def products(self) -> dict[str, Floats]:
        """Return what products of two functions are over the width, by the letters of both."""
        named = {"p": self.plane, "P": self.plane_d, "z": self.along, "Z": self.along_d}
        pairs = "pp", "PP", "zz", "ZZ", "pZ", "Pz"
        return {pair: (named[pair[0]].T * self.weights) @ named[pair[1]] for pair in pairs}


def solid_law(E: float, nu: float) -> Law:
    """Return the law of a solid, and of plane strain."""
    return Law(E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), E / (2.0 * (1.0 + nu)))


def plane_stress(E: float, nu: float) -> Law:
    """Return the law of plane stress, in the form of that of plane strain."""
    return Law(E * nu / (1.0 - nu**2), E / (2.0 * (1.0 + nu)))


def flat(b: float) -> Width:
    """Return the width of a plane figure: nothing changes over it."""
    one, none = np.ones((1, 1)), np.zeros((1, 1))
    return Width(np.array([b]), one, none, none[:, :0], none[:, :0], one[0], none[0, :0])


def even_and_odd(cuts: Floats, order: int) -> Width:
    """Return functions of elements that end at ``cuts``, from the first, beside z = 0, on [m].

    The first is the half of one that reaches as far beyond z = 0; the order is even.
    """
    one = element(order)
    whole = np.concatenate([-cuts[::-1], cuts])
    places = places_along(whole, order)
    gauss, _ = np.polynomial.legendre.leggauss(order + BEYOND)
    count, points = places.size, (len(whole) - 1) * gauss.size
    values, slopes, weights = np.zeros((points, count)), np.zeros((points, count)), []
    for k, (start, end) in enumerate(pairwise(whole)):
        half = (end - start) / 2.0
        rows = slice(k * gauss.size, (k + 1) * gauss.size)
        columns = slice(k * order, (k + 1) * order + 1)
        values[rows, columns], slopes[rows, columns] = one.values, one.slopes / half
        weights.append(one.weights * half)
    # what is integrated is even: points beyond z = 0 count twice
    beyond = slice(points // 2, None)
    middle = count // 2
    mirrored = slice(None, None, -1)

    def of(functions: Floats, sign: float, start: int) -> Floats:
        both = functions + sign * functions[:, mirrored]
        both[:, middle] /= 2.0
        return np.asarray(both[beyond, start:])

    return Width(
        2.0 * np.concatenate(weights)[beyond],
        of(values, 1.0, middle), of(slopes, 1.0, middle),
        of(values, -1.0, middle + 1), of(slopes, -1.0, middle + 1),
        np.ones(count - middle), places[middle + 1 :],
    )  # fmt: skip


class Face(NamedTuple):
    """An element in the plane at its Gauss points: weights [m²], values and slopes of functions.

    ``values`` (points, nodes) and ``slopes`` (2, points, nodes) [1/m].
    """

    weights: Floats
    values: Floats
    slopes: Floats

    def stiffness(self, law: Law, width: Width, products: dict[str, Floats]) -> Floats:
        """Return the stiffness of the element drawn out, its motions node by node (n, n).

        Of a node come the functions along x, those along y, then those along z.
        """
        lame, mu = law
        weighed = self.slopes * self.weights[:, None]
        S = np.einsum("agm,bgn->abmn", weighed, self.slopes, optimize=True)
        D = np.einsum("agm,gn->amn", weighed, self.values)  # of a slope and a value
        N = (self.values.T * self.weights) @ self.values
        plane, nodes = width.plane.shape[1], self.values.shape[1]
        K = np.zeros((nodes, width.each, nodes, width.each))
        at = slice(0, plane), slice(plane, 2 * plane), slice(2 * plane, width.each)

        def put(i: int, j: int, *terms: tuple[Floats, str, bool]) -> None:
            for face, pair, is_turned in terms:
                over = products[pair].T if is_turned else products[pair]
                K[:, at[i], :, at[j]] += face[:, None, :, None] * over[None, :, None, :]

        whole = mu * (S[0, 0] + S[1, 1])
        for i in range(2):
            put(i, i, ((lame + mu) * S[i, i] + whole, "pp", False), (mu * N, "PP", False))
            put(i, 1 - i, (lame * S[i, 1 - i] + mu * S[1 - i, i], "pp", False))
            put(i, 2, (lame * D[i], "pZ", False), (mu * D[i].T, "Pz", False))
            put(2, i, (lame * D[i].T, "pZ", True), (mu * D[i], "Pz", True))
        put(2, 2, ((lame + 2.0 * mu) * N, "ZZ", False), (whole, "zz", False))
        size = nodes * width.each
        return K.reshape(size, size)

    def gradient(self, width: Width, u: Floats) -> Floats:
        """Return ∂u_i/∂x_j (points, points over the width, 3, 3) of motions (nodes, each)."""
        plane = width.plane.shape[1]
        found = np.zeros((self.weights.size, width.weights.size, 3, 3))
        kinds = (
            (u[:, :plane], width.plane, width.plane_d),
            (u[:, plane : 2 * plane], width.plane, width.plane_d),
            (u[:, 2 * plane :], width.along, width.along_d),
        )
        for i, (own, over, over_d) in enumerate(kinds):
            for j in range(2):
                found[..., i, j] = self.slopes[j] @ own @ over.T
            found[..., i, 2] = self.values @ own @ over_d.T
        return found


def over_face(corners: Floats, order: int) -> Face:
    """Return an element with straight sides between its corners (4, 2) [m], counterclockwise.

    Its nodes are row by row: along the side from the first corner to the second come rows.
    """
    one = element(order)
    gauss, _ = np.polynomial.legendre.leggauss(order + BEYOND)
    values = np.kron(one.values, one.values)
    slopes = np.stack([np.kron(one.slopes, one.values), np.kron(one.values, one.slopes)])
    u, v = (each.ravel() for each in np.meshgrid(gauss, gauss, indexing="ij"))
    a, b, c, d = corners
    by_u = ((b - a) * (1.0 - v)[:, None] + (c - d) * (1.0 + v)[:, None]) / 4.0
    by_v = ((d - a) * (1.0 - u)[:, None] + (c - b) * (1.0 + u)[:, None]) / 4.0
    J = np.stack([by_u, by_v], axis=-1)  # (points, place, variable)
    weights = np.kron(one.weights, one.weights) * np.linalg.det(J)
    found = np.einsum("grc,rgn->cgn", np.linalg.inv(J), slopes)
    return Face(weights, np.asarray(values, dtype=np.float64), found)
