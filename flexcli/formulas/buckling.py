"""Euler buckling of a blade for the ways in which its ends can be held."""

from math import pi

from flexcli.formulas.card import SLENDER, Card
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "EFFECTIVE_LENGTH", "euler_load"]

EFFECTIVE_LENGTH = {
    "clamped-clamped": 0.5,
    "clamped-pinned": 0.6991556596428411,  # π over the first root of tan x = x
    "clamped-guided": 1.0,
    "pinned-pinned": 1.0,
    "clamped-free": 2.0,
}
"""Effective length over length, by what holds the two ends (Timoshenko & Gere 1961, §2.1)."""


def euler_load(*, E: Quantity, I: Quantity, l: Quantity, ends: str) -> Quantity:
    """Return the critical axial force of a straight blade.

    ``N_cr = π² E I / (μ l)²`` with the effective length μ l of how its ends are held.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    I : Quantity
        Second moment of area about the axis of bending [m⁴].
    l : Quantity
        Length [m].
    ends : str
        A key of :data:`EFFECTIVE_LENGTH`.

    Returns
    -------
    N_cr : Quantity
        Critical force [N].

    Notes
    -----
    Elastic and slender: the stress N_cr/(h b) must stay below yield.

    Examples
    --------
    >>> round(euler_load(E=200e9, I=1e-12, l=0.1, ends="pinned-pinned"), 3)
    197.392

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, §2.1.

    """
    return pi**2 * E * I / (EFFECTIVE_LENGTH[ends] * l) ** 2


CARDS = (
    Card(
        "euler-load",
        euler_load,
        {"E": 200e9, "I": 1e-12, "l": 0.1, "ends": "clamped-guided"},
        (SLENDER,),
    ),
)
