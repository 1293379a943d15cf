"""What shear and stretching of thick blades do to a pivot of two blades: exact at small rotation.

The pivot bends its blades in a uniform part, free of force, and an S-shaped part (γ = 1 + 2δ)
that a force f = 6γθ/(1 + Φ*) across each blade and ∓f cot α along it keep up [unit EI/l²].
"""

import numpy as np

from flexcli.formulas.blade_shear import s_bending_share
from flexcli.formulas.blade_shear import stiffness_change as relieved
from flexcli.formulas.card import Card
from flexcli.formulas.quantity import Quantity
from flexcli.formulas.section import shear_parameter

__all__ = ["CARDS", "give", "shift_across", "stiffness_change", "stress_change"]


def give(*, h: Quantity, l: Quantity, half_angle: Quantity, poisson_ratio: float) -> Quantity:
    """Return how much shear and stretching soften the S-shaped bending of a pivot's blades.

    ``Φ* = Φ + (h/l)² cot²α``: the S-shaped part of stiffness and stress is divided by 1 + Φ*.

    Parameters
    ----------
    h, l : Quantity
        Thickness and length of a blade [m].
    half_angle : Quantity
        Half the angle between the blades [rad].
    poisson_ratio : float
        ν [-].

    Returns
    -------
    Phi : Quantity
        Timoshenko's shear parameter with the stretching of both blades [-].

    Notes
    -----
    Exact for the linear beam of Timoshenko with κ = 5/6, two blades, a centre free to shift.

    Examples
    --------
    >>> from math import pi
    >>> round(float(give(h=0.1, l=1.0, half_angle=pi / 4, poisson_ratio=0.25)), 6)
    0.04

    References
    ----------
    Derived: stiffness of both blades condensed on the rotation, the centre unloaded; Φ as in
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6.

    """
    shear = shear_parameter(depth=h, l=l, poisson_ratio=poisson_ratio)
    return shear + (h / l) ** 2 / np.tan(half_angle) ** 2


def stiffness_change(
    *, h: Quantity, l: Quantity, p: Quantity, half_angle: Quantity, poisson_ratio: float
) -> Quantity:
    """Return the relative change that shear and stretching make to the rotational stiffness.

    ``−3γ²/(1 + 3γ²) · Φ*/(1 + Φ*)``, ``γ = 1 + 2δ``.

    Parameters
    ----------
    h, l : Quantity
        Thickness and length of a blade [m].
    p : Quantity
        Distance from the centre to the inner ends [m].
    half_angle : Quantity
        Half the angle between the blades [rad].
    poisson_ratio : float
        ν [-].

    Returns
    -------
    change : Quantity
        True over closed-form stiffness, less one [-].

    Examples
    --------
    >>> from math import pi
    >>> thick = {"h": 0.1, "l": 1.0, "half_angle": pi / 4, "poisson_ratio": 0.25}
    >>> round(float(stiffness_change(**thick, p=0.0)), 6)
    -0.028846

    References
    ----------
    As :func:`give`.

    """
    Phi = give(h=h, l=l, half_angle=half_angle, poisson_ratio=poisson_ratio)
    return relieved(Phi=Phi, share=s_bending_share(p / l))


def stress_change(
    *, h: Quantity, l: Quantity, p: Quantity, half_angle: Quantity, poisson_ratio: float
) -> Quantity:
    """Return the relative change that shear and stretching make to the largest bending stress.

    ``−3|γ|/(1 + 3|γ|) · Φ*/(1 + Φ*)``, ``γ = 1 + 2δ``, at a given rotation.

    Parameters
    ----------
    h, l : Quantity
        Thickness and length of a blade [m].
    p : Quantity
        Distance from the centre to the inner ends [m].
    half_angle : Quantity
        Half the angle between the blades [rad].
    poisson_ratio : float
        ν [-].

    Returns
    -------
    change : Quantity
        True over closed-form stress, less one [-].

    Examples
    --------
    >>> from math import pi
    >>> thick = {"h": 0.1, "l": 1.0, "half_angle": pi / 4, "poisson_ratio": 0.25}
    >>> round(float(stress_change(**thick, p=0.0)), 6)
    -0.028846

    References
    ----------
    As :func:`give`; moments 1 ± 3γ/(1 + Φ*) at the ends [unit EI θ/l].

    """
    s_bending = 3.0 * np.abs(1.0 + 2.0 * p / l)
    Phi = give(h=h, l=l, half_angle=half_angle, poisson_ratio=poisson_ratio)
    return -s_bending / (1.0 + s_bending) * Phi / (1.0 + Phi)


def shift_across(
    *,
    h: Quantity,
    l: Quantity,
    p: Quantity,
    theta: Quantity,
    half_angle: Quantity,
    poisson_ratio: float,
) -> Quantity:
    """Return the shift of the centre across the bisector that the stretching of the blades makes.

    ``Y = −θ l γ (h/l)² cos α/(2 sin²α (1 + Φ*))``: linear in θ, zero for δ = −½.

    Parameters
    ----------
    h, l : Quantity
        Thickness and length of a blade [m].
    p : Quantity
        Distance from the centre to the inner ends [m].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the blades [rad].
    poisson_ratio : float
        ν [-].

    Returns
    -------
    Y : Quantity
        Shift [m].

    Notes
    -----
    ``pivot_next_shift.shift_across`` adds what bending makes of order θ³. Shear lessens it.

    Examples
    --------
    >>> from math import pi
    >>> thick = {"h": 0.1, "l": 1.0, "half_angle": pi / 4, "poisson_ratio": 0.25}
    >>> round(float(shift_across(**thick, p=0.0, theta=0.01)), 9)
    -6.7991e-05

    References
    ----------
    As :func:`give`.

    """
    Phi = give(h=h, l=l, half_angle=half_angle, poisson_ratio=poisson_ratio)
    lever = np.cos(half_angle) / (2.0 * np.sin(half_angle) ** 2 * (1.0 + Phi))
    return -theta * l * (1.0 + 2.0 * p / l) * (h / l) ** 2 * lever


_THICK = {"h": 1e-3, "l": 17.5e-3, "half_angle": 0.7, "poisson_ratio": 0.33}

CARDS = (
    Card("pivot-shear-and-stretch", give, _THICK),
    Card("pivot-stiffness-of-thick-blades", stiffness_change, {**_THICK, "p": 2e-3}),
    Card("pivot-stress-of-thick-blades", stress_change, {**_THICK, "p": 2e-3}),
    Card("pivot-shift-of-thick-blades", shift_across, {**_THICK, "p": 2e-3, "theta": 0.05}),
)
