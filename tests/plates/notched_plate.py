"""Notch hinge and the blocks beside it, bent in its plane as a plane body: finite elements.

A quarter of it in plane stress, E = 1 and width 1, by elements of degree 5 that follow the edge of
the notch. Behind the mouth stands a block, rigid at its end. Shares no code with the package.
"""

from itertools import pairwise, product

import numpy as np
from numpy.polynomial import legendre
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve

__all__ = [
    "assembled",
    "elliptic",
    "filleted",
    "peaks_over_nominal",
    "shift_over_beam",
    "solid_over_beam",
    "turn_beyond_beam",
]

DEGREE, ALONG, ACROSS = 5, 8, 2


def elliptic(*, e, depth, l):
    """Return the edge of half a notch as pieces s → (x, z), which run from throat to mouth."""

    def edge(s):
        return l / 2 * np.sin(np.pi / 2 * s), e / 2 + depth * (1 - np.cos(np.pi / 2 * s))

    return (edge,)


def filleted(*, h, r, l):
    """Return the edge of half a blade and of its quarter circle."""

    def straight(s):
        return (l / 2 - r) * s, h / 2 + 0 * s

    def arc(s):
        x, z = elliptic(e=h, depth=r, l=2 * r)[0](s)
        return l / 2 - r + x, z

    return straight, arc


def solid_over_beam(edges, *, block, rise=0.0, nu=0.3):
    """Return the moment per rotation of both ends over that of the beam between rigid blocks.

    ``block`` is the length of a block over the height of the mouth, ``rise`` by how much of that
    it is higher at its end, on either side. Also the peak at the throat over its nominal stress.
    """
    K, throat_stress, _ = _solid(edges, block, rise, nu)
    nominal = 6 * 2 * K / (2 * edges[0](0.0)[1]) ** 2
    return K * _flexible(edges), throat_stress / nominal


def turn_beyond_beam(edges, *, block, rise=0.0, nu=0.3):
    """Return the rotation of one end per moment beyond that of the beam."""
    beam, K = _flexible(edges) / 2, _solid(edges, block, rise, nu)[0]
    return 1 / (2 * K) - beam


def peaks_over_nominal(edges, *, block, rise=0.0):
    """Return the largest stress along the edge over that in the throat: in bending, stretched."""
    h = 2 * edges[0](0.0)[1]
    part = assembled(_columns(edges, block, rise), 0.3)
    bent, stretched = (_loaded(*part, stretch)[::2] for stretch in (False, True))
    return bent[1] / (6 * 2 * bent[0] / h**2), stretched[1] / (2 * stretched[0] / h)


def shift_over_beam(edges, *, block, rise=0.0):
    """Return the shift of the middle over that of the beam, both of second order in the rotation.

    An end that turns by 1 comes nearer by the work of an axial force of 1 on what the rotation
    strains to second order; rigid, it would turn about the throat.
    """
    part = assembled(_columns(edges, block, rise), 0.3)
    (x, bent, _), (_, pulled, force) = (_fields(*part, stretch) for stretch in (False, True))
    squares = sum(
        weight * stress @ [g[0] @ g[0] / 2, g[1] @ g[1] / 2, g[0] @ g[1]]
        for (weight, g, _), (_, _, stress) in zip(bent, pulled, strict=True)
    )
    solid = x + 2 * (-squares - force[1]) / force[0]
    # of the beam ∫(1 − φ²), φ the share of the rotation
    g, w = legendre.leggauss(200)
    whole, before, beam = _flexible(edges) / 2, 0.0, 0.0
    for edge in edges:
        s = (g + 1) / 2

        def curved(s, edge=edge):
            slope = (edge(s + 1e-6)[0] - edge(s - 1e-6)[0]) / 2e-6
            return slope, slope / edge(s)[1] ** 3 * 12 / 8

        slope, bent = curved(s)
        inner = [t / 2 * w @ curved(t * s)[1] for t in s]
        turned = (before + np.array(inner)) / whole
        beam += w / 2 @ (slope * (1 - turned**2))
        before += w / 2 @ bent
    return solid / beam


