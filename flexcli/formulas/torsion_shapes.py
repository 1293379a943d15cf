"""Sections in torsion in powers of their dimensions: strip, star of strips, circle."""

from math import exp, inf, pi, tan

import numpy as np

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.formulas.torsion_fibres import rectangle_fourth_moment
from flexcli.results import QuantityKind

__all__ = [
    "CIRCLE_CARDS",
    "SHORT_ARM",
    "STAR_CARDS",
    "STRIP_CARDS",
    "circle_torsion_constant",
    "star_area",
    "star_arm",
    "star_core_error",
    "star_fourth_moment",
    "star_polar_moment",
    "star_shear_factor",
    "star_side_error",
    "star_torsion_constant",
    "strip_torsion_constant",
]


def strip_torsion_constant(h: Quantity, b: Quantity) -> Computed:
    """Return the torsion constant of a rectangle of thin side h, close and in powers only.

    ``J ≈ b h³/3 − 0.21008 h⁴ + 0.0175 h^7.5/b^3.5``.

    Parameters
    ----------
    h, b : Quantity
        Thin side and broad side [m], h ≤ b.

    Returns
    -------
    J : Quantity
        Torsion constant [m⁴].

    Notes
    -----
    The first two terms are those of the exact series; the last stands for what remains of it.
    Within 0.21 % of the exact constant for every h ≤ b, where the usual last term 0.0175 h⁸/b⁴
    leaves 0.5 %. Arithmetic alone: it takes signomials.

    Examples
    --------
    >>> round(strip_torsion_constant(1.0, 1.0), 6)
    0.14075

    References
    ----------
    Shortened from Timoshenko & Goodier (1970), Theory of Elasticity, section 109.

    """
    return b * h**3 / 3.0 - 0.210083 * h**4 + 0.0175 * h**7.5 / b**3.5


_CORE = {2: -0.0848, 3: 1.3047, 4: 5.187, 5: 13.18, 6: 27.30}
_CORE_ERROR = {2: 0.0002, 3: 0.001, 4: 0.005, 5: 0.01, 6: 0.03}
_SHORT_ARMS = {2: 1.0, 3: 2.7, 4: 5.1, 5: 8.2, 6: 12.2}

_SIDE = {2: -0.3452, 3: 0.009, 4: 0.3446, 5: 0.673, 6: 0.999}
_SHORT_SIDE = {2: 0.733, 3: 0.861, 4: 1.016, 5: 1.17, 6: 1.33}
SIDE_ERROR = 0.01
"""Largest error of ``star_shear_factor`` over what fades along half an arm [-]."""


def star_torsion_constant(h: Quantity, b: Quantity, strips: int) -> Computed:
    """Return the torsion constant of strips of full width b that cross in one axis, as one section.

    ``J = n b h³/3 + c_n h⁴``: two strips make the cruciform (plus) section, three a star of six
    arms. c_n is what the junction adds and the free edges take.

    Parameters
    ----------
    h, b : Quantity
        Thickness and full width of a strip, edge to edge [m].
    strips : int
        Number n of strips.

    Returns
    -------
    J : Quantity
        Torsion constant [m⁴].

    Notes
    -----
    Arms of at least one thickness beyond the core (``star_arm``). c_2 = −0.0848 (the edges take
    0.42, the junction adds 0.335); the more strips cross, the thicker is the core: c_3 = 1.305,
    c_4 = 5.19, c_5 = 13.2, c_6 = 27.3, from the Poisson equation on half an arm, by finite elements
    that crowd at the re-entrant corner; what core and edge change of each other fades with the arm
    (``star_core_error``). Of more than six the core is left out.

    Examples
    --------
    >>> round(star_torsion_constant(1.0, 6.0, strips=2), 9)
    3.9152

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, chapter 10 (thin open sections).

    """
    return strips * b * h**3 / 3.0 + _CORE.get(strips, 0.0) * h**4


