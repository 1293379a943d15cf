"""Motion, stress and frequency of a joint in space, each with its error.

The springs' errors are those of :mod:`flexcli.formulas.clamped_blade`. What a stroke leaves out of
small motion is told by its second order; where that is not small beside the first, the error is
unknown.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import product
from math import inf, isfinite
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.rigid_motion import axes_about_z, motion_along, motion_at
from flexcli.mechanics.space.layout import SpaceBlade, SpaceRod, Vector
from flexcli.mechanics.space.linear import SpaceAssembly
from flexcli.mechanics.space.second_order import SecondOrder, stiffened_by_loads
from flexcli.mechanics.space.states import (
    Acting,
    BladeStress,
    SpaceState,
    Stresses,
    action,
    combined,
    warmed,
)
from flexcli.mechanics.space.stresses import equivalent, hinge_error, hinge_range
from flexcli.mechanics.space.warping_error import warping_error
from flexcli.parts.material import Material
from flexcli.parts.requirements.ask import Ask
from flexcli.parts.scene import Scene
from flexcli.parts.space_joint import SpaceJoint, joint_of
from flexcli.parts.temperature import alike, held_lengths
from flexcli.parts.worst_places import worst_places
from flexcli.results import EXACT, ErrorRange

__all__ = [
    "KNOWN",
    "SOFTENED",
    "STIFFENS",
    "THIRD",
    "TURNS",
    "UNEVEN",
    "Place",
    "StrokeEnd",
    "acting_groups",
    "acting_together",
    "bent_by_gradient",
    "hinge_error_of",
    "hinge_stress_error",
    "hull",
    "largest_stress",
    "left_by_temperature",
    "linear_error",
    "motions",
    "moved_by_lengths",
    "moved_by_moduli",
    "senses",
    "spring_change",
    "spring_error",
    "state_error",
    "stiffened_by",
    "straight_shares",
    "stress_places",
    "third_order",
    "unsure_swing",
    "warping_change",
]

Floats = NDArray[np.float64]

AROUND_ERROR = 5e-3
"""Largest relative excess of a round section's computed stress."""

KNOWN = 0.3
"""Relative change by further orders up to which the linear result is used."""

STIFFENS = 12.0
"""Axial force [EI/l²] that would change the bending of a blade by as much as itself."""

SOFTENED = 0.75
"""Share of the lateral-buckling load of straight blades and bodies up to which results are given:
there it makes the second order four times as large. One or two polynomials for a blade give it to
some per cent."""

THIRD = 0.4
"""Factor on l θ³, θ the largest rotation of a blade: third-order motion off the path."""

UNEVEN = 1.5
"""Times the second order of blades of constant thickness for blades that are not."""

TURNS = 2.0
"""Factor on the square of a blade's rotation: its third-order rotation."""

SHARES = (1.0, 0.8, 0.6, 0.5, 0.4, 0.35, 0.3, 0.25, 0.2)
"""Of the loads that are of interest, at which a linear state is looked at, to say that nothing
buckles."""

TWOFOLD = 2.0
"""Factor on the effect at rest of uneven sections: its upper bound at a stroke."""


class StrokeEnd(NamedTuple):
    """Motion of the moving body's point at an end of a stroke, along the axes of cases.

    ``first`` and ``second`` are its orders (6,) [m, rad], ``doubt`` the relative error of each,
    ``floor`` a further error of a translation [m] and of a rotation [rad]. ``growth`` is the body's
    own thermal growth about its point [-].
    """

    first: Floats
    second: Floats
    doubt: float
    floor: tuple[float, float]
    growth: float = 0.0

    def at(self, point: Vector, rows: Floats) -> tuple[Floats, Floats]:
        """Return components of the motion of another point of the body, and their errors.

        ``rows`` (n, 6) pick the components, which are all lengths or all angles.
        """
        to, theta = motion_at(point), self.first[3:]
        arc = np.concatenate([np.cross(theta, np.cross(theta, point)) / 2.0, np.zeros(3)])
        grown = np.concatenate([self.growth * np.asarray(point), np.zeros(3)])
        one, two = rows @ (to @ self.first + grown), rows @ (to @ self.second + arc)
        besides = self.floor[0] if np.any(rows[:, :3]) else self.floor[1]
        sizes = np.abs(one) + np.abs(two)
        # what nobody knows is no less unknown of what does not move
        off = self.doubt * sizes if isfinite(self.doubt) else np.full_like(sizes, inf)
        return one + two, off + besides


