"""Blade mass: the blades move with what they carry, lower its frequency and add to its sag."""

from typing import ClassVar

from flexcli.numerics.rows import design_by_design
from flexcli.parts.bending import Changes
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting
from flexcli.results import QuantityKind

__all__ = ["BladeMass"]


class BladeMass(ModelEffect):
    """Effect of the modes of bodies and heavy blades on the frequency of a single freedom.

    The blades' mass counts by the shapes of their vibration, and so do coordinates of the bodies
    beside the driven motion, such as the rotation of a payload with inertia.
    """

    name: ClassVar[EffectName] = EffectName.BLADE_MASS
    needs: ClassVar[str] = "density"
    is_whole: ClassVar[bool] = True
    only: ClassVar[frozenset[QuantityKind]] = frozenset({QuantityKind.FREQUENCY, QuantityKind.SAG})

    def __init__(self) -> None:
        self._last: tuple[Setting, Changes] | None = None

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the change of the frequency, with the blades' mass over the moving mass."""
        change = self.changes(setting).get("frequency")
        if change is None:
            return None
        if setting.material.density is None:
            return Indicator(change.bound, "unknown without the density")
        if change.value is None:
            return Indicator(0.0, "the limbs between the hinges have no stated mass")
        return Indicator(abs(change.value), f"frequency changes by {change.value:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return the change of the frequency, and of a sag."""
        if setting.mechanism is None and not setting.geometry.has_masses:
            return {}
        from flexcli.parts.heavy_blades import changes  # loads vibrating structures

        if self._last is None or not _same(self._last[0], setting):
            axes = tuple(scene.axis for scene in setting.scenes)
            found = design_by_design(changes, setting, name="blade mass", about=axes)
            self._last = setting, found
        return self._last[1]


def _same(one: Setting, other: Setting) -> bool:
    """Return whether two settings have the same blades, bodies and accelerations."""
    alike = one.geometry is other.geometry and one.mechanism is other.mechanism
    axes = [[s.axis for s in setting.scenes] for setting in (one, other)]
    return (
        alike and one.material is other.material and one.sizes == other.sizes and axes[0] == axes[1]
    )
