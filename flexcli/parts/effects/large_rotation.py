"""Large rotation of the blades."""

from typing import ClassVar

from flexcli.parts.bending import Changes
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting

__all__ = ["LargeRotation"]


class LargeRotation(ModelEffect):
    """The closed forms are of first order in the travel; the stiffness is stated at rest."""

    name: ClassVar[EffectName] = EffectName.LARGE_ROTATION
    grows_with_travel: ClassVar[bool] = True
    cost: ClassVar[float] = 3.0

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return θ, or the stroke over the length."""
        travel = setting.largest_travel
        turns = setting.geometry.motion == "rotation"
        if travel == 0.0 and setting.geometry.strain != "twist":
            return None  # of twisted bars even the stiffness at rest has an error
        angle = travel if turns else travel / setting.geometry.length(setting.sizes)
        return Indicator(angle, f"{'θ' if turns else 'stroke/l'} = {angle:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return the terms of next order of stress and shift."""
        return setting.bending.rotation()