class Place(NamedTuple):
    """Amplitude of a stroke and the other stress at a place of a blade [Pa], signed."""

    where: str
    amplitude: float
    mean: float


def acting_groups(joint: SpaceJoint, scene: Scene) -> list[Acting]:
    """Return the stated loads of a case and each of its accelerations, each acting by itself."""
    point = joint.layout.body(joint.layout.drive.body).point
    fields = ((0.0, 0.0, 0.0), *scene.accelerations)
    return [
        Acting(0.0, np.array(wrench), point, np.array(field))
        for wrench, field in zip((scene.stated, *scene.inertial), fields, strict=True)
        if any(wrench) or any(field)
    ]


def senses(scene: Scene, groups: int) -> Iterator[tuple[float, ...]]:
    """Yield the senses in which the acting groups of a case act at once.

    The stated load, the first of them, acts in its own sense alone.
    """
    stated = (1.0,) if any(scene.stated) else (1.0, -1.0)
    return product(*(stated if k == 0 else (1.0, -1.0) for k in range(groups)))


def acting_together(
    joint: SpaceJoint,
    acting: Sequence[Acting],
    senses: Iterable[Sequence[float]],
    *,
    locked: bool,
) -> Iterator[SpaceState]:
    """Yield the linear states of a joint as it has grown, under loads in each of their senses.

    ``locked`` says whether the drive holds it against what it has grown by. A temperature may
    leave all of it without strain.
    """
    states = [action(joint.assembly, each) for each in acting]
    heat = [warmed(joint.assembly, locked=locked)] if joint.layout.grows or not acting else []
    for signs in senses:
        yield combined([*states, *heat], [*signs, *(1.0 for _ in heat)])


def motions(
    joint: SpaceJoint, scene: Scene, material: Material, turn: float
) -> tuple[StrokeEnd, ...]:
    """Return the motion at both ends of a stroke, the drive locked there, without loads.

    With a temperature the joint has grown besides; without a stroke its drive is then free.
    ``turn`` is the angle from the layout's x to that of cases [rad].
    """
    axes = motion_along(axes_about_z(turn))
    body = joint.layout.body(joint.layout.drive.body)
    to_point = axes @ joint.assembly.motion(body.name, body.point)
    found = []
    bent = bent_by_gradient(joint, scene)[1] + moved_by_moduli(joint, scene, material, turn)
    for travel in scene.stroke_ends:
        state = action(joint.assembly, Acting(travel, np.zeros(6), body.point, np.zeros(3)))
        if joint.layout.grows:
            heat = warmed(joint.assembly, locked=scene.moves)
            state = combined([state, heat], [1.0, 1.0]) if travel else heat
        after = state.following()
        one, two = to_point @ state.moved.coordinates[:, 0], to_point @ after.coordinates
        # the drive's point turns as well, where it is not the body's
        arm = axes[:3, :3] @ np.subtract(body.point, joint.layout.drive.point)
        two[:3] += np.cross(one[3:], np.cross(one[3:], arm)) / 2.0
        share = spring_change(joint, state) + third_order(after)
        share = share if share <= KNOWN else inf
        length = max(member.l for member in joint.assembly.members)
        floor = THIRD * after.rotation**3
        growth = joint.layout.body_growth.get(body.name, 0.0)
        turned = float(np.linalg.norm(bent[3:]))
        shifted = float(np.linalg.norm(bent[:3])) + length * turned
        floors = (length * floor + shifted, floor + turned)
        found.append(StrokeEnd(one, two, share, floors, growth))
    return tuple(found)


