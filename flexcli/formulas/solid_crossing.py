"""Blades that are one piece where they cross: what their crossing gives way beside beams.

The crossing is a problem of plane elasticity of its own: four arms that meet at the angle 2α.
Against Timoshenko's beams that meet in a point it has a compliance, mostly negative, which in units
of h and of the modulus depends on α alone, but for what ν adds to one term.
"""

from math import inf, pi, radians
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range

__all__ = [
    "ANGLES",
    "BEAMS",
    "CARDS",
    "FIT",
    "Arms",
    "CrossingCompliance",
    "JoinedAcross",
    "OfHalves",
    "arms_in_a_point",
    "crossed_blades",
    "crossing_compliance",
    "crossing_offset",
    "crossing_reach",
    "crossing_shift",
    "joined_across",
    "relieved",
    "solid_crossing",
    "with_crossing",
]

Floats = NDArray[np.float64]
Both = tuple[ArrayLike, ArrayLike]

ANGLES = radians(5.0), radians(85.0)
"""Half-angles of the fits [rad]."""

FIT = 5e-3
"""Error of what a crossing makes stiffer, in a plane [-]."""

_MOMENT = (
    -4.8363, -5.3926, -9.7709, -8.4464, -7.8698, 3.4762, 13.493, 5.9196, -6.318, -4.8779,
)  # fmt: skip
_MIXED = (
    -0.053092, -1.7695, 3.8182, 2.5947, 0.072024, -0.48855, -1.6709, -1.0554, 0.89213, 0.76722,
)  # fmt: skip
_SHEAR = (
    -0.26069, 1.0081, -1.449, -0.21759, 0.21414, -0.48713, 0.23923, 0.52255, -0.1609, -0.23384,
)  # fmt: skip
_OTHER = (
    0.013581, 0.095832, 0.20997, -0.0062934, -0.58072, -0.47902, 0.41055, 0.48282, -0.16435,
    -0.20563,
)  # fmt: skip
_PULLED = (
    -0.020694, 0.91323, -0.64024, -0.22684, 0.49422, 0.062355, -0.14673, -0.0785, 0.017541,
    0.037977,
)  # fmt: skip
"""Polynomials in 4α/π − 1 of the terms times (sin α cos α) to the power of 1, 2, 3, 3 and 2."""


class CrossingCompliance(NamedTuple):
    """Compliance of a crossing less that of beams that meet in a point, times E' b [-].

    Twice its energy is ``(moment M² + 2 mixed M h (V₁ + V₂) + (shear (V₁² + V₂²) + 2 other V₁ V₂
    + 2 pulled N (V₁ − V₂)) h²)/(E' b h²)``: at the crossing every blade bears M, and V₁ or V₂
    across it on the side of the base or of the body, where the moment falls to M − V x; one blade
    is pulled by N, the other pushed as much.
    """

    moment: Floats
    mixed: Floats
    shear: Floats
    other: Floats
    pulled: Floats


class JoinedAcross(NamedTuple):
    """Motion of the body across the bisector at a small rotation, over that and l [-].

    ``beams`` is that of beams that meet in a point, ``solid`` that of blades of one piece, and
    ``of_pulled`` what a unit more of ``CrossingCompliance.pulled`` adds to it.
    """

    beams: Floats
    solid: Floats
    of_pulled: Floats


def crossing_compliance(*, half_angle: ArrayLike, poisson_ratio: ArrayLike) -> CrossingCompliance:
    """Return what blades that are one piece where they cross give way beside beams.

    ``c = polynomial(4α/π − 1)/(sin α cos α)^k − [2.4 ν]``, k = 1 for moments, 2 for moments with
    shear, of which alone 2.4 ν is taken, 3 for shear; 2 for a pull with shear, to which ν is added.

    Parameters
    ----------
    half_angle : array_like
        Angle α from the bisector to a blade [rad].
    poisson_ratio : array_like
        ν of plane stress; ν/(1 − ν) in plane strain, where E' = E/(1 − ν²) [-].

    Returns
    -------
    compliance : CrossingCompliance
        Each term [-].

    Notes
    -----
    α from 5° to 85°. What moments alone turn is independent of ν, as Michell showed of plane
    stresses; the forces that arms bear across keep those along them in balance.

    Examples
    --------
    >>> round(float(crossing_compliance(half_angle=pi / 4.0, poisson_ratio=0.3).moment), 2)
    -9.67

    References
    ----------
    Plane elements of order 5, graded to the corners (``tests/benchmarks/plane_crossing.py``),
    fitted here within 6e-4 in moments.

    """
    alpha = np.asarray(half_angle, dtype=np.float64)
    x, wide = 4.0 * alpha / pi - 1.0, np.sin(alpha) * np.cos(alpha)
    fits = (_MOMENT, 1), (_MIXED, 2), (_SHEAR, 3), (_OTHER, 3), (_PULLED, 2)
    moment, mixed, shear, other, pulled = (
        np.polynomial.polynomial.polyval(x, fit) / wide**power for fit, power in fits
    )
    nu = np.asarray(poisson_ratio)
    return CrossingCompliance(moment, mixed - 2.4 * nu, shear, other, pulled + nu)


