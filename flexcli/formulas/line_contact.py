"""Elastic contact of a cylinder along its length with another body: size, pressure, shear.

Smooth, frictionless half-spaces (Hertz); R and E* are those of :mod:`flexcli.formulas.hertz`.
"""

from math import pi
from typing import NamedTuple

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "LineContact", "line_contact", "line_load"]

SHEAR = 0.30028310
"""Greatest shear below the surface over the peak pressure, for any ν, at 0.786 a."""


class LineContact(NamedTuple):
    """Half-width of the contact [m], peak pressure and greatest shear [Pa]."""

    half_width: Quantity
    pressure: Quantity
    shear: Quantity


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
    return LineContact(2.0 * R * pressure / E_star, pressure, SHEAR * pressure)


def line_load(*, p: Quantity, b: Quantity, R: Quantity, E_star: Quantity) -> Quantity:
    """Return the force that presses a cylinder on a body with a peak pressure.

    ``F = π b R p²/E*``.

    Parameters
    ----------
    p : Quantity
        Peak pressure [Pa].
    b : Quantity
        Length of the line [m].
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
    >>> round(line_load(p=11.18e6, b=7.8e-3, R=50e-3, E_star=53.2e9), 2)
    2.88

    References
    ----------
    Johnson (1985), Contact Mechanics, equation (4.45).

    """
    return pi * b * R * p**2 / E_star


_CYLINDER = {"b": 7.8e-3, "R": 50e-3, "E_star": 53.2e9}
_VALIDITY = (
    Range("a/R", most=0.1, why="each body is taken for a half-space"),
    Range("a/b", most=0.1, why="a line far longer than wide"),
)

CARDS: tuple[Card, ...] = (
    Card("line-contact", line_contact, {"F": 2.88, **_CYLINDER}, _VALIDITY),
    Card("line-contact-load", line_load, {"p": 11.18e6, **_CYLINDER}, _VALIDITY),
)
