"""Buckling of a necked-down blade, whose rigid middle stays straight between two hinges."""

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Numbers, Quantity
from flexcli.formulas.section import second_moment
from flexcli.results import QuantityKind

__all__ = ["CARDS", "guided_critical_load", "locked_critical_load"]

Floats = NDArray[np.float64]

_NEWTON_STEPS = 4
"""From a start within 2 %, four quadratic steps reach rounding for every ξ."""


def guided_critical_load(
    *, E: Numbers, h: Numbers, l: Numbers, b: Numbers, xi: Numbers
) -> Computed:
    """Return the critical load of a necked-down blade under a stage free along its stroke.

    ``P = 4 E I u² / (ξ l)²`` with ``u tan u = ξ/(1 − ξ)`` in (0, π/2]: the stage moves without
    turning. π²EI/l² for ξ = 1; 4EI/(ξ l²), two hinges of stiffness EI/l_c, for ξ → 0.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness of a hinge, length of the whole blade and width [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-]; numbers only.

    Returns
    -------
    P : Quantity
        Critical axial force of one blade [N].

    Notes
    -----
    0 < ξ ≤ 1, elastic: P/(b h) below yield. Hinge: y'' + k² y = k² δ with k² = P/EI, clamped
    below; the rigid half-middle carries its slope on to the inflection at mid-length.

    Raises
    ------
    ValueError
        When ξ is not above 0 and at most 1.

    Examples
    --------
    >>> blade = {"E": 200e9, "h": 300e-6, "l": 50e-3, "b": 10e-3}
    >>> f"{guided_critical_load(**blade, xi=1.0):.3f} {guided_critical_load(**blade, xi=0.2):.3f}"
    '17.765 41.488'

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, §2.1 and §2.14 (stepped columns);
    Henein & Thalmann, lecture "Dimensioning of flexure joints", critical load.

    """
    return E * second_moment(b, h) / l**2 * (2.0 * _phase(xi) / xi) ** 2


def locked_critical_load(
    *, E: Quantity, h: Quantity, l: Quantity, b: Quantity, xi: Quantity
) -> Computed:
    """Return the critical load of a necked-down blade under a stage locked along its stroke.

    ``P = 4 π² E I / (ξ l)² = π² E I / l_c²``: the rigid middle moves sideways without turning.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness of a hinge, length of the whole blade and width [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    P : Quantity
        Critical axial force of one blade [N].

    Notes
    -----
    0 < ξ ≤ 1, elastic: P/(b h) below yield, which short hinges reach first. The other mode, in
    which the middle turns, has ``tan u = u/(1 + u² (1 − ξ)/ξ²)``, u = k l_c above π: always later.

    Examples
    --------
    >>> f"{locked_critical_load(E=200e9, h=300e-6, l=50e-3, b=10e-3, xi=1.0):.3f}"
    '71.061'

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, §2.1 (each hinge is a clamped–guided
    column).

    """
    return E * second_moment(b, h) / l**2 * (2.0 * np.pi / xi) ** 2


def _phase(xi: Numbers) -> Floats:
    """Return the root u in (0, π/2] of (1 − ξ) u sin u = ξ cos u."""
    (share,) = positive(xi=xi)
    if (share > 1.0).any():
        raise ValueError(f"xi must be at most 1, got {share}")
    # u² → ξ for short hinges and (π/2)² at ξ = 1; the hyperbola between is within 2 %
    u: Floats = np.sqrt(share / (1.0 + (4.0 / np.pi**2 - 1.0) * share))
    for _ in range(_NEWTON_STEPS):
        sin, cos = np.sin(u), np.cos(u)
        residual = (1.0 - share) * u * sin - share * cos
        u = u - residual / (sin + (1.0 - share) * u * cos)
    return u


_SHARE = Range("xi", 0.0, 1.0, "two hinges make up at most the whole blade")
_BLADE = {"E": 200e9, "h": 100e-6, "l": 50e-3, "b": 10e-3, "xi": 0.2}

CARDS: tuple[Card, ...] = (
    Card(
        "necked-down-buckling-guided",
        guided_critical_load,
        _BLADE,
        (_SHARE,),
        kind=QuantityKind.BUCKLING,
    ),
    Card(
        "necked-down-buckling-locked",
        locked_critical_load,
        _BLADE,
        (_SHARE,),
        kind=QuantityKind.BUCKLING,
    ),
)
