"""Wide blades joined where they cross: the plates of both halves."""

from collections.abc import Sequence
from math import inf, pi
from typing import NamedTuple

from flexcli.formulas import pivot
from flexcli.formulas import plate_factors as plates
from flexcli.formulas import sheet_factors as sheets
from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.joined_plates import joined_plates, uneven_line
from flexcli.formulas.quantity import Numbers
from flexcli.formulas.solid_crossing import OfHalves, joined_across
from flexcli.numerics.rows import Number, cos, larger, number, one_by_one, smaller, tan
from flexcli.parts.bending.base import SHORTEST, Factor, WideAcross, WideBlades
from flexcli.parts.bending.plate_range import (
    HINGED,
    TINY,
    UNSURE_ALONG,
    buckled,
    floats,
    pivot_shift,
    plate_alone,
    plate_factor,
    shortening,
)
from flexcli.parts.geometries.base import Blade

__all__ = ["PlatesOfHalves", "halves_apart", "plates_of_halves", "wide_halves"]

UNEVEN_LINE = 0.05
"""Part of the plates' change of joined blades by which they turn unevenly along their line: thin
plates, held on it, by Ritz's method (``tests/plates/crossed_strip.py``)."""

LOOSE = 0.5
"""Part of h/b cot α by which joined blades widen less than held on their line: solids (CalculiX,
``tests/benchmarks/crossed_solids.py``) had 0.3 to 0.7."""

UNEVENLY, AT_ENDS = 0.6, 0.04
"""Errors of ``uneven_line``, of which there may be nothing: a part of it that plates add less, and
what they add less besides, over (1 − 2c)⁴, where the line is near an end. Thin plates held on it,
c from 0.05 on, had 0.5 and 0.025; to 0.02, 0.04 (``tests/plates/crossed_strip.py``)."""

OF_PATH = 5e-4
"""What their shift is off besides, by the errors of how much blades shorten [-]."""

ANY_SHARE = 0.9
"""How unsure the part of a shift is that is across the bisector of joined blades."""


def wide_halves(blade: Blade, nu: float, crossing: float, half_angle: float) -> WideBlades:
    """Return the factors of two pivots of p = 0 in series, clamped by the cross of the blades.

    A blade that curls where they cross stretches the other by tan α of that, which holds it
    straight, the less the thicker they are and the flatter they cross; what turns unevenly along
    it is little. Both halves bear the same moment there, half that of the body: the stress rises as
    the stiffness. What rigid clamps stiffen by keeping ends as thick as they are is of
    :mod:`flexcli.parts.bending.solid_cross`.
    """
    blade = floats(blade)
    shares = (crossing, 1.0 - crossing)
    parts = [blade._replace(l=share * blade.l) for share in shares]
    each = [plate_factor(plates.pivot_factor, part, nu, delta=0.0) for part in parts]
    loose = _loose(blade, half_angle)
    at = {"half_angle": half_angle, "crossing": crossing, "poisson_ratio": nu}
    value, low, high = (
        number(joined_plates(h=blade.h, l=blade.l, halves=halves, **at))
        for halves in plates_of_halves(blade, nu, crossing, half_angle)
    )
    most = 1.0 + number(plates.bound(nu))
    stiffness = Factor(value, larger(1.0, low), larger(value, smaller(most, high)))
    shift = _halves_shift(shares, parts, [factor.value for factor in each], nu, loose)
    longer, shorter = (
        blade._replace(l=choose(part.l for part in parts)) for choose in (larger, smaller)
    )
    stiffness = stiffness._replace(other=_other_shapes(stiffness, longer, shorter, nu, loose))
    # on hinges each blade buckles alone, and curls where it crosses as much as it can
    held = dict.fromkeys(EFFECTIVE_LENGTH, _buckled_halves(longer, shorter, nu, loose))
    held[HINGED] = _buckled_halves(longer, shorter, nu, 1.0)
    bends = 4.0 / blade.l, -2.0 / blade.l  # at the cross and at the ends of either half
    widest = blade.b / smaller(part.l for part in parts)
    across = _halves_across(blade, nu, crossing, half_angle)
    # curvature flattens no more than clamps and line leave
    left = smaller((most / stiffness.low - 1.0) / larger(most - 1.0, TINY), 1.0)
    found = WideBlades(widest, stiffness, stiffness, held, shift, None, bends, across=across)
    return found._replace(uneven=left)


class PlatesOfHalves(NamedTuple):
    """What plates stiffen of both halves of joined blades: the best value, the least, the most."""

    value: OfHalves
    low: OfHalves
    high: OfHalves


def plates_of_halves(
    blade: Blade, nu: float, crossing: float, half_angle: float, rigid: Numbers = 0.0
) -> PlatesOfHalves:
    """Return what plates stiffen of both halves, which are rigid up to a length from their line."""
    blade = floats(blade)
    loose = _loose(blade, half_angle)
    uneven = number(uneven_line(b=blade.b, l=blade.l, crossing=crossing))
    found = []
    most = (1.0 + UNEVENLY) * uneven + AT_ENDS * (1.0 - 2.0 * crossing) ** 4
    for index, (curls, less) in enumerate(((LOOSE, uneven), (1.0, most), (0.0, 0.0))):
        straight = larger(1.0 - curls * loose, 0.0)
        even = larger(straight - less, 0.0)
        arcs, bent, pulled = [], [], []
        for share in (crossing, 1.0 - crossing):
            part = blade._replace(l=share * blade.l - number(rigid))
            arc, s_shape = (
                plate_alone(f, part, nu)[index]
                for f in (plates.pure_bending_factor, plates.guided_factor)
            )
            if index == 2:  # clamps keep it from warping as it shears
                at = {"h": part.h, "l": part.l, "poisson_ratio": nu, "flat": 0.0}
                s_shape += number(plates.beyond_plate(**at)[1])
            kept = number(sheets.axial_factor(b=part.b, l=part.l, poisson_ratio=nu))
            arcs.append(1.0 + even * (arc - 1.0))
            bent.append(1.0 + even * (s_shape - 1.0))
            pulled.append(1.0 + straight * (kept - 1.0))
        found.append(OfHalves(*((one, two) for one, two in (arcs, bent, pulled))))
    return PlatesOfHalves(*found)


