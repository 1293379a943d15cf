"""Thermal expansion: blades and bodies whose growth differs."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from flexcli.errors import SolveError
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, SceneEffect, Setting
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.scene import Scene

if TYPE_CHECKING:
    from flexcli.mechanics.layout import Layout

__all__ = ["Expansion"]


class Expansion(SceneEffect):
    """On where a case has a temperature."""

    name: ClassVar[EffectName] = EffectName.EXPANSION
    excludes: ClassVar[tuple[str, ...]] = ("temperature",)

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the largest difference between the free strains of blades and bodies [-]."""
        warm = [scene for scene in setting.scenes if scene.temperature is not None]
        if not warm:
            return None
        try:
            most = max(_misfit(_warmed(setting, scene)) for scene in warm)
        except NotAvailable:
            return Indicator(1.0, "a temperature on a joint without a layout of blades")
        return Indicator(most, f"free strains differ by {most:.2g}")

    def estimates(self, setting: Setting) -> Mapping[str, float]:
        """Return the stress's change without it over the larger of both, by linear blades."""
        found = 0.0
        for scene in setting.scenes:
            if scene.temperature is None:
                continue
            try:
                layout = _warmed(setting, scene)
                cold = setting.geometry.plane_layout(setting.material.elastic, setting.sizes)
                held = setting.geometry.held(0.0) if scene.moves else None
                strained = _stress(layout, held)
                reach = scene.travel + abs(scene.middle)
                stroke = _stress(cold, setting.geometry.held(reach)) if scene.moves else 0.0
            except (NotAvailable, SolveError):
                return {}
            if strained > 0.0:
                found = max(found, strained / max(strained, stroke))
        return {"stress": found}


def _warmed(setting: Setting, scene: Scene) -> "Layout":
    """Return the joint as grown by the temperature of a case."""
    geometry = setting.geometry
    layout = geometry.plane_layout(setting.material.elastic, setting.sizes)
    assert scene.temperature is not None  # the caller has asked
    return scene.temperature.warmed(layout, setting.material, geometry.axes)


def _misfit(layout: "Layout") -> float:
    strains = (*layout.body_growth.values(), *layout.blade_growth.values())
    return float(max(strains) - min(strains))


def _stress(layout: "Layout", held: object) -> float:
    """Return the largest nominal stress at the ends of the blades by linear beams [Pa]."""
    from flexcli.mechanics.linear import linear

    found = linear(layout, {MOVING: held} if held is not None else {})  # type: ignore[dict-item]
    most = 0.0
    for blade, force in zip(layout.blades, found.end_forces[0], strict=True):
        along = np.subtract(blade.end, blade.start).astype(np.float64)
        l = float(np.hypot(*along))
        N = float(force[:2] @ along) / l
        V = float(force[1] * along[0] - force[0] * along[1]) / l
        u = np.array([-1.0, 1.0])
        h = min(float(np.min(piece.thickness(u))) for piece in blade.profile.pieces(l))
        M = max(abs(force[2]), abs(force[2] + V * l))
        most = max(most, abs(N) / (blade.b * h) + 6.0 * float(M) / (blade.b * h**2))
    return most
