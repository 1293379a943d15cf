"""Elastic contact of a ball with another body: size, pressure, shear, approach.

Smooth, frictionless half-spaces (Hertz); R and E* are those of :mod:`flexcli.formulas.hertz`.
"""

from math import pi
from typing import NamedTuple

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "PointContact", "point_contact", "point_load"]

SHEAR = 0.31
"""Greatest shear below the surface over the peak pressure, for ν = 0.3, at 0.48 a."""


class PointContact(NamedTuple):
    """Radius of the contact and approach [m], peak pressure and greatest shear [Pa]."""

    radius: Quantity
    approach: Quantity
    pressure: Quantity
    shear: Quantity


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
    return PointContact(radius, radius**2 / R, pressure, SHEAR * pressure)


def point_load(*, p: Quantity, R: Quantity, E_star: Quantity) -> Quantity:
    """Return the force that presses a ball on a body with a peak pressure.

    ``F = π³ p³ R²/(6 E*²)``.

    Parameters
    ----------
    p : Quantity
        Peak pressure [Pa].
    R : Quantity
        Relative radius [m].
    E_star : Quantity
        Contact modulus E* [Pa].

    Returns
    -------
    Quantity
        Normal force [N].

    Examples
    --------
    >>> round(point_load(p=85.8e6, R=50e-3, E_star=53.2e9), 2)
    2.88

    References
    ----------
    Johnson (1985), Contact Mechanics, equation (4.24).

    """
    return (pi * p) ** 3 * R**2 / (6.0 * E_star**2)


_BALL = {"R": 50e-3, "E_star": 53.2e9}
_VALIDITY = (
    Range("a/R", most=0.1, why="each body is taken for a half-space"),
    Range("nu", 0.25, 0.35, "0.31 belongs to ν = 0.3; it is 0.32 at 0.25, 0.30 at 0.35"),
)

CARDS: tuple[Card, ...] = (
    Card("point-contact", point_contact, {"F": 2.88, **_BALL}, _VALIDITY),
    Card("point-contact-load", point_load, {"p": 85.8e6, **_BALL}, _VALIDITY),
)
