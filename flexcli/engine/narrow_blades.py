"""Blades so narrow that loads in the plane of their joint may buckle it out of it."""

import numpy as np

from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask

__all__ = ["may_leave_plane"]

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
    for blade in blades:
        l = np.hypot(*np.subtract(blade.end, blade.start))
        thickness = [np.min(piece.thickness(PLACES), axis=-1) for piece in blade.profile.pieces(l)]
        if np.any(np.asarray(blade.b) < NARROW * np.min(thickness, axis=0)):
            return True
    return False
