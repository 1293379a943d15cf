"""What loads and heat bend in a joint of the plane, by exact beams under a little more of them."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.joint_states import Solver, of_case
from flexcli.formulas.amplified import FURTHER, bent_part
from flexcli.mechanics.demand import Held
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.own_weight import POINTS
from flexcli.mechanics.state import Equilibrium
from flexcli.mechanics.stresses import blade_stress
from flexcli.numerics.rows import Number, larger, largest_of_each, states_of
from flexcli.parts.requirements import Ask

__all__ = ["bent_in_plane"]

Floats = NDArray[np.float64]

ROUNDING = 1e-9
"""Strain under which what is bent is rounding."""


def bent_in_plane(ask: Ask, states: Equilibrium, solver: Solver[Equilibrium]) -> Number:
    """Return what share of the largest stress loads and heat make by bending what is deformed [-].

    It is found place by place at both faces of each blade, of ``states`` of a case.

    Raises
    ------
    NotAvailable
        When a little more of them buckles the joint.

    """
    further = of_case(ask, _with_share(solver, 1.0 + FURTHER))
    rest = of_case(ask, _with_share(solver, 0.0)) if ask.scene.moves else None
    bent: Number = 0.0
    most: Number = ROUNDING * states.layout.E
    for blade in states.layout.blades:
        here, more = (blade_stress(each, blade.name, POINTS) for each in (states, further))
        before = None if rest is None else blade_stress(rest, blade.name, POINTS)
        for face in ("left", "right"):
            now, then = (states_of(getattr(each, face)) for each in (here, more))
            none = 0.0 * now if before is None else states_of(getattr(before, face))
            bent = larger(bent, largest_of_each(bent_part(none, now, then)))
            most = larger(most, largest_of_each(np.abs(now)))
    return bent / most


def _with_share(solver: Solver[Equilibrium], share: float) -> Solver[Equilibrium]:
    """Return a solver of joints that have a share of their loads and of what heat strains."""

    def solve(layout: Layout, held: Held, loads: Sequence[Load]) -> Equilibrium:
        return solver(layout.grown(share), held, [load.times(share) for load in loads])

    return solve
