"""Stress concentration in the throat of a notch hinge, in bending and along it.

The factor K_t multiplies the nominal stress, 6M/(b e²) or N/(b e). In bending it falls to 1 as
the notch grows against the throat: below 5 % for r > 5 e. (The lecture prints the rule as
r < 5 h_min, which is the wrong way round.)
"""

import numpy as np

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Quantity
from flexcli.numerics.quadrature import gauss_rule

__all__ = ["CARDS", "axial_factor", "bending_factor", "fitted_bending_factor"]

_NODES = 24
"""Enough for full digits up to e/r = 10, where the nearest pole is 0.45 from the interval."""


def bending_factor(*, e: Quantity, r: Quantity) -> Quantity:
    """Return the stress concentration factor of two deep opposite notches in bending.

    ``K_t = 4 a√a / (3 (√a + (a − 1) arctan √a))`` with ``a = e/(2r)``; 1 + e/(5r) for a thin
    throat.

    Parameters
    ----------
    e, r : Quantity
        Thickness of the throat and radius of curvature of the notches there [m]; numbers only.

    Returns
    -------
    K_t : Quantity
        Highest stress over 6M/(b e²) [-].

    Notes
    -----
    Exact (plane elasticity) for hyperbolic notches without end, hence for any notch much deeper
    than its throat is thick: e/r up to about 1 for a right-circular one. The denominator is
    evaluated as ``a√a ∫(1 + u²)/(1 + a u²) du`` over 0 < u < 1, which keeps its digits as a → 0.

    Examples
    --------
    >>> [round(float(bending_factor(e=e, r=1.0)), 4) for e in (0.025, 0.2, 1.0)]
    [1.005, 1.0391, 1.1804]

    References
    ----------
    Neuber (1958), Kerbspannungslehre, deep notch on both sides in bending; Pilkey (1997),
    Peterson's Stress Concentration Factors, chapter 2 (hyperbolic notches).

    """
    a = np.asarray(e / (2.0 * r), dtype=np.float64)[..., None]
    u, weights = gauss_rule(_NODES)
    return 4.0 / 3.0 / ((1.0 + u**2) / (1.0 + a * u**2) @ weights)


def axial_factor(*, e: Quantity, r: Quantity) -> Quantity:
    """Return the stress concentration factor of two deep opposite notches in tension.

    ``K_t = 2 (a + 1)√a / ((a + 1) arctan √a + √a)`` with ``a = e/(2r)``; 1 + e/(3r) for a thin
    throat.

    Parameters
    ----------
    e, r : Quantity
        Thickness of the throat and radius of curvature of the notches there [m]; numbers only.

    Returns
    -------
    K_t : Quantity
        Highest stress over N/(b e) [-].

    Notes
    -----
    As for :func:`bending_factor`; the denominator is evaluated as
    ``√a ((a + 1) ∫ du/(1 + a u²) + 1)`` over 0 < u < 1.

    Examples
    --------
    >>> [round(float(axial_factor(e=e, r=1.0)), 4) for e in (0.025, 0.2, 1.0)]
    [1.0083, 1.0652, 1.3012]

    References
    ----------
    Neuber (1958), Kerbspannungslehre, deep notch on both sides in tension; Pilkey (1997),
    Peterson's Stress Concentration Factors, chapter 2 (hyperbolic notches).

    """
    a = np.asarray(e / (2.0 * r), dtype=np.float64)
    u, weights = gauss_rule(_NODES)
    arc = 1.0 / (1.0 + a[..., None] * u**2) @ weights
    return 2.0 * (a + 1.0) / ((a + 1.0) * arc + 1.0)


def fitted_bending_factor(*, e: Quantity, r: Quantity) -> Quantity:
    """Return the stress concentration factor of a right-circular notch hinge, as fitted.

    ``K_t = (2.7 e + 5.4 r)/(8 r + e) + 0.325``.

    Parameters
    ----------
    e, r : Quantity
        Thickness of the throat and radius of the notches [m]; numbers only.

    Returns
    -------
    K_t : Quantity
        Highest stress over 6M/(b e²) [-].

    Notes
    -----
    0 < e < 2.3 r.

    Examples
    --------
    >>> [round(fitted_bending_factor(e=e, r=1.0), 4) for e in (0.025, 0.2, 1.0)]
    [1.0063, 1.0494, 1.225]

    References
    ----------
    Smith & Chetwynd (1992), Foundations of Ultraprecision Mechanism Design, chapter 4 (notch
    hinge); Smith, Chetwynd & Bowen (1987), Journal of Physics E 20(8), 977–983.

    """
    return (2.7 * e + 5.4 * r) / (8.0 * r + e) + 0.325


_NOTCH = {"e": 100e-6, "r": 4e-3}

CARDS: tuple[Card, ...] = (
    Card(
        "notch-stress-concentration",
        bending_factor,
        _NOTCH,
        (Range("e/r", 0.0, 1.0, "notch deep against the throat"),),
    ),
    Card(
        "notch-stress-concentration-axial",
        axial_factor,
        _NOTCH,
        (Range("e/r", 0.0, 1.0, "notch deep against the throat"),),
    ),
    Card(
        "notch-stress-concentration-fit",
        fitted_bending_factor,
        _NOTCH,
        (Range("e/r", 0.0, 2.3, "range of the fit"),),
    ),
)
