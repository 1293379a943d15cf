"""Next order in the stroke of the closed forms of blades that a lateral force moves.

Cantilever, guided blade, leaf-spring stage and necked-down stage share one expansion: each half
of a guided blade, and a cantilever, is an elastica θ' = c(s) f ∫cos θ ds under a force across it.
"""

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Quantity

__all__ = ["CARDS", "shift_change", "stress_change"]


def stress_change(*, l: Quantity, x: Quantity, xi: Quantity = 1.0) -> Computed:
    """Return the relative change that a large stroke makes to the largest bending stress.

    ``σ/σ₀ − 1 = (x/l)² 3(105 − 105ξ − 126ξ² + 238ξ³ − 123ξ⁴ + 21ξ⁵)/(70 (3 − 3ξ + ξ²)³)``: 3/7
    (x/l)² for ξ = 1, (x/l)²/6 for ξ → 0.

    Parameters
    ----------
    l, x : Quantity
        Length of the blade and travel of its tip [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    change : Quantity
        True over closed-form stress at the clamped ends, less one [-].

    Notes
    -----
    Less than the force grows, since the lever of the force is shortened.

    Examples
    --------
    >>> round(7.0 * stress_change(l=1.0, x=0.1), 6)
    0.03

    References
    ----------
    Derived as :func:`force_change`, with the moment F (l − λ) at the clamp.

    """
    share = 105.0 - xi * (105.0 + xi * (126.0 - xi * (238.0 - xi * (123.0 - 21.0 * xi))))
    return (x / l) ** 2 * 3.0 * share / (70.0 * flexible_share(xi) ** 3)


def shift_change(*, l: Quantity, x: Quantity, xi: Quantity = 1.0) -> Computed:
    """Return the relative change that a large stroke makes to the motion towards the base.

    ``λ/λ₀ − 1 = (x/l)² 3N/(140 (3 − 3ξ + ξ²)³ (15 − 25ξ + 15ξ² − 3ξ³))``,
    ``N = 4725 − 18690ξ + 31710ξ² − 29355ξ³ + 15605ξ⁴ − 4548ξ⁵ + 600ξ⁶ − 15ξ⁷``: 12/35 (x/l)² for
    ξ = 1, so λ = 3x²/(5l) + 36x⁴/(175l³), and (x/l)²/4 for ξ → 0.

    Parameters
    ----------
    l, x : Quantity
        Length of the blade and travel of its tip [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    change : Quantity
        True over closed-form motion, less one [-].

    Examples
    --------
    >>> round(35.0 * shift_change(l=1.0, x=0.1), 6)
    0.12

    References
    ----------
    Derived as :func:`force_change`, with λ = ∫(θ²/2 − θ⁴/24) ds.

    """
    share = xi * (29355.0 - xi * (15605.0 - xi * (4548.0 - xi * (600.0 - 15.0 * xi))))
    share = 4725.0 - xi * (18690.0 - xi * (31710.0 - share))
    first = 15.0 - xi * (25.0 - xi * (15.0 - 3.0 * xi))
    return (x / l) ** 2 * 3.0 * share / (140.0 * flexible_share(xi) ** 3 * first)


def flexible_share(xi: Quantity) -> Computed:
    """Return the compliance of the hinges over that of their share of the blade."""
    return 3.0 - 3.0 * xi + xi**2


_STROKE = Range("x/l", -0.35, 0.35, "the change is the next term only")
_BLADE = {"l": 50e-3, "x": 5e-3, "xi": 1.0}

CARDS = (
    Card("stage-stress-at-large-stroke", stress_change, _BLADE, (_STROKE,)),
    Card("stage-shift-at-large-stroke", shift_change, _BLADE, (_STROKE,)),
)
