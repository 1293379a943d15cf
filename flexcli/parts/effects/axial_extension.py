"""Axial extension: blades stretch under the forces that their bending makes."""

from math import pi
from typing import ClassVar

from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.parts.bending import Bending, Change, Changes, whole
from flexcli.parts.effects.axial_load import largest_load, load_number
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting

__all__ = ["AxialExtension"]


class AxialExtension(ModelEffect):
    """Compliance l/EA beside that of bending, (h/l)² times it."""

    name: ClassVar[str] = "axial extension"

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return (h/l)²."""
        if setting.blade is None:
            return None
        square = float(setting.blade.h / setting.blade.l) ** 2
        return Indicator(square, f"(h/l)² = {square:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return what stretching softens and shifts; it raises a critical load by ε = P/EA."""
        blade, bending = setting.blade, setting.bending
        if blade is None or bending is None:
            return {}
        found = dict(bending.extension())
        for name, more in bending.stretched(largest_load(setting)).items():
            first = found.get(name, whole(0.0))
            both = None
            if more.value is not None and first.value is not None:
                both = first.value + more.value
            found[name] = Change(both, first.bound + more.bound, first.error + more.error)
        for name, more in self._pulled(setting, bending).items():
            first = found.get(name, whole(0.0))
            sign = more.sign if first.bound == 0.0 else 0
            found[name] = Change(None, first.bound + more.bound, first.error, sign)
        held = [s.ends for s in setting.scenes if s.blade_force and s.ends]
        if held:
            reach = min(EFFECTIVE_LENGTH[ends] for ends in held) * blade.l
            found["buckling"] = whole(pi**2 * (blade.h / reach) ** 2 / 12.0)
        return found

    def _pulled(self, setting: Setting, bending: Bending) -> Changes:
        """Return what the bending adds in cases in which forces alone act."""
        still = [s for s in setting.scenes if s.blade_force and not s.bends]
        return bending.pulled(load_number(setting, still)) if still else {}
