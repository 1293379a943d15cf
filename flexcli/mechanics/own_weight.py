"""Blades that weigh something: what an acceleration makes them put on bodies, and bends in them."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import per_design
from flexcli.mechanics.layout import Blade, Layout, Load
from flexcli.mechanics.mesh import column

__all__ = [
    "POINTS",
    "HeldBlade",
    "blade_places",
    "direction",
    "held_blade",
    "weights_on_bodies",
]

Floats = NDArray[np.float64]

POINTS = 257
"""Places along each piece of a blade at which its stress is looked at: the greatest stress of a
notch, which lies beside its throat, is found to some 1e-6."""


class HeldBlade(NamedTuple):
    """A blade between fixed ends under an acceleration of its mass of 1 m/s².

    ``moment`` [N·m] and ``pull`` [N] are (designs or 1, places), of an acceleration across the
    blade (to the left of the way from start to end) and of one along it. ``across`` (2, 2) are
    force [N] and moment [N·m] on what holds the start, then the end; ``along`` (2,) the forces.
    ``thickness`` is that at the places [m], ``steps`` are the lengths between them, none where it
    is rigid [m]; ``softness`` is E over the force that buckles it, if it is uniform [1/m²]. Each
    has designs first.
    """

    moment: Floats
    pull: Floats
    across: Floats
    along: Floats
    thickness: Floats
    steps: Floats
    softness: Floats


def blade_places(blade: Blade, l: float | Floats) -> tuple[Floats, Floats]:
    """Return places along the flexible pieces of a blade of length l and thickness there [m]."""
    u = np.linspace(-1.0, 1.0, POINTS)
    pieces = blade.profile.pieces(per_design(l))
    each = [(piece.position(u), piece.thickness(u)) for piece in pieces]
    shape = np.broadcast_shapes(u.shape, *(np.shape(values) for both in each for values in both))
    position, thickness = (
        np.concatenate([np.broadcast_to(values, shape) for values in along], axis=-1)
        for along in zip(*each, strict=True)
    )
    return position, thickness


def held_blade(blade: Blade, density: float) -> HeldBlade:
    """Return what its own mass does in a blade whose ends are held.

    With W the mass from the start to a place and S its integral, an acceleration across makes
    M = S − k₀ − k₁ s, of which the curvature M/EI neither turns nor shifts the ends; one along
    makes N = n₀ − W, which does not stretch the blade. What is rigid between flexible pieces has
    no stated thickness and so no mass.

    Parameters
    ----------
    blade : Blade
        The blade; its sizes may be arrays over designs.
    density : float
        Density [kg/m³].

    Notes
    -----
    By Euler and Bernoulli (shear changes the moments of an uneven blade alone), and by trapezoids:
    1e-4 of the greatest moment. A uniform blade has w l²/12 at its ends.

    """
    x, y = (column(b) - column(a) for a, b in zip(blade.start, blade.end, strict=True))
    l = np.hypot(x, y)
    s, h = np.broadcast_arrays(*map(np.atleast_2d, blade_places(blade, l)))
    b = column(blade.b)[:, None]
    ds = np.diff(s)
    flexible = ds.copy()
    flexible[:, POINTS - 1 :: POINTS] = 0.0
    W = _integral(density * b * (h[:, 1:] + h[:, :-1]) / 2.0 * flexible)
    S = _integral((W[:, 1:] + W[:, :-1]) / 2.0 * ds)
    start, end = np.zeros((1, 1)), l[:, None]
    c, share = 1.0 / (b * h**3 / 12.0), s / end

    def over(values: Floats) -> Floats:
        return np.asarray(np.sum((values[:, 1:] + values[:, :-1]) / 2.0 * flexible, axis=1))

    c_0, c_1, c_2 = over(c), over(c * share), over(c * share**2)
    S_0, S_1 = over(c * S), over(c * S * share)
    whole = c_0 * c_2 - c_1**2
    k_0, k_1 = (S_0 * c_2 - S_1 * c_1) / whole, (S_1 * c_0 - S_0 * c_1) / whole / l
    n_0 = over(W / h) / over(1.0 / h)
    mass = W[:, -1]
    first = S[:, -1] + mass * (l - s[:, -1])  # beyond the last place nothing weighs

    def line(at: Floats) -> Floats:
        return np.asarray(k_0[:, None] + k_1[:, None] * at)

    ends = np.stack(
        [
            np.stack([k_1, -line(start)[:, 0]], axis=-1),
            np.stack([mass - k_1, line(end)[:, 0] - first], axis=-1),
        ],
        axis=1,
    )
    along = np.stack([n_0, mass - n_0], axis=-1)
    softness = l * c_0 / (4.0 * np.pi**2)
    return HeldBlade(S - line(s), n_0[:, None] - W, ends, along, h, flexible, softness)


def _integral(steps: Floats) -> Floats:
    """Return the sums of what each step adds, from nothing at the start (designs, places)."""
    return np.concatenate([np.zeros((len(steps), 1)), np.cumsum(steps, axis=1)], axis=1)


def weights_on_bodies(layout: Layout, density: float, x: Floats, y: Floats) -> list[Load]:
    """Return what blades that are accelerated put on the bodies which they join.

    Parameters
    ----------
    layout : Layout
        Bodies and blades.
    density : float
        Density of the blades [kg/m³].
    x, y : array
        Acceleration that acts on all mass (designs,) [m/s²].

    """
    bodies, found = {body.name for body in layout.bodies}, list[Load]()
    for blade in layout.blades:
        held = held_blade(blade, density)
        c, s = direction(blade)
        left, ahead = c * y - s * x, c * x + s * y
        each = ((blade.first, blade.start), (blade.second, blade.end))
        for end, (body, point) in enumerate(each):
            if body not in bodies:
                continue
            along, across = held.along[:, end] * ahead, held.across[:, end, 0] * left
            force = (c * along - s * across, s * along + c * across)
            found.append(Load(body, point, force, held.across[:, end, 1] * left))
    return found


def direction(blade: Blade) -> tuple[Floats, Floats]:
    """Return cosine and sine of the way from the start of a blade to its end (designs or 1,)."""
    x, y = (column(b) - column(a) for a, b in zip(blade.start, blade.end, strict=True))
    l = np.hypot(x, y)
    return x / l, y / l
