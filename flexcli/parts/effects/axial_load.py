"""Axial load: a force along the blades stiffens or softens their bending."""

from collections.abc import Sequence
from math import inf
from typing import ClassVar

from flexcli.formulas.section import second_moment
from flexcli.parts.bending import Change, Changes
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting
from flexcli.parts.scene import Scene

__all__ = ["AxialLoad", "largest_load", "load_number"]


class AxialLoad(ModelEffect):
    """Where a case both bends and loads the blades; the stiffness is stated without load."""

    name: ClassVar[str] = "axial load"

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the largest N l²/(E I) of the cases that load the blades."""
        n = load_number(setting, setting.scenes)
        return Indicator(n, f"N l²/EI = {n:.2g}") if n else None

    def changes(self, setting: Setting) -> Changes:
        """Return how far the end moments at a given travel change, the load either way.

        Where a load makes the travel itself, the other changes that too: nobody knows how far.
        """
        bending, n = setting.bending, largest_load(setting)
        if bending is None:
            return {}
        if any(s.push and s.blade_force for s in setting.scenes):
            return {"stress": Change(None, inf)}
        if n:
            return {name: Change(None, found.bound) for name, found in bending.load(n).items()}
        still = [s for s in setting.scenes if s.blade_force and not s.bends]
        return bending.amplified(load_number(setting, still)) if still else {}


def largest_load(setting: Setting) -> float:
    """Return the largest N l²/(E I) in a blade of the cases that also bend it [-]."""
    return load_number(setting, [s for s in setting.scenes if s.bends])


def load_number(setting: Setting, scenes: Sequence[Scene]) -> float:
    """Return the largest N l²/(E I) in a blade of some cases [-]."""
    loads = [s.blade_force for s in scenes if s.blade_force]
    if not loads or setting.blade is None:
        return 0.0
    h, l, b = setting.blade
    return float(max(loads) * l**2 / (setting.material.elastic.E * second_moment(b, h)))
