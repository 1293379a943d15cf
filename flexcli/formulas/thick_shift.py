"""What shear and stretching of thick blades do to the parasitic shift of stages and pivots.

The shortening of a blade is ``λ = ∫(θ²/2 + gθ) ds − fw/(EA)``: its sections turn by θ, shear by g,
and its end force f across it, of first order in the motion w, stretches it as it turns.
"""

import numpy as np

from flexcli.formulas.card import Card
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "pivot_stretch", "shear_factor", "stage_stretch"]


def shear_factor(Phi: Quantity) -> Quantity:
    """Return by how much shear scales the shortening of a blade that bends in an S.

    ``(1 + 5Φ/3)/(1 + Φ)²``: the blade turns less and shears instead.

    Parameters
    ----------
    Phi : Quantity
        Timoshenko's parameter of the blade (a quarter of it for a cantilever) [-].

    Returns
    -------
    factor : Quantity
        Shortening with shear over that without [-].

    Examples
    --------
    >>> shear_factor(0.0)
    1.0

    References
    ----------
    Derived, see the module.

    """
    return (1.0 + 5.0 * Phi / 3.0) / (1.0 + Phi) ** 2


def stage_stretch(*, h: Quantity, l: Quantity) -> Quantity:
    """Return the relative change that stretching makes to the motion towards the base.

    ``−(5/3)(h/l)²`` of guided blades; a cantilever is half a guided blade of twice its length.

    Parameters
    ----------
    h, l : Quantity
        Thickness and length of a guided blade [m].

    Returns
    -------
    change : Quantity
        Motion with stretching over that without, less one [-].

    Examples
    --------
    >>> round(stage_stretch(h=0.06, l=1.0), 6)
    -0.006

    References
    ----------
    Derived, see the module.

    """
    return -5.0 / 3.0 * (h / l) ** 2


def pivot_stretch(*, h: Quantity, l: Quantity, p: Quantity, half_angle: Quantity) -> Quantity:
    """Return what stretching adds to the bracket of the shift of a pivot of two blades.

    ``(γ − γ')/4 + 3(γ² − γ'²)/20 + γ'(γ' + 1)(h/l)²/4 − (h/l)² (18γ² + 15γ + (5 − 9γ²) tan²α)/60``,
    ``γ = 1 + 2δ``, ``γ' = γ/(1 + (h/l)² cot²α)``, beside ``(5 − 9γ²)/60``, the bracket of slender
    blades. The last term is of the axial force of order θ² that balances what the shift and the
    axial force of order θ add to the force across the blades.

    Parameters
    ----------
    h, l : Quantity
        Thickness and length of a blade [m].
    p : Quantity
        Distance from the centre to the inner ends [m].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    bracket : Quantity
        Change of the shift along the bisector over l θ²/cos α [-].

    Examples
    --------
    >>> from math import pi
    >>> round(float(pivot_stretch(h=0.06, l=1.0, p=-0.5, half_angle=pi / 4)), 9)
    -0.0003

    References
    ----------
    Derived, see the module; the centre shifts across by ``thick_pivot.shift_across``.

    """
    gamma, slender = 1.0 + 2.0 * p / l, (h / l) ** 2
    softer = gamma / (1.0 + slender / np.tan(half_angle) ** 2)
    balance = 18.0 * gamma**2 + 15.0 * gamma + (5.0 - 9.0 * gamma**2) * np.tan(half_angle) ** 2
    bends = (gamma - softer) / 4.0 + 3.0 * (gamma**2 - softer**2) / 20.0
    return bends + softer * (softer + 1.0) * slender / 4.0 - slender * balance / 60.0


_THICK = {"h": 1e-3, "l": 17.5e-3}

CARDS = (
    Card("shear-in-shift", shear_factor, {"Phi": 0.03}),
    Card("stretching-in-stage-shift", stage_stretch, _THICK),
    Card("stretching-in-pivot-shift", pivot_stretch, {**_THICK, "p": 2e-3, "half_angle": 0.7}),
)
