"""The best design that can be made: sizes from stock, or multiples of a step.

Where every free size is on such a grid, its points are judged one by one: boxes about the
continuous design grow until one holds a feasible point, then all that could be better is judged.
Where a size stays continuous, or those are too many points, branch and bound decides.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import partial
from math import ceil, floor, log, prod
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.engine import assess
from flexcli.engine.sizing.program import SizingProgram
from flexcli.engine.sizing.rows import ONE, Term, size_of
from flexcli.errors import Outcome
from flexcli.numerics.solution import Solution
from flexcli.parts.sizing import Grid

__all__ = ["StockChoice", "from_stock", "points_about"]

Floats = NDArray[np.float64]

Box: TypeAlias = Mapping[str, tuple[float, float]]

MOST_POINTS = 4_000_000
"""Points judged at the most; at some million a second this takes seconds."""

FIRST_WINDOW, WIDEST_WINDOW = 0.05, 3.0
"""Half-widths of the first and the last box searched about the continuous design, in logarithms."""

SAME = 1e-12
"""Merits closer than this are equal: products of the same sizes, rounded apart."""

HAIR = 1e-9
"""By how much a box is widened, so that rounding leaves no value of its rim out."""

REACH, MOST_BESIDE = 3, 40
"""Steps either way to points that are judged by themselves, and how many of these at the most."""

NEARLY = 0.03
"""Logarithm by which such a point may exceed a row of formulas corrected near by."""

MOST_PROGRAMS, MOST_CURVED = 400, 40
"""Continuous programs solved at the most, and where signomial rows are not all convex: those
need many starts each."""

ON_GRID = 1e-10
"""A size this near (relative) to a value of the grid is on it: far above a solution's rounding,
far below what a check forgives."""

NO_BETTER = 1e-9
"""A program that promises less than this (relative) is not followed."""


@dataclass(frozen=True)
class StockChoice:
    """The best point found, and whether nothing better can be on the grid.

    Without a point, ``proved`` says that the grid has no feasible one. ``judged`` counts points
    and programs.
    """

    x: dict[str, float] | None
    proved: bool
    judged: int


def from_stock(
    program: SizingProgram,
    grids: Mapping[str, Grid],
    goals: Sequence[Term] | None,
    centre: Mapping[str, float],
) -> StockChoice:
    """Return the feasible design whose first goal is least, ties broken by the next goals.

    Without goals it is the one nearest to the centre, by the sum of |ln ratio| of the sizes.
    """
    point = StockChoice(None, False, 0)
    curved = bool(program.curved)
    if set(grids) == set(centre):
        point = _judged_one_by_one(program, grids, goals, centre)
        if point.proved or (point.x is not None and curved):
            return point
    other = _branched(program, grids, goals, centre)
    x = other.x if other.x is not None else point.x
    return StockChoice(x, other.proved, point.judged + other.judged)


def points_about(
    program: SizingProgram,
    grids: Mapping[str, Grid],
    goals: Sequence[Term] | None,
    centre: Mapping[str, float],
) -> list[dict[str, float]]:
    """Return the points of a grid about a design that all but keep the rows, the best first.

    Without goals the nearest first.
    """
    axes = [_values_about(grids[name], centre[name]) for name in program.names]
    points = np.stack([axis.ravel() for axis in np.meshgrid(*axes, indexing="ij")])
    x = dict(zip(program.names, points, strict=True))
    limits = [(term.key, term.sign, term.shift) for term in program.banded()]
    rows = program.at([key for key, *_ in limits], x)
    over = np.max(
        [sign * row + shift for row, (_, sign, shift) in zip(rows, limits, strict=True)], axis=0
    )
    merit = _merits(program, goals, centre, x)[0]
    order = [k for k in np.argsort(merit, kind="stable") if over[k] <= NEARLY]
    return [{name: float(at[k]) for name, at in x.items()} for k in order[:MOST_BESIDE]]


def _values_about(grid: Grid, size: float) -> Floats:
    """Return a few values of a grid about a size."""
    if grid.step is None:
        stock = np.array(sorted(set(grid.stock)))
        return stock[np.argsort(np.abs(np.log(stock / size)))[: 2 * REACH]]
    first = floor(size / grid.step)
    return _sizes(grid, range(max(1, first - REACH), first + REACH + 2))


# -- point by point --------------------------------------------------------------------------


def _judged_one_by_one(
    program: SizingProgram,
    grids: Mapping[str, Grid],
    goals: Sequence[Term] | None,
    centre: Mapping[str, float],
) -> StockChoice:
    merits = partial(_merits, program, goals, centre)
    judged, width = 0, _first_width(grids, centre)
    best: dict[str, float] | None = None
    while best is None and width <= WIDEST_WINDOW:
        best, count = _best_of_box(program, grids, _window(centre, width), merits)
        if count == 0:
            break
        judged, width = judged + count, width * 2.0
    if best is None:
        return StockChoice(None, False, judged)
    reached = float(merits({name: np.array([size]) for name, size in best.items()})[0][0])
    if goals is None:
        box: Box | None = _window(centre, reached)
    else:
        box = _box_of_better(program, goals[0], reached, centre)
    if box is None:
        return StockChoice(best, False, judged)
    better, count = _best_of_box(program, grids, box, merits)
    proved = count > 0 and (goals is None or not program.curved)
    return StockChoice(better or best, proved, judged + count)


def _merits(
    program: SizingProgram,
    goals: Sequence[Term] | None,
    centre: Mapping[str, float],
    x: Mapping[str, Floats],
) -> list[Floats]:
    """Return what decides between points, the less the better: the goals, or their distance."""
    if goals is None:
        return [np.asarray(sum(np.abs(np.log(x[name] / at)) for name, at in centre.items()))]
    y = np.log(np.array([x[name] for name in program.names]))
    return [program.worth(goal, y) for goal in goals]


def _first_width(grids: Mapping[str, Grid], centre: Mapping[str, float]) -> float:
    """Return a half-width that holds a few steps of the coarsest grid, small for fine grids."""
    steps = [grid.step / centre[name] for name, grid in grids.items() if grid.step is not None]
    return min(FIRST_WINDOW, 2.0 * max(steps, default=FIRST_WINDOW))


def _window(centre: Mapping[str, float], width: float) -> Box:
    """Return the box of sizes within a logarithm of those of the centre."""
    factor = float(np.exp(width))
    return {name: (x / factor, x * factor) for name, x in centre.items()}


def _within(grid: Grid, low: float, high: float) -> Sequence[float]:
    """Return the sizes in stock between two, or which multiples of the step lie there.

    Where there is none it is the nearest ones, so that a coarse stock does not make the search miss
    every design.
    """
    low, high = low * (1.0 - HAIR), high * (1.0 + HAIR)
    if grid.step is None:
        stock = sorted(set(grid.stock))
        inside = [size for size in stock if low <= size <= high]
        outside = [s for s in stock if s < low][-1:] + [s for s in stock if s > high][:1]
        return inside or outside
    first, last = sorted((ceil(low / grid.step), floor(high / grid.step)))
    return range(max(1, first), max(1, first, last) + 1)


def _sizes(grid: Grid, places: Sequence[float]) -> Floats:
    """Return sizes in stock as they are, or multiples of a step: the floats nearest to decimals."""
    if grid.step is None:
        return np.array(places)
    step = Decimal(repr(grid.step))
    return np.array([float(step * int(k)) for k in places])


def _best_of_box(
    program: SizingProgram,
    grids: Mapping[str, Grid],
    box: Box,
    merits: Callable[[Mapping[str, Floats]], list[Floats]],
) -> tuple[dict[str, float] | None, int]:
    """Return the best feasible point of a box and how many were judged: none when too many."""
    axes = {name: _within(grid, *box[name]) for name, grid in grids.items()}
    shape = tuple(map(len, axes.values()))
    size = prod(shape)
    if size > MOST_POINTS:
        return None, 0
    values = {name: _sizes(grid, axes[name]) for name, grid in grids.items()}
    found: list[dict[str, Floats]] = []
    for start in range(0, size, assess.CHUNK):
        places = np.unravel_index(np.arange(start, min(start + assess.CHUNK, size)), shape)
        x = {name: values[name][at] for name, at in zip(values, places, strict=True)}
        holds = _holds(program, x)
        if holds.any():
            found.append(_first_by(merits, {name: at[holds] for name, at in x.items()}))
    if not found:
        return None, size
    best = _first_by(merits, {n: np.concatenate([x[n] for x in found]) for n in values})
    return {name: float(at[0]) for name, at in best.items()}, size


def _first_by(
    merits: Callable[[Mapping[str, Floats]], list[Floats]], x: dict[str, Floats]
) -> dict[str, Floats]:
    """Return the one point of least merit, ties decided by the merits that follow."""
    kept = np.arange(next(iter(x.values())).size)
    for merit in merits(x):
        left = merit[kept]
        kept = kept[left <= left.min() + SAME]
    return {name: at[kept[:1]] for name, at in x.items()}


def _holds(program: SizingProgram, x: Mapping[str, Floats]) -> NDArray[np.bool_]:
    """Return which points keep the bounds of the sizes and all limits."""
    geometry = program.problem.design.geometry
    holds = np.ones(next(iter(x.values())).shape, dtype=bool)
    for name, extent in geometry.extents.items():
        if name in x:
            holds &= x[name] >= (extent.least or 0.0)
            holds &= x[name] <= (extent.most or np.inf)
    for margin in assess.margins(program.problem.limits, geometry, program.complete(x)).values():
        holds &= margin >= 1.0 - assess.ROUNDING
    return holds


def _box_of_better(
    program: SizingProgram, goal: Term, best: float, centre: Mapping[str, float]
) -> Box | None:
    """Return the box around the designs whose goal is at most ``best``.

    Around all of them where the rows are signomials, and none where a dimension has no end there
    or an end is only a local optimum. Of rows known as numbers, around those that local searches
    from the centre lead to.
    """
    limits = [*program.banded([goal]), goal._replace(shift=goal.shift - best - HAIR)]
    near = None if program.exact else centre
    box = {}
    for name in program.names:
        ends = []
        for sign in (1.0, -1.0):
            solution = program.least([Term(size_of(name), sign)], limits, (), near)
            sure = solution.certificate == "global" or not program.exact
            if not (solution.converged and sure):
                return None
            ends.append(solution.x[name])
        box[name] = (ends[0], ends[1])
    return box


# -- branch and bound ------------------------------------------------------------------------


Bounds: TypeAlias = dict[str, tuple[float | None, float | None]]


def _branched(
    program: SizingProgram,
    grids: Mapping[str, Grid],
    goals: Sequence[Term] | None,
    centre: Mapping[str, float],
) -> StockChoice:
    """Return the feasible design of least first goal with the given sizes on their grid.

    Each program leaves the grid out and keeps bounds instead; a size off its grid splits it at
    the values on either side. Ties are broken by a second search for the next goal among the
    equally good.
    """
    limits = program.banded(goals or ())
    if goals is None:
        goal, rows = _distance(centre)
        return _search(program, grids, [goal], [*limits, *rows], centre)
    goal, *ties = goals
    first = _search(program, grids, goals, limits, centre)
    if first.x is None or not ties:
        return first
    sizes = np.log([[first.x[name]] for name in program.names])
    reached = float(program.worth(goal, sizes)[0])
    as_good = goal._replace(shift=-reached - NO_BETTER)
    again = _search(program, grids, ties, [*limits, as_good], first.x)
    best = again.x if again.x is not None else first.x
    return StockChoice(best, first.proved, first.judged + again.judged)


def _distance(centre: Mapping[str, float]) -> tuple[Term, list[Term]]:
    """Return the sum of |ln ratio| to the centre as a goal, with the rows that bound each part."""
    goal = Term(ONE, eases=tuple((f"distance of {name}", -1.0) for name in centre))
    rows = [
        Term(size_of(name), sign, -sign * log(at), ((f"distance of {name}", 1.0),))
        for name, at in centre.items()
        for sign in (1.0, -1.0)
    ]
    return goal, rows


def _search(
    program: SizingProgram,
    grids: Mapping[str, Grid],
    goals: Sequence[Term],
    limits: Sequence[Term],
    centre: Mapping[str, float],
) -> StockChoice:
    """Return the best point whose sizes are on their grids, the others continuous."""
    near = None if program.exact else centre
    most = MOST_CURVED if program.exact and program.curved else MOST_PROGRAMS
    best: dict[str, float] | None = None
    least, solved, proved = float("inf"), 0, True
    open_bounds: list[Bounds] = [{}]
    while open_bounds:
        if solved >= most:
            return StockChoice(best, False, solved)
        bounds = open_bounds.pop()
        solved += 1
        relaxed = program.least(goals[:1], [*limits, *_bound_rows(bounds)], (), near)
        proved &= relaxed.outcome in (Outcome.CONVERGED, Outcome.INFEASIBLE)
        proved &= relaxed.certificate == "global"
        if not relaxed.converged or relaxed.objective >= least * (1.0 - NO_BETTER):
            continue
        split = _farthest(relaxed, grids)
        if split is not None:
            open_bounds.extend(_branches(bounds, *split))
            continue
        solved += 1
        sizes = {name: _nearest(grid, relaxed.x[name]) for name, grid in grids.items()}
        equal = [Term(size_of(name), 1.0, -log(size)) for name, size in sizes.items()]
        leaf = program.least(goals, limits, equal, None if near is None else {**near, **sizes})
        if leaf.converged and leaf.objective < least:
            best = {name: leaf.x[name] for name in program.names} | sizes
            least = leaf.objective
    return StockChoice(best, proved, solved)


def _bound_rows(bounds: Bounds) -> list[Term]:
    """Return the rows of further bounds on sizes."""
    found = []
    for name, (low, high) in bounds.items():
        if low is not None:
            found.append(Term(size_of(name), -1.0, log(low)))
        if high is not None:
            found.append(Term(size_of(name), 1.0, -log(high)))
    return found


def _farthest(
    relaxed: Solution, grids: Mapping[str, Grid]
) -> tuple[str, float | None, float | None] | None:
    """Return the size farthest off its grid with the values on either side, if one is off."""
    found: tuple[str, float | None, float | None] | None = None
    farthest = 0.0
    for name, grid in grids.items():
        size = relaxed.x[name]
        below, above = _neighbours(grid, size)
        gaps = [abs(size - side) / size for side in (below, above) if side is not None]
        if min(gaps) > max(farthest, ON_GRID):
            found, farthest = (name, below, above), min(gaps)
    return found


def _branches(
    bounds: Bounds, name: str, below: float | None, above: float | None
) -> Iterator[Bounds]:
    """Yield the bounds on either side of a gap of the grid of one size."""
    low, high = bounds.get(name, (None, None))
    if below is not None:
        yield {**bounds, name: (low, below)}
    if above is not None:
        yield {**bounds, name: (above, high)}


def _neighbours(grid: Grid, size: float) -> tuple[float | None, float | None]:
    """Return the nearest values of the grid at most and at least as large."""
    if grid.step is None:
        stock = sorted(grid.stock)
        below = [s for s in stock if s <= size]
        above = [s for s in stock if s >= size]
        return (below[-1] if below else None), (above[0] if above else None)
    step = Decimal(repr(grid.step))
    multiple = size / grid.step
    first, last = floor(multiple), ceil(multiple)
    return (float(step * first) if first > 0 else None), float(step * max(last, 1))


def _nearest(grid: Grid, size: float) -> float:
    """Return the value of a grid nearest to a size."""
    return min((s for s in _neighbours(grid, size) if s is not None), key=lambda s: abs(s - size))
