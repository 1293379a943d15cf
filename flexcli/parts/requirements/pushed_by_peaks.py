"""What bends and pushes blades beside small vibration: stroke, static loads, the peaks themselves.

Modes are those of straight blades without load. A peak that pushes blades softens them on the way,
and one of what would buckle the joint if it stood has no linear response. Blades that are bent give
way along themselves, and a force along them bends them further.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import pi

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.plate_flattening import flat_width, tangent_factor
from flexcli.mechanics.space.planar import from_plane
from flexcli.mechanics.space.states import Acting
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.ends import FREE
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements.ask import Ask
from flexcli.parts.requirements.closed_form import least_blade_force
from flexcli.parts.requirements.shaking import quality_of
from flexcli.parts.scene import IN_PLANE
from flexcli.parts.space_joint import SpaceJoint, joint_in_space
from flexcli.parts.space_states import KNOWN
from flexcli.parts.strained_compliance import BentBeside, bent_beside, shares_beside
from flexcli.parts.structure import MOTIONS, Answer, Structure, largest_of
from flexcli.results import EXACT, ErrorRange

__all__ = [
    "STRAIGHT",
    "axial_share",
    "bent_by_motion",
    "bent_by_stroke",
    "flattened_by_stroke",
    "pushed_by_peaks",
    "pushed_share",
]

Floats = NDArray[np.float64]

NEGLIGIBLE = 1e-6
"""Part of the stress of a peak that is along blades up to which nothing pushes them."""

FREELY = 8.0
"""Times what a force along a bent blade stresses it by that is held across: one that is not."""

STRAIGHT = BentBeside(0.0, 0.0)

ALONE = 4.0
"""Times the load of a blade between guided ends that one bears whose body nothing else holds."""


def pushed_by_peaks(
    ask: Ask, structure: Structure, answer: Answer, others: Sequence[Structure] = ()
) -> ErrorRange | None:
    """Return by what share the peaks of a response change stiffnesses at most, as static loads.

    Nothing where it is not small. ``answer`` gives the peaks of a structure's outputs, those of
    ``others`` that it may be count where they are larger.
    """
    share = pushed_share(ask, structure, answer, others)
    if share == 0.0:
        return EXACT
    return None if share is None or share > KNOWN else ErrorRange(-share, share)


def pushed_share(
    ask: Ask, structure: Structure, answer: Answer, others: Sequence[Structure] = ()
) -> float | None:
    """Return what the peaks of a response are of what buckles the joint, as static loads [-].

    Each component of the wrench on a joint counts by its peak, in either sense, in the plane and
    out of it: what is carried is free but for the joint, whatever ``ends`` a case states. In space
    it is the share of Euler's load of a blade, of joints that are no blades in a plane that of
    :func:`axial_share`.
    """
    if not structure.wrenches:
        return axial_share(ask, structure, answer)
    each_peak = [
        answer(replace(each, outputs={**each.outputs, **_wrench_rows(each)}))
        for each in (structure, *others)
    ]
    if not any(map(_pushes, each_peak)):
        return 0.0
    joint = _joint(ask)
    if joint is None:
        return axial_share(ask, structure, answer)
    peaks = {name: max(one[name] for one in each_peak) for name in each_peak[0]}
    point, alone = joint.layout.body(joint.layout.drive.body).point, ask.scene.without_loads()
    shares = list[float]()
    for name in structure.wrenches:
        groups = [
            Acting(0.0, peaks[f"{name} {k}"] * np.eye(6)[i], point, np.zeros(3))
            for k, i in enumerate(IN_PLANE)
        ]
        shares += shares_beside(joint, alone, groups, driven=True)
    return max(shares)


def _wrench_rows(structure: Structure) -> dict[str, Floats]:
    """Return the rows of each component of the wrenches of a structure, by joint and number."""
    return {
        f"{name} {k}": row[None]
        for name, wrench in structure.wrenches.items()
        for k, row in enumerate(wrench)
    }


def bent_by_motion(ask: Ask, structure: Structure, answer: Answer) -> BentBeside | None:
    """Return what static loads and the peak travel change by bending blades, in space a stroke too.

    Nothing of what moves a mechanism along its own motion alone, where forces are across its
    blades; None where it is not known. In a plane modes are those about a stroke, and in space the
    travel of the peaks is judged by its modes.
    """
    standing, peaks = ask.scene.standing, answer(structure)
    scene = (ask.scene.without_loads() if standing is None else standing).at_assembly()
    in_plane, travel = bool(structure.wrenches), 0.0
    if not (_pushes(peaks) if in_plane else scene.moves or scene.is_loaded):
        return STRAIGHT
    if in_plane:
        scene = scene._replace(travel=0.0, mean_travel=0.0, middle=0.0)
        travel = next((abs(peaks[name]) for name in MOTIONS if name in peaks), 0.0)
        travel *= 1.0 if ask.mechanism is None else ask.mechanism.joint_travel_per_motion
    joint = _joint(ask)
    if joint is None:
        return None
    across = _moves_aside_alone(ask)
    bent = bent_beside(joint, scene, travel, in_plane=in_plane, across=across)
    if not scene.moves:
        return bent
    if not across:  # at resonance of the own motion
        quality = quality_of(ask.mechanism, ask.scene).largest
        bent = bent._replace(stressed=FREELY * quality * bent.stressed)
    return bent if bent.stressed <= KNOWN else None


def _moves_aside_alone(ask: Ask) -> bool:
    """Return whether a base shakes along z, to which no stroke of a joint in a plane answers.

    Its mirror image in that plane is itself, at a stroke too, where its blades stand in it.
    """
    if ask.geometry.in_space or set(ask.scene.shaken_axes) != {"z"}:
        return False
    layout = ask.geometry.blades_layout(ask.material.elastic, ask.sizes)
    return len({float(np.ravel(blade.z)[0]) for blade in layout.blades}) == 1


def bent_by_stroke(ask: Ask) -> float | None:
    """Return by what share more a stroke stresses blades that shake, of a joint in a plane.

    Where no exact beams tell it: of a force along a blade that nothing holds across it, whose lever
    is what stroke and loads bend it by, at resonance of the own motion. None where it is not small,
    and where the body's centre of mass is off the joint's, so that the stroke moves it aside.
    """
    standing, joint, mechanism = ask.scene.standing, _joint(ask), ask.mechanism
    if standing is None or joint is None or ask.geometry.has_masses:
        return None
    if mechanism is None or mechanism.arm or mechanism.joints > 1:
        return None
    quality = quality_of(mechanism, ask.scene).largest
    bent = bent_beside(joint, standing.at_assembly(), in_plane=True)
    share = FREELY * quality * bent.stressed
    return share if share <= KNOWN else None


def flattened_by_stroke(ask: Ask, structure: Structure) -> float:
    """Return by what share a stroke makes a joint in a plane stiffer at most, as curvature does.

    A wide blade that is curved keeps its section from curling, as if all of it were as curved as
    where it is most: by the stress of the stroke in the structure at rest.
    """
    standing = ask.scene.standing
    if standing is None or not standing.moves or structure.motion is None:
        return 0.0
    ratio = 1.0 if ask.mechanism is None else ask.mechanism.joint_travel_per_motion
    travel = max(map(abs, standing.stroke_ends)) / ratio
    still = np.linalg.solve(structure.stiffness, structure.motion) * structure.motion_stiffness
    faces = [
        np.split(rows @ still, 2)
        for name, rows in structure.outputs.items()
        if name.startswith("stress")
    ]
    stress = travel * max(float(np.abs(one - other).max()) / 2.0 for one, other in faces)
    layout, nu = (
        ask.geometry.blades_layout(ask.material.elastic, ask.sizes),
        ask.material.elastic.most_nu,
    )
    beta = 0.0
    for blade in layout.blades:
        h = float(blade.least_thickness)
        curvature = 2.0 * stress / (layout.E * h)
        wide = flat_width(b=float(blade.b), h=h, curvature=curvature, poisson_ratio=nu)
        beta = max(beta, float(wide))
    return float(tangent_factor(beta=beta, poisson_ratio=nu)) - 1.0


def _joint(ask: Ask) -> SpaceJoint | None:
    """Return the joint in space, its blades as far apart as long where nothing says it."""
    geometry, (elastic, *_) = ask.geometry, ask.material.elastic.likely
    try:
        if geometry.in_space:
            return SpaceJoint(geometry.space_layout(elastic, ask.sizes))
        plane, turns = geometry.blades_layout(elastic, ask.sizes), geometry.motion == "rotation"
        return SpaceJoint(from_plane(plane, MOVING, turns=turns, density=0.0))
    except NotAvailable:
        return None


def _pushes(peaks: Mapping[str, float]) -> bool:
    """Return whether a part of the stress that counts is along blades."""
    return largest_of(peaks, "axial") > NEGLIGIBLE * largest_of(peaks, "stress")


def axial_share(ask: Ask, structure: Structure, answer: Answer) -> float | None:
    """Return the peak axial force in a blade over its critical one.

    In a plane that of the case's ``ends``, or where nothing but the joint holds what it carries;
    nothing where no formula has it. In space every blade counts as between guided ends, one alone
    as if its body were free.
    """
    if not structure.wrenches:
        return _share_in_space(ask, structure, answer)
    axial = largest_of(answer(structure), "axial")
    held = ask._replace(scene=ask.scene._replace(ends=ask.scene.ends or FREE))
    try:
        force = axial / float(ask.geometry.axial_stress(1.0, ask.sizes))
        return force / float(least_blade_force(held).force)
    except NotAvailable:
        return None


def _share_in_space(ask: Ask, structure: Structure, answer: Answer) -> float | None:
    """Return the largest peak axial force of a blade over π²EI/l², or over a quarter of it.

    A joint that is several times in a mechanism counts by the least of its blades.
    """
    try:
        joint: SpaceJoint | None = joint_in_space(ask.geometry, ask.material, ask.sizes)
    except NotAvailable:  # no shear modulus, which bending hardly asks for
        joint = _joint(ask)
    if joint is None:
        return None
    assembly = joint.assembly
    least = {
        blade.name: pi**2 * float(member.springs.stiffness[4:].min()) / member.l
        for blade, member in zip(assembly.layout.blades, assembly.members, strict=True)
    }
    axial = {
        name.removeprefix("force "): rows[:, 0]
        for name, rows in structure.outputs.items()
        if name.startswith("force ")
    }
    peaks = answer(replace(structure, outputs=axial))
    alone = ALONE if len(axial) == 1 else 1.0
    weakest = min(least.values())
    return alone * max(peak / least.get(name, weakest) for name, peak in peaks.items())
