"""Limb between two circular notches, with blocks outside them, as a plane body: finite elements.

A quarter of it in plane stress, E = 1 and width 1, from its middle to the rigid end of a block. The
radius of the notches is 1. Shares no code with the package.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from plates.notched_plate import DEGREE, assembled
from scipy.sparse.linalg import spsolve

__all__ = ["Limb", "solid"]

ALONG = 8


class Limb(NamedTuple):
    """Compliances between the ends, by a moment, by a force across the middle and one along.

    ``arc`` and ``sway`` are by how much half of it shortens, to second order, as its end turns by 1
    and as it moves across by 1, both over the length of the limb. ``turned``, ``swung``
    and ``pulled`` are the stresses along the edge over E as an end does so, or is pulled by 1, of a
    radius of 1.
    """

    turn: float
    swing: float
    along: float
    arc: float
    sway: float
    turned: np.ndarray
    swung: np.ndarray
    pulled: np.ndarray


def solid(*, e, l, block, rise=0.0, nu=0.3):
    """Return a limb whose blocks are as long as ``block`` heights of a mouth.

    They are higher by a share ``rise`` at their ends.
    """
    X, Z, number, elements, (g, w), slopes, strain, elastic, K = assembled(
        _columns(e, l, block, rise), nu
    )
    inside, on_edge = slopes(g, g), slopes(np.linspace(-1.0, 1.0, 15), np.array([1.0]))
    count, far, axis = X.size, number[-1], number[:, 0]
    odd, level = (axis, number[0]), (axis, number[0] + count)

    def moved(held, u, w):
        found = np.zeros(2 * count)
        found[far], found[far + count] = u, w
        fixed = np.unique(np.concatenate([*held, far, far + count]))
        free = np.setdiff1d(np.arange(2 * count), fixed)
        found[free] = spsolve(K[free][:, free], -(K @ found)[free])
        return found

    turned, swung = moved(odd, -Z[-1], 0.0), moved(level, 0.0, 1.0)
    pulled = moved((axis + count, number[0]), 1.0, 0.0)
    forces = K @ pulled
    squares = []
    for motion in (turned, swung):
        total = 0.0
        for where in elements:
            ids = number[where].ravel()
            B, area = strain(ids, inside)
            d_x, d_z = B[:, 0, : ids.size], B[:, 2, : ids.size]
            at_x, at_z = (
                np.stack([d @ motion[ids], d @ motion[ids + count]], axis=1) for d in (d_x, d_z)
            )
            stress = (B @ np.concatenate([pulled[ids], pulled[ids + count]])) @ elastic
            green = [(at_x**2).sum(1) / 2, (at_z**2).sum(1) / 2, (at_x * at_z).sum(1)]
            total += np.outer(w, w).ravel() * area @ (stress * np.transpose(green)).sum(1)
        squares.append(total)
    force = forces[far].sum()
    # a face that turns as a rigid one moves towards the axis by z/2
    ends = -(Z[-1] / 2) @ forces[far + count]
    shorter = (squares[0] + ends) / force, squares[1] / force

    def edge(motion):
        traces = []
        for start in range(0, len(X) - 1, DEGREE):
            ids = number[start : start + DEGREE + 1, -DEGREE - 1 :].ravel()
            B, _ = strain(ids, on_edge)
            stress = B @ np.concatenate([motion[ids], motion[ids + count]]) @ elastic
            traces.append(stress[:, 0] + stress[:, 1])  # a free edge is pulled along itself
        return np.concatenate(traces)

    return Limb(
        *(1 / float(motion @ (K @ motion)) for motion in (turned, swung, pulled)),
        arc=float(2 * (X[-1, 0] - 2 * shorter[0]) / l),
        sway=float(l * shorter[1]),
        turned=edge(turned),
        swung=edge(swung),
        pulled=edge(pulled),
    )


def _columns(e, l, block, rise):
    """Yield columns of elements from the middle of the limb to the end of a block."""
    c, top, length = l / 2, e / 2 + 1, block * (e + 2)
    a = c - 1
    inner, outer = 0.5 * min(a, 1.0), 0.5 * min(length, 1.0)

    def bar(s):
        return (a - inner) * s, a * s, top + 0 * s

    def notch(s, way, lean):
        x, z = np.sin(np.pi / 2 * s), top - np.cos(np.pi / 2 * s)
        return c + way * (x + lean * s**2), c + way * x, z

    def body(s):
        return (
            c + 1 + outer + (length - outer) * s, c + 1 + length * s, top * (1 + 2 * rise * s)
        )  # fmt: skip

    def fine(count, power=1.5):
        return pairwise(np.linspace(0, 1, count + 1) ** power)

    for s, t in reversed(list(fine(max(ALONG // 2, int(a / top) + 1)))):
        yield bar, 1 - t, 1 - s
    for s, t in reversed(list(fine(ALONG))):
        yield (lambda u: notch(1 - u, -1, inner)), 1 - t, 1 - s
    for s, t in fine(ALONG):
        yield (lambda u: notch(u, 1, outer)), s, t
    for s, t in fine(max(ALONG // 2, int(2 * block) + 1)):
        yield body, s, t
