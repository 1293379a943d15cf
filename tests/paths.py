"""The path of one mechanism by arc length, past the points at which its load turns, for tests."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from flexcli.mechanics.assembly import assemble
from flexcli.mechanics.critical_point import arc_weight, steps_of
from flexcli.mechanics.equilibrium import LEVELS, solve
from flexcli.mechanics.inertia_count import inertia_count_of_one
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.prescribed_motion import demand_of
from flexcli.mechanics.state import Equilibrium, Part
from flexcli.numerics.arc_length import follow


class Trace(NamedTuple):
    """Shares of the demand along a path from rest and the equilibria there."""

    share: np.ndarray
    states: tuple[Equilibrium, ...]

    @property
    def turns(self):
        """Return the indices of the points before which the share turned (limit points)."""
        change = np.sign(np.diff(self.share))
        return tuple(int(i) + 1 for i in np.flatnonzero(change[1:] != change[:-1]))


def trace(layout, held, *, loads=(), effects=None, until=None):
    """Return the path from rest to the whole demand, or to where ``until`` holds of a state."""
    effects = Effects() if effects is None else effects
    assembly = assemble(layout, effects, LEVELS[2])
    demand = demand_of(assembly, held, loads)
    rest = solve(layout, dict.fromkeys(held, (None,) * 3))

    def state(x, share):
        part = Part(assembly, demand, np.arange(1), x[None], np.array([share]))
        return replace(rest, effects=effects, reached=part.share, parts=(part,))

    def goal(x, share):
        return share >= 1.0 if until is None else until(state(x, share))

    points = follow(
        steps_of(assembly, demand),
        (np.zeros(assembly.size), 0.0),
        arc_weight(assembly),
        stride=0.02,
        longest=0.2,
        goal=goal,
        kind=lambda x, share: inertia_count_of_one(assembly, demand, x, share),
        tolerance=1e-12,
        most=400,
    )
    assert goal(points[-1].x, points[-1].parameter), "the path is lost"
    return Trace(
        np.array([point.parameter for point in points]),
        tuple(state(point.x, point.parameter) for point in points),
    )
