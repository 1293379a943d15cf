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

from flexcli.mechanics.beam import Condensed, paired
from flexcli.mechanics.mesh import across, chosen

__all__ = ["Attachment", "Element", "Ends", "element", "turned"]

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


class Ends(NamedTuple):
    """What an element takes of an attachment, (blades or 1, …, designs or 1).

    ``lever`` reaches from the start's body to the end of the blade, ``weight`` is the energy unit
    of the blade over that of the design, ``still`` what of the second derivative does not change.
    """

    lever: Complexes
    end: Complexes
    along: Complexes
    scale: Floats
    misfit: Complexes
    weight: Floats
    still: Floats

    @classmethod
    def of(cls, at: Attachment, weight: Floats) -> "Ends":
        """Return those of blades with energy units (designs or 1, blades)."""
        still = np.zeros((*np.broadcast_shapes(at.scale.shape, at.along.shape), 3, 9))
        still[..., 0, 6] = still[..., 1, 7] = at.scale
        still[..., 0, 3] = still[..., 1, 4] = -at.scale
        still[..., 2, 5], still[..., 2, 8] = -1.0, 1.0
        return cls(
            across(at.start + at.reach * at.along),
            across(at.end),
            across(at.along),
            across(at.scale),
            across(at.misfit),
            across(weight),
            across(still),
        )

    def chosen(self, rows: NDArray[np.intp]) -> "Ends":
        """Return those of the designs ``rows``."""
        return Ends(
            chosen(self.lever, rows),
            chosen(self.end, rows),
            chosen(self.along, rows),
            chosen(self.scale, rows),
            chosen(self.misfit, rows),
            chosen(self.weight, rows),
            chosen(self.still, rows),
        )


class Element(NamedTuple):
    """Gradient and second derivative of blades in units of energy, the designs the last axis.

    ``gap`` (blades, 3, designs) is the gradient by ν_x, ν_y, m, ``closing`` (blades, 3, 9, designs)
    its derivative by these and by x, y, φ of both bodies. ``on`` (2, blades, 4, designs) are the
    gradients by x, y, φ of the start's and the end's body, and the second derivative by that φ:
    of the rest only the transpose of ``closing`` is not zero.
    """

    gap: Floats
    closing: Floats
    on: Floats


def turned(vector: Floats, phi: Floats) -> tuple[Floats, Floats]:
    """Return the vector turned by φ, and how far that moved it (in full relative precision)."""
    versine, sin = 2.0 * np.sin(phi / 2.0) ** 2, np.sin(phi)
    x, y = vector[..., 0], vector[..., 1]
    moved = np.stack([-versine * x - sin * y, sin * x - versine * y], axis=-1)
    return vector + moved, moved


def element(
    at: Ends,
    blade: Condensed,
    along: Complexes,
    force: tuple[Complexes, Floats],
    apart: Floats,
    turns: Complexes,
    warmth: Floats,
) -> Element:
    """Return gradient and second derivative.

    Parameters
    ----------
    at : Ends
        Geometry at rest.
    blade : Condensed
        The blades about their present forces.
    along : array, shape (blades, designs)
        Direction of the blades' starts.
    force : tuple of array, shape (blades, designs)
        ν as ν_x + i ν_y, and m.
    apart : array, shape (blades, 3, designs)
        By how much the body at the end moved more than that at the start, positions in their unit.
    turns : array, shape (2, blades, designs)
        ``turning`` of the bodies at start and end.
    warmth : array, shape (designs,)
        Share of the misfit that is there.

    """
    (nu, m), weight = force, at.weight
    pulled = nu.conj()
    blades, _, _, designs = blade.end.shape
    # end and derivatives turned into global axes: x and y of the end first, then of the forces
    turned_end = along[:, None] * paired(blade.end[:, 0], blade.end[:, 1])
    rows = np.empty((blades, 3, 3, designs))
    rows[:, 0], rows[:, 1] = turned_end[:, 1:].real, turned_end[:, 1:].imag
    rows[:, 2] = blade.end[:, 2, 1:]
    F = along[:, None] * paired(rows[:, :, 0], rows[:, :, 1])
    bent = turned_end[:, 0]
    lever_moved, end_moved = at.lever * turns[0], at.end * turns[1]
    lever, end = at.lever + lever_moved + bent, at.end + end_moved
    moment, far = pulled * lever, pulled * end
    opens = at.scale * paired(apart[:, 0], apart[:, 1]) + warmth * at.misfit
    opens += end_moved - bent - lever_moved
    gap = np.empty((blades, 3, designs))
    gap[:, 0], gap[:, 1] = opens.real, opens.imag
    np.subtract(apart[:, 2], blade.end[:, 2, 0], out=gap[:, 2])
    H = np.empty((blades, 3, 9, designs))
    H[...] = at.still
    np.negative(F.real, out=H[:, :, 0])
    np.negative(F.imag, out=H[:, :, 1])
    np.negative(rows[:, :, 2], out=H[:, :, 2])
    # a turn of the start turns the force in its frame by −iν
    with_start = (F * pulled[:, None]).imag
    H[:, :, 5] += with_start
    H[:, 0, 5] += lever.imag
    H[:, 1, 5] -= lever.real
    np.negative(end.imag, out=H[:, 0, 8])
    H[:, 1, 8] = end.real
    on = np.empty((2, blades, 4, designs))
    pull = at.scale * nu
    on[1, :, 0], on[1, :, 1] = pull.real, pull.imag
    np.negative(on[1, :, :2], out=on[0, :, :2])
    on[0, :, 2], on[1, :, 2] = moment.imag - m, m - far.imag
    on[0, :, 3] = with_start[:, 0] * nu.imag - with_start[:, 1] * nu.real + moment.real
    np.negative(far.real, out=on[1, :, 3])
    return Element(gap * weight[:, None], H * weight[:, None, None], on * weight[:, None])
