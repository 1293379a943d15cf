"""Motion of any point of a body: centre shift, runout, travel of an end."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.element import turned
from flexcli.mechanics.layout import Layout, Point
from flexcli.mechanics.mesh import column

__all__ = ["MovedLayout", "point_motion"]

Floats = NDArray[np.float64]


class MovedLayout(Protocol):
    """Designs whose bodies have moved, in equilibrium or by small motion."""

    @property
    def layout(self) -> Layout:
        """Return their bodies and blades."""

    @property
    def motions(self) -> Floats:
        """Return the motions (designs, bodies, 3) of the bodies' points [m, m, rad]."""


def point_motion(state: MovedLayout, body: str, point: Point) -> Floats:
    """Return how far a point of a body has moved.

    ``u_P = u + (R(φ) − 1) a`` with the arm a from the reference point at rest.

    Parameters
    ----------
    state : MovedLayout
        The designs.
    body : str
        Name of the body.
    point : Point
        Where the point is at rest [m]; for a pivot its centre: the motion is the centre shift.

    Returns
    -------
    array, shape (designs, 2)
        Motion along x and y [m].

    """
    index = state.layout.index(body)
    motion = state.motions[:, index]
    origin = state.layout.bodies[index].point
    x, y = (column(p) - column(o) for p, o in zip(point, origin, strict=True))
    arm = np.broadcast_to(np.stack(np.broadcast_arrays(x, y), axis=-1), (len(motion), 2))
    return np.asarray(motion[:, :2] + turned(arm, motion[:, 2])[1])
