"""A wide hinge between rigid bodies: the plate of its thickness profile, by Ritz's method.

The plate is clamped where the profile ends and free along its sides. Its deflection is the beam's
and a part that vanishes at the clamps: products of polynomials, along the hinge in a coordinate
that follows the throat.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from flexcli.formulas.profile import Profile
from flexcli.mechanics.hinge_plate import (
    ACROSS,
    Half,
    across_width,
    along_hinge,
    crossed,
    half_of,
    plate_energy,
    products,
)

__all__ = ["ALONG", "LEFT", "SETTLED", "STIFF", "WIDE", "WideHinge", "wide_hinge"]

ALONG = (10, 20, 28)
"""Functions along half of the hinge, as many as it takes."""

SETTLED = 2e-4
"""Change of the stiffness by more functions at which there are enough: of notches these few are,
long fillets at a narrow blade take more."""

LEFT = 1.0
"""Share of the last such change by which the stiffness is less at most: blades of fillets up to
r = 0.47 l had half of it beside solids."""

STIFF = 4.0
"""Lengths over which the throat bends, beyond which a notch is rigid: 1e4 times as stiff."""

WIDE = 10.0
"""Width, in the same lengths, from which on the free sides know nothing of each other."""


class WideHinge(NamedTuple):
    """Stiffness in pure bending over the beam's, and shift of the middle over the beam's [-].

    The stiffness is ``less`` less at most, for want of functions. ``peak`` is the largest stress
    across the width of the throat over its mean: the middle is kept flat, the sides curl.
    """

    stiffness: float
    shift: float
    less: float
    peak: float


@lru_cache(maxsize=512)
def wide_hinge(
    shape: type[Profile], numbers: tuple[float, ...], l: float, b: float, poisson_ratio: float
) -> WideHinge:
    """Return how a wide hinge differs from the beam of its profile.

    Parameters
    ----------
    shape, numbers
        Kind of the profile, symmetric about its middle, and its parameters.
    l, b : float
        Length and width of the hinge [m].
    poisson_ratio : float
        ν [-].

    Returns
    -------
    WideHinge
        Of the same rotation; the mean of the stress over the width is as the stiffness.

    Notes
    -----
    Kirchhoff's plate: thin against the length over which the throat bends. The stiffness is an
    upper bound.

    References
    ----------
    Timoshenko & Woinowsky-Krieger (1959), Theory of Plates and Shells, section 26 (energy); the
    solution is derived here.

    """
    whole = half_of(shape(*numbers), l, l / 2.0)
    bends = 2.0 * float(whole.dx @ (1.0 / whole.d))
    half = half_of(shape(*numbers), l, min(l / 2.0, STIFF * bends), bends)
    used = min(b, WIDE * bends)
    plate = _settled(half, used / bends, poisson_ratio)
    if b <= used or poisson_ratio == 0.0:
        return plate
    # the curl at the sides is what a plate flat all over lacks: its share falls as 1/b
    square, share = poisson_ratio**2, used / b
    curled = (1.0 - (1.0 - 1.0 / plate.stiffness) / square) * share
    stiffness, shift = 1.0 / (1.0 - square * (1.0 - curled)), 1.0 + (plate.shift - 1.0) * share
    peak = 1.0 + (plate.peak - 1.0) * share
    return WideHinge(stiffness, shift, plate.less * share, peak)


def _settled(half: Half, b: float, nu: float) -> WideHinge:
    """Return the solution by as many functions as settle its stiffness."""
    found = _plate(half, b, nu, ALONG[0])
    for along in ALONG[1:]:
        before, found = found, _plate(half, b, nu, along)
        change = abs(before.stiffness - found.stiffness)
        if change <= SETTLED:
            break
    return found._replace(less=LEFT * change)


def _plate(half: Half, b: float, nu: float, count: int) -> WideHinge:
    """Return the solution of a quarter of the plate, by the beam and what it lacks."""
    dx, d, turned = half.dx, half.d, half.slope
    turned_all = float(dx @ (1.0 / d))
    along, (across, weight) = along_hinge(half, count), across_width(b)
    B = products(across, weight)
    K = plate_energy(products(along, d * dx), B, nu)
    # the beam's moment is the same all along: d w_0'' = 1
    load = nu * crossed(along[0] @ dx, across[2] @ weight)
    scale = 1.0 / np.sqrt(np.diag(K))
    c = -scale * np.linalg.solve(K * scale[:, None] * scale, scale * load)
    stiffness = (1.0 + float(load @ c) / turned_all) / (1.0 - nu**2)
    mean = c.reshape(count, ACROSS) @ (across[0] @ weight)
    squares = crossed((along[1] * dx) @ along[1].T, B[0, 0])
    change = 2.0 * float((turned * dx) @ along[1].T @ mean) + float(c @ squares @ c)
    shift = 1.0 - change / float(dx @ (turned_all**2 - turned**2))
    # moments in the throat, where that of the beam is 1
    flat, _, bent = (part[:, 0] for part in along_hinge(half._replace(x=np.zeros(1)), count))
    by = c.reshape(count, ACROSS)
    moments = 1.0 + bent @ by @ across[0] + nu * (flat @ by @ across[2])
    peak = float(np.max(moments) / (weight @ moments))
    return WideHinge(stiffness, shift, 0.0, peak)
