"""Axial extension: blades stretch under the forces that their bending makes."""

from math import pi
from typing import ClassVar

from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.parts.bending import Changes, together, whole
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.axial_load import largest_load, load_number
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting

__all__ = ["AxialExtension"]


class AxialExtension(ModelEffect):
    """Compliance l/EA beside that of bending, (h/l)² times it."""

    name: ClassVar[EffectName] = EffectName.AXIAL_EXTENSION
    grows_with_travel: ClassVar[bool] = True

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return (h/l)²."""
        slender = setting.slenderness
        if slender is None:
            return None
        square = slender**2
        return Indicator(square, f"(h/l)² = {square:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return the changes by stretching; it raises a critical load by ε = P/EA."""
        blade, bending = setting.blade, setting.bending
        found = dict(bending.extension())
        for name, more in bending.stretched(largest_load(setting), _direction(setting)).items():
            found[name] = together(found.get(name, whole(0.0)), more)
        still = [s for s in setting.scenes if s.blade_force and not s.bends]
        if still:
            for name, more in bending.pulled(load_number(setting, still)).items():
                found[name] = together(found.get(name, whole(0.0)), more)
        held = [s.ends for s in setting.scenes if s.blade_force and s.ends]
        if held and blade is not None:
            reach = min(EFFECTIVE_LENGTH[ends] for ends in held) * blade.l
            found["buckling"] = whole(pi**2 * (blade.h / reach) ** 2 / 12.0)
        return found


def _direction(setting: Setting) -> float | None:
    """Return the direction of the forces of all cases that bend under load, where they have one."""
    found = {direction for s in setting.scenes if s.bends for force, direction in s.forces if force}
    return found.pop() if len(found) == 1 else None
