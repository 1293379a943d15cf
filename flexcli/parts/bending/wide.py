"""Wide blades: the increased stiffness of a joint's blades or hinges against beams."""

from collections.abc import Iterable, Sequence
from math import inf, pi
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from flexcli.formulas import pivot, plate_buckling, plate_shortening, thick_blades
from flexcli.formulas import plate_factors as plates
from flexcli.formulas import sheet_factors as sheets
from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.joined_plates import joined_plates, uneven_line
from flexcli.formulas.quantity import Computed, Numbers
from flexcli.formulas.section import second_moment, shear_parameter
from flexcli.formulas.solid_crossing import OfHalves, joined_across
from flexcli.numerics.rows import Number, cos, larger, number, one_alone, one_by_one, smaller, tan
from flexcli.parts.bending.base import (
    PULLED,
    SHORTEST,
    Factor,
    WideAcross,
    WideBlades,
    hull,
)
from flexcli.parts.bending.wide_notch import NOTCH_PULLED
from flexcli.parts.geometries.base import MOVING, Blade, Held

if TYPE_CHECKING:
    from flexcli.mechanics.layout import Layout

__all__ = [
    "PlatesOfHalves",
    "halves_apart",
    "plates_of_halves",
    "wide_by_shapes",
    "wide_cantilever",
    "wide_drawn",
    "wide_guided",
    "wide_halves",
    "wide_linked",
    "wide_moment",
    "wide_necks",
    "wide_pivot",
]

CANCELS = 10.0
"""Largest ratio of a blade's shortening to the layout's shift that comes from it."""

NECKS_BUCKLED = 0.2
"""Part of what a hinge in pure bending widens by, by which the hinges of a blade that buckles
sideways, or on pins, may differ from it: plates with a rigid middle of 0 to 40 hinges' lengths
between them had 0.1 at most."""

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

LET_OFF = 0.1
"""Part of the change of a pivot's factors by stretching and shear that may be wrong: springs in
space of 150 random stars had 0.02 at most."""

TINY = 1e-12
"""Share of S-shaped bending below which there is none."""

OF_PATH = 5e-4
"""What their shift is off besides, by the errors of how much blades shorten [-]."""

UNSURE_ALONG = 0.3
"""Part of a pivot's shift along its bisector that shear and the next order in θ may change."""

ANY_SHARE = 0.9
"""How unsure the part of a shift is that is across the bisector of joined blades."""

ENDS = {
    plates.pure_bending_factor: 2.0, plates.cantilever_factor: 3.0, plates.limb_hinge_factor: 3.0,
}  # fmt: skip
"""Squares of both end moments of a blade over their mean square along it, 6 of an S at most."""

LOCKED, HINGED = "clamped-clamped", "pinned-pinned"


