"""Fillets at the root of a blade: how far they raise its stress over that of the plain blade."""

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas import notch
from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Numbers

__all__ = ["CARDS", "axial_factor", "bending_factor", "factors_above"]

ABOVE, ABOVE_SHORT = 0.027, 0.045
"""What the factor along a blade is above that of plane bodies at most, where it was fitted; the
second of blades less than h between their fillets."""

FITTED, APART = 20.0, 0.5
"""Largest h/r of the fillets that were compared, and how far apart they were, over h; else the
deep notch is taken."""


def bending_factor(*, h: Numbers, l: Numbers, r: Numbers) -> Computed:
    """Return K_t of the bending stress where the fillets of a blade begin on a large body.

    ``K_t = (1 + 0.355 x/(1 + 0.0084 x))^0.4555``, x = h/r, over the nominal 6M/(b h²).

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
    Quarter circles; 0 to 0.3 % above plane bodies for h/r up to 20 and 0.5 h or more between the
    fillets. Beyond that Neuber's deep notch, which fillets that meet are and which is above others
    (19 % at h/r = 20). The power is that of the stress in a corner of 270°.

    Examples
    --------
    >>> round(float(bending_factor(h=0.2e-3, l=20e-3, r=0.2e-3)), 3)
    1.147

    References
    ----------
    Fitted here to finite elements of high order for plane bodies; M. L. Williams (1952), Journal of
    Applied Mechanics 19, 526–528, for the corner.

    """
    x = np.asarray(h, dtype=np.float64) / r
    fitted = (1.0 + 0.355 * x / (1.0 + 0.0084 * x)) ** 0.4555
    return np.where(_is_fitted(h, l, r), fitted, notch.bending_factor(e=x, r=1.0))[()]


def axial_factor(*, h: Numbers, l: Numbers, r: Numbers) -> Computed:
    """Return K_t of the axial stress where the fillets of a blade begin on a large body.

    ``K_t = (1 + 0.49 x/(1 + 0.053 x))^0.675``, x = h/r, over the nominal N/(b h).

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
    0 to 2.5 % above plane bodies for h/r up to 20 and 0.5 h or more between the fillets; beyond
    that Neuber's deep notch.

    Examples
    --------
    >>> round(float(axial_factor(h=0.2e-3, l=20e-3, r=0.2e-3)), 2)
    1.29

    References
    ----------
    Fitted here to finite elements of high order for plane bodies.

    """
    x = np.asarray(h, dtype=np.float64) / r
    fitted = (1.0 + 0.49 * x / (1.0 + 0.053 * x)) ** 0.675
    return np.where(_is_fitted(h, l, r), fitted, notch.axial_factor(e=x, r=1.0))[()]


def factors_above(h: float, l: float, r: float) -> float:
    """Return by what share of it the peak of a stress may be less than these factors say [-].

    ``min(0.027, 1 − 1/K_t)`` of the factor along the blade, which is the less sure of both, 0.045
    with less than h between the fillets; where it was not fitted, no peak at all.

    Parameters
    ----------
    h, l, r : float
        Thickness, length with both fillets, and radius of these [m].

    Returns
    -------
    share : float
        Of the stress with the factor [-].

    Examples
    --------
    >>> round(factors_above(0.2e-3, 20e-3, 0.2e-3), 3), round(factors_above(0.01, 2.0, 0.24), 3)
    (0.027, 0.014)

    References
    ----------
    The finite elements of ``axial_factor``.

    """
    least = 1.0 - 1.0 / float(axial_factor(h=h, l=l, r=r))
    above = ABOVE if l - 2.0 * r >= h else ABOVE_SHORT
    return min(above, least) if _is_fitted(h, l, r) else least


def _is_fitted(h: Numbers, l: Numbers, r: Numbers) -> NDArray[np.bool_]:
    """Return whether such fillets were compared."""
    h, l, r = (np.asarray(size, dtype=np.float64) for size in (h, l, r))
    return np.asarray((h <= FITTED * r) & (l - 2.0 * r >= APART * h))


_FITTED = (Range("h/r", most=FITTED, why="sharper fillets are taken as deep notches"),)

CARDS: tuple[Card, ...] = (
    Card("fillet-bending", bending_factor, {"h": 0.2e-3, "l": 20e-3, "r": 0.2e-3}, _FITTED),
    Card("fillet-axial", axial_factor, {"h": 0.2e-3, "l": 20e-3, "r": 0.2e-3}, _FITTED),
)