def bent_by_gradient(joint: SpaceJoint, scene: Scene) -> tuple[float, Floats]:
    """Return the most that gradients within sections add: stress [Pa], motion of the drive.

    The motion is that of the driven point, shift [m] and rotation [rad] (6,). States give each
    blade the temperature of its middle. The gradient of its section would bend it where it is free,
    and stresses it where it is held, as a plate in both directions. Beside a stroke, at which other
    motions are softer than at rest, all counts twofold.
    """
    assembly, drive = joint.assembly, joint.layout.drive
    misfits = assembly.curl()
    if not misfits.any():
        return 0.0, np.zeros(6)
    moved = assembly.moved(misfits=misfits[:, None], travel=np.zeros(1) if scene.moves else None)
    of_blades = Stresses(assembly).of(moved.forces[:, 0], np.zeros((len(assembly.members), 3)))
    each = zip(of_blades, joint.layout.blades, strict=True)
    stress = max(largest_stress(found) / (1.0 - blade.material.nu) for found, blade in each)
    times = TWOFOLD if scene.moves else 1.0
    motion = assembly.motion(drive.body, drive.point) @ moved.coordinates[:, 0]
    return times * stress, times * np.abs(motion)


def moved_by_lengths(joint: SpaceJoint, scene: Scene, material: Material) -> tuple[float, Floats]:
    """Return the most that unsure lengths of warm blades add: stress [Pa], motion of the drive.

    The motion is that of the driven point, shift [m] and rotation [rad] (6,). Both are of small
    motion, of each kind of blades by itself: clamps make those that are alike as much longer.
    """
    assembly, drive, unsure = (
        joint.assembly,
        joint.layout.drive,
        held_lengths(joint.layout, material),
    )
    at, none = assembly.motion(drive.body, drive.point), np.zeros((len(assembly.members), 3))
    stress, motion = 0.0, np.zeros(6)
    for names in alike(joint.layout.blades):
        own = {name: unsure[name] for name in names}
        longer = replace(joint.layout, body_growth={}, blade_growth=own)
        misfits = replace(assembly, layout=longer).growth()[:, None]
        moved = assembly.moved(misfits=misfits, travel=np.zeros(1) if scene.moves else None)
        of_blades = Stresses(assembly).of(moved.forces[:, 0], none)
        stress += max(map(largest_stress, of_blades))
        motion += np.abs(at @ moved.coordinates[:, 0])
    return stress, motion


def moved_by_moduli(joint: SpaceJoint, scene: Scene, material: Material, turn: float) -> Floats:
    """Return the most that moduli of blades add which differ by their temperatures (6,) [m, rad].

    It is the motion of the driven point at either end of a stroke, of small motion; states give all
    blades one modulus. Blades that share a force alike leave a body where it is, and tip it or move
    it aside in the first order where they do not. What nobody gave over temperature counts for each
    blade by itself; beside a stroke, at which other motions are softer than at rest, all counts
    twofold. ``turn`` is the angle from the layout's x to that of cases [rad].
    """
    assembly, drive, temperature = joint.assembly, joint.layout.drive, scene.temperature
    if temperature is None:
        return np.zeros(6)
    of = joint.layout, material, turn
    known, unsure = (list(d.values()) for d in (temperature.stiffer(*of), temperature.unlike(*of)))
    changes = [each for each in (np.array(known) - 1.0, *np.diag(unsure)) if each.any()]
    if not changes:
        return np.zeros(6)
    travels = np.array(scene.stroke_ends) if scene.moves else None
    misfits = assembly.growth()[:, None] * np.ones(1 if travels is None else len(travels))

    def moved(springs: SpaceAssembly) -> Floats:
        to_point = springs.motion(drive.body, drive.point)
        return np.asarray(to_point @ springs.moved(misfits=misfits, travel=travels).coordinates)

    alike = moved(assembly)
    found = np.zeros_like(alike)
    for change in changes:
        factors = np.ones(len(assembly.rows))
        factors[: 6 * len(change)] += np.repeat(change, 6)
        found += np.abs(moved(assembly.scaled(factors)) - alike)
    return np.asarray((TWOFOLD if scene.moves else 1.0) * found.max(axis=1))


