"""The best feasible design that can be made: a search over the manufacturing grid."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from itertools import product

import numpy as np
from numpy.typing import NDArray

from flexcli.engine import assess
from flexcli.engine.optimum import optimum
from flexcli.engine.program import SizingProgram
from flexcli.numerics.ratios import Equality, Ratio, Settled, at_most
from flexcli.numerics.signomial import Signomial, as_signomial, variables
from flexcli.parts.design import DesignSpec
from flexcli.parts.sizing import Grid

__all__ = ["GridPoint", "Merit", "best_on_grid"]

Floats = NDArray[np.float64]
Merit = Callable[[Mapping[str, Floats]], Floats]
"""What the search makes smallest, on arrays of the free dimensions."""

_Best = tuple[float, dict[str, float]] | None

MOST_POINTS = 20_000_000
"""Grid points judged at the most; at some million a second this takes seconds."""

MOST_PROGRAMS = 400
"""Choices of gridded sizes tried when other dimensions stay continuous: a program for each."""

FIRST_WINDOW, WIDEST_WINDOW = 0.05, 3.0
"""Half-widths of the first and the last box searched about the continuous design, in logarithms."""


@dataclass(frozen=True)
class GridPoint:
    """The best point found, and whether nothing better can be on the grid."""

    x: dict[str, float]
    proved: bool
    judged: int


def best_on_grid(
    design: DesignSpec,
    program: SizingProgram,
    grids: Mapping[str, Grid],
    merit: Signomial | Merit,
    centre: Mapping[str, float],
) -> GridPoint | None:
    """Return the feasible grid point of least merit, or nothing when none was found.

    ``merit`` is a signomial (an objective) or a function (the distance from a balanced design).
    Boxes about the continuous design grow until one holds a feasible point. Then everything that
    could be better is judged: for an objective, the box around all feasible designs of smaller
    objective (by two small convex programs per dimension); for a distance, the box of that
    half-width. Where other dimensions stay continuous, each choice on the grid is a program.
    """
    grids = {name: grid for name, grid in grids.items() if name in program.names}
    whole = set(grids) == set(program.names)
    rows = program.banded()
    value = merit if callable(merit) else _evaluate(merit)

    def search(box: Mapping[str, tuple[float, float]]) -> tuple[_Best, int]:
        axes = _axes(grids, box)
        if whole:
            return _judge_points(design, program, axes, value)
        return _judge_programs(program, rows, axes, merit, value)

    judged, width = 0, FIRST_WINDOW
    best: _Best = None
    while best is None and width <= WIDEST_WINDOW:
        best, count = search(_window(centre, width))
        judged, width = judged + count, width * 2.0
    if best is None:
        return None
    box = (
        _window(centre, best[0])
        if callable(merit)
        else _box_of_better(program, rows, merit, best[0])
    )
    if box is None:
        return GridPoint(best[1], False, judged)
    better, count = search(box)
    found = better if better is not None and better[0] <= best[0] else best
    complete = count > 0 and (whole if callable(merit) else not program.curved)
    return GridPoint(found[1], complete, judged + count)


def _evaluate(objective: Signomial) -> Merit:
    return lambda x: np.asarray(objective.at(**x))


def _window(centre: Mapping[str, float], width: float) -> dict[str, tuple[float, float]]:
    factor = float(np.exp(width))
    return {name: (x / factor, x * factor) for name, x in centre.items()}


def _axes(grids: Mapping[str, Grid], box: Mapping[str, tuple[float, float]]) -> dict[str, Floats]:
    """Return the grid values of each dimension in a box (a hair wider, against rounding).

    A dimension without a grid value in the box gets its nearest ones, so that a coarse stock
    does not make the search miss every design.
    """
    return {name: _values(grid, *box[name]) for name, grid in grids.items()}


def _values(grid: Grid, low: float, high: float) -> Floats:
    low, high = low * (1.0 - 1e-12), high * (1.0 + 1e-12)
    if grid.stock:
        stock = np.array(sorted(grid.stock))
        inside = stock[(stock >= low) & (stock <= high)]
        if inside.size:
            return inside
        below, above = stock[stock < low][-1:], stock[stock > high][:1]
        return np.concatenate([below, above])
    assert grid.step is not None  # a grid is a step or a stock
    step = Decimal(repr(grid.step))
    first, last = max(1, int(np.ceil(low / grid.step))), int(np.floor(high / grid.step))
    if first > last:
        first, last = max(1, last), max(1, last) + 1
    if last - first >= MOST_POINTS:
        return np.linspace(low, high, 2)  # too fine to list: the caller sees the size
    return np.array([float(step * k) for k in range(first, last + 1)])


def _size(axes: Mapping[str, Floats]) -> int:
    return int(np.prod([axis.size for axis in axes.values()]))


def _judge_points(
    design: DesignSpec, program: SizingProgram, axes: Mapping[str, Floats], value: Merit
) -> tuple[_Best, int]:
    """Return merit and place of the best feasible point of a box, and how many were judged."""
    size = _size(axes)
    if size > MOST_POINTS:
        return None, 0
    best: _Best = None
    first, *others = axes
    slab = max(1, assess.CHUNK // max(1, size // axes[first].size))
    for start in range(0, axes[first].size, slab):
        grid = np.meshgrid(
            axes[first][start : start + slab], *(axes[n] for n in others), indexing="ij"
        )
        x = {name: values.reshape(-1) for name, values in zip(axes, grid, strict=True)}
        merits = np.where(_feasible(design, program, x), value(x), np.inf)
        at = int(np.argmin(merits))
        if np.isfinite(merits[at]) and (best is None or merits[at] < best[0]):
            best = float(merits[at]), {name: float(values[at]) for name, values in x.items()}
    return best, size


def _feasible(
    design: DesignSpec, program: SizingProgram, x: Mapping[str, Floats]
) -> NDArray[np.bool_]:
    blade = program.complete(dict(x))  # type: ignore[arg-type]
    shape = np.broadcast_shapes(*(np.shape(v) for v in x.values()))
    holds = np.ones(shape, dtype=bool)
    for name, extent in design.geometry.extents.items():
        if name in x:
            holds &= x[name] >= (extent.least or 0.0)
            holds &= x[name] <= (extent.most or np.inf)
    for margin in assess.factors(design, *blade).values():
        holds &= margin >= 1.0 - assess.ROUNDING
    return holds


def _judge_programs(
    program: SizingProgram,
    rows: Sequence[Ratio | Settled],
    axes: Mapping[str, Floats],
    merit: Signomial | Merit,
    value: Merit,
) -> tuple[_Best, int]:
    """Return the best design with some dimensions on their grid and the others optimal.

    The others minimise the objective, or the volume where the merit is a distance.
    """
    size = _size(axes)
    if size > MOST_PROGRAMS:
        return None, 0
    h, l, b = program.blade
    goal = as_signomial(h * l * b) if callable(merit) else merit
    best: _Best = None
    for sizes in product(*axes.values()):
        held = [
            Equality(f"{name} on its grid", variables(name)[0], as_signomial(float(given)))
            for name, given in zip(axes, sizes, strict=True)
        ]
        solution = optimum(program, [goal], rows, held)
        if solution.converged:
            x = {n: solution.x[n] for n in program.names}
            x |= {name: float(given) for name, given in zip(axes, sizes, strict=True)}
            reached = float(value({n: np.asarray(v) for n, v in x.items()}))
            if best is None or reached < best[0]:
                best = reached, x
    return best, size


def _box_of_better(
    program: SizingProgram, rows: Sequence[Ratio | Settled], objective: Signomial, best: float
) -> dict[str, tuple[float, float]] | None:
    """Return the box around all feasible designs whose objective is at most ``best``."""
    better = [*rows, at_most("no worse than the best", objective, best * (1.0 + 1e-9))]
    box = {}
    for name in program.names:
        (x,) = variables(name)
        ends = []
        for goal in (x, 1.0 / x):
            solution = optimum(program, [goal], better, ())
            if not solution.converged:
                return None
            ends.append(solution.x[name])
        box[name] = (ends[0], ends[1])
    return box
