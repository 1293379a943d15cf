"""Plate widening: a wide blade cannot curl across its width and is stiffer than a beam."""

from itertools import product
from math import inf
from typing import ClassVar

from flexcli.formulas.beam_column import uniform_bending
from flexcli.formulas.plate_factors import bound
from flexcli.formulas.plate_flattening import flat_width, secant_factor
from flexcli.formulas.plates_under_force import under_force
from flexcli.numerics.rows import larger, number, smaller
from flexcli.parts.bending import Change, Changes, Factor, WideAcross, WideBlades
from flexcli.parts.bending.base import UNEVEN
from flexcli.parts.bending.plate_range import floats
from flexcli.parts.bending.wide import LEAST_STRAIGHT, fillets_hold, held_less, wide_guided
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.axial_load import largest_load
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.results import ErrorRange

__all__ = [
    "PlateWidening",
    "change_by_loads",
    "flattest",
    "pulled",
    "stretched",
    "wide_of",
    "widest",
]

LEADS = 1.5
"""Ratio of the shift to its leading term up to which both change alike."""


class PlateWidening(ModelEffect):
    """Effect of rigid clamps on a wide blade, between a beam (E) and a plate (E/(1 − ν²)).

    It comes on top of any beam model; at small curvature, to which ``anticlastic`` adds.
    """

    name: ClassVar[EffectName] = EffectName.PLATE_WIDENING
    needs: ClassVar[str] = "poisson_ratio"
    is_whole: ClassVar[bool] = True

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the largest b/l of a blade or hinge."""
        wide = wide_of(setting)
        if wide is None:
            return None
        text = f"b/l = {wide.ratio:.3g}"
        if self.lacks(setting):
            text += ", Poisson's ratio anything from 0 to 0.5: giving it would decide"
        return Indicator(wide.ratio, text)

    def changes(self, setting: Setting) -> Changes:
        """Return the changes at rest, of the moment at a travel, and of the critical force."""
        wide = wide_of(setting)
        if wide is None:
            return {}
        known = not self.lacks(setting)
        found = {"stiffness": wide.stiffness.change(known)}
        if any(scene.blade_force for scene in setting.scenes):
            found["buckling"] = _buckling(wide, setting, known)
        if setting.largest_travel:
            found["stress"] = _stress(wide, setting, known)
            shift = _of_path(wide, setting) or wide.shift
            if shift is not None:
                if shift is wide.shift:
                    shift = shift[0], shift[1] + _flattened(wide, shift[0], setting)
                found["shift"] = _shift(*shift, setting, known)
                if wide.across is not None:
                    found["shift"] = _with_across(found["shift"], wide.across, setting)
        elif any(scene.is_loaded for scene in setting.scenes):
            spread = pulled(setting)
            found["stress"] = Change(0.0, spread, spread)
        if wide.sag is not None:
            value, error = wide.sag
            found["sag"] = Change(value if known else None, abs(value) + error, error, -1)
        return found


def pulled(setting: Setting) -> float:
    """Return by how much the stress of forces along wide blades may differ from beams' [-]."""
    wide = wide_of(setting)
    return 0.0 if wide is None else wide.pulled * (wide.stiffness.high - 1.0)


def stretched(setting: Setting) -> Factor:
    """Return the largest stress of a force along wide blades over that of beams, and its range."""
    wide = wide_of(setting)
    if (
        wide is not None
        and wide.stretched is not None
        and setting.material.poisson_ratio is not None
    ):
        return wide.stretched
    spread = pulled(setting)
    return Factor(1.0, 1.0 - spread, 1.0 + spread)


def widest(setting: Setting) -> float:
    """Return how stiff blades that bend in any shape may be, over beams; 1 where none is wide [-].

    Those that were compared in other shapes are no stiffer than kept flat.
    """
    wide = wide_of(setting)
    if wide is None:
        return 1.0
    return smaller(wide.stiffness.value * (1.0 + wide.stiffness.other), flattest(setting))


def flattest(setting: Setting) -> float:
    """Return how stiff blades kept flat all over are, over beams; 1 where none is wide [-]."""
    wide = wide_of(setting)
    return 1.0 if wide is None else 1.0 + number(bound(setting.poisson_bound))


def _stress(wide: WideBlades, setting: Setting, known: bool) -> Change:
    """Return the change of the stress, of an S shape where a case keeps a free tip from turning."""
    geometry, blade = setting.geometry, setting.blade
    keeps = geometry.turns_freely and any(scene.keeps_turn for scene in setting.scenes)
    if blade is None or not keeps:
        return wide.stress.change(known)
    if number(geometry.fillet(setting.sizes)):
        change = wide.stress.change(known)
        return change._replace(error=larger(change.error, wide.stiffness.other))
    return wide_guided(blade, setting.poisson_bound).stress.change(known)


def wide_of(setting: Setting) -> WideBlades | None:
    """Return the factors of a design's wide blades, for ν = ½ where it is not given."""
    return _LAST.of(setting)


