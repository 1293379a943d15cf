"""Shear, stretching and strain of thick blades in stages and pivots: stiffness, stress, shift.

In stiffness, stress, sag and buckling one share says it for every joint, exactly in Timoshenko's
Φ: that of the compliance (or of the stiffness) which bends in an S and so needs a force across the
blade. A pivot of two blades bends them in a uniform part, free of force, and an S-shaped part
(γ = 1 + 2δ) that a force f = 6γθ/(1 + Φ*) across each blade and ∓f cot α along it keep up [unit
EI/l²]. The shortening that makes the shift is ``λ = ∫(θ²/2 + gθ) ds − fw/(EA)``: a blade's
sections turn by θ, shear by g, and its end force f across it, of first order in the motion w,
stretches it as it turns.

Of the same order is what the law of finite strain makes of a bent blade, which no material states:
bent to ±ε at its faces, its middle grows by −ε²/2 where stress is linear in Green's strain and by
+ε²/2 where it is in Hencky's, of which a beam's is the mean, and by ν ε²/2 in all of them.
"""

from math import pi

import numpy as np

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Numbers, Quantity
from flexcli.formulas.section import shear_parameter

__all__ = [
    "CARDS",
    "buckling_change",
    "pivot_shift_across",
    "pivot_softening",
    "pivot_strain_law",
    "pivot_stretch",
    "s_bending_share",
    "shear_factor",
    "stage_strain_law",
    "stage_stretch",
    "stiffness_change",
]


def s_bending_share(delta: Quantity) -> Computed:
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


def stiffness_change(*, Phi: Quantity, share: Quantity = 1.0, series: Quantity = 1.0) -> Computed:
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


def buckling_change(*, Phi: Quantity, effective_length: Quantity = 1.0) -> Computed:
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


def pivot_softening(
    *, h: Numbers, l: Numbers, half_angle: Numbers, poisson_ratio: float
) -> Computed:
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
    >>> round(float(pivot_softening(h=0.1, l=1.0, half_angle=pi / 4, poisson_ratio=0.25)), 6)
    0.04

    References
    ----------
    Derived: stiffness of both blades condensed on the rotation, the centre unloaded; Φ as in
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6.

    """
    shear = shear_parameter(depth=h, l=l, poisson_ratio=poisson_ratio)
    return shear + (h / l) ** 2 / np.tan(half_angle) ** 2


def pivot_shift_across(
    *,
    h: Numbers,
    l: Numbers,
    p: Numbers,
    theta: Numbers,
    half_angle: Numbers,
    poisson_ratio: float,
) -> Computed:
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
    ``pivot_next_order.shift_across`` adds what bending makes of order θ³. Shear lessens it.

    Examples
    --------
    >>> from math import pi
    >>> thick = {"h": 0.1, "l": 1.0, "half_angle": pi / 4, "poisson_ratio": 0.25}
    >>> round(float(pivot_shift_across(**thick, p=0.0, theta=0.01)), 9)
    -6.7991e-05

    References
    ----------
    As :func:`pivot_softening`.

    """
    Phi = pivot_softening(h=h, l=l, half_angle=half_angle, poisson_ratio=poisson_ratio)
    lever = np.cos(half_angle) / (2.0 * np.sin(half_angle) ** 2 * (1.0 + Phi))
    return -theta * l * (1.0 + 2.0 * p / l) * (h / l) ** 2 * lever


_PIVOT = {"h": 1e-3, "l": 17.5e-3, "half_angle": 0.7, "poisson_ratio": 0.33}


def shear_factor(Phi: Quantity) -> Computed:
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


def stage_stretch(*, h: Quantity, l: Quantity) -> Computed:
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


def pivot_stretch(*, h: Numbers, l: Numbers, p: Numbers, half_angle: Numbers) -> Computed:
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
    Derived, see the module; the centre shifts across by ``thick_blades.pivot_shift_across``.

    """
    gamma, slender = 1.0 + 2.0 * p / l, (h / l) ** 2
    softer = gamma / (1.0 + slender / np.tan(half_angle) ** 2)
    balance = 18.0 * gamma**2 + 15.0 * gamma + (5.0 - 9.0 * gamma**2) * np.tan(half_angle) ** 2
    bends = (gamma - softer) / 4.0 + 3.0 * (gamma**2 - softer**2) / 20.0
    return bends + softer * (softer + 1.0) * slender / 4.0 - slender * balance / 60.0


def stage_strain_law(*, h: Quantity, l: Quantity, poisson_ratio: Quantity) -> Computed:
    """Return the relative change of a motion towards the base by the law of finite strain, at most.

    ``5/2 (1 + ν)(h/l)²`` of guided blades; a cantilever is half a guided blade of twice its length.

    Parameters
    ----------
    h, l : Quantity
        Thickness and length of a guided blade [m].
    poisson_ratio : Quantity
        ν [-].

    Returns
    -------
    change : Quantity
        Motion by some law over that of beams, less one, of either sign [-].

    Examples
    --------
    >>> round(stage_strain_law(h=0.1, l=1.0, poisson_ratio=0.3), 6)
    0.0325

    References
    ----------
    Derived, see the module; strips in plane stress, their radii solved for by either law, have it.

    """
    return 2.5 * (1.0 + poisson_ratio) * (h / l) ** 2


def pivot_strain_law(*, h: Quantity, l: Quantity, p: Quantity, poisson_ratio: Quantity) -> Computed:
    """Return what the law of finite strain may add to the bracket of a pivot's shift, at most.

    ``(1 + ν)(h/l)² (1 + 3γ²)/8``, ``γ = 1 + 2δ``, beside ``(5 − 9γ²)/60``, the bracket of slender
    blades.

    Parameters
    ----------
    h, l : Quantity
        Thickness and length of a blade [m].
    p : Quantity
        Distance from the centre to the inner ends [m].
    poisson_ratio : Quantity
        ν [-].

    Returns
    -------
    bracket : Quantity
        Change of the shift along the bisector over l θ²/cos α, of either sign [-].

    Examples
    --------
    >>> round(pivot_strain_law(h=0.1, l=1.0, p=-0.5, poisson_ratio=0.3), 6)
    0.001625

    References
    ----------
    Derived, see the module; as for stages.

    """
    gamma = 1.0 + 2.0 * p / l
    return (1.0 + poisson_ratio) * (h / l) ** 2 * (1.0 + 3.0 * gamma**2) / 8.0


_STAGE = {"h": 1e-3, "l": 17.5e-3}
_LAW = {**_STAGE, "poisson_ratio": 0.33}


CARDS: tuple[Card, ...] = (
    Card("s-bending-share", s_bending_share, {"delta": 0.1}),
    Card("shear-in-stiffness", stiffness_change, {"Phi": 0.03, "share": 0.75}, (_SHORT,)),
    Card("shear-in-buckling", buckling_change, {"Phi": 0.03}, (_SHORT,)),
    Card("pivot-shear-and-stretch", pivot_softening, _PIVOT),
    Card("pivot-shift-of-thick-blades", pivot_shift_across, {**_PIVOT, "p": 2e-3, "theta": 0.05}),
    Card("shear-in-shift", shear_factor, {"Phi": 0.03}),
    Card("stretching-in-stage-shift", stage_stretch, _STAGE),
    Card("stretching-in-pivot-shift", pivot_stretch, {**_STAGE, "p": 2e-3, "half_angle": 0.7}),
    Card("strain-law-in-stage-shift", stage_strain_law, _LAW),
    Card("strain-law-in-pivot-shift", pivot_strain_law, {**_LAW, "p": 2e-3}),
)
