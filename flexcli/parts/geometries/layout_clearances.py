"""Room between the blades of a drawn layout: those that stand in one plane may not meet."""

from collections.abc import Iterator, Mapping
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.quantity import Computed
from flexcli.parts.geometries.layout_parts import DrawnBlade, Place

__all__ = ["rooms"]

Floats = NDArray[np.float64]
Points = NDArray[np.complex128]

ROOT = 0.1
"""Share of a blade next to a body that another ends on too, where both may be one piece."""

TOUCHING = 1e-9
"""Overlap along the axis, over the width, below which blades lie side by side."""


def rooms(
    blades: Mapping[str, DrawnBlade], thinnest: Mapping[str, Computed]
) -> Iterator[tuple[str, Computed]]:
    """Yield the room between any two blades that stand at one height, where they are thinnest [m].

    What lies next to a body on which both end is left out: blades that meet in it are drawn so.
    """
    for (one, a), (other, b) in combinations(blades.items(), 2):
        if np.all(abs(a.z - b.z) >= (a.b + b.b) / 2.0 * (1.0 - TOUCHING)):
            continue
        apart = _apart(_trimmed(a, b), _trimmed(b, a))
        yield f"blades {one} and {other}", apart - (thinnest[one] + thinnest[other]) / 2.0


def _trimmed(blade: DrawnBlade, other: DrawnBlade) -> tuple[Points, Points]:
    """Return both ends of a blade without what is next to bodies of the other [m]."""
    start, end = _point(blade.start), _point(blade.end)
    cut = [ROOT * (body in other.between) for body in blade.between]
    return start + cut[0] * (end - start), end + cut[1] * (start - end)


def _point(place: Place) -> Points:
    """Return a place as x + i y, of one design or of many [m]."""
    x, y = map(np.asarray, place)
    return np.asarray(x + 1j * y)


def _apart(one: tuple[Points, Points], other: tuple[Points, Points]) -> Computed:
    """Return the distance of two straight lines [m]: none where they cross, or from an end."""
    pairs = [(at, line) for line, ats in ((other, one), (one, other)) for at in ats]
    nearest = np.minimum.reduce(np.broadcast_arrays(*(_from_line(*pair) for pair in pairs)))
    sides = [_side(*pair) for pair in pairs]
    crossed = (sides[0] * sides[1] < 0.0) & (sides[2] * sides[3] < 0.0)
    return np.where(crossed, 0.0, nearest)[()]


def _side(at: Points, line: tuple[Points, Points]) -> Floats:
    """Return on which side of a line a point is: twice the area between them, signed [m²]."""
    return np.asarray(np.imag(np.conj(line[1] - line[0]) * (at - line[0])))


def _from_line(at: Points, line: tuple[Points, Points]) -> Floats:
    """Return the distance of a point from a straight line with two ends [m]."""
    along, to = line[1] - line[0], at - line[0]
    share = np.clip(np.real(np.conj(along) * to) / np.abs(along) ** 2, 0.0, 1.0)
    return np.asarray(np.abs(to - share * along))
