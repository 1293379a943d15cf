"""A cross-spring pivot against the symmetric one of the same blades, and its admissible stroke."""

from math import pi, sqrt

import numpy as np

from flexcli.formulas.card import SLENDER, SMALL_ROTATION, Card, Table
from flexcli.formulas.pivot import end_stresses, parasitic_shift
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "WITTRICK", "admissible_rotation", "stiffness_ratio", "stroke_ratio"]

WITTRICK = (sqrt(45.0) - 9.0) / 18.0
"""δ = −0.1273… at which the leading term of the parasitic shift vanishes: 9δ² + 9δ + 1 = 0."""


def admissible_rotation(
    *, E: float, h: Quantity, l: Quantity, p: Quantity, stress: float
) -> Quantity:
    """Return the rotation at which the larger of the two end stresses reaches a given one.

    ``θ = σ l / (E h max(|2 + 3δ|, |1 + 3δ|))``. Both ends count: the course's formula takes the
    inner one, which is the larger for δ > −½ only.

    Parameters
    ----------
    E : float
        Young's modulus [Pa].
    h, l : Quantity
        Thickness and length of a blade [m]; floats or arrays.
    p : Quantity
        Distance from the centre to the inner ends [m], negative when the blades cross.
    stress : float
        Admissible stress σ [Pa].

    Returns
    -------
    theta : Quantity
        Admissible rotation [rad].

    Examples
    --------
    >>> theta = admissible_rotation(E=1.0, h=1.0, l=50.0, p=-25.0, stress=4e-3)
    >>> round(float(theta), 6)
    0.4

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", generalised cross-spring pivot
    (inner end).

    """
    inner, outer = end_stresses(E=E, h=h, l=l, p=p, theta=1.0)
    return stress / np.maximum(np.abs(inner), np.abs(outer))


def stiffness_ratio(delta: Quantity) -> Quantity:
    """Return the stiffness of a cross-spring pivot over that of the symmetric one.

    ``4 (3δ² + 3δ + 1)``, for the same blades: 2.667 at Wittrick's crossing, where the course
    prints about 3.3.

    Parameters
    ----------
    delta : Quantity
        δ = p/l [-].

    Returns
    -------
    ratio : Quantity
        Ratio of stiffness, 1 at δ = −½ [-].

    Examples
    --------
    >>> round(stiffness_ratio(WITTRICK), 4)
    2.6667

    References
    ----------
    From the stiffness in Henein & Thalmann, lecture "Dimensioning of flexure joints".

    """
    return 4.0 * (3.0 * delta * (delta + 1.0) + 1.0)


def stroke_ratio(delta: Quantity) -> Quantity:
    """Return the admissible rotation of a cross-spring pivot over that of the symmetric one.

    ``½ / max(|2 + 3δ|, |1 + 3δ|)``, for the same blades and stress: 1/3.236 at Wittrick's
    crossing, where the course prints 1/3.2.

    Parameters
    ----------
    delta : Quantity
        δ = p/l [-].

    Returns
    -------
    ratio : Quantity
        Ratio of admissible rotations, 1 at δ = −½ [-].

    Examples
    --------
    >>> round(float(1.0 / stroke_ratio(WITTRICK)), 4)
    3.2361

    References
    ----------
    From the stress in Henein & Thalmann, lecture "Dimensioning of flexure joints".

    """
    return 0.5 / np.maximum(np.abs(2.0 + 3.0 * delta), np.abs(1.0 + 3.0 * delta))


_DELTA = Table(
    variable="delta",
    values=tuple(sorted((WITTRICK, -1.0 - WITTRICK, *(n / 10.0 for n in range(-15, 11))))),
    columns={
        "K l/(E I)": ("", lambda delta: 8.0 * (3.0 * delta * (delta + 1.0) + 1.0)),
        "theta_max": (
            "rad",
            lambda delta: admissible_rotation(E=1.0, h=1.0, l=50.0, p=50.0 * delta, stress=4e-3),
        ),
        "shift/l": (
            "",
            lambda delta: parasitic_shift(l=1.0, p=delta, theta=pi / 12.0, half_angle=pi / 4.0),
        ),
        "stiffness ratio": ("", stiffness_ratio),
        "stroke ratio": ("", stroke_ratio),
    },
    note="σ/E = 0.4 %, l/h = 50; shift at 15° with α = 45°; ratios to δ = −½. Where the shift's "
    "leading term vanishes (δ = −0.1273, −0.8727) the next order in θ rules",
)

CARDS = (
    Card(
        "pivot-stroke",
        admissible_rotation,
        {"E": 114e9, "h": 637e-6, "l": 17.5e-3, "p": 2e-3, "stress": 200e6},
        (SLENDER, SMALL_ROTATION),
        {"delta": _DELTA},
    ),
    Card("stiffness-over-symmetric", stiffness_ratio, {"delta": WITTRICK}),
    Card("stroke-over-symmetric", stroke_ratio, {"delta": WITTRICK}),
)
