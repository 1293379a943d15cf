"""Statics of a cantilever that meets a stop: contact, forces, deflection and stress.

A lateral force F acts at the tip. Stops stand at height L_a, one at +d and, unless its gap is
infinite, one at −d_behind; L_b = L − L_a. Deflection and F share their sign; the reaction of a
stop is positive when it pushes towards +. Small rotation, slender blade, rigid frictionless stops.
"""

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Numbers, Quantity
from flexcli.formulas.stop_stiffness import bent_shape, contact_stiffness, free_stiffness

__all__ = [
    "CARDS",
    "bending_moment",
    "bending_stress",
    "contact_load",
    "excess_load",
    "load_at_travel",
    "reaction",
]


def _gap(name: str, d: Quantity) -> NDArray[np.float64]:
    """Return a gap as an array, or refuse one with which the blade would start inside its stop."""
    gap = np.asarray(d, dtype=np.float64)
    if not (gap >= 0.0).all():  # also refuses NaN
        raise ValueError(f"{name} must not be negative, the blade starts inside its stop: {gap}")
    return gap


def contact_load(
    *, E: Quantity, I: Quantity, L_a: Quantity, L_b: Quantity, d: Quantity
) -> Computed:
    """Return the tip force at which a cantilever just touches the stop.

    ``F′ = d 6EI/(L_a² (3L − L_a))``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    I : Quantity
        Second moment of area [m⁴].
    L_a, L_b : Quantity
        Length below and above the stop [m].
    d : Quantity
        Gap [m]; infinite for no stop.

    Returns
    -------
    Quantity
        Force at the tip [N].

    Raises
    ------
    ValueError
        When a gap is negative.

    Examples
    --------
    >>> round(float(contact_load(E=60e9, I=1.2695e-12, L_a=0.02565, L_b=0.00285, d=87.3e-6)), 3)
    1.013

    References
    ----------
    Monti (2014), section 4.1.3, step 1.

    """
    return 6.0 * E * I * _gap("d", d) / (L_a**2 * (2.0 * L_a + 3.0 * L_b))


def excess_load(
    *,
    F: Numbers,
    E: Numbers,
    I: Numbers,
    L_a: Numbers,
    L_b: Numbers,
    d: Numbers,
    d_behind: Numbers = np.inf,
) -> Computed:
    """Return the part of the tip force beyond the one that makes contact, with its sign.

    ``F″ = F − F′`` once the blade touches, 0 before: what is not 0 is contact.

    Parameters
    ----------
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
        Force carried by the blade on its stop [N].

    Raises
    ------
    ValueError
        When a gap is negative.

    Examples
    --------
    >>> blade = {"E": 6.0, "I": 1.0, "L_a": 1.0, "L_b": 1.0, "d": 0.5}
    >>> [round(float(excess_load(F=F, **blade)), 12) for F in (4.0, -4.0)]
    [0.4, 0.0]

    References
    ----------
    Monti (2014), section 4.1.3, steps 2 and 3.

    """
    ahead = contact_load(E=E, I=I, L_a=L_a, L_b=L_b, d=d)
    behind = contact_load(E=E, I=I, L_a=L_a, L_b=L_b, d=_gap("d_behind", d_behind))
    return F - np.clip(F, -behind, ahead)


def reaction(
    *,
    F: Numbers,
    E: Numbers,
    I: Numbers,
    L_a: Numbers,
    L_b: Numbers,
    d: Numbers,
    d_behind: Numbers = np.inf,
) -> Computed:
    """Return the force of the stops on the blade, with its sign; 0 without contact.

    ``R = F″ (L_a − 3L)/(2 L_a)``: it opposes the tip force and exceeds its part beyond contact.

    Parameters
    ----------
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
        Force at the stop [N].

    Raises
    ------
    ValueError
        When a gap is negative.

    Examples
    --------
    >>> round(float(reaction(F=4.0, E=6.0, I=1.0, L_a=1.0, L_b=1.0, d=0.5)), 12)
    -1.0

    References
    ----------
    Monti (2014), section 4.1.3, step 4.

    """
    excess = excess_load(F=F, E=E, I=I, L_a=L_a, L_b=L_b, d=d, d_behind=d_behind)
    return -excess * (2.0 * L_a + 3.0 * L_b) / (2.0 * L_a)


def load_at_travel(
    *,
    delta: Numbers,
    E: Numbers,
    I: Numbers,
    L_a: Numbers,
    L_b: Numbers,
    d: Numbers,
    d_behind: Numbers = np.inf,
) -> Computed:
    """Return the tip force that holds the tip at a deflection δ, in contact or not.

    ``F = k_free δ′ + k_contact (δ − δ′)`` with δ′ the part of δ travelled before contact,
    at the most ``d/φ(L_a/L)``.

    Parameters
    ----------
    delta : Quantity
        Deflection of the tip [m].
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
        Force at the tip [N].

    Raises
    ------
    ValueError
        When a gap is negative.

    Examples
    --------
    >>> blade = {"E": 6.0, "I": 1.0, "L_a": 1.0, "L_b": 1.0, "d": 0.5}
    >>> round(float(load_at_travel(delta=1.6, **blade)), 12), float(excess_load(F=3.6, **blade))
    (3.6, 0.0)

    References
    ----------
    Monti (2014), section 4.1.3, steps 5 to 8, solved for F.

    """
    L = L_a + L_b
    share = bent_shape(L_a / L)
    free = np.clip(delta, -_gap("d_behind", d_behind) / share, _gap("d", d) / share)
    stiff = contact_stiffness(E=E, I=I, L_a=L_a, L_b=L_b)
    return free_stiffness(E=E, I=I, L=L) * free + stiff * (delta - free)


_BLADE = {"E": 60e9, "I": 1.2695e-12, "L_a": 14.25e-3, "L_b": 14.25e-3, "d": 30e-6}
_VALIDITY = (
    Range("delta/L", -0.1, 0.1, "small rotation"),
    Range("h/L_b", most=0.5, why="shear of the overhang is left out"),
)


def bending_moment(
    *,
    x: Numbers,
    F: Numbers,
    E: Numbers,
    I: Numbers,
    L_a: Numbers,
    L_b: Numbers,
    d: Numbers,
    d_behind: Numbers = np.inf,
) -> Computed:
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


def bending_stress(*, M: Quantity, I: Quantity, h: Quantity) -> Computed:
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


_PUSHED = {"F": 3.0, "E": 60e9, "I": 1.2695e-12, "L_a": 14.25e-3, "L_b": 14.25e-3, "d": 30e-6}
_SMALL = (Range("delta/L", -0.1, 0.1, "small rotation"),)


CARDS: tuple[Card, ...] = (
    Card("stop-contact-load", contact_load, _BLADE, _VALIDITY),
    Card("stop-excess-load", excess_load, {"F": 3.0, **_BLADE}, _VALIDITY),
    Card("stop-reaction", reaction, {"F": 3.0, **_BLADE}, _VALIDITY),
    Card("stop-load-at-travel", load_at_travel, {"delta": 150e-6, **_BLADE}, _VALIDITY),
    Card("stopped-cantilever-moment", bending_moment, {"x": 14.25e-3, **_PUSHED}, _SMALL),
    Card("bending-stress", bending_stress, {"M": 56.3e-3, "I": 1.2695e-12, "h": 1.25e-3}),
)