def crossing_offset(*, half_angle: ArrayLike) -> Floats:
    """Return over which length from the crossing blades are as if rigid, over their thickness.

    ``s/h = −c/48``, c that of moments: 0.20 at 45°, 2.2 at 80°, 0.59 at 10°.

    Parameters
    ----------
    half_angle : array_like
        Angle α from the bisector to a blade [rad].

    Returns
    -------
    offset : array
        s/h [-].

    Notes
    -----
    To first order in h/l: what turns them beside moments is of the next.

    Examples
    --------
    >>> round(float(crossing_offset(half_angle=pi / 4.0)), 3)
    0.202

    References
    ----------
    See :func:`crossing_compliance`.

    """
    return -crossing_compliance(half_angle=half_angle, poisson_ratio=0.0).moment / 48.0


def crossing_reach(*, half_angle: ArrayLike) -> Floats:
    """Return how far the rhombus that blades share reaches along them, over their thickness.

    ``max(tan α, cot α)/2``: half its length.

    Parameters
    ----------
    half_angle : array_like
        Angle α from the bisector to a blade [rad].

    Returns
    -------
    reach : array
        From the middle to the farther corner [-].

    Examples
    --------
    >>> round(float(crossing_reach(half_angle=pi / 4.0)), 9)
    0.5

    References
    ----------
    Geometry of two strips.

    """
    slope = np.tan(np.asarray(half_angle, dtype=np.float64))
    return np.asarray(np.maximum(slope, 1.0 / slope) / 2.0)


def crossed_blades(h: float, l: float, crossing: float, half_angle: float) -> tuple[float, float]:
    """Return the range of what a solid crossing makes of the stiffness of joined blades, any way.

    ``1/(1 + x/2)`` to ``(1 − 5y/4)⁻⁴``, x the share of the shorter half that the crossing reaches,
    y that over which it is as if rigid, ``crossing_offset``.

    Parameters
    ----------
    h, l : float
        Thickness of a blade, and length from end to end [m].
    crossing : float
        Share c of the length on the side of the base [-].
    half_angle : float
        Angle α from the bisector to a blade [rad].

    Returns
    -------
    range : tuple
        Over the stiffness of beams that meet in a point; the latter infinite where x ≥ 1 [-].

    Notes
    -----
    The forms are those of blades that are rigid so far, whatever bends them, and of a length that
    both share and that was counted twice. Planes of 30 joints were, in any direction,
    1/(1 + 0.3 x) to (1 − 1.06 y)⁻⁴ times as stiff as beams; α from 5° to 85°.

    Examples
    --------
    >>> least, most = crossed_blades(1e-3, 0.1, 0.5, pi / 4.0)
    >>> round(least, 4), round(most, 4)
    (0.995, 1.0204)

    References
    ----------
    Derived here; held against plane elements of whole joints and solids of them out of their plane
    (``tests/benchmarks/crossed_solids.py``).

    """
    thick = h / (min(crossing, 1.0 - crossing) * l)
    shared = float(crossing_reach(half_angle=half_angle)) * thick
    rigid = 1.25 * float(crossing_offset(half_angle=half_angle)) * thick
    return 1.0 / (1.0 + shared / 2.0), (1.0 - rigid) ** -4.0 if rigid < 1.0 else inf


def crossing_shift(*, half_angle: ArrayLike) -> Floats:
    """Return what a crossing adds to the shift of joined blades in second order of h/l.

    ``g = 17.5 + 2.7 cot α − 8.35 cot² α``: the shift changes by g h²/(l² (c³ + (1 − c)³)) besides
    what blades do that are rigid over ``crossing_offset``, and thick beyond it.

    Parameters
    ----------
    half_angle : array_like
        Angle α from the bisector to a blade [rad].

    Returns
    -------
    g : array
        Over (h/l)² [-].

    Notes
    -----
    α from 5° to 80°: within 1 + |g|/20. ν adds 0.3 or so.

    Examples
    --------
    >>> round(float(crossing_shift(half_angle=pi / 4.0)), 2)
    11.85

    References
    ----------
    Plane elements of whole joints to second order of their rotation
    (``tests/benchmarks/plane_crossing.py``), fitted here.

    """
    steep = 1.0 / np.tan(np.asarray(half_angle, dtype=np.float64))
    return np.asarray(17.5 + 2.7 * steep - 8.35 * steep**2)