def wide_pivot(
    blade: Blade,
    nu: float,
    *,
    delta: Computed,
    half_angle: float | None = None,
    sags_wide: bool = False,
    softer: tuple[Computed, Computed] = (0.0, 0.0),
) -> WideBlades:
    """Return the factors of equal blades that point at one centre, p = δ l from it.

    A pair, at a half-angle from its bisector, has a shift along that and across it; those of
    others are of their path, or bounded as drawn blades' where that does not tell it. The sag of a
    pivot may bend its blades across their width. ``softer`` are the shares of the stiffness by
    which stretching and shear of the blades let their S-shaped bending off: clamps that keep a
    blade from curling keep it from narrowing as well.
    """
    _, l, b = blade = _floats(blade)
    delta = number(delta)
    stiffness = _any_shape(_factor(plates.pivot_factor, blade, nu, delta=delta), blade, nu)
    stress = _factor(plates.end_moment_factor, blade, nu, delta=delta)
    gamma = 1.0 + 2.0 * delta
    shift, across, uneven = (0.0, CANCELS * larger(*_shortening(blade, nu))), None, 1.0
    if half_angle is not None:
        shift = _pivot_shift(gamma, *_shortening(blade, nu))
        across = _pivot_across(blade, nu, delta, half_angle)
        leading = abs(5.0 - 9.0 * gamma**2)
        uneven = (2.5 + 9.0 * gamma**2) / leading if leading else inf
    odd = 3.0 * gamma**2 / (1.0 + 3.0 * gamma**2)
    stretching, shear = (_in_series(each, odd) for each in softer)
    kept = number(sheets.axial_factor(b=b, l=l, poisson_ratio=nu))
    springs = stretching, stretching / kept, shear
    pure, bent = (
        _factor(f, blade, nu).value for f in (plates.pure_bending_factor, plates.guided_factor)
    )
    stiffness = _let_off(stiffness, pure, bent, odd / (1.0 - odd), springs)
    stress = _let_off(stress, pure, bent, 3.0 * abs(gamma), springs)
    left = 1.0 / (1.0 + stretching + shear)
    bends = (1.0 - 3.0 * gamma * left) / l, (1.0 + 3.0 * gamma * left) / l
    held = _held(blade, nu)
    # whose body turns as well: the shape is none of these; on hinges one blade buckles alone
    turned = [ends for ends in held if ends not in (LOCKED, HINGED)]
    held |= {ends: hull(held.values(), at=held[ends]) for ends in turned}
    sag = None
    if sags_wide:
        inverse = 1.0 / number(sheets.guided_factor(b=b, l=l, poisson_ratio=nu))
        sag = inverse - 1.0, sheets.GUIDED_ERROR
    return WideBlades(
        b / l, stiffness, stress, held, shift, sag, bends, uneven=uneven, across=across
    )


def _in_series(softer: Computed, odd: float) -> float:
    """Return the compliance beside the S-shaped bending, over its own, that softens the whole."""
    left = 1.0 - number(softer) / larger(odd, TINY)
    return 1.0 / larger(left, TINY) - 1.0


def _shear(blade: Blade, nu: float) -> float:
    """Return Φ of a blade across its thickness [-]."""
    return number(shear_parameter(depth=blade.h, l=blade.l, poisson_ratio=nu))


def _let_off(
    factor: Factor, pure: float, bent: float, share: float, springs: tuple[float, float, float]
) -> Factor:
    """Return the factor of bending of which a share is S-shaped, and a part of that is let off.

    ``pure`` and ``bent`` are the factors of the arc and of the S, ``share`` is the S over the arc,
    ``springs`` compliances in series with it over its own: of stretching, of beams and of blades
    kept from narrowing, and of shear, of which clamps take as much as of the bending.
    """
    beams, kept, shear = springs
    before = (pure + share * bent) / (1.0 + share)
    wide = pure + share / ((1.0 + shear) / bent + kept)
    after = wide / (1.0 + share / (1.0 + shear + beams))
    moved = after - before
    off = LET_OFF * abs(moved)
    value, low, high = (each + moved for each in factor[:3])
    return factor._replace(value=value, low=larger(1.0, low - off), high=high + off)


def wide_guided(blade: Blade, nu: float) -> WideBlades:
    """Return the factors of parallel blades whose ends do not turn.

    What guides them, or the next blade, keeps the body from turning whatever the ends say.
    """
    _, l, b = blade = _floats(blade)
    factor = _factor(plates.guided_factor, blade, nu)
    _, bent = _shortening(blade, nu)
    bends = 6.0 / l**2, -6.0 / l**2
    held = _held(blade, nu)
    held |= {"clamped-free": held["clamped-guided"], "clamped-pinned": held[LOCKED]}
    stiffness = _any_shape(factor, blade, nu)
    return WideBlades(b / l, stiffness, factor, held, (bent, 0.2 * bent), None, bends)


def wide_cantilever(blade: Blade, nu: float) -> WideBlades:
    """Return the factors of a blade that a force bends at its free tip."""
    _, l, b = blade = _floats(blade)
    factor = _factor(plates.cantilever_factor, blade, nu)
    change = number(plate_shortening.cantilever_shift_factor(b=b, l=l, poisson_ratio=nu)) - 1.0
    shift = change, 0.2 * sum(_shortening(blade, nu))
    stiffness = _any_shape(factor, blade, nu)
    return WideBlades(b / l, stiffness, factor, _held(blade, nu), shift, None, (3.0 / l**2, 0.0))


