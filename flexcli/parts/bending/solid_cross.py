"""Blades that are one piece where they cross: what this changes of a joint."""

from collections.abc import Callable
from math import inf, pi, sin, tan

from flexcli.formulas import pivot, thick_blades
from flexcli.formulas.plate_factors import bound
from flexcli.formulas.solid_crossing import (
    ANGLES,
    FIT,
    crossing_offset,
    crossing_reach,
    crossing_shift,
    solid_crossing,
)
from flexcli.numerics.rows import number, one_alone
from flexcli.parts.bending.base import CompliantClamps, Factor
from flexcli.parts.geometries.base import Blade

__all__ = ["solid_cross", "with_roots"]

LEAST_ARM = 2.0
"""Length of a blade beyond the crossing, over its thickness, from which on it bends as a beam."""

WIDE = 8.0
"""Width of a blade, over half the length of the crossing, that keeps this as flat as the blade."""

HELD_ENDS = 0.25
"""What rigid clamps stiffen by keeping an end as thick as it is, over ν'² h/l: plane elements of
whole joints had 0.16 to 0.24."""

OF_SECOND, OF_THIRD = 0.1, 40.0
"""Errors of the shift: part of its second order in h/l, to which one is added; and over (h/l)³ of
the shorter half and 1 + cot²α, by plane elements of whole joints."""

TURNED = 2.5
"""What a crossing changes of the stress otherwise at a rotation [1/rad]: exact beams that begin
beyond it had 0.25 at 0.1 rad and less after it."""

LESS_ALONG = 10.0
"""What shear and stretching take of the shift along the bisector, over (h/l)² of the shorter half
and sin⁻² α: exact beams had 6 at 45° and 1 at 12°."""

ACROSS = 0.06
"""First-order motion across the bisector by the crossing, over (tan² α + cot² α)(1 − 2c) h²/l θ:
the same elements had 0.045 at most."""


def solid_cross(
    blade: Blade, nu: float, crossing: float, half_angle: float, flat: Callable[[float], float]
) -> CompliantClamps:
    """Return the changes by blades that are one piece where they cross, ν ½ where not given.

    The moment in the crossing rises with the stiffness. ``flat`` is the stiffness over a beam's of
    wide blades of a length. A crossing much shorter than wide is as flat as they are, at least,
    and does not curl at all, at most; between blades that are shorter by it, which are flatter.
    Nothing is known where a half hardly reaches beyond the crossing.
    """
    one_alone()
    h, l, b = map(number, blade)
    shares = crossing, 1.0 - crossing
    shortest = min(shares) * l
    ratio = h / shortest
    reach = float(crossing_reach(half_angle=half_angle))
    if not ANGLES[0] <= half_angle <= ANGLES[1] or shortest < (reach + LEAST_ARM) * h:
        return _unknown(ratio)
    thickens = nu / (1.0 - nu)  # ν' of plane strain
    plane = (nu if nu < 0.5 else 0.0), thickens
    stiffer = [
        float(
            solid_crossing(h=h, l=l, half_angle=half_angle, crossing=crossing, poisson_ratio=each)
        )
        - 1.0
        for each in plane
    ]
    rigid = float(crossing_offset(half_angle=half_angle)) * h
    whole, shorter = flat(l), flat(l - 2.0 * rigid)
    least = whole / (1.0 + number(bound(nu)))
    most = whole / (1.0 + (whole - 1.0) * min(1.0, b / (WIDE * reach * h)))
    low = 1.0 + min(stiffer) * least * (1.0 - FIT)
    high = 1.0 + max(stiffer) * most * (1.0 + FIT) + HELD_ENDS * thickens**2 * h / l
    high *= max(1.0, shorter / whole)
    middle = (low + high) / 2.0
    shifted = [_shift(l, shares, share * rigid) for share in (least, most)]
    g = float(crossing_shift(half_angle=half_angle))
    second = (h / l) ** 2 / sum(share**3 for share in shares)
    off = second * (1.0 + OF_SECOND * abs(g))
    off += OF_THIRD * ratio**3 * (1.0 + tan(half_angle) ** -2.0)
    held = (1.0 - 1.5 * rigid / shortest) ** -2.0 if 1.5 * rigid < shortest else inf
    return CompliantClamps(
        ratio,
        Factor(middle, low, high),
        (low - 1.0, high - 1.0),
        high - 1.0,
        Factor(1.0, 1.0, held),
        (min(shifted) + g * second - off, max(shifted) + g * second + off),
        0.0,
        _across(h, l, crossing, half_angle),
        TURNED * (high - 1.0),
    )


def with_roots(crossed: CompliantClamps, roots: CompliantClamps) -> CompliantClamps:
    """Return the changes by a solid crossing and by compliant roots."""
    one, other = crossed.stiffness, roots.stiffness
    stress = tuple(a + b for a, b in zip(crossed.stress, roots.stress, strict=True))
    shift = tuple(a + b for a, b in zip(crossed.shift, roots.shift, strict=True))
    return CompliantClamps(
        max(crossed.ratio, roots.ratio),
        Factor(one.value * other.value, one.low * other.low, one.high * other.high),
        (stress[0], stress[1]),
        roots.loaded + crossed.loaded,
        roots.buckling._replace(high=roots.buckling.high * crossed.buckling.high),
        (shift[0], shift[1]),
        roots.softest,
        crossed.first,
        crossed.turned,
    )


def _unknown(ratio: float) -> CompliantClamps:
    """Return changes of which nothing is known."""
    any_factor = Factor(1.0, 1.0, inf)
    return CompliantClamps(ratio, any_factor, (0.0, inf), inf, any_factor, (-inf, inf), 0.0)


def _shift(l: float, shares: tuple[float, float], rigid: float) -> float:
    """Return the change of the shift of two pivots whose blades are rigid up to the crossing.

    Either turns by its share of the compliance; its blades begin that far from their centre.
    """
    parts = [(share * l - rigid, rigid) for share in shares]
    soft = [length / (1.0 + 3.0 * p / length + 3.0 * (p / length) ** 2) for length, p in parts]
    at = {"half_angle": pi / 4.0}
    moved = sum(
        number(pivot.parasitic_shift(l=length, p=p, theta=each / sum(soft), **at))
        for (length, p), each in zip(parts, soft, strict=True)
    )
    point = sum(
        number(pivot.parasitic_shift(l=share * l, p=0.0, theta=share, **at)) for share in shares
    )
    return moved / point - 1.0


def _across(h: float, l: float, crossing: float, half_angle: float) -> tuple[float, float]:
    """Return the motion across the bisector over the least along it, and what the crossing adds.

    Both for a unit rotation [rad].
    """
    shares, at = (crossing, 1.0 - crossing), {"half_angle": half_angle}
    along = sum(
        number(pivot.parasitic_shift(l=share * l, p=0.0, theta=share, **at)) for share in shares
    )
    stretched = sum(
        number(
            thick_blades.pivot_shift_across(
                h=h, l=share * l, p=p, theta=share, poisson_ratio=-1.0, **at
            )
        )
        for share, p in zip(shares, (-crossing * l, 0.0), strict=True)
    )
    ratio = h / (min(shares) * l)
    along *= max(1.0 - LESS_ALONG * (ratio / sin(half_angle)) ** 2, 0.5)
    slope = tan(half_angle) ** 2
    more = ACROSS * (slope + 1.0 / slope) * abs(1.0 - 2.0 * crossing) * h**2 / l
    return abs(stretched) / along, more / along
