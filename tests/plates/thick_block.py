"""Block between two rigid bodies as bricks of high order, small towards its clamped edges.

The block has l = 1 and E = 1. At the edges of its clamps stresses have no bound: what the finest
bricks leave of that makes it stiffer, by up to half a percent of what clamps stiffen of it.
"""

from typing import NamedTuple

import numpy as np
from plates.held_solid import cuts

from flexcli.mechanics.solids.lagrange import places_along
from flexcli.mechanics.solids.octant import Lattice, Octant

ORDERS, GROWING = (4, 12, 4), 4.0
ALONG, S_SHAPED, ARC = 0, 1, 5
"""Which of the unit loads stretch it, and bend it across its thickness."""


class Factors(NamedTuple):
    """Stiffness bent to an arc, over E I/l, and to an S, over Timoshenko's 12 E I/(l³ (1 + Φ))."""

    arc: float
    s_shape: float


def factors(*, h, b, nu, first=0.05):
    """Return both, with bricks that begin at a part of the smaller side [-]."""
    found = _block(h, b, nu, first)
    I, Phi = b * h**3 / 12.0, 2.4 * (1.0 + nu) * h**2
    arc, s_shaped = (found.moved(load).compliance for load in (ARC, S_SHAPED))
    return Factors(1.0 / I / arc, (1.0 + Phi) / 12.0 / I / s_shaped)


def axial_factor(*, h, b, nu, first=0.05):
    """Return the stiffness along the block over E b h/l [-]."""
    return 1.0 / (b * h) / _block(h, b, nu, first).moved(ALONG).compliance


def _block(h, b, nu, first):
    """Return an octant of the block, one brick to its thickness."""
    x, z = (
        places_along(cuts(size / 2.0, first * min(h, b), GROWING), order)
        for size, order in zip((1.0, b), ORDERS[::2], strict=True)
    )
    y = places_along(np.array([0.0, h / 2.0]), ORDERS[1])
    return Octant(Lattice(*np.meshgrid(x, y, indexing="ij"), z, ORDERS), 1.0, nu)
