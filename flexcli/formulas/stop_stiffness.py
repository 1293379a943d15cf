"""Stiffness of a cantilever at its tip, free and resting on a stop at height L_a.

The stop touches the blade at L_a from its clamped end and leaves L_b = L − L_a above it. It is
rigid, touches at a point and has no friction; the load is a lateral force at the tip.
"""

from math import sqrt

import numpy as np

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Numbers, Quantity

__all__ = [
    "CARDS",
    "bent_shape",
    "contact_stiffness",
    "free_stiffness",
    "height_share",
    "stiffness_ratio",
]

SLENDER = Range("L/h", 10.0, why="shear is left out; it matters most for a short overhang L_b/h")


def bent_shape(share: Quantity) -> Computed:
    """Return the deflection of a tip-loaded cantilever at x, over that of its tip.

    ``φ(a) = a² (3 − a)/2`` with ``a = x/L``. It is also the share of the tip's speed at x while
    the blade moves in this shape.

    Parameters
    ----------
    share : Quantity
        Height over length, a = x/L [-], 0 ≤ a ≤ 1.

    Returns
    -------
    Quantity
        Deflection over that of the tip [-].

    Examples
    --------
    >>> bent_shape(0.5)
    0.3125

    References
    ----------
    Monti (2014), section 4.1.3, δ_Ix.

    """
    return share**2 * (3.0 - share) / 2.0


def free_stiffness(*, E: Quantity, I: Quantity, L: Quantity) -> Computed:
    """Return the stiffness of a cantilever to a lateral force at its tip.

    ``k_free = 3 E I/L³``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    I : Quantity
        Second moment of area [m⁴].
    L : Quantity
        Length [m].

    Returns
    -------
    Quantity
        Stiffness at the tip [N/m].

    Examples
    --------
    >>> free_stiffness(E=3.0, I=1.0, L=3.0)
    0.3333333333333333

    References
    ----------
    Monti (2014), section 5.3.2, k_free.

    """
    return 3.0 * E * I / L**3


def contact_stiffness(*, E: Quantity, I: Quantity, L_a: Quantity, L_b: Quantity) -> Computed:
    """Return the stiffness at the tip of a cantilever that rests on a stop at height L_a.

    ``k_contact = 12 E I/(L_b² (3 L_a + 4 L_b))``: the propped overhang's.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    I : Quantity
        Second moment of area [m⁴].
    L_a, L_b : Quantity
        Length below and above the stop [m].

    Returns
    -------
    Quantity
        Stiffness at the tip [N/m].

    Notes
    -----
    Rigid stop. The source writes the same denominator as 4L³ − 3L L_a(2L_a + 3L_b) +
    L_a²(2L_a + 3L_b), which cancels to nothing as the stop nears the tip; this form does not.

    Examples
    --------
    >>> round(contact_stiffness(E=60e9, I=1.2695e-12, L_a=25.65e-3, L_b=2.85e-3) / 1e6, 3)
    1.274

    References
    ----------
    Monti (2014), section 5.3.2, k_contact.

    """
    return 12.0 * E * I / (L_b**2 * (3.0 * L_a + 4.0 * L_b))


def stiffness_ratio(*, L_a: Quantity, L_b: Quantity) -> Computed:
    """Return how much stiffer a cantilever is at its tip when it rests on a stop.

    ``π1 = k_contact/k_free = 4 (L_a + L_b)³/(L_b² (3 L_a + 4 L_b))``.

    Parameters
    ----------
    L_a, L_b : Quantity
        Length below and above the stop [m].

    Returns
    -------
    Quantity
        Ratio of the stiffnesses [-], 1 for a stop at the clamped end.

    Examples
    --------
    >>> round(stiffness_ratio(L_a=0.5, L_b=0.5), 3)
    4.571

    References
    ----------
    Monti (2014), table 5.2, π1.

    """
    return 4.0 * (L_a + L_b) ** 3 / (L_b**2 * (3.0 * L_a + 4.0 * L_b))


def height_share(pi_1: Numbers) -> Computed:
    """Return the height over length of the stop that makes a cantilever π1 times stiffer.

    ``L_a/L = 1 + 2 sin²(ψ/3) − √3 sin(2ψ/3)`` with ``tan ψ = 1/√(π1 − 1)``: the root of
    ``(1 − a)² (4 − a) = 4/π1`` in closed form.

    Parameters
    ----------
    pi_1 : Quantity
        Stiffness in contact over free stiffness [-], at least 1.

    Returns
    -------
    Quantity
        Height of the stop over the blade's length [-].

    Raises
    ------
    ValueError
        When π1 is below 1: a stop only stiffens.

    Examples
    --------
    >>> round(float(height_share(4.0 / 0.875)), 12)
    0.5

    References
    ----------
    Inverse of :func:`stiffness_ratio`, a cubic with three real roots (Cardano, trigonometric form).

    """
    (ratio,) = positive(pi_1=pi_1)
    if (ratio < 1.0).any():
        raise ValueError(f"pi_1 must be at least 1, a stop only stiffens: got {ratio.min():g}")
    angle = np.arctan2(1.0, np.sqrt(ratio - 1.0))
    return 1.0 + 2.0 * np.sin(angle / 3.0) ** 2 - sqrt(3.0) * np.sin(2.0 * angle / 3.0)


_PIEZO = {"E": 60e9, "I": 1.2695e-12}

CARDS: tuple[Card, ...] = (
    Card("bent-shape", bent_shape, {"share": 0.5}, (Range("x/L", 0.0, 1.0),)),
    Card(
        "stopped-cantilever-stiffness",
        contact_stiffness,
        {**_PIEZO, "L_a": 25.65e-3, "L_b": 2.85e-3},
        (SLENDER, Range("L_b/h", 2.0, why="shear of the overhang is left out")),
    ),
    Card("stop-stiffness-ratio", stiffness_ratio, {"L_a": 25.65e-3, "L_b": 2.85e-3}, (SLENDER,)),
    Card("stop-height-share", height_share, {"pi_1": 129.0}, (Range("pi_1", 1.0),)),
)