def solid_crossing(
    *,
    h: ArrayLike,
    l: ArrayLike,
    half_angle: ArrayLike,
    crossing: ArrayLike,
    poisson_ratio: ArrayLike,
) -> Floats:
    """Return how much stiffer joined blades are than beams that meet in a point.

    ``(a − c)/(a' − c')`` of the energies of Timoshenko's arms, a, without and with the crossing, c
    what the shear in either half relieves; to first order ``1 + 8 s/l``, s that of
    ``crossing_offset``.

    Parameters
    ----------
    h, l : array_like
        Thickness of a blade, and length from end to end [m].
    half_angle : array_like
        Angle α from the bisector to a blade [rad].
    crossing : array_like
        Share c of the length on the side of the base [-].
    poisson_ratio : array_like
        ν of plane stress; ν/(1 − ν) in plane strain [-].

    Returns
    -------
    factor : array
        Over the stiffness with bending, shear and stretching [-].

    Notes
    -----
    Within 5e-4 of plane elements of the whole joint at ν = 0, whose halves reach 2 h beyond the
    crossing or more, α from 5° to 85°: 1.6 % at 45° and h = l/100, 20 % at 80°. At a given
    rotation the moment in the crossing rises as much.

    Examples
    --------
    >>> at = {"half_angle": pi / 4.0, "crossing": 0.5, "poisson_ratio": 0.0}
    >>> round(float(solid_crossing(h=0.01, l=1.0, **at)), 4)
    1.0164

    References
    ----------
    Derived here from :func:`crossing_compliance`; held against solids (CalculiX,
    ``tests/benchmarks/crossed_solids.py``).

    """
    arms = arms_in_a_point(h, l, half_angle, crossing, poisson_ratio)
    solid = with_crossing(arms, half_angle, poisson_ratio)
    return np.asarray(relieved(arms) / relieved(solid))


def joined_across(
    *,
    h: ArrayLike,
    l: ArrayLike,
    half_angle: ArrayLike,
    crossing: ArrayLike,
    poisson_ratio: ArrayLike,
) -> JoinedAcross:
    """Return how far joined blades move their body across the bisector as it turns a little.

    ``(cot α (V₁ l₁ − V₂ l₂) + pulled h (V₁ − V₂)/2)/(E' b h sin α)`` over the rotation and l: the
    shear in either half pulls one blade and pushes the other; almost alike in both, as V l is 3/2
    of the moment where halves are long.

    Parameters
    ----------
    h, l : array_like
        Thickness of a blade, and length from end to end [m].
    half_angle : array_like
        Angle α from the bisector to a blade [rad].
    crossing : array_like
        Share c of the length on the side of the base [-].
    poisson_ratio : array_like
        ν of plane stress; ν/(1 − ν) in plane strain [-].

    Returns
    -------
    across : JoinedAcross
        Over the rotation and l [-].

    Notes
    -----
    Nothing where the blades cross in their middle. Halves that reach h beyond the crossing or more,
    α from 5° to 85°; ends that rigid clamps keep as thick as they are add up to 0.25 ν² cot α to
    ``pulled``.

    Examples
    --------
    >>> at = {"h": 0.1, "l": 1.0, "half_angle": pi / 6.0, "poisson_ratio": 0.0}
    >>> across = joined_across(crossing=0.3, **at)
    >>> round(float(across.beams), 5), round(float(across.solid), 5)
    (-0.00153, -0.00307)

    References
    ----------
    Castigliano's theorem on the energies of :func:`solid_crossing`; held against plane elements of
    whole joints (``tests/benchmarks/plane_crossing.py``).

    """
    arms = arms_in_a_point(h, l, half_angle, crossing, poisson_ratio)
    solid = with_crossing(arms, half_angle, poisson_ratio)
    pulled = crossing_compliance(half_angle=half_angle, poisson_ratio=poisson_ratio).pulled
    alpha = np.asarray(half_angle, dtype=np.float64)
    t = np.asarray(h, dtype=np.float64) / np.asarray(l, dtype=np.float64)

    def moved(found: Arms, pulls: Floats | float) -> Floats:
        one, other = _shears(found)
        stretched = 2.0 / np.tan(alpha) * (one * arms.first - other * arms.second)
        return np.asarray((stretched + pulls * (one - other)) / (np.sin(alpha) * relieved(found)))

    beams, whole = moved(arms, 0.0) * t, moved(solid, pulled) * t
    return JoinedAcross(beams, whole, (moved(solid, pulled + 1.0) * t - whole))


