"""Blade mass: the blades move with what they carry and lower its frequency."""

from typing import ClassVar

from flexcli.formulas.blade_mass import CANTILEVER, GUIDED, MOMENT, frequency_change, pivot_inertia
from flexcli.parts.bending import Changes, whole
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting
from flexcli.parts.geometries.blades import BladeGeometry
from flexcli.parts.geometries.pivots import BladePivot
from flexcli.parts.geometries.single_blade import Cantilever, MomentBlade
from flexcli.parts.mechanisms.payload import Payload

__all__ = ["BladeMass"]


class BladeMass(ModelEffect):
    """Rayleigh's share of the mass of the blades, beside that of a payload."""

    name: ClassVar[str] = "blade mass"
    needs: ClassVar[str] = "density"

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return what the blades add over what moves, as a ratio of masses or inertias."""
        geometry = setting.geometry
        if not isinstance(setting.mechanism, Payload) or not isinstance(geometry, BladeGeometry):
            return None
        if setting.material.density is None:
            return Indicator(0.0, "unknown without the density")
        ratio = _ratio(setting, setting.mechanism, geometry)
        return None if ratio is None else Indicator(ratio, f"blades/payload = {ratio:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return 1/√(1 + r) − 1."""
        found = self.indicator(setting)
        if found is None:
            return {}
        return {"frequency": whole(frequency_change(found.value))}


def _ratio(setting: Setting, payload: Payload, geometry: BladeGeometry) -> float | None:
    assert setting.material.density is not None  # asked by those who know
    count, l = geometry.blade_count, float(setting.sizes.l)
    m_b = setting.material.density.value * float(geometry.volume(setting.sizes)) / count
    if geometry.motion == "translation":
        share = CANTILEVER if isinstance(geometry, Cantilever) else GUIDED
        return share * count * m_b / payload.mass
    if not payload.inertia:
        return None
    if isinstance(geometry, MomentBlade):
        return MOMENT * m_b * l**2 / payload.inertia
    assert isinstance(geometry, BladePivot)  # the other kind that turns
    p = float(geometry.offset(setting.sizes))
    return float(pivot_inertia(m_b=m_b, l=l, p=p, blades=count)) / payload.inertia
