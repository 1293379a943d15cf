"""Fillets at the root of a blade: how far they raise its stress over that of the plain blade."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas import notch
from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Numbers

__all__ = [
    "CARDS",
    "Above",
    "above_bars",
    "axial_factor",
    "bending_factor",
    "factors_above",
    "sheared_peak",
]

ABOVE, ABOVE_SHORT = 0.027, 0.045
"""What the factor along a blade is above that of plane bodies at most, where h ≤ 2 r; the second of
blades less than h between their fillets."""

BENT, BENT_SHARP, BENT_SHORT = 0.0015, 0.0025, 0.005
"""The same of the factor in bending, how much more per h/r beyond 1 (wedges), and of such short
blades."""

CLAMPED, CLAMPED_BENT = (0.6, 0.027, 0.17), (1.0, 0.0015, 0.066)
"""The h/r up to which rigid clamps hardly relieve the peak along a blade and in bending, by what
the factors are above it there, and how much more per h/r beyond; plane bodies had at most 0.073,
0.25, 0.35 and 0.64 along at h/r = 1, 2, 4 and 20, and 0.001, 0.046, 0.2 and 0.46 bent."""

OF_WEDGES = 0.0125
"""How much more that is per h/r beyond 2, of bodies that are hardly twice as high as the fillets: a
plane body of h/r = 20 on a step as high had 0.82 of it."""

CORNER = 0.4555
"""Power of the distance with which stress grows towards a corner of 270°."""

SHEARED, STEEPER, BLUNT, OF_BLUNT = 0.155, 0.77, 2.3, 0.55
"""Of :func:`sheared_peak`: the share of fillets of h = r far apart, its power of h/r, and what
fillets near each other have more."""

EITHER_WAY, REACH, REACH_STEEPER = 0.4, 0.11, 0.4
"""Its error, a share of it; how far beyond the start of a fillet the moment counts at most, over h,
and the power of h/r by which it is more of h > r."""

FITTED, APART = 20.0, 0.5
"""Largest h/r of the fillets that were compared, and how far apart they were, over h; else the
deep notch is taken."""


def bending_factor(*, h: Numbers, l: Numbers, r: Numbers) -> Computed:
    """Return K_t of the bending stress where the fillets of a blade begin on a large body.

    ``K_t = (1 + c x)^0.4555``, c = 0.345 + 0.016/(4 + x²), x = h/r, over the nominal 6M/(b h²).

    Parameters
    ----------
    h, l, r : Numbers
        Thickness, length with both fillets, and radius of these [m].

    Returns
    -------
    K_t : Numbers
        Peak over nominal stress [-].

    Notes
    -----
    Quarter circles; 0 to 0.6 % above plane bodies for h/r up to 7, 2 % to 20, and 0.5 h or more
    between the fillets, under a moment that is the same all along, else see ``sheared_peak``.
    Beyond that Neuber's deep notch, which fillets that meet are and which is above others (19 % at
    h/r = 20). The power is that of the stress in a corner of 270°.

    Examples
    --------
    >>> round(float(bending_factor(h=0.2e-3, l=20e-3, r=0.2e-3)), 3)
    1.146

    References
    ----------
    Fitted here to finite elements for plane bodies, from wedges of 45° to steps twelve times as
    high as the mouth; M. L. Williams (1952), Journal of Applied Mechanics 19, 526–528, for the
    corner.

    """
    x = np.asarray(h, dtype=np.float64) / r
    fitted = (1.0 + (0.345 + 0.016 / (4.0 + x**2)) * x) ** CORNER
    return np.where(_is_fitted(h, l, r), fitted, notch.bending_factor(e=x, r=1.0))[()]


def axial_factor(*, h: Numbers, l: Numbers, r: Numbers) -> Computed:
    """Return K_t of the axial stress where the fillets of a blade begin on a large body.

    ``K_t = (1 + x (0.6 + 0.74 x)/(1 + 0.8 x))^0.4555``, x = h/r, over the nominal N/(b h).

    Parameters
    ----------
    h, l, r : Numbers
        Thickness, length with both fillets, and radius of these [m].

    Returns
    -------
    K_t : Numbers
        Peak over nominal stress [-].

    Notes
    -----
    0 to 1.5 % above plane bodies for h/r up to 20 and 0.5 h or more between the fillets; beyond
    that Neuber's deep notch. Of fillets sharper than h/2 it counts how high the body is: it is that
    of one without end, and :func:`factors_above` says how much less others have.

    Examples
    --------
    >>> round(float(axial_factor(h=0.2e-3, l=20e-3, r=0.2e-3)), 2)
    1.29

    References
    ----------
    Fitted here to finite elements for plane bodies, as :func:`bending_factor`.

    """
    x = np.asarray(h, dtype=np.float64) / r
    fitted = (1.0 + x * (0.6 + 0.74 * x) / (1.0 + 0.8 * x)) ** CORNER
    return np.where(_is_fitted(h, l, r), fitted, notch.axial_factor(e=x, r=1.0))[()]


class Above(NamedTuple):
    """By what share of them peaks of stress may be less than the factors say, bent and along."""

    bent: float
    along: float


def factors_above(
    h: float, l: float, r: float, *, bars: bool = False, clamped: bool = False
) -> Above:
    """Return by what share of it the peak of a stress may be less than these factors say [-].

    In bending ``0.0015 + 0.0025 (h/r − 1)``, along the blade ``0.027 + 0.0125 (h/r − 2)`` where
    positive; in rigid clamps, which keep fillets of h > r from stretching at their foot, 0.0015 +
    0.066 (h/r − 1) and 0.027 + 0.17 (h/r − 0.6); at most 1 − 1/K_t, and that where it was not
    fitted.

    Parameters
    ----------
    h, l, r : float
        Thickness, length with both fillets, and radius of these [m].
    bars : bool
        Whether the bodies may be bars as high as the fillets, not at least twice as high.
    clamped : bool
        Whether they may be rigid where the fillets end.

    Returns
    -------
    bent, along : float
        Of the stress with the factor [-].

    Examples
    --------
    >>> [round(share, 3) for share in factors_above(0.2e-3, 20e-3, 0.2e-3)]
    [0.002, 0.027]

    References
    ----------
    The finite elements of ``axial_factor``, and others of high order for plane bodies on walls, of
    ν from 0 to 0.9.

    """
    x, at = h / r, {"h": h, "l": l, "r": r}
    most = Above(*(1.0 - 1.0 / float(k(**at)) for k in (bending_factor, axial_factor)))
    if not _is_fitted(h, l, r):
        return most
    bent, along = BENT + BENT_SHARP * max(x - 1.0, 0.0), ABOVE
    if l - 2.0 * r < h:
        bent, along = bent + BENT_SHORT, ABOVE_SHORT
    if bars:
        bent, along = (
            1.0 - (1.0 - own) / (1.0 + more)
            for own, more in zip((bent, along), above_bars(x), strict=True)
        )
    else:
        along += OF_WEDGES * max(x - 2.0, 0.0)
    if clamped:
        bent = max(bent, _clamped(x, *CLAMPED_BENT))
        along = max(along, _clamped(x, *CLAMPED))
    return Above(min(bent, most.bent), min(along, most.along))


def _clamped(x: float, freely: float, least: float, more: float) -> float:
    return least + more * max(x - freely, 0.0)


def above_bars(x: float) -> tuple[float, float]:
    """Return by what share a peak may be more than on bars that are as high as the fillets [-].

    ``0.02 (x − 2.5)`` bent and ``0.055 (x − 1.5)`` along the blade, x = h/r, where positive.

    Parameters
    ----------
    x : float
        Thickness over radius of the fillets, to 20, or over the depth of a notch.

    Returns
    -------
    bent, along : float
        Of the stress on bars, that of larger bodies at most [-].

    Examples
    --------
    >>> [round(share, 3) for share in above_bars(6.5)]
    [0.08, 0.275]

    References
    ----------
    Bounds here of finite elements for plane bodies: 0, 0.014, 0.06, 0.20 and 0.32 more bent, 0.01,
    0.13, 0.29, 0.62 and 0.86 along, at x = 2, 4, 7, 14 and 20.

    """
    return 0.02 * max(x - 2.5, 0.0), 0.055 * max(x - 1.5, 0.0)


class Sheared(NamedTuple):
    """What a force across a blade makes of the stress at its fillets beyond its moment's.

    The share ``more`` of that stress, by ``off`` of it more or less [-]; or what its moment is more
    over a ``reach`` [m] at most.
    """

    more: Computed
    off: Computed
    reach: Computed


def sheared_peak(*, h: Numbers, l: Numbers, r: Numbers) -> Sheared:
    """Return by what share a force across the thickness stresses fillets more, and its error.

    ``0.155 x^0.77 G (1 + 2.3 x/(x + 0.55) G)``, x = h/r, G = g/(g + s/2), g = √(h r/3), s straight
    between the fillets: of the stress by the moment that vanishes halfway, in the section.

    Parameters
    ----------
    h, l, r : Numbers
        Thickness, length with both fillets, and radius of these [m].

    Returns
    -------
    more, off : Numbers
        The share and how far it may be off either way [-].
    reach : Numbers
        Beside a moment that is the same all along, the force adds its own over no more than
        0.11 h, and of h > r as much times (h/r)^0.4, to that where the fillet begins [m].

    Notes
    -----
    The peak is not where a fillet begins but in it, where the moment is larger, and the faces rise.
    Of the peaks of a moment all along and of a moment that vanishes halfway the one of both
    together is no more than the sum. h/r 0.05 to 20, a quarter of h or more from halfway to the
    fillets; solids of 45 hinges with h/r to 3, b/h 1 to 40, down to none.

    Examples
    --------
    >>> found = sheared_peak(h=0.2e-3, l=4.4e-3, r=0.2e-3)
    >>> [round(float(each), 4) for each in found[:2]], round(float(found.reach) / 0.2e-3, 2)
    ([0.0091, 0.0037], 0.11)

    References
    ----------
    Fitted here to finite elements of high order for plane bodies: 15 h/r and 7 lengths, on rigid
    and on compliant bodies, each with 13 ratios of both moments.

    """
    h, l, r = (np.asarray(size, dtype=np.float64) for size in (h, l, r))
    x, beside = h / r, np.sqrt(h * r / 3.0)
    near = beside / (beside + np.maximum(l / 2.0 - r, 0.0))
    more = SHEARED * x**STEEPER * near * (1.0 + BLUNT * x / (x + OF_BLUNT) * near)
    return Sheared(more, EITHER_WAY * more, REACH * h * np.maximum(1.0, x) ** REACH_STEEPER)


def _is_fitted(h: Numbers, l: Numbers, r: Numbers) -> NDArray[np.bool_]:
    """Return whether such fillets were compared."""
    h, l, r = (np.asarray(size, dtype=np.float64) for size in (h, l, r))
    return np.asarray((h <= FITTED * r) & (l - 2.0 * r >= APART * h))


_FITTED = (Range("h/r", most=FITTED, why="sharper fillets are taken as deep notches"),)

CARDS: tuple[Card, ...] = (
    Card("fillet-bending", bending_factor, {"h": 0.2e-3, "l": 20e-3, "r": 0.2e-3}, _FITTED),
    Card("fillet-axial", axial_factor, {"h": 0.2e-3, "l": 20e-3, "r": 0.2e-3}, _FITTED),
)
