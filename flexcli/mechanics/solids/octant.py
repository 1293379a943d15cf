"""One octant of a body with three planes of symmetry, in bricks of high order.

The body is a plane region drawn out along z, so that what is integrated over a brick is a product
of its face and its width. Layers of bricks, one after the other along x, are solved by blocks.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cholesky, solve_triangular

from flexcli.mechanics.solids.lagrange import element

__all__ = ["LOADS", "Lattice", "Load", "Moved", "Octant"]

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

IN_PLANE, ACROSS = (0, 1, 5), (2, 3, 4)
"""Loads in the plane of its face, of which alone most cases ask, and across it."""


@dataclass(frozen=True, eq=False)
class Moved:
    """The octant under a unit load: compliance [m/N or rad/(N·m)], motions of the nodes [m].

    ``motions`` are (along, across, width, 3); they and the compliance hold for a load of one.
    """

    compliance: float
    motions: Floats
    lattice: Lattice
    elastic: tuple[float, float]

    @cached_property
    def stress(self) -> Floats:
        """Return xx, yy, zz, yz, zx, xy at the nodes (along, across, width, 6) [Pa]."""
        return _stress(self.lattice, self.motions, *self.elastic)


class Octant:
    """The body between rigid ends that move by one, each its way, under unit loads.

    What is sought is the rest of the motion: none at the end, and in the middle what symmetry holds
    against that. Loads in the plane are solved together, when one is first asked for, or across it.

    Parameters
    ----------
    lattice : Lattice
        The octant.
    E, nu : float
        Young's modulus [Pa] and Poisson's ratio below ½ [-].

    """

    def __init__(self, lattice: Lattice, E: float, nu: float) -> None:
        self.lattice = lattice
        self.elastic = E, nu
        self._known: dict[int, Moved | None] = {}

    def moved(self, index: int) -> Moved | None:
        """Return what the load of a place in a wrench does, by which the ends move.

        It is nothing for a load under which the body is so slender that no digits are left.
        """
        if index not in self._known:
            self._solve(IN_PLANE if index in IN_PLANE else ACROSS)
        return self._known[index]

    def _solve(self, indices: Iterable[int]) -> None:
        """Solve some loads, those of the same mirror images in y and z together."""
        groups = dict[tuple[int, int], list[int]]()
        for index in indices:
            groups.setdefault(LOADS[index].signs[1:], []).append(index)
            self._known[index] = None
        each = {signs: _Mirrored(self.lattice, signs) for signs in groups}
        layers = list[_Layer]()
        # from the rigid end to the middle, so that a soft throat keeps its digits
        for n in range(self.lattice.layers - 1, -1, -1):
            try:
                layers.append(_Layer(self.lattice, n, *self.elastic))
            except np.linalg.LinAlgError:
                return
            for one in each.values():
                one.eliminate(n, layers[-1])
        for signs, group in groups.items():
            for index in group:
                found = each[signs].moved(LOADS[index], layers[::-1])
                if found is not None:
                    self._known[index] = Moved(*found, self.lattice, self.elastic)


class _Following:
    """Motions of which some follow the others, told by their places: ``own`` those, ``rest`` these.

    ``left`` is the stiffness of the others. Only what moves freely may follow.
    """

    def __init__(self, K: Floats, own: Integers, rest: Integers) -> None:
        """Take the stiffness of all, those that follow first."""
        self.own, self.rest = own, rest
        count = own.size
        self.factor = _factor(K[:count, :count].copy())
        self.forces = _solved(self.factor, K[:count, count:])
        self.left = K[count:, count:] - self.forces.T @ self.forces

    @classmethod
    def among(cls, K: Floats, own: Integers, rest: Integers) -> "_Following":
        """Return them by a stiffness in the order of the places."""
        order = np.concatenate([own, rest])
        return cls(K[np.ix_(order, order)], own, rest)

    def fill(self, w: Floats) -> None:
        """Set the motions that follow by the others."""
        w[self.own] = -_solved(self.factor, self.forces @ w[self.rest], transposed=True)


class _Layer:
    """A layer whose nodes off its ends and off the planes of symmetry follow the others.

    These move freely under any load: those within a brick are eliminated, then those between
    bricks. ``left`` is the stiffness of the others, at the places ``others`` (of the layer's
    motions, in the order of the lattice).
    """

    def __init__(self, lattice: Lattice, n: int, E: float, nu: float) -> None:
        _, across, wide = lattice.orders
        rows, columns, width = lattice.orders[0] + 1, *lattice.shape[1:]
        self.shape = rows, columns, width, 3
        inside = np.ones(self.shape, dtype=bool)
        inside[0] = inside[-1] = inside[:, 0] = inside[:, :, 0] = False
        numbers = np.arange(inside.size).reshape(self.shape)
        apart = np.ones(self.shape, dtype=bool)  # off the faces between bricks
        apart[:, across:-1:across] = apart[:, :, wide:-1:wide] = False
        within, between = inside & apart, inside & ~apart
        kept = np.concatenate([np.flatnonzero(between), np.flatnonzero(~inside)])
        place = np.full(inside.size, -1)
        place[kept] = np.arange(kept.size)
        K = np.zeros((kept.size, kept.size))
        self.bricks = list[tuple[Integers, _Following]]()
        for first in range(0, columns - 1, across):
            at = slice(first, first + across + 1)
            of_brick = _Bricks(lattice, n, at, E, nu)
            for side in range(0, width - 1, wide):
                over = slice(side, side + wide + 1)
                half = (lattice.z[side + wide] - lattice.z[side]) / 2.0
                own = np.moveaxis(numbers[:, at, over], -1, 0).ravel()
                brick = of_brick.following(half, within.ravel()[own])
                self.bricks.append((own, brick))
                rest = place[own[brick.rest]]
                K[np.ix_(rest, rest)] += brick.left
        own, rest = np.split(np.arange(kept.size), [np.count_nonzero(between)])
        self.between = kept, _Following(K, own, rest)
        self.others, self.left = kept[rest], self.between[1].left

    def whole(self, others: Floats) -> Floats:
        """Return the motions of all nodes of the layer by those of the others."""
        w = np.empty(int(np.prod(self.shape)))
        w[self.others] = others
        for numbers, part in (self.between, *self.bricks):
            own = w[numbers]
            part.fill(own)
            w[numbers] = own
        return w.reshape(self.shape)


class _Mirrored:
    """The octant under loads of the same mirror images in y and z, layers eliminated up to a plane.

    ``beyond`` is the stiffness of what moves freely in that plane, ``kept`` has for each layer
    which of its other motions follow those of the plane before it, and how.
    """

    def __init__(self, lattice: Lattice, signs: tuple[int, int]) -> None:
        self.lattice = lattice
        self.free = _free(lattice, signs)
        self.beyond: Floats | None = np.zeros((0, 0))
        self.kept = list[_Following]()

    def eliminate(self, n: int, layer: _Layer) -> None:
        """Eliminate a layer but for the plane before it; beyond it all are eliminated already."""
        if self.beyond is None:
            return
        own = self.free[self.lattice.planes_of(n)].copy()
        near = np.zeros_like(own)
        near[0], own[0] = own[0], False
        at, before = (np.flatnonzero(each.ravel()[layer.others]) for each in (own, near))
        K, last = layer.left, len(self.beyond)
        if last:
            K = K.copy()
            K[np.ix_(at[-last:], at[-last:])] += self.beyond
        try:
            self.kept.append(_Following.among(K, at, before))
        except np.linalg.LinAlgError:
            self.beyond = None
            return
        self.beyond = self.kept[-1].left

    def moved(self, load: Load, layers: list[_Layer]) -> tuple[float, Floats] | None:
        """Return the compliance to a load and its motions, the layers from the middle on.

        Nothing is returned without digits.
        """
        if self.beyond is None:
            return None
        lattice, w = self.lattice, np.zeros((*self.lattice.shape, 3))
        try:
            middle, work = self._middle(self.beyond, load)
        except np.linalg.LinAlgError:
            return None
        if not work > 0.0:
            return None
        for n, (layer, follows) in enumerate(zip(layers, self.kept[::-1], strict=True)):
            others = np.zeros(len(layer.left))
            others[follows.rest] = middle
            follows.fill(others)
            planes = lattice.planes_of(n)
            w[planes] = layer.whole(others)
            middle = w[planes.stop - 1][self.free[planes.stop - 1]]
        # eight octants, whose ends move by one each way
        return 1.0 / (2.0 * work), w / (4.0 * work)

    def _middle(self, K: Floats, load: Load) -> tuple[Floats, float]:
        """Return how the plane x = 0 moves against an end that moves by one, and the work of that.

        ``K`` is the stiffness of what y and z = 0 leave free of it, where the end is held.
        """
        lattice, free = self.lattice, self.free[0]
        y, z = np.broadcast_arrays(lattice.y[0][:, None], lattice.z)
        at = np.stack([y, z, np.ones_like(y)], axis=-1)
        back = -at @ np.array(load.motion, dtype=np.float64).T
        along = np.arange(3) == 0
        led = np.broadcast_to(along if load.signs[0] == 1 else ~along, free.shape)[free]
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


def _free(lattice: Lattice, signs: tuple[int, int]) -> Flags:
    """Return which motions (along, across, width, 3) the end and y, z = 0 leave free."""
    free = np.ones((*lattice.shape, 3), dtype=bool)
    free[-1] = False
    for axis, sign, plane in ((1, signs[0], free[:, 0]), (2, signs[1], free[:, :, 0])):
        held = np.arange(3) == axis
        plane[..., held if sign == 1 else ~held] = False
    return free


def _lame(E: float, nu: float) -> tuple[float, float]:
    """Return Lamé's constants λ and μ [Pa]."""
    return E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), E / (2.0 * (1.0 + nu))


