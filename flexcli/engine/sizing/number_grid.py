"""The search on the manufacturing grid by limits that are numbers."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import log

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.sizing.branching import (
    MOST_PROGRAMS,
    NO_BETTER,
    Bounds,
    Branched,
    Relaxations,
    search,
)
from flexcli.engine.sizing.grid import Box, GridTask, Merit
from flexcli.engine.sizing.number_optimum import optimum
from flexcli.engine.sizing.number_rows import NumberSizing, Term
from flexcli.numerics.geometric_program import Solution
from flexcli.numerics.log_stencil import Field
from flexcli.parts.sizing import Grid

__all__ = ["number_task"]

Floats = NDArray[np.float64]

SMOOTH = 1e-2
"""Distance, in logarithms, within which the sum is rounded off at the centre."""


def number_task(
    sizing: NumberSizing,
    grids: Mapping[str, Grid],
    objectives: Sequence[Term] | None,
    centre: Mapping[str, float],
) -> GridTask:
    """Return the search for the least objective, or without one for the nearest to the centre."""

    def merit(goal: Term) -> Merit:
        return lambda x: sizing.value(goal, x)

    return GridTask(
        sizing.complete,
        None if objectives is None else [merit(goal) for goal in objectives],
        lambda best: None if objectives is None else _better(sizing, objectives[0], best, centre),
        lambda: _branch(sizing, grids, objectives, centre),
        curved=True,
        judged=sizing.closed,
    )


def _better(
    sizing: NumberSizing, goal: Term, best: float, centre: Mapping[str, float]
) -> Box | None:
    """Return the box around the better designs that local searches from the centre lead to."""
    limits = [*sizing.banded(), goal._replace(shift=-log(best * (1.0 + NO_BETTER)))]
    box = {}
    for name in sizing.names:
        ends = [
            optimum(sizing, [Term(f"size {name}", sign)], limits, (), centre)
            for sign in (1.0, -1.0)
        ]
        if not all(end.converged for end in ends):
            return None
        box[name] = (ends[0].x[name], ends[1].x[name])
    return box


def _branch(
    sizing: NumberSizing,
    grids: Mapping[str, Grid],
    objectives: Sequence[Term] | None,
    centre: Mapping[str, float],
) -> Branched:
    if objectives is None:
        return _search(_with_distance(sizing, centre), grids, [Term("distance")], (), centre)
    goal, *ties = objectives
    first = _search(sizing, grids, objectives, (), centre)
    if first.x is None or not ties:
        return first
    reached = float(sizing.value(goal, {n: np.array([x]) for n, x in first.x.items()})[0])
    as_good = goal._replace(shift=-log(reached * (1.0 + NO_BETTER)))
    again = _search(sizing, grids, ties, (as_good,), first.x)
    return Branched(again.x or first.x, False, first.solved + again.solved)


def _search(
    sizing: NumberSizing,
    grids: Mapping[str, Grid],
    objectives: Sequence[Term],
    further: Sequence[Term],
    near: Mapping[str, float],
) -> Branched:
    limits = [*sizing.banded(), *further]

    def relaxed(bounds: Bounds) -> Solution:
        return optimum(sizing, objectives[:1], [*limits, *sizing.between(bounds)], (), near)

    def held(sizes: Mapping[str, float]) -> Solution:
        equal = [Term(f"size {name}", 1.0, -log(size)) for name, size in sizes.items()]
        return optimum(sizing, objectives, limits, equal, {**near, **sizes})

    return search(grids, Relaxations(relaxed, held, MOST_PROGRAMS))


def _with_distance(sizing: NumberSizing, centre: Mapping[str, float]) -> NumberSizing:
    """Return the rows with the smoothed sum of |ln ratio| to the centre as a further goal."""
    middle = np.log([centre[name] for name in sizing.names])[:, None]

    def with_distance(field: Field) -> Field:
        def rows(y: Floats) -> Floats:
            away = np.sqrt((y - middle) ** 2 + SMOOTH**2).sum(axis=0)
            return np.vstack([field(y), away])

        return rows

    base = with_distance(sizing.base) if sizing.base is not None else None
    keys = (*sizing.keys, "distance")
    return replace(sizing, keys=keys, evaluate=with_distance(sizing.evaluate), base=base)
