"""Axial load: a force along the blades stiffens or softens their bending."""

from flexcli.formulas.buckling import euler_load
from flexcli.formulas.section import second_moment
from flexcli.parts.effects.base import Effect, Setting
from flexcli.results import EffectRow

__all__ = ["AxialLoad"]


class AxialLoad(Effect):
    """Where a case both bends and loads the blades, stiffness changes by about N/N_cr."""

    name = "axial load"

    def row(self, setting: Setting) -> EffectRow | None:
        """Return the largest N/N_cr (clamped–guided) of the cases that bend under load."""
        loads = [s.blade_force for s in setting.scenes if s.travel and s.blade_force]
        if not loads:
            return None
        h, l, b = setting.blade
        inertia = min(second_moment(b, h), second_moment(h, b))
        critical = euler_load(E=setting.material.E, I=inertia, l=l, ends="clamped-guided")
        ratio = max(loads) / critical
        return EffectRow(
            self.name, False, ratio, ratio, f"N/N_cr = {ratio:.2g}; bending stiffness changes by it"
        )
