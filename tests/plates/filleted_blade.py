"""Blade with quarter-circle fillets on walls or on bodies, as one plane body: finite elements.

Plane stress, E = 1, width and thickness 1; quadrilaterals of high order that follow the fillets.
Half of the blade's thickness, and half of its length, which end in symmetry. The body is held at
its back. Shares no code with the package.
"""

from functools import cache
from itertools import pairwise

import numpy as np
from numpy.polynomial import legendre
from plates.line_elements import line_element
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

__all__ = ["beam_compliances", "beyond_beam", "edge_stresses", "over_beam"]

DEGREE, FINE = 5, 8
"""Of stiffnesses, and where stresses are evaluated."""

_gauss = cache(legendre.leggauss)

ORDER = "MMD_AT_PLUS_A"
"""Of unknowns, by which a symmetric matrix fills least."""

FREE = 0.97
"""Share of a fillet on which the stress at its edge is evaluated: where it ends it has a corner."""


def over_beam(r, straight, *, body=None, nu=0.3):
    """Return the stiffness of a blade over that of its profile's beam: as an arc, an S, pulled.

    ``straight`` is the length between the fillets of radius ``r``; ``body`` how far the body
    reaches beyond the fillets and behind its face, all over the thickness, or nothing if rigid.
    """
    return np.array(_stiffness(r, straight / 2.0, body, nu)) * beam_compliances(r, straight, nu=nu)


def beyond_beam(r, straight, *, body=None, nu=0.3):
    """Return the rotation, travel and elongation per moment and forces beyond those of the beam."""
    return 1.0 / np.array(_stiffness(r, straight / 2.0, body, nu)) - beam_compliances(
        r, straight, nu=nu
    )


def beam_compliances(r, straight, *, nu=0.3):
    """Return the compliances of the beam of the profile: its rotation, travel and elongation."""
    half = straight / 2.0
    g, w = _gauss(400)
    phi = np.pi / 4.0 * (g + 1.0)
    places, weights = r * np.sin(phi), w * np.pi / 4.0 * r * np.cos(phi)
    h = 1.0 + 2.0 * r * (1.0 - np.cos(phi))
    shear, lever = 2.4 * (1.0 + nu), half + places
    return np.array(
        [
            2.0 * (12.0 * half + weights @ (12.0 / h**3)),
            2.0 * (4.0 * half**3 + shear * half + weights @ (12.0 * lever**2 / h**3 + shear / h)),
            2.0 * (half + weights @ (1.0 / h)),
        ]
    )


def edge_stresses(r, straight, *, body=None, nu=0.3):
    """Return places along the free edge and the stress there, bent to an arc and to an S.

    Places are from where the fillet begins, into it; stresses over 6M/(b h²) of the moment there.
    """
    half = straight / 2.0
    maps = _maps(r, half, body)
    places, number, K = _assembled(maps, nu, FINE)
    moved = list(_moved(places, K, half))
    nodes, *_ = line_element(FINE)
    at = np.linspace(-1.0, 1.0, 41)
    back = np.linalg.inv(legendre.legvander(nodes, FINE))

    def shape(where, order):
        each = [legendre.legval(where, legendre.legder(c, order)) for c in np.eye(FINE + 1)]
        return np.transpose(each) @ back

    top = np.ones(1)
    along, up = (
        np.einsum("ai,bj->abij", *pair).reshape(len(at), -1)
        for pair in ((shape(at, 1), shape(top, 0)), (shape(at, 0), shape(top, 1)))
    )
    s, stress = [], []
    for ids in number:
        x, y = places[ids].T
        ends = places[ids.reshape(FINE + 1, -1)[:, -1]]
        into = np.clip(-ends[:, 0], 0.0, r)
        edge = 0.5 + r - np.sqrt(r**2 - into**2)
        if ends[:, 0].min() < -r - 1e-9 or not np.allclose(ends[:, 1], edge, atol=1e-6):
            continue
        here = shape(at, 0) @ ends[:, 0]
        free = here > -FREE * r
        (x_s, y_s), (x_t, y_t) = ((d[free] @ x, d[free] @ y) for d in (along, up))
        area = x_s * y_t - x_t * y_s
        d_x = (along[free] * y_t[:, None] - up[free] * y_s[:, None]) / area[:, None]
        d_y = (up[free] * x_s[:, None] - along[free] * x_t[:, None]) / area[:, None]
        s.append(-here[free])
        stress.append([(d_x @ u[ids] + d_y @ u[ids + len(places)]) / (1.0 - nu) for u, _ in moved])
    # the two stresses beside a free edge add up to the one along it; moments are 1 and ½ straight
    (_, turned), (_, sheared), _ = moved
    per = np.array([1.0 / (6.0 * turned), 1.0 / (6.0 * sheared * half)])
    order = np.argsort(np.concatenate(s))
    return (
        np.concatenate(s)[order],
        np.abs(np.concatenate(stress, axis=1)[:2, order]) * per[:, None],
    )


@cache
def _stiffness(r, half, body, nu):
    places, _, K = _assembled(_maps(r, half, body), nu)
    return tuple(stiffness for _, stiffness in _moved(places, K, half))


