"""Shear deformation of the blades."""

from typing import ClassVar

from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.section import shear_parameter
from flexcli.formulas.thick_blades import buckling_change
from flexcli.numerics.rows import larger, number, smaller
from flexcli.parts.bending import Change, Changes
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting

__all__ = ["Shear"]

PLANE_STRESS = 0.06
"""Stiffness of plane stress over that of Timoshenko's beam at b/l = 1, bent across its width."""


class Shear(ModelEffect):
    """Timoshenko's shear parameter Φ lowers a clamped–guided stiffness by Φ/(1 + Φ).

    Without Poisson's ratio it may be anything from 0 to ½: the middle of both results is taken, and
    half their difference is an error.
    """

    name: ClassVar[EffectName] = EffectName.SHEAR
    needs: ClassVar[str] = "poisson_ratio"
    spans_what_it_needs: ClassVar[bool] = True

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return Φ of the stockiest blade, in its plane."""
        slender = setting.slenderness
        if slender is None:
            return None
        phi = shear_parameter(depth=slender, l=1.0, poisson_ratio=setting.poisson_bound)
        return Indicator(phi, f"Φ = {phi:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return the reduced stiffness in the plane, and across it where sag bends the width."""
        low, high = (_changes(setting, nu) for nu in setting.poisson_ratios)
        return {name: _between(low[name], high[name]) for name in low}


def _changes(setting: Setting, nu: float) -> Changes:
    found = dict(setting.bending.shear(nu))
    blade = setting.blade
    held = [s.ends for s in setting.scenes if s.blade_force and s.ends]
    if held and blade is not None:
        phi = shear_parameter(depth=blade.h, l=blade.l, poisson_ratio=nu)
        k = smaller(EFFECTIVE_LENGTH[ends] for ends in held)
        value = number(buckling_change(Phi=phi, effective_length=k))
        found["buckling"] = Change(value, abs(value), value**2)
    if setting.geometry.sag_bends_width and blade is not None:
        phi = number(shear_parameter(depth=blade.b, l=blade.l, poisson_ratio=nu))
        found["sag"] = Change(phi, phi, PLANE_STRESS * smaller(1.0, number(blade.b / blade.l)))
    return found


def _between(one: Change, other: Change) -> Change:
    """Return the middle of two changes, with half their difference as an error."""
    if one.value is None or other.value is None:
        return one if one.value is None else other
    value = (one.value + other.value) / 2.0
    apart = abs(one.value - other.value) / 2.0 / (1.0 + value)
    return Change(value, larger(one.bound, other.bound), larger(one.error, other.error) + apart)
