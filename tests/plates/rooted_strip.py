"""Half a blade and the body that it is cut from, as one plane body: finite elements.

Plane stress, E = 1, width and thickness 1; rectangles of high order, graded towards the two sharp
corners at the root. The body is held at its back. Shares no code with the package.
"""

from functools import cache

import numpy as np
from plates.line_elements import line_element
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

__all__ = ["compliance", "root"]

DEGREE, LAYERS, RATIO = 4, 4, 0.25


@cache
def compliance(length, *, beyond=(20.0, 20.0), behind=20.0, nu=0.3):
    """Return motion (turn, shift across, along) of a blade's free end per moment and forces there.

    ``beyond`` is how far the body reaches beyond either face, ``behind`` how deep it is, both over
    the thickness. A blade between two such bodies is two of these: in pure bending, in an S, and
    stretched each end moves by half.
    """
    x_body = _graded(-behind, 0.0, right=True)
    x_blade = _graded(0.0, length, left=True)
    rows = [(-0.5, 0.5, True)]
    lower, upper = beyond
    if lower:
        rows.insert(0, (-0.5 - lower, -0.5, False))
    if upper:
        rows.append((0.5, 0.5 + upper, False))
    y, in_blade = [rows[0][0]], []
    for start, end, blade in rows:
        part = _graded(start, end, left=blade or start > 0.0, right=blade or end < 0.0)
        y += list(part[1:])
        in_blade += [blade] * (len(part) - 1)
    x = np.concatenate([x_body, x_blade[1:]])
    return _solved(x, np.array(y), np.array(in_blade), len(x_body) - 1, nu)


def root(*, beyond=(20.0, 20.0), behind=20.0, nu=0.3):
    """Return what the root alone gives way, per moment, force across and along at the root."""
    l, G = 4.0, 0.5 / (1.0 + nu)
    beam = np.array([[12 * l, -6 * l**2, 0], [-6 * l**2, 4 * l**3 + 1.2 * l / G, 0], [0, 0, l]])
    at_root = np.array([[1, l, 0], [0, 1, 0], [0, 0, 1]])  # force and moment at the end, of these
    return at_root.T @ (compliance(l, beyond=beyond, behind=behind, nu=nu) - beam) @ at_root


def _graded(start, end, *, left=False, right=False):
    layers = LAYERS + int(np.log(max(end - start, 1.0)) / np.log(1.0 / RATIO))
    steps = np.concatenate([[0.0], RATIO ** np.arange(layers, -1, -1.0)])
    if left and right:
        half = (end - start) / 2.0 * steps
        return np.concatenate([start + half, (end - half[::-1])[1:]])
    return start + (end - start) * steps if left else end - (end - start) * steps[::-1]


def _solved(x, y, in_blade, in_body, nu):
    p = DEGREE
    _, g, w, N, D = line_element(p)
    mass, stiff, mixed = N.T @ (w[:, None] * N), D.T @ (w[:, None] * D), D.T @ (w[:, None] * N)

    def plane(one, other):
        return np.einsum("ik,jl->ijkl", one, other).reshape((p + 1) ** 2, -1)

    E, G = 1.0 / (1.0 - nu**2), 0.5 / (1.0 + nu)
    columns, lines = len(x) - 1, len(y) - 1
    number = np.arange((columns * p + 1) * (lines * p + 1)).reshape(columns * p + 1, -1)
    size, used = number.size, np.zeros(number.size, bool)
    at, entries = [], []
    xy = plane(mixed, mixed.T)
    for i in range(columns):
        for j in range(lines):
            if i >= in_body and not in_blade[j]:
                continue
            a, b = (x[i + 1] - x[i]) / 2.0, (y[j + 1] - y[j]) / 2.0
            xx, yy = plane(stiff * b / a, mass), plane(mass * a / b, stiff)
            k = np.block(
                [
                    [E * xx + G * yy, nu * E * xy + G * xy.T],
                    [nu * E * xy.T + G * xy, E * yy + G * xx],
                ]
            )
            ids = number[i * p : i * p + p + 1, j * p : j * p + p + 1].ravel()
            used[ids] = True
            at.append(np.concatenate([ids, ids + size]))
            entries.append(k.ravel())
    rows = np.concatenate([np.repeat(dof, len(dof)) for dof in at])
    cols = np.concatenate([np.tile(dof, len(dof)) for dof in at])
    K = coo_matrix((np.concatenate(entries), (rows, cols)), (2 * size, 2 * size)).tocsc()
    F = np.zeros((2 * size, 3))
    for j in np.flatnonzero(in_blade):  # a beam's stresses, at which it is exact
        half = (y[j + 1] - y[j]) / 2.0
        z = y[j] + (g + 1.0) * half
        ids = number[-1, j * p : j * p + p + 1]
        F[ids, 0] += N.T @ (w * half * 12.0 * z)
        F[ids + size, 1] += N.T @ (w * half * 1.5 * (1.0 - 4.0 * z**2))
        F[ids, 2] += N.T @ (w * half)
    used[number[0]] = False  # held at its back
    free = np.flatnonzero(np.concatenate([used, used]))
    return F[free].T @ splu(K[free][:, free]).solve(F[free])
