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
from flexcli.mechanics.mesh import pick

__all__ = ["Attachment", "element", "turned", "turning"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]


class Attachment(NamedTuple):
    """Where blades sit (designs or 1, blades): lengths in those of the blade, at rest.

    ``start`` and ``end`` are the ends x + iy from the reference points of their bodies, ``along``
    the direction, ``scale`` the unit of the bodies' positions over the length of the blade.
    ``reach`` is the length of the blade over that at assembly, ``misfit`` how far bodies and blade,
    grown by a temperature, do not meet at its end.
    """

    start: Complexes
    end: Complexes
    along: Complexes
    scale: Floats
    reach: Floats
    misfit: Complexes

    def of(self, rows: NDArray[np.intp]) -> "Attachment":
        """Return those of the designs ``rows``."""
        return Attachment(
            pick(self.start, rows),
            pick(self.end, rows),
            pick(self.along, rows),
            pick(self.scale, rows),
            pick(self.reach, rows),
            pick(self.misfit, rows),
        )


def turning(phi: Floats) -> Complexes:
    """Return ``exp(iφ) − 1`` in full relative precision: how far a unit vector moves by turning."""
    return np.asarray(-2.0 * np.sin(phi / 2.0) ** 2 + 1j * np.sin(phi))


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
    nu, m = _complex(force), force[..., 2]
    turn_i, turn_j = turning(pose_i[..., 2]), turning(pose_j[..., 2])
    along_moved, a_j_moved = at.along * turn_i, at.end * turn_j
    along = at.along + along_moved
    bent = along * _complex(blade.motion)
    lever = at.start * (1.0 + turn_i) + at.reach * along + bent
    a_j = at.end + a_j_moved
    # flexibility in global axes
    T = np.zeros(blade.F.shape)
    T[..., 0, 0] = T[..., 1, 1] = along.real
    T[..., 1, 0], T[..., 0, 1] = along.imag, -along.imag
    T[..., 2, 2] = 1.0
    F = T @ blade.F @ np.swapaxes(T, -1, -2)
    # a turn of the start turns the force in its frame by −iν
    p = np.zeros(force.shape)
    p[..., 0], p[..., 1] = nu.imag, -nu.real
    deflection = (F @ p[..., None])[..., 0]
    pull, moment = at.scale * nu, np.conj(lever) * nu
    far = np.conj(a_j) * nu
    gap = at.scale * (_complex(pose_j) - _complex(pose_i)) + at.misfit + a_j_moved - bent
    gap -= at.start * turn_i + at.reach * along_moved
    gradient = np.empty((*m.shape, 9))
    gradient[..., 0], gradient[..., 1] = gap.real, gap.imag
    gradient[..., 2] = pose_j[..., 2] - pose_i[..., 2] - blade.motion[..., 2]
    gradient[..., 6], gradient[..., 7] = pull.real, pull.imag
    gradient[..., 3:5] = -gradient[..., 6:8]
    gradient[..., 5] = -m - moment.imag
    gradient[..., 8] = m + far.imag
    H = np.zeros((*m.shape, 9, 9))
    H[..., :3, :3] = -F
    H[..., 0, 6] = H[..., 1, 7] = at.scale
    H[..., 0, 3] = H[..., 1, 4] = -at.scale
    H[..., :3, 5] = -deflection
    H[..., 0, 5] += lever.imag
    H[..., 1, 5] -= lever.real
    H[..., 2, 5] -= 1.0
    H[..., 0, 8], H[..., 1, 8], H[..., 2, 8] = -a_j.imag, a_j.real, 1.0
    H[..., 3:, :3] = np.swapaxes(H[..., :3, 3:], -1, -2)
    H[..., 5, 5] = moment.real - np.sum(deflection * p, axis=-1)
    H[..., 8, 8] = -far.real
    return gradient, H


def _complex(vector: Floats) -> Complexes:
    return np.asarray(vector[..., 0] + 1j * vector[..., 1])
