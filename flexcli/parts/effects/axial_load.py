"""Axial load: a force along the blades stiffens or softens their bending."""

from collections.abc import Sequence
from math import inf, pi
from typing import ClassVar

from flexcli.formulas.section import second_moment
from flexcli.numerics.rows import cos, isfinite, larger, number
from flexcli.parts.bending import UNKNOWN, Change, Changes, together, whole
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting
from flexcli.parts.scene import Scene

__all__ = ["AxialLoad", "largest_load", "load_number"]


class AxialLoad(ModelEffect):
    """Where a case loads the blades; the stiffness is stated without load."""

    name: ClassVar[EffectName] = EffectName.AXIAL_LOAD

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the largest N l²/(E I) of the cases that load the blades."""
        n = load_number(setting, setting.scenes)
        known = f"N l²/EI = {n:.2g}" if isfinite(n) else "a force on blades that differ"
        return Indicator(n, known) if n else None

    def changes(self, setting: Setting) -> Changes:
        """Return the change of the end moments at a given travel by an axial load of either sign.

        Where a load causes the travel itself, the change is unknown.
        """
        bending, n = setting.bending, largest_load(setting)
        if any(s.push and s.blade_force for s in setting.scenes):
            return {"stress": UNKNOWN}
        found = dict(bending.load(n)) if n else {}
        stress = found.get("stress")
        if stress is not None and stress.value is not None and _pushes(setting):
            # compression relieves the moments by less than n/(π² − n), guided or free to turn
            relief = number(n / (pi**2 - n)) if n < pi**2 else inf
            found["stress"] = Change(0.0, relief, stress.error + larger(relief, stress.value))
        still = [s for s in setting.scenes if s.blade_force and not s.bends]
        if still:
            for name, more in bending.amplified(load_number(setting, still)).items():
                found[name] = together(found.get(name, whole(0.0)), more)
        return found


def _pushes(setting: Setting) -> bool:
    """Return whether a case that bends the blades states a force that pushes along x."""
    return any(
        scene.directed and any(cos(direction) < 0.0 for force, direction in scene.forces if force)
        for scene in setting.scenes
        if scene.bends
    )


def largest_load(setting: Setting) -> float:
    """Return the largest N l²/(E I) in a blade of the cases that also bend it [-]."""
    return load_number(setting, [s for s in setting.scenes if s.bends])


def load_number(setting: Setting, scenes: Sequence[Scene]) -> float:
    """Return the largest N l²/(E I) in a blade of some cases [-].

    It is infinite where the joint has no single kind of blade.
    """
    loads = [s.blade_force for s in scenes if s.blade_force]
    if not loads:
        return 0.0
    if setting.blade is None:
        return inf
    h, l, b = setting.blade
    return number(larger(loads) * l**2 / (setting.material.elastic.E * second_moment(b, h)))
