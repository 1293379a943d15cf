"""Shock: a pulse or a response spectrum of the base."""

from typing import ClassVar

from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, SceneEffect, Setting
from flexcli.units import STANDARD_GRAVITY

__all__ = ["ShockLoad"]


class ShockLoad(SceneEffect):
    """On where a case has a shock."""

    name: ClassVar[EffectName] = EffectName.SHOCK
    excludes: ClassVar[tuple[str, ...]] = ("shock",)

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the worst acceleration of the shock [g], 0 where it is not known beforehand."""
        shocks = [s.shock for s in setting.scenes if s.shock is not None]
        if not shocks:
            return None
        most = max(shock.worst_acceleration() or 0.0 for shock in shocks) / STANDARD_GRAVITY
        return Indicator(most, f"{most:.3g} g" if most else "by the response of its modes")
