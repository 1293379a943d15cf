"""Gravity and steady acceleration: the weight of what the joint carries."""

from typing import ClassVar

from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, SceneEffect, Setting
from flexcli.units import STANDARD_GRAVITY

__all__ = ["Gravity"]


class Gravity(SceneEffect):
    """On where a case has an acceleration."""

    name: ClassVar[EffectName] = EffectName.GRAVITY
    excludes: ClassVar[tuple[str, ...]] = ("acceleration",)

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the largest acceleration [g]."""
        most = max((s.acceleration for s in setting.scenes), default=0.0) / STANDARD_GRAVITY
        return Indicator(most, f"{most:.3g} g") if most else None
