"""Axial load: a force along the blades stiffens or softens their bending."""

from flexcli.parts.effects.base import Effect, Setting
from flexcli.results import EffectRow

__all__ = ["AxialLoad"]


class AxialLoad(Effect):
    """Where a case both bends and loads the blades, stiffness changes by about N/N_cr."""

    name = "axial load"

    def row(self, setting: Setting) -> EffectRow | None:
        """Return the largest N/N_cr (clamped–guided) of the cases that bend under load."""
        loads = [s.blade_force for s in setting.scenes if s.travel and s.blade_force]
        if not loads or setting.blade is None:
            return None
        elastic, sizes = setting.material.elastic, setting.sizes
        critical = min(
            float(c.force) for c in setting.geometry.critical(elastic, sizes, "clamped-guided")
        )
        ratio = max(loads) / critical
        return EffectRow(
            self.name, False, ratio, ratio, f"N/N_cr = {ratio:.2g}; bending stiffness changes by it"
        )
