"""Random vibration of the base."""

from typing import ClassVar

from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, SceneEffect, Setting

__all__ = ["RandomVibration"]


class RandomVibration(SceneEffect):
    """On where a case has an acceleration density."""

    name: ClassVar[EffectName] = EffectName.RANDOM_VIBRATION
    excludes: ClassVar[tuple[str, ...]] = ("asd", "axes")

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the largest Q at which the base shakes the joint."""
        found = [s.vibration.q.largest for s in setting.scenes if s.vibration is not None]
        return Indicator(max(found), f"Q = {max(found):.3g}") if found else None
