"""Stress along the blades and rods of a mechanism in space at an equilibrium: that of the beams.

``σ = N/A − M_z y/I_z + M_y z/I_y + E' ψ f' + ½ E τ² (y² + z² − I_p/A)`` at the corners, with
E' = E/(1 − ν²), τ the twist rate, ψ the section's largest warping (near a corner) and f what the
section warps by; the shear of torsion in the middle of the broad faces, and with it that of the
forces across, there and in the middle of the sides. At a clamp the stress is
locally higher, since it keeps the section from narrowing
(:mod:`flexcli.formulas.clamp_stress`); that is not in these numbers.
"""

import functools
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Filleted, Notch
from flexcli.formulas.torsion_section import shear_factor, warping
from flexcli.mechanics.space.exact.beams import Beams
from flexcli.mechanics.space.exact.blade import along
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.layout import BeamEffects, SpaceBlade, SpaceLayout, SpaceRod
from flexcli.mechanics.space.stresses import (
    SectionForces,
    at_places,
    equivalent,
    shear_spread,
    twisted,
)
from flexcli.numerics.collocation import gauss_nodes, interpolation_matrix, slope_matrix

__all__ = [
    "BladeStress",
    "SectionStates",
    "added_states",
    "beam_stresses",
    "beams_of_state",
    "blade_stresses",
    "difference",
    "largest_of",
    "section_states",
]

Floats = NDArray[np.float64]

_ENDS = np.array([-1.0, 1.0])

_STILL = 1e-6
"""Of the largest ds/du on a segment, the least that is divided by."""

ROUND = 4.0 / 3.0
"""Largest shear of a force across a round section over its mean."""

_THICK = 2.5
"""Thickness over the least of a notch or a blade with fillets from which on its stress is none of
the largest: that of a force past a throat is so where it is twice as thick. Where its faces stand
up, the slope of warping is lost in its digits."""


class BladeStress(NamedTuple):
    """Stresses along a blade at places s over its length, from its start (places,) [Pa].

    ``axial`` is N/A, ``bend_thin`` and ``bend_wide`` are the largest of bending across the
    thickness and across the width (for a rod, of both together in the first), ``warping`` that of
    restrained warping and ``fibres`` that of the long fibres at the corners; ``corner``
    (places, 4) is their sum, with its sign, at the corners (+y +z), (+y −z), (−y +z), (−y −z), for
    a rod the two extremes. ``shear`` is that of torsion at the faces, clamps excepted; ``edge`` is
    the share of it beside the corners: all but a thickness of the edge of a thin section. ``faces``
    and ``sides`` are the shear of the forces across the width, in the middle of the faces, and
    across the thickness, in that of the sides; of a rod the latter is that of both. ``signed``
    (places, 5) are bending across the thickness and the width, and these three shears, of a rod
    its two bendings, that of torsion and those of its two forces, each with its sign.
    """

    name: str
    s: Floats
    axial: Floats
    bend_thin: Floats
    bend_wide: Floats
    warping: Floats
    fibres: Floats
    corner: Floats
    shear: Floats
    edge: Floats
    faces: Floats
    sides: Floats
    signed: Floats


class SectionStates(NamedTuple):
    """What acts in sections of a blade at places s over its length (places,), h thick [m].

    Forces and moments are along the section's own axes [N, N·m]; ``warps`` is what it warps by
    and ``turns`` its twist [rad/m], ``slope`` how the first changes along the blade [rad/m²].
    """

    s: Floats
    h: Floats
    N: Floats
    V_y: Floats
    V_z: Floats
    M_y: Floats
    M_z: Floats
    warps: Floats
    turns: Floats
    slope: Floats


def blade_stresses(state: SpaceEquilibrium) -> tuple[BladeStress, ...]:
    """Return the stresses of every blade and rod of an equilibrium of beams."""
    members, inside = beams_of_state(state)
    return beam_stresses(members, inside, state.own_forces, state.layout.blades, state.effects)


