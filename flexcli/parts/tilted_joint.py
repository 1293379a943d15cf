"""Blades side by side along the axis of a pivot: forces at different heights tilt the body.

Models of a plane keep it upright. Two blades that cross bear the forces that a rotation makes of
them, or one in the plane, as a couple.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from math import inf, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.layout import SpaceBlade, SpaceLayout, Vector
from flexcli.mechanics.space.states import Acting, SpaceState, Stresses, action, combined
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.material import Material
from flexcli.parts.mechanisms import Mechanism
from flexcli.parts.own_motion import TAKES_PART, UNSURE_PART, own_angular
from flexcli.parts.scene import Scene
from flexcli.parts.space_joint import SpaceJoint, joint_in_space
from flexcli.parts.space_states import KNOWN, acting_groups, third_order
from flexcli.parts.space_vibration import likely_structures
from flexcli.parts.stress_across import ACROSS, WITHIN, borne_stress

__all__ = ["Tilt", "least_frequency", "moved_by_tilt", "tilt_of"]

Floats = NDArray[np.float64]

BEYOND, LOADED = 0.15, 0.75
"""Part of the stress of a tilt that orders beyond the second may add, by a stroke alone and beside
loads: of 140 random cross-springs at strokes exact beams in space had 0.87 of what is told at most,
under forces half of the second in thick blades as wide as long."""


class Tilt(NamedTuple):
    """What a tilting body changes.

    ``stiffness`` is that along the motion over that of the same joint kept upright [-]; ``stress``
    and ``amplitude`` are what the tilt adds at most to the largest stress of a case, and to how far
    that alternates [Pa]; infinite where small motion tells nothing.
    """

    stiffness: float
    stress: float
    amplitude: float


def tilt_of(geometry: Geometry, material: Material, sizes: Sizes, scene: Scene) -> Tilt:
    """Return what a tilt changes of a joint at the ends of a case's stroke, its loads acting.

    The stress is that of the forces out of the plane, to second order, and of what those in it are
    more than in an upright joint: with that of the plane, as if all were largest at one place, it
    is no less than all together. Without a Poisson's ratio
    that which makes most of it, 0 or ½.
    """
    each = [_of_joint(joint, scene) for joint in _joints(geometry, material, sizes)]
    least, *others = zip(*each, strict=True)
    return Tilt(min(least), *map(max, others))


def moved_by_tilt(geometry: Geometry, material: Material, sizes: Sizes) -> float:
    """Return how far a tilt moves a pivot's centre in its plane, or a stage along its blades.

    Of a unit stroke [m/rad or 1], beside what an upright body does; it is of first order in the
    stroke. Without a Poisson's ratio as of :func:`tilt_of`.
    """
    return max(map(_moved_by_tilt, _joints(geometry, material, sizes)))


def least_frequency(
    geometry: Geometry, material: Material, sizes: Sizes, mechanism: Mechanism | None
) -> float:
    """Return the lowest frequency of a mode in which the motion of a tilting body takes part [Hz].

    Of all that its stiffness, its masses and the unstated inertia of its bodies may be.
    """
    found = likely_structures(mechanism, geometry, material, sizes, 2)
    each = (found.own, *(found.others or ()))
    part = TAKES_PART / UNSURE_PART
    return min(own_angular(structure, part) for structure in each) / (2.0 * pi)


def _joints(geometry: Geometry, material: Material, sizes: Sizes) -> list[SpaceJoint]:
    if material.poisson_ratio is not None:
        return [joint_in_space(geometry, material, sizes)]
    return [SpaceJoint(geometry.space_layout(each, sizes)) for each in material.elastic.likely]


def _moved_by_tilt(joint: SpaceJoint) -> float:
    free, upright = map(_moved_aside, (joint, SpaceJoint(_kept_upright(joint.layout))))
    return float(np.linalg.norm(free - upright))


def _moved_aside(joint: SpaceJoint) -> Floats:
    """Return the motion of a pivot's centre in its plane, or of a stage across its stroke."""
    drive = joint.layout.drive
    moved = joint.assembly.moved(travel=np.ones(1)).coordinates[:, 0]
    point, rows = ((0.0, 0.0, 0.0), slice(2)) if drive.turns else (drive.point, slice(1))
    return np.asarray(joint.assembly.motion(drive.body, point)[rows] @ moved)


