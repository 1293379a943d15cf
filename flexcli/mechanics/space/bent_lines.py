"""Lines of blades and rods between ends that moved, by small motion, and how far off they are.

A blade that nothing loads between its ends has a curvature (a + c s)/I(s) of its profile, which
the places and slopes of its ends tell: a cubic where it is uniform, straight pieces beside thin
hinges.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Constant, Piece, Profile
from flexcli.mechanics.space.layout import SpaceBlade, SpaceRod
from flexcli.mechanics.space.swept_box import Edges, steps_along
from flexcli.numerics.collocation import gauss_nodes, integration_matrix, integration_to

__all__ = ["Ends", "bent_line"]

Floats = NDArray[np.float64]

NODES = 24
"""Gauss nodes on a piece of a profile."""

PLACES = np.linspace(-1.0, 1.0, 25)
"""On each piece."""

SHEARED = 3.2
"""Share of (h/l)² by which shear across the thickness softens an S shape, E/(κ G) at ν = 1/3."""

TWISTED = 0.25
"""Of a blade's whole twist, how far it may be from one that is even, where clamps keep its ends
flat: a blade that is all clamps twists as 3 s² − 2 s³, 0.1 from it."""


class Ends(NamedTuple):
    """Both ends of a blade on its way: places (…, 3) [m], and the blade's axes there (…, 3, 3)."""

    start: Floats
    end: Floats
    first: Floats
    second: Floats


class _Shapes(NamedTuple):
    """Where a line goes of a unit shift across, and a unit slope, of its end; and its slopes.

    All (places,): at places s [m], h thick [m], a ``step`` [m] from those beside it where it bends.
    """

    s: Floats
    h: Floats
    step: Floats
    shift: Floats
    slope: Floats
    shift_rate: Floats
    slope_rate: Floats
    shift_bend: Floats
    slope_bend: Floats


def bent_line(
    blade: SpaceBlade | SpaceRod, ends: Ends, axial: Floats | float
) -> tuple[Edges, Floats]:
    """Return a blade's line and sections, and how far off the line may be (…, places) [m].

    Parameters
    ----------
    blade : SpaceBlade or SpaceRod
        The blade.
    ends : Ends
        Where its ends went.
    axial : float or array
        Share by which axial forces change its bending, shape (…) [-].

    Notes
    -----
    Large slopes leave an elastic line by less than its distance from the chord times the square of
    its largest angle against it, and the share by which axial forces change its bending: elasticae
    of 750 random end forces, turned by up to 0.6 rad, uniform, with two hinges or notched, were off
    by 0.4 of that at most.

    """
    l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
    profile = Constant(blade.d) if isinstance(blade, SpaceRod) else blade.profile
    found = _shapes(profile, l, 3)
    line, along = _line(found, ends, l)
    p, q = ends.start[..., None, :], ends.end[..., None, :]
    chord = (q - p) / np.linalg.norm(q - p, axis=-1, keepdims=True)
    sine = np.linalg.norm(np.cross(along, chord), axis=-1).max(axis=-1)
    away = np.linalg.norm(np.cross(line - p, chord), axis=-1).max(axis=-1)
    w_0, w_1 = ends.first[..., None, 2, :], ends.second[..., None, 2, :]
    s = (found.s / l)[:, None]
    width = (1.0 - s) * w_0 + s * w_1
    across = np.cross(width, along)
    across, width = (x / np.linalg.norm(x, axis=-1, keepdims=True) for x in (across, width))
    share = sine**2 + axial + SHEARED * (float(found.h.max()) / l) ** 2
    inner = 4.0 * s[:, 0] * (1.0 - s[:, 0])
    off = away[..., None] * share[..., None] * inner
    if isinstance(blade, SpaceBlade):
        twist = np.linalg.norm(np.cross(w_0, w_1), axis=-1) * blade.b / 2.0
        off = off + TWISTED * twist * inner
        # across its width it bends by another moment of inertia
        if not isinstance(profile, Constant):
            other = _line(_shapes(profile, l, 1), ends, l)[0]
            off = off + np.abs(((other - line) * width).sum(axis=-1))
    t, u = ends.first[..., None, 0, :], ends.second[..., None, 0, :]
    curve = found.shift_bend[:, None] * (q - p - l * t) + found.slope_bend[:, None] * (u - t)
    kappa = np.linalg.norm(curve, axis=-1)
    return Edges(line, along, across, width, found.h, kappa, found.step), off


def _line(shapes: _Shapes, ends: Ends, l: float) -> tuple[Floats, Floats]:
    """Return the line between ends (…, places, 3) and its direction."""
    p, q = ends.start[..., None, :], ends.end[..., None, :]
    t, u = ends.first[..., None, 0, :], ends.second[..., None, 0, :]
    _, _, _, shift, slope, shift_rate, slope_rate, *_ = (each[:, None] for each in shapes)
    aside, turned = q - p - l * t, u - t
    line = p + shapes.s[:, None] * t + shift * aside + slope * turned
    rate = t + shift_rate * aside + slope_rate * turned
    return line, rate / np.linalg.norm(rate, axis=-1, keepdims=True)


def _shapes(profile: Profile, l: float, power: int) -> _Shapes:
    """Return how a blade bends whose moment of inertia goes with a power of its thickness."""
    x, thin = gauss_nodes(NODES)[0], _thinnest(profile, l)
    inside, onto = integration_matrix(NODES), integration_to(NODES, PLACES)
    slope, place, last = np.zeros(2), np.zeros(2), 0.0
    rows = [np.array([[0.0, thin, *np.zeros(7)]])]
    for piece in profile.pieces(l):
        s, ds = np.ravel(piece.position(PLACES)), np.broadcast_to(piece.slope(x), x.shape)
        place = place + slope * (float(s[0]) - last)
        bends = [_bend(piece, u, l, power, thin) for u in (x, PLACES)]
        rate = bends[0] * ds[:, None]
        turned, there = slope + inside @ rate, slope + onto @ rate
        went = place + onto @ (turned * ds[:, None])
        h = np.broadcast_to(piece.thickness(PLACES), PLACES.shape)
        rows.append(np.column_stack([s, h, steps_along(s[:, None]), went, there, bends[1]]))
        slope, place, last = there[-1], went[-1], float(s[-1])
    place = place + slope * (l - last)
    rows.append(np.array([[l, thin, 0.0, *place, *slope, 0.0, 0.0]]))
    s, h, step, *each = np.concatenate(rows).T
    # shares of both curvatures that shift the end, or turn it, alone
    shares = np.linalg.inv(np.array([place, slope]))
    by_end = [np.column_stack(pair) @ shares for pair in (each[:2], each[2:4], each[4:])]
    return _Shapes(s, h, step, *(column for pair in by_end for column in pair.T))


def _bend(piece: Piece, u: Floats, l: float, power: int, thin: float) -> Floats:
    """Return both curvatures, even and odd, of a moment alone at places of a piece."""
    s = np.ravel(piece.position(u))
    soft = (thin / np.broadcast_to(piece.thickness(u), u.shape)) ** power
    return np.column_stack([soft, soft * (s - l / 2.0) / l])


def _thinnest(profile: Profile, l: float) -> float:
    return min(float(np.min(piece.thickness(PLACES))) for piece in profile.pieces(l))
