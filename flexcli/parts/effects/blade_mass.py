"""Blade mass: the blades move with what they carry, lower its frequency and add to its sag."""

from math import hypot, inf, pi, sqrt
from typing import ClassVar

import numpy as np

from flexcli.formulas.blade_mass import (
    TORSION_CLAMPED,
    bar_frequency_change,
    frequency_change,
)
from flexcli.formulas.section import second_moment
from flexcli.mechanics.hanging_mass import blade_masses
from flexcli.parts.bending import Change, Changes
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Sizes
from flexcli.parts.geometries.torsion import RoundTorsionBar, TorsionBar, TorsionStar
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.mechanisms.carried import carried, has_limbs, has_masses, joint_layout
from flexcli.parts.mechanisms.parallel_stage import ParallelStage
from flexcli.parts.own_motion import (
    DENSEST,
    hanging_mass,
    hanging_on,
    own_angular,
    own_mode,
    structure_of,
)

__all__ = ["BladeMass"]

SECTION = 3.0
"""Times (h/l)² of the blades' share: their sections' own inertia and shear, left out of it."""

TORSIONAL = RoundTorsionBar | TorsionBar | TorsionStar


class BladeMass(ModelEffect):
    """What the modes of bodies and heavy blades make of the frequency of the one freedom.

    The blades' mass counts by the shapes that they take while they vibrate, and so do coordinates
    of the bodies beside the own motion, such as the rotation of a payload with inertia.
    """

    name: ClassVar[str] = "blade mass"
    needs: ClassVar[str] = "density"
    is_whole: ClassVar[bool] = True

    def __init__(self) -> None:
        self._last: tuple[Setting, Changes] | None = None

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return what it makes of the frequency, with the blades' mass over that of what moves."""
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
        if self._last is None or not _same(self._last[0], setting):
            self._last = setting, _changes(setting)
        return self._last[1]


def _same(one: Setting, other: Setting) -> bool:
    """Return whether two settings have the same blades, bodies and accelerations."""
    alike = one.geometry is other.geometry and one.mechanism is other.mechanism
    axes = [[s.axis for s in setting.scenes] for setting in (one, other)]
    return (
        alike and one.material is other.material and one.sizes == other.sizes and axes[0] == axes[1]
    )


def _changes(setting: Setting) -> Changes:
    found: dict[str, Change] = {}
    for name, change in (("frequency", _frequency), ("sag", _sag)):
        try:
            made = change(setting)
        except (MechanismError, NotAvailable):
            continue
        if made is not None:
            found[name] = made
    return found


def _frequency(setting: Setting) -> Change | None:
    if setting.mechanism is None and not _draws_masses(setting):
        return None
    if isinstance(setting.geometry, TORSIONAL):
        return _twisted(setting, setting.geometry)
    if has_limbs(setting.geometry, setting.material.elastic, setting.sizes):
        return Change(None, 1.0, 0.0, -1)  # a mass that nobody states: down to nothing
    density = setting.material.density
    if density is None:
        return Change(None, abs(_ratio(setting, DENSEST)), 0.0, -1)
    value, light = _ratio(setting, density.value), _ratio(setting, 0.0)
    return Change(value, abs(value), abs(value - light) * _sections(setting))


def _ratio(setting: Setting, density: float) -> float:
    """Return the frequency of the own mode over √(k/m) of the one freedom, less one."""
    geometry, elastic, sizes = setting.geometry, setting.material.elastic, setting.sizes
    mechanism = setting.mechanism
    joint = carried(geometry, elastic, sizes).motion_stiffness
    single = own_mode(mechanism, joint, geometry, elastic, sizes)
    if isinstance(mechanism, ParallelStage) and mechanism.pivot_stiffness is not None:
        added = mechanism.blades_in_motion(geometry, elastic, sizes, density) if density else 0.0
        return frequency_change(added / single.mass)
    structure = structure_of(mechanism, geometry, elastic, sizes, None, density)
    return own_angular(structure) / sqrt(float(single.stiffness) / single.mass) - 1.0


def _sag(setting: Setting) -> Change | None:
    axes = {scene.axis for scene in setting.scenes if scene.acceleration > 0.0}
    if len(axes) != 1 or isinstance(setting.geometry, TORSIONAL):
        return None
    mechanism = setting.mechanism
    if mechanism is None and not _draws_masses(setting):
        return None
    if has_limbs(setting.geometry, setting.material.elastic, setting.sizes):
        return Change(None, inf, 0.0, 1)
    (axis,) = axes
    joint = (setting.geometry, setting.material.elastic, setting.sizes)
    density = setting.material.density
    payload = mechanism.hanging_mass() if mechanism is not None else 0.0
    arm = mechanism.arm if mechanism is not None else 0.0
    light = hanging_mass(mechanism, *joint, axis)
    rho = DENSEST if density is None else density.value
    value = hanging_on(*joint, payload, axis, arm=arm, density=rho) / light - 1.0
    if density is None:
        return Change(None, abs(value), 0.0, 1)
    return Change(value, abs(value), abs(value) * _sections(setting))


def _twisted(setting: Setting, geometry: TORSIONAL) -> Change | None:
    """Return the change by bars that turn with the body: tan(β) β = J_bars/J, one bar or more.

    Where the clamps hold the warping the bars' twist is between that of a free one, linear, and
    that of warping alone, a cubic.
    """
    mechanism, sizes = setting.mechanism, setting.sizes
    inertia = getattr(mechanism, "inertia", None)
    if not inertia or isinstance(mechanism, ParallelStage):
        return None
    density = setting.material.density
    rho = DENSEST if density is None else density.value
    bars = rho * float(geometry.bars * _polar_moment(geometry, sizes) * sizes.l) / inertia
    value = bar_frequency_change(bars)
    if density is None:
        return Change(None, abs(frequency_change(TORSION_CLAMPED * bars)), 0.0, -1)
    clamped = getattr(geometry, "warping", "free") == "restrained"
    least = frequency_change(TORSION_CLAMPED * bars) if clamped else value
    return Change(value, abs(value), abs(least - value))


def _polar_moment(geometry: TORSIONAL, sizes: Sizes) -> float:
    """Return the polar second moment of the section of a bar [m⁴]."""
    if isinstance(geometry, RoundTorsionBar):
        return float(pi * sizes.d**4 / 32.0)
    strips = geometry.strips if isinstance(geometry, TorsionStar) else 1
    return float(strips * (second_moment(sizes.h, sizes.b) + second_moment(sizes.b, sizes.h)))


def _draws_masses(setting: Setting) -> bool:
    return has_masses(setting.geometry, setting.material.elastic, setting.sizes)


def _sections(setting: Setting) -> float:
    """Return the share of the blades' part that their sections' inertia and shear may change."""
    layout = joint_layout(setting.geometry, setting.material.elastic, setting.sizes)
    most = max(
        volume / (blade.b * hypot(*np.subtract(blade.end, blade.start)) ** 2)
        for blade, volume in zip(layout.blades, blade_masses(layout, 1.0), strict=True)
    )
    return float(SECTION * most**2)