def left_by_temperature(ask: Ask) -> tuple[float, ...]:
    """Return the motion of the body by the temperature of a case alone, along and about x, y, z."""
    joint = joint_of(ask)
    body = joint.layout.body(joint.layout.drive.body)
    moved = warmed(joint.assembly, locked=False).moved.coordinates[:, 0]
    found = joint.assembly.motion(body.name, body.point) @ moved
    return tuple(found.tolist())


def stress_places(joint: SpaceJoint, scene: Scene) -> tuple[list[Place], ErrorRange | None]:
    """Return the stresses of a case where they may be the worst, and their error.

    The stroke is held by the drive, a temperature beside it; the loads act with the drive free,
    each either way save a stated load that has a direction. Amplitude and mean are von Mises' of
    their own normal and shear stress; a mean in compression without shear is negative.
    """
    stresses = Stresses(joint.assembly)
    groups = [action(joint.assembly, each) for each in acting_groups(joint, scene)]
    body = joint.layout.body(joint.layout.drive.body)
    found: list[Place] = []
    errors: list[ErrorRange | None] = []
    if scene.moves:
        unit = action(joint.assembly, Acting(1.0, np.zeros(6), body.point, np.zeros(3)))
        strokes = [unit]
    else:
        unit, strokes = None, []
    heated = scene.temperature is not None
    heat = [warmed(joint.assembly, locked=scene.moves)] if heated else []
    for signs in product(*((1.0, -1.0) for _ in groups)):
        if not groups and unit is None and not heat:
            break
        parts, loads = [*strokes, *groups, *heat], [*signs, *(1.0 for _ in heat)]
        still = combined(parts, [*[scene.middle] * len(strokes), *loads])
        means = stresses.of(still.moved.forces[:, 0], still.weights)
        if unit is None:
            found += [p for m in means for p in _places(None, m)]
            errors.append(_error(joint, [still], stresses))
            continue
        swing = combined([unit], [scene.travel])
        swings = stresses.of(swing.moved.forces[:, 0], swing.weights)
        found += [p for s, m in zip(swings, means, strict=True) for p in _places(s, m)]
        states = [combined(parts, [end, *loads]) for end in scene.stroke_ends]
        errors.append(_error(joint, states, stresses))
        # what alternates, and what stands, may be of other forces than their sum
        errors += [hinge_error_of(joint, each, stresses) for each in (swing, still)]
    whole, bent = hull(errors), bent_by_gradient(joint, scene)[0]
    if whole is None or bent == 0.0:
        return found, whole
    most = max((place.amplitude + abs(place.mean) for place in found), default=0.0)
    if bent > KNOWN * most:
        return found, None
    return found, whole + ErrorRange(-bent / most, bent / most)


def unsure_swing(joint: SpaceJoint, scene: Scene) -> ErrorRange:
    """Return by what restrained warping may change the largest stress of a stroke alone."""
    body = joint.layout.body(joint.layout.drive.body)
    swing = action(joint.assembly, Acting(scene.travel, np.zeros(6), body.point, np.zeros(3)))
    found = Stresses(joint.assembly).of(swing.moved.forces[:, 0], swing.weights)
    return warping_change(joint.layout.blades, found)


def _places(swing: BladeStress | None, still: BladeStress) -> Iterator[Place]:
    """Yield the places of a blade that may be the worst for some method of the mean stress."""
    sheared = np.abs(still.shear) > 1e-9 * np.abs(still.normal).max(initial=0.0)
    mean = equivalent(still.normal, still.shear)
    mean = np.where((still.normal < 0.0) & ~sheared, -mean, mean)
    amplitude = np.zeros_like(mean) if swing is None else equivalent(swing.normal, swing.shear)
    for place in dict.fromkeys(map(int, worst_places(amplitude, mean))):
        yield Place(
            f"{still.name}, {still.where[place]}", float(amplitude[place]), float(mean[place])
        )


def _error(joint: SpaceJoint, states: list[SpaceState], stresses: Stresses) -> ErrorRange | None:
    """Return the error of the largest stress in states, the worst of them."""
    if not joint.is_known_in_stress:
        return None
    each = [linear_error(joint, state, stresses) for state in states]
    return hull(each)


