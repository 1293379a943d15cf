"""Clamps: they keep a blade from narrowing, and are compliant where one piece with the blade."""

from collections.abc import Callable
from itertools import product
from math import hypot, inf
from typing import ClassVar, Generic, TypeVar

from flexcli.formulas import clamps
from flexcli.numerics.rows import design_by_design, isfinite, larger, number, one_by_one, smaller
from flexcli.parts.bending import (
    UNKNOWN,
    Change,
    Changes,
    CompliantClamps,
    FilletedRoots,
    MovedAcross,
    whole,
)
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting
from flexcli.parts.effects.plate import wide_of
from flexcli.parts.geometries import Geometry, Sizes

__all__ = ["ClampCompliance", "ClampStress", "RootRadius", "clamps_of"]


UNSURE = 0.5
"""Error of a changed shift beyond which the middle of its range is not taken."""

OF_LINEAR, OF_CREST = 1e-6, 1e-4
"""Errors of linear beams of a profile, and of a maximum between two points."""


class ClampStress(ModelEffect):
    """The stress at a clamp beyond the nominal stress, the mean over the face's width.

    It is reported and changes no number: yield and fatigue take the nominal stress. A strength
    measured on clamped blades and stated by their nominal stress includes it; one of free specimens
    does not: von Mises' share for yield, that of σ_x for fatigue.
    """

    name: ClassVar[EffectName] = EffectName.CLAMP_STRESS
    needs: ClassVar[str] = "poisson_ratio"
    is_whole: ClassVar[bool] = True

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return σ_x in the mid-width of the clamp over the nominal stress, less one."""
        wide, blade, nu = wide_of(setting), setting.blade, setting.poisson_bound
        if wide is None or wide.bends is None or blade is None or not setting.largest_travel:
            return None
        h, l, b = (number(size) for size in blade)
        if b < 3.0 * h:
            return None
        first, second = wide.bends
        pure, bent = abs(first + second), abs(first - second)
        at = {"b": b, "l": l, "poisson_ratio": nu}
        peak = pure * number(clamps.pure_bending_peak(**at))
        peak += bent * number(clamps.s_shape_peak(**at))
        over = peak / (pure + bent) / wide.stress.value
        equivalent = number(clamps.at_clamp(peak=over, poisson_ratio=nu))
        text = (
            f"in mid-width at the clamp σ_x is {over - 1.0:+.0%}, von Mises {equivalent - 1.0:+.0%}"
            " against the nominal stress, which leaves it out"
        )
        return Indicator(over - 1.0, text)

    def changes(self, setting: Setting) -> Changes:
        """Return no changes: it is no part of the nominal stress."""
        return {}


class ClampCompliance(ModelEffect):
    """The compliance of bodies that the blades are cut from, at their roots, beyond any beam model.

    A crossing in which blades are joined, a body of its own, is stiffer than they are. Compliant
    roots lower the stress at a given travel, as far as they surely give way; under loads it may
    rise. What a crossing makes stiffer may relieve of loads as well.
    """

    name: ClassVar[EffectName] = EffectName.CLAMP_COMPLIANCE
    is_whole: ClassVar[bool] = True
    spares_loads: ClassVar[bool] = True

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the largest h/l of a blade, and the error of rigid clamps where none is stated."""
        softened, slender = _CLAMPS.of(setting), setting.slenderness
        if softened is not None:
            text = f"h/l = {softened.ratio:.2g}"
            more = softened.stiffness.value - 1.0
            if more > 0.0 and softened.across is not None:
                text += f"; the solid crossing makes blades {more:.1%} stiffer"
            elif more > 0.0:
                text += f"; they hold blades {more:.1%} stiffer than their beams"
            elif softened.stiffness.high == inf:
                text += "; nobody knows how stiff the solid crossing is"
            return Indicator(softened.ratio, text)
        if slender is None or setting.geometry.with_compliant_clamps() is None:
            return None
        softer = 6.0 * clamps.extra_length(h=slender)
        text = (
            f"h/l = {slender:.2g}; clamps are rigid: cut from one piece with its bodies "
            f"(clamps: monolithic) a blade is up to {softer:.1%} softer"
        )
        return Indicator(slender, text)

    def changes(self, setting: Setting) -> Changes:
        """Return the reduced stiffness, and the ranges of the numbers that follow from it."""
        softened = _CLAMPS.of(setting)
        if softened is None:
            return {}
        found = {"stiffness": _within(*softened.stiffness[:3])}
        if softened.stiffness.other < inf:
            # of what else bends blades
            found["stiffness"] = found["stiffness"]._replace(other=softened.stiffness.other)
        if any(scene.blade_force for scene in setting.scenes):
            found["buckling"] = _within(*softened.buckling[:3])
        if setting.largest_travel:
            least, most = softened.stress
            if any(scene.temperature is not None for scene in setting.scenes):
                least, most = smaller(least, 1.0 / (1.0 + softened.loaded) - 1.0), softened.loaded
            if any(scene.is_loaded for scene in setting.scenes):
                most = larger(most, softened.loaded)
                if softened.across is not None:  # a crossing relieves as much as it adds elsewhere
                    least = smaller(least, 1.0 / (1.0 + softened.loaded) - 1.0)
                if not any(scene.moves for scene in setting.scenes):
                    least = smaller(least, 0.0)
            less, more = one_by_one(_turned, *softened.turned, setting.largest_travel)
            found["stress"] = _between(least + less, most + more)
            if not any(scene.is_loaded for scene in setting.scenes):
                found["stress"] = found["stress"]._replace(other=softened.stiffness.other)
            found["shift"] = (
                _between(*softened.shift)
                if softened.across is None
                else _beside(softened.shift, softened.across, setting.largest_travel)
            )
        elif any(scene.is_loaded for scene in setting.scenes):
            # heat bends blades by motions, of which roots that give way take their part
            heated = any(scene.temperature is not None for scene in setting.scenes)
            relieved = heated or softened.across is not None
            least = 1.0 / (1.0 + softened.loaded) - 1.0 if relieved else 0.0
            found["stress"] = _between(least, softened.loaded)
        if softened.across is not None and setting.material.sheet is not None:
            # a crossing of blades with moduli of their own, which no plane was solved of
            found = {name: _off(change, change.bound) for name, change in found.items()}
        if not setting.sags_along_stroke:
            found["sag"] = Change(None, softened.softest, 0.0, 1)
        return found

    def all_changes(self, setting: Setting) -> dict[str, Change]:
        """Return the changes, and that of a frequency, which follows from the stiffness.

        What else bends blades changes it as that; of what they weigh blade mass has it.
        """
        found, softened = super().all_changes(setting), _CLAMPS.of(setting)
        if softened is not None and softened.stiffness.other < inf:
            half = _within(*(each**0.5 for each in softened.stiffness[:3]))
            found["frequency"] = half._replace(other=softened.stiffness.other)
            if setting.material.sheet is not None and softened.across is not None:
                found["frequency"] = _off(found["frequency"], found["frequency"].bound)
        return found