class _Bricks:
    """Stiffness of bricks of the same face: products of what is integrated over it and over widths.

    It is the sum of parts that go with half the width, with nothing of it, and with its inverse.
    Motions are in the order of their ways, of nodes of the face, and of those over the width.
    """

    def __init__(self, lattice: Lattice, n: int, columns: slice, E: float, nu: float) -> None:
        lame, mu = _lame(E, nu)
        S, D, N = _over_face(lattice, n, columns)  # of slopes, of a slope and a value, of values
        one = element(lattice.orders[2])
        M, C, K = (
            (f.T * one.weights) @ g
            for f, g in ((one.values, one.values), (one.slopes, one.values), (one.slopes,) * 2)
        )
        nodes, width = len(N), len(M)
        parts = np.zeros((3, 3, nodes, width, 3, nodes, width))

        def put(part: int, i: int, j: int, face: Floats, over: Floats) -> None:
            parts[part, i, :, :, j] += face[:, None, :, None] * over[None, :, None, :]

        whole = S[0, 0] + S[1, 1]
        for i in range(2):
            put(0, i, i, (lame + mu) * S[i, i] + mu * whole, M)
            put(0, i, 1 - i, lame * S[i, 1 - i] + mu * S[1 - i, i], M)
            put(1, i, 2, lame * D[i], C.T)
            put(1, i, 2, mu * D[i].T, C)
            put(1, 2, i, lame * D[i].T, C)
            put(1, 2, i, mu * D[i], C.T)
            put(2, i, i, mu * N, K)
        put(0, 2, 2, mu * whole, M)
        put(2, 2, 2, (lame + 2.0 * mu) * N, K)
        self.parts = parts.reshape(3, 3 * nodes * width, -1)
        self._ordered = dict[bytes, tuple[Integers, Integers, Floats]]()

    def following(self, half: float, follows: Flags) -> _Following:
        """Return a brick by half its width [m], of whose motions some follow the others."""
        key = follows.tobytes()
        if key not in self._ordered:  # the same of all but the last over the width
            own, rest = np.flatnonzero(follows), np.flatnonzero(~follows)
            order = np.concatenate([own, rest])
            self._ordered[key] = own, rest, self.parts[:, order[:, None], order]
        own, rest, (growing, even, falling) = self._ordered[key]
        return _Following(half * growing + even + falling / half, own, rest)


def _over_face(lattice: Lattice, n: int, columns: slice) -> tuple[Floats, Floats, Floats]:
    """Return what slopes, a slope and a value, and values are together over a brick's face.

    Their shapes are (2, 2, nodes, nodes), (2, nodes, nodes) and (nodes, nodes).
    """
    along, across, _ = lattice.orders
    one, other = element(along), element(across)
    values = np.kron(one.values, other.values)
    slopes = np.stack([np.kron(one.slopes, other.values), np.kron(one.values, other.slopes)])
    rows = lattice.planes_of(n)
    places = np.stack([lattice.x[rows, columns].ravel(), lattice.y[rows, columns].ravel()])
    J = np.einsum("rgn,cn->gcr", slopes, places)
    w = np.kron(one.weights, other.weights) * np.linalg.det(J)
    d = np.einsum("grc,rgn->cgn", np.linalg.inv(J), slopes)
    weighed = np.swapaxes(d, 1, 2) * w
    return weighed[:, None] @ d, weighed @ values, (values.T * w) @ values


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
