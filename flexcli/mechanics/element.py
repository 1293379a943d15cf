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
from flexcli.mechanics.mesh import across

__all__ = ["Attachment", "Element", "element", "turned", "turning"]

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

    def across(self, rows: NDArray[np.intp]) -> "Attachment":
        """Return those of the designs ``rows``, (blades, designs or 1)."""
        return Attachment(
            across(self.start, rows),
            across(self.end, rows),
            across(self.along, rows),
            across(self.scale, rows),
            across(self.reach, rows),
            across(self.misfit, rows),
        )


class Element(NamedTuple):
    """Gradient and second derivative of blades, order ν_x, ν_y, m, then x, y, φ of both bodies.

    ``gradient`` is (blades, 9, designs), ``closing`` (blades, 3, 9, designs) the first rows of the
    second derivative; of the others only their transpose, and ``turned_i`` and ``turned_j`` at φ of
    the start's and of the end's body (blades, designs), are not zero.
    """

    gradient: Floats
    closing: Floats
    turned_i: Floats
    turned_j: Floats


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
    at: Attachment,
    blade: Condensed,
    force: Floats,
    apart: Floats,
    turn_i: Complexes,
    turn_j: Complexes,
) -> Element:
    """Return gradient and second derivative.

    Parameters
    ----------
    at : Attachment
        Geometry at rest, (blades, designs or 1).
    blade : Condensed
        The blades about their present forces.
    force : array, shape (blades, 3, designs)
        ν and m.
    apart : array, shape (blades, 3, designs)
        By how much the body at the end moved more than that at the start, positions in their unit.
    turn_i, turn_j : array, shape (blades, designs)
        ``turning`` of the bodies at start and end.

    """
    nu, m = force[:, 0] + 1j * force[:, 1], force[:, 2]
    along_moved, a_j_moved, start_moved = at.along * turn_i, at.end * turn_j, at.start * turn_i
    along = at.along + along_moved
    bent = along * (blade.motion[:, 0] + 1j * blade.motion[:, 1])
    lever = at.start + start_moved + at.reach * along + bent
    a_j = at.end + a_j_moved
    pull, moment, far = at.scale * nu, np.conj(lever) * nu, np.conj(a_j) * nu
    gap = at.scale * (apart[:, 0] + 1j * apart[:, 1]) + at.misfit + a_j_moved - bent
    gap -= start_moved + at.reach * along_moved
    gradient = np.empty((m.shape[0], 9, m.shape[1]))
    gradient[:, 0], gradient[:, 1] = gap.real, gap.imag
    gradient[:, 2] = apart[:, 2] - blade.motion[:, 2]
    gradient[:, 6], gradient[:, 7] = pull.real, pull.imag
    gradient[:, 3:5] = -gradient[:, 6:8]
    gradient[:, 5] = -m - moment.imag
    gradient[:, 8] = m + far.imag
    H = np.zeros((m.shape[0], 3, 9, m.shape[1]))
    # −F in global axes: rows and columns turned
    rows = along[:, None] * (blade.F[:, 0] + 1j * blade.F[:, 1])
    for i, turned_row in enumerate((rows.real, rows.imag, blade.F[:, 2])):
        pair = along * (turned_row[:, 0] + 1j * turned_row[:, 1])
        H[:, i, 0], H[:, i, 1], H[:, i, 2] = -pair.real, -pair.imag, -turned_row[:, 2]
    # a turn of the start turns the force in its frame by −iν
    H[:, :, 5] = H[:, :, 0] * nu.imag[:, None] - H[:, :, 1] * nu.real[:, None]
    turned_i = moment.real + (H[:, 0, 5] * nu.imag - H[:, 1, 5] * nu.real)
    H[:, 0, 6] = H[:, 1, 7] = at.scale
    H[:, 0, 3] = H[:, 1, 4] = -at.scale
    H[:, 0, 5] += lever.imag
    H[:, 1, 5] -= lever.real
    H[:, 2, 5] -= 1.0
    H[:, 0, 8], H[:, 1, 8], H[:, 2, 8] = -a_j.imag, a_j.real, 1.0
    return Element(gradient, H, turned_i, -far.real)
