"""One octant of a body with three planes of symmetry, in bricks of high order.

The body is a plane region drawn out along z, so that what is integrated over a brick is a product
of its face and its width. Layers of bricks, one after the other along x, are solved by blocks.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_factor, cho_solve

from flexcli.errors import SolveError
from flexcli.mechanics.solids.lagrange import element

__all__ = ["LOADS", "Lattice", "Load", "Moved", "moved"]

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]


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


def moved(lattice: Lattice, load: Load, E: float, nu: float) -> Moved:
    """Return what a unit load does to the body between rigid ends.

    The ends move by one, rigidly, each its way. What is sought is the rest of the motion: none at
    the end, and in the middle what symmetry holds against that.

    Parameters
    ----------
    lattice : Lattice
        The octant.
    load : Load
        One of six.
    E, nu : float
        Young's modulus [Pa] and Poisson's ratio below ½ [-].

    Raises
    ------
    SolveError
        Where the body is so slender that no digits are left.

    """
    try:
        return _moved(lattice, load, E, nu)
    except np.linalg.LinAlgError as error:
        hint = "leave a body as slender as that to beams"
        raise SolveError("too-slender", "a solid has too few digits", hint) from error


def _moved(lattice: Lattice, load: Load, E: float, nu: float) -> Moved:
    stiffness, free = _Layers(lattice, E, nu), _free(lattice, load)
    per_layer, plane = lattice.orders[0], 3 * lattice.x.shape[1] * lattice.z.size
    count = (lattice.x.shape[0] - 1) // per_layer
    # from the rigid end to the middle, so that a soft throat keeps its digits
    beyond, kept = np.zeros((plane, plane)), list[tuple[Flags, Floats]]()
    for n in range(count - 1, -1, -1):
        K = stiffness.of_layer(n)
        K[-plane:, -plane:] += beyond
        here = free[n * per_layer + 1 : (n + 1) * per_layer + 1].ravel()
        own, near = np.flatnonzero(here) + plane, slice(0, plane)
        factor = cho_factor(K[np.ix_(own, own)], lower=True, overwrite_a=True, check_finite=False)
        follows = cho_solve(factor, K[own, near], check_finite=False)
        beyond = K[near, near] - K[near, own] @ follows
        kept.append((here, follows))
    w = np.zeros((*lattice.shape, 3))
    middle, work = _middle(lattice, load, beyond, free[0])
    w[0] = middle.reshape(w[0].shape)
    for n in range(count):
        here, follows = kept.pop()
        after = np.zeros(here.size)
        after[here] = -follows @ middle
        w[n * per_layer + 1 : (n + 1) * per_layer + 1] = after.reshape(-1, *w.shape[1:])
        middle = after[-plane:]
    # eight octants, whose ends move by one each way
    return Moved(1.0 / (2.0 * work), _stress(lattice, w / (4.0 * work), E, nu))


def _middle(lattice: Lattice, load: Load, K: Floats, free: Flags) -> tuple[Floats, float]:
    """Return how the plane x = 0 moves against an end that moves by one, and the work of that.

    ``K`` is the stiffness of that plane where the end is held, ``free`` (across, width, 3) what y
    and z = 0 leave free.
    """
    y, z = np.broadcast_arrays(lattice.y[0][:, None], lattice.z)
    at = np.stack([y, z, np.ones_like(y)], axis=-1)
    back = -at @ np.array(load.motion, dtype=np.float64).T
    along = np.arange(3) == 0
    led = along if load.signs[0] == 1 else ~along
    given = np.flatnonzero(free & led)
    left = np.flatnonzero(free & ~led)
    w = np.zeros(K.shape[0])
    w[given] = back.ravel()[given]
    factor = cho_factor(K[np.ix_(left, left)], check_finite=False)
    w[left] = -cho_solve(factor, K[np.ix_(left, given)] @ w[given], check_finite=False)
    return w, float(w[given] @ K[given] @ w)


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
    rows = slice(n * along, (n + 1) * along + 1)
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
