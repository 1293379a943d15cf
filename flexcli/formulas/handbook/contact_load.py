"""Force that presses two bodies to a peak pressure, and the radius of both."""

from math import pi

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Quantity

__all__ = ["CARDS", "line_load", "point_load", "relative_radius"]


def relative_radius(R_1: Quantity, R_2: Quantity) -> Computed:
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


def line_load(*, p: Quantity, b: Quantity, R: Quantity, E_star: Quantity) -> Computed:
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


def point_load(*, p: Quantity, R: Quantity, E_star: Quantity) -> Computed:
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


_CYLINDER = {"b": 7.8e-3, "R": 50e-3, "E_star": 53.2e9}
_LINE = (
    Range("a/R", most=0.1, why="each body is taken for a half-space"),
    Range("a/b", most=0.1, why="a line far longer than wide"),
)
_BALL = {"R": 50e-3, "E_star": 53.2e9}
_POINT = (
    Range("a/R", most=0.1, why="each body is taken for a half-space"),
    Range("nu", 0.25, 0.35, "0.31 belongs to ν = 0.3; it is 0.32 at 0.25, 0.30 at 0.35"),
)

CARDS: tuple[Card, ...] = (
    Card("contact-radius", relative_radius, {"R_1": 0.05, "R_2": 0.1}),
    Card("line-contact-load", line_load, {"p": 11.18e6, **_CYLINDER}, _LINE),
    Card("point-contact-load", point_load, {"p": 85.8e6, **_BALL}, _POINT),
)
