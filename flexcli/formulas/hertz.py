"""Elastic bodies in contact: the modulus and radius that Hertz' formulas take for both."""

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "contact_modulus", "relative_radius"]


def contact_modulus(*, E_1: Quantity, nu_1: Quantity, E_2: Quantity, nu_2: Quantity) -> Quantity:
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


def relative_radius(R_1: Quantity, R_2: Quantity) -> Quantity:
    """Return the relative radius of two balls, or of two parallel cylinders, in contact.

    ``1/R = 1/R1 + 1/R2``: for a ball on a flat (R2 infinite) the ball's own.

    Parameters
    ----------
    R_1, R_2 : Quantity
        Radius of each body [m]; infinite for a flat, negative for a hollow.

    Returns
    -------
    Quantity
        R [m].

    Examples
    --------
    >>> relative_radius(2.0, 2.0), relative_radius(0.05, float("inf"))
    (1.0, 0.05)

    References
    ----------
    Johnson (1985), Contact Mechanics, equation (4.3).

    """
    return 1.0 / (1.0 / R_1 + 1.0 / R_2)


CARDS: tuple[Card, ...] = (
    Card(
        "contact-modulus",
        contact_modulus,
        {"E_1": 70e9, "nu_1": 0.33, "E_2": 70e9, "nu_2": 0.33},
        (Range("nu", -1.0, 0.5),),
    ),
    Card("contact-radius", relative_radius, {"R_1": 0.05, "R_2": 0.1}),
)
