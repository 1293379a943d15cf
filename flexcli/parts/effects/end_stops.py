"""End stops beside the blade."""

from typing import ClassVar

from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, SceneEffect, Setting

__all__ = ["EndStops"]


class EndStops(SceneEffect):
    """On where the design has stops."""

    name: ClassVar[EffectName] = EffectName.END_STOPS
    shuts_out: ClassVar[frozenset[EffectName]] = frozenset(
        {EffectName.LARGE_ROTATION, EffectName.AXIAL_LOAD}
    )
    """The blade between stops moves in the modes of small motion."""

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the travel that the stops allow over the length of the blade."""
        if setting.stops is None or setting.blade is None:
            return None
        if setting.stops.travel is None:
            return Indicator(0.0, "as far as the bending allows")
        share = setting.stops.travel / float(setting.blade.l)
        return Indicator(share, f"travel/l = {share:.2g}")
