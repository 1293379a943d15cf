"""Next order in the rotation of an overconstrained pivot of three or more blades.

The blades shorten more, or less, than their ends come closer, by c θ² l with
c = (9δ² + 9δ + 1)/15. Two blades let the centre shift; more hold it, and stretch: the tension
n [EI/l²] grows with (θ l/h)² until the blades straighten or bow out.
"""

from math import pi

import numpy as np

from flexcli.formulas.beam_column import s_bending, uniform_bending
from flexcli.formulas.card import SLENDER, Card, Range
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.numerics.rows import atan2, cos, sin

__all__ = ["CARDS", "held_shares", "stress_change", "tension"]


def held_shares(angles: tuple[float, ...]) -> tuple[float, ...]:
    """Return the share of each blade's misfit that no shift of the centre takes up.

    ``1 − e_iᵀ (Σ e eᵀ)⁻¹ Σ e``: zero for two blades, one for blades evenly around the centre.

    Parameters
    ----------
    angles : tuple of float
        Direction of each blade [rad]; not all parallel.

    Returns
    -------
    shares : tuple of float
        Share of the misfit [-].

    Examples
    --------
    >>> from math import pi
    >>> [round(share, 9) for share in held_shares((0.0, 2 * pi / 3, 4 * pi / 3))]
    [1.0, 1.0, 1.0]

    References
    ----------
    Least strain energy of a statically indeterminate truss, e.g. Przemieniecki (1968).

    """
    axis = atan2(sum(sin(2.0 * a) for a in angles), sum(cos(2.0 * a) for a in angles)) / 2.0
    along = sum(cos(a - axis) for a in angles) / sum(cos(a - axis) ** 2 for a in angles)
    across = sum(sin(a - axis) for a in angles) / sum(sin(a - axis) ** 2 for a in angles)
    return tuple(1.0 - along * cos(a - axis) - across * sin(a - axis) for a in angles)


def tension(
    *, h: Quantity, l: Quantity, p: Quantity, theta: Quantity, share: Quantity = 1.0
) -> Computed:
    """Return the tension that the rotation of an overconstrained pivot makes in a blade.

    ``n = c θ² share/((h/l)²/12 + (9γ² + 35) θ²/25200)`` in units of EI/l², ``γ = 1 + 2δ``.

    Parameters
    ----------
    h, l : Quantity
        Thickness and length of a blade [m].
    p : Quantity
        Distance from the centre to the inner ends [m].
    theta : Quantity
        Rotation [rad].
    share : Quantity
        Share of the misfit that the centre cannot take up, see ``held_shares`` [-].

    Returns
    -------
    n : Quantity
        N l²/(EI), negative in compression [-].

    Notes
    -----
    Second order in n: −5 < n < 30, where the moment it gives is at most 12 % too low; a blade in
    stronger tension bows out less than so, one in compression goes towards buckling.

    Examples
    --------
    >>> round(float(tension(h=0.01, l=1.0, p=0.0, theta=0.01)), 4)
    0.7836

    References
    ----------
    Beam constraint model, Awtar, Slocum & Sevincer (2007), Journal of Mechanical Design 129.

    """
    delta = p / l
    gamma = 1.0 + 2.0 * delta
    misfit = (9.0 * delta**2 + 9.0 * delta + 1.0) / 15.0 * theta**2
    bows = (9.0 * gamma**2 + 35.0) * theta**2 / 25200.0
    return misfit * share / ((h / l) ** 2 / 12.0 + bows)


def stress_change(
    *, h: Quantity, l: Quantity, p: Quantity, theta: Quantity, angles: tuple[float, ...]
) -> Computed:
    """Return the relative change that the tension makes to the largest bending stress.

    ``max (k_s + 3|γ| k_a)/(1 + 3|γ|) − 1`` over the blades.

    Parameters
    ----------
    h, l : Quantity
        Thickness and length of a blade [m].
    p : Quantity
        Distance from the centre to the inner ends [m].
    theta : Quantity
        Rotation [rad].
    angles : tuple of float
        Direction of each blade [rad].

    Returns
    -------
    change : Quantity
        True over closed-form bending stress, less one [-].

    Notes
    -----
    Bending alone; the tension adds N/(h b).

    Examples
    --------
    >>> from math import pi
    >>> star = (0.0, 2 * pi / 3, 4 * pi / 3)
    >>> round(float(stress_change(h=0.01, l=1.0, p=0.0, theta=0.01, angles=star)), 4)
    0.0259

    References
    ----------
    End moments of a beam-column, Timoshenko & Gere (1961), Theory of Elastic Stability.

    """
    gamma = np.abs(1.0 + 2.0 * p / l)
    most = 0.0
    for share in held_shares(angles):
        n = tension(h=h, l=l, p=p, theta=theta, share=share)
        most = np.maximum(most, uniform_bending(n) + 3.0 * gamma * s_bending(n))
    return most / (1.0 + 3.0 * gamma) - 1.0


_STAR = {"h": 250e-6, "l": 80e-3, "p": 0.0, "theta": 0.003}
_EVEN = {"angles": (0.0, 2.0 * pi / 3.0, 4.0 * pi / 3.0)}
_SMALL = Range("n", -5.0, 30.0, "the shortening of the blade is of second order in n")

CARDS = (
    Card("star-held-shares", held_shares, _EVEN),
    Card("star-tension", tension, _STAR, (SLENDER, _SMALL)),
    Card("star-stress-at-large-rotation", stress_change, {**_STAR, **_EVEN}, (SLENDER, _SMALL)),
)
