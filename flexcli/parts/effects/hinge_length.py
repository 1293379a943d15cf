"""Hinge length: a notch bends over a length of its own, not in a point."""

from typing import ClassVar

from flexcli.parts.bending import Changes
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting

__all__ = ["HingeLength"]


class HingeLength(ModelEffect):
    """The closed forms of limbs take their hinges as pins with springs."""

    name: ClassVar[EffectName] = EffectName.HINGE_LENGTH

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return how far a hinge bends about its centre, over the limb."""
        reach = setting.bending.hinge_reach
        return None if reach is None else Indicator(reach, f"c/l = {reach:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return what hinges of a length do to stress and shift."""
        return setting.bending.hinge_length()
