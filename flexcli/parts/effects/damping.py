"""Damping of the mechanism's own motion."""

from typing import ClassVar

from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, SceneEffect, Setting

__all__ = ["DampedMotion"]


class DampedMotion(SceneEffect):
    """On where the mechanism states it."""

    name: ClassVar[EffectName] = EffectName.DAMPING

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the damping ratio 1/(2Q)."""
        given = setting.mechanism.damping if setting.mechanism is not None else None
        if given is None:
            return None
        ratio = 1.0 / (2.0 * given.quality)
        return Indicator(ratio, f"1/(2Q) = {ratio:.2g}")
