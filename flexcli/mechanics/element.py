"""A blade between two bodies: the closing of its ends and its forces on the bodies, linearised.

The unknowns of an element are its force ν in global axes and its end moment m (both scaled by the
blade), and the motions (x, y, φ) of its two bodies. Their potential is

    ν·(r_j − r_i) + m (φ_j − φ_i) − H(Rᵀν, m),

with R the rotation of body i and of the blade's direction, and H the complementary energy of the
blade, whose derivatives are the end motion and the flexibility F of :mod:`flexcli.mechanics.beam`.
Its gradient is the closing (3 rows) and the forces that the blade needs at the bodies (6 rows); its
second derivative is the symmetric element matrix.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.beam import Condensed

__all__ = ["Attachment", "element", "turned"]

Floats = NDArray[np.float64]


class Attachment(NamedTuple):
    """Where blades sit (designs or 1, blades, ...): lengths in those of the blade, at rest.

    ``start`` and ``end`` are the ends from the reference points of their bodies (2), ``along``
    the direction (2), ``scale`` the unit of the bodies' positions over the length of the blade.
    """

    start: Floats
    end: Floats
    along: Floats
    scale: Floats


def turned(vector: Floats, phi: Floats) -> tuple[Floats, Floats]:
    """Return the vector turned by φ, and how far that moved it (in full relative precision)."""
    versine, sin = 2.0 * np.sin(phi / 2.0) ** 2, np.sin(phi)
    x, y = vector[..., 0], vector[..., 1]
    moved = np.stack([-versine * x - sin * y, sin * x - versine * y], axis=-1)
    return vector + moved, moved


def element(
    at: Attachment, blade: Condensed, force: Floats, pose_i: Floats, pose_j: Floats
) -> tuple[Floats, Floats]:
    """Return gradient (designs, blades, 9) and second derivative (designs, blades, 9, 9).

    Parameters
    ----------
    at : Attachment
        Geometry at rest.
    blade : Condensed
        The blades about their present forces.
    force : array, shape (designs, blades, 3)
        ν and m.
    pose_i, pose_j : array, shape (designs, blades, 3)
        Motions of the bodies at start and end, positions in their unit.

    Returns
    -------
    gradient, matrix : array
        Order: ν_x, ν_y, m, then x, y, φ of the start's body, then of the end's.

    """
    nu, m = force[..., :2], force[..., 2]
    phi_i, phi_j = pose_i[..., 2], pose_j[..., 2]
    along, along_moved = turned(at.along, phi_i)
    a_i, a_i_moved = turned(at.start, phi_i)
    a_j, a_j_moved = turned(at.end, phi_j)
    R = np.empty((*nu.shape, 2))
    R[..., :, 0] = along
    R[..., 0, 1], R[..., 1, 1] = -along[..., 1], along[..., 0]
    bent = np.sum(R * blade.motion[..., None, :2], axis=-1)
    reach = along + bent
    lever = a_i + reach
    # flexibility in global axes
    F = np.empty_like(blade.F)
    half = R @ blade.F[..., :2, :]
    F[..., :2, :2] = half[..., :2] @ np.swapaxes(R, -1, -2)
    F[..., :2, 2] = half[..., 2]
    F[..., 2, :2] = half[..., 2]
    F[..., 2, 2] = blade.F[..., 2, 2]
    p = np.stack([nu[..., 1], -nu[..., 0]], axis=-1)
    give = np.sum(F[..., :2] * p[..., None, :], axis=-1)
    gradient = np.empty((*m.shape, 9))
    apart = at.scale[..., None] * (pose_j[..., :2] - pose_i[..., :2])
    gradient[..., :2] = apart + a_j_moved - a_i_moved - along_moved - bent
    gradient[..., 2] = phi_j - phi_i - blade.motion[..., 2]
    pull = at.scale[..., None] * nu
    gradient[..., 3:5] = -pull
    gradient[..., 5] = -m - _cross(lever, nu)
    gradient[..., 6:8] = pull
    gradient[..., 8] = m + _cross(a_j, nu)
    H = np.zeros((*m.shape, 9, 9))
    H[..., :3, :3] = -F
    for i in (0, 1):
        H[..., i, 3 + i] = -at.scale
        H[..., i, 6 + i] = at.scale
    H[..., 0, 5] = lever[..., 1] - give[..., 0]
    H[..., 1, 5] = -lever[..., 0] - give[..., 1]
    H[..., 2, 5] = -1.0 - give[..., 2]
    H[..., 0, 8] = -a_j[..., 1]
    H[..., 1, 8] = a_j[..., 0]
    H[..., 2, 8] = 1.0
    H[..., 3:, :3] = np.swapaxes(H[..., :3, 3:], -1, -2)
    H[..., 5, 5] = np.sum(lever * nu, axis=-1) - np.sum(give[..., :2] * p, axis=-1)
    H[..., 8, 8] = -np.sum(a_j * nu, axis=-1)
    return gradient, H


def _cross(a: Floats, b: Floats) -> Floats:
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])
