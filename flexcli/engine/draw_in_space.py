"""A mechanism in space as it is drawn: seen along one axis, its blades as thick as they look."""

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Constant
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.space.layout import SpaceLayout, SpaceRod

__all__ = ["VIEWS", "seen", "view_of"]

Floats = NDArray[np.float64]

VIEWS = {"z": ("x", "y"), "x": ("y", "z"), "y": ("x", "z")}
"""Axes to the right and up, by the axis that one looks along."""

END_ON = 1e-3
"""Share of its length that a blade is seen of, below which it is only seen end on."""


def view_of(layout: SpaceLayout) -> str:
    """Return the axis to look along: that of a rotation, or one that a translation is across."""
    size = dict(zip("xyz", np.abs(layout.drive.direction), strict=True))
    if layout.drive.turns:
        return max(VIEWS, key=lambda axis: size[axis])
    return min(VIEWS, key=lambda axis: round(size[axis], 3))


def seen(layout: SpaceLayout, view: str) -> tuple[Layout, int]:
    """Return a mechanism as a planar one seen along an axis, and how many blades are end on."""
    rows = np.array([[float(a == axis) for a in "xyz"] for axis in VIEWS[view]])
    blades, hidden = [], 0
    for member in layout.blades:
        start, end = rows @ member.start, rows @ member.end
        length = float(np.linalg.norm(end - start))
        if length < END_ON * float(np.linalg.norm(np.subtract(member.end, member.start))):
            hidden += 1
            continue
        across = np.array([start[1] - end[1], end[0] - start[0]]) / length @ rows
        if isinstance(member, SpaceRod):
            thick, deep = member.d, member.d
        else:
            h = float(member.profile.h) if isinstance(member.profile, Constant) else 0.0
            thick = abs(float(across @ member.axes[1])) * h
            thick += abs(float(across @ member.axes[2])) * member.b
            deep = member.b
        ends = (float(start[0]), float(start[1])), (float(end[0]), float(end[1]))
        profile = Constant(thick)
        blades.append(Blade(member.name, member.first, member.second, *ends, profile, deep))
    bodies = []
    for body in layout.bodies:
        (x, y), (p, q) = rows @ body.point, rows @ body.com
        bodies.append(Body(body.name, (float(x), float(y)), body.mass, 0.0, (float(p), float(q))))
    return Layout(tuple(bodies), tuple(blades), 1.0), hidden
