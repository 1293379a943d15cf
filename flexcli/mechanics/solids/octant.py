"""One octant of a body with three planes of symmetry, in bricks of high order.

The body is a plane region drawn out along z, so that what is integrated over a brick is a product
of its face and its width. Layers of bricks, one after the other along x, are solved by blocks.
"""

from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cholesky, solve_triangular

from flexcli.mechanics.solids.lagrange import element

__all__ = ["LOADS", "Lattice", "Load", "Moved", "moved"]

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Integers = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class Lattice:
    """Nodes of the octant: x, y (along, across) [m] of the face, z (width,) from the middle [m].

    ``orders`` are those of the bricks along, across and over the width. The first nodes along lie
    in x = 0, the first across in y = 0; the last along are tied to a rigid body. ``mouth`` is how
    many along there are before the one where a neck ends.
    """

    x: Floats
    y: Floats
    z: Floats
    orders: tuple[int, int, int]
    mouth: int = 0

    @property
    def shape(self) -> tuple[int, int, int]:
        """Return how many nodes it has along, across and over the width."""
        along, across = self.x.shape
        return along, across, self.z.size

    @property
    def layers(self) -> int:
        """Return how many layers of bricks it has along."""
        return (len(self.x) - 1) // self.orders[0]

    def planes_of(self, n: int) -> slice:
        """Return which nodes along are those of a layer, its ends among them."""
        return slice(n * self.orders[0], (n + 1) * self.orders[0] + 1)


class Load(NamedTuple):
    """A unit load between both ends, and how the body moves under it.

    ``signs`` are 1 where the motion is its own mirror image in x, y, z = 0, −1 where it is that
    reversed; ``motion`` is that of the end, as the factors (3, 3) of y, z and 1 in ux, uy, uz.
    """

    signs: tuple[int, int, int]
    motion: tuple[tuple[float, float, float], ...]


LOADS = (
    Load((1, 1, 1), ((0, 0, 1), (0, 0, 0), (0, 0, 0))),
    Load((-1, -1, 1), ((0, 0, 0), (0, 0, 1), (0, 0, 0))),
    Load((-1, 1, -1), ((0, 0, 0), (0, 0, 0), (0, 0, 1))),
    Load((-1, -1, -1), ((0, 0, 0), (0, -1, 0), (1, 0, 0))),
    Load((1, 1, -1), ((0, 1, 0), (0, 0, 0), (0, 0, 0))),
    Load((1, -1, 1), ((-1, 0, 0), (0, 0, 0), (0, 0, 0))),
)
"""In the order of a wrench, about the middle of the body, which makes its compliance diagonal."""


class Moved(NamedTuple):
    """The octant under a unit load: compliance [m/N or rad/(N·m)], stresses at the nodes [Pa].

    ``stress`` (along, across, width, 6) are xx, yy, zz, yz, zx, xy.
    """

    compliance: float
    stress: Floats


def moved(lattice: Lattice, E: float, nu: float) -> tuple[Moved | None, ...]:
    """Return what each of the unit loads does to the body between rigid ends.

    The ends move by one, rigidly, each its way. What is sought is the rest of the motion: none at
    the end, and in the middle what symmetry holds against that. Nothing is returned for a load
    under which the body is so slender that no digits are left.

    Parameters
    ----------
    lattice : Lattice
        The octant.
    E, nu : float
        Young's modulus [Pa] and Poisson's ratio below ½ [-].

    """
    stiffness, each = _Layers(lattice, E, nu), [_UnderLoad(lattice, load) for load in LOADS]
    everywhere = np.all([one.free for one in each], axis=0)
    # from the rigid end to the middle, so that a soft throat keeps its digits
    within = list[_Within]()
    for n in range(lattice.layers - 1, -1, -1):
        try:
            within.append(_Within(stiffness.of_layer(n), everywhere[lattice.planes_of(n)]))
        except np.linalg.LinAlgError:
            return (None,) * len(each)
        for one in each:
            one.eliminate(n, within[-1])
    return tuple(one.moved(within[::-1], E, nu) for one in each)


class _Within:
    """A layer whose nodes off its ends and off the planes of symmetry follow the others.

    These move freely under any load: they are eliminated once for all. ``left`` is the stiffness of
    the others, ``others`` tells which of the layer's motions they are.
    """

    def __init__(self, K: Floats, free: Flags) -> None:
        inside = free.copy()
        inside[0] = inside[-1] = False
        self.shape, self.inside, self.others = free.shape, inside.ravel(), ~inside.ravel()
        own, rest = np.flatnonzero(self.inside), np.flatnonzero(self.others)
        self.factor = _factor(K[np.ix_(own, own)])
        self.forces = _solved(self.factor, K[np.ix_(own, rest)])
        self.left = K[np.ix_(rest, rest)] - self.forces.T @ self.forces

    def whole(self, others: Floats) -> Floats:
        """Return the motions of all nodes of the layer by those of the others."""
        w = np.empty(self.inside.size)
        w[self.others] = others
        w[self.inside] = -_solved(self.factor, self.forces @ others, transposed=True)
        return w.reshape(self.shape)


