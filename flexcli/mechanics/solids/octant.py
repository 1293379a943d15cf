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

    def solve(self, indices: Iterable[int]) -> None:
        """Solve what is not known yet of loads, told by their places in a wrench, all together."""
        unknown = {index for index in indices if index not in self._known}
        asked = [group for group in (IN_PLANE, ACROSS) if unknown.intersection(group)]
        if asked:
            self._solve(sum(asked, ()))

    def moved(self, index: int) -> Moved | None:
        """Return what the load of a place in a wrench does, by which the ends move.

        It is nothing for a load under which the body is so slender that no digits are left.
        """
        self.solve([index])
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
    """Motions of which the first ``count`` follow the others. Only what moves freely may follow.

    ``K`` is the stiffness of all: its part of the others becomes that of these alone.
    """

    def __init__(self, K: Floats, count: int) -> None:
        self.count = count
        self.factor = _factor(K[:count, :count])
        self.forces = _solved(self.factor, K[:count, count:])
        K[count:, count:] -= self.forces.T @ self.forces

    def fill(self, w: Floats) -> None:
        """Set the motions that follow by the others."""
        count = self.count
        w[:count] = -_solved(self.factor, self.forces @ w[count:], transposed=True)


class _Layer:
    """A layer whose nodes off its ends and off the planes of symmetry follow the others.

    These move freely under any load: those within a brick are eliminated, then those between
    bricks. ``left`` is the stiffness of the others, at the places ``others`` (of the layer's
    motions, in the order of the lattice): first those in z = 0 off the edges of the face, then
    those at its edges, plane by plane of z.
    """

    def __init__(self, lattice: Lattice, n: int, E: float, nu: float) -> None:
        rows, columns, width = lattice.orders[0] + 1, *lattice.shape[1:]
        self.shape = rows, columns, width, 3
        in_order = np.moveaxis(np.arange(int(np.prod(self.shape))).reshape(self.shape), 2, 0)
        numbers = in_order.reshape(width, rows * columns, 3)
        bricks = _Bricks(lattice, n, E, nu)
        off, edge = numbers[:, bricks.off], numbers[:, bricks.edge]
        wide = bricks.wide
        between, middle, edges = off[wide:-1:wide].ravel(), off[0].ravel(), edge.ravel()
        self.others = np.concatenate([middle, edges])
        starts = np.cumsum([0, between.size, middle.size])
        K = np.zeros((starts[2] + edges.size,) * 2)
        self.bricks = list[tuple[Integers, _Following]]()
        plane, face = edge[0].size, off[0].size
        for k, first in enumerate(range(0, width - 1, wide)):
            half = (lattice.z[first + wide] - lattice.z[first]) / 2.0
            is_last = first + wide == width - 1
            of_brick = bricks.stiffness(half)
            brick = _Following(of_brick, bricks.alone if not is_last else bricks.alone + face)
            left = of_brick[brick.count :, brick.count :]
            own = off[[*range(first + 1, first + wide + 1), first]].ravel()
            own = np.concatenate([own, edge[first : first + wide + 1].ravel()])
            self.bricks.append((own, brick))
            # its faces of nodes that bricks share, and its edges
            near = starts[1] if k == 0 else (k - 1) * face
            along = starts[2] + first * plane
            places = [near, along] if is_last else [k * face, near, along]
            sizes = [*(face,) * (len(places) - 1), (wide + 1) * plane]
            cuts = np.cumsum([0, *sizes])
            for i, row in enumerate(places):
                for j, column in enumerate(places):
                    part = left[cuts[i] : cuts[i + 1], cuts[j] : cuts[j + 1]]
                    K[row : row + sizes[i], column : column + sizes[j]] += part
        self.between = np.concatenate([between, self.others]), _Following(K, between.size)
        self.left = K[between.size :, between.size :]

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

    ``beyond`` is the stiffness of what moves freely in that plane; ``kept`` has for each layer the
    places of its free motions, which of these are in its last plane, and how all follow those in
    its first plane, which are the last.
    """

    def __init__(self, lattice: Lattice, signs: tuple[int, int]) -> None:
        self.lattice = lattice
        self.free = _free(lattice, signs)
        self.beyond: Floats | None = np.zeros((0, 0))
        self.kept = list[tuple[Integers, slice, _Following]]()

    def eliminate(self, n: int, layer: _Layer) -> None:
        """Eliminate a layer but for the plane before it; beyond it all are eliminated already."""
        if self.beyond is None:
            return
        free = self.free[self.lattice.planes_of(n)]
        rows = np.arange(len(free)).repeat(free[0].size)[layer.others]
        is_free = free.ravel()[layer.others]
        is_first, is_last = rows == 0, rows == len(free) - 1
        inner, last, first = (
            np.flatnonzero(is_free & at) for at in (~(is_first | is_last), is_last, is_first)
        )
        order = np.concatenate([inner, last, first])
        K = layer.left[order][:, order]
        far = slice(inner.size, inner.size + last.size)
        K[far, far] += self.beyond
        try:
            self.kept.append((order, far, _Following(K, far.stop)))
        except np.linalg.LinAlgError:
            self.beyond = None
            return
        self.beyond = K[far.stop :, far.stop :]

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
        for n, (layer, (order, far, follows)) in enumerate(
            zip(layers, self.kept[::-1], strict=True)
        ):
            own = np.concatenate([np.empty(far.stop), middle])
            follows.fill(own)
            others = np.zeros(len(layer.left))
            others[order] = own
            w[lattice.planes_of(n)] = layer.whole(others)
            middle = own[far]
        # eight octants, whose ends move by one each way
        return 1.0 / (2.0 * work), w / (4.0 * work)

    def _middle(self, K: Floats, load: Load) -> tuple[Floats, float]:
        """Return how the plane x = 0 moves against an end that moves by one, and the work of that.

        ``K`` is the stiffness of what y and z = 0 leave free of it, where the end is held.
        """
        lattice, free = self.lattice, np.swapaxes(self.free[0], 0, 1)
        y, z = np.broadcast_arrays(lattice.y[0], lattice.z[:, None])
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
    return np.asarray(cholesky(K, lower=True, check_finite=False))


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
    Nodes ``off`` the edges of the face that others share or y = 0 holds come first, those of the
    first plane of z last, then those at the ``edge``; plane by plane, all motions of a node. Those
    of the brick ``alone``, so many motions, are the first.
    """

    def __init__(self, lattice: Lattice, n: int, E: float, nu: float) -> None:
        lame, mu = _lame(E, nu)
        along, across, self.wide = lattice.orders
        S, D, N = _over_face(lattice, n)  # of slopes, of a slope and a value, of values
        one = element(self.wide)
        M, C, K = (
            (f.T * one.weights) @ g
            for f, g in ((one.values, one.values), (one.slopes, one.values), (one.slopes,) * 2)
        )
        is_off = np.zeros((along + 1, across + 1), dtype=bool)
        is_off[1:-1, 1:] = True
        self.off, self.edge = (np.flatnonzero(each) for each in (is_off, ~is_off))
        planes = np.arange(self.wide + 1)
        kinds = (self.off, np.roll(planes, -1)), (self.edge, planes)
        sizes = [3 * nodes.size * planes.size for nodes, _ in kinds]
        cuts = slice(0, sizes[0]), slice(sizes[0], sum(sizes))
        self.parts = np.zeros((3, sum(sizes), sum(sizes)))
        self.alone = 3 * self.off.size * (self.wide - 1)

        def put(part: int, i: int, j: int, face: Floats, over: Floats) -> None:
            for (nodes, at), rows in zip(kinds, cuts, strict=True):
                for (others, there), columns in zip(kinds, cuts, strict=True):
                    shape = at.size, nodes.size, 3, there.size, others.size, 3
                    into = self.parts[part, rows, columns].reshape(shape)[:, :, i, :, :, j]
                    into += over[at][:, None, there, None] * face[nodes][:, None, others]

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

    def stiffness(self, half: float) -> Floats:
        """Return that of a brick by half its width [m]."""
        size = self.parts.shape[1]
        K = np.array([half, 1.0, 1.0 / half]) @ self.parts.reshape(3, -1)
        return np.asarray(K.reshape(size, size))


def _over_face(lattice: Lattice, n: int) -> tuple[Floats, Floats, Floats]:
    """Return what slopes, a slope and a value, and values are together over a brick's face.

    Their shapes are (2, 2, nodes, nodes), (2, nodes, nodes) and (nodes, nodes).
    """
    along, across, _ = lattice.orders
    one, other = element(along), element(across)
    values = np.kron(one.values, other.values)
    slopes = np.stack([np.kron(one.slopes, other.values), np.kron(one.values, other.slopes)])
    rows = lattice.planes_of(n)
    places = np.stack([lattice.x[rows].ravel(), lattice.y[rows].ravel()])
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
