"""Shear deformation of the blades."""

from typing import ClassVar

from flexcli.formulas.blade_shear import buckling_change
from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.section import shear_parameter
from flexcli.parts.bending import Change, Changes, whole
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting

__all__ = ["Shear"]


class Shear(ModelEffect):
    """Timoshenko's shear parameter Φ lowers a clamped–guided stiffness by Φ/(1 + Φ)."""

    name: ClassVar[str] = "shear"
    needs: ClassVar[str] = "poisson_ratio"

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return Φ of the blade in its plane."""
        if setting.blade is None:
            return None
        phi = _in_plane(setting)
        return Indicator(phi, f"Φ = {phi:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return the softer bending in the plane, and across it where the sag bends the width."""
        blade, bending = setting.blade, setting.bending
        if blade is None or bending is None:
            return {}
        phi = _in_plane(setting)
        found = dict(bending.shear(phi))
        held = [s.ends for s in setting.scenes if s.blade_force and s.ends]
        if held:
            worst = min(EFFECTIVE_LENGTH[ends] for ends in held)
            found["buckling"] = whole(buckling_change(Phi=phi, effective_length=worst))
        if setting.geometry.sag_bends_width:
            nu = setting.poisson_bound
            found["sag"] = Change(None, shear_parameter(depth=blade.b, l=blade.l, poisson_ratio=nu))
        return found


def _in_plane(setting: Setting) -> float:
    assert setting.blade is not None  # asked by those who know
    h, l, _ = setting.blade
    return float(shear_parameter(depth=h, l=l, poisson_ratio=setting.poisson_bound))
