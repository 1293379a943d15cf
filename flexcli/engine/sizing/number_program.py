"""A design as rows of numbers: limits, bounds and objectives over the logarithms of the sizes."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from math import log
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.sizing.number_rows import NumberSizing, Term
from flexcli.engine.sizing.program import Row, bounds_of
from flexcli.errors import NoSolution
from flexcli.numerics.log_stencil import Field
from flexcli.numerics.log_utilisation import log_utilisation
from flexcli.parts.design import DesignSpec
from flexcli.parts.requirements import Limit
from flexcli.parts.sizing import Objective

__all__ = ["LimitsOf", "goal_of", "number_sizing", "one_by_one"]

Floats = NDArray[np.float64]

LimitsOf: TypeAlias = Callable[[Mapping[str, Floats]], list[Limit]]
"""The limits of a design at many sizes: arrays by symbol, all of one length."""

WORLD = (1e-10, 1e4)
"""Sizes [m] beyond which a dimension has run away."""
LIKELY = (1e-4, 1e-1)
"""Sizes [m] between which a first design is looked for where nothing bounds it."""

TRIALS, ENOUGH = 500, 8
"""Designs tried for a first one, and those after which the one of most numbers is taken."""

GOALS = ("volume", "k_pivot")
"""Quantities that can be least, beside the sizes."""


def number_sizing(
    design: DesignSpec, limits_of: LimitsOf | None = None, *, base: LimitsOf | None = None,
    starts: Iterable[Mapping[str, float]] = (), noise: float = 1e-14,
) -> NumberSizing:  # fmt: skip
    """Return the rows of a design by the given limits, its closed forms if none are given.

    Parameters
    ----------
    design : DesignSpec
        The design whose free dimensions are chosen.
    limits_of : callable, optional
        Its limits at many sizes, always the same ones in the same order.
    base : callable, optional
        A cheaper model's limits, one for one: these are then corrected to the true ones.
    starts : iterable of mapping
        Free sizes [m] to start from instead of a search between the bounds.
    noise : float
        Relative error [-] of the limits' numbers that changes from design to design.

    Returns
    -------
    NumberSizing
        The rows of limits and bounds, and the objectives.

    Notes
    -----
    Limits are smooth in the sizes: where a demand is the largest of several, each is a limit of
    its own. Outside the domain of the model its numbers are NaN.

    """
    names = design.geometry.free
    of = limits_of or (lambda sizes: design.closed_limits(design.geometry.sized(sizes)))
    given = tuple(starts)
    probe = {n: np.full(1, given[0][n]) for n in names} if given else _probe(design, of)
    asked = {f"{index} {limit.name}": limit for index, limit in enumerate(of(probe))}
    bounds = bounds_of(design, dict(probe))
    quantities = _quantities(design)
    low, high = (np.full(len(names), np.log(end)) for end in WORLD)
    return NumberSizing(
        names=names,
        sizes=design.geometry.sized(probe),
        constraints=(*(k for k, limit in asked.items() if limit.tolerance is None), *bounds),
        targets=tuple(k for k, limit in asked.items() if limit.tolerance is not None),
        keys=(*asked, *bounds, *GOALS, *(f"size {name}" for name in names)),
        evaluate=_field(of, len(asked), names, bounds, quantities),
        quantities=quantities,
        low=low,
        high=high,
        base=None if base is None else _field(base, len(asked), names, bounds, quantities),
        noise=noise,
        starts=given,
        rows={key: _row(limit) for key, limit in asked.items()} | bounds,
        closed=limits_of is None,
    )


def _row(limit: Limit) -> Row:
    demand = limit.demand * limit.required**limit.power
    return Row(f"{limit.name}: {limit.quantity}", demand, limit.capacity, limit)


def _quantities(design: DesignSpec) -> Field:
    """Return the logarithms of what can be least, and of the free sizes."""
    names = design.geometry.free

    def quantities(y: Floats) -> Floats:
        sizes = design.geometry.sized(dict(zip(names, np.exp(y), strict=True)))
        found = np.empty((len(GOALS) + len(names), *y.shape[1:]))
        found[0] = np.log(design.geometry.volume(sizes))
        found[1] = np.log(design.geometry.stiffness(design.material.elastic, sizes))
        found[len(GOALS) :] = y
        return found

    return _guarded(quantities, len(GOALS) + len(names))


def _field(
    limits_of: LimitsOf,
    judged: int,
    names: tuple[str, ...],
    bounds: Mapping[str, Row],
    quantities: Field,
) -> Field:
    """Return the rows of as many limits as were judged before, of the bounds, and quantities."""

    def values(y: Floats) -> Floats:
        x = dict(zip(names, np.exp(y), strict=True))
        used = np.empty((judged + len(bounds), *y.shape[1:]))
        found = limits_of(x)
        if len(found) != judged:
            raise ValueError(f"{len(found)} limits where {judged} were found before")
        used[:judged] = _used(found, y.shape[1:])
        for k, (key, row) in enumerate(bounds.items(), start=judged):
            side, name = key.split(" ")
            over = y[names.index(name)] - np.log(row.bound)
            used[k] = over if side == "most" else -over
        return np.vstack([used, quantities(y)])

    return _guarded(values, judged + len(bounds) + len(GOALS) + len(names))


def _guarded(values: Field, rows: int) -> Field:
    """Return a field that is NaN for the designs of which the formulas have no numbers."""

    def guarded(y: Floats) -> Floats:
        with suppress(ArithmeticError, ValueError):
            return values(y)
        shape = y.shape[1:]
        found = np.full((rows, *shape), np.nan)
        flat, each = y.reshape(len(y), -1), found.reshape(rows, -1)
        for i in range(flat.shape[1]) if flat.shape[1] > 1 else ():
            each[:, i : i + 1] = guarded(flat[:, i : i + 1])
        return found

    return guarded


def _probe(design: DesignSpec, of: LimitsOf) -> dict[str, Floats]:
    """Return sizes of which the formulas have all numbers, looked for between the bounds.

    Raises
    ------
    SolveError
        When there are none among many.

    """
    extents, names = design.geometry.extents, design.geometry.free
    ends = {
        name: (extents[name].least or LIKELY[0], extents[name].most or LIKELY[1]) for name in names
    }
    rng = np.random.default_rng(0)
    best: dict[str, Floats] = {}
    most = -1
    for trial in range(TRIALS):
        shares = np.full(len(names), 0.5) if trial == 0 else rng.random(len(names))
        sizes = {
            name: np.full(1, low * (high / low) ** share)
            for (name, (low, high)), share in zip(ends.items(), shares, strict=True)
        }
        with suppress(ArithmeticError, ValueError):
            count = len(of(sizes))
            if count > most:
                best, most = sizes, count
            if trial >= ENOUGH:
                break
    if not best:
        raise NoSolution(
            "no-design-to-start-from",
            f"no sizes were found of which a {design.geometry.name} has numbers",
            "bound its free sizes to what can be made",
        )
    return best


def _used(limits: Sequence[Limit], shape: tuple[int, ...]) -> Floats:
    """Return the log utilisation of each limit, raised to its power as its numbers are."""
    demand, capacity = np.empty((len(limits), *shape)), np.empty((len(limits), *shape))
    for k, limit in enumerate(limits):
        demand[k], capacity[k] = limit.demand, limit.capacity
        demand[k] *= limit.required**limit.power
    used = log_utilisation(demand, capacity)
    targets = [k for k, limit in enumerate(limits) if limit.tolerance is not None]
    with np.errstate(divide="ignore", invalid="ignore"):
        used[targets] = np.log(demand[targets] / capacity[targets])
    return used


def goal_of(objective: Objective, sizing: NumberSizing) -> Term:
    """Return the row that an objective minimises, a constant where it is a size that is fixed."""
    named = {"least-volume": "volume", "least-stiffness": "k_pivot", "balanced": "volume",
             "mass": "volume", "shortest": "l"}  # fmt: skip
    if isinstance(objective, str):
        name, sign = named[objective], 1.0
    else:
        sign = 1.0 if objective.minimize is not None else -1.0
        name = objective.minimize or objective.maximize or ""
        name = named.get(name, name)
    given = sizing.sizes._asdict()
    if name in sizing.names:
        return Term(f"size {name}", sign)
    if name in given:
        return Term("volume", 0.0, sign * log(given[name]))
    return Term(name, sign)


def one_by_one(limits_of: Callable[[Mapping[str, float]], list[Limit]]) -> LimitsOf:
    """Return the limits at many sizes from those of a model that takes one design at a time."""

    def limits(sizes: Mapping[str, Floats]) -> list[Limit]:
        count = next(iter(sizes.values())).size
        each = [limits_of({name: float(x[i]) for name, x in sizes.items()}) for i in range(count)]
        return [
            replace(
                same[0],
                demand=np.array([float(limit.demand) for limit in same]),
                capacity=np.array([float(limit.capacity) for limit in same]),
            )
            for same in zip(*each, strict=True)
        ]

    return limits
