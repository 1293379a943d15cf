"""Block between two rigid bodies as bricks of the fourth order, small towards its clamped edges.

The block has l = 1 and E = 1. At the edges of its clamps stresses have no bound: what the finest
bricks leave of that makes it stiffer, by up to half a percent of what clamps stiffen of it.
"""

from typing import NamedTuple

import numpy as np

from flexcli.mechanics.solids.lagrange import places_along
from flexcli.mechanics.solids.octant import Lattice, moved

ORDER, GROWING = 4, 4.0
S_SHAPED, ARC = 1, 5
"""Which of the unit loads bend it across its thickness."""


class Factors(NamedTuple):
    """Stiffness bent to an arc, over E I/l, and to an S, over Timoshenko's 12 E I/(l³ (1 + Φ))."""

    arc: float
    s_shape: float


def factors(*, h, b, nu, first=0.05):
    """Return both, with bricks that begin at a part of the smaller side [-]."""
    x, y, z = (places_along(_cuts(size / 2.0, first * min(h, b)), ORDER) for size in (1.0, h, b))
    found = moved(Lattice(*np.meshgrid(x, y, indexing="ij"), z, (ORDER,) * 3), 1.0, nu)
    I, Phi = b * h**3 / 12.0, 2.4 * (1.0 + nu) * h**2
    return Factors(
        1.0 / I / found[ARC].compliance, (1.0 + Phi) / 12.0 / I / found[S_SHAPED].compliance
    )


def _cuts(half, first):
    """Return the ends of bricks from the middle, which grow from the edge inwards."""
    cuts, size = [0.0], first
    while cuts[-1] + 1.6 * size < half:
        cuts.append(cuts[-1] + size)
        size *= GROWING
    return half - np.array([*cuts, half])[::-1]
