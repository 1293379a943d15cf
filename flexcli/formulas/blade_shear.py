"""What shear does to stiffness, stress, sag and buckling of blades, exactly in Timoshenko's Φ.

One share says it for every joint: that of the compliance (or of the stiffness) which bends in an
S and so needs a force across the blade.
"""

from math import pi

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "buckling_change", "s_bending_share", "stiffness_change"]


def s_bending_share(delta: Quantity) -> Quantity:
    """Return the share of a pivot's stiffness that is S-shaped bending.

    ``3(1 + 2δ)²/(1 + 3(1 + 2δ)²)``: none for the symmetric pivot, 3/4 for p = 0.

    Parameters
    ----------
    delta : Quantity
        δ = p/l [-].

    Returns
    -------
    share : Quantity
        Share of the stiffness [-].

    Examples
    --------
    >>> s_bending_share(0.0)
    0.75

    References
    ----------
    Bending split into a uniform and an S-shaped part, 4EI/l(1 + 3δ + 3δ²) = EI/l(1 + 3(1 + 2δ)²).

    """
    share = 3.0 * (1.0 + 2.0 * delta) ** 2
    return share / (1.0 + share)


def stiffness_change(*, Phi: Quantity, share: Quantity = 1.0, series: Quantity = 1.0) -> Quantity:
    """Return the relative change that shear makes to a stiffness.

    ``−share · series Φ/(1 + series Φ)``: share 1 and series 1 for guided blades and stages,
    share 1 and series ¼ for a cantilever, share ``s_bending_share`` for pivots.

    Parameters
    ----------
    Phi : Quantity
        Timoshenko's parameter 12EI/(κGA l²) of the blade, ``section.shear_parameter`` [-].
    share : Quantity
        Share of the stiffness that bends in an S [-].
    series : Quantity
        Share of Φ that is in series with it [-].

    Returns
    -------
    change : Quantity
        Stiffness with shear over that without, less one [-].

    Notes
    -----
    Exact at small rotation. At a given stroke the stress of stages and cantilevers changes alike,
    for a pivot by the share 3|γ|/(1 + 3|γ|) in place of 3γ²/(1 + 3γ²); a sag changes by the
    inverse, 1/(1 + change) − 1, with Φ of the side that bends.

    Examples
    --------
    >>> stiffness_change(Phi=1.0), stiffness_change(Phi=1.0, series=0.25)
    (-0.5, -0.2)

    References
    ----------
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6.

    """
    return -share * series * Phi / (1.0 + series * Phi)


def buckling_change(*, Phi: Quantity, effective_length: Quantity = 1.0) -> Quantity:
    """Return the relative change that shear makes to a critical axial force.

    ``P/P_E − 1 = −u/(1 + u)``, ``u = P_E/(κGA) = π²Φ/(12 k²)``, k the effective length over l.

    Parameters
    ----------
    Phi : Quantity
        Timoshenko's parameter 12EI/(κGA l²) of the blade [-].
    effective_length : Quantity
        k: 1 clamped–guided, ½ clamped–clamped, 2 clamped–free [-].

    Returns
    -------
    change : Quantity
        Critical force with shear over Euler's, less one [-].

    Notes
    -----
    Engesser's form. Haringx's, whose shear force is normal to the section as in the exact solver,
    is (√(1 + 4u) − 1)/(2u) − 1: −u as well at first, and higher by u² then.

    Examples
    --------
    >>> round(buckling_change(Phi=0.01), 6)
    -0.008158

    References
    ----------
    Engesser (1891); Timoshenko & Gere (1961), Theory of Elastic Stability, section 2.17.

    """
    u = pi**2 * Phi / (12.0 * effective_length**2)
    return -u / (1.0 + u)


_SHORT = Range("Phi", 0.0, 1.0, "a blade as thick as this is no beam")

CARDS = (
    Card("s-bending-share", s_bending_share, {"delta": 0.1}),
    Card("shear-in-stiffness", stiffness_change, {"Phi": 0.03, "share": 0.75}, (_SHORT,)),
    Card("shear-in-buckling", buckling_change, {"Phi": 0.03}, (_SHORT,)),
)
