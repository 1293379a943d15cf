"""Equilibria along a stroke or a load, past the points at which the load turns."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.assembly import Assembly, assemble, at_nodes, finer
from flexcli.mechanics.demand import Demand, Held
from flexcli.mechanics.equilibrium import LEVELS, difference, solve
from flexcli.mechanics.inertia_count import inertia_count_of_one
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.prescribed_motion import demand_of
from flexcli.mechanics.state import Equilibrium, Outcome, Part
from flexcli.numerics.arc_length import Steps, correct_on, follow

__all__ = ["Trace", "arc_weight", "state_of", "steps_of", "sweep", "trace"]

Floats = NDArray[np.float64]

_TOLERANCE = 1e-12
_FIRST, _LONGEST, _MOST = 0.02, 0.2, 400


@dataclass(frozen=True, eq=False)
class Trace:
    """A path by arc length: shares λ of the demand and the equilibria there.

    ``complete`` is false when the path was lost or is longer than the most points allowed.
    """

    share: Floats
    states: tuple[Equilibrium, ...]
    complete: bool

    @property
    def turns(self) -> tuple[int, ...]:
        """Return the indices of the points before which λ turned (limit points)."""
        change = np.sign(np.diff(self.share))
        return tuple(int(i) + 1 for i in np.flatnonzero(change[1:] != change[:-1]))


def sweep(
    layout: Layout,
    held: Callable[[float], Held],
    shares: Sequence[float],
    *,
    loads: Callable[[float], Sequence[Load]] = lambda _: (),
    effects: Effects | None = None,
    tolerance: float = 1e-9,
) -> tuple[Equilibrium, ...]:
    """Return the equilibria at shares of a stroke, each reached from the one before.

    Parameters
    ----------
    layout : Layout
        The mechanism, or a batch of them.
    held, loads : callable
        Give motions held and loads at a share; those may run along any path.
    shares : sequence of float
        Shares, in the order of travel.
    effects, tolerance
        As in :func:`flexcli.mechanics.equilibrium.solve`.

    Returns
    -------
    tuple of Equilibrium
        One for each share.

    """
    states: list[Equilibrium] = []
    for share in shares:
        states.append(
            solve(
                layout,
                held(share),
                loads=loads(share),
                effects=effects,
                tolerance=tolerance,
                start=states[-1] if states else None,
            )
        )
    return tuple(states)


def trace(
    layout: Layout,
    held: Held | None = None,
    *,
    loads: Sequence[Load] = (),
    effects: Effects | None = None,
    until: Callable[[Equilibrium], bool] | None = None,
    most: int = _MOST,
) -> Trace:
    """Return the path of one mechanism from rest by arc length, while its demand grows and turns.

    Parameters
    ----------
    layout : Layout
        One mechanism (not a batch).
    held, loads, effects
        The demand at λ = 1, as in :func:`flexcli.mechanics.equilibrium.solve`.
    until : callable, optional
        Ends the path where it holds of an equilibrium; by default where λ ≥ 1.
    most : int
        Most points.

    Returns
    -------
    Trace
        The points, each computed twice, with its error.

    """
    effects = Effects() if effects is None else effects
    coarse = assemble(layout, effects, LEVELS[1])
    fine = at_nodes(coarse, LEVELS[2])
    demand = demand_of(coarse, {} if held is None else held, loads)
    refined: list[Equilibrium] = []

    def far_enough(x: Floats, share: float) -> bool:
        if until is None:
            return share >= 1.0
        part = Part(coarse, demand, np.arange(1), x[None], np.array([share]))
        return until(state_of(layout, effects, part, np.inf, 0))

    points = follow(
        steps_of(coarse, demand),
        (np.zeros(coarse.size), 0.0),
        arc_weight(coarse),
        stride=_FIRST,
        longest=_LONGEST,
        goal=far_enough,
        kind=lambda x, share: inertia_count_of_one(coarse, demand, x, share),
        tolerance=_TOLERANCE,
        most=most,
    )
    dense = np.zeros(fine.size)
    dense[fine.turns + 3 * fine.blades :] = 1.0
    for point in points:
        plane = point._replace(
            x=finer(coarse, fine, point.x[None])[0],
            tangent=finer(coarse, fine, point.tangent[None])[0],
            weight=dense,
        )
        found = correct_on(plane, steps_of(fine, demand), _TOLERANCE)
        if found is None:
            break
        x, share, count = found
        error = difference(coarse, fine, point.x[None], x[None], np.zeros(1))
        part = Part(fine, demand, np.arange(1), x[None], np.array([share]))
        refined.append(state_of(layout, effects, part, float(error[0]), count))
    complete = len(refined) == len(points) and far_enough(points[-1].x, points[-1].parameter)
    return Trace(np.array([float(s.parts[0].share[0]) for s in refined]), tuple(refined), complete)


def arc_weight(assembly: Assembly) -> Floats:
    """Return the weights in arc length: rotations in the mean, motions, no forces."""
    weight = np.zeros(assembly.size)
    weight[: assembly.turns] = 1.0 / assembly.turns
    weight[assembly.turns + 3 * assembly.blades :] = 1.0
    return weight


def steps_of(assembly: Assembly, demand: Demand) -> Steps:
    """Return the steps of one mechanism for following its path by arc length."""

    def steps(x: Floats, share: float) -> tuple[Floats, Floats]:
        step, rate = assembly.steps(x[None], np.array([share]), np.arange(1), demand)
        return step[0], rate[0]

    return steps


def state_of(
    layout: Layout, effects: Effects, part: Part, error: float, iterations: int
) -> Equilibrium:
    """Return a point of a path as an equilibrium."""
    return Equilibrium(
        layout=layout,
        effects=effects,
        outcome=(Outcome.CONVERGED,),
        reached=part.share,
        iterations=np.array([iterations], dtype=np.intp),
        estimated_error=np.array([error]),
        nodes=np.array([part.assembly.nodes], dtype=np.intp),
        seconds=0.0,
        parts=(part,),
    )
