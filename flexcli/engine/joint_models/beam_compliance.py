"""Compliance of a joint of beams in space, which effects of plates correct afterwards."""

from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.support import support_compliance
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements import Ask

__all__ = ["beam_compliance"]


def beam_compliance(ask: Ask) -> NDArray[np.float64]:
    """Return the 6×6 compliance of a planar joint, free but for its guide, along cases' axes.

    It is that of the moving body's point, its blades beams that may warp: what no plate is in.

    Raises
    ------
    NotAvailable
        When the joint has no layout, no shear modulus, or a freedom without any spring.

    """
    layout = ask.geometry.layout(ask.material.elastic, ask.sizes)
    if layout.G is None:
        raise NotAvailable("needs material.poisson_ratio for its shear and torsion")
    c, s = cos(ask.geometry.axes), sin(ask.geometry.axes)
    axes = ((c, s, 0.0), (-s, c, 0.0), (0.0, 0.0, 1.0))
    try:
        C = support_compliance(layout, MOVING, (*layout.body(MOVING).point, 0.0), axes)
    except SolveError as error:
        raise NotAvailable(f"has no stiffness: {error}") from error
    if ask.geometry.is_guided:
        # what guides it keeps it from turning about z
        C = C - np.outer(C[:, 5], C[5]) / C[5, 5]
        C[5], C[:, 5] = 0.0, 0.0
    return C