class RootRadius(ModelEffect):
    """Fillets at the roots, which closed forms leave out.

    Other models have the actual thickness along the blade, and all count the peak of the stress.
    """

    name: ClassVar[EffectName] = EffectName.ROOT_RADIUS

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return r/l of the blades."""
        found = _FILLETED.of(setting)
        return None if found is None else Indicator(found.ratio, f"r/l = {found.ratio:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return the increased stiffness, the stress at a given travel, and their consequences."""
        found = _FILLETED.of(setting)
        if found is None:
            return {}
        changes = {"stiffness": whole(found.stiffness - 1.0, OF_LINEAR)}
        if any(scene.blade_force for scene in setting.scenes):
            more = (1.0 + found.arc) ** -2 - 1.0
            changes["buckling"] = Change(0.0, more, more, 1)
        if setting.largest_travel:
            loaded = any(scene.is_loaded for scene in setting.scenes)
            crest = whole(found.stress - 1.0, OF_CREST + found.off)
            changes["stress"] = UNKNOWN if loaded else crest
            changes["shift"] = _between(*found.shift)
        if not setting.sags_along_stroke:
            changes["sag"] = UNKNOWN
        return changes


Found = TypeVar("Found")


class _Last(Generic[Found]):
    """The last changes asked for, kept because every number of a design needs the same."""

    def __init__(self, name: str, find: Callable[[Geometry, Sizes, float], Found | None]) -> None:
        self.name, self.find = name, find
        self.asked: tuple[Geometry, Sizes, float] | None = None
        self.found: Found | None = None

    def of(self, setting: Setting) -> Found | None:
        """Return those of a setting, for ν = ½ where it is not given."""
        geometry, sizes, nu = setting.geometry, setting.sizes, setting.poisson_bound
        last = self.asked
        if last is None or last[0] is not geometry or last[1:] != (sizes, nu):
            self.found = design_by_design(
                self.find, geometry, sizes, nu, name=self.name, about=geometry.name
            )
            self.asked = geometry, sizes, nu
        return self.found