def _flexible(edges):
    """Return twice the rotation of half the beam per moment."""
    g, w = legendre.leggauss(200)
    flexible = 0.0
    for edge in edges:
        _, z = edge((g + 1) / 2)
        slope = (edge((g + 1) / 2 + 1e-6)[0] - edge((g + 1) / 2 - 1e-6)[0]) / 2e-6
        flexible += w @ (slope * 12 / (2 * z) ** 3)
    return flexible


def _columns(edges, block, rise):
    """Yield the columns of elements as s → (x on the axis, x and z on the edge), s in [0, 1]."""
    end, top = edges[-1](1.0)
    lean = 0.5 * min(2 * top * block, top - edges[0](0.0)[1])
    for index, edge in enumerate(edges):
        last = index == len(edges) - 1

        def column(s, edge=edge, lean=lean if last else 0.0):
            x, z = edge(s)
            return x + lean * s**2, x, z

        for a, b in pairwise(np.linspace(0, 1, ALONG + 1) ** (1.5 if last else 1)):
            yield column, a, b

    def body(s):
        length = 2 * top * block
        return end + lean + (length - lean) * s, end + length * s, top * (1 + 2 * rise * s)

    for a, b in pairwise(np.linspace(0, 1, ALONG // 2 + 1)):
        yield body, a, b


def assembled(columns, nu):
    """Return the places of all nodes, their numbers, elements, slopes, strain, elastic law and K.

    A column of elements stands from the axis to the edge: s → (x on the axis, x and z on the edge),
    and from which to which s.
    """
    p, columns = DEGREE, list(columns)
    inner = legendre.legroots(legendre.legder([0] * p + [1]))
    t = np.concatenate([[-1], inner, [1]])
    to_legendre = np.linalg.inv(legendre.legvander(t, p))

    def shape(at, order):
        each = [legendre.legval(at, legendre.legder(c, order)) for c in np.eye(p + 1)]
        return np.transpose(each) @ to_legendre

    g, w = legendre.leggauss(p + 2)
    steps = [(k + (t + 1) / 2) / ACROSS for k in range(ACROSS)]
    across = 1 - (1 - np.unique(np.round(np.concatenate(steps), 12))) ** 1.3
    X = np.zeros((len(columns) * p + 1, len(across)))
    Z = np.zeros_like(X)
    for i, (column, a, b) in enumerate(columns):
        axis, x, z = column(a + (b - a) * (t + 1) / 2)
        X[i * p : i * p + p + 1] = axis[:, None] + (x - axis)[:, None] * across
        Z[i * p : i * p + p + 1] = z[:, None] * across
    number = np.arange(X.size).reshape(X.shape)

    def blocks():
        for i, j in product(range(len(columns)), range(ACROSS)):
            yield slice(i * p, i * p + p + 1), slice(j * p, j * p + p + 1)

    def slopes(s, t):
        """Return the slopes along s and t of the functions of all nodes of an element, at s × t."""
        along, across = ([shape(at, order) for order in (0, 1)] for at in (s, t))
        return [
            np.einsum("ai,bj->abij", along[m], across[n]).reshape(len(s) * len(t), -1)
            for m, n in ((1, 0), (0, 1))
        ]

    def strain(ids, N):
        """Return the strains by the motions of an element's nodes, and the area, by its slopes."""
        x, z = X.ravel()[ids], Z.ravel()[ids]
        (x_s, x_t), (z_s, z_t) = ([n @ each for n in N] for each in (x, z))
        area = x_s * z_t - x_t * z_s
        assert (area > 0).all()
        d_x = (N[0] * z_t[:, None] - N[1] * z_s[:, None]) / area[:, None]
        d_z = (N[1] * x_s[:, None] - N[0] * x_t[:, None]) / area[:, None]
        zero = np.zeros_like(d_x)
        rows = [np.hstack(row) for row in ((d_x, zero), (zero, d_z), (d_z, d_x))]
        return np.stack(rows, axis=1), area

    elastic = np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]]) / (1 - nu**2)
    inside, rows, cols, entries = slopes(g, g), [], [], []
    for where in blocks():
        ids = number[where].ravel()
        B, area = strain(ids, inside)
        k = np.einsum(
            "q,qai,ab,qbj->ij", np.outer(w, w).ravel() * area, B, elastic, B, optimize=True
        )
        dof = np.concatenate([ids, ids + X.size])
        rows.append(np.repeat(dof, len(dof)))
        cols.append(np.tile(dof, len(dof)))
        entries.append(k.ravel())
    found = (np.concatenate(rows), np.concatenate(cols))
    K = coo_matrix((np.concatenate(entries), found), (2 * X.size, 2 * X.size)).tocsc()
    return X, Z, number, list(blocks()), (g, w), slopes, strain, elastic, K


