"""Wide blades: how much stiffer the blades or hinges of a joint are than the beams of them."""

from collections.abc import Iterable, Sequence
from math import inf
from typing import Any, NamedTuple

import numpy as np

from flexcli.formulas import plate_buckling, plate_shortening
from flexcli.formulas import plate_factors as plates
from flexcli.formulas import sheet_factors as sheets
from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.notch_compliance import bending_reach, circular_compliance
from flexcli.formulas.profile import Notch, Profile
from flexcli.formulas.section import second_moment
from flexcli.parts.bending.base import Change
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.geometries.base import MOVING, Blade
from flexcli.parts.geometries.blade_profile import ConstantProfile
from flexcli.parts.geometries.free_layout import FreeLayout
from flexcli.parts.geometries.hinged import HingedPivot, HingedStage
from flexcli.parts.geometries.leaf_stage import LeafSpringStage
from flexcli.parts.geometries.linkage import LinkageGeometry
from flexcli.parts.geometries.necked_stage import NeckedDownStage
from flexcli.parts.geometries.notch import NotchGeometry
from flexcli.parts.geometries.pivots import BladePivot, PairPivot
from flexcli.parts.geometries.single_blade import Cantilever, GuidedBlade, MomentBlade
from flexcli.parts.geometries.unseparated import UnseparatedPivot

__all__ = ["Factor", "WideBlades", "wide_blades"]

RITZ_ERROR = 1e-3
"""Largest error of a plate solved by Ritz's method with few functions [-]."""

UNIT = Elastic(1.0, None)

CANCELS = 10.0
"""Times that a layout's shift may be smaller than the shortening of a blade that makes it."""


class Factor(NamedTuple):
    """A plate's number over the beam's: the best value, and the range it is in [-].

    ``other`` is how far off the value may be for blades that bend in any other shape, as a share.
    """

    value: float
    low: float
    high: float
    other: float = inf

    def change(self, nu_known: bool) -> Change:
        """Return it as a change; where ν is not known, it was taken as ½ and is a bound."""
        if not nu_known:
            return Change(None, self.high - 1.0, 0.0, 1)
        error = max(self.high - self.value, self.value - self.low) / self.value
        return Change(self.value - 1.0, self.high - 1.0, error, other=self.other)


class WideBlades(NamedTuple):
    """What the width of its blades changes in a joint; ν is that of the material, or ½.

    ``shift`` and ``sag`` are relative changes with their errors; nothing where the first is zero
    or the second follows from the stiffness.
    """

    ratio: float
    """Largest b/l."""
    stiffness: Factor
    stress: Factor
    buckling: dict[str, Factor]
    shift: tuple[float, float] | None = None
    sag: tuple[float, float] | None = None
    bends: tuple[float, float] | None = None
    """Curvatures at both ends of a blade of constant thickness, over the travel [1/m or 1/m²]."""
    bent: Blade | None = None
    """The blade that these are of, where the joint has more than one shape of blades."""


def wide_blades(geometry: Geometry, sizes: Sizes, nu: float) -> WideBlades | None:
    """Return the factors of a joint, nothing where nothing of it bends across its thickness."""
    if isinstance(geometry, LinkageGeometry):
        return _of_linkage(geometry, sizes, nu)
    if isinstance(geometry, FreeLayout):
        return _of_layout(geometry, sizes, nu)
    if isinstance(geometry, NotchGeometry | HingedStage | HingedPivot):
        return _of_notch(geometry, sizes, nu)
    if isinstance(geometry, NeckedDownStage):
        return _of_necks(sizes, nu)
    blade = geometry.blade(sizes)
    if blade is None:
        return None
    return _of_blades(geometry, sizes, Blade(*(float(size) for size in blade)), nu)