class OfHalves(NamedTuple):
    """Stiffness of both halves over beams': bent to an arc, to an S, and pulled [-]."""

    arcs: Both = (1.0, 1.0)
    bent: Both = (1.0, 1.0)
    pulled: Both = (1.0, 1.0)


BEAMS = OfHalves()


class Arms(NamedTuple):
    """Lengths of both halves over h, and the terms of twice the energy of all arms [-]."""

    first: Floats
    second: Floats
    moment: Floats
    mixed: tuple[Floats, Floats]
    own: tuple[Floats, Floats]
    other: Floats


def arms_in_a_point(
    h: ArrayLike,
    l: ArrayLike,
    half_angle: ArrayLike,
    crossing: ArrayLike,
    poisson_ratio: ArrayLike,
    halves: OfHalves = BEAMS,
) -> Arms:
    """Return Timoshenko's arms that meet in a point, stiffened as plates are but in shear.

    The moment falls from M to M − V x: an arc by its mean, an S by the rest.
    """
    t = np.asarray(h, dtype=np.float64) / np.asarray(l, dtype=np.float64)
    share = np.asarray(crossing, dtype=np.float64)
    nu, across = np.asarray(poisson_ratio, dtype=np.float64), np.tan(np.asarray(half_angle)) ** -2.0
    lengths = share / t, (1.0 - share) / t
    moment, mixed, own = np.zeros(()), list[Floats](), list[Floats]()
    arrays = ([np.asarray(each, dtype=np.float64) for each in both] for both in halves)
    for n, arc, bent, pulled in zip(lengths, *arrays, strict=True):
        moment = moment + 24.0 * n / arc
        mixed.append(-12.0 * n**2 / arc)
        own.append(n**3 * (6.0 / arc + 2.0 / bent) + n * (4.8 * (1.0 + nu) + 2.0 * across / pulled))
    return Arms(*lengths, moment, (mixed[0], mixed[1]), (own[0], own[1]), np.zeros(()))


def with_crossing(
    arms: Arms, half_angle: ArrayLike, poisson_ratio: ArrayLike, stiffer: ArrayLike = 1.0
) -> Arms:
    """Return the energies of arms with what their crossing gives way beside them.

    ``stiffer`` is its modulus over that of beams.
    """
    c = crossing_compliance(half_angle=half_angle, poisson_ratio=poisson_ratio)
    moment, mixed, shear, other = (
        each / np.asarray(stiffer, dtype=np.float64)
        for each in (c.moment, c.mixed, c.shear, c.other)
    )
    (p, q), (a, b) = arms.mixed, arms.own
    return arms._replace(
        moment=arms.moment + moment,
        mixed=(p + mixed, q + mixed),
        own=(a + shear, b + shear),
        other=other,
    )


def _shears(arms: Arms) -> tuple[Floats, Floats]:
    """Return V₁ h and V₂ h over M, at which the energy is least."""
    (p, q), (a, b), other = arms.mixed, arms.own, arms.other
    least = a * b - other * other
    return (q * other - p * b) / least, (p * other - q * a) / least


def relieved(arms: Arms) -> Floats:
    """Return the compliance of a moment where both shears are as its energy is least."""
    (p, q), (one, other) = arms.mixed, _shears(arms)
    return arms.moment + p * one + q * other


_ANGLES = (Range("half_angle", *ANGLES, unit="rad", why="computed and fitted between these"),)
_AT = {"half_angle": pi / 4.0}

CARDS = (
    Card(
        "solid-crossing",
        solid_crossing,
        {"h": 0.1e-3, "l": 17.5e-3, "crossing": 0.5, "poisson_ratio": 0.3, **_AT},
        _ANGLES,
    ),
    Card(
        "joined-across",
        joined_across,
        {"h": 0.1e-3, "l": 17.5e-3, "crossing": 0.3, "poisson_ratio": 0.3, **_AT},
        _ANGLES,
    ),
    Card("crossing-compliance", crossing_compliance, {**_AT, "poisson_ratio": 0.3}, _ANGLES),
    Card("crossing-offset", crossing_offset, _AT, _ANGLES),
    Card("crossing-reach", crossing_reach, _AT),
    Card("crossing-shift", crossing_shift, _AT, _ANGLES),
)
