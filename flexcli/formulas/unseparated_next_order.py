"""Next order in the rotation of the closed forms of crossed blades that are joined.

Two pivots of p = 0 in series, blades c l and (1 − c)l, carry the same moment and no force: the
changes of :mod:`flexcli.formulas.pivot_next_order` at the rotations of both add up.
"""

import numpy as np

from flexcli.formulas import pivot_next_order as part
from flexcli.formulas import pivot_next_order as shifts
from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Numbers

__all__ = [
    "CARDS",
    "moment_change",
    "next_shift",
]


def moment_change(*, crossing: Numbers, theta: Numbers, half_angle: Numbers) -> Computed:
    """Return the relative change that a large rotation makes to the moment over the rotation.

    ``M/(Kθ) − 1 = κ θ² (c³ + (1 − c)³)``, κθ² that of a pivot of p = 0; the tangent stiffness
    changes by three times that.

    Parameters
    ----------
    crossing : Quantity
        Share c of the blades on the side of the base [-].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    change : Quantity
        True over closed-form secant stiffness, less one [-].

    Notes
    -----
    The next term is of order θ⁴; slender blades, a small cross.

    Examples
    --------
    >>> from math import pi
    >>> alone = part.moment_change(l=1.0, p=0.0, theta=0.1, half_angle=pi / 4)
    >>> half = moment_change(crossing=0.5, theta=0.1, half_angle=pi / 4)
    >>> round(float(half / alone), 9)
    0.25

    References
    ----------
    Compliances of both pivots in series.

    """
    alone = part.moment_change(l=1.0, p=0.0, theta=theta, half_angle=half_angle)
    return alone * (crossing**3 + (1.0 - crossing) ** 3)


def next_shift(*, l: Numbers, crossing: Numbers, theta: Numbers, half_angle: Numbers) -> Computed:
    """Return what the next order in θ adds to the shift of the centre along the bisector.

    The shifts of both pivots of order θ⁴, that of the second turned with the cross, and what
    their unequal softening adds to the first order.

    Parameters
    ----------
    l : Quantity
        Length of a blade from end to end [m].
    crossing : Quantity
        Share c of that length on the side of the base [-].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    shift : Quantity
        Shift besides ``unseparated.unseparated_shift``, with the same sign [m].

    Notes
    -----
    The next term is of order θ⁶.

    Examples
    --------
    >>> from math import pi
    >>> f"{next_shift(l=1.0, crossing=0.5, theta=0.1, half_angle=pi / 4):.3g}"
    '-7.34e-07'

    References
    ----------
    Both pivots in series, the one of the base with δ = −1 and the other with δ = 0.

    """
    first, second = crossing * theta, (1.0 - crossing) * theta
    base = {"l": crossing * l, "p": -crossing * l, "theta": first, "half_angle": half_angle}
    far = {"l": (1.0 - crossing) * l, "p": 0.0, "theta": second, "half_angle": half_angle}
    whole = moment_change(crossing=crossing, theta=theta, half_angle=half_angle)
    along = 0.0
    for pivot in (base, far):
        # a shift ∝ (turn)² of a part that turns by more than its share
        more = whole - part.moment_change(**pivot)
        leading = pivot["l"] * pivot["theta"] ** 2 / (15.0 * np.cos(half_angle))
        along = along + shifts.next_shift(**pivot) + 2.0 * more * leading
    turned = (1.0 - crossing) * l * second**2 / (15.0 * np.cos(half_angle)) * first**2 / 2.0
    return along - turned + first * shifts.shift_across(**far)


_CROSSED = {"crossing": 0.5, "theta": 0.1, "half_angle": 0.7}
_TURN = (Range("theta", most=0.35, unit="rad", why="the change is the next term only"),)

CARDS = (
    Card("unseparated-moment-at-large-rotation", moment_change, _CROSSED, _TURN),
    Card("unseparated-next-shift", next_shift, {"l": 17.5e-3, **_CROSSED}, _TURN),
)
