"""Plate widening: a wide blade cannot curve across its width and is stiffer than a beam."""

from typing import ClassVar

from flexcli.formulas.plate_widening import bound, flat_width, rigidity_change
from flexcli.parts.bending import Change, Changes
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting

__all__ = ["PlateWidening"]


class PlateWidening(ModelEffect):
    """Between a beam (E) and a plate (E/(1 − ν²)), on top of what any model says.

    At the least, the blade curls as its curvature lets it (Ashwell 1950); clamps keep it flat
    over about its own width at either end (Saint-Venant), which makes the most. The correction
    takes the middle of both.
    """

    name: ClassVar[str] = "plate widening"
    needs: ClassVar[str] = "poisson_ratio"
    is_whole: ClassVar[bool] = True

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return b/h."""
        if setting.blade is None:
            return None
        ratio = float(setting.blade.b / setting.blade.h)
        return Indicator(ratio, f"b/h = {ratio:.3g}")

    def changes(self, setting: Setting) -> Changes:
        """Return the change at rest, and that of the stress at the curvature of the stroke."""
        if setting.blade is None:
            return {}
        found = {"stiffness": _between(setting, 0.0)}
        if any(scene.blade_force for scene in setting.scenes):
            found["buckling"] = found["stiffness"]
        if setting.largest_travel:
            found["stress"] = _between(setting, setting.largest_travel)
        return found


def _between(setting: Setting, travel: float) -> Change:
    assert setting.blade is not None  # asked by those who know
    h, l, b = (float(size) for size in setting.blade)
    elastic, nu = setting.material.elastic, setting.poisson_bound
    curls = 0.0
    if travel:
        stresses = setting.geometry.end_stresses(elastic, setting.sizes, travel)
        curvature = 2.0 * max(abs(float(s)) for s in stresses.values()) / (elastic.E * h)
        beta = flat_width(b=b, h=h, curvature=curvature, poisson_ratio=nu)
        curls = float(rigidity_change(beta=beta, poisson_ratio=nu))
    most = min(bound(nu), curls + bound(nu) * 2.0 * b / l)
    return Change((curls + most) / 2.0, most, (most - curls) / 2.0)
