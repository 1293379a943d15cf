"""The best feasible design that can be made: a search over the manufacturing grid."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from math import prod
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine import assess
from flexcli.engine.sizing.branching import Branched, branch
from flexcli.engine.sizing.optimum import optimum
from flexcli.engine.sizing.program import SizingProgram
from flexcli.numerics.ratios import Ratio, Settled, at_most
from flexcli.numerics.signomial import Signomial, variables
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.sizing import Grid

__all__ = ["Box", "GridPoint", "GridTask", "best_on_grid", "posynomial_task"]

Floats = NDArray[np.float64]
Merit = Callable[[Mapping[str, Floats]], Floats]
"""What the search makes smallest, on arrays of the free dimensions."""

Box = Mapping[str, tuple[float, float]]

MOST_POINTS = 4_000_000
"""Grid points judged at the most; at some million a second this takes seconds."""

FIRST_WINDOW, WIDEST_WINDOW = 0.05, 3.0
"""Half-widths of the first and the last box searched about the continuous design, in logarithms."""

SAME = 1e-12
"""Merits closer than this (relative) are equal: products of the same sizes, rounded apart."""

HAIR = 1e-9
"""By how much a box is widened, so that rounding leaves no grid value of its rim out."""


@dataclass(frozen=True)
class GridPoint:
    """The best point found, and whether nothing better can be on the grid.

    Without a point, ``proved`` says that the grid has no feasible one.
    """

    x: dict[str, float] | None
    proved: bool
    judged: int


class GridTask(NamedTuple):
    """What the search on a grid is for.

    ``merits`` are what to make smallest, in order; none stands for the distance from the centre.
    ``better`` bounds all feasible designs whose first merit is at most a value, ``branch`` solves
    with some sizes continuous; ``curved`` where neither can prove anything. ``judged``
    tells that the limits are those by which designs are judged, so that points can be, one by one.
    """

    complete: Callable[[Mapping[str, Floats]], Sizes]
    merits: Sequence[Merit] | None
    better: Callable[[float], Box | None]
    branch: Callable[[], Branched]
    curved: bool
    judged: bool


def best_on_grid(
    design: DesignSpec, grids: Mapping[str, Grid], centre: Mapping[str, float], task: GridTask
) -> GridPoint:
    """Return the feasible grid point of least merit, ties broken by the next merits.

    Without merits it is the one nearest to the centre, by the sum of |ln ratio| of the sizes.
    When every free dimension is on a grid, its points are judged one by one: boxes about the
    centre grow until one holds a feasible point, then everything that could be better is judged.
    When a dimension stays continuous, or that is too many points, branch and bound decides.
    """
    point = GridPoint(None, False, 0)
    if task.judged and set(grids) == set(centre):
        point = _judged_one_by_one(design, grids, centre, task)
        if point.proved or (point.x is not None and task.curved):
            return point
    other = task.branch()
    x = other.x if other.x is not None else point.x
    return GridPoint(x, other.proved, point.judged + other.solved)


def posynomial_task(
    program: SizingProgram,
    grids: Mapping[str, Grid],
    objectives: Sequence[Signomial] | None,
    centre: Mapping[str, float],
) -> GridTask:
    """Return the search for the least objective of a geometric program, or for the nearest."""
    return GridTask(
        program.complete,
        None if objectives is None else [_value(o) for o in objectives],
        lambda best: None if objectives is None else _box_of_better(program, objectives[0], best),
        lambda: branch(program, grids, objectives, centre),
        curved=bool(program.curved),
        judged=True,
    )


def _value(objective: Signomial) -> Merit:
    return lambda x: np.asarray(objective.at(**x))


def _distance(centre: Mapping[str, float]) -> Merit:
    def distance(x: Mapping[str, Floats]) -> Floats:
        return np.asarray(sum(np.abs(np.log(x[name] / at)) for name, at in centre.items()))

    return distance


def _judged_one_by_one(
    design: DesignSpec, grids: Mapping[str, Grid], centre: Mapping[str, float], task: GridTask
) -> GridPoint:
    merits = [_distance(centre)] if task.merits is None else task.merits
    judged, width = 0, _first_width(grids, centre)
    best: dict[str, float] | None = None
    while best is None and width <= WIDEST_WINDOW:
        best, count = _judge(design, task.complete, grids, _window(centre, width), merits)
        if count == 0:
            break
        judged, width = judged + count, width * 2.0
    if best is None:
        return GridPoint(None, False, judged)
    reached = float(merits[0]({name: np.array([size]) for name, size in best.items()}).flat[0])
    box = _window(centre, reached) if task.merits is None else task.better(reached)
    if box is None:
        return GridPoint(best, False, judged)
    better, count = _judge(design, task.complete, grids, box, merits)
    proved = count > 0 and (task.merits is None or not task.curved)
    return GridPoint(better or best, proved, judged + count)


def _first_width(grids: Mapping[str, Grid], centre: Mapping[str, float]) -> float:
    """Return a half-width that holds a few steps of the coarsest grid, small for fine grids."""
    steps = [grid.step / centre[name] for name, grid in grids.items() if grid.step is not None]
    return min(FIRST_WINDOW, 2.0 * max(steps, default=FIRST_WINDOW))


def _window(centre: Mapping[str, float], width: float) -> dict[str, tuple[float, float]]:
    factor = float(np.exp(width))
    return {name: (x / factor, x * factor) for name, x in centre.items()}


@dataclass(frozen=True)
class _Axis:
    """The grid values of one dimension in a box: multiples of a step, or sizes of a stock.

    A box without a grid value gets the nearest ones, so that a coarse stock does not make the
    search miss every design.
    """

    stock: Floats
    step: float
    first: int
    count: int

    @classmethod
    def of(cls, grid: Grid, low: float, high: float) -> "_Axis":
        low, high = low * (1.0 - HAIR), high * (1.0 + HAIR)
        if grid.step is None:
            stock = np.array(sorted(set(grid.stock)))
            inside = stock[(stock >= low) & (stock <= high)]
            if not inside.size:
                inside = np.concatenate([stock[stock < low][-1:], stock[stock > high][:1]])
            return cls(inside, 0.0, 0, inside.size)
        first, last = int(np.ceil(low / grid.step)), int(np.floor(high / grid.step))
        if first > last:
            first, last = last, first
        first = max(1, first)
        return cls(np.empty(0), grid.step, first, max(last, first) - first + 1)

    def values(self) -> Floats:
        """Return the values, each the float nearest to the decimal multiple of the step."""
        if not self.step:
            return self.stock
        step = Decimal(repr(self.step))
        return np.array([float(step * k) for k in range(self.first, self.first + self.count)])


def _judge(
    design: DesignSpec,
    complete: Callable[[Mapping[str, Floats]], Sizes],
    grids: Mapping[str, Grid],
    box: Box,
    merits: Sequence[Merit],
) -> tuple[dict[str, float] | None, int]:
    """Return the best feasible point of a box and how many were judged: none when too many."""
    axes = {name: _Axis.of(grid, *box[name]) for name, grid in grids.items()}
    size = prod(axis.count for axis in axes.values())
    if size > MOST_POINTS:
        return None, 0
    values = {name: axis.values() for name, axis in axes.items()}
    shape = tuple(axis.count for axis in axes.values())
    found: list[dict[str, Floats]] = []
    for start in range(0, size, assess.CHUNK):
        places = np.unravel_index(np.arange(start, min(start + assess.CHUNK, size)), shape)
        x = {name: values[name][at] for name, at in zip(values, places, strict=True)}
        holds = _feasible(design, complete(x), x)
        if holds.any():
            found.append(_first_by(merits, {name: at[holds] for name, at in x.items()}))
    if not found:
        return None, size
    best = _first_by(merits, {n: np.concatenate([x[n] for x in found]) for n in values})
    return {name: float(at[0]) for name, at in best.items()}, size


def _first_by(merits: Sequence[Merit], x: dict[str, Floats]) -> dict[str, Floats]:
    """Return the one point of least merit, ties decided by the merits that follow."""
    for merit in merits:
        value = np.broadcast_to(merit(x), next(iter(x.values())).shape)
        least = value.min()
        x = {name: at[value <= least + SAME * abs(least)] for name, at in x.items()}
    return {name: at[:1] for name, at in x.items()}


def _feasible(design: DesignSpec, sizes: Sizes, x: Mapping[str, Floats]) -> NDArray[np.bool_]:
    holds = np.ones(next(iter(x.values())).shape, dtype=bool)
    for name, extent in design.geometry.extents.items():
        if name in x:
            holds &= x[name] >= (extent.least or 0.0)
            holds &= x[name] <= (extent.most or np.inf)
    for margin in assess.factors(design, **sizes._asdict()).values():
        holds &= margin >= 1.0 - assess.ROUNDING
    return holds


def _box_of_better(
    program: SizingProgram, objective: Signomial, best: float
) -> dict[str, tuple[float, float]] | None:
    """Return the box around all feasible designs whose objective is at most ``best``.

    Nothing where a dimension has no end there, or where an end is only a local optimum.
    """
    better: list[Ratio | Settled] = [
        *program.banded(), at_most("no worse than the best", objective, best * (1.0 + HAIR))
    ]  # fmt: skip
    box = {}
    for name in program.names:
        (x,) = variables(name)
        ends = []
        for goal in (x, 1.0 / x):
            solution = optimum(program, [goal], better, ())
            if not solution.converged or solution.certificate != "global":
                return None
            ends.append(solution.x[name])
        box[name] = (ends[0], ends[1])
    return box
