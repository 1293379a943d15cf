"""The octant of a neck, or of a limb between two: half of it along, across and over the width."""

from math import asinh, ceil, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.solids.lagrange import places_along
from flexcli.mechanics.solids.octant import Lattice

__all__ = ["Neck", "neck_lattice"]

Floats = NDArray[np.float64]

STEP = 0.55
"""Longest brick along a curved face, in the variable that crowds them into a sharp throat."""

STRAIGHT = 3.0
"""Longest brick of a straight stretch over its neighbour nearer to a fillet."""

STEEP = 0.999
"""Sine of the angle at which bricks end at a mouth that is clamped: none fits in the cusp beyond,
which is rigid here."""

AT_FACE, WIDER = 0.6, 4.0
"""First brick at a free side, in thicknesses of the throat, and each over the one before."""


class Neck(NamedTuple):
    """A neck [m]: two half-ellipses apart by a straight stretch, of a depth and a length together.

    ``block`` is the length of each block beside it, as high as its mouth, up to a rigid body. With
    a ``bar`` it is one of the two necks of a limb, whose middle is that far from their mouths.
    """

    e: float
    depth: float
    l: float
    b: float
    straight: float = 0.0
    block: float = 0.0
    bar: float = 0.0

    @property
    def height(self) -> float:
        """Return the height of its mouth [m]."""
        return self.e + 2.0 * self.depth

    @property
    def end(self) -> float:
        """Return the distance of a mouth from the middle of the throat [m]."""
        return (self.straight + self.l) / 2.0

    @property
    def throat(self) -> float:
        """Return the distance of the middle of the throat from that of the body [m]."""
        return self.bar + self.end if self.bar > 0.0 else 0.0


def neck_lattice(neck: Neck, orders: tuple[int, int, int]) -> Lattice:
    """Return the octant of a neck in bricks of these orders."""
    along, across, wide = orders
    faces, mouth = _face(neck, along)
    t = places_along(np.array([0.0, 1.0]), across)
    top, bottom = faces[:, :2], faces[:, 2]
    x = bottom[:, None] + t * (top[:, 0] - bottom)[:, None]
    y = t * top[:, 1:]
    z = neck.b / 2.0 - places_along(_widths(neck), wide)[::-1]
    return Lattice(x, y, z, orders, mouth)


def _face(neck: Neck, order: int) -> tuple[Floats, int]:
    """Return places along the face from the middle on, and which is at the last mouth.

    They are (n, 3): x and y there, and x where the line across the body from there meets y = 0.
    """
    found, mouth = _from_throat(neck, order)
    if neck.bar == 0.0:
        return found, mouth
    # the other side of the throat is its mirror image, its block is half the bar
    inner, _ = _from_throat(neck._replace(block=neck.bar), order)
    inner, found = inner[:0:-1] * [-1.0, 1.0, -1.0], found.copy()
    for each in (inner, found):
        each[:, [0, 2]] += neck.throat
    return np.concatenate([inner, found]), len(inner) + mouth


def _from_throat(neck: Neck, order: int) -> tuple[Floats, int]:
    """Return the places from the middle of the throat to the end of the block."""
    e, depth, l = neck.e, neck.depth, neck.l
    w = sqrt(e / (e + 4.0 * depth))
    most = STEEP if neck.block == 0.0 else 1.0
    reach = asinh(most / (1.0 + sqrt(1.0 - most**2)) / w)
    v = places_along(np.linspace(0.0, reach, ceil(reach / STEP) + 1), order)
    u = w * np.sinh(v)
    cos, sin = (1.0 - u**2) / (1.0 + u**2), 2.0 * u / (1.0 + u**2)
    if neck.block > 0.0:
        cos[-1], sin[-1] = 0.0, 1.0
    x, y = neck.straight / 2.0 + l / 2.0 * sin, e / 2.0 + depth * (1.0 - cos)
    # lines lean by half the slope of the face, as far as the block is long enough
    lean = min(1.0, neck.block / neck.height)
    slope = np.arctan2(2.0 * depth * sin, l * cos)
    foot = x + lean * y * np.tan(slope / 2.0)
    found = [np.stack([x, y, foot], axis=-1)]
    if neck.straight > 0.0:
        s = places_along(_straight(neck), order)[:-1]
        found.insert(0, np.stack([s, np.full(s.size, e / 2.0), s], axis=-1))
    mouth = sum(map(len, found)) - 1
    if neck.block > 0.0:
        end, start = neck.end + neck.block, foot[-1]
        cuts = np.linspace(0.0, 1.0, 1 + ceil(neck.block / neck.height))
        cuts = np.concatenate([cuts[:-1], [(cuts[-2] + 2.0) / 3.0, 1.0]])
        share = places_along(cuts, order)[1:]
        above = neck.end + share * neck.block
        below = start + share * (end - start)
        found.append(np.stack([above, np.full(share.size, neck.height / 2.0), below], axis=-1))
    return np.concatenate(found), mouth


def _straight(neck: Neck) -> Floats:
    """Return where bricks of the straight half end, short where the fillet begins."""
    size = min(sqrt(neck.e * neck.l**2 / (4.0 * neck.depth)), neck.e)
    cuts, at = [0.0], 0.0
    half = neck.straight / 2.0
    while at + 1.5 * size < half:
        at += size
        cuts.append(at)
        size *= STRAIGHT
    cuts.append(half)
    return half - np.array(cuts)[::-1]


def _widths(neck: Neck) -> Floats:
    """Return where bricks end over half the width, from its free side."""
    half, at = neck.b / 2.0, AT_FACE * neck.e
    cuts = [0.0]
    while at < half / 1.5:
        cuts.append(at)
        at *= WIDER
    if len(cuts) == 1:
        cuts.append(0.4 * half)
    return np.array([*cuts, half])