def _moved(places, K, half):
    """Yield the motions of a quarter, the ends moved by 1 against each other, and its stiffness."""
    n, (x, y) = len(places), places.T
    back, middle = (np.flatnonzero(np.abs(x - at) < 1e-9) for at in (x.min(), half))
    axis = np.flatnonzero(np.abs(y) < 1e-9)
    for on_axis, moved, by in (
        (axis, middle, -0.5 * y[middle]),
        (axis, middle + n, 0.5),
        (axis + n, middle, 0.5),
    ):
        u = np.zeros(2 * n)
        u[moved] = by
        held = np.concatenate([back, back + n, on_axis, moved])
        free = np.setdiff1d(np.arange(2 * n), held)
        u[free] = splu(K[free][:, free], ORDER).solve(-(K @ u)[free])
        yield u, 4.0 * u @ (K @ u)  # of four quarters


def _maps(r, half, body):
    """Return the maps of the quadrilaterals, (s, t) in [0, 1]² → places; fillets begin at x = 0."""
    small, t = min(r, 0.5), 0.5
    across = np.sort(1.0 - _graded(1.0, min(1.0, 0.6 * r / t), 2.2))
    angles = [0.0]
    step = min(0.35, 0.7 * np.sqrt(t / r))
    while angles[-1] < 1.15:
        angles.append(min(angles[-1] + step, 1.15))
        step = min(1.3 * step, 0.4)
    angles.append(np.pi / 2.0)
    found = []

    def columns(bottom, top):
        for low, high in pairwise(across):

            def place(s, e, low=low, high=high):
                share = low + (high - low) * e
                return tuple(
                    a * (1 - share) + b * share for a, b in zip(bottom(s), top(s), strict=True)
                )

            found.append(place)

    for a, b in pairwise(_graded(half, 0.4 * small, 2.5)):
        columns(lambda s, a=a, b=b: (a + (b - a) * s, 0.0 * s),
                lambda s, a=a, b=b: (a + (b - a) * s, t + 0.0 * s))  # fmt: skip
    for b, a in pairwise(angles):
        columns(
            lambda s, a=a, b=b: (-r * (np.sin(a) + (np.sin(b) - np.sin(a)) * s), 0.0 * s),
            lambda s, a=a, b=b: (
                -r * np.sin(a + (b - a) * s),
                t + r * (1.0 - np.cos(a + (b - a) * s)),
            ),
        )
    if body is None:
        return found
    beyond, behind = body
    deep, high = (_graded(size, min(0.35 * small, size), 2.5) for size in (behind, beyond))
    for b, a in pairwise(deep):
        columns(lambda s, a=a, b=b: (-r - a + (a - b) * s, 0.0 * s),
                lambda s, a=a, b=b: (-r - a + (a - b) * s, t + r + 0.0 * s))  # fmt: skip
        for c, d in pairwise(high):
            found.append(
                lambda s, e, a=a, b=b, c=c, d=d: (
                    -r - a + (a - b) * s + 0.0 * e,
                    t + r + c + (d - c) * e + 0.0 * s,
                )
            )
    return found


def _graded(length, first, ratio):
    """Return places from 0 to a length, the first step given and each larger than the last."""
    steps = [min(first, length)]
    while sum(steps) < length * (1.0 - 1e-9):
        steps.append(ratio * steps[-1])
    places = np.concatenate([[0.0], np.cumsum(steps)])
    return length / places[-1] * places


def _assembled(maps, nu, p=DEGREE):
    nodes, _, w, N, D = line_element(p)
    along, up = (
        np.einsum("ai,bj->abij", *pair).reshape((p + 2) ** 2, -1) for pair in ((D, N), (N, D))
    )
    s, t = ((each + 1.0) / 2.0 for each in np.meshgrid(nodes, nodes, indexing="ij"))
    each = np.stack(
        [np.stack(np.broadcast_arrays(*place(s, t)), -1).reshape(-1, 2) for place in maps]
    )
    _, first, number = np.unique(
        np.round(each.reshape(-1, 2), 8) + 0.0, axis=0, return_index=True, return_inverse=True
    )
    places, number = each.reshape(-1, 2)[first], number.reshape(len(maps), -1)
    n, (E, G) = len(places), (1.0 / (1.0 - nu**2), 0.5 / (1.0 + nu))
    dofs, entries = [], []
    for ids, (x, y) in zip(number, each.transpose(0, 2, 1), strict=True):
        (x_s, y_s), (x_t, y_t) = ((d @ x, d @ y) for d in (along, up))
        area = x_s * y_t - x_t * y_s
        assert (area > 0.0).all()
        d_x = (along * y_t[:, None] - up * y_s[:, None]) / area[:, None]
        d_y = (up * x_s[:, None] - along * x_t[:, None]) / area[:, None]
        weight = (np.outer(w, w).ravel() * area)[:, None]
        xx, yy, xy = d_x.T @ (weight * d_x), d_y.T @ (weight * d_y), d_x.T @ (weight * d_y)
        k = [[E * xx + G * yy, nu * E * xy + G * xy.T], [nu * E * xy.T + G * xy, E * yy + G * xx]]
        dofs.append(np.concatenate([ids, ids + n]))
        entries.append(np.block(k).ravel())
    rows = np.concatenate([np.repeat(dof, len(dof)) for dof in dofs])
    cols = np.concatenate([np.tile(dof, len(dof)) for dof in dofs])
    K = coo_matrix((np.concatenate(entries), (rows, cols)), (2 * n, 2 * n)).tocsc()
    return places, number, K