def _of_joint(joint: SpaceJoint, scene: Scene) -> Tilt:
    upright = SpaceJoint(_kept_upright(joint.layout))
    k, kept = (_driven(each) for each in (joint, upright))
    stresses, most, swings = Stresses(joint.assembly), 0.0, 0.0
    groups = acting_groups(joint, scene)
    loads, held = ([action(of.assembly, one) for one in groups] for of in (joint, upright))
    cases = zip(_ends(joint, scene, loads), _ends(upright, scene, held), strict=True)
    for ends, upright_ends in cases:
        forces, beside, more = [], [], 0.0
        for state, still in zip(ends, upright_ends, strict=True):
            after = state.following()
            borne = state.moved.forces[:, 0] + after.forces
            forces.append(borne + _twisting(joint, state, borne))
            beside.append(state.moved.forces[:, 0] - still.moved.forces[:, 0])
            more = max(more, third_order(after))
        if more > KNOWN:
            return Tilt(k / kept, inf, inf)
        beyond = 1.0 + more + (LOADED if loads else BEYOND)
        pairs = zip(forces, beside, strict=True)
        most = max(most, *(_stress(stresses, *both) * beyond for both in pairs))
        out, within = ((each[0] - each[-1]) / 2.0 for each in (forces, beside))
        swings = max(swings, _stress(stresses, out, within) * beyond)
    return Tilt(k / kept, most, swings)


def _stress(stresses: Stresses, out: Floats, within: Floats) -> float:
    """Return the stress of forces out of the plane and of others in it, where both are largest.

    Of several pairs a tilt pulls and bends the blades at other heights than the middle one.
    """
    return borne_stress(stresses, out, ACROSS) + borne_stress(stresses, within, WITHIN)


def _twisting(joint: SpaceJoint, state: SpaceState, forces: Floats) -> Floats:
    """Return the torques that forces out of the plane become as blades turn, at most [N·m].

    What bends a blade across its width twists it where it has turned about z, of a wide thin blade
    at a stroke most of its stress out of the plane: by the moment times the slope about the mean
    slope, for its ends are kept from twisting. What the twist lets off is not counted.
    """
    found = np.zeros_like(forces)
    for k, member in enumerate(joint.assembly.members):
        at = 6 * k
        v, turn = state.moved.deformations[at + 1, 0], state.moved.deformations[at + 5, 0]
        slope = (abs(turn) + 1.5 * abs(v) / member.l) / 2.0
        _, _, across, torque, bending, _ = forces[at : at + 6]
        most = abs(bending) + abs(across) * member.l / 2.0
        found[at + 3] = np.copysign(slope * most, torque)
    return found


_NONE = np.zeros(3)


def _kept_upright(layout: SpaceLayout) -> SpaceLayout:
    """Return a layout with all blades in the plane."""
    blades = tuple(
        replace(each, start=_flat(each.start), end=_flat(each.end))
        for each in layout.blades
        if isinstance(each, SpaceBlade)
    )
    return SpaceLayout(layout.bodies, blades, layout.drive, layout.springs)


def _flat(place: Vector) -> Vector:
    return place[0], place[1], 0.0


def _driven(joint: SpaceJoint) -> float:
    return float(joint.assembly.moved(travel=np.ones(1)).drive[0])


def _ends(joint: SpaceJoint, scene: Scene, groups: list[SpaceState]) -> Iterator[list[SpaceState]]:
    """Yield the states at the ends of a stroke for each sense of the loads; none without both."""
    point = joint.layout.body(joint.layout.drive.body).point
    strokes = [action(joint.assembly, Acting(end, np.zeros(6), point, _NONE))
               for end in dict.fromkeys(scene.stroke_ends) if end]  # fmt: skip
    if not (strokes or groups):
        return
    for signs in product((1.0, -1.0), repeat=len(groups)):
        loads = [combined(groups, list(signs))] if groups else []
        rest = loads if not strokes or not all(scene.stroke_ends) else []
        yield [*(combined([each, *loads], [1.0] * (1 + len(loads))) for each in strokes), *rest]