def _without_fillets(geometry: Geometry, sizes: Sizes, nu: float) -> WideBlades | None:
    """Return the factors of blades that may be shorter by the fillets at their roots."""
    found = geometry.wide_blades(sizes, nu)
    radius = number(geometry.fillet(sizes))
    if found is None or not radius:
        return found
    straight = larger(sizes.l - 2.0 * radius, LEAST_STRAIGHT * sizes.l)
    short = geometry.wide_blades(sizes._replace(l=straight), nu)
    blade = geometry.blade(sizes)
    if short is None or blade is None:
        return found
    held = fillets_hold(floats(blade), straight)

    def either(one: Factor, other: Factor) -> Factor:
        low, high = smaller(one.low, other.low), larger(one.high, other.high)
        return held_less(one._replace(low=low, high=high), held)

    return found._replace(
        stiffness=either(found.stiffness, short.stiffness),
        stress=either(found.stress, short.stress),
        buckling={
            ends: either(factor, short.buckling[ends]) for ends, factor in found.buckling.items()
        },
    )


class _Last:
    """The last factors asked for, kept because every effect of wide blades needs the same."""

    def __init__(self) -> None:
        self.asked: tuple[Geometry, Sizes, float] | None = None
        self.found: WideBlades | None = None

    def of(self, setting: Setting) -> WideBlades | None:
        """Return the factors of a setting."""
        geometry, sizes, nu = setting.geometry, setting.sizes, setting.poisson_bound
        last = self.asked
        if last is None or last[0] is not geometry or last[1:] != (sizes, nu):
            self.found = _without_fillets(geometry, sizes, nu)
            self.asked = geometry, sizes, nu
        return self.found


_LAST = _Last()


def _buckling(wide: WideBlades, setting: Setting, known: bool) -> Change:
    """Return the change of the critical force, for the ends of every case that has one."""
    ends = {scene.ends for scene in setting.scenes if scene.blade_force}
    asked = [wide.buckling[e] for e in ends if e is not None]
    if None in ends or not asked:
        asked = list(wide.buckling.values())
    if len(asked) == 1:
        return asked[0].change(known)
    low, high = smaller(f.low for f in asked), larger(f.high for f in asked)
    middle = asked[0]._replace(value=(low + high) / 2.0, low=low, high=high)
    return middle.change(known)


def _of_path(wide: WideBlades, setting: Setting) -> tuple[float, float] | None:
    """Return the change of the shift of a drawn layout at the ends of its strokes, if known."""
    ends = [end for scene in setting.scenes if scene.moves for end in scene.stroke_ends]
    return wide.path.change(ends) if wide.path is not None and ends else None


def _flattened(wide: WideBlades, value: float, setting: Setting) -> float:
    """Return by how much curvature that flattens sections may change a shift besides.

    Blades that are flat bend as beams do, and shorten like these; one that is curved unevenly is
    flatter, and bent less, where it is curved the most.
    """
    blade = wide.bent or setting.blade
    if wide.bends is None or blade is None:
        return 0.0
    nu, (h, _, b) = setting.poisson_bound, (number(size) for size in blade)
    most = number(bound(nu))
    if most == 0.0:
        return 0.0
    curvature = larger(abs(end) for end in wide.bends) * setting.largest_travel
    beta = flat_width(b=b, h=h, curvature=curvature, poisson_ratio=nu)
    flat = larger(number(secant_factor(beta=beta, poisson_ratio=nu)) - 1.0, 0.0)
    return flat / most * abs(value) + UNEVEN * flat * wide.uneven


def _with_across(along: Change, across: WideAcross, setting: Setting) -> Change:
    """Return the change of a shift of which a part is across the bisector.

    Both are at right angles: each counts by its share of the square.
    """
    ratio, unsure = across.ratio / setting.largest_travel, across.unsure
    more = across.change + across.error
    if along.value is None:
        return along._replace(bound=larger(along.bound, more))
    if not ratio < inf:
        return Change(across.change, more, across.error)
    low, share = (x**2 / (1.0 + x**2) for x in (ratio / (1.0 + unsure), ratio))
    most = ratio / (1.0 - unsure) if unsure < 1.0 else inf
    high = 1.0 if most == inf else most**2 / (1.0 + most**2)
    apart = abs(across.change - along.value)
    value = (1.0 - share) * along.value + share * across.change
    error = (1.0 - low) * along.error + high * across.error
    error += larger(high - share, share - low) * apart + high * (1.0 - low) * apart**2
    return Change(value, larger(along.bound, more), error)


def _shift(value: float, error: float, setting: Setting, known: bool) -> Change:
    """Return the change of the shift; value and error are shares of the leading term.

    Where the leading term nearly vanishes the shift is of next order: a share of that.
    """
    bending, whole = setting.bending, 1.0
    next_order = bending.rotation().get("shift") if bending is not None else None
    if next_order is not None and next_order.value is not None:
        whole = larger(whole, abs(1.0 + next_order.value))
    bound = (abs(value) + error) / whole
    return Change(value, bound, error) if known and whole <= LEADS else Change(None, bound)


def change_by_loads(setting: Setting) -> ErrorRange:
    """Return by how much a force along the blades changes a factor at a travel, either way.

    They are bent to an arc, to an S or to what is between. Of blades that differ it says nothing.
    """
    n, blade = largest_load(setting), setting.blade
    if n == 0.0 or blade is None:
        return ErrorRange(0.0, 0.0)
    low = high = 1.0
    for pull, (last, rest) in product((n, -n), ((1.0, 1.0), (-1.0, 0.0))):
        least, most = under_force(
            first=1.0,
            last=last,
            mean=rest / uniform_bending(pull),
            n=pull,
            b=blade.b,
            l=blade.l,
            poisson_ratio=setting.poisson_bound,
            h=blade.h,
            grows=False,
        )
        low, high = smaller(low, number(least)), larger(high, number(most))
    return ErrorRange(low - 1.0, high - 1.0)
