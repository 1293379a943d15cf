"""The stress of joints whose blades miss their seats, beyond small motion: beams, or shells."""

from collections.abc import Callable, Iterator, Sequence
from math import inf
from typing import NamedTuple

import numpy as np

from flexcli.engine.joint_models.space_deflection import load_error, unsure_springs
from flexcli.engine.joint_models.space_stroke import BEAMS, Blades, held_motion
from flexcli.errors import SolveError
from flexcli.formulas.amplified import FURTHER, amplified, bent_by_forces
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium, solve
from flexcli.mechanics.space.layout import MissedSeat
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask, MisfitStress, Told
from flexcli.parts.space_joint import SpaceJoint, joint_in_space
from flexcli.results import ErrorRange

__all__ = ["StressModel", "misfit_stresses"]

SMALL = 1e-3
"""Share of an offset under which the stress is that of small motion."""


class StressModel(NamedTuple):
    """What blades are made of, and how the stress of an equilibrium of them is told [Pa].

    ``largest`` gives the largest and the blade that has it, ``unsure`` how unsure it is besides,
    relative.
    """

    blades: Blades
    largest: Callable[[SpaceEquilibrium], tuple[float, str]]
    unsure: Callable[[SpaceEquilibrium, float], ErrorRange]


def misfit_stresses(
    ask: Ask, small: Sequence[MisfitStress], model: StressModel
) -> Iterator[tuple[Told, str]]:
    """Yield the largest stress of each missed seat, off either way, and its place.

    By beams it is that of small motion by its best springs, times what the size of the offset
    changes; by shells it is their own.

    Raises
    ------
    NotAvailable
        Where the joint has no stable equilibrium under one of the offsets.

    """
    for one in small:
        for sense in (1.0, -1.0) if one.stress > 0.0 else (1.0,):
            if one.stress == 0.0:
                yield Told(0.0, one.error), one.where
            elif model.blades is BEAMS:
                yield _by_beams(ask, one, sense, model)
            else:
                yield _by_itself(ask, one, sense, model)


def _by_beams(ask: Ask, small: MisfitStress, sense: float, model: StressModel) -> tuple[Told, str]:
    """Return the stress of small motion times what beams say that the size of the offset changes.

    That is as sure as what the size of a load changes of a deflection, and as the springs are.
    """
    state, first = (_off(ask, small.missed.times(sense * share), model) for share in (1.0, SMALL))
    largest, blade = model.largest(state)
    ratio = largest * SMALL / model.largest(first)[0]
    where = small.where if ratio == 1.0 else f"{blade}, {_being_off(state, small)}"
    value, more = small.stress * ratio, abs(ratio - 1.0)
    bent = _bent(ask, small, sense, model, largest)
    if small.springs is None or bent is None:
        return Told(value, None), where
    try:
        share = max(load_error(ask), unsure_springs(_joint(ask))) + small.springs.largest
    except SolveError as error:
        raise NotAvailable(f"has no errors by beams: {error}") from error
    off = amplified(max(bent, more * (1.0 + more) / ratio), share)
    if off == inf:
        return Told(value, None), where
    besides = small.springs + model.unsure(state, largest)
    return Told(value, besides + ErrorRange(-off, off)), where


def _by_itself(ask: Ask, small: MisfitStress, sense: float, model: StressModel) -> tuple[Told, str]:
    """Return the stress of shells."""
    state = _off(ask, small.missed.times(sense), model)
    largest, blade = model.largest(state)
    known, told = model.blades.errors(state), Told(largest, None)
    bent = _bent(ask, small, sense, model, largest)
    if known is not None and state.coarser is not None and bent is not None:
        change = abs(model.largest(state.coarser)[0] / largest - 1.0)
        off = known.stress_of(bent) + change
        besides = model.unsure(state, largest) + ErrorRange(-off, off)
        told = Told(largest, besides if off < inf else None)
    return told, f"{blade}, {_being_off(state, small)}"


def _bent(
    ask: Ask, small: MisfitStress, sense: float, model: StressModel, largest: float
) -> float | None:
    """Return what share of the largest stress an offset makes by bending what it has bent.

    Nothing where a little more of it buckles the joint.
    """
    try:
        further = _off(ask, small.missed.times(sense * (1.0 + FURTHER)), model)
    except NotAvailable:
        return None
    each = (0.0, largest, model.largest(further)[0])
    rest, here, more = map(np.array, each)
    return float(bent_by_forces(rest, None, here, more))


def _joint(ask: Ask) -> SpaceJoint:
    return joint_in_space(ask.geometry, ask.material, ask.sizes)


def _off(ask: Ask, missed: MissedSeat, model: StressModel) -> SpaceEquilibrium:
    """Return the joint with a seat that is off, its drive free and its guide held."""
    layout, blades = _joint(ask).layout, model.blades
    try:
        found = solve(
            layout, held_motion(ask, layout), frames=drive_frame(layout.drive), missed=missed,
            tolerance=blades.tolerance, levels=blades.levels, made=blades.made,
        ).checked()  # fmt: skip
    except SolveError as error:
        raise NotAvailable(f"has no equilibrium with its seat off: {error}") from error
    if found.unstable:
        raise NotAvailable("buckles with its seat off")
    return found


def _being_off(state: SpaceEquilibrium, small: MisfitStress) -> str:
    return f"{state.layout.blades[small.missed.blade].name} being off"
