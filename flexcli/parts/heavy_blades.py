"""The mass of the blades in a frequency and in a sag."""

from math import inf, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.blade_mass import (
    TORSION_CLAMPED,
    bar_frequency_change,
    frequency_change,
)
from flexcli.formulas.plate_factors import bound
from flexcli.formulas.thick_notch import bends_more
from flexcli.mechanics.hanging_mass import blade_masses
from flexcli.mechanics.layout import Blade
from flexcli.mechanics.stress_places import stress_places
from flexcli.mechanics.stresses import beside_beam_rows
from flexcli.numerics.modes import natural_modes
from flexcli.numerics.quadrature import gauss_rule
from flexcli.parts.bending import Change, Changes, Factor
from flexcli.parts.effects.base import Setting
from flexcli.parts.effects.clamps import clamps_of
from flexcli.parts.effects.estimate import BETWEEN
from flexcli.parts.effects.plate import wide_of
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import TwistingBars
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.mechanisms.carried import carried
from flexcli.parts.own_motion import (
    DENSEST,
    either_mode,
    first_taking,
    hanging_mass,
    hanging_on,
    own_angular,
    own_mode,
    structure_of,
)
from flexcli.parts.structure import Structure

__all__ = ["changes"]

Floats = NDArray[np.float64]

SECTION = 3.0
"""Factor on (h/l)² of the blades' share, for rotary inertia and shear of their sections."""

THICK = 0.05
"""Part of that which Timoshenko's beams leave out."""

NODES = 40
"""Gauss nodes on a piece of a hinge."""

BESIDE, APART = 3e-3, 2.0
"""Part of the own motion that a mode below may take, for a little more would make it the own one;
and the ratio of frequencies up to which two modes mix, so that first order tells too little."""

SECOND, SLOPES = 3.0, 2.0
"""By which part of the largest change of a section first order tells too little of what bending
that is distributed otherwise does to a frequency, and on what it tells of sloping faces and of
mouths: 1000 random beams with sections up to a third less compliant somewhere were within it; of
faces and mouths 1.9."""

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
    own = _own(setting, rho)
    value, error = own.ratio, abs(own.ratio - _own(setting, 0.0).ratio) * _sections(setting)
    if setting.material.elastic.shear is not None:
        value, error = _own(setting, rho, thick=True).ratio, THICK * error
    if own.structure is not None:
        error += (1.0 + value) * either_mode(own.structure)
    beside = _redistributed(setting, rho)
    if beside is not None:
        error += beside
    crossed = clamps_of(setting)
    if crossed is not None and crossed.stiffness.other == 0.0:
        low, high = crossed.stiffness.low**0.5, crossed.stiffness.high**0.5
        error += BETWEEN * abs(value) * max(1.0 - low, high - 1.0)
    if density is None:
        return Change(None, 1.0 - (1.0 + value) * (1.0 - error), 0.0, -1)
    return Change(value, abs(value), error, other=inf if beside is None else 0.0)


class _Bent(NamedTuple):
    """Where a symmetric hinge bends (nodes,): thickness, and shares of its energy of bending.

    ``still`` is that under a moment at rest, ``moving`` in its own mode; ``slope`` is that of a
    face, ``at_mouth`` the mean of both mouths over that at rest.
    """

    slope: Floats
    still: Floats
    moving: Floats
    at_mouth: float


def _redistributed(setting: Setting, density: float) -> float | None:
    """Return what a hinge that bends otherwise than its beam changes of what its mass does.

    Where a section is more compliant by a share c, the square of the frequency falls by the mean of
    c over the energy of bending in the mode, and the stiffness by that at rest: the mass changes
    their ratio as far as both distributions differ. None of joints that are no single hinge, or
    that a mode below the own one takes part in.
    """
    thick = setting.geometry.thick_notches(setting.sizes)
    if thick is None or thick.factor is None:
        return None
    bent = _bent(setting, density)
    if bent is None:
        return None
    return _of_width(bent, setting) + _of_thickness(bent, thick.factor)


def _of_width(bent: _Bent, setting: Setting) -> float:
    """Return what the width changes of what a hinge's mass does.

    A section is stiffer by anything up to that of a plate that is kept flat, all of them together
    by what is known of the hinge.
    """
    apart = bent.moving - bent.still
    own = float(np.abs(apart).sum() / 2.0)
    apart = (apart + apart[::-1]) / 2.0
    flat = float(bound(setting.poisson_bound))
    between = flat / (1.0 + flat)
    changed = between * float(np.abs(apart).sum() / 2.0)
    wide = wide_of(setting)
    if wide is not None and setting.material.poisson_ratio is not None:
        most = float(np.max(np.abs(apart) / bent.still))
        _, low, high, _ = wide.stiffness
        kept, given = max(1.0 / low - 1.0 / (1.0 + flat), 0.0), 1.0 - 1.0 / high
        changed = min(changed, kept * most, given * most)
    return (1.0 + SECOND * between) * changed / 2.0 + (between * own) ** 2


