"""Wide blades: the increased stiffness of a joint's blades or hinges against beams."""

from collections.abc import Iterable, Sequence
from math import inf
from typing import TYPE_CHECKING

import numpy as np

from flexcli.formulas import pivot, plate_shortening, thick_blades
from flexcli.formulas import plate_factors as plates
from flexcli.formulas import sheet_factors as sheets
from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.clamps import pure_bending_peak
from flexcli.formulas.quantity import Computed, Numbers
from flexcli.formulas.section import second_moment
from flexcli.numerics.rows import Number, cos, larger, number, one_alone, smaller, tan
from flexcli.parts.bending.base import (
    NOTCH_PULLED,
    PULLED,
    SHORTEST,
    Factor,
    WideAcross,
    WideBlades,
    hull,
)
from flexcli.parts.bending.plate_range import (
    HINGED,
    LOCKED,
    TINY,
    UNSURE_ALONG,
    along_factor,
    between,
    blade_factor,
    buckled,
    buckling,
    floats,
    pivot_shift,
    plate_factor,
    shear_of,
    shortening,
)
from flexcli.parts.geometries.base import MOVING, Blade, Held

if TYPE_CHECKING:
    from flexcli.mechanics.layout import Layout

__all__ = [
    "LEAST_STRAIGHT",
    "fillets_hold",
    "held_less",
    "middle_bears",
    "wide_by_shapes",
    "wide_cantilever",
    "wide_drawn",
    "wide_guided",
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


SHAPES = plates.pure_bending_factor, plates.guided_factor
"""Factors of both shapes of a clamped blade, an arc and an S."""

LEAST_STRAIGHT = 0.01
"""Share of a blade's length to which its fillets shorten it at most: far wider than long."""

BLUNT = 20.0
"""Square of b/√(h r) at which fillets of a radius r hold half of what a clamp does: plates of their
profile in an arc had 0.28, 0.51 and 0.91 at b/√(h r) = 0.9, 2.4 and 10, all of it from 20 on; less
is taken of other shapes (a square of that)."""

FILLETS_CLAMP = 0.12
"""Share of the peak in the middle of a clamp that fillets have, over b/h, and over b/√(h r) where
they are blunt: a clamp curls back over a length like b, and they give way over √(h r). The whole of
it at most: solids of b/h 1 to 30, l/h 20 and 50, r/h 0.5 to 7 had 0.09 over b/h in narrow blades,
and up to 0.9 of it in wide ones, ν = 0.34; r/h 2 to 100, b/h 0.7 to 20, ν 0.3 and 0.45 had 0.08
over b/√(h r)."""

LET_OFF = 0.1
"""Part of the change of a pivot's factors by stretching and shear that may be wrong: springs in
space of 150 random stars had 0.02 at most."""


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
    _, l, b = blade = floats(blade)
    delta = number(delta)
    stiffness = _any_shape(blade_factor(plates.pivot_factor, blade, nu, delta=delta), blade, nu)
    stress = blade_factor(plates.end_moment_factor, blade, nu, delta=delta)
    gamma = 1.0 + 2.0 * delta
    shift, across, uneven = (0.0, CANCELS * larger(*shortening(blade, nu))), None, 1.0
    if half_angle is not None:
        shift = pivot_shift(gamma, *shortening(blade, nu))
        across = _pivot_across(blade, nu, delta, half_angle)
        leading = abs(5.0 - 9.0 * gamma**2)
        uneven = (2.5 + 9.0 * gamma**2) / leading if leading else inf
    odd = 3.0 * gamma**2 / (1.0 + 3.0 * gamma**2)
    stretching, shear = (_in_series(each, odd) for each in softer)
    springs = stretching, stretching / along_factor(blade, nu).value, shear
    pure, bent = (
        blade_factor(f, blade, nu).value for f in (plates.pure_bending_factor, plates.guided_factor)
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
    _, l, b = blade = floats(blade)
    factor = blade_factor(plates.guided_factor, blade, nu)
    _, bent = shortening(blade, nu)
    bends = 6.0 / l**2, -6.0 / l**2
    held = _held(blade, nu)
    held |= {"clamped-free": held["clamped-guided"], "clamped-pinned": held[LOCKED]}
    stiffness = _any_shape(factor, blade, nu)
    return WideBlades(b / l, stiffness, factor, held, (bent, 0.2 * bent), None, bends)


def wide_cantilever(blade: Blade, nu: float) -> WideBlades:
    """Return the factors of a blade that a force bends at its free tip."""
    _, l, b = blade = floats(blade)
    factor = blade_factor(plates.cantilever_factor, blade, nu)
    change = number(plate_shortening.cantilever_shift_factor(b=b, l=l, poisson_ratio=nu)) - 1.0
    shift = change, 0.2 * sum(shortening(blade, nu))
    stiffness = _any_shape(factor, blade, nu)
    return WideBlades(b / l, stiffness, factor, _held(blade, nu), shift, None, (3.0 / l**2, 0.0))


def wide_moment(blade: Blade, nu: float) -> WideBlades:
    """Return the factors of a blade that a moment bends at its free tip."""
    _, l, b = blade = floats(blade)
    factor = blade_factor(plates.pure_bending_factor, blade, nu)
    pure, _ = shortening(blade, nu)
    shift, bends = (-pure / 2.0, 0.2 * pure), (1.0 / l, 1.0 / l)
    stiffness = _any_shape(factor, blade, nu)
    return WideBlades(b / l, stiffness, factor, _held(blade, nu), shift, None, bends, uneven=0.0)


def wide_necks(neck: Blade, nu: float, *, l: Numbers) -> WideBlades:
    """Return the factors of hinges at the ends of blades of length l that a stage's drive bends.

    The force is at half the height of the stage.
    """
    _, l_c, b = neck = floats(neck)
    l = number(l)
    stiffness = blade_factor(plates.limb_hinge_factor, neck, nu, arm=(l - l_c) / 2.0)
    pure, _ = shortening(neck, nu)
    share = 2.0 * l_c / l  # of the path, most of which is that of the rigid middle
    held = _held_necks(neck, nu)
    return WideBlades(b / l_c, stiffness, stiffness, held, (0.0, share * pure))


def wide_drawn(
    blades: Iterable[tuple[Blade, Computed | None]], nu: float, *, springs: bool
) -> WideBlades:
    """Return the range of the factors of drawn blades, from the least to the greatest.

    Each is given where it is thinnest, with the length over which it is as thick as there but for
    fillets at its ends, nothing where its thickness varies otherwise; springs that are not blades
    take their share.
    """
    found, hinged, kept = list[Factor](), list[Factor](), list[Factor]()
    most = path = pulled = 0.0
    for given, straight in blades:
        blade = floats(given)
        most = larger(most, blade.b / blade.l)
        if straight is None:
            pulled = NOTCH_PULLED
            found.append(between(blade_factor(plates.pure_bending_factor, blade, nu).low, nu))
            kept.append(between(1.0, nu))
            hinged.append(kept[-1])
            path = number(plates.bound(nu)) / 5.0
            continue
        pulled = larger(pulled, PULLED if number(straight) == blade.l else NOTCH_PULLED)
        held = fillets_hold(blade, straight)
        for each in shortened(blade, straight):
            pure, bent = (blade_factor(f, each, nu) for f in SHAPES)
            factor = Factor((pure.value + bent.value) / 2.0, pure.low, bent.high)
            found.append(held_less(factor, held))
            hinged.append(held_less(buckling(each, nu, HINGED), held))
            kept.append(held_less(buckled(each, nu), held))
            path = larger(path, *shortening(each, nu))
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


def shortened(blade: Blade, straight: Computed) -> tuple[Blade, ...]:
    """Return a blade, and as it would be without its fillets, where it has some."""
    straight = number(straight)
    if straight == blade.l:
        return (blade,)
    return blade, blade._replace(l=larger(straight, LEAST_STRAIGHT * blade.l))


def fillets_hold(blade: Blade, straight: Computed) -> Number:
    """Return the share of what a clamp holds of a blade that fillets at its ends hold at least.

    ``y²/(y² + 20)``, y = b/√(h r): a narrow blade curls and narrows where blunt ones begin.
    """
    h, l, b = (number(size) for size in blade)
    r = (l - number(straight)) / 2.0
    return number(b**2 / (b**2 + BLUNT * h * r))


def held_less(factor: Factor, share: Number) -> Factor:
    """Return a factor of which no more than a share of what stiffens a blade is sure."""
    return factor._replace(low=smaller(factor.low, 1.0 + share * (factor.low - 1.0)))


def middle_bears(h: Number, r: Number, l: Number, b: Number, nu: float) -> Number:
    """Return by what share the middle of fillets may bear more of a moment than its mean [-]."""
    share = smaller(FILLETS_CLAMP * b / larger(h, (h * r) ** 0.5), 1.0)
    return share * (number(pure_bending_peak(b=b, l=l, poisson_ratio=nu)) - 1.0)


def wide_by_shapes(
    plain: WideBlades,
    blades: Sequence[tuple[Blade, float]],
    nu: float,
    layout: "Layout",
    held: Held,
) -> WideBlades:
    """Return the factors of drawn blades of constant thickness but for fillets, from their beams.

    ``held`` is a unit travel of its moving body, ``plain`` the factors known without; each blade is
    given with its length between the fillets. A clamped blade takes the even and the odd part of
    its bending, and what stretches it, each by its own factor. With the motions of the beams the
    energy of the plates is an upper bound, with their forces a lower.
    """
    from flexcli.formulas.notch_compliance import planar_compliance
    from flexcli.mechanics.linear import linear
    from flexcli.parts.bending.drawn_shift import drawn_path

    one_alone()
    solution = linear(layout, {MOVING: held})
    if not solution.unique.all():
        return plain
    axis = next(i for i in (2, 1) if held[i])
    whole = number(solution.reactions[0, layout.index(MOVING), axis])
    more = less = 0.0  # of twice the energy
    each, bends, curved, most_bent, middle_more = [], (0.0, 0.0), 0.0, blades[0][0], 0.0
    for (blade, straight), strip, force in zip(
        blades, layout.blades, solution.end_forces[0], strict=True
    ):
        h, l, b = blade
        x, y = np.subtract(strip.end, strip.start)
        last = number(force[2])
        first = last + number(force[1] * x - force[0] * y)
        even, odd = (first + last) / 2.0, (first - last) / 2.0
        compliance = l / number(second_moment(b, h))
        alike, kept = shortened(blade, straight), fillets_hold(blade, straight)
        pure, bent, stretched = (
            held_less(hull(factors), kept)
            for factors in (
                *([blade_factor(f, one, nu) for one in alike] for f in SHAPES),
                [along_factor(one, nu) for one in alike],
            )
        )
        along = number(force[0] * x + force[1] * y) / l
        C = planar_compliance(strip.profile, E=1.0, l=l, b=b, a=l / 2.0, G=0.5 / (1.0 + nu))
        parts = (
            (even**2 * number(C[..., 2, 2]), pure),
            ((2.0 * odd / l) ** 2 * number(C[..., 1, 1]), bent),
            (along**2 * number(C[..., 0, 0]), stretched),
        )
        if straight < l:
            middle_more = larger(middle_more, middle_bears(h, (l - straight) / 2.0, l, b, nu))
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
    stress = Factor(at.value, larger(1.0 - spread, at.low - spread), at.high + spread + middle_more)
    middle, least = (low + high) / 2.0, plain.stiffness.low
    most = 1.0 + number(plates.bound(nu))
    other = larger(most / middle - 1.0, 1.0 - least / middle)
    stiffness = Factor(middle, larger(1.0, low), high, other)
    found = plain._replace(stiffness=stiffness, stress=stress, bends=bends, bent=tuple(most_bent))
    if any(straight < blade.l for blade, straight in blades):
        return found
    return found._replace(path=drawn_path([blade for blade, _ in blades], nu, layout, held))


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
        blade_factor(plates.pure_bending_factor, blade._replace(b=b), nu)
        for b in (blade.b, SHORTEST * blade.b)
    )
    least, most = pure.low, larger(short.high, factor.high)
    return factor._replace(other=larger(most / factor.value - 1.0, 1.0 - least / factor.value))


def _held(blade: Blade, nu: float) -> dict[str, Factor]:
    """Return the factors of the critical force by its end conditions."""
    return {ends: buckling(blade, nu, ends) for ends in EFFECTIVE_LENGTH}


def _held_necks(neck: Blade, nu: float) -> dict[str, Factor]:
    """Return the factors of the force that buckles two hinges with a rigid middle, by their ends.

    The blades of a stage keep it upright: one that is not kept from turning buckles as if it were.
    Its hinges bend to an arc as it sways, to an S where it is kept from that as well.
    """
    pure, bent = (
        plate_factor(f, neck, nu) for f in (plates.pure_bending_factor, plates.guided_factor)
    )
    off = NECKS_BUCKLED * (pure.value - 1.0)
    arc = pure._replace(low=larger(1.0, pure.low - off), high=pure.high + off)
    locked = hull([arc, bent])
    return dict.fromkeys(EFFECTIVE_LENGTH, arc) | {LOCKED: locked, "clamped-pinned": locked}


def _pivot_across(blade: Blade, nu: float, delta: float, half_angle: float) -> WideAcross:
    """Return what moves the centre of a pair across its bisector: the forces that bend its blades.

    They bend to an S and stretch as plates do: of ``κ/(1 + κ)``, κ what forces across one blade
    stretch of the other over what they bend of itself, κ changes.
    """
    h, l, _ = blade
    at = {"l": l, "p": delta * l, "theta": 1.0, "half_angle": half_angle}
    along = abs(number(pivot.parasitic_shift(**at)))
    moved = abs(number(thick_blades.pivot_shift_across(h=h, poisson_ratio=-1.0, **at)))
    stretch = number(
        thick_blades.pivot_stretch(h=h, l=l, p=delta * l, half_angle=half_angle)
    ) / cos(half_angle)
    bent = blade_factor(plates.guided_factor, blade, nu)
    axial = along_factor(blade, nu)
    off = bent.off + axial.off
    stiffer = bent.value / axial.value
    kappa = (h / l) ** 2 / (1.0 + shear_of(blade, nu)) / tan(half_angle) ** 2
    change = stiffer * (1.0 + kappa) / (1.0 + stiffer * kappa) - 1.0
    ratio = moved / along if along else inf if moved else 0.0
    unsure = UNSURE_ALONG + (abs(stretch) * l / along if along else inf)
    return WideAcross(ratio, unsure, change, off)
