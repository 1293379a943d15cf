"""Blades so narrow that loads in the plane of their joint may buckle it out of it."""

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.layout import Blade
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask

__all__ = ["least_thickness", "may_leave_plane"]

NARROW = 10.0
"""Width of a blade over its least thickness up to which it may leave the plane before it buckles in
it: free at one end there and held by the drive in it, one four times as wide as thick bears as
much; bodies that reach far beyond their blades make it more."""

PLACES = np.linspace(-1.0, 1.0, 41)
"""Where on a piece of a blade its thickness is looked at."""


def may_leave_plane(ask: Ask) -> bool:
    """Return whether a blade of the joint is so narrow, or one of any of many designs."""
    try:
        blades = ask.geometry.plane_layout(ask.material.elastic, ask.sizes).blades
    except NotAvailable:
        return False
    return any(np.any(np.asarray(x.b) < NARROW * least_thickness(x)) for x in blades)


def least_thickness(blade: Blade) -> NDArray[np.float64]:
    """Return the least thickness of a blade, or of each of many designs of it [m]."""
    l = np.hypot(*np.subtract(blade.end, blade.start))
    each = [np.min(piece.thickness(PLACES), axis=-1) for piece in blade.profile.pieces(l)]
    return np.asarray(np.min(each, axis=0))