def state_error(joint: SpaceJoint, state: SpaceState, stress: float) -> ErrorRange | None:
    """Return the error of the largest stress in a state, given that stress [Pa]."""
    stresses = Stresses(joint.assembly)
    here = stresses.of(state.moved.forces[:, 0], state.weights)
    most = max(largest_stress(each) for each in here)
    if most == 0.0:
        return ErrorRange(0.0, 0.0)
    return linear_error(joint, combined([state], [stress / most]), stresses)


def linear_error(
    joint: SpaceJoint, state: SpaceState, stresses: Stresses, change: ErrorRange | None = None
) -> ErrorRange | None:
    """Return the error of the largest stress in a state, ``change`` as of :func:`spring_error`."""
    forces = state.moved.forces[:, 0]
    here = stresses.of(forces, state.weights)
    most = max(largest_stress(each) for each in here)
    if most == 0.0:
        return ErrorRange(0.0, 0.0)
    after = state.following()
    added = stresses.of(forces + after.forces, state.weights)
    second = max(
        float(np.max(np.abs(equivalent(a.normal, a.shear) - equivalent(b.normal, b.shear))))
        for a, b in zip(added, here, strict=True)
    )
    inside = float(stresses.of_moments(after.inside).max())
    more = (second + inside) / (most * max(1.0 - after.buckling, 1.0 - SOFTENED)) + third_order(
        after
    )
    springs = spring_error(joint, state, stresses, change)
    if more > KNOWN or springs is None:
        return None
    off = more / (1.0 - more)
    return springs + warping_change(joint.layout.blades, here) + ErrorRange(-off, off)


def spring_error(
    joint: SpaceJoint, state: SpaceState, stresses: Stresses, change: ErrorRange | None = None
) -> ErrorRange | None:
    """Return the error of the largest stress by the springs' own, and by the kind of sections.

    What small motion leaves out and what restrained warping may be come besides. ``change`` is by
    how much the errors of the springs change the stress, where that is known better than by their
    share of the energy.
    """
    off = spring_change(joint, state)
    around = AROUND_ERROR if any(isinstance(x, SpaceRod) for x in joint.layout.blades) else 0.0
    hinges = hinge_error_of(joint, state, stresses)
    if hinges is None:
        return None
    return (change or ErrorRange(-off, off)) + ErrorRange(-around, 0.0) + hinges


def hinge_error_of(joint: SpaceJoint, state: SpaceState, stresses: Stresses) -> ErrorRange | None:
    """Return the error of the largest stress in a state by what is unsure of hinges."""
    forces, least, most = state.moved.forces[:, 0], 0.0, 0.0
    here = max(map(largest_stress, stresses.of(forces, state.weights)))
    for k, (blade, rows) in enumerate(zip(joint.layout.blades, stresses.rows, strict=True)):
        acting = np.concatenate([forces[6 * k : 6 * k + 6], state.weights[k]])
        found = hinge_range(blade, rows, acting)
        if found is None:
            return None
        least, most = max(least, found[0]), max(most, found[1])
    return ErrorRange(least / here - 1.0, most / here - 1.0) if here else ErrorRange(0.0, 0.0)


def hinge_stress_error(blade: SpaceBlade | SpaceRod) -> ErrorRange | None:
    """Return the relative error of the stress of a blade's section where it is a hinge."""
    error = hinge_error(blade)
    return None if error is None else ErrorRange(*error)


def warping_change(
    blades: Sequence[SpaceBlade | SpaceRod], stresses: list[BladeStress], curled: float = 1.0
) -> ErrorRange:
    """Return the relative error of the largest stress of blades by restrained warping.

    ``curled`` is the share of the most by which their sections may curl.
    """
    own = least = most = 0.0
    for blade, each in zip(blades, stresses, strict=True):
        error = warping_error(blade, curled)
        ends = [equivalent(each.normal + end * each.warping, each.shear) for end in error]
        own = max(own, largest_stress(each))
        least = max(least, float(np.max(np.minimum(*ends), initial=0.0)))
        most = max(most, float(np.max(np.maximum(*ends), initial=0.0)))
    return ErrorRange(min(least / own, 1.0) - 1.0, max(most / own, 1.0) - 1.0) if own else EXACT


