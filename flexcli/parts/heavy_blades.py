"""The mass of the blades in a frequency and in a sag."""

from math import hypot, inf, sqrt

import numpy as np

from flexcli.formulas.blade_mass import (
    TORSION_CLAMPED,
    bar_frequency_change,
    frequency_change,
)
from flexcli.mechanics.hanging_mass import blade_masses
from flexcli.parts.bending import Change, Changes
from flexcli.parts.effects.base import Setting
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import TwistingBars
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.mechanisms.carried import carried
from flexcli.parts.own_motion import (
    DENSEST,
    hanging_mass,
    hanging_on,
    own_angular,
    own_mode,
    structure_of,
)

__all__ = ["changes"]

SECTION = 3.0
"""Factor on (h/l)² of the blades' share, for rotary inertia and shear of their sections."""

THICK = 0.05
"""Part of that which Timoshenko's beams leave out."""

SLOWER = Change(None, 1.0, 0.0, -1)
"""Change of a frequency with unknown masses: down to zero."""

LOWER = Change(None, inf, 0.0, 1)
"""Change of a sag with unknown masses: unbounded."""


def changes(setting: Setting) -> Changes:
    """Return the change of the frequency, and of a sag, where a body with mass moves."""
    found: dict[str, Change] = {}
    for name, change, unknown in (("frequency", _frequency, SLOWER), ("sag", _sag, LOWER)):
        try:
            made = change(setting)
        except MechanismError:
            continue  # nothing moves there that has a mass
        except NotAvailable:
            made = unknown
        if made is not None:
            found[name] = made
    return found


def _frequency(setting: Setting) -> Change | None:
    bars = setting.geometry.twisting_bars(setting.sizes)
    if bars is not None:
        return _twisted(setting, bars)
    if setting.geometry.has_limbs(setting.material.elastic, setting.sizes):
        return SLOWER
    density = setting.material.density
    rho = DENSEST if density is None else density.value
    value = _ratio(setting, rho)
    error = abs(value - _ratio(setting, 0.0)) * _sections(setting)
    if setting.material.elastic.shear is not None:
        value, error = _ratio(setting, rho, thick=True), THICK * error
    if density is None:
        return Change(None, 1.0 - (1.0 + value) * (1.0 - error), 0.0, -1)
    return Change(value, abs(value), error)


def _ratio(setting: Setting, density: float, *, thick: bool = False) -> float:
    """Return the frequency of the own mode over √(k/m) of the one freedom, less one."""
    geometry, elastic, sizes = setting.geometry, setting.material.elastic, setting.sizes
    mechanism = setting.mechanism
    joint = carried(geometry, elastic, sizes, thick=thick).motion_stiffness
    single = own_mode(mechanism, joint, geometry, elastic, sizes)
    if mechanism is not None and mechanism.states_stiffness:
        added = mechanism.blades_in_motion(geometry, elastic, sizes, density) if density else 0.0
        return frequency_change(added / single.mass)
    structure = structure_of(mechanism, geometry, elastic, sizes, None, density, thick=thick)
    return own_angular(structure) / sqrt(float(single.stiffness) / single.mass) - 1.0


def _sag(setting: Setting) -> Change | None:
    axes = {scene.axis for scene in setting.scenes if scene.sags}
    if len(axes) != 1 or setting.geometry.twisting_bars(setting.sizes) is not None:
        return None
    mechanism = setting.mechanism
    if setting.geometry.has_limbs(setting.material.elastic, setting.sizes):
        return LOWER
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


def _twisted(setting: Setting, bars: TwistingBars) -> Change | None:
    """Return the change by bars that turn with the body: tan(β) β = J_bars/J, one bar or more.

    Where the clamps hold the warping the bars' twist is between that of a free one, linear, and
    that of warping alone, a cubic.
    """
    inertia = setting.mechanism.turning_inertia if setting.mechanism is not None else None
    if not inertia:
        return None
    density = setting.material.density
    rho = DENSEST if density is None else density.value
    ratio = rho * float(bars.polar) / inertia
    value = bar_frequency_change(ratio)
    if density is None:
        return Change(None, abs(frequency_change(TORSION_CLAMPED * ratio)), 0.0, -1)
    least = frequency_change(TORSION_CLAMPED * ratio) if bars.restrained else value
    return Change(value, abs(value), abs(least - value))


def _sections(setting: Setting) -> float:
    """Return the share of the blades' part that their sections' inertia and shear may change."""
    layout = setting.geometry.blades_layout(setting.material.elastic, setting.sizes)
    most = max(
        volume / (blade.b * hypot(*np.subtract(blade.end, blade.start)) ** 2)
        for blade, volume in zip(layout.blades, blade_masses(layout, 1.0), strict=True)
    )
    return float(SECTION * most**2)
