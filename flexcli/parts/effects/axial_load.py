"""Axial load: a force along the blades stiffens or softens their bending."""

from typing import ClassVar

from flexcli.formulas.section import second_moment
from flexcli.parts.bending import Change, Changes
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting

__all__ = ["AxialLoad", "largest_load"]


class AxialLoad(ModelEffect):
    """Where a case both bends and loads the blades; the stiffness is stated without load."""

    name: ClassVar[str] = "axial load"

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the largest N l²/(E I) of the cases that bend under load."""
        n = largest_load(setting)
        return Indicator(n, f"N l²/EI = {n:.2g}") if n else None

    def changes(self, setting: Setting) -> Changes:
        """Return how far the end moments at a given travel change, the load either way."""
        bending, n = setting.bending, largest_load(setting)
        if not n or bending is None:
            return {}
        return {name: Change(None, found.bound) for name, found in bending.load(n).items()}


def largest_load(setting: Setting) -> float:
    """Return the largest N l²/(E I) in a blade of the cases that also bend it [-]."""
    loads = [s.blade_force for s in setting.scenes if s.bends and s.blade_force]
    if not loads or setting.blade is None:
        return 0.0
    h, l, b = setting.blade
    return float(max(loads) * l**2 / (setting.material.elastic.E * second_moment(b, h)))