def largest_stress(stress: BladeStress) -> float:
    """Return the largest equivalent stress of a blade [Pa]."""
    return float(np.max(equivalent(stress.normal, stress.shear), initial=0.0))


def third_order(after: SecondOrder) -> float:
    """Return the relative change of a linear result by orders beyond the second.

    It is infinite near the buckling of straight blades, or the instability of bodies.
    """
    if max(after.buckling, after.arms) > SOFTENED:
        return inf
    return TURNS * after.rotation**2 + after.axial / STIFFENS


def stiffened_by(joint: SpaceJoint, scene: Scene) -> tuple[float, float]:
    """Return the relative changes of the stiffness along the motion by the loads of a case [-].

    To first order: that of stated loads with its sign, and the largest of those that act either
    way.
    """
    body = joint.layout.body(joint.layout.drive.body)
    unit = action(joint.assembly, Acting(1.0, np.zeros(6), body.point, np.zeros(3))).moved
    along, k, stated, either = unit.coordinates[:, 0], float(unit.drive[0]), 0.0, 0.0
    for each in acting_groups(joint, scene):
        state = action(joint.assembly, each)
        found = stiffened_by_loads(joint.assembly, state.moved, state.loads, along) / k
        if each.acceleration.any():
            either += abs(found)
        else:
            stated += found
    return stated, either


def straight_shares(
    joint: SpaceJoint, scene: Scene, most: float
) -> Iterator[tuple[float, float, float]]:
    """Yield the share of a case's loads that turns straight blades aside, and one that is sure.

    That is at each end of the stroke, the drive locked there, else free, and whichever way loads
    without a direction act. Up to the second share, zero where none is, the linear state tells its
    stress, which no loss of stability leaves near what it was; both are ``most`` at most. The third
    number is what pushes a blade at the first the most, over its area [Pa].
    """
    stresses = Stresses(joint.assembly)
    groups = acting_groups(joint, scene)
    each = list(acting_together(joint, groups, senses(scene, len(groups)), locked=False))
    centre = joint.layout.body(joint.layout.drive.body).point
    for end in dict.fromkeys(scene.stroke_ends):
        stroke = [action(joint.assembly, Acting(end, np.zeros(6), centre, np.zeros(3)))] * bool(end)
        for loads in each:
            buckling = loads.following().buckling
            least = _told_up_to(joint, stroke, combined([loads], [most]), stresses) * most
            share = max(least, min(1.0 / max(buckling, 1e-9), most))
            yield share, least, share * loads.compression


def _told_up_to(
    joint: SpaceJoint, stroke: list[SpaceState], loads: SpaceState, stresses: Stresses
) -> float:
    """Return the largest share of loads, beside a stroke, up to which the linear stress holds."""
    for share in SHARES:
        state = combined([*stroke, loads], [1.0] * len(stroke) + [share])
        if linear_error(joint, state, stresses) is not None:
            return share
    return 0.0


def spring_change(joint: SpaceJoint, state: SpaceState) -> float:
    """Return the relative change of a state's forces by the errors of the springs.

    To first order an error e of a spring changes the forces by no more than e √(its share of the
    energy) in the norm of the energy; its own force besides.
    """
    energy = state.moved.forces[:, 0] * state.moved.deformations[:, 0]
    whole = float(energy.sum())
    if whole <= 0.0:
        return 0.0
    error = np.maximum(-joint.low, joint.high)
    used = energy > 1e-12 * whole
    return 2.0 * float(np.sqrt(np.sum(error[used] ** 2 * energy[used] / whole)))


def hull(errors: Iterable[ErrorRange | None]) -> ErrorRange | None:
    """Return the range that includes all others; None where one is unknown."""
    low, high = 0.0, 0.0
    for error in errors:
        if error is None or not isfinite(error.largest):
            return None
        low, high = min(low, error.low), max(high, error.high)
    return ErrorRange(low, high)