class _UnderLoad:
    """The octant under one unit load, layers eliminated up to a plane.

    ``beyond`` is the stiffness of what moves freely in that plane, ``kept`` has for each layer
    which of its other motions follow those of the plane before it, and how.
    """

    def __init__(self, lattice: Lattice, load: Load) -> None:
        self.lattice, self.load = lattice, load
        self.free = _free(lattice, load)
        self.beyond: Floats | None = np.zeros((0, 0))
        self.kept = list[tuple[Integers, Integers, Floats, Floats]]()

    def eliminate(self, n: int, layer: _Within) -> None:
        """Eliminate a layer but for the plane before it; beyond it all are eliminated already."""
        if self.beyond is None:
            return
        own = self.free[self.lattice.planes_of(n)].copy()
        near = np.zeros_like(own)
        near[0], own[0] = own[0], False
        at, before = (np.flatnonzero(each.ravel()[layer.others]) for each in (own, near))
        K, last = layer.left[np.ix_(at, at)], len(self.beyond)
        if last:
            K[-last:, -last:] += self.beyond
        try:
            factor = _factor(K)
        except np.linalg.LinAlgError:
            self.beyond = None
            return
        forces = _solved(factor, layer.left[np.ix_(at, before)])
        self.beyond = layer.left[np.ix_(before, before)] - forces.T @ forces
        self.kept.append((at, before, factor, forces))

    def moved(self, layers: list[_Within], E: float, nu: float) -> Moved | None:
        """Return what the load does, its layers from the middle on; nothing without digits."""
        if self.beyond is None:
            return None
        lattice, w = self.lattice, np.zeros((*self.lattice.shape, 3))
        try:
            middle, work = self._middle(self.beyond)
        except np.linalg.LinAlgError:
            return None
        if not work > 0.0:
            return None
        for n, layer in enumerate(layers):
            at, before, factor, forces = self.kept.pop()
            others = np.zeros(len(layer.left))
            others[before] = middle
            others[at] = -_solved(factor, forces @ middle, transposed=True)
            planes = lattice.planes_of(n)
            w[planes] = layer.whole(others)
            middle = w[planes.stop - 1][self.free[planes.stop - 1]]
        # eight octants, whose ends move by one each way
        return Moved(1.0 / (2.0 * work), _stress(lattice, w / (4.0 * work), E, nu))

    def _middle(self, K: Floats) -> tuple[Floats, float]:
        """Return how the plane x = 0 moves against an end that moves by one, and the work of that.

        ``K`` is the stiffness of what y and z = 0 leave free of it, where the end is held.
        """
        lattice, free = self.lattice, self.free[0]
        y, z = np.broadcast_arrays(lattice.y[0][:, None], lattice.z)
        at = np.stack([y, z, np.ones_like(y)], axis=-1)
        back = -at @ np.array(self.load.motion, dtype=np.float64).T
        along = np.arange(3) == 0
        led = np.broadcast_to(along if self.load.signs[0] == 1 else ~along, free.shape)[free]
        given, left = np.flatnonzero(led), np.flatnonzero(~led)
        w = np.zeros(len(K))
        w[given] = back[free][given]
        factor = _factor(K[np.ix_(left, left)])
        follows = _solved(factor, K[np.ix_(left, given)] @ w[given])
        w[left] = -_solved(factor, follows, transposed=True)
        return w, float(w[given] @ K[given] @ w)


def _factor(K: Floats) -> Floats:
    """Return the lower factor of Cholesky."""
    return np.asarray(cholesky(K, lower=True, overwrite_a=True, check_finite=False))


def _solved(factor: Floats, right: Floats, *, transposed: bool = False) -> Floats:
    """Return a lower factor's, or its transpose's, solution."""
    way: Literal["T", "N"] = "T" if transposed else "N"
    return np.asarray(solve_triangular(factor, right, way, lower=True, check_finite=False))


def _free(lattice: Lattice, load: Load) -> Flags:
    """Return which motions (along, across, width, 3) the end and y, z = 0 leave free."""
    free = np.ones((*lattice.shape, 3), dtype=bool)
    free[-1] = False
    for axis, plane in ((1, free[:, 0]), (2, free[:, :, 0])):
        held = np.arange(3) == axis
        plane[..., held if load.signs[axis] == 1 else ~held] = False
    return free


def _lame(E: float, nu: float) -> tuple[float, float]:
    """Return Lamé's constants λ and μ [Pa]."""
    return E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), E / (2.0 * (1.0 + nu))


