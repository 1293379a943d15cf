"""Clamp stress: the clamps keep a blade from narrowing, which raises the stress in mid-width."""

from typing import ClassVar

from flexcli.formulas import clamp_stress
from flexcli.parts.bending import Changes
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting
from flexcli.parts.effects.plate import wide_of

__all__ = ["ClampStress"]


class ClampStress(ModelEffect):
    """What the nominal stress, the mean over the width of the face, leaves out at a clamp.

    It is told and changes no number: yield and fatigue take the nominal stress. A strength that
    was measured on clamped blades and stated by their nominal stress has it already; one of free
    specimens has not: von Mises' share for yield, that of σ_x for fatigue.
    """

    name: ClassVar[EffectName] = EffectName.CLAMP_STRESS
    needs: ClassVar[str] = "poisson_ratio"
    is_whole: ClassVar[bool] = True

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return σ_x in the mid-width of the clamp over the nominal stress, less one."""
        wide, blade, nu = wide_of(setting), setting.blade, setting.poisson_bound
        if wide is None or wide.bends is None or blade is None or not setting.largest_travel:
            return None
        h, l, b = (float(size) for size in blade)
        if b < 3.0 * h:
            return None
        first, second = wide.bends
        pure, bent = abs(first + second), abs(first - second)
        at = {"b": b, "l": l, "poisson_ratio": nu}
        peak = pure * float(clamp_stress.pure_bending_peak(**at))
        peak += bent * float(clamp_stress.s_shape_peak(**at))
        over = peak / (pure + bent) / wide.stress.value
        equivalent = float(clamp_stress.at_clamp(peak=over, poisson_ratio=nu))
        text = (
            f"in mid-width at the clamp σ_x is {over - 1.0:+.0%}, von Mises {equivalent - 1.0:+.0%}"
            " against the nominal stress, which leaves it out"
        )
        return Indicator(over - 1.0, text)

    def changes(self, setting: Setting) -> Changes:
        """Return nothing: it is no part of the nominal stress."""
        return {}
