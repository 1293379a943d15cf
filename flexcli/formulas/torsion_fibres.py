"""Longitudinal fibres of a twisted bar: those far from its axis stretch, which stiffens wide bars.

A fibre at the distance r from the axis becomes a helix, longer by ½ r² φ'². A bar whose ends may
come closer shortens until its axial force vanishes; one whose ends are held does not.
"""

import numpy as np

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Numbers, Quantity
from flexcli.results import QuantityKind

__all__ = [
    "CARDS",
    "clamped_rise",
    "clamped_rise_error",
    "fibre_moment",
    "fibre_stress",
    "rectangle_fourth_moment",
]

COMPARED, RISE_ERROR, FARTHER = 0.6, 0.2, 0.4
"""Up to what ρ ``clamped_rise`` is known, its error there as a share of it, and by how much more
for each ρ beyond: plates had 0.13 at most up to ρ = 0.6, 0.36 at 1.2."""


def fibre_stress(
    *, E: Quantity, rate: Quantity, square: Quantity, mean_square: Quantity
) -> Computed:
    """Return the axial stress of a fibre of a twisted bar.

    ``σ = ½ E φ'² (r² − r_m²)``: at the edge of a strip ``E (b φ')²/12`` where the bar may
    shorten, ``E (b φ')²/8`` where it may not.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    rate : Quantity
        Twist per length φ' [rad/m].
    square : Quantity
        Squared distance r² of the fibre from the axis [m²].
    mean_square : Quantity
        Mean of r² over the section, I_p/A, where the bar may shorten; 0 where it may not [m²].

    Returns
    -------
    sigma : Quantity
        Axial stress [Pa].

    Notes
    -----
    Next order in (r φ')²; uniform twist.

    Examples
    --------
    >>> b = 10e-3
    >>> free = fibre_stress(E=114e9, rate=17.45, square=b**2 / 4, mean_square=b**2 / 12)
    >>> round(free / 1e6)
    289

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, chapter 10 (thin strips at large twist);
    Wagner's term.

    """
    return E * rate**2 * (square - mean_square) / 2.0


def clamped_rise(
    *, fibre: Numbers, stiffening: Numbers, h: Numbers, b: Numbers, l: Numbers, free: bool
) -> Computed:
    """Return by how much fibres raise the stress in the clamped corners of a bar that cannot warp.

    ``σ/σ_0 − 1 = μ ρ + γ κ/(1 + 0.25 κ)`` with ``μ = 0.49 + 0.93 y``, less ``0.31 − 0.3 y`` where
    the ends may come closer, ``γ = 0.83 − 0.67 y``, y = b/(b + l), b the broad side.

    Parameters
    ----------
    fibre : Numbers
        ρ, axial stress of the fibre at the edge (``fibre_stress``) over σ_0 [-].
    stiffening : Numbers
        κ, moment of all fibres (``fibre_moment``) over that of small twist [-].
    h, b, l : Numbers
        Sides of the section in either order, and length [m].
    free : bool
        Whether the ends may come closer.

    Returns
    -------
    rise : Numbers
        Rise over the stress σ_0 of restrained warping [-].

    Notes
    -----
    Fibres are as tight at the clamps as at mid-length, and their pull crowds the twist's bending
    there. Fitted to the moments of bending and of tension in clamped ends of von Kármán's plate by
    Ritz's method: l/b from 0.25 to 8, ν from 0 to 0.45, ρ up to 1.2; ``clamped_rise_error``.

    Examples
    --------
    >>> rise = clamped_rise(fibre=0.15, stiffening=0.116, h=0.2e-3, b=6e-3, l=10e-3, free=False)
    >>> round(float(rise), 3)
    0.191

    References
    ----------
    Derived here; Timoshenko & Woinowsky-Krieger (1959), section 100, for the plate.

    """
    near = np.maximum(h, b) / (np.maximum(h, b) + l)
    tight = 0.49 + 0.93 * near - free * (0.31 - 0.3 * near)
    bent = (0.83 - 0.67 * near) / (1.0 + 0.25 * stiffening)
    return tight * fibre + bent * stiffening


def clamped_rise_error(fibre: Numbers) -> Computed:
    """Return how far ``clamped_rise`` may be off, as a share of it.

    ``0.2 + 0.4 (ρ − 0.6)``, the second above ρ = 0.6.

    Examples
    --------
    >>> round(float(clamped_rise_error(1.2)), 2)
    0.44

    """
    return RISE_ERROR + FARTHER * np.maximum(fibre - COMPARED, 0.0)


def fibre_moment(
    *, E: Quantity, rate: Quantity, area: Quantity, fourth: Quantity, mean_square: Quantity
) -> Computed:
    """Return the torque that the long fibres of a twisted bar add to Saint-Venant's.

    ``T = ½ E φ'³ (∫r⁴ dA − A r_m⁴)``: ``E h b⁵ φ'³/360`` for a strip that may shorten and
    ``/160`` for one that may not.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    rate : Quantity
        Twist per length φ' [rad/m].
    area : Quantity
        Area of the section [m²].
    fourth : Quantity
        ∫r⁴ dA about the axis [m⁶].
    mean_square : Quantity
        I_p/A where the bar may shorten; 0 where it may not [m²].

    Returns
    -------
    T : Quantity
        Torque [N·m].

    Examples
    --------
    >>> T = fibre_moment(E=360.0, rate=1.0, area=0.01, fourth=0.01 / 80, mean_square=1 / 12)
    >>> round(T, 9)
    0.01

    References
    ----------
    Moment of the fibres' stresses, inclined by r φ' to the axis.

    """
    return E * rate**3 / 2.0 * (fourth - area * mean_square**2)


def rectangle_fourth_moment(h: Quantity, b: Quantity) -> Computed:
    """Return ∫r⁴ dA of a rectangle about its middle [m⁶].

    ``(b⁵h + bh⁵)/80 + b³h³/72``.

    Examples
    --------
    >>> round(rectangle_fourth_moment(1e-6, 1.0) * 80e6, 6)
    1.0

    """
    return (b**5 * h + b * h**5) / 80.0 + b**3 * h**3 / 72.0


_RATE = {"E": 114e9, "rate": 17.5}
LONG_FIBRES = Range(
    "r θ/l",
    most=0.25,
    why="the fibres farthest from the axis stretch by half the square of it",
    kind=QuantityKind.STRESS,
)

CARDS = (
    Card(
        "long-fibre-stress",
        fibre_stress,
        {**_RATE, "square": 25e-6, "mean_square": 8.33e-6},
        (LONG_FIBRES,),
        kind=QuantityKind.STRESS,
    ),
    Card(
        "long-fibre-torque",
        fibre_moment,
        {**_RATE, "area": 5e-7, "fourth": 6.25e-14, "mean_square": 8.33e-6},
        (LONG_FIBRES,),
    ),
)
