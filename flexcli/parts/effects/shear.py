"""Shear deformation of the blades."""

from flexcli.formulas.section import shear_parameter
from flexcli.parts.effects.base import Effect, Setting
from flexcli.results import EffectRow

__all__ = ["Shear"]


class Shear(Effect):
    """Timoshenko's shear parameter Φ lowers a clamped–guided stiffness by Φ/(1 + Φ)."""

    name = "shear"

    def row(self, setting: Setting) -> EffectRow | None:
        """Return the softer stiffness in the plane, or out of it where a sag is reported."""
        blade, nu = setting.blade, setting.poisson_bound
        if blade is None:
            return None
        phi = shear_parameter(depth=blade.h, l=blade.l, poisson_ratio=nu)
        share = setting.geometry.s_bending_share(blade)
        estimate, what = share * phi / (1.0 + phi), "stiffness"
        if setting.hangs and setting.geometry.sag_bends_width:
            phi = shear_parameter(depth=blade.b, l=blade.l, poisson_ratio=nu)
            estimate, what = phi / (1.0 + phi), "stiffness against the sag"
        return EffectRow(
            self.name, False, phi, estimate, f"Φ = {phi:.2g}; {what} is that much lower"
        )
