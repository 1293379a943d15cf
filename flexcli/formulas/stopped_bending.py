"""Deflection, moment and stress along a cantilever that may rest on a stop at height L_a.

Arguments and signs are those of :mod:`flexcli.formulas.stopped_cantilever`.
"""

import numpy as np

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Quantity
from flexcli.formulas.stopped_cantilever import reaction

__all__ = ["CARDS", "bending_moment", "bending_stress", "deflection"]


def _of_force(force: Quantity, at: Quantity, x: Quantity, rigidity: Quantity) -> Quantity:
    """Return the deflection at x of a cantilever under one lateral force at a height."""
    near = np.minimum(x, at)
    # straight beyond the force: slope of the bent part times the rest of the way
    bent = force * near**2 * (3.0 * at - near) / (6.0 * rigidity)
    return bent + force * near * (2.0 * at - near) / (2.0 * rigidity) * (x - near)


def deflection(
    *,
    x: Quantity,
    F: Quantity,
    E: Quantity,
    I: Quantity,
    L_a: Quantity,
    L_b: Quantity,
    d: Quantity,
    d_behind: Quantity = np.inf,
) -> Quantity:
    """Return the deflection at height x of a cantilever that may rest on a stop.

    ``δ(x) = δ_F(x) + δ_R(x)``: superposed cantilevers under F at the tip and R at L_a, each
    ``P x² (3s − x)/(6EI)`` up to its force at s and straight beyond.

    Parameters
    ----------
    x : Quantity
        Height above the clamped end [m], 0 ≤ x ≤ L; L gives the tip.
    F : Quantity
        Force at the tip [N].
    E : Quantity
        Young's modulus [Pa].
    I : Quantity
        Second moment of area [m⁴].
    L_a, L_b : Quantity
        Length below and above the stops [m].
    d, d_behind : Quantity
        Gap on the side of + and of − [m]; infinite for no stop.

    Returns
    -------
    Quantity
        Deflection [m].

    Raises
    ------
    ValueError
        When a gap is negative.

    Examples
    --------
    >>> blade = {"E": 6.0, "I": 1.0, "L_a": 1.0, "L_b": 1.0, "d": 0.5}
    >>> round(float(deflection(x=1.0, F=9.0, **blade)), 12)
    0.5

    References
    ----------
    Monti (2014), section 4.1.3, step 8 and the equations for any x below it.

    """
    force = reaction(F=F, E=E, I=I, L_a=L_a, L_b=L_b, d=d, d_behind=d_behind)
    return _of_force(F, L_a + L_b, x, E * I) + _of_force(force, L_a, x, E * I)


def bending_moment(
    *,
    x: Quantity,
    F: Quantity,
    E: Quantity,
    I: Quantity,
    L_a: Quantity,
    L_b: Quantity,
    d: Quantity,
    d_behind: Quantity = np.inf,
) -> Quantity:
    """Return the bending moment at height x of a cantilever that may rest on a stop.

    ``M(x) = F (L − x) + R (L_a − x)``, the second term below the stop only: ``F L_b`` at the
    stop, ``F′ L − F″ L_b/2`` at the base.

    Parameters
    ----------
    x : Quantity
        Height above the clamped end [m].
    F : Quantity
        Force at the tip [N].
    E : Quantity
        Young's modulus [Pa].
    I : Quantity
        Second moment of area [m⁴].
    L_a, L_b : Quantity
        Length below and above the stops [m].
    d, d_behind : Quantity
        Gap on the side of + and of − [m]; infinite for no stop.

    Returns
    -------
    Quantity
        Moment [N·m], positive where it bends the blade towards +.

    Raises
    ------
    ValueError
        When a gap is negative.

    Notes
    -----
    Contact relieves the base and loads the blade at the stop. Under a given F the moment at the
    stop stays below that of the free blade's base; at a given travel of the tip it does not, for
    F grows with k_contact.

    Examples
    --------
    >>> blade = {"E": 6.0, "I": 1.0, "L_a": 1.0, "L_b": 1.0, "d": 0.5}
    >>> [round(float(bending_moment(x=x, F=5.6, **blade)), 9) for x in (0.0, 1.0)]
    [6.2, 5.6]

    References
    ----------
    Monti (2014), section 9.1.2.

    """
    force = reaction(F=F, E=E, I=I, L_a=L_a, L_b=L_b, d=d, d_behind=d_behind)
    return F * (L_a + L_b - x) + force * np.maximum(L_a - x, 0.0)


def bending_stress(*, M: Quantity, I: Quantity, h: Quantity) -> Quantity:
    """Return the bending stress at the surface of a blade of thickness h.

    ``σ = M h/(2 I)``.

    Parameters
    ----------
    M : Quantity
        Bending moment [N·m].
    I : Quantity
        Second moment of area [m⁴].
    h : Quantity
        Thickness across the axis of bending [m].

    Returns
    -------
    Quantity
        Stress at the surface [Pa], with the sign of M.

    Examples
    --------
    >>> round(bending_stress(M=56.3e-3, I=1.2695e-12, h=1.25e-3) / 1e6, 1)
    27.7

    References
    ----------
    Monti (2014), section 9.1.1, σ = M y/I.

    """
    return M * h / (2.0 * I)


_BLADE = {"F": 3.0, "E": 60e9, "I": 1.2695e-12, "L_a": 14.25e-3, "L_b": 14.25e-3, "d": 30e-6}
_SMALL = (Range("delta/L", -0.1, 0.1, "small rotation"),)

CARDS: tuple[Card, ...] = (
    Card("stopped-cantilever-deflection", deflection, {"x": 28.5e-3, **_BLADE}, _SMALL),
    Card("stopped-cantilever-moment", bending_moment, {"x": 14.25e-3, **_BLADE}, _SMALL),
    Card("bending-stress", bending_stress, {"M": 56.3e-3, "I": 1.2695e-12, "h": 1.25e-3}),
)