_CLAMPS: _Last[CompliantClamps] = _Last(
    "clamps", lambda geometry, sizes, nu: geometry.compliant_clamps(sizes, nu)
)
_FILLETED: _Last[FilletedRoots] = _Last(
    "fillets", lambda geometry, sizes, nu: geometry.filleted(sizes, nu)
)


def clamps_of(setting: Setting) -> CompliantClamps | None:
    """Return what clamps that are not rigid change of a design, for ν = ½ where not given."""
    return _CLAMPS.of(setting)


def _turned(
    least: float, most: float, grows: float, farthest: float, travel: float
) -> tuple[float, float]:
    """Return what a travel adds to the change of a stress, which nobody knows beyond the farthest.

    A stress is never less than none.
    """
    if travel > farthest:
        return -1.0, inf
    return least * travel, (most + grows * travel**2) * travel


def _beside(change: tuple[float, float], across: MovedAcross, travel: float) -> Change:
    """Return the change of a shift, of which a part is of first order in the travel and across.

    ``change`` is the range of that of the rest.
    """
    value, bound, error, other = one_by_one(
        _with_across, *change, *across.beams, *across.solid, *across.along, across.farthest, travel
    )
    return Change(value, bound, error, other=other)


def _with_across(
    low: float,
    high: float,
    least_beams: float,
    most_beams: float,
    least_solid: float,
    most_solid: float,
    least_along: float,
    most_along: float,
    farthest: float,
    travel: float,
) -> tuple[float, float, float, float]:
    """Return the value, bound and error of the change, and the error for other shapes.

    What moves the centre across the bisector is at right angles to what moves it along.
    """
    sides = sorted((abs(least_solid), abs(most_solid)))
    if least_solid <= 0.0 <= most_solid:
        sides[0] = 0.0
    ends, other, known = [], 0.0, isfinite(high - low)
    for along, beams in product((least_along, most_along), (least_beams, most_beams)):
        plain = hypot(along * travel, beams)
        if plain == 0.0:
            return 0.0, inf, inf, inf
        moved = [abs(1.0 + low) * along, abs(1.0 + high) * along] if known else [0.0, farthest]
        if low <= -1.0 <= high:
            moved[0] = 0.0
        least, most = min(moved) * travel, max(moved) * travel
        ends += [hypot(least, sides[0]) / plain, hypot(most, sides[1]) / plain]
        # what else bends blades changes that along the bisector
        share = most**2 / (most**2 + sides[0] ** 2) if most else 0.0
        other = max(other, share * (max(abs(low), abs(high)) if known else 1.0))
    least, most = min(ends), max(ends)
    if most - least > UNSURE * (least + most):
        off = max(1.0 - least, most - 1.0)
        return 0.0, off, off, inf
    middle = (least + most) / 2.0
    return middle - 1.0, max(1.0 - least, most - 1.0), (most - least) / 2.0 / middle, other


def _off(change: Change, more: float) -> Change:
    """Return a change that is off by more."""
    return change._replace(bound=change.bound + more, error=change.error + more)


def _within(value: float, low: float, high: float) -> Change:
    """Return the change to a factor known as a range, of which the value may be the least."""
    if value == low:
        return Change(value - 1.0, high - 1.0, high / value - 1.0, 1)
    error = larger(high - value, value - low) / value
    return Change(value - 1.0, larger(1.0 - low, high - 1.0), error)


def _between(low: float, high: float) -> Change:
    """Return a change known as a range; with a value of zero where the range includes it."""
    if low <= 0.0 <= high:
        size = larger(-low, high)
        return Change(0.0, size, size, -1 if high == 0.0 else 1 if low == 0.0 else 0)
    return _within(1.0 + (low + high) / 2.0, 1.0 + low, 1.0 + high)
