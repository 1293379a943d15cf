"""The states of a case beside those of a joint that differs a little, by their derivatives."""

from collections.abc import Sequence

from flexcli.engine.joint_models.joint_states import exactly, of_case
from flexcli.mechanics.demand import Held
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.sensitivity import beside
from flexcli.mechanics.state import Equilibrium
from flexcli.parts.requirements import Ask

__all__ = ["states_beside", "trail_of"]

Trail = tuple[Equilibrium, ...]
"""The equilibria that lead to the states of a case, one after the other: these are the last."""


def trail_of(ask: Ask, effects: Effects, tolerance: float, levels: Sequence[int]) -> Trail:
    """Return the exact equilibria of a case's states after those that they start from."""
    solver, found = exactly(effects, tolerance, levels), list[Equilibrium]()

    def keeping(layout: Layout, held: Held, loads: Sequence[Load]) -> Equilibrium:
        found.append(solver(layout, held, loads))
        return found[-1]

    of_case(ask, keeping)
    return tuple(found)


def states_beside(ask: Ask, trail: Trail) -> Equilibrium:
    """Return a case's states by what a small change makes of those of a known joint."""
    known = iter(trail)

    def changed(layout: Layout, held: Held, loads: Sequence[Load]) -> Equilibrium:
        return beside(next(known), layout, held, loads=loads)

    return of_case(ask, changed)