def _of_blades(geometry: Geometry, sizes: Sizes, blade: Blade, nu: float) -> WideBlades | None:
    at: dict[str, Any] = {"b": blade.b, "l": blade.l, "poisson_ratio": nu}
    pure, bent = (float(f(**at)) - 1.0 for f in _SHORTENING)
    shift: tuple[float, float] | None
    if isinstance(geometry, UnseparatedPivot):
        return _of_halves(geometry, blade, nu)
    if isinstance(geometry, BladePivot):
        delta = float(geometry.offset(sizes)) / blade.l
        stiffness = _factor(plates.pivot_factor, blade, nu, delta=delta)
        stress = _factor(plates.end_moment_factor, blade, nu, delta=delta)
        gamma = 1.0 + 2.0 * delta
        shift = _pivot_shift(gamma, pure, bent) if isinstance(geometry, PairPivot) else None
        bends = (1.0 - 3.0 * gamma) / blade.l, (1.0 + 3.0 * gamma) / blade.l
    elif isinstance(geometry, LeafSpringStage | GuidedBlade):
        stiffness = stress = _factor(plates.guided_factor, blade, nu)
        shift = bent, 0.2 * bent
        bends = 6.0 / blade.l**2, -6.0 / blade.l**2
    elif isinstance(geometry, Cantilever):
        stiffness = stress = _factor(plates.cantilever_factor, blade, nu)
        change = float(plate_shortening.cantilever_shift_factor(**at)) - 1.0
        shift = change, 0.2 * (pure + bent)
        bends = 3.0 / blade.l**2, 0.0
    elif isinstance(geometry, MomentBlade):
        stiffness = stress = _factor(plates.pure_bending_factor, blade, nu)
        shift = -pure / 2.0, 0.2 * pure
        bends = 1.0 / blade.l, 1.0 / blade.l
    else:
        return None
    # of all shapes between clamps pure bending curls the most, and a flat plate not at all
    least = _factor(plates.pure_bending_factor, blade, nu).low
    most = 1.0 + float(plates.bound(nu))
    apart = max(most / stiffness.value - 1.0, 1.0 - least / stiffness.value)
    stiffness = stiffness._replace(other=apart)
    held = {ends: _buckling(blade, nu, ends) for ends in EFFECTIVE_LENGTH}
    if isinstance(geometry, BladePivot):  # whose body turns as well: the shape is none of these
        held |= {ends: _hull(held.values(), at=held[ends]) for ends in held if ends != LOCKED}
    sag = None
    if geometry.sag_bends_width:
        inverse = 1.0 / float(sheets.guided_factor(b=blade.b, l=blade.l, poisson_ratio=nu))
        sag = inverse - 1.0, sheets.GUIDED_ERROR
    return WideBlades(blade.b / blade.l, stiffness, stress, held, shift, sag, bends)


LOCKED = "clamped-clamped"
_SHORTENING = plate_shortening.pure_shortening_factor, plate_shortening.s_shortening_factor


def _of_halves(geometry: UnseparatedPivot, blade: Blade, nu: float) -> WideBlades:
    """Return the factors of two pivots of p = 0 in series, clamped by the cross of the blades."""
    shares = (geometry.crossing, 1.0 - geometry.crossing)
    parts = [blade._replace(l=share * blade.l) for share in shares]
    each = [_factor(plates.pivot_factor, part, nu, delta=0.0) for part in parts]
    value, low, high = (
        1.0 / sum(share / factor[i] for share, factor in zip(shares, each, strict=True))
        for i in range(3)
    )
    whole = _factor(plates.pivot_factor, blade, nu, delta=0.0)
    # the cross is thin, and holds its sections by the other blade alone
    stiffness = Factor(value, min(low, whole.low), high)
    ends = [_factor(plates.end_moment_factor, part, nu, delta=0.0) for part in parts]
    stress = _hull([*ends, stiffness], at=Factor(max(e.value for e in ends), 1.0, 1.0))
    shifts = [
        _pivot_shift(1.0, *(float(f(b=p.b, l=p.l, poisson_ratio=nu)) - 1.0 for f in _SHORTENING))
        for p in parts
    ]
    # each half turns by its own share, and their shifts may cancel
    most = CANCELS * max(abs(value) + error for value, error in shifts)
    held = {ends: _buckling(blade, nu, ends) for ends in EFFECTIVE_LENGTH}
    flat = Factor(1.0, 1.0, 1.0 + float(plates.bound(nu)))
    held = {ends: _hull([flat], at=held[ends]) for ends in held}
    bends = 4.0 / blade.l, -2.0 / blade.l  # at the cross and at the ends of either half
    widest = blade.b / min(part.l for part in parts)
    return WideBlades(widest, stiffness, stress, held, (0.0, most), None, bends)


