"""What is left of the parasitic shift at Wittrick's crossing, where its leading term vanishes."""

from math import cos, pi, sin, sqrt

from flexcli.formulas.card import SLENDER, SMALL_ROTATION, Card
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "shift_across"]


def shift_across(*, l: Quantity, theta: Quantity, half_angle: float) -> Quantity:
    """Return the shift of the centre across the bisector at Wittrick's crossing, leading order.

    ``y = −√5/315 (cos α/sin² α) θ³ l`` for δ = −0.1273, with the other sign for −0.8727.

    Parameters
    ----------
    l : Quantity
        Length of a blade [m].
    theta : Quantity
        Rotation of the body at the inner ends [rad].
    half_angle : float
        Half the angle between the blades [rad], 0 < α < π/2.

    Returns
    -------
    y : Quantity
        Shift across the bisector [m], positive 90° from it in the sense of θ.

    Notes
    -----
    Slender blades without load. Along the bisector a shift of the order θ⁴ l is left, 0.0065 θ⁴ l
    for α = 45°. Against exact (elastica) blades the two hold to four and two digits at 1°; at 10°
    and α = 45° the first is 0.06 % too large.

    Examples
    --------
    >>> f"{shift_across(l=20e-3, theta=pi / 18.0, half_angle=pi / 4.0) * 1e6:.3f} um"
    '-1.067 um'

    References
    ----------
    Wittrick (1951), The Aeronautical Quarterly 2(4), 272–292, for the crossing; the coefficient
    fitted to exact solutions over half-angles from 20° to 70°.

    """
    return -sqrt(5.0) / 315.0 * cos(half_angle) / sin(half_angle) ** 2 * l * theta**3


CARDS: tuple[Card, ...] = (
    Card(
        "shift-at-wittricks-crossing",
        shift_across,
        {"l": 20e-3, "theta": pi / 18.0, "half_angle": pi / 4.0},
        (SLENDER, SMALL_ROTATION),
    ),
)
