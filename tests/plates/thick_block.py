"""Block between two rigid bodies as bricks of the fourth order, small towards its clamped edges.

The block has l = 1 and E = 1. At the edges of its clamps stresses have no bound: what the finest
bricks leave of that makes it stiffer, by up to half a percent of what clamps stiffen of it.
"""

from typing import NamedTuple

import numpy as np
from plates.held_solid import cuts

from flexcli.mechanics.solids.lagrange import places_along
from flexcli.mechanics.solids.octant import Lattice, Octant

ORDER, GROWING = 4, 4.0
S_SHAPED, ARC = 1, 5
"""Which of the unit loads bend it across its thickness."""


class Factors(NamedTuple):
    """Stiffness bent to an arc, over E I/l, and to an S, over Timoshenko's 12 E I/(l³ (1 + Φ))."""

    arc: float
    s_shape: float


def factors(*, h, b, nu, first=0.05):
    """Return both, with bricks that begin at a part of the smaller side [-]."""
    least = first * min(h, b)
    x, y, z = (places_along(cuts(size / 2.0, least, GROWING), ORDER) for size in (1.0, h, b))
    block = Octant(Lattice(*np.meshgrid(x, y, indexing="ij"), z, (ORDER,) * 3), 1.0, nu)
    arc, s_shape = (block.moved(index).compliance for index in (ARC, S_SHAPED))
    I, Phi = b * h**3 / 12.0, 2.4 * (1.0 + nu) * h**2
    return Factors(1.0 / I / arc, (1.0 + Phi) / 12.0 / I / s_shape)
