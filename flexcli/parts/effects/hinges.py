"""Notch hinges: they bend over a finite length, and are softer as plane bodies than as beams."""

from math import inf
from typing import ClassVar

from flexcli.numerics.rows import larger
from flexcli.parts.bending import UNKNOWN, Change, Changes, Factor, Thick
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting

__all__ = ["HingeLength", "ThickNotch"]

BESIDE_WIDENING = 0.1
"""Of what is softer, how far off it may be besides in a notch that is kept wide: in plane strain a
notch is as much softer as in plane stress. Of CalculiX's solids of 37 notches between blocks (e/r
from 0.12 to 0.8, b/e 1.6 to 50, ν 0.3 to 0.45, blocks of 0.2 to 1.5 times the height of the mouth)
seven were beyond the errors of both, by 0.043 of it at most; of those clamped at the mouth none."""


class HingeLength(ModelEffect):
    """The length of hinges, which the closed forms of limbs take as pins with springs."""

    name: ClassVar[EffectName] = EffectName.HINGE_LENGTH

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return how far a hinge bends about its centre, over the limb."""
        reach = setting.bending.hinge_reach
        return None if reach is None else Indicator(reach, f"c/l = {reach:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return the changes of stress and shift by the length of the hinges."""
        return setting.bending.hinge_length()


class ThickNotch(ModelEffect):
    """The compliance of a notch's curved faces and of the blocks beside it, beyond any beam model.

    At a given rotation the stress of the throat is reduced as much: its moment is the hinge's, and
    the peak over the nominal stress is the deep notch's for any e/r. Under a load the moment may be
    the load's own, and nothing of that counts.
    """

    name: ClassVar[EffectName] = EffectName.THICK_NOTCH
    is_whole: ClassVar[bool] = True

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the largest throat over the radius of its notch."""
        thick = setting.geometry.thick_notches(setting.sizes)
        return None if thick is None else Indicator(thick.ratio, f"e/r = {thick.ratio:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return the reduced stiffness, the stress of the stroke, and what may follow from them."""
        thick = setting.geometry.thick_notches(setting.sizes)
        if thick is None:
            return {}
        ends = {scene.ends for scene in setting.scenes if scene.blade_force}
        if thick.factor is None:
            names = ("stiffness", "stress", "shift", *(("buckling",) if ends else ()))
            return dict.fromkeys(names, UNKNOWN)
        value, most, error = _of_factor(thick.factor)
        found = {"stiffness": Change(value, most, error, other=BESIDE_WIDENING * most)}
        under_loads = _of_factor(thick.loaded or thick.factor)
        if ends and ends.issubset(thick.bowing):
            found["buckling"] = _of_bowed(thick.factor, thick.bowed)
        elif ends:  # limbs that sway buckle by their hinges' stiffness, others more or less so
            value, most, error = under_loads
            unlike = 0.0 if ends.issubset(thick.swaying) else -value
            found["buckling"] = Change(value, most, error + unlike)
        if setting.largest_travel:
            loaded = any(scene.is_loaded for scene in setting.scenes)
            value, most, error = _of_factor(thick.stress or thick.factor)
            most = larger(most, under_loads[1])
            found["stress"] = Change(0.0, most, most, -1) if loaded else Change(value, most, error)
            found["shift"] = _of_shift(thick, setting.largest_travel)
        return found


def _of_factor(factor: Factor) -> tuple[float, float, float]:
    """Return the change that a factor makes, its largest, and its error."""
    value, low, high, _ = factor
    return value - 1.0, max(1.0 - low, high - 1.0), max(high - value, value - low) / value


def _of_bowed(factor: Factor, bowed: float) -> Change:
    """Return the change of what buckles a hinge whose ends bear no moment.

    It bears the more moment the nearer to its middle a section is, and what makes it softer grows
    towards its ends: it loses less than where it bears the same moment all along, its stiffness
    (Chebyshev's inequality of Timoshenko's quotient ``∫w²/EI / ∫w'²``), and more than its faces
    lose by a moment that falls evenly.
    """
    low, high = factor.low, larger(factor.high, bowed)
    value, most, error = _of_factor(Factor((low + high) / 2.0, low, high))
    return Change(value, most, error)


def _of_shift(thick: Thick, travel: float) -> Change:
    """Return the change of a shift: the rotation is distributed differently along its hinges.

    What the centre moves aside, in proportion to the travel, is a part of its own.
    """
    (low, high), (first, least, greatest) = thick.shift, thick.first
    if first != 0.0:
        aside, low = (first / travel) ** 2, larger(low, 0.0)
        low, high = (
            ((one**2 + aside * other**2) / (1.0 + aside)) ** 0.5
            for one, other in ((low, least), (high, greatest))
        )
    most = larger(1.0 - low, high - 1.0)
    if thick.path != 1.0:
        return Change(0.0, most * thick.path, most * thick.path)
    middle = (low + high) / 2.0
    return Change(middle - 1.0, most, (high - low) / 2.0 / middle if middle > 0.0 else inf)
