"""What the forces of a vibration's peaks change of the stiffness of a joint, as if they stood.

Modes are those of blades without load. A peak that pushes blades softens them on the way, and one
of what would buckle the joint if it stood has no linear response.
"""

from collections.abc import Mapping
from dataclasses import replace
from math import pi

import numpy as np

from flexcli.mechanics.space.states import Acting
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.ends import FREE
from flexcli.parts.requirements.ask import Ask
from flexcli.parts.requirements.closed_form import least_blade_force
from flexcli.parts.scene import IN_PLANE
from flexcli.parts.space_joint import joint_in_space
from flexcli.parts.space_states import KNOWN
from flexcli.parts.strained_compliance import shares_beside
from flexcli.parts.structure import Answer, Structure
from flexcli.results import EXACT, ErrorRange

__all__ = ["axial_share", "pushed_by_peaks", "pushed_share"]

NEGLIGIBLE = 1e-6
"""Part of the stress of a peak that is along blades up to which nothing pushes them."""

ALONE = 4.0
"""Times the load of a blade between guided ends that one bears whose body nothing else holds."""


def pushed_by_peaks(ask: Ask, structure: Structure, answer: Answer) -> ErrorRange | None:
    """Return by what share the peaks of a response change stiffnesses at most, as static loads.

    Nothing where it is not small. ``answer`` gives the peaks of a structure's outputs.
    """
    share = pushed_share(ask, structure, answer)
    if share == 0.0:
        return EXACT
    return None if share is None or share > KNOWN else ErrorRange(-share, share)


def pushed_share(ask: Ask, structure: Structure, answer: Answer) -> float | None:
    """Return what the peaks of a response are of what buckles the joint, as static loads [-].

    Each component of the wrench on a joint counts by its peak, in either sense, in the plane and
    out of it: what is carried is free but for the joint, whatever ``ends`` a case states. In space
    it is the share of Euler's load of a blade, in the plane without a shear modulus that of
    :func:`axial_share`.
    """
    if not structure.wrenches:
        return axial_share(ask, structure, answer)
    if not _pushes(answer(structure)):
        return 0.0
    try:
        joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
    except NotAvailable:
        return axial_share(ask, structure, answer)
    rows = {
        f"{name} {k}": row[None]
        for name, wrench in structure.wrenches.items()
        for k, row in enumerate(wrench)
    }
    peaks = answer(replace(structure, outputs=rows))
    point, alone = joint.layout.body(joint.layout.drive.body).point, ask.scene.without_loads()
    shares = list[float]()
    for name in structure.wrenches:
        groups = [
            Acting(0.0, peaks[f"{name} {k}"] * np.eye(6)[i], point, np.zeros(3))
            for k, i in enumerate(IN_PLANE)
        ]
        shares += shares_beside(joint, alone, groups, driven=True)
    return max(shares)


def _pushes(peaks: Mapping[str, float]) -> bool:
    """Return whether a part of the stress that counts is along blades."""
    along = max((p for name, p in peaks.items() if name.startswith("axial")), default=0.0)
    return along > NEGLIGIBLE * max(
        (p for name, p in peaks.items() if name.startswith("stress")), default=0.0
    )


def axial_share(ask: Ask, structure: Structure, answer: Answer) -> float | None:
    """Return the peak axial force in a blade over its critical one.

    In a plane that of the case's ``ends``, or where nothing but the joint holds what it carries;
    nothing where no formula has it. In space every blade counts as between guided ends, one alone
    as if its body were free.
    """
    if not structure.wrenches:
        return _share_in_space(ask, structure, answer)
    peaks = answer(structure)
    axial = max((p for name, p in peaks.items() if name.startswith("axial")), default=0.0)
    held = ask._replace(scene=ask.scene._replace(ends=ask.scene.ends or FREE))
    try:
        force = axial / float(ask.geometry.axial_stress(1.0, ask.sizes))
        return force / float(least_blade_force(held).force)
    except NotAvailable:
        return None


def _share_in_space(ask: Ask, structure: Structure, answer: Answer) -> float:
    """Return the largest peak axial force of a blade over π²EI/l², or over a quarter of it.

    A joint that is several times in a mechanism counts by the least of its blades.
    """
    assembly = joint_in_space(ask.geometry, ask.material, ask.sizes).assembly
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
