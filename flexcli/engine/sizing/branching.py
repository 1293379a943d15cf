"""Branch and bound: the best design with some sizes on a grid and the others continuous."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from math import ceil, floor
from typing import NamedTuple, TypeAlias

from flexcli.engine.sizing.optimum import optimum
from flexcli.engine.sizing.program import SizingProgram
from flexcli.numerics.geometric_program import Outcome, Solution
from flexcli.numerics.ratios import Equality, Ratio, Settled, at_most
from flexcli.numerics.signomial import Signomial, as_signomial, variables
from flexcli.parts.sizing import Grid

__all__ = ["MOST_PROGRAMS", "NO_BETTER", "Bounds", "Branched", "Relaxations", "branch", "search"]

MOST_PROGRAMS, MOST_CURVED = 400, 40
"""Relaxations solved at the most, where all rows are convex and where some are not: the latter
need many starts each."""

ON_GRID = 1e-10
"""A size this near (relative) to a grid value is on it: far above a solution's rounding, far
below what a check forgives."""

NO_BETTER = 1e-9
"""A relaxation that promises less than this (relative) is not followed."""


@dataclass(frozen=True)
class Branched:
    """The best point found; ``proved`` when every branch was followed or shown to be worse."""

    x: dict[str, float] | None
    proved: bool
    solved: int


Bounds: TypeAlias = dict[str, tuple[float | None, float | None]]


def branch(
    program: SizingProgram,
    grids: Mapping[str, Grid],
    objectives: Sequence[Signomial] | None,
    centre: Mapping[str, float],
) -> Branched:
    """Return the feasible design of least first objective with the given sizes on their grid.

    Each relaxation leaves the grid out and keeps bounds instead; a size off its grid splits it
    at the grid values on either side. Ties are broken by a second search for the next objective
    among the equally good. Without objectives the design nearest to the centre is taken, by the
    sum of |ln ratio|, which is a monomial of bounds on each ratio.
    """
    rows: list[Ratio | Settled] = program.banded()
    if objectives is None:
        program, goal, near = _nearness(program, centre)
        return _search(program, grids, [goal], [*rows, *near])
    goal, *ties = objectives
    first = _search(program, grids, objectives, rows)
    if first.x is None or not ties:
        return first
    reached = float(goal.at(**first.x)) * (1.0 + NO_BETTER)
    again = _search(program, grids, ties, [*rows, at_most("as good", goal, reached)])
    best = again.x if again.x is not None else first.x
    return Branched(best, first.proved, first.solved + again.solved)


def _nearness(
    program: SizingProgram, centre: Mapping[str, float]
) -> tuple[SizingProgram, Signomial, list[Ratio | Settled]]:
    goal, rows = as_signomial(1.0), []
    names = {name: f"distance of {name}" for name in program.names}
    for name, distance in names.items():
        x, d = variables(name, distance)
        goal = goal * d
        rows += [
            at_most(f"{name} above", x, centre[name] * d),
            at_most(f"{name} below", centre[name], x * d),
        ]
    return replace(program, names=(*program.names, *names.values())), goal, rows


def _search(
    program: SizingProgram,
    grids: Mapping[str, Grid],
    objectives: Sequence[Signomial],
    rows: Sequence[Ratio | Settled],
) -> Branched:
    def relaxed(bounds: Bounds) -> Solution:
        return optimum(program, objectives[:1], [*rows, *_as_rows(bounds)], ())

    def held(sizes: Mapping[str, float]) -> Solution:
        equal = [
            Equality(f"{name} on its grid", variables(name)[0], as_signomial(size))
            for name, size in sizes.items()
        ]
        return optimum(program, objectives, rows, equal)

    return search(
        grids, Relaxations(relaxed, held, MOST_CURVED if program.curved else MOST_PROGRAMS)
    )


class Relaxations(NamedTuple):
    """The best continuous sizes within further bounds, and with some held; how many to solve."""

    relaxed: Callable[[Bounds], Solution]
    held: Callable[[Mapping[str, float]], Solution]
    most: int


def search(grids: Mapping[str, Grid], solves: Relaxations) -> Branched:
    """Return the best point whose sizes are on their grids, the others continuous."""
    best: dict[str, float] | None = None
    least, solved, proved = float("inf"), 0, True
    open_bounds: list[Bounds] = [{}]
    while open_bounds:
        if solved >= solves.most:
            return Branched(best, False, solved)
        bounds = open_bounds.pop()
        solved += 1
        relaxed = solves.relaxed(bounds)
        proved &= relaxed.outcome in (Outcome.CONVERGED, Outcome.INFEASIBLE)
        proved &= relaxed.certificate == "global"
        if not relaxed.converged or relaxed.objective >= least * (1.0 - NO_BETTER):
            continue
        split = _farthest(relaxed, grids)
        if split is not None:
            open_bounds.extend(_children(bounds, *split))
            continue
        solved += 1
        sizes = {name: _nearest(grid, relaxed.x[name]) for name, grid in grids.items()}
        leaf = solves.held(sizes)
        if leaf.converged and leaf.objective < least:
            best, least = leaf.x | sizes, leaf.objective
    return Branched(best, proved, solved)


def _as_rows(bounds: Bounds) -> Iterator[Ratio | Settled]:
    for name, (low, high) in bounds.items():
        (x,) = variables(name)
        if low is not None:
            yield at_most(f"{name} from", low, x)
        if high is not None:
            yield at_most(f"{name} to", x, high)


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


def _children(
    bounds: Bounds, name: str, below: float | None, above: float | None
) -> Iterator[Bounds]:
    low, high = bounds.get(name, (None, None))
    if below is not None:
        yield {**bounds, name: (low, below)}
    if above is not None:
        yield {**bounds, name: (above, high)}


def _neighbours(grid: Grid, size: float) -> tuple[float | None, float | None]:
    """Return the nearest grid values at most and at least as large."""
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
    return min((s for s in _neighbours(grid, size) if s is not None), key=lambda s: abs(s - size))