def _of_necks(sizes: Any, nu: float) -> WideBlades:
    """Return the factors of hinges that a force at half the height of the stage bends."""
    h, l_c, l, b = (float(size) for size in sizes)
    neck = Blade(h, l_c, b)
    stiffness = _factor(plates.limb_hinge_factor, neck, nu, arm=(l - l_c) / 2.0)
    buckles = _between(float(plates.pure_bending_factor(b=b, l=l_c, poisson_ratio=nu, h=h)), nu)
    pure = float(plate_shortening.pure_shortening_factor(b=b, l=l_c, poisson_ratio=nu)) - 1.0
    share = 2.0 * l_c / l  # of the path, most of which is that of the rigid middle
    held = dict.fromkeys(EFFECTIVE_LENGTH, buckles)
    return WideBlades(b / l_c, stiffness, stiffness, held, (0.0, share * pure))


def _of_notch(geometry: Geometry, sizes: Any, nu: float) -> WideBlades:
    """Return the factors of a hinge of its thickness profile that rigid bodies hold."""
    from flexcli.mechanics.wide_hinge import wide_hinge

    b = float(sizes.b)
    if isinstance(geometry, HingedStage | HingedPivot):
        e, l = float(sizes.e), 2.0 * float(sizes.r)
        profile: Profile = Notch(e, l / 2.0)
        turn = float(geometry.hinge(UNIT, sizes)[0])
        C = circular_compliance(E=1.0, b=1.0, e=e, r=l / 2.0)
        # a force across the limb bends its hinges by a moment that is not the same all along
        reach = float(bending_reach(across=C.across, turn=C.turn)) / float(sizes.l)
        uneven = 4.0 * reach**2
    else:
        assert isinstance(geometry, NotchGeometry)  # the caller's other kind
        e = float(geometry.throat(sizes)[0])
        profile, l = geometry.profile(type(sizes)(*map(float, sizes)))
        turn, uneven = float(geometry.stiffness(UNIT, sizes)), 0.0
    numbers = tuple(float(each) for each in vars(profile).values())
    thin, thick = (
        wide_hinge(type(profile), numbers, float(l), width, nu)
        for width in (b, float(plates.effective_width(b=b, h=e)))
    )
    widening, bends = float(plates.bound(nu)), float(second_moment(b, e)) / turn
    factor = _as_a_solid(thick.stiffness, e / b, e / bends, widening)
    low, high = factor.low - uneven * widening, factor.high + uneven * widening
    factor = factor._replace(low=max(1.0, low), high=high)
    held = dict.fromkeys(EFFECTIVE_LENGTH, factor._replace(high=1.0 + widening))
    moves = (thin.shift, thick.shift)
    middle = sum(moves) / 2.0 - 1.0
    spread = abs(moves[0] - moves[1]) / 2.0 + 0.3 * max(abs(m - 1.0) for m in moves)
    # of limbs the path of the whole counts, which their hinges shorten by a share of it
    shift = (0.0, abs(middle) + spread) if uneven else (middle, spread)
    return WideBlades(b / bends, factor, factor, held, shift)


