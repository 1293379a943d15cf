"""Prescribed motions and loads of a solution, blended from what holds where its path starts."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.assembly import Assembly
from flexcli.mechanics.demand import (
    Demand,
    Force,
    Held,
    forces_of,
    held_of,
    springs_of,
    weights_of,
)
from flexcli.mechanics.layout import Load, Number
from flexcli.mechanics.state import Equilibrium

__all__ = ["demand_of", "designs_of"]

Integers = NDArray[np.intp]


def designs_of(assembly: Assembly, demand: Demand) -> int:
    """Return the number of designs of the whole: the longest first axis of any number."""
    arrays = [demand.after, demand.before]
    for force in demand.forces:
        arrays += [force.arm, force.force, force.moment, force.before, force.after]
    for spring in demand.springs:
        arrays += [spring.arm, spring.stiffness]
    (designs,) = np.broadcast_shapes((assembly.designs,), *{a.shape[:1] for a in arrays})
    return int(designs)


def demand_of(
    assembly: Assembly,
    held: Held,
    loads: Sequence[Load],
    load_factor: Number = 1.0,
    start: Equilibrium | None = None,
) -> Demand:
    """Return the prescribed motions and loads, blended from what holds at the start."""
    layout, length, force = assembly.layout, assembly.length, assembly.force
    index, free, after = held_of(layout, held, length)
    own = (*layout.loads, *weights_of(layout))
    forces = forces_of(layout, own, length, force)
    forces += forces_of(layout, loads, length, force, load_factor)
    springs = springs_of(layout, length, force)
    if start is None:
        return Demand(index, free, np.zeros_like(after), after, forces, springs)
    flat = start.motions / np.stack([length, length, np.ones_like(length)], axis=-1)[:, None]
    before = flat.reshape(flat.shape[0], -1)[:, index]
    forces = (*_released(assembly, start, free), *forces)
    return Demand(index, free, before, after, forces, springs, grown=True)


def _released(assembly: Assembly, start: Equilibrium, free: Integers) -> tuple[Force, ...]:
    """Return the loads and reactions of the start, to be taken away along the path."""
    one, nothing = np.ones(1), np.zeros(1)
    shares = start.scatter([part.share for part in start.parts])
    gone = [
        f._replace(before=f.before + shares * (f.after - f.before), after=nothing)
        for f in start.parts[0].demand.forces
    ]
    unit = assembly.force[:, None] * np.stack(
        [np.ones_like(assembly.length)] * 2 + [assembly.length], axis=-1
    )
    reactions = (start.reactions / unit[:, None]).reshape(start.designs, -1)
    freed = np.zeros(reactions.shape[1], dtype=bool)
    freed[free] = True
    reactions = np.where(freed, reactions, 0.0)
    for body in range(assembly.bodies):
        pull = reactions[:, 3 * body : 3 * body + 3]
        if np.any(pull != 0.0):
            arm = np.zeros((1, 2))
            gone.append(Force(body, arm, pull[:, :2], pull[:, 2], False, one, nothing))
    return tuple(gone)