def star_shear_factor(h: Quantity, b: Quantity, strips: int) -> Computed:
    """Return the shear stress in the middle of an arm's sides over that of a thin strip, G h φ'.

    ``k = 1 + (s_n − t_n e^(−π a)) e^(−π a/2)`` with the free length a of an arm over its thickness:
    edge and core, half an arm away, fade so.

    Parameters
    ----------
    h, b : Quantity
        Thickness and full width of a strip, edge to edge [m].
    strips : int
        Number n of strips.

    Returns
    -------
    k : Quantity
        Factor [-]; that of an arm of one thickness for shorter ones, 1 of more than six strips.

    Notes
    -----
    The edge takes 8/π² of what fades, the core adds to it: of two strips s is −0.345, of three
    0.009, of four 0.345, of five 0.67, of six 1.0. Within 1 % of what fades of the Poisson equation
    on half an arm, by finite elements; arms of a thickness and more.

    Examples
    --------
    >>> round(float(star_shear_factor(1.0, 3.0, strips=2)), 3)
    0.922

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, section 109, for the edge alone.

    """
    arm = np.maximum(star_arm(h, b, strips), 1.0)
    fading = np.exp(-pi * arm / 2.0)
    return 1.0 + (_SIDE.get(strips, 0.0) - _SHORT_SIDE.get(strips, 0.0) * fading**2) * fading


def star_side_error(arm: float, strips: int) -> float:
    """Return the error of ``star_shear_factor`` [-].

    Parameters
    ----------
    arm : float
        Free length of an arm over its thickness, from ``star_arm`` [-].
    strips : int
        Number n of strips.

    Returns
    -------
    error : float
        Relative error, infinite for arms shorter than h [-].

    Notes
    -----
    Of more than six strips, of which ``star_shear_factor`` knows nothing, what the core changes:
    0.31 n times what fades, as of 8, 12, 30 and 100.

    Examples
    --------
    >>> round(star_side_error(1.0, strips=2), 4)
    0.0023

    """
    if arm < 1.0:
        return inf
    fading = exp(-pi * arm / 2.0)
    if strips not in _SIDE:
        return 0.31 * strips * fading
    factor = 1.0 + (_SIDE[strips] - _SHORT_SIDE[strips] * fading**2) * fading
    return SIDE_ERROR * fading / factor


def star_arm(h: Quantity, b: Quantity, strips: int) -> Computed:
    """Return the length of an arm of crossing strips beyond their core, over the thickness.

    ``a = b/2h − ½ cot(π/2n)``: from the corner that two arms make to the edge.

    Parameters
    ----------
    h, b : Quantity
        Thickness and full width of a strip, edge to edge [m].
    strips : int
        Number n of strips.

    Returns
    -------
    a : Quantity
        Free length of an arm over its thickness [-].

    Notes
    -----
    Exact.

    Examples
    --------
    >>> round(star_arm(1.0, 6.0, strips=2), 9)
    2.5

    References
    ----------
    Geometry of the section.

    """
    return b / h / 2.0 - _to_corner(strips)


def _to_corner(strips: int) -> float:
    """Return how far from the axis two arms part, along an arm and over the thickness [-]."""
    return 0.5 / tan(pi / (2.0 * strips))


def star_area(h: Quantity, b: Quantity, strips: int) -> Computed:
    """Return the area of strips of full width b that cross in one axis, their core counted once.

    ``A = n h (b − c h)``, ``c = ½ cot(π/2n)``: two strips have 2 b h − h².

    Examples
    --------
    >>> round(star_area(1.0, 6.0, strips=2), 9)
    11.0

    """
    return strips * h * (b - _to_corner(strips) * h)


