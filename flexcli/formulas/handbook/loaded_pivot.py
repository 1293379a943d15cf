"""Rotational stiffness of a pivot of equal blades whose blades carry axial forces.

A force at the centre, radial or across, stretches or compresses the blades; each then bends as a
beam-column, and its force has a lever when the body turns.
"""

from collections.abc import Sequence
from math import pi

import numpy as np

from flexcli.formulas.beam_column import s_bending, uniform_bending
from flexcli.formulas.card import SLENDER, Card
from flexcli.formulas.quantity import Computed, Numbers, Quantity
from flexcli.formulas.section import second_moment

__all__ = ["CARDS", "loaded_stiffness", "radial_gain", "transverse_gain"]


def loaded_stiffness(
    *,
    E: Quantity,
    h: Quantity,
    l: Quantity,
    b: Quantity,
    p: Quantity,
    tensions: Sequence[Quantity],
) -> Computed:
    """Return the rotational stiffness of a pivot at rest whose blades carry axial forces.

    ``K = (EI/l) Σ (k_s + 3γ² k_a + n (γ² − 1)/4)`` over the blades, ``γ = 1 + 2δ``,
    ``n = N l²/(EI)``, ``k_s = 1/τ``, ``k_a = (n/12) τ/(1 − τ)``, ``τ = tanh(√n/2)/(√n/2)``: for
    small forces ``K₀ + 2(9δ² + 9δ + 1) l ΣN/15 − (9γ² + 35) l³ ΣN²/(25200 EI)``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width of a blade [m].
    p : Quantity
        Distance from the centre to the inner ends [m].
    tensions : sequence of Quantity
        Axial force of each blade [N], positive in tension: the force at the centre times its
        ``pivot.axial_share``.

    Returns
    -------
    K : Quantity
        Rotational stiffness [N·m/rad], zero and below beyond the load that buckles the pivot.

    Notes
    -----
    Exact for slender blades at rest; the force acts at the centre, with its direction kept.

    Examples
    --------
    >>> blade = {"E": 200e9, "h": 300e-6, "l": 50e-3, "b": 10e-3, "p": -25e-3}
    >>> round(float(loaded_stiffness(**blade, tensions=(0.0, 0.0))), 6)
    0.18

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, section 1.11; derived by splitting the
    blade's bending into a uniform and an S-shaped part about its chord.

    """
    unit = E * second_moment(b, h)
    gamma = 1.0 + 2.0 * p / l
    total = 0.0
    for tension in tensions:
        n = np.asarray(tension) * l**2 / unit
        bending = uniform_bending(n) + 3.0 * gamma**2 * s_bending(n)
        total = total + bending + n * (gamma**2 - 1.0) / 4.0
    return unit / l * total


def radial_gain(*, l: Numbers, p: Numbers, half_angle: Numbers) -> Computed:
    """Return the change of the stiffness of a pivot of two blades per radial force at its centre.

    ``dK/dF = 2(9δ² + 9δ + 1) l/(15 cos α)``, F along the bisector and positive when it stretches
    the blades: the bracket of the parasitic shift, none at Wittrick's crossing.

    Parameters
    ----------
    l, p : Quantity
        Length of a blade and distance from the centre to the inner ends [m].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    gain : Quantity
        Stiffness per force [m/rad].

    Notes
    -----
    First order in the force: twice the leading coefficient of the shift, on which F does work.

    Examples
    --------
    >>> from math import pi
    >>> round(float(radial_gain(l=15.0, p=0.0, half_angle=pi / 3)), 6)
    4.0

    References
    ----------
    First order of :func:`loaded_stiffness`.

    """
    delta = p / l
    return 2.0 * (9.0 * delta**2 + 9.0 * delta + 1.0) * l / (15.0 * np.cos(half_angle))


def transverse_gain(
    *, E: Numbers, h: Numbers, l: Numbers, b: Numbers, p: Numbers, half_angle: Numbers
) -> Computed:
    """Return the change of the stiffness of a pivot of two blades per squared force across it.

    ``(K − K₀)/F² = −(9γ² + 35) l³/(50400 EI sin²α)``, F across the bisector, ``γ = 1 + 2δ``: one
    blade stretched and the other as much compressed soften it, whatever the sign.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width of a blade [m].
    p : Quantity
        Distance from the centre to the inner ends [m].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    gain : Quantity
        Stiffness per squared force [m/(N·rad)].

    Notes
    -----
    Leading order: the first order cancels between the blades.

    Examples
    --------
    >>> from math import pi
    >>> gain = transverse_gain(E=1.0, h=1.0, l=12.0, b=12.0, p=-6.0, half_angle=pi / 6)
    >>> round(float(gain), 6)
    -4.8

    References
    ----------
    Second order of :func:`loaded_stiffness`.

    """
    gamma = 1.0 + 2.0 * p / l
    compliance = l**3 / (50400.0 * E * second_moment(b, h))
    return -(9.0 * gamma**2 + 35.0) * compliance / np.sin(half_angle) ** 2


_BLADE = {"E": 114e9, "h": 637e-6, "l": 17.5e-3, "b": 10e-3, "p": 2e-3}
_AIM = {"l": 17.5e-3, "p": 2e-3, "half_angle": pi / 4.0}

CARDS = (
    Card("pivot-under-load", loaded_stiffness, {**_BLADE, "tensions": (10.0, 10.0)}, (SLENDER,)),
    Card("pivot-radial-gain", radial_gain, _AIM, (SLENDER,)),
    Card("pivot-transverse-gain", transverse_gain, {**_BLADE, **_AIM}, (SLENDER,)),
)