def _moved(X, Z, number, K, stretch):
    """Return the motions of all nodes, the far end turned by −1 or pulled by 1."""
    # u is odd in x and in z; the far end turns by −1, or u is even in z and the end moves by 1
    u = np.zeros(2 * X.size)
    u[number[-1]] = 1.0 if stretch else -Z[-1]
    middle = number[:, 0] + (X.size if stretch else 0)
    held = np.concatenate([number[0], middle, number[-1], number[-1] + X.size])
    free = np.setdiff1d(np.arange(2 * X.size), held)
    u[free] = spsolve(K[free][:, free], -(K @ u)[free])
    return u


def _solid(edges, block, rise, nu):
    return _loaded(*assembled(_columns(edges, block, rise), nu), stretch=False)


def _loaded(X, Z, number, blocks, rule, slopes, strain, elastic, K, stretch):
    """Return the stiffness of a quarter, the stress of its throat and the peak along its edge."""
    u, p = _moved(X, Z, number, K, stretch), DEGREE
    peaks, edge = [], slopes(np.linspace(-1.0, 1.0, 25), np.array([1.0]))
    for i in range((len(X) - 1) // p):
        ids = number[i * p : i * p + p + 1, -p - 1 :].ravel()
        B, _ = strain(ids, edge)
        x, z, shear = (elastic @ B @ np.concatenate([u[ids], u[ids + X.size]])).T
        peaks.append(np.abs(x + z) / 2 + np.hypot((x - z) / 2, shear))
        if i == 0:
            throat = abs(x[0])
    return u @ (K @ u), throat, np.max(peaks)


def _fields(X, Z, number, blocks, rule, slopes, strain, elastic, K, stretch):
    """Return x of the end, weight, gradient and stress at points, and what an end's force is."""
    g, w = rule
    u, points, inside = _moved(X, Z, number, K, stretch), [], slopes(g, g)
    for where in blocks:
        ids = number[where].ravel()
        B, area = strain(ids, inside)
        n = ids.size
        # the rows of B are u_x, w_z and u_z + w_x
        d_x, d_z = B[:, 0, :n], B[:, 2, :n]
        first, second = u[ids], u[ids + X.size]
        gradient = np.stack(
            [np.stack([d @ first, d @ second], axis=1) for d in (d_x, d_z)], axis=1
        )  # points, by x or z, of u or w
        stress = (B @ np.concatenate([first, second])) @ elastic
        weight = np.outer(w, w).ravel() * area
        points += list(zip(weight, gradient, stress, strict=True))
    forces, end = K @ u, number[-1]
    # faces that turn as rigid ones move towards the middle by z/2
    return X[-1, 0], points, (forces[end].sum(), -(Z[-1] / 2) @ forces[end + X.size])
