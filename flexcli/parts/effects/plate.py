"""Plate widening: a wide blade cannot curve across its width and is stiffer than a beam."""

from flexcli.parts.effects.base import Effect, Setting
from flexcli.results import EffectRow

__all__ = ["PlateWidening"]


class PlateWidening(Effect):
    """Between a beam (E) and a plate (E/(1 − ν²)): the plate is the upper bound."""

    name = "plate widening"

    def row(self, setting: Setting) -> EffectRow | None:
        """Return the bound ν²/(1 − ν²) for blades wider than thick."""
        if setting.blade is None:
            return None
        ratio = setting.blade.b / setting.blade.h
        if ratio <= 1.0:
            return None
        nu = setting.poisson_bound
        bound = nu**2 / (1.0 - nu**2)
        known = "" if setting.material.poisson_ratio else " for ν = ½, as the material gives no ν"
        return EffectRow(
            self.name,
            False,
            ratio,
            bound,
            f"b/h = {ratio:.3g}; stiffness at most so much higher{known}",
        )
