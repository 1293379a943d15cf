"""The box that a mechanism in space fills while it travels: of points, and of how far off each is.

A sweep are points (shares, travels, points, 3) and how far off each may be along the axes of the
box (the same shape) [m]: at even shares of loads, and at even travels.
"""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.layout import SpaceBlade, SpaceRod, SpaceStar

__all__ = ["Edges", "Sweep", "SweptBox", "edges_of", "steps_along", "swept_box"]

Floats = NDArray[np.float64]

BEYOND = 0.25
"""Of a second difference, how far points may reach beyond those that are looked at: twice what a
parabola does."""

CURLED = 1.47
"""Times ``ν h/√(12 (1 − ν²))``, how far the sides of a bent blade curl away from its middle at
most, however wide it is: strips of any width (Ashwell's profile, which
:mod:`flexcli.formulas.plate_flattening` has the energy of) had 1.466."""

_SIGNS = np.array([1.0, -1.0])


class Sweep(NamedTuple):
    """Points on their way, and how far off they may be along the axes of the box [m], if known."""

    points: Floats
    off: Floats
    is_known: bool = True


class SweptBox(NamedTuple):
    """Sides of the box along its axes (3,) [m], and between what they lie, if known."""

    sides: Floats
    least: Floats
    most: Floats
    is_known: bool = True


class Edges(NamedTuple):
    """A blade on its way: its line (…, places, 3) [m] and what its section is along it.

    ``across`` and ``width`` are unit vectors along the section's thickness and width, ``along`` is
    the line's own direction, all (…, places, 3); ``h`` (places,) is the thickness [m], ``kappa``
    (…, places) the curvature [1/m] and ``steps`` (places,) the distance to the next place [m].
    """

    line: Floats
    along: Floats
    across: Floats
    width: Floats
    h: Floats
    kappa: Floats
    steps: Floats


def steps_along(line: Floats) -> Floats:
    """Return how far each place of a line (places, axes) is from those beside it, at most [m]."""
    between = np.linalg.norm(np.diff(line, axis=0), axis=-1)
    return np.asarray(np.maximum(np.append(between, 0.0), np.append(0.0, between)))


def swept_box(sweeps: Iterable[Sweep]) -> SweptBox:
    """Return the box around sweeps, whose points are along the axes of the box.

    Between two travels, or shares, a point reaches further than at either by an eighth of its
    second difference, if its way is a parabola there.
    """
    ends = np.full((3, 2, 3), -np.inf)  # as they are, at least, at most; above and below
    known = True
    for points, off, is_known in sweeps:
        known = known and is_known
        past = _past(points, 0) + _past(points, 1)
        for i, more in enumerate((np.zeros(3), -off, off + past)):
            for k, sign in enumerate(_SIGNS):
                reach = (sign * points + more).reshape(-1, 3).max(axis=0)
                ends[i, k] = np.maximum(ends[i, k], reach)
    sides, least, most = ends.sum(axis=1)
    return SweptBox(sides, np.maximum(least, 0.0), most, known)


def _past(points: Floats, axis: int) -> Floats:
    """Return how far points may reach beyond those beside them along an axis of the array."""
    if points.shape[axis] < 3:
        return np.zeros(points.shape)
    bent = np.moveaxis(np.abs(np.diff(points, 2, axis=axis)), axis, 0)
    bent = np.concatenate([bent[:1], bent, bent[-1:]])
    return BEYOND * np.moveaxis(bent, 0, axis)


def edges_of(blade: SpaceBlade | SpaceRod, edges: Edges, axes: Floats, grown: float) -> Sweep:
    """Return the edges of a blade or rod along axes by rows (3, 3), and how far off they may be.

    The sides of a bent blade curl away from its middle by up to ``ν κ b²/8``, and it is wider by
    its strain where it is compressed. Its section has ``grown`` by a free strain.
    """
    line, along, across, width = (each @ axes.T for each in edges[:4])
    between = (edges.kappa * edges.steps**2 / 8.0)[..., None]
    nu = blade.material.nu
    if isinstance(blade, SpaceRod) and not isinstance(blade, SpaceStar):
        reach = (1.0 + grown) * blade.d / 2.0 * np.sqrt(np.maximum(1.0 - along**2, 0.0))
        wider = 1.0 + nu * blade.d / 2.0 * edges.kappa[..., None]
        off = reach * (wider - 1.0) + between
        points = np.concatenate([line - reach, line + reach], axis=-2)
        return Sweep(points, np.concatenate([off, off], axis=-2))
    if isinstance(blade, SpaceStar):
        arms, half = blade.arms / 2.0, blade.h / 2.0
        corners = [
            (blade.b * y - 2.0 * k * half * z, blade.b * z + 2.0 * k * half * y)
            for y, z in arms for k in _SIGNS
        ]  # fmt: skip
        b, curl = blade.d, np.zeros_like(edges.kappa)
        sections = [(np.full_like(edges.h, y), z) for y, z in corners]
    else:
        b = blade.b
        most = CURLED * nu * edges.h / np.sqrt(12.0 * (1.0 - nu**2))
        curl = np.minimum(nu * edges.kappa * b**2 / 8.0, most)
        sections = [(i * edges.h / 2.0, k * b / 2.0) for i in _SIGNS for k in _SIGNS]
    wider = nu * edges.kappa * edges.h * b / 4.0
    off = np.abs(across) * (curl[..., None] + between) + np.abs(width) * wider[..., None]
    each = [line + (1.0 + grown) * (y[..., None] * across + z * width) for y, z in sections]
    return Sweep(np.concatenate(each, axis=-2), np.concatenate([off] * len(each), axis=-2))
