"""Blades that are one piece where they cross: what this changes of a joint."""

from collections.abc import Callable, Sequence
from math import cos, exp, inf, pi, radians, sin, tan

from flexcli.formulas import pivot
from flexcli.formulas.joined_plates import joined_plates, solid_plates
from flexcli.formulas.plate_factors import bound, flat_share
from flexcli.formulas.solid_crossing import (
    ANGLES,
    FIT,
    OfHalves,
    crossing_compliance,
    crossing_offset,
    crossing_reach,
    crossing_shift,
    joined_across,
    solid_crossing,
)
from flexcli.numerics.rows import number, one_alone
from flexcli.parts.bending.base import CompliantClamps, Factor, MovedAcross, Turned
from flexcli.parts.geometries.base import Blade

__all__ = ["solid_cross", "turned_by", "with_roots"]

LEAST_ARM = 0.3
"""Length of a blade beyond the crossing, over its thickness, from which on the joint is as stiff as
its beams and its crossing: plane elements of whole joints with halves of 0.16 to 2.1."""

SHIFTING_ARM = 2.0
"""The same for the shift, whose orders in h/l are no longer in sequence below."""

NARROW = 3.0
"""Width of a blade, over half the length of the crossing, up to which this may not be as in plane
strain, of which it moves the body across."""

LESS_FLAT, MORE_FLAT, LOOSENED = 0.2, 0.15, 0.5
"""By how much less and more flat than the halves beyond it a crossing may be kept, over
4 f (1 − f), f their flatness, and more by the part of h/b cot α by which these curl where it does
not: solids from 60° to 84° of h/b cot α up to 0.15, b from 0.5 to 31 times half the length of the
crossing, had 0.18 less, and 0.85 of what is more (``tests/benchmarks/crossed_solids.py``). Flatter
joints tell little of it: their solids are in the range of all."""

HELD_FLAT = 0.06
"""What a rigid clamp stiffens by keeping an end flat, over h²/l² and what the crossing stiffens:
plane elements of whole joints had up to 0.05."""

OF_SECOND, OF_THIRD = 0.1, 40.0
"""Errors of the shift: part of its second order in h/l, to which one is added; and over (h/l)³ of
the shorter half and 1 + cot²α, by plane elements of whole joints."""

STEEP = 60.0
TURNED, TURNED_STEEP = (-0.035, 0.085, 0.0), (0.0, 0.045, 0.06)
"""What a rotation θ adds to what a crossing adds to the stress, over θ times that and
sin⁻² α cos⁻² α [1/rad]: the least, the most, and what this grows by tan α θ², up to a half-angle
[deg] and beyond. Exact beams that begin beyond the crossing had −0.022 to 0.078 below, 0.012 to
(0.043 + 0.053 tan α θ²) beyond, of crossings from 0.05 on, 6° to 84° and up to 0.7 rad."""

TURNS_MOST = 2.8
"""The rotation up to which it is no more, over cot α [rad]."""

TURNS_FAR = 0.7
"""The largest rotation of those [rad]."""

LESS_ALONG, MORE_ALONG = 10.0, 1.1
"""What shear and stretching take of the shift along the bisector, over (h/l)² of the shorter half
and sin⁻² α: exact beams had 6 at 45° and 1 at 12°; and how much larger it is at most."""

SHORT_ALONG, FARTHEST_ALONG = 6.0, 20.0
"""The shift along the bisector over that of thin beams, at most, where halves hardly reach beyond
the crossing: of exact beams, which had 0.1 to 5, and of plane elements, which had −3 to 14."""

ENDS_PULL, ENDS_PRESS = 0.5, 0.15
"""What ends that rigid clamps keep as thick as they are add to ``CrossingCompliance.pulled``, over
ν'² cot α and ν'² tan α: plane elements of whole joints had 0.47 and 0.14."""

OF_WIDENING = 1.5
"""What blades bend stiffer than they stretch, at most, over what width stiffens."""

LEAST_STIFF = 0.8
"""Least stiffness of joined blades over that of beams: 0.87 in a plane, nearly parallel."""

