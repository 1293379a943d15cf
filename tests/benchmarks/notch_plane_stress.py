"""Right-circular notch hinge in pure bending by plane-stress finite elements, beside the formulas.

Run by hand: python tests/benchmarks/notch_plane_stress.py
Prints the stress concentration and the stiffness over that of the beam integral, for two meshes.
"""

from typing import NamedTuple

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.linalg import spsolve

from flexcli.formulas.notch import (
    bending_factor,
    circular_stiffness,
    fitted_bending_factor,
    law_stiffness,
)

NU = 0.3
BLOCK = 3.0
"""Length of the body beside the notch, over half its height; its own bending is taken off."""
ORDER = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1), (1, 1))
"""Nodes of a nine-node element: corners, sides, middle."""
STRESS = np.array([[1, NU, 0], [NU, 1, 0], [0, 0, (1 - NU) / 2]]) / (1 - NU**2)


class Mesh(NamedTuple):
    points: np.ndarray
    grid: np.ndarray
    elements: np.ndarray


def quarter(ratio, columns):
    """Mesh the quarter x, y > 0 of a hinge of radius 1 and throat e = ratio, notch and body."""
    width = np.sqrt(ratio / (ratio + 4))
    t = width * np.sinh(np.arcsinh(1 / width) * np.linspace(0, 1, 2 * columns + 1))
    half = 1 + ratio / 2
    along = 1 + BLOCK * half * np.linspace(0, 1, columns + 1)[1:] ** 1.3
    x = np.concatenate([2 * t / (1 + t**2), along])
    top = np.concatenate([ratio / 2 + 2 * t**2 / (1 + t**2), np.full(columns, half)])
    rows = columns // 3
    eta = np.linspace(0, 1, 2 * rows + 1)
    points = np.stack([x[:, None] + 0 * eta, top[:, None] * eta], axis=-1).reshape(-1, 2)
    grid = np.arange(len(points)).reshape(x.size, eta.size)
    corners = [(i, j) for i in range(0, x.size - 2, 2) for j in range(0, eta.size - 2, 2)]
    elements = np.array([[grid[i + a, j + b] for a, b in ORDER] for i, j in corners])
    return Mesh(points, grid, elements)


def strains(mesh, z, y):
    """Return the strain rows of all elements at (z, y) of [−1, 1]² and the area factor."""

    def line(u):
        value = (u * (u - 1) / 2, 1 - u * u, u * (u + 1) / 2)
        return np.array(value), np.array([u - 0.5, -2 * u, u + 0.5])

    (n_z, d_z), (n_y, d_y) = line(z), line(y)
    slopes = np.array([[d_z[a] * n_y[b] for a, b in ORDER], [n_z[a] * d_y[b] for a, b in ORDER]])
    jacobian = np.einsum("ak,ekc->eac", slopes, mesh.points[mesh.elements])
    local = np.linalg.inv(jacobian) @ slopes
    rows = np.zeros((len(mesh.elements), 3, 18))
    rows[:, 0, 0::2] = rows[:, 2, 1::2] = local[:, 0]
    rows[:, 1, 1::2] = rows[:, 2, 0::2] = local[:, 1]
    return rows, np.linalg.det(jacobian)


def bent(ratio, columns):
    """Return stress concentration and rotational stiffness of the hinge, E = b = r = 1."""
    mesh = quarter(ratio, columns)
    nodes, weights = np.polynomial.legendre.leggauss(3)
    element = 0.0
    for z, w_z in zip(nodes, weights, strict=True):
        for y, w_y in zip(nodes, weights, strict=True):
            B, area = strains(mesh, z, y)
            element = element + np.einsum("eia,ij,ejb,e->eab", B, STRESS, B, area * w_z * w_y)
    freedom = np.stack([2 * mesh.elements, 2 * mesh.elements + 1], -1).reshape(-1, 18)
    place = (np.repeat(freedom, 18, 1).ravel(), np.tile(freedom, (1, 18)).ravel())
    size = 2 * len(mesh.points)
    K = coo_array((element.ravel(), place), shape=(size, size)).tocsr()
    # the middle plane and the plane of symmetry do not move along x; the far face turns by one
    far = mesh.grid[-1]
    u, held = np.zeros(size), np.zeros(size, bool)
    held[2 * mesh.grid[:, 0]] = held[2 * mesh.grid[0]] = held[2 * far] = True
    held[2 * mesh.grid[0, 0] + 1] = True
    u[2 * far] = mesh.points[far, 1]
    free = ~held
    u[free] = spsolve(K[free][:, free].tocsc(), -K[free][:, held] @ u[held])
    moment = 2 * (K @ u)[2 * far] @ mesh.points[far, 1]
    half = 1 + ratio / 2
    body = 12 * moment * BLOCK * half / (2 * half) ** 3
    throat = np.flatnonzero(mesh.elements[:, 3] == mesh.grid[0, -1])[0]
    rows, _ = strains(mesh, -1.0, 1.0)
    stress = (STRESS @ rows[throat] @ u[freedom[throat]])[0]
    return stress / (6 * moment / ratio**2), moment / (2 * (1 - body))


def main():
    print("  e/r  columns   K_t: elements  Neuber  fitted   K: elements/integral  elements/law")
    for ratio in (0.025, 0.1, 0.2, 0.5, 1.0):
        hinge = {"E": 1.0, "b": 1.0, "e": ratio, "r": 1.0}
        for columns in (36, 72):
            factor, stiffness = bent(ratio, columns)
            known = [f(e=ratio, r=1.0) for f in (bending_factor, fitted_bending_factor)]
            shares = [stiffness / f(**hinge) for f in (circular_stiffness, law_stiffness)]
            print(
                f"{ratio:5}  {columns:7}  {factor:14.4f}  {known[0]:.4f}  {known[1]:.4f}"
                f"  {shares[0]:20.4f}  {shares[1]:12.4f}"
            )


if __name__ == "__main__":
    main()
