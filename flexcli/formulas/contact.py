"""Hertz's contact of smooth, frictionless half-spaces: a ball, a cylinder along its length."""

from math import pi
from typing import NamedTuple

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Quantity

__all__ = [
    "CARDS",
    "CHORD",
    "LineContact",
    "PointContact",
    "chord_deviation",
    "contact_modulus",
    "line_contact",
    "point_contact",
]


def contact_modulus(*, E_1: Quantity, nu_1: Quantity, E_2: Quantity, nu_2: Quantity) -> Computed:
    """Return the plane-strain modulus of two bodies in contact.

    ``1/E* = (1 − ν1²)/E1 + (1 − ν2²)/E2``.

    Parameters
    ----------
    E_1, E_2 : Quantity
        Young's modulus of each body [Pa]; infinite for a rigid one.
    nu_1, nu_2 : Quantity
        Poisson's ratio of each body [-].

    Returns
    -------
    Quantity
        E* [Pa].

    Examples
    --------
    >>> round(contact_modulus(E_1=70e9, nu_1=0.33, E_2=70e9, nu_2=0.33) / 1e9, 1)
    39.3

    References
    ----------
    Johnson (1985), Contact Mechanics, equation (4.20).

    """
    return 1.0 / ((1.0 - nu_1**2) / E_1 + (1.0 - nu_2**2) / E_2)


LINE_SHEAR = 0.30028310
"""Greatest shear below the surface over the peak pressure, for any ν, at 0.786 a."""


class LineContact(NamedTuple):
    """Half-width of the contact [m], peak pressure and greatest shear [Pa]."""

    half_width: Computed
    pressure: Computed
    shear: Computed


def line_contact(*, F: Quantity, b: Quantity, R: Quantity, E_star: Quantity) -> LineContact:
    """Return the half-width and stresses of a cylinder pressed along its length on a body.

    ``a = √(4 F R/(π b E*))``, ``p = √(F E*/(π b R))``, ``τ = 0.300 p``.

    Parameters
    ----------
    F : Quantity
        Normal force [N], evenly along the line.
    b : Quantity
        Length of the line [m].
    R : Quantity
        Relative radius [m].
    E_star : Quantity
        Contact modulus E* [Pa].

    Returns
    -------
    half_width : Quantity
        Half the width of the contact [m].
    pressure, shear : Quantity
        Peak pressure and greatest shear stress below the surface [Pa].

    Notes
    -----
    Aligned bodies, a ≪ b and R. The approach depends on the bodies' shape and is not given.

    Examples
    --------
    >>> contact = line_contact(F=2.88, b=7.8e-3, R=50e-3, E_star=53.2e9)
    >>> round(contact.half_width * 1e6, 1), round(contact.pressure / 1e6, 2)
    (21.0, 11.18)

    References
    ----------
    Johnson (1985), Contact Mechanics, equations (4.43) and (4.45).

    """
    pressure = (F * E_star / (pi * b * R)) ** 0.5
    return LineContact(2.0 * R * pressure / E_star, pressure, LINE_SHEAR * pressure)


_CYLINDER = {"b": 7.8e-3, "R": 50e-3, "E_star": 53.2e9}
_LINE = (
    Range("a/R", most=0.1, why="each body is taken for a half-space"),
    Range("a/b", most=0.1, why="a line far longer than wide"),
)


POINT_SHEAR = 0.31
"""Greatest shear below the surface over the peak pressure, for ν = 0.3, at 0.48 a."""


class PointContact(NamedTuple):
    """Radius of the contact and approach [m], peak pressure and greatest shear [Pa]."""

    radius: Computed
    approach: Computed
    pressure: Computed
    shear: Computed


def point_contact(*, F: Quantity, R: Quantity, E_star: Quantity) -> PointContact:
    """Return the size, approach and stresses of a ball pressed on a body.

    ``a = (3 F R/(4 E*))^(1/3)``, ``δ = a²/R``, ``p = 3F/(2π a²)``, ``τ = 0.31 p``.

    Parameters
    ----------
    F : Quantity
        Normal force [N].
    R : Quantity
        Relative radius [m].
    E_star : Quantity
        Contact modulus E* [Pa].

    Returns
    -------
    radius, approach : Quantity
        Radius of the contact and approach of the bodies [m].
    pressure, shear : Quantity
        Peak pressure and greatest shear stress below the surface [Pa].

    Notes
    -----
    a ≪ R and the thickness of either body; the factor of τ is that of ν = 0.3.

    Examples
    --------
    >>> contact = point_contact(F=2.88, R=50e-3, E_star=53.2e9)
    >>> round(contact.radius * 1e3, 3), round(contact.pressure / 1e6), round(contact.shear / 1e6, 1)
    (0.127, 86, 26.6)

    References
    ----------
    Johnson (1985), Contact Mechanics, equations (4.22) to (4.24); Monti (2014), section 9.1.3.

    """
    radius = (3.0 * F * R / (4.0 * E_star)) ** (1.0 / 3.0)
    # p = 3F/(2πa²) in the form that is 0, not 0/0, without a force
    pressure = 2.0 * E_star * radius / (pi * R)
    return PointContact(radius, radius**2 / R, pressure, POINT_SHEAR * pressure)


CHORD = 1.1184
"""Indentation of the line over that of the ball, at a force, for which a ball's indentation lies
within 11.9 % of it from that line up to that force: the least of all lines, c³ = c² + 4/27."""


def chord_deviation(share: float) -> float:
    """Return how far a ball's indentation is from a line through none, up to a force.

    ``max |x^(2/3) − r x| = max(4/(27 r²), |1 − r|)`` for 0 ≤ x ≤ 1.

    Parameters
    ----------
    share : float
        r: indentation of the line over that of the ball at the largest force, from 2/3 on [-].

    Returns
    -------
    float
        The largest difference, over the ball's indentation at the largest force [-].

    Examples
    --------
    >>> round(chord_deviation(CHORD), 3)
    0.118

    """
    return max(4.0 / (27.0 * share**2), abs(1.0 - share))


_BALL = {"R": 50e-3, "E_star": 53.2e9}
_POINT = (
    Range("a/R", most=0.1, why="each body is taken for a half-space"),
    Range("nu", 0.25, 0.35, "0.31 belongs to ν = 0.3; it is 0.32 at 0.25, 0.30 at 0.35"),
)


CARDS: tuple[Card, ...] = (
    Card(
        "contact-modulus",
        contact_modulus,
        {"E_1": 70e9, "nu_1": 0.33, "E_2": 70e9, "nu_2": 0.33},
        (Range("nu", -1.0, 0.5),),
    ),
    Card("line-contact", line_contact, {"F": 2.88, **_CYLINDER}, _LINE),
    Card("point-contact", point_contact, {"F": 2.88, **_BALL}, _POINT),
)