def _as_a_solid(plate: float, t: float, depth: float, widening: float) -> Factor:
    """Return the factor of a notch from that of the plate, which is thin.

    Solids of t = e/b up to ½ and e/r from 0.005 to 0.5 widen by 0.65 t less, to 0.75 t about that;
    a throat as deep as it bends long (``depth``) spreads its own stress when it is kept flat.
    """
    over, share = plate - 1.0, 0.14 * depth**2
    away = min(RITZ_ERROR, plates.OF_WIDENING * over) + over * (0.75 * t + share)
    value = 1.0 + over * max(1.0 - 0.65 * t, 0.35)
    return Factor(value, max(1.0, value - away), min(1.0 + widening * (1.0 + share), value + away))


def _of_layout(geometry: FreeLayout, sizes: Sizes, nu: float) -> WideBlades | None:
    """Return the range of its blades: from the least that one is stiffer to the most."""
    found, most, path = [], 0.0, 0.0
    for name, drawn in geometry.blades.items():
        h = float(drawn.thickness.thinnest(geometry.size_of(name, sizes)))
        blade = Blade(h, drawn.length, drawn.b)
        most = max(most, blade.b / blade.l)
        pure = _factor(plates.pure_bending_factor, blade, nu)
        if isinstance(drawn.thickness, ConstantProfile):
            bent = _factor(plates.guided_factor, blade, nu)
            found.append(Factor((pure.value + bent.value) / 2.0, pure.low, bent.high))
            at: dict[str, Any] = {"b": blade.b, "l": blade.l, "poisson_ratio": nu}
            path = max(path, *(float(f(**at)) - 1.0 for f in _SHORTENING))
        else:
            found.append(_between(pure.low, nu))
            path = float(plates.bound(nu)) / 5.0
    held = geometry.supports  # springs that are no blades take their share
    hull = _hull(found)
    stiffness = _hull([hull, Factor(1.0, 1.0, 1.0)]) if held else hull
    flat = 1.0 + float(plates.bound(nu))
    # what one blade takes more of than another adds to its own factor; curvature flattens it
    spread = stiffness.high - stiffness.low
    stress = Factor(stiffness.value, max(1.0 - spread, stiffness.low - spread), flat + spread)
    buckles = dict.fromkeys(EFFECTIVE_LENGTH, Factor(stiffness.value, 1.0, flat))
    plain = WideBlades(most, stiffness, stress, buckles, (0.0, CANCELS * path))
    straight = all(
        isinstance(drawn.thickness, ConstantProfile) for drawn in geometry.blades.values()
    )
    return _of_its_shapes(geometry, sizes, nu, plain) if straight else plain


def _of_its_shapes(geometry: FreeLayout, sizes: Sizes, nu: float, plain: WideBlades) -> WideBlades:
    """Return the factors of a layout of blades of constant thickness by how its beams bend.

    A clamped blade takes the even and the odd part of its bending each by its own factor. With
    the motions of the beams the energy of the plates is an upper bound, with their forces a lower.
    """
    from flexcli.mechanics.linear import linear

    layout = geometry.layout(Elastic(1.0, nu), sizes)
    solution = linear(layout, {MOVING: geometry.held(1.0)})
    if not solution.unique.all():
        return plain
    axis = 2 if geometry.motion == "rotation" else 1
    whole = float(solution.reactions[0, layout.index(MOVING), axis])
    more = less = 0.0  # of twice the energy
    each, bends, curved = [], (0.0, 0.0), 0.0
    for drawn, strip, force in zip(
        geometry.blades.items(), layout.blades, solution.end_forces[0], strict=True
    ):
        name, own = drawn
        h, b = float(own.thickness.thinnest(geometry.size_of(name, sizes))), float(own.b)
        (x, y), l = np.subtract(strip.end, strip.start), own.length
        last = float(force[2])
        first = last + float(force[1] * x - force[0] * y)
        even, odd = (first + last) / 2.0, (first - last) / 2.0
        compliance = l / float(second_moment(b, h))
        blade = Blade(h, l, b)
        pure, bent = (
            _factor(f, blade, nu) for f in (plates.pure_bending_factor, plates.guided_factor)
        )
        parts = ((even**2 * compliance, pure), (odd**2 / 3.0 * compliance, bent))
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
            bent_blade = blade
    if whole <= 0.0 or not each:
        return plain
    high, low = 1.0 + more / whole, 1.0 / (1.0 + less / whole)
    at = _hull(each)
    spread = at.high - at.low
    # what one blade takes more of than another adds to its own factor
    stress = Factor(at.value, max(1.0 - spread, at.low - spread), at.high + spread)
    middle, least = (low + high) / 2.0, _hull([plain.stiffness]).low
    most = 1.0 + float(plates.bound(nu))
    other = max(most / middle - 1.0, 1.0 - least / middle)
    stiffness = Factor(middle, max(1.0, low), high, other)
    return plain._replace(stiffness=stiffness, stress=stress, bends=bends, bent=bent_blade)