def _loose(blade: Blade, half_angle: float) -> Number:
    """Return by how much blades that cross let each other curl, h/b cot α, 1 at most [-]."""
    return smaller(number(blade.h) / number(blade.b) / tan(half_angle), 1.0)


def _halves_across(blade: Blade, nu: float, crossing: float, half_angle: float) -> WideAcross:
    """Return how little width changes of the motion across the bisector: the crossing has that.

    It is only told how much of the shift that is, at most, which changes along the bisector.
    """
    h, l, _ = blade

    def moved(h: float, l: float, nu: float, half_angle: float, crossing: float) -> float:
        found = joined_across(h=h, l=l, half_angle=half_angle, crossing=crossing, poisson_ratio=nu)
        return max(abs(float(found.beams)), abs(float(found.solid)))

    farthest = larger(
        one_by_one(moved, h, l, each, half_angle, crossing) for each in (nu, nu / (1.0 - nu))
    )
    along = sum(share**3 for share in (crossing, 1.0 - crossing)) / (15.0 * cos(half_angle))
    most = farthest * (1.0 + number(plates.bound(nu))) / ((1.0 - UNSURE_ALONG) * along)
    return WideAcross((1.0 - ANY_SHARE) * most, ANY_SHARE, 0.0, 0.0)


def halves_apart(
    blade: Blade, nu: float, crossing: float, half_angle: float
) -> tuple[float, float]:
    """Return the range of how much more shear the first half takes for its width than the second.

    A half whose S is stiffer over its arc by r than a beam's takes ``4r/(1 + 3r)`` of the shear of
    a beam.
    """
    blade = floats(blade)
    loose = _loose(blade, half_angle)
    ends = []
    for share in (crossing, 1.0 - crossing):
        part = blade._replace(l=share * blade.l)
        pure, bent = (
            plate_factor(f, part, nu) for f in (plates.pure_bending_factor, plates.guided_factor)
        )
        least = _held_on_a_line(bent.low, loose) / pure.high
        most = bent.high / _held_on_a_line(pure.low, loose)
        ends.append((4.0 * least / (1.0 + 3.0 * least), 4.0 * most / (1.0 + 3.0 * most)))
    (low, high), (least, most) = ends
    return low - most, high - least


def _held_on_a_line(factor: float, loose: float) -> float:
    """Return the least factor of blades that one which crosses them keeps from curling [-]."""
    return 1.0 + (factor - 1.0) * larger(1.0 - UNEVEN_LINE - loose, 0.0)


def _other_shapes(factor: Factor, longer: Blade, shorter: Blade, nu: float, loose: float) -> float:
    """Return the error of a factor of two halves that bend in any other shape [-]."""
    least = _held_on_a_line(plate_factor(plates.pure_bending_factor, longer, nu).low, loose)
    short = shorter._replace(b=SHORTEST * shorter.b)
    most = larger(plate_factor(plates.pure_bending_factor, short, nu).high, factor.high)
    return larger(most / factor.value - 1.0, 1.0 - least / factor.value)


def _buckled_halves(longer: Blade, shorter: Blade, nu: float, loose: float) -> Factor:
    """Return the range of the factor of the force that buckles two halves, each in any shape."""
    least = _held_on_a_line(buckled(longer, nu).low, loose)
    most = larger(buckled(shorter, nu).high, buckled(longer, nu).high)
    return Factor((least + most) / 2.0, least, most)


def _halves_shift(
    shares: tuple[float, float],
    parts: Sequence[Blade],
    each: Sequence[float],
    nu: float,
    loose: float,
) -> tuple[float, float]:
    """Return the change of the shift of two pivots in series and its error, of the leading term.

    Each shifts by the shortening of its own blades and by the square of its share of the rotation,
    which the stiffer one loses; the two may almost cancel.
    """
    places = (-parts[0].l, 0.0)
    leading = [
        number(pivot.parasitic_shift(theta=share, l=part.l, p=p, half_angle=pi / 4.0))
        for share, part, p in zip(shares, parts, places, strict=True)
    ]
    whole, lost = sum(leading), each[0] / each[1] - 1.0
    if whole == 0.0:
        return 0.0, inf
    # a part that is stiffer by ε turns by ε times the share of the other less
    turns = (-2.0 * lost * shares[1], 2.0 * lost * shares[0])
    value, error = 0.0, OF_PATH
    for own, part, turn in zip(leading, parts, turns, strict=True):
        moved, off = pivot_shift(1.0, *shortening(part, nu))
        value += own * (moved + turn) / whole
        astray = smaller(UNEVEN_LINE + loose, 1.0) * (abs(turn) + abs(moved))
        error += abs(own / whole) * (off + lost**2 + astray)
    return value, error