class _Layers:
    """Stiffness of layers of bricks: products of what is integrated over faces and over widths."""

    def __init__(self, lattice: Lattice, E: float, nu: float) -> None:
        self.lattice = lattice
        self.lame = _lame(E, nu)
        self.M, self.C, self.K = _over_width(lattice.z, lattice.orders[2])

    def of_layer(self, n: int) -> Floats:
        """Return the stiffness of a layer, its nodes in the order of the lattice."""
        M, C, K = self.M, self.C, self.K
        lame, mu = self.lame
        S, D, N = _over_faces(self.lattice, n)  # of slopes, of a slope and a value, of values
        nodes, width = N.shape[0], M.shape[0]
        found = np.empty((nodes, width, 3, nodes, width, 3))

        def put(i: int, j: int, *products: tuple[Floats, Floats]) -> None:
            for k, (face, over) in enumerate(products):
                part = face[:, None, :, None] * over[None, :, None, :]
                if k == 0:
                    found[:, :, i, :, :, j] = part
                else:
                    found[:, :, i, :, :, j] += part

        whole = S[0, 0] + S[1, 1]
        for i in range(2):
            put(i, i, ((lame + mu) * S[i, i] + mu * whole, M), (mu * N, K))
            put(i, 1 - i, (lame * S[i, 1 - i] + mu * S[1 - i, i], M))
            put(i, 2, (lame * D[i], C.T), (mu * D[i].T, C))
            put(2, i, (lame * D[i].T, C), (mu * D[i], C.T))
        put(2, 2, ((lame + 2.0 * mu) * N, K), (mu * whole, M))
        return found.reshape(3 * nodes * width, -1)


def _over_width(z: Floats, order: int) -> tuple[Floats, Floats, Floats]:
    """Return what values, a slope and a value, and slopes are together over the width."""
    one = element(order)
    found = np.zeros((3, z.size, z.size))
    for first in range(0, z.size - 1, order):
        at = slice(first, first + order + 1)
        half = (z[first + order] - z[first]) / 2.0
        N, d, w = one.values, one.slopes / half, one.weights * half
        found[:, at, at] += [N.T * w @ N, d.T * w @ N, d.T * w @ d]
    return found[0], found[1], found[2]


def _over_faces(lattice: Lattice, n: int) -> tuple[Floats, Floats, Floats]:
    """Return what slopes, a slope and a value, and values are together over a layer's faces.

    Their shapes are (2, 2, nodes, nodes), (2, nodes, nodes) and (nodes, nodes).
    """
    along, across, _ = lattice.orders
    one, other = element(along), element(across)
    values = np.kron(one.values, other.values)
    slopes = np.stack([np.kron(one.slopes, other.values), np.kron(one.values, other.slopes)])
    weights = np.kron(one.weights, other.weights)
    columns = lattice.x.shape[1]
    count = (along + 1) * columns
    S, D, N = np.zeros((2, 2, count, count)), np.zeros((2, count, count)), np.zeros((count, count))
    rows = lattice.planes_of(n)
    for first in range(0, columns - 1, across):
        at = slice(first, first + across + 1)
        places = np.stack([lattice.x[rows, at].ravel(), lattice.y[rows, at].ravel()])
        J = np.einsum("rgn,cn->gcr", slopes, places)
        w = weights * np.linalg.det(J)
        d = np.einsum("grc,rgn->cgn", np.linalg.inv(J), slopes)
        numbers = (np.arange(along + 1)[:, None] * columns + np.arange(columns)[at]).ravel()
        where = np.ix_(numbers, numbers)
        for i in range(2):
            for j in range(2):
                S[i, j][where] += (d[i].T * w) @ d[j]
            D[i][where] += (d[i].T * w) @ values
        N[where] += (values.T * w) @ values
    return S, D, N


def _stress(lattice: Lattice, u: Floats, E: float, nu: float) -> Floats:
    """Return the stress at the nodes, the mean of the bricks that meet there."""
    along, across, wide = lattice.orders
    one, other, third = element(along), element(across), element(wide)
    total, count = np.zeros((*lattice.shape, 6)), np.zeros((*lattice.shape, 1))
    nx, nt, nz = lattice.shape
    lame, mu = _lame(E, nu)
    for i in range(0, nx - 1, along):
        for j in range(0, nt - 1, across):
            face = slice(i, i + along + 1), slice(j, j + across + 1)
            x, y = lattice.x[face], lattice.y[face]
            rates = [(one.at_nodes @ c, c @ other.at_nodes.T) for c in (x, y)]
            J = np.stack([np.stack(each, axis=-1) for each in rates], axis=-2)
            inverse = np.linalg.inv(J)
            for k in range(0, nz - 1, wide):
                at = (*face, slice(k, k + wide + 1))
                half = (lattice.z[k + wide] - lattice.z[k]) / 2.0
                own = u[at]
                by = np.stack(
                    [
                        np.einsum("ia,abcm->ibcm", one.at_nodes, own),
                        np.einsum("jb,abcm->ajcm", other.at_nodes, own),
                    ],
                    axis=-1,
                )
                g = np.empty((*own.shape, 3))
                g[..., :2] = np.einsum("abcmr,abrs->abcms", by, inverse)
                g[..., 2] = np.einsum("kc,abcm->abkm", third.at_nodes, own) / half
                strain = (g + np.swapaxes(g, -1, -2)) / 2.0
                volume = lame * np.trace(strain, axis1=-2, axis2=-1)
                s = 2.0 * mu * strain
                total[at] += np.stack(
                    [
                        *(s[..., m, m] + volume for m in range(3)),
                        s[..., 1, 2], s[..., 0, 2], s[..., 0, 1],
                    ],
                    axis=-1,
                )  # fmt: skip
                count[at] += 1.0
    return np.asarray(total / count)