NEAR_PULL = 0.25, 2.0
"""The same by ends so near that they feel the crossing, over e⁻² of what is between them over h,
and of it over ν': plane elements of halves that reach 0.16 to 2.1 h beyond it."""


def solid_cross(
    blade: Blade,
    nu: float,
    crossing: float,
    half_angle: float,
    halves: Callable[[float], OfHalves],
    apart: tuple[float, float],
) -> CompliantClamps:
    """Return the changes by blades that are one piece where they cross, ν ½ where not given.

    The moment in the crossing rises with the stiffness. ``halves`` is what plates stiffen of both
    that are rigid up to a length from the crossing, ``apart`` what they share otherwise for being
    wide, as :func:`flexcli.parts.bending.joined_halves.halves_apart` has it. A crossing is about as
    flat as the halves beyond it, which are shorter by it and flatter. Nothing is known where a half
    does not reach beyond the crossing, and nothing of the shift along the bisector where it hardly
    does.
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
    plane = (nu if nu < 0.5 else 0.0), nu + (thickens - nu) * min(1.0, b / (NARROW * reach * h))
    rigid = float(crossing_offset(half_angle=half_angle)) * h
    wide, beyond = halves(0.0), halves(rigid)
    at = {"h": h, "l": l, "half_angle": half_angle, "crossing": crossing, "poisson_ratio": nu}
    whole = float(joined_plates(**at, halves=wide))
    ends = _flatness(beyond, [share * l for share in shares], rigid, nu, h / b / tan(half_angle))
    stiffer = [float(solid_plates(**at, halves=beyond, flat=flat)) / whole for flat in ends]
    if nu >= 0.5:  # which may be none as well
        stiffer.append(float(solid_crossing(**{**at, "poisson_ratio": 0.0})))
    low, high = min(stiffer), max(stiffer)
    if low <= 0.0:
        return _unknown(ratio)
    least, most = (whole / (1.0 + each * number(bound(nu))) for each in (1.0, ends[0]))
    held_ends = _held_ends(thickens, shortest / h - reach) * h / l * high**0.5
    held_ends += HELD_FLAT * (h / l) ** 2 * high
    low -= FIT * abs(low - 1.0)
    high = (high + FIT * abs(high - 1.0)) * (1.0 + held_ends)
    middle = (low + high) / 2.0
    shift = -inf, inf
    if shortest >= (reach + SHIFTING_ARM) * h:
        shifted = [_shift(l, shares, share * rigid) for share in (min(1.0, least), max(1.0, most))]
        g = float(crossing_shift(half_angle=half_angle))
        second = (h / l) ** 2 / sum(share**3 for share in shares)
        off = second * (1.0 + OF_SECOND * abs(g))
        off += OF_THIRD * ratio**3 * (1.0 + tan(half_angle) ** -2.0)
        shift = min(shifted) + g * second - off, max(shifted) + g * second + off
    turned = turned_by(low, high, half_angle)
    held = (1.0 - 1.5 * rigid / shortest) ** -2.0 if 1.5 * rigid < shortest else inf
    return CompliantClamps(
        ratio,
        Factor(middle, low, high, 0.0),  # shear, stretching and width are all in its range
        (low - 1.0, high - 1.0),
        high - 1.0,
        Factor(1.0, 1.0, held),
        shift,
        0.0,
        _across(blade, plane, crossing, half_angle, apart, (whole, whole * high)),
        turned,
    )


def turned_by(low: float, high: float, half_angle: float) -> Turned:
    """Return what a travel adds to a stress that a crossing raises between these factors."""
    unsteady = max(abs(low - 1.0), abs(high - 1.0)) / (sin(half_angle) * cos(half_angle)) ** 2
    lost, more, grows = TURNED if half_angle < radians(STEEP) else TURNED_STEEP
    return Turned(
        unsteady * (lost if low >= 1.0 else -more),
        unsteady * more,
        unsteady * grows * tan(half_angle),
        min(TURNS_FAR, TURNS_MOST / tan(half_angle)),
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
        crossed.across,
        crossed.turned,
    )


def _unknown(ratio: float) -> CompliantClamps:
    """Return changes of which nothing is known."""
    any_factor = Factor(1.0, 1.0, inf)
    return CompliantClamps(ratio, any_factor, (0.0, inf), inf, any_factor, (-inf, inf), 0.0)


def _held_ends(thickens: float, beyond: float) -> float:
    """Return the most that rigid clamps stiffen by keeping ends as thick as they are.

    Over h/l and the root of what the crossing stiffens; ``beyond`` is the length of a blade beyond
    the crossing over h. Plane elements of whole joints had 0.16 to 0.26 ν'² of slender joints, 0.2
    at ν' = 0.8, and less where ends are near.
    """
    return 0.34 * thickens**2 / (1.0 + 0.7 * thickens) * min(1.0, 0.5 + 0.3 * beyond)


def _flatness(
    halves: OfHalves, lengths: Sequence[float], rigid: float, nu: float, loose: float
) -> tuple[float, float]:
    """Return the range of how flat a crossing is kept, from the halves beyond it [-].

    These turn about a centre by which they are rigid; each by its share of the compliance.
    """
    soft = flat = 0.0
    for length, arc, bent in zip(lengths, halves.arcs, halves.bent, strict=True):
        s_shaped = 12.0 * (0.5 + rigid / (length - rigid)) ** 2
        compliance = (length - rigid) / (1.0 + s_shaped)
        soft += compliance
        flat += compliance * (1.0 + s_shaped) / (number(arc) + s_shaped * number(bent))
    f = number(flat_share(soft / flat, nu))
    apart = 4.0 * f * (1.0 - f)
    return max(f - LESS_FLAT * apart, 0.0), min(f + MORE_FLAT * apart + LOOSENED * loose, 1.0)


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


def _across(
    blade: Blade,
    plane: tuple[float, float],
    crossing: float,
    half_angle: float,
    apart: tuple[float, float],
    stiffer: tuple[float, float],
) -> MovedAcross:
    """Return the motion across the bisector by beams, and by blades of one piece.

    ``plane`` is the range of ν of a plane. Wide blades that stretch as beams, at the least, bend as
    plates; halves of which one is flatter share the shear otherwise, which pulls the blades.
    ``stiffer`` is what width stiffens, and the largest stiffness, over that of beams.
    """
    h, l, _ = map(number, blade)
    shares, steep = (crossing, 1.0 - crossing), tan(half_angle)
    shortest = min(shares) * l
    past = shortest / h - float(crossing_reach(half_angle=half_angle))
    near, per_nu = NEAR_PULL
    unsure = plane[1] ** 2 * (ENDS_PULL / steep + ENDS_PRESS * steep)
    unsure += (near + per_nu * plane[1]) * exp(-2.0 * past)
    wide = 1.0 + OF_WIDENING * (stiffer[0] - 1.0)
    beams, solid = [], []
    for nu in plane:
        found = joined_across(h=h, l=l, half_angle=half_angle, crossing=crossing, poisson_ratio=nu)
        pulled = crossing_compliance(half_angle=half_angle, poisson_ratio=nu).pulled
        off = abs(float(found.of_pulled)) * (unsure + FIT * abs(float(pulled)))
        for each in (float(found.solid) - off, float(found.solid) + off):
            solid += [each * l, each * wide * l]
        beams.append(float(found.beams) * l)
    if plane[0] > 0.0 or plane[1] == 0.0:
        beams[1] = beams[0]  # their ν is known
    lever = 0.5 * h**2 / l / (steep * sin(half_angle))
    levers = lever * LEAST_STIFF, lever * stiffer[1]
    thin = sum(
        number(pivot.parasitic_shift(l=share * l, p=0.0, theta=share, half_angle=half_angle))
        for share in shares
    )
    less = max(1.0 - LESS_ALONG * (h / shortest / sin(half_angle)) ** 2, 0.0)
    return MovedAcross(
        (min(beams), max(beams)),
        (
            min(solid) + min(each * apart[0] for each in levers),
            max(solid) + max(each * apart[1] for each in levers),
        ),
        (less * thin, MORE_ALONG * thin) if past >= SHIFTING_ARM else (0.0, SHORT_ALONG * thin),
        FARTHEST_ALONG * thin,
    )