def section_states(state: SpaceEquilibrium) -> list[SectionStates]:
    """Return what acts in the sections of every blade and rod of an equilibrium of beams."""
    return _sections_along(*beams_of_state(state), state.own_forces)


def beams_of_state(state: SpaceEquilibrium) -> tuple[Beams, Floats]:
    """Return the beams of an equilibrium, and what is inside of them."""
    part = state.part
    assembly = part.assembly.on_the_way(part.demand, part.share)
    if not isinstance(assembly.members, Beams):
        raise TypeError("the blades of this equilibrium are no beams")
    return assembly.members, assembly.at(part.x).inside


def added_states(state: SpaceEquilibrium, before: SpaceEquilibrium) -> list[SectionStates]:
    """Return what acts more in the sections of blades in a state than in another.

    Both have the same nodes.
    """
    each = zip(section_states(state), section_states(before), strict=True)
    return [difference(now, then) for now, then in each]


def difference(now: SectionStates, then: SectionStates) -> SectionStates:
    """Return what acts in sections at the same places less what acts in others."""
    return SectionStates(now.s, now.h, *(np.subtract(now[2:], then[2:])))


def largest_of(layout: SpaceLayout, states: Sequence[SectionStates]) -> float:
    """Return the largest stress of von Mises of what acts in the sections of blades [Pa].

    At the places of :func:`flexcli.mechanics.space.stresses.at_places`.
    """
    found = 0.0
    for blade, now in zip(layout.blades, states, strict=True):
        assert isinstance(blade, SpaceBlade)
        steep = isinstance(blade.profile, Notch | Filleted)
        thin = now.h <= (_THICK if steep else np.inf) * now.h.min()
        at = SectionStates(*(each[thin] for each in now))
        torsion = twisted(blade, at.h, at.warps, at.turns, at.slope)
        forces = (at.N, at.V_y, at.V_z, at.M_y, at.M_z, *torsion)
        columns = SectionForces(*(each[:, None] for each in forces))
        rows = at_places(blade, at.s, at.h, ("",) * len(at.s), columns)
        found = max(found, float(equivalent(rows.normal, rows.shear).max()))
    return found


def beam_stresses(
    beams: Beams,
    inside: Floats,
    forces: Floats,
    blades: Sequence[SpaceBlade | SpaceRod],
    effects: BeamEffects,
) -> tuple[BladeStress, ...]:
    """Return the stresses of beams at their nodes and the ends of their segments.

    ``forces`` (blades, 6) are force and end moment in the frames of the starts, scaled.
    """
    found = _sections_along(beams, inside, forces)
    each = zip(blades, found, strict=True)
    return tuple(_of_section(*one, effects) for one in each)


