"""Hinge length: a notch bends over a length of its own, not in a point."""

from typing import ClassVar

from flexcli.parts.bending import Changes
from flexcli.parts.bending.limbs import LimbPivot, LimbStage
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting

__all__ = ["HingeLength"]


class HingeLength(ModelEffect):
    """The closed forms of limbs take their hinges as pins with springs."""

    name: ClassVar[str] = "hinge length"

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return how far a hinge bends about its centre, over the limb."""
        bending = setting.bending
        if not isinstance(bending, LimbPivot | LimbStage):
            return None
        return Indicator(bending.hinge.reach, f"c/l = {bending.hinge.reach:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return what hinges of a length do to stress and shift."""
        bending = setting.bending
        return bending.hinge_length() if isinstance(bending, LimbPivot | LimbStage) else {}
