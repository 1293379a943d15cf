"""Natural frequencies of a massless cantilever that carries a body beyond its end.

The body has mass m, its centre lies c beyond the blade's end on the blade's axis, and J is its
moment of inertia about that centre. Motion is lateral and small; gravity and shear are left out.
"""

from math import pi
from typing import NamedTuple

import numpy as np

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "TipBody", "joined", "massless_frequencies"]


class TipBody(NamedTuple):
    """Mass [kg], offset of its centre beyond the blade's end [m], central inertia [kg·m²]."""

    m: Quantity
    c: Quantity
    J: Quantity


def joined(first: TipBody, second: TipBody) -> TipBody:
    """Return the body that two bodies make when fixed to each other.

    ``m = m1 + m2``, ``m c = m1 c1 + m2 c2``, ``J = J1 + J2 + m1 m2/m (c1 − c2)²``.

    Parameters
    ----------
    first, second : TipBody
        The bodies, centres on the blade's axis.

    Returns
    -------
    TipBody
        Mass [kg], offset [m] and central inertia [kg·m²].

    Examples
    --------
    >>> joined(TipBody(1.0, 0.0, 0.0), TipBody(1.0, 2.0, 0.5))
    TipBody(m=2.0, c=1.0, J=2.5)

    """
    m = first.m + second.m
    return TipBody(
        m=m,
        c=(first.m * first.c + second.m * second.c) / m,
        J=first.J + second.J + first.m * second.m / m * (first.c - second.c) ** 2,
    )


def massless_frequencies(
    *, E: Quantity, I: Quantity, L: Quantity, m: Quantity, c: Quantity = 0.0, J: Quantity = 0.0
) -> tuple[Quantity, Quantity]:
    """Return both natural frequencies of a massless cantilever with a body beyond its end.

    ``1/ω² = (T ± √(T² − 4D))/2`` with ``T = (m L³/3 + m c L² + (J + m c²) L)/(EI)`` and
    ``D = m J L⁴/(12 (EI)²)``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    I : Quantity
        Second moment of area of the blade [m⁴].
    L : Quantity
        Length of the blade [m].
    m : Quantity
        Mass of the body [kg].
    c : Quantity
        Offset of its centre beyond the blade's end [m].
    J : Quantity
        Moment of inertia about its centre [kg·m²].

    Returns
    -------
    f_1, f_2 : Quantity
        Natural frequencies [Hz]; f_2 is infinite when J is 0.

    Notes
    -----
    Blade far lighter than the body: its mass m_b lowers f_1 by about (33/280) m_b/m when c and J
    are 0, by less otherwise. With c = J = 0 this is √(k/m)/2π.

    Examples
    --------
    >>> f_1, f_2 = massless_frequencies(E=3.0, I=1.0, L=1.0, m=9.0)
    >>> round(float(2 * pi * f_1), 12), float(f_2)
    (1.0, inf)

    References
    ----------
    Two by two eigenproblem of the tip's compliance (Timoshenko 1955, Strength of Materials, Part I)
    with the body's mass matrix about the end.

    """
    flexibility = L / (E * I)
    half_sum = flexibility * (m * (L**2 / 3.0 + c * (L + c)) + J) / 2.0
    product = (flexibility * L) ** 2 * m * J / 12.0
    slow = half_sum + np.sqrt(half_sum**2 - product)  # 1/ω1²
    with np.errstate(divide="ignore"):
        fast = np.sqrt(np.divide(slow, product))  # the other root without cancellation
    return 1.0 / (2.0 * pi * np.sqrt(slow)), fast / (2.0 * pi)


CARDS: tuple[Card, ...] = (
    Card(
        "tip-mass-frequencies",
        massless_frequencies,
        {"E": 69e9, "I": 9.528e-13, "L": 20.5e-3, "m": 9.96e-3, "c": 11.5e-3, "J": 1.9e-6},
        (Range("m_b/m", most=0.1, why="the blade's own mass is left out"),),
    ),
)
