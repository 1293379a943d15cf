"""Blade tension: the stroke of a pivot pulls one blade and pushes the other."""

from typing import ClassVar

from flexcli.parts.bending import Changes
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting

__all__ = ["BladeTension"]


class BladeTension(ModelEffect):
    """Axial stress beside the bending stress, of first order in h/l."""

    name: ClassVar[EffectName] = EffectName.BLADE_TENSION
    grows_with_travel: ClassVar[bool] = True

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return h/l of a pivot that turns."""
        slender = setting.slenderness
        if slender is None or setting.geometry.motion != "rotation":
            return None
        if not setting.largest_travel:
            return None
        return Indicator(slender, f"h/l = {slender:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return the axial stress relative to that of the bending."""
        return setting.bending.tension()
