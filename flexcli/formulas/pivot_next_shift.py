"""What a large rotation adds to the parasitic shift of a pivot of two blades.

Along the bisector the next term is of order θ⁴, and rules at Wittrick's crossing; across it the
shift begins with θ³. Derivation in :mod:`flexcli.formulas.pivot_next_order`.
"""

import numpy as np

from flexcli.formulas.card import Card
from flexcli.formulas.pivot_next_order import LARGE_ROTATION, Parts
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "next_shift", "shift_across", "shift_parts"]


def shift_parts(*, l: Quantity, p: Quantity, theta: Quantity, half_angle: Quantity) -> Parts:
    """Return the parts of the fourth-order shift [m], see :func:`next_shift`."""
    gamma, cot = 1.0 + 2.0 * p / l, 1.0 / np.tan(half_angle)
    square, size = gamma**2, l * theta**4 / np.cos(half_angle)
    cubic = gamma * (35.0 + gamma * (27.0 + gamma * (9.0 + 9.0 * gamma)))
    quartic = -35.0 + gamma * (-70.0 + gamma * (-13.0 + gamma * (126.0 + 108.0 * gamma)))
    return Parts(
        square=-size * cubic * cot**2 / 8400.0,
        none=-size * quartic / 2800.0,
        inverse=size * (9.0 * square - 7.0) * (9.0 * square - 5.0) / (6300.0 * cot**2),
    )


def next_shift(*, l: Quantity, p: Quantity, theta: Quantity, half_angle: Quantity) -> Quantity:
    """Return what the next order in θ adds to the shift of the centre along the bisector.

    ``ΔPP' = −θ⁴ l/cos α · (γ(9γ³ + 9γ² + 27γ + 35) cot²α/8400 + (108γ⁴ + 126γ³ − 13γ² − 70γ −
    35)/2800 − (9γ² − 7)(9γ² − 5) tan²α/6300)``, ``γ = 1 + 2δ``. At Wittrick's crossing, where
    9γ² = 5, the last term vanishes too, and the first two are all there is.

    Parameters
    ----------
    l, p : Quantity
        Length of a blade and distance from the centre to the inner ends [m]; the inner ends are
        on the fixed body.
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    shift : Quantity
        Shift besides ``pivot.parasitic_shift``, with the same sign [m].

    Notes
    -----
    The next term is of order θ⁶. Unlike the leading term it is not symmetric in δ ↔ −1 − δ, since
    it is stated in the axes of the body that holds the inner ends.

    Examples
    --------
    >>> from math import pi, sqrt
    >>> wittrick = (sqrt(45.0) - 9.0) / 18.0
    >>> shift = next_shift(l=1.0, p=wittrick, theta=0.1, half_angle=pi / 4)
    >>> f"{shift:.3g}"
    '-3.52e-07'

    References
    ----------
    Derived, see ``pivot_next_order``; the leading term is of Wittrick (1951), Aeronautical
    Quarterly 2.

    """
    return shift_parts(l=l, p=p, theta=theta, half_angle=half_angle).total


def shift_across(*, l: Quantity, p: Quantity, theta: Quantity, half_angle: Quantity) -> Quantity:
    """Return the shift of the centre across the bisector, of the order θ³ with which it begins.

    ``Y = −θ³ l/sin α · (γ(9γ² + 35) cot α + (378γ³ + 315γ² − 210γ − 175) tan α)/4200``.

    Parameters
    ----------
    l, p : Quantity
        Length of a blade and distance from the centre to the inner ends [m].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    Y : Quantity
        Shift, towards where the rotation turns the bisector when positive [m].

    Notes
    -----
    Slender blades; ``thick_pivot.shift_across`` adds what their stretching makes of order θ.

    Examples
    --------
    >>> from math import pi
    >>> f"{shift_across(l=1.0, p=0.0, theta=0.1, half_angle=pi / 4):.3g}"
    '-0.000119'

    References
    ----------
    Derived, see ``pivot_next_order``.

    """
    gamma, cot = 1.0 + 2.0 * p / l, 1.0 / np.tan(half_angle)
    tilt = gamma * (9.0 * gamma**2 + 35.0) * cot
    tilt = tilt + (gamma * (gamma * (378.0 * gamma + 315.0) - 210.0) - 175.0) / cot
    return -(theta**3) * l * tilt / (4200.0 * np.sin(half_angle))


_PIVOT = {"l": 17.5e-3, "p": 2e-3, "theta": 0.1, "half_angle": 0.7}

CARDS = (
    Card("pivot-next-shift", next_shift, _PIVOT, LARGE_ROTATION),
    Card("pivot-shift-across", shift_across, _PIVOT, LARGE_ROTATION),
)
