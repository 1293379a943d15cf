"""Blades joined where they cross, wide or narrow: their stiffness by the energies of all arms.

Every half bears the moment M at the crossing, which falls to M − V x: an arc by its mean, an S by
the rest. Plates stiffen both otherwise, and what pulls a half; they do not stiffen its shear.
"""

from math import pi

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range
from flexcli.formulas.plate_factors import bound
from flexcli.formulas.solid_crossing import (
    ANGLES,
    BEAMS,
    OfHalves,
    arms_in_a_point,
    relieved,
    with_crossing,
)

__all__ = ["CARDS", "joined_plates", "solid_plates", "uneven_line"]

Floats = NDArray[np.float64]

UNEVEN, UNEVEN_AT = 0.065, 0.45
"""Largest part of what plates add by which halves turn unevenly along their line, over (1 − 2c)²,
and the width over the length at which it is."""


def joined_plates(
    *,
    h: ArrayLike,
    l: ArrayLike,
    half_angle: ArrayLike,
    crossing: ArrayLike,
    poisson_ratio: ArrayLike,
    halves: OfHalves = BEAMS,
) -> Floats:
    """Return the stiffness of wide blades that meet in a point, over that of beams there.

    ``8/(a − c)`` of twice the energy of all arms under a moment that is shared, ``a M²``, of which
    the shear in either half relieves ``c M²``; over the same of Timoshenko's beams.

    Parameters
    ----------
    h, l : array_like
        Thickness of a blade, and length from end to end [m].
    half_angle : array_like
        Angle α from the bisector to a blade [rad].
    crossing : array_like
        Share c of the length on the side of the base [-].
    poisson_ratio : array_like
        ν [-].
    halves : OfHalves
        What plates stiffen of either half [-].

    Returns
    -------
    factor : array
        Over the stiffness of beams with bending, shear and stretching [-].

    Examples
    --------
    >>> at = {"h": 0.01, "l": 1.0, "half_angle": pi / 4.0, "crossing": 0.5, "poisson_ratio": 0.3}
    >>> float(joined_plates(**at))
    1.0
    >>> flat = OfHalves((1.1, 1.1), (1.1, 1.1), (1.1, 1.1))
    >>> round(float(joined_plates(**at, halves=flat)), 4)  # but for their shear
    1.0999

    References
    ----------
    Castigliano's theorem on arms of plates.

    """
    at = h, l, half_angle, crossing, poisson_ratio
    return np.asarray(relieved(arms_in_a_point(*at)) / relieved(arms_in_a_point(*at, halves)))


def solid_plates(
    *,
    h: ArrayLike,
    l: ArrayLike,
    half_angle: ArrayLike,
    crossing: ArrayLike,
    poisson_ratio: ArrayLike,
    halves: OfHalves = BEAMS,
    flat: ArrayLike = 1.0,
) -> Floats:
    """Return the stiffness of wide blades of one piece where they cross, over beams in a point.

    As :func:`joined_plates`, with :func:`crossing_compliance` over ``1 + flat ν²/(1 − ν²)``.

    Parameters
    ----------
    h, l, half_angle, crossing, poisson_ratio : array_like
        As :func:`joined_plates` has them.
    halves : OfHalves
        What plates stiffen of either half [-].
    flat : array_like
        How flat the crossing is kept across its width: 0 as in plane stress, 1 as in plane strain
        [-].

    Returns
    -------
    factor : array
        Over the stiffness of beams with bending, shear and stretching [-].

    Notes
    -----
    α from 5° to 85°. Solids (CalculiX, ``tests/benchmarks/crossed_solids.py``) had a crossing as
    flat as the halves beyond it: see :mod:`flexcli.parts.bending.solid_cross`.

    Examples
    --------
    >>> at = {"h": 0.01, "l": 1.0, "half_angle": pi / 4.0, "crossing": 0.5, "poisson_ratio": 0.0}
    >>> round(float(solid_plates(**at)), 4)
    1.0164

    References
    ----------
    Castigliano's theorem on arms of plates and their crossing.

    """
    at = h, l, half_angle, crossing, poisson_ratio
    nu, held = (np.asarray(each, dtype=np.float64) for each in (poisson_ratio, flat))
    plane, stiffer = nu + held * (nu / (1.0 - nu) - nu), 1.0 + held * bound(nu)
    solid = with_crossing(arms_in_a_point(*at, halves), half_angle, plane, stiffer)
    return np.asarray(relieved(arms_in_a_point(*at)) / relieved(solid))


def uneven_line(*, b: ArrayLike, l: ArrayLike, crossing: ArrayLike) -> Floats:
    """Return what halves that turn unevenly along their line take of what plates stiffen.

    ``0.26 (1 − 2c)² y/(1 + y)²``, y = (b/0.45 l)²: one half would turn in mid-width otherwise than
    the other at a given moment.

    Parameters
    ----------
    b, l : array_like
        Width, and length from end to end [m].
    crossing : array_like
        Share c of the length on the side of the base [-].

    Returns
    -------
    share : array
        Of the factor less one [-].

    Notes
    -----
    Within half of it and the errors of the factors: b/l from 0.02 to 6, c from 0.1 on, ν ≤ ½;
    nearer to an end up to 0.04 more, or all of it less.

    Examples
    --------
    >>> float(uneven_line(b=0.4, l=1.0, crossing=0.5))
    0.0
    >>> round(float(uneven_line(b=0.4, l=1.0, crossing=0.1)), 3)
    0.041

    References
    ----------
    Thin plates held on a line, by Ritz's method (``tests/plates/crossed_strip.py``).

    """
    y = (np.asarray(b) / np.asarray(l) / UNEVEN_AT) ** 2
    uneven = (1.0 - 2.0 * np.asarray(crossing, dtype=np.float64)) ** 2
    return np.asarray(4.0 * UNEVEN * uneven * y / (1.0 + y) ** 2)


_ANGLES = (Range("half_angle", *ANGLES, unit="rad", why="computed and fitted between these"),)
_BLADES = {
    "h": 0.1e-3, "l": 17.5e-3, "half_angle": pi / 4.0, "crossing": 0.3, "poisson_ratio": 0.3,
}  # fmt: skip

CARDS = (
    Card("solid-plates", solid_plates, {**_BLADES, "flat": 0.5}, _ANGLES),
    Card("uneven-line", uneven_line, {"b": 10e-3, "l": 17.5e-3, "crossing": 0.3}),
)