def star_polar_moment(h: Quantity, b: Quantity, strips: int) -> Computed:
    """Return ∫r² dA of strips that cross, twice their second moment about any axis across [m⁴].

    ``I_p = n (h b³ + b h³)/12 − n h⁴ (c³/6 + c/8)``, ``c = ½ cot(π/2n)``: what the strips have in
    common, a polygon of 2n sides h, is counted once.

    Examples
    --------
    >>> round(star_polar_moment(1.0, 6.0, strips=2) * 6.0, 9)
    221.0

    """
    c = _to_corner(strips)
    return strips * ((h * b**3 + b * h**3) / 12.0 - h**4 * (c**3 / 6.0 + c / 8.0))


def star_fourth_moment(h: Quantity, b: Quantity, strips: int) -> Computed:
    """Return ∫r⁴ dA of strips that cross, their core counted once [m⁶].

    Examples
    --------
    >>> core = 1.0 / 40.0 + 1.0 / 72.0
    >>> twice = 2.0 * rectangle_fourth_moment(1.0, 6.0)
    >>> round(float(star_fourth_moment(1.0, 6.0, strips=2) / (twice - core)), 9)
    1.0

    """
    c = _to_corner(strips)
    common = 2.0 * h**6 * (c**5 / 30.0 + c**3 / 36.0 + c / 96.0)
    return strips * (rectangle_fourth_moment(h, b) - common)


def star_core_error(arm: float, strips: int) -> float:
    """Return by how much the torsion constant of crossing strips may be off, over h⁴.

    ``e_n + A_n exp(−π a)`` with the free length a of an arm over its thickness: the slowest way
    in which core and edge feel each other fades so.

    Parameters
    ----------
    arm : float
        Free length of an arm over its thickness, from ``star_arm`` [-].
    strips : int
        Number n of strips.

    Returns
    -------
    error : float
        Bound over h⁴ [-], infinite for more than six strips and for arms shorter than h.

    Notes
    -----
    A_n bounds the same solutions at a = 1 to 3.

    Examples
    --------
    >>> round(star_core_error(2.5, strips=2), 5)
    0.00059

    References
    ----------
    Saint-Venant's principle for strips with free faces: Timoshenko & Goodier (1970), Theory of
    Elasticity, chapter 10.

    """
    if arm < 1.0 or strips not in _CORE:
        return inf
    return _CORE_ERROR[strips] + _SHORT_ARMS[strips] * exp(-pi * arm)


def circle_torsion_constant(d: Quantity) -> Computed:
    """Return the torsion constant of a circular section, whose edge is sheared by G φ' d/2.

    ``J = π d⁴/32``.

    Parameters
    ----------
    d : Quantity
        Diameter [m].

    Returns
    -------
    J : Quantity
        Torsion constant [m⁴].

    Notes
    -----
    Exact; a circle does not warp.

    Examples
    --------
    >>> round(circle_torsion_constant(1.0), 6)
    0.098175

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, chapter 10.

    """
    return pi * d**4 / 32.0


STRIP_CARDS: tuple[Card, ...] = (
    Card(
        name="strip-torsion-constant",
        function=strip_torsion_constant,
        example={"h": 0.5e-3, "b": 5e-3},
        validity=(Range("h/b", most=1.0, why="h is the thin side"),),
    ),
)

SHORT_ARM = Range("arm/h", least=1.0, why="the strips' ends and their crossing feel each other")

STAR_CARDS: tuple[Card, ...] = (
    Card(
        name="star-shear-factor",
        function=star_shear_factor,
        example={"h": 0.5e-3, "b": 2e-3, "strips": 2},
        validity=(SHORT_ARM,),
        kind=QuantityKind.STRESS,
    ),
    Card(
        name="star-torsion-constant",
        function=star_torsion_constant,
        example={"h": 0.5e-3, "b": 10e-3, "strips": 2},
        validity=(SHORT_ARM,),
        kind=QuantityKind.STIFFNESS,
    ),
)

CIRCLE_CARDS: tuple[Card, ...] = (
    Card(
        name="circle-torsion-constant",
        function=circle_torsion_constant,
        example={"d": 1e-3},
    ),
)
