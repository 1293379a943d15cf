"""Places along a piece of a blade at which a stress is looked at that small motion causes."""

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Piece
from flexcli.mechanics.layout import Blade

__all__ = ["SAMPLED", "is_uneven", "stress_places"]

Floats = NDArray[np.float64]

THICKER, STEPS = 1.0, 10
"""How much thicker than where it is thinnest a piece is looked at, in that many steps: of a force
across a notch, whose moment vanishes in the throat, the largest stress is where it is 4/3 as thick.
"""

SAMPLED = 0.01
"""Share by which the stress between two such places may be larger: 0.009 of notches, fillets and
tapers, thin and thick, whatever forces and moments with whatever correlation."""

_FINE = np.linspace(-1.0, 1.0, 513)


def is_uneven(blade: Blade) -> bool:
    """Return whether a blade has a piece whose thickness is not the same everywhere."""
    pieces = blade.profile.pieces(float(blade.length))
    return not all(piece.is_uniform for piece in pieces)


def stress_places(piece: Piece) -> Floats:
    """Return places u of a piece of one design, from −1 to 1, both ends among them.

    Along a uniform piece a moment is largest at an end. Where thickness grows, the stress of a
    moment that grows as well is largest between: places are crowded where the piece is thin, evenly
    in the distance from a throat, whose thickness grows by its square.
    """
    if piece.is_uniform:
        return np.array([-1.0, 1.0])
    h = np.broadcast_to(np.ravel(piece.thickness(_FINE)), _FINE.shape)
    u = _FINE if h[0] < h[-1] else _FINE[::-1]
    h = np.sort(h)
    more = min(THICKER, float(h[-1] / h[0]) - 1.0)
    between = h[0] * (1.0 + more * (np.arange(1, STEPS + 1) / STEPS) ** 2)
    inner = np.interp(between[between < h[-1]], h, u)
    return np.unique(np.concatenate([[-1.0, 1.0], inner]))