def _of_thickness(bent: _Bent, factor: Factor) -> float:
    """Return what the faces' slope and the blocks change of what a hinge's mass does."""
    more = bends_more(bent.slope)
    faces = float(bent.still @ more)
    blocks = max(abs(1.0 / end - 1.0 - faces) for end in (factor.low, factor.high))
    changed = abs(float((bent.moving - bent.still) @ more)) + blocks * abs(bent.at_mouth - 1.0)
    return SLOPES * changed / 2.0


def _bent(setting: Setting, density: float) -> _Bent | None:
    geometry, elastic, sizes = setting.geometry, setting.material.elastic, setting.sizes
    layout = geometry.blades_layout(elastic, sizes)
    structure = structure_of(setting.mechanism, geometry, elastic, sizes, None, density)
    stresses = [rows for name, rows in structure.outputs.items() if name.startswith("stress ")]
    if len(layout.blades) != 1 or len(stresses) != 1 or structure.motion is None:
        return None
    modes = natural_modes(structure.stiffness, structure.mass)
    share = (structure.motion @ modes.shapes) ** 2 / modes.angular**2 * structure.motion_stiffness
    own = first_taking(share, 1.0)
    if own is None:
        return None
    others = np.delete(modes.angular, own) / modes.angular[own]
    mixed = np.any((others < APART) & (others > 1.0 / APART))
    if mixed or share[:own].max(initial=0.0) > BESIDE or share[own] < 0.5:
        return None
    one, other = np.split(stresses[0] @ modes.shapes[:, own], 2)
    return _along(layout.blades[0], (one - other) / 2.0)


def _along(blade: Blade, bending: Floats) -> _Bent:
    """Return where a hinge bends, given its bending stress along every piece."""
    l = float(blade.length)
    pieces = blade.profile.pieces(l)
    looked = [(piece, stress_places(piece)) for piece in pieces]
    places = np.concatenate([piece.position(u) for piece, u in looked])
    thick = np.concatenate([piece.thickness(u) * np.ones(u.size) for piece, u in looked])
    # without what forces across it add to the stress of its moment
    more, _ = beside_beam_rows(blade, places, thick, np.eye(places.size))
    moments = np.linalg.solve(np.eye(places.size) + more, bending) * thick**2
    is_end = np.concatenate([np.abs(u) == 1.0 for _, u in looked])
    at, first = np.unique(np.round(places[is_end] / l - 0.5, 9), return_index=True)
    moment = np.polyfit(at, moments[is_end][first], len(at) - 1)
    u, weight = gauss_rule(NODES)
    u, weight = 2.0 * u - 1.0, 2.0 * weight
    s, h, ds = (
        np.concatenate(found)
        for found in zip(
            *(
                (p.position(u) / l - 0.5, p.thickness(u) * np.ones(NODES), p.slope(u) * weight)
                for p in pieces
            ),
            strict=True,
        )
    )
    still, square = ds / h**3, np.polyval(moment, s) ** 2
    still /= still.sum()
    mean = float(still @ square)
    mouths = float(np.mean(np.polyval(moment, np.array([-0.5, 0.5])) ** 2)) / mean
    slope = np.abs(np.gradient(h, s * l)) / 2.0
    return _Bent(slope, still, still * square / mean, mouths)


class _Own(NamedTuple):
    """The own mode: its frequency over √(k/m) of the one freedom, less one; what vibrates.

    Nothing is told to vibrate where the stiffness of the motion is stated.
    """

    ratio: float
    structure: Structure | None


def _own(setting: Setting, density: float, *, thick: bool = False) -> _Own:
    geometry, elastic, sizes = setting.geometry, setting.material.elastic, setting.sizes
    mechanism = setting.mechanism
    joint = carried(geometry, elastic, sizes, thick=thick).motion_stiffness
    single = own_mode(mechanism, joint, geometry, elastic, sizes)
    if mechanism is not None and mechanism.states_stiffness:
        added = mechanism.blades_in_motion(geometry, elastic, sizes, density) if density else 0.0
        return _Own(frequency_change(added / single.mass), None)
    structure = structure_of(mechanism, geometry, elastic, sizes, None, density, thick=thick)
    alone = sqrt(float(single.stiffness) / single.mass)
    return _Own(own_angular(structure) / alone - 1.0, structure)


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
    return Change(value, abs(value), abs(value) / (1.0 + value) * _sections(setting))


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
        volume / (blade.b * float(blade.length) ** 2)
        for blade, volume in zip(layout.blades, blade_masses(layout, 1.0), strict=True)
    )
    return float(SECTION * most**2)