def _of_linkage(geometry: LinkageGeometry, sizes: Sizes, nu: float) -> WideBlades | None:
    """Return the range of its joints, which reflect their stiffness to the input."""
    each = [wide_blades(part, geometry.sizes_of(n, sizes), nu) for n, part in geometry.flexures()]
    found = [wide for wide in each if wide is not None]
    if not found:
        return None
    rigid = [Factor(1.0, 1.0, 1.0)] if len(found) < len(each) else []
    stiffness = _hull([*(w.stiffness for w in found), *rigid])
    stress = _hull([*(w.stress for w in found), *rigid])
    held = {ends: _hull(w.buckling[ends] for w in found) for ends in EFFECTIVE_LENGTH}
    return WideBlades(max(w.ratio for w in found), stiffness, stress, held)


def _factor(formula: Any, blade: Blade, nu: float, **more: float) -> Factor:
    """Return a factor of a formula with its error, between beam and flat plate."""
    at = {"b": blade.b, "l": blade.l, "poisson_ratio": nu, **more}
    value, thin = float(formula(h=blade.h, **at)), float(formula(**at))
    return _with_error(value, float(plates.factor_error(value, thin)), nu)


def _buckling(blade: Blade, nu: float, ends: str) -> Factor:
    at: dict[str, Any] = {"b": blade.b, "l": blade.l, "poisson_ratio": nu, "ends": ends}
    value = float(plate_buckling.buckling_factor(h=blade.h, **at))
    thin = float(plate_buckling.buckling_factor(**at))
    fit = plate_buckling.BUCKLING_ERROR[ends]
    return _with_error(value, float(plates.factor_error(value, thin, fit)), nu)


def _with_error(value: float, error: float, nu: float) -> Factor:
    flat = 1.0 + float(plates.bound(nu))
    return Factor(value, max(1.0, value - error), min(flat, value + error))


def _between(low: float, nu: float) -> Factor:
    """Return what is at least a factor and at most that of a plate kept flat."""
    flat = 1.0 + float(plates.bound(nu))
    return Factor((low + flat) / 2.0, low, flat)


def _hull(factors: Iterable[Factor], at: Factor | None = None) -> Factor:
    """Return the range of all, about its middle or a given value."""
    found: Sequence[Factor] = tuple(factors)
    low, high = min(f.low for f in found), max(f.high for f in found)
    return Factor((low + high) / 2.0 if at is None else at.value, low, high)


def _pivot_shift(gamma: float, pure: float, bent: float) -> tuple[float, float]:
    """Return the change of 5 − 9γ², of which −5/2 and −9γ² are shortenings of the two shapes."""
    left = 5.0 - 9.0 * gamma**2
    moved = 2.5 * pure + 9.0 * gamma**2 * bent
    if left == 0.0:
        return 0.0, float("inf") if moved else 0.0
    return -moved / left, 0.2 * moved / abs(left)