def wide_moment(blade: Blade, nu: float) -> WideBlades:
    """Return the factors of a blade that a moment bends at its free tip."""
    _, l, b = blade = _floats(blade)
    factor = _factor(plates.pure_bending_factor, blade, nu)
    pure, _ = _shortening(blade, nu)
    shift, bends = (-pure / 2.0, 0.2 * pure), (1.0 / l, 1.0 / l)
    stiffness = _any_shape(factor, blade, nu)
    return WideBlades(b / l, stiffness, factor, _held(blade, nu), shift, None, bends, uneven=0.0)


def wide_halves(blade: Blade, nu: float, crossing: float, half_angle: float) -> WideBlades:
    """Return the factors of two pivots of p = 0 in series, clamped by the cross of the blades.

    A blade that curls where they cross stretches the other by tan α of that, which holds it
    straight, the less the thicker they are and the flatter they cross; what turns unevenly along
    it is little. Both halves bear the same moment there, half that of the body: the stress rises as
    the stiffness. What rigid clamps stiffen by keeping ends as thick as they are is of
    :mod:`flexcli.parts.bending.solid_cross`.
    """
    blade = _floats(blade)
    shares = (crossing, 1.0 - crossing)
    parts = [blade._replace(l=share * blade.l) for share in shares]
    each = [_factor(plates.pivot_factor, part, nu, delta=0.0) for part in parts]
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
    blade = _floats(blade)
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
                _of_plates(f, part, nu)[index]
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
    blade = _floats(blade)
    loose = _loose(blade, half_angle)
    ends = []
    for share in (crossing, 1.0 - crossing):
        part = blade._replace(l=share * blade.l)
        pure, bent = (
            _factor(f, part, nu) for f in (plates.pure_bending_factor, plates.guided_factor)
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
    least = _held_on_a_line(_factor(plates.pure_bending_factor, longer, nu).low, loose)
    short = shorter._replace(b=SHORTEST * shorter.b)
    most = larger(_factor(plates.pure_bending_factor, short, nu).high, factor.high)
    return larger(most / factor.value - 1.0, 1.0 - least / factor.value)


def _buckled_halves(longer: Blade, shorter: Blade, nu: float, loose: float) -> Factor:
    """Return the range of the factor of the force that buckles two halves, each in any shape."""
    least = _held_on_a_line(_buckled(longer, nu).low, loose)
    most = larger(_buckled(shorter, nu).high, _buckled(longer, nu).high)
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
        moved, off = _pivot_shift(1.0, *_shortening(part, nu))
        value += own * (moved + turn) / whole
        astray = smaller(UNEVEN_LINE + loose, 1.0) * (abs(turn) + abs(moved))
        error += abs(own / whole) * (off + lost**2 + astray)
    return value, error


def wide_necks(neck: Blade, nu: float, *, l: Numbers) -> WideBlades:
    """Return the factors of hinges at the ends of blades of length l that a stage's drive bends.

    The force is at half the height of the stage.
    """
    _, l_c, b = neck = _floats(neck)
    l = number(l)
    stiffness = _factor(plates.limb_hinge_factor, neck, nu, arm=(l - l_c) / 2.0)
    pure, _ = _shortening(neck, nu)
    share = 2.0 * l_c / l  # of the path, most of which is that of the rigid middle
    held = _held_necks(neck, nu)
    return WideBlades(b / l_c, stiffness, stiffness, held, (0.0, share * pure))


def wide_drawn(blades: Iterable[tuple[Blade, bool]], nu: float, *, springs: bool) -> WideBlades:
    """Return the range of the factors of drawn blades, from the least to the greatest.

    Each is given where it is thinnest, and whether its thickness is constant; springs that are not
    blades take their share.
    """
    found, hinged, kept = list[Factor](), list[Factor](), list[Factor]()
    most = path = pulled = 0.0
    for given, constant in blades:
        pulled = larger(pulled, PULLED if constant else NOTCH_PULLED)
        blade = _floats(given)
        most = larger(most, blade.b / blade.l)
        pure = _factor(plates.pure_bending_factor, blade, nu)
        if constant:
            bent = _factor(plates.guided_factor, blade, nu)
            found.append(Factor((pure.value + bent.value) / 2.0, pure.low, bent.high))
            hinged.append(_buckling(blade, nu, HINGED))
            kept.append(_buckled(blade, nu))
            path = larger(path, *_shortening(blade, nu))
        else:
            found.append(_between(pure.low, nu))
            kept.append(_between(1.0, nu))
            hinged.append(kept[-1])
            path = number(plates.bound(nu)) / 5.0
    any_shape = hull(found)
    stiffness = hull([any_shape, Factor(1.0, 1.0, 1.0)]) if springs else any_shape
    flat = 1.0 + number(plates.bound(nu))
    # what one blade takes more of than another adds to its own factor; curvature flattens it
    spread = stiffness.high - stiffness.low
    stress = Factor(stiffness.value, larger(1.0 - spread, stiffness.low - spread), flat + spread)
    if springs:
        kept.append(Factor(1.0, 1.0, 1.0))
    # on hinges a blade buckles alone
    buckles = dict.fromkeys(EFFECTIVE_LENGTH, hull(kept)) | {HINGED: hull(hinged)}
    return WideBlades(most, stiffness, stress, buckles, (0.0, CANCELS * path), pulled=pulled)


def wide_by_shapes(
    plain: WideBlades, blades: Sequence[Blade], nu: float, layout: "Layout", held: Held
) -> WideBlades:
    """Return the factors of drawn blades of constant thickness, from a layout's beams.

    ``held`` is a unit travel of its moving body, ``plain`` the factors known without. A clamped
    blade takes the even and the odd part of its bending, and what stretches it, each by its own
    factor. With the motions of the beams the energy of the plates is an upper bound, with their
    forces a lower.
    """
    from flexcli.mechanics.linear import linear
    from flexcli.parts.bending.drawn_shift import drawn_path

    one_alone()
    solution = linear(layout, {MOVING: held})
    if not solution.unique.all():
        return plain
    axis = next(i for i in (2, 1) if held[i])
    whole = number(solution.reactions[0, layout.index(MOVING), axis])
    more = less = 0.0  # of twice the energy
    each, bends, curved, most_bent = [], (0.0, 0.0), 0.0, blades[0]
    for blade, strip, force in zip(blades, layout.blades, solution.end_forces[0], strict=True):
        h, l, b = blade
        x, y = np.subtract(strip.end, strip.start)
        last = number(force[2])
        first = last + number(force[1] * x - force[0] * y)
        even, odd = (first + last) / 2.0, (first - last) / 2.0
        compliance = l / number(second_moment(b, h))
        pure, bent = (
            _factor(f, blade, nu) for f in (plates.pure_bending_factor, plates.guided_factor)
        )
        stretched = number(sheets.axial_factor(b=b, l=l, poisson_ratio=nu))
        kept = Factor(stretched, stretched - sheets.SHEET_ERROR, stretched + sheets.SHEET_ERROR)
        along, shear = number(force[0] * x + force[1] * y) / l, _shear(blade, nu)
        parts = (
            (even**2 * compliance, pure),
            (odd**2 / 3.0 * compliance * (1.0 + shear), bent),
            (along**2 * l / (b * h), kept),
        )
        more += sum(energy * (factor.high - 1.0) for energy, factor in parts)
        less += sum(energy * (1.0 / factor.low - 1.0) for energy, factor in parts)
        ends = abs(even) + abs(odd)
        if ends:
            share = abs(odd) / ends
            each.append(Factor(
                pure.value + share * (bent.value - pure.value),
                pure.low + share * (bent.low - pure.low),
                pure.high + share * (bent.high - pure.high),
            ))  # fmt: skip
        over = b**2 / h * ends * compliance / l
        if over > curved:
            curved, bends = over, (first * compliance / l, last * compliance / l)
            most_bent = blade
    if whole <= 0.0 or not each:
        return plain
    high, low = 1.0 + more / whole, 1.0 / (1.0 + less / whole)
    at = hull(each)
    spread = at.high - at.low
    # what one blade takes more of than another adds to its own factor
    stress = Factor(at.value, larger(1.0 - spread, at.low - spread), at.high + spread)
    middle, least = (low + high) / 2.0, plain.stiffness.low
    most = 1.0 + number(plates.bound(nu))
    other = larger(most / middle - 1.0, 1.0 - least / middle)
    stiffness = Factor(middle, larger(1.0, low), high, other)
    found = plain._replace(stiffness=stiffness, stress=stress, bends=bends, bent=tuple(most_bent))
    return found._replace(path=drawn_path(blades, nu, layout, held))


def wide_linked(each: Sequence[WideBlades | None]) -> WideBlades | None:
    """Return the range of a linkage's joints, which reflect their stiffness to the input."""
    found = [wide for wide in each if wide is not None]
    if not found:
        return None
    rigid = [Factor(1.0, 1.0, 1.0)] if len(found) < len(each) else []
    stiffness = hull([*(w.stiffness for w in found), *rigid])
    stress = hull([*(w.stress for w in found), *rigid])
    held = {ends: hull(w.buckling[ends] for w in found) for ends in EFFECTIVE_LENGTH}
    ratio, most = larger(w.ratio for w in found), larger(w.pulled for w in found)
    return WideBlades(ratio, stiffness, stress, held, pulled=most)


def _any_shape(factor: Factor, blade: Blade, nu: float) -> Factor:
    """Return a factor with its error for blades that bend in any other shape.

    Of all shapes between clamps pure bending curls the most.
    """
    pure, short = (
        _factor(plates.pure_bending_factor, blade._replace(b=b), nu)
        for b in (blade.b, SHORTEST * blade.b)
    )
    least, most = pure.low, larger(short.high, factor.high)
    return factor._replace(other=larger(most / factor.value - 1.0, 1.0 - least / factor.value))


def _buckled(blade: Blade, nu: float) -> Factor:
    """Return the range of the factor of the force that buckles a blade in any shape between clamps.

    Plates under any axial force, bent evenly or oddly, are softest where their ends have no moment.
    """
    least = _buckling(blade, nu, HINGED).low
    most = _factor(plates.pure_bending_factor, blade._replace(b=SHORTEST * blade.b), nu).high
    return Factor((least + most) / 2.0, least, most)


def _floats(blade: Blade) -> Blade:
    return Blade(number(blade.h), number(blade.l), number(blade.b))  # without fillets


def _shortening(blade: Blade, nu: float) -> tuple[float, float]:
    """Return the extra shortening of a blade over a beam, bent to an arc and to an S [-]."""
    at: dict[str, Any] = {"b": blade.b, "l": blade.l, "poisson_ratio": nu}
    pure = number(plate_shortening.pure_shortening_factor(**at)) - 1.0
    return pure, number(plate_shortening.s_shortening_factor(**at)) - 1.0


def _held(blade: Blade, nu: float) -> dict[str, Factor]:
    """Return the factors of the critical force by its end conditions."""
    return {ends: _buckling(blade, nu, ends) for ends in EFFECTIVE_LENGTH}


def _held_necks(neck: Blade, nu: float) -> dict[str, Factor]:
    """Return the factors of the force that buckles two hinges with a rigid middle, by their ends.

    The blades of a stage keep it upright: one that is not kept from turning buckles as if it were.
    Its hinges bend to an arc as it sways, to an S where it is kept from that as well.
    """
    pure, bent = (_factor(f, neck, nu) for f in (plates.pure_bending_factor, plates.guided_factor))
    off = NECKS_BUCKLED * (pure.value - 1.0)
    arc = pure._replace(low=larger(1.0, pure.low - off), high=pure.high + off)
    locked = hull([arc, bent])
    return dict.fromkeys(EFFECTIVE_LENGTH, arc) | {LOCKED: locked, "clamped-pinned": locked}


def _factor(formula: Any, blade: Blade, nu: float, **more: float) -> Factor:
    """Return a factor of a formula with its error, between beam and flat plate."""
    at = {"b": blade.b, "l": blade.l, "poisson_ratio": nu, **more}
    value, thin = number(formula(h=blade.h, **at)), number(formula(**at))
    error, ends = number(plates.factor_error(value, thin)), ENDS.get(formula, 6.0)
    return _with_error(value, error, blade, nu, ends)


def _buckling(blade: Blade, nu: float, ends: str) -> Factor:
    at: dict[str, Any] = {"b": blade.b, "l": blade.l, "poisson_ratio": nu, "ends": ends}
    value = number(plate_buckling.buckling_factor(h=blade.h, **at))
    thin = number(plate_buckling.buckling_factor(**at))
    fit = plate_buckling.BUCKLING_ERROR[ends]
    return _with_error(value, number(plates.factor_error(value, thin, fit)), blade, nu)


def _of_plates(formula: Any, blade: Blade, nu: float) -> Factor:
    """Return a factor with its error, of blades that do not shear and whose ends may thin."""
    at = {"b": blade.b, "l": blade.l, "poisson_ratio": nu}
    value, thin = number(formula(h=blade.h, **at)), number(formula(**at))
    return _between_beam_and_plate(value, number(plates.factor_error(value, thin)), nu)


def _between_beam_and_plate(value: float, error: float, nu: float) -> Factor:
    most = 1.0 + number(plates.bound(nu))
    return Factor(value, larger(1.0, value - error), smaller(most, value + error))


def _with_error(value: float, error: float, blade: Blade, nu: float, ends: float = 6.0) -> Factor:
    """Return a factor with its range: of thin plates, and what thickness changes of wide ones."""
    flat = plates.flat_share(value, nu)
    beyond = plates.beyond_plate(h=blade.h, l=blade.l, poisson_ratio=nu, flat=flat, ends=ends)
    less, more = (value * number(each) for each in beyond)
    value, low, high, _ = _between_beam_and_plate(value, error, nu)
    return Factor(value, low - less, high + more)


def _between(low: float, nu: float) -> Factor:
    """Return a factor between a lower bound and that of a plate kept flat."""
    flat = 1.0 + number(plates.bound(nu))
    return Factor((low + flat) / 2.0, low, flat)


def _pivot_across(blade: Blade, nu: float, delta: float, half_angle: float) -> WideAcross:
    """Return what moves the centre of a pair across its bisector: the forces that bend its blades.

    They bend to an S and stretch as plates do.
    """
    h, l, b = blade
    at = {"l": l, "p": delta * l, "theta": 1.0, "half_angle": half_angle}
    along = abs(number(pivot.parasitic_shift(**at)))
    moved = abs(number(thick_blades.pivot_shift_across(h=h, poisson_ratio=-1.0, **at)))
    stretch = number(
        thick_blades.pivot_stretch(h=h, l=l, p=delta * l, half_angle=half_angle)
    ) / cos(half_angle)
    bent = _factor(plates.guided_factor, blade, nu)
    axial = number(sheets.axial_factor(b=b, l=l, poisson_ratio=nu))
    off = larger(bent.high / bent.value - 1.0, 1.0 - bent.low / bent.value)
    ratio = moved / along if along else inf if moved else 0.0
    unsure = UNSURE_ALONG + (abs(stretch) * l / along if along else inf)
    return WideAcross(
        ratio, unsure, bent.value / axial - 1.0, off + smaller(sheets.SHEET_ERROR, axial - 1.0)
    )


def _pivot_shift(gamma: float, pure: float, bent: float) -> tuple[float, float]:
    """Return the change of 5 − 9γ², whose parts −5/2 and −9γ² are shortenings of both shapes."""
    left = 5.0 - 9.0 * gamma**2
    moved = 2.5 * pure + 9.0 * gamma**2 * bent
    if left == 0.0:
        return 0.0, inf if moved else 0.0
    return -moved / left, 0.2 * moved / abs(left)
