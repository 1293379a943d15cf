"""Stretching and bending of a thin shell that was flat: Kirchhoff's and Love's, Saint-Venant's law.

A point of the middle surface is at x; g are its derivatives along (1) and across (2),
x_1, x_2, x_11, x_22, x_12. The energy per area is

    ½ S (E_11² + E_22² + 2 ν E_11 E_22 + 2 (1 − ν) E_12²) + ½ D (the same of κ),
    E_ab = (x_a · x_b − δ_ab)/2,  κ_ab = n · x_ab,  n = x_1 × x_2/|x_1 × x_2|,

exact for any rotation; strains are small. E_11 is less what a temperature frees.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.exact.rotation import cross, skew

__all__ = ["Density", "Strains", "density", "strains"]

Floats = NDArray[np.float64]


class Strains(NamedTuple):
    """E_11, E_22, 2 E_12 and κ_11, κ_22, 2 κ_12 (..., 3), the normal n and |x_1 × x_2|."""

    stretch: Floats
    bend: Floats
    normal: Floats
    area: Floats


class Density(NamedTuple):
    """Slope (..., 15) and Hessian (..., 15, 15) of the energy per area by g."""

    slope: Floats
    hessian: Floats


def strains(g: Floats, grown: Floats) -> Strains:
    """Return the strains of derivatives g (blades, ..., 5, 3), E_11 less what is free (blades,)."""
    free = grown.reshape(-1, *(1,) * (g.ndim - 3))
    x_1, x_2 = g[..., 0, :], g[..., 1, :]
    across = cross(x_1, x_2)
    area = np.sqrt(np.sum(across**2, axis=-1, keepdims=True))
    normal = across / area
    stretch = np.stack(
        [
            (np.sum(x_1**2, axis=-1) - 1.0) / 2.0 - free,
            (np.sum(x_2**2, axis=-1) - 1.0) / 2.0,
            np.sum(x_1 * x_2, axis=-1),
        ],
        axis=-1,
    )
    bend = (g[..., 2:, :] @ normal[..., None])[..., 0] * _TWICE
    return Strains(stretch, bend, normal, area)


_TWICE = np.array([1.0, 1.0, 2.0])


def density(g: Floats, grown: Floats, stretching: Floats, bending: Floats, law: Floats) -> Density:
    """Return the derivatives of the energy per area.

    Parameters
    ----------
    g : array, shape (blades, points, 5, 3)
        Derivatives of the position by lengths.
    grown : array, shape (blades,)
        E_11 that is free, of each.
    stretching, bending : array, shape (blades, points)
        S and D, times what an area counts for in the sum over points.
    law : array, shape (blades, 3, 3)
        Stress over strain, in S and D: [[1, ν, 0], [ν, 1, 0], [0, 0, (1 − ν)/2]].

    """
    found = strains(g, grown)
    n, area = found.normal, found.area
    x_1, x_2, seconds = g[..., 0, :], g[..., 1, :], g[..., 2:, :]
    force = stretching[..., None] * (found.stretch @ law)
    moment = bending[..., None] * (found.bend @ law)
    # n · y by n's own change: v · (δx_1 × x_2 + x_1 × δx_2)
    v = (seconds * _TWICE[:, None] - found.bend[..., None] * n[..., None, :]) / area[..., None]
    rows = np.zeros((*g.shape[:-2], 6, 5, 3))
    rows[..., 0, 0, :] = rows[..., 2, 1, :] = x_1
    rows[..., 1, 1, :] = rows[..., 2, 0, :] = x_2
    rows[..., 3:, 0, :] = cross(x_2[..., None, :], v)
    rows[..., 3:, 1, :] = cross(v, x_1[..., None, :])
    for k in range(3):
        rows[..., 3 + k, 2 + k, :] = _TWICE[k] * n
    flat = rows.reshape(*g.shape[:-2], 6, 15)
    stress = np.concatenate([force, moment], axis=-1)
    felt = np.empty_like(flat)
    felt[..., :3, :] = stretching[..., None, None] * (law[:, None] @ flat[..., :3, :])
    felt[..., 3:, :] = bending[..., None, None] * (law[:, None] @ flat[..., 3:, :])
    H = (np.swapaxes(flat, -1, -2) @ felt).reshape(*g.shape[:-2], 5, 3, 5, 3)
    # what the strains curve by: x_a · x_b, then n · y
    one = np.eye(3)
    for (a, b), f in zip(((0, 0), (1, 1), (0, 1)), np.moveaxis(force, -1, 0), strict=True):
        H[..., a, :, b, :] += f[..., None, None] * one
    Pv = (moment[..., None, :] @ v)[..., 0, :]
    level = np.sum(moment * found.bend, axis=-1)[..., None, None] / area[..., None] ** 2
    flat_part = one - n[..., :, None] * n[..., None, :]
    mixed = n[..., :, None] * (Pv / area)[..., None, :]
    G = -(mixed + np.swapaxes(mixed, -1, -2) + level * flat_part)
    turn = (-skew(x_2), skew(x_1))
    back = [np.swapaxes(A, -1, -2) for A in turn]
    for a, b in ((0, 0), (0, 1), (1, 1)):
        H[..., a, :, b, :] += back[a] @ G @ turn[b]
    H[..., 0, :, 1, :] -= skew(Pv)
    for a in range(2):
        way = back[a] @ (flat_part / area[..., None])
        for k in range(3):
            H[..., a, :, 2 + k, :] += (_TWICE[k] * moment[..., k])[..., None, None] * way
            H[..., 2 + k, :, a, :] = np.swapaxes(H[..., a, :, 2 + k, :], -1, -2)
    H[..., 1, :, 0, :] = np.swapaxes(H[..., 0, :, 1, :], -1, -2)
    slope = (stress[..., None, :] @ flat)[..., 0, :]
    return Density(slope, H.reshape(*g.shape[:-2], 15, 15))
