"""The box that a mechanism in space fills, at rest and while its drive travels."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Profile
from flexcli.mechanics.space.exact.rotation import matrix_of
from flexcli.mechanics.space.layout import SpaceBlade, SpaceLayout, SpaceRod, Vector

__all__ = ["SweptBox", "swept_box"]

Floats = NDArray[np.float64]

TRAVELS = 9
"""Travels between the ends at which it is looked at: a corner may reach furthest between them."""

PLACES = 9
"""Sections of a blade."""

_ENDS = np.array([-1.0, 1.0])


class SweptBox(NamedTuple):
    """Sides of the box [m], and how far off the bent blades' lines may be [m].

    Blades are taken as cubics between their ends. Those leave an elastic line by less than its
    distance from the chord times the square of its largest angle against it.
    """

    sides: Floats
    doubt: float


def swept_box(
    layout: SpaceLayout,
    outlines: Mapping[str, Floats],
    poses: Sequence[tuple[float, Floats]],
    axes: Floats,
) -> SweptBox:
    """Return the box along some axes around all blades and outlined bodies.

    Parameters
    ----------
    layout : SpaceLayout
        The mechanism at rest.
    outlines : mapping
        Corners of bodies at rest, by name, shape (points, 3) [m].
    poses : sequence
        Travels of the drive, and shift and rotation vector of every body's point there, shape
        (bodies, 6) [m, rad]; between them and rest the motion is interpolated.
    axes : array, shape (3, 3)
        The directions of the box's sides, by rows.

    """
    known = {0.0: np.zeros((len(layout.bodies), 6)), **dict(poses)}
    travels = np.linspace(min(known), max(known), TRAVELS) if len(known) > 1 else np.zeros(1)
    low, high, doubt = np.full(3, np.inf), np.full(3, -np.inf), 0.0
    for travel in dict.fromkeys([*known, *travels.tolist()]):
        motion = _between(known, travel)
        for points, off in _outline(layout, outlines, motion):
            placed = points @ axes.T
            low, high = np.minimum(low, placed.min(axis=0)), np.maximum(high, placed.max(axis=0))
            doubt = max(doubt, off)
    return SweptBox(high - low, doubt)


def _between(known: Mapping[float, Floats], travel: float) -> Floats:
    """Return the motion at a travel, by the polynomial through those that are known (Lagrange)."""
    found = np.zeros_like(known[0.0])
    for at, motion in known.items():
        others = [other for other in known if other != at]
        found += motion * np.prod([(travel - other) / (at - other) for other in others])
    return found


def _outline(
    layout: SpaceLayout, outlines: Mapping[str, Floats], motion: Floats
) -> list[tuple[Floats, float]]:
    """Return the points of bodies and blades as they moved, and how far off each may be."""
    names = [body.name for body in layout.bodies]
    turns = {name: _turn(motion[i, 3:]) for i, name in enumerate(names)}

    def placed(body: str, points: Floats | Vector) -> Floats:
        if body not in turns:
            return np.asarray(points, dtype=np.float64)
        i = names.index(body)
        origin = np.asarray(layout.bodies[i].point)
        return np.asarray((points - origin) @ turns[body].T + origin + motion[i, :3])

    found = [(placed(name, corners), 0.0) for name, corners in outlines.items()]
    for blade in layout.blades:
        ends = placed(blade.first, blade.start), placed(blade.second, blade.end)
        frames = [
            blade.axes @ turns[body].T if body in turns else blade.axes
            for body in (blade.first, blade.second)
        ]
        found.append(_bent(blade, ends, frames))
    return found


def _turn(phi: Floats) -> Floats:
    """Return the matrix of a rotation vector (3, 3)."""
    half = float(np.linalg.norm(phi)) / 2.0
    return matrix_of(np.array([np.cos(half), *(phi / 2.0 * np.sinc(half / np.pi))]))


def _bent(
    blade: SpaceBlade | SpaceRod, ends: tuple[Floats, Floats], frames: Sequence[Floats]
) -> tuple[Floats, float]:
    """Return the edges of a blade bent between its ends, and how far off they may be."""
    l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
    s = np.linspace(0.0, 1.0, PLACES)[:, None]
    (p, q), (t, u) = ends, (l * frames[0][0], l * frames[1][0])
    line = (
        (1.0 + 2.0 * s) * (1.0 - s) ** 2 * p + s * (1.0 - s) ** 2 * t
        + s**2 * (3.0 - 2.0 * s) * q - s**2 * (1.0 - s) * u
    )  # fmt: skip
    slope = (
        6.0 * s * (1.0 - s) * (q - p) + (1.0 - s) * (1.0 - 3.0 * s) * t + s * (3.0 * s - 2.0) * u
    )
    along = slope / np.linalg.norm(slope, axis=1, keepdims=True)
    chord = (q - p) / np.linalg.norm(q - p)
    sine = float(np.linalg.norm(np.cross(along, chord), axis=1).max())
    away = float(np.linalg.norm(np.cross(line - p, chord), axis=1).max())
    if isinstance(blade, SpaceRod):
        reach = blade.d / 2.0 * np.sqrt(np.maximum(1.0 - along**2, 0.0))
        return np.concatenate([line - reach, line + reach]), away * sine**2
    width = (1.0 - s) * frames[0][2] + s * frames[1][2]
    across = np.cross(width, along)
    across, width = (x / np.linalg.norm(x, axis=1, keepdims=True) for x in (across, width))
    h, b = _thickest(blade.profile, l), blade.b
    edges = [line + i * h / 2.0 * across + k * b / 2.0 * width for i in _ENDS for k in _ENDS]
    return np.concatenate(edges), away * sine**2


def _thickest(profile: Profile, l: float) -> float:
    """Return the largest thickness of a blade where it is flexible [m]."""
    return max(float(np.max(piece.thickness(_ENDS))) for piece in profile.pieces(l))
