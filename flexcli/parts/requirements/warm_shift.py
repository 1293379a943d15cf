"""Parasitic shift at a temperature: what the stroke makes of it, what the heat, and what both.

What a stroke makes without a temperature is known better than beams know it, by what corrects them.
What the heat makes are lengths, which no model of how blades bend changes, but for what they bend
by pressing what is bent already: near the temperature that buckles a joint, all of it.
"""

from math import inf
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["EndShift", "WarmShift", "combined"]

Floats = NDArray[np.float64]


class EndShift(NamedTuple):
    """The shift at an end of a stroke (2,) [m]: by stroke, by heat, and what both make besides.

    Towards −x and −y, of a stage towards −x alone. ``bent`` is what heat makes by bending what is
    deformed already, ``unsure`` what lengths, and stiffness of blades that are not alike, leave.
    """

    cold: Floats
    heat: Floats
    both: Floats
    bent: float
    unsure: float


class WarmShift(NamedTuple):
    """The shifts at both ends of a stroke, or that of the heat alone.

    ``plates`` is how much stiffer blades may be in bending than beams, ``held`` what clamps change
    of that which hold them across [-]. ``raised`` is by what share more heat is what tells how much
    of a shift is bent.
    """

    ends: tuple[EndShift, ...]
    plates: float
    held: float
    raised: float

    @property
    def cold(self) -> float:
        """Return the size of the largest shift by the stroke [m]."""
        return max(_size(end.cold) for end in self.ends)


def combined(
    warm: WarmShift, *, factor: float = 1.0, cold_error: float = 0.0, bending: float = 0.0
) -> tuple[float, float, float]:
    """Return the largest shift, positive towards −x, and between which sizes it is [m].

    What both make besides, and what heat bends, follows from how blades bend that are pulled or
    pressed; its error is that of their stiffness in bending.

    Parameters
    ----------
    warm : WarmShift
        By beams.
    factor : float
        What corrects the stroke's share [-].
    cold_error, bending : float
        Relative errors of the size of that, and of a stiffness in bending.

    """
    off = cold_error * abs(factor) * warm.cold if warm.cold else 0.0
    beside, stiffer = bending + warm.plates + warm.held, max(bending, warm.plates) + warm.held
    largest = least = most = 0.0
    for end in warm.ends:
        shift, cold = factor * end.cold + end.heat + end.both, np.abs(end.cold)
        # a size says nothing of a direction, which plates change by no more than they are stiffer
        turned = np.where(cold == cold.min(), np.minimum(cold, warm.plates * _size(cold)), 0.0)
        unsure = off + end.unsure + _of_bent(end.bent, _size(shift), stiffer, warm.raised)
        apart = turned + beside * np.abs(end.both)
        found = float(np.copysign(_size(shift), shift[0]))
        largest = found if abs(found) > abs(largest) else largest
        least = max(least, _size(np.maximum(np.abs(shift) - apart, 0.0)) - unsure)
        most = max(most, _size(np.abs(shift) + apart) + unsure)
    return largest, max(least, 0.0), most


def _of_bent(bent: float, shift: float, stiffer: float, raised: float) -> float:
    """Return how far a shift is off of which so much is bent [m], by blades that much stiffer.

    What is bent is that by heat that is more by the share ``raised``, see ``amplified``.
    """
    left = 1.0 - max(stiffer - raised, 0.0) * bent / shift if bent and shift else 1.0
    return stiffer * bent / left if bent < inf and left > 0.0 else inf


def _size(shift: Floats) -> float:
    return float(np.hypot(*shift))
