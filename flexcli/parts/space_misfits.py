"""The stress of joints whose blades miss their seats, by small motion."""

from collections.abc import Iterable, Iterator

import numpy as np

from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.freedoms import misfit
from flexcli.mechanics.space.layout import MissedSeat, SpaceBlade, Vector
from flexcli.mechanics.space.linear import SpaceAssembly
from flexcli.mechanics.space.states import SpaceState, Stresses, misfitted
from flexcli.mechanics.space.stresses import equivalent
from flexcli.parts.geometries import Geometry
from flexcli.parts.requirements.ask import MisfitStress, Told
from flexcli.parts.space_joint import SpaceJoint
from flexcli.parts.space_states import largest_stress, linear_error, spring_error
from flexcli.parts.spring_limits import changed_by_springs
from flexcli.parts.stress_across import ACROSS
from flexcli.results import EXACT, ErrorRange

__all__ = ["guided_about", "misfit_stresses", "worst_misfit"]

UNSTRESSED = 1e-10
"""Stress over that of blades whose bodies were held, below which a missed seat leaves rounding:
bodies that nothing over-constrains follow it freely."""

STRAINED = 1e-12
"""Share of the energy of a state below which a spring has no part in it."""


def guided_about(geometry: Geometry) -> tuple[Vector, ...]:
    """Return the axes of the layout about which a guide keeps the body of a joint from turning."""
    return ((0.0, 0.0, 1.0),) if geometry.is_guided else ()


def misfit_stresses(
    joint: SpaceJoint,
    blades: Iterable[int],
    motion: tuple[float, ...],
    *,
    kept: tuple[Vector, ...] = (),
) -> Iterator[MisfitStress]:
    """Yield the largest stress where each of some blades misses its seat, by small motion.

    Where nothing over-constrains the bodies it is zero, and known. ``motion`` is the offset of the
    seat on its second body at its end, along the axes of the layout [m, rad]; the drive is free,
    but about axes of the layout in ``kept`` the body is guided.
    """
    stresses = Stresses(joint.assembly)
    for blade in blades:
        missed = MissedSeat(blade, np.array(motion))
        state = misfitted(joint.assembly, missed, kept=kept)
        held = misfit(joint.assembly, blade, missed.offset[:, None])
        energy, most = (
            float(joint.assembly.stiffness @ strained[:, 0] ** 2)
            for strained in (state.moved.deformations, held)
        )
        if energy <= UNSTRESSED**2 * most:
            yield MisfitStress(missed, 0.0, "nothing is stressed", EXACT, EXACT)
            continue
        found = stresses.of(state.moved.forces[:, 0], state.weights)
        here = max(found, key=largest_stress)
        springs = whole = None
        if joint.is_known_in_stress or _stays_in_plane(joint, state):
            change = _by_springs(joint, state, missed, kept, stresses)
            springs = spring_error(joint, state, stresses, change)
            whole = linear_error(joint, state, stresses, change)
        place = here.where[int(np.argmax(equivalent(here.normal, here.shear)))]
        where = f"{here.name}, {place}, {stresses.names[blade]} being off"
        yield MisfitStress(missed, largest_stress(here), where, springs, whole)


def _stays_in_plane(joint: SpaceJoint, state: SpaceState) -> bool:
    """Return whether blades of known springs are strained along and across their thickness alone.

    Their nominal stress is that of their springs' forces, however wide they are: it is of sheets
    bent in their own plane, and of torsion, that nobody compared that of wider ones. That of rods
    and hinges is compared as it is known.
    """
    blades = joint.layout.blades
    plain = all(
        isinstance(x, SpaceBlade) and isinstance(x.profile, Constant) and x.profile.h <= x.b
        for x in blades
    )
    if not (joint.is_known and plain and not joint.is_directed):
        return False
    energy = state.moved.forces[:, 0] * state.moved.deformations[:, 0]
    across = energy[: 6 * len(blades)].reshape(-1, 6)[:, ACROSS]
    return bool(across.max() <= STRAINED * energy.sum())


def _by_springs(
    joint: SpaceJoint,
    state: SpaceState,
    missed: MissedSeat,
    kept: tuple[Vector, ...],
    stresses: Stresses,
) -> ErrorRange | None:
    """Return by how much the errors of the springs change the largest stress, see limits."""
    energy = state.moved.forces[:, 0] * state.moved.deformations[:, 0]
    strained = energy[: 6 * len(joint.layout.blades)].reshape(-1, 6) > STRAINED * energy.sum()

    def stress(assembly: SpaceAssembly) -> float:
        one = misfitted(assembly, missed, kept=kept)
        return max(map(largest_stress, stresses.of(one.moved.forces[:, 0], one.weights)))

    return changed_by_springs(joint, np.flatnonzero(strained.any(axis=0)).tolist(), stress)


def worst_misfit(found: Iterable[tuple[Told, str]]) -> tuple[Told, str]:
    """Return the largest of several stresses, and its place.

    Its range is that of the largest of them all, whichever it is: unknown if one of them is.
    """
    each = list(found)
    worst, where = max(each, key=lambda one: one[0].value)
    if worst.value == 0.0 or any(told.error is None for told, _ in each):
        error = None if any(told.error is None for told, _ in each) else EXACT
        return Told(worst.value, error), where
    low, high = (
        max(told.value * (1.0 + told.error[end]) for told, _ in each if told.error is not None)
        for end in (0, 1)
    )
    return Told(worst.value, ErrorRange(low / worst.value - 1.0, high / worst.value - 1.0)), where
