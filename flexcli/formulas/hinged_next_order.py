"""Next order in the stroke of stages and pivots of rigid limbs between hinges (pins and springs).

Stages have the exact kinematics of a parallelogram; pivots the next powers of θ of a symmetric
four-bar linkage, whose limbs turn by ψ = (1 + δ)θ ± δ(1 + δ)θ² tan α/2 − (1 + 2δ)δ(1 + δ)θ³/6.
"""

import numpy as np

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Numbers, Quantity

__all__ = [
    "CARDS",
    "pivot_shift_change",
    "pivot_turn_change",
    "stage_shift_change",
    "stage_turn_change",
]


def _limb_turn(reach: Computed) -> Computed:
    """Return the turn of a limb whose end has moved by a share of its length; NaN beyond one."""
    with np.errstate(invalid="ignore"):
        return np.arcsin(reach)


def stage_turn_change(*, l: Quantity, x: Quantity) -> Computed:
    """Return the relative change that a large stroke makes to the turn and stress of the hinges.

    ``ψ/sin ψ − 1``, ``sin ψ = x/l``: (x/l)²/6 at first.

    Parameters
    ----------
    l, x : Quantity
        Distance between the hinges of a limb and travel of the stage [m].

    Returns
    -------
    change : Quantity
        True over closed-form rotation of a hinge, less one [-].

    Examples
    --------
    >>> round(float(stage_turn_change(l=1.0, x=0.1)), 6)
    0.001674

    References
    ----------
    Kinematics of a parallelogram.

    """
    return over_sine(_limb_turn(x / l)) - 1.0


def stage_shift_change(*, l: Quantity, x: Quantity) -> Computed:
    """Return the relative change that a large stroke makes to the motion towards the base.

    ``2/(1 + cos ψ) − 1 = tan²(ψ/2)``, ``sin ψ = x/l``: (x/l)²/4 at first.

    Parameters
    ----------
    l, x : Quantity
        Distance between the hinges of a limb and travel of the stage [m].

    Returns
    -------
    change : Quantity
        True over closed-form motion, less one [-].

    Examples
    --------
    >>> round(float(stage_shift_change(l=1.0, x=0.1)), 6)
    0.002513

    References
    ----------
    Kinematics of a parallelogram, l(1 − cos ψ) over x²/(2l).

    """
    return np.tan(_limb_turn(x / l) / 2.0) ** 2


def pivot_turn_change(*, l: Numbers, p: Numbers, theta: Numbers, half_angle: Numbers) -> Computed:
    """Return the relative change that a large rotation makes to the largest turn of a hinge.

    ``max(|1 + δ + a|, |δ + a|)/max(|1 + δ|, |δ|) − 1`` with
    ``a = ±δ(1 + δ) θ tan α/2 − (1 + 2δ)δ(1 + δ)θ²/6``: linear in θ, and so is the stress.

    Parameters
    ----------
    l, p : Quantity
        Distance between the hinges of a limb and from the centre to the inner one [m].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the limbs [rad].

    Returns
    -------
    change : Quantity
        True over closed-form rotation of the most turned hinge, less one [-].

    Notes
    -----
    Hinges that turn about their own centres. The closed form is on the unsafe side.

    Examples
    --------
    >>> from math import pi
    >>> change = pivot_turn_change(l=1.0, p=1.0, theta=1e-5, half_angle=pi / 4)
    >>> round(float(change / 1e-5), 3)
    0.5

    References
    ----------
    Derived from the constant length of each limb, see the module.

    """
    delta = p / l
    bent = delta * (1.0 + delta)
    even, odd = (1.0 + 2.0 * delta) * bent * theta**2 / 6.0, bent * theta * np.tan(half_angle) / 2.0
    inner = np.abs(1.0 + delta - even) + np.abs(odd)
    outer = np.abs(delta - even) + np.abs(odd)
    most = np.maximum(np.abs(1.0 + delta), np.abs(delta))
    return np.maximum(inner, outer) / most - 1.0


def pivot_shift_change(*, l: Numbers, p: Numbers, theta: Numbers, half_angle: Numbers) -> Computed:
    """Return the relative change that a large rotation makes to the shift along the bisector.

    ``PP'/PP'₀ − 1 = −θ² (9γ² + 12γ + 7 − 3(γ² − 1) tan²α)/48``, ``γ = 1 + 2δ``.

    Parameters
    ----------
    l, p : Quantity
        Distance between the hinges of a limb and from the centre to the inner one [m].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the limbs [rad].

    Returns
    -------
    change : Quantity
        True over closed-form shift, less one [-].

    Notes
    -----
    Hinges that turn about their own centres. The next term is of order θ⁴.

    Examples
    --------
    >>> from math import pi
    >>> change = pivot_shift_change(l=1.0, p=-0.5, theta=0.1, half_angle=pi / 4)
    >>> round(float(-4.8 * change), 9)
    0.01

    References
    ----------
    Derived from the constant length of each limb, see the module.

    """
    gamma = 1.0 + 2.0 * p / l
    share = 7.0 + gamma * (12.0 + 9.0 * gamma)
    return -(theta**2) * (share - 3.0 * (gamma**2 - 1.0) * np.tan(half_angle) ** 2) / 48.0


def over_sine(psi: Quantity) -> Computed:
    """Return ψ/sin ψ, 1 at rest."""
    return 1.0 / np.sinc(psi / np.pi)


_STAGE = {"l": 50e-3, "x": 5e-3}
_PIVOT = {"l": 20e-3, "p": 5e-3, "theta": 0.1, "half_angle": 0.7}
_TURN = Range("theta", -0.35, 0.35, "the change is the next term only", "rad")
_STROKE = Range("x/l", -1.0, 1.0, "a limb reaches no further")

CARDS = (
    Card("hinged-stage-turn-at-large-stroke", stage_turn_change, _STAGE, (_STROKE,)),
    Card("hinged-stage-shift-at-large-stroke", stage_shift_change, _STAGE, (_STROKE,)),
    Card("hinged-pivot-turn-at-large-rotation", pivot_turn_change, _PIVOT, (_TURN,)),
    Card("hinged-pivot-shift-at-large-rotation", pivot_shift_change, _PIVOT, (_TURN,)),
)
