"""Shear and stretching of thick blades in a pivot of two: stiffness and stress."""

import numpy as np

from flexcli.formulas.card import Card
from flexcli.formulas.quantity import Computed, Numbers
from flexcli.formulas.thick_blades import pivot_softening, s_bending_share
from flexcli.formulas.thick_blades import stiffness_change as relieved

__all__ = ["CARDS", "stiffness_change", "stress_change"]


def stiffness_change(
    *, h: Numbers, l: Numbers, p: Numbers, half_angle: Numbers, poisson_ratio: float
) -> Computed:
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
    As :func:`pivot_softening`.

    """
    Phi = pivot_softening(h=h, l=l, half_angle=half_angle, poisson_ratio=poisson_ratio)
    return relieved(Phi=Phi, share=s_bending_share(p / l))


def stress_change(
    *, h: Numbers, l: Numbers, p: Numbers, half_angle: Numbers, poisson_ratio: float
) -> Computed:
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
    As :func:`pivot_softening`; moments 1 ± 3γ/(1 + Φ*) at the ends [unit EI θ/l].

    """
    s_bending = 3.0 * np.abs(1.0 + 2.0 * p / l)
    Phi = pivot_softening(h=h, l=l, half_angle=half_angle, poisson_ratio=poisson_ratio)
    return -s_bending / (1.0 + s_bending) * Phi / (1.0 + Phi)


_PIVOT = {"h": 1e-3, "l": 17.5e-3, "half_angle": 0.7, "poisson_ratio": 0.33}

CARDS: tuple[Card, ...] = (
    Card("pivot-stiffness-of-thick-blades", stiffness_change, {**_PIVOT, "p": 2e-3}),
    Card("pivot-stress-of-thick-blades", stress_change, {**_PIVOT, "p": 2e-3}),
)