def _sections_along(beams: Beams, inside: Floats, forces: Floats) -> list[SectionStates]:
    """Return what acts in the sections of beams, at their nodes and the ends of their segments.

    ``forces`` (blades, 6) are force and end moment in the frames of the starts, scaled.
    """
    mesh = beams.mesh
    nodes = beams.nodes(inside)
    felt = along(mesh, nodes, forces)
    out = []
    for i, section in enumerate(mesh.sections):
        unit = section.EI / section.l**2
        values = np.concatenate(
            [unit * felt.N[i], unit * section.l * felt.M[i], nodes[i, :, 4:] / section.l], axis=-1
        )
        # the twist rate becomes what the section warps by
        values[:, 6] /= np.where(mesh.apart[i] > 0.0, mesh.apart[i], 1.0)
        at, slope, count = [], [], mesh.per_segment
        for k in range(mesh.nodes // count):
            own = slice(k * count, (k + 1) * count)
            if not np.any(mesh.flexible[i, own]) or not np.any(mesh.w[i, own]):
                continue
            # where its thickness varies, its ends lie beyond what the nodes tell
            varies = float(np.ptp(mesh.h[i, own])) > 0.0
            onto, rise = _from_nodes(count, not varies)
            known = np.column_stack([mesh.s[i, own], mesh.half[i, own], mesh.h[i, own]])
            at.append(np.hstack([onto @ known, onto @ values[own]]))
            # a notch begins where its face is steep: there the nodes stand still
            ds = np.maximum(at[-1][:, 1], _STILL * np.max(mesh.half[i, own])) * section.l
            slope.append(rise @ values[own, 6] / ds)
        s, _, h, N, V_y, V_z, M_x, M_y, M_z, f = np.concatenate(at).T
        felt_here = section.at(h)
        turns = f * felt_here.apart + felt_here.spin / section.EI * M_x
        out.append(SectionStates(s, h, N, V_y, V_z, M_y, M_z, f, turns, np.concatenate(slope)))
    return out


@functools.cache
def _from_nodes(count: int, with_ends: bool) -> tuple[Floats, Floats]:
    """Return what takes values at the nodes to those and slopes there, and at the ends if asked."""
    u = gauss_nodes(count)[0]
    if with_ends:
        u = np.concatenate([_ENDS[:1], u, _ENDS[1:]])
    return interpolation_matrix(count, u), slope_matrix(count, u)


def _of_section(
    blade: SpaceBlade | SpaceRod, at: SectionStates, effects: BeamEffects
) -> BladeStress:
    s, h, N, M_y, M_z, tau = at.s, at.h, at.N, at.M_y, at.M_z, at.turns
    E, G, nu = blade.material.E, blade.material.G, blade.material.nu
    long_fibres = effects.long_fibres
    if isinstance(blade, SpaceRod):
        A, I = blade.area, blade.bent
        bent = np.hypot(M_y, M_z) * blade.d / 2.0 / I
        fibres = long_fibres * E * tau**2 / 2.0 * (blade.d**2 / 4.0 - 2.0 * I / A)
        none = np.zeros_like(N)
        bends = blade.d / 2.0 / I * np.array([M_z, M_y])
        twisted_by, pushed = G * tau * blade.sheared, ROUND / A * np.array([at.V_y, at.V_z])
        return BladeStress(
            name=blade.name,
            s=s,
            axial=N / A,
            bend_thin=bent,
            bend_wide=none,
            warping=none,
            fibres=fibres,
            corner=(N / A + fibres)[:, None] + bent[:, None] * np.array([1.0, -1.0]),
            shear=np.abs(twisted_by),
            edge=none,  # its faces are all around
            faces=none,
            sides=ROUND * np.hypot(at.V_y, at.V_z) / A,
            signed=np.stack([*bends, twisted_by, *pushed], axis=-1),
        )
    b = blade.b
    thin, wide = M_z * 6.0 / (b * h**2), M_y * 6.0 / (h * b**2)
    held = effects.warping and not blade.warps_freely
    warped = held * E / (1.0 - nu**2) * warping(h, b).largest * at.slope
    r2 = (h**2 + b**2) / 12.0
    fibres = long_fibres * E * tau**2 / 2.0 * ((h**2 + b**2) / 4.0 - r2)
    axial = N / (b * h)
    y, z = np.array([1.0, 1.0, -1.0, -1.0]), np.array([1.0, -1.0, 1.0, -1.0])
    corner = (axial + fibres)[:, None] - thin[:, None] * y + wide[:, None] * z
    shear = G * np.minimum(h, b) * ((shear_factor(h, b) - 0.5) * at.warps + 0.5 * tau)
    across, along_y = shear_spread(blade) * at.V_z / (b * h), 1.5 * at.V_y / (b * h)
    return BladeStress(
        name=blade.name,
        s=s,
        axial=axial,
        bend_thin=np.abs(thin),
        bend_wide=np.abs(wide),
        warping=np.abs(warped),
        fibres=fibres,
        corner=corner + warped[:, None] * y * z,
        shear=np.abs(shear),
        edge=1.0 - np.minimum(h, b) / np.maximum(h, b),
        faces=np.abs(across),
        sides=np.abs(along_y),
        signed=np.stack([thin, wide, shear, across, along_y], axis=-1),
    )
