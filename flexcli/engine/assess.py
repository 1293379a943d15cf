"""Judge sizes by every requirement: one design into checks, or many at once into factors."""

from collections.abc import Callable, Iterable, Sequence
from math import inf
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.rows import Rows, is_of_many
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.requirements import Limit
from flexcli.results import Check, Verdict

__all__ = [
    "CHUNK",
    "ROUNDING",
    "checks",
    "factor",
    "factors",
    "margins",
    "required",
    "span",
    "verdict",
    "worst_of_each",
]

ROUNDING = 1e-9
"""A factor this little (relative) below the required one is rounding, not a failure: what a
sizing leaves when it puts a constraint exactly at its limit."""

CHUNK = 65_536
"""Designs per pass of :func:`factors`, which bounds its memory."""


def factor(limit: Limit, demand: float, capacity: float) -> float:
    """Return the factor of safety of one limit: capacity over demand, infinite for no demand.

    For a target it is the ratio of the smaller to the larger, 1 when met exactly, none of nothing.
    """
    if demand <= 0.0:
        return np.inf if limit.tolerance is None else 0.0
    ratio = float(np.sign(capacity) * (abs(capacity) / demand) ** (1.0 / limit.power))
    return min(ratio, 1.0 / ratio) if limit.tolerance is not None and ratio > 0.0 else ratio


def required(limit: Limit) -> float:
    """Return the factor that a limit asks for."""
    return limit.required if limit.tolerance is None else 1.0 / (1.0 + limit.tolerance)


def checks(limits: Iterable[Limit]) -> tuple[Check, ...]:
    """Return one check for each requirement, case and variant, decided by its worst limit."""
    found = tuple(limits)
    if not any(is_of_many(x) for limit in found for x in (limit.demand, limit.capacity)):
        return worst_of_each(map(_check, found))
    names = dict.fromkeys(limit.name for limit in found)
    return tuple(_check_of_many([each for each in found if each.name == name]) for name in names)


def worst_of_each(checks: Iterable[Check]) -> tuple[Check, ...]:
    """Return the worst of the checks of each name, in the order of the names."""
    worst: dict[str, Check] = {}
    for check in checks:
        name = check.full_name
        if name not in worst or _order(check) < _order(worst[name]):
            worst[name] = check
    return tuple(worst.values())


def _check(limit: Limit) -> Check:
    root = 1.0 / limit.power
    demand, capacity = float(limit.demand), float(limit.capacity)
    found, asked, between = factor(limit, demand, capacity), required(limit), span(limit)
    return Check(
        name=limit.title,
        case=limit.case,
        quantity=limit.quantity,
        demand=max(demand, 0.0) ** root,
        capacity=float(np.sign(capacity)) * abs(capacity) ** root,
        unit=limit.unit,
        factor=found,
        required=asked,
        verdict=verdict(between, asked),
        source=limit.source,
        factor_range=between,
        path=limit.path,
        is_target=limit.tolerance is not None,
        kind=limit.kind,
    )


def _check_of_many(limits: Sequence[Limit]) -> Check:
    """Return the check of many designs that limits of one name make, each decided by its worst.

    What the text says of the first limit may be of another in some designs.
    """
    columns = [_of_many(limit) for limit in limits]
    shape = np.broadcast_shapes(*(x.shape for column in columns for x in column))
    worst = _OfMany(*(np.broadcast_to(x, shape) for x in columns[0]))
    for column in columns[1:]:
        below = (column.rank == worst.rank) & (column.order < worst.order)
        below |= column.rank < worst.rank
        worst = _OfMany(*(np.where(below, x, y) for x, y in zip(column, worst, strict=True)))
    rank, known = Rows.of(worst.rank), Rows.of(worst.known)
    between = (Rows.of(worst.least), Rows.of(worst.most)) if known else None
    said = Verdict.FAIL if rank == Verdict.FAIL.rank else Verdict.UNDECIDED
    if rank == Verdict.PASS.rank:
        said = Verdict.PASS
    first = limits[0]
    return Check(
        name=first.title,
        case=first.case,
        quantity=first.quantity,
        demand=Rows.of(worst.demand),
        capacity=Rows.of(worst.capacity),
        unit=first.unit,
        factor=Rows.of(worst.factor),
        required=required(first),
        verdict=said,
        source=first.source,
        factor_range=between,
        path=first.path,
        is_target=first.tolerance is not None,
        kind=first.kind,
    )


class _OfMany(NamedTuple):
    """What a limit says of many designs (designs,), as :class:`Check` has it.

    ``order`` is what decides between limits of one verdict, whose ``rank`` comes first.
    """

    demand: NDArray[Any]
    capacity: NDArray[Any]
    factor: NDArray[Any]
    known: NDArray[Any]
    least: NDArray[Any]
    most: NDArray[Any]
    rank: NDArray[Any]
    order: NDArray[Any]


def _of_many(limit: Limit) -> _OfMany:
    root, asked = 1.0 / limit.power, required(limit)
    demand, capacity = np.asarray(limit.demand), np.asarray(limit.capacity)
    plain = _factors(limit._replace(tolerance=None))
    found = plain if limit.tolerance is None else _factors(limit)
    least = most = np.full(found.shape, np.nan)
    with np.errstate(divide="ignore", invalid="ignore"):
        if limit.known is not None:
            low, high = (np.maximum(1.0 + np.asarray(error), 0.0) for error in limit.known)
            one, other = plain * low, plain * high
            if not limit.in_capacity:
                one, other = (np.where(e > 0.0, plain / e, np.inf) for e in (high, low))
            least, most = np.minimum(one, other), np.maximum(one, other)
            if limit.tolerance is not None:
                inside = np.minimum(least, 1.0 / least), np.minimum(most, 1.0 / most)
                beyond = np.where((least <= 1.0) & (most >= 1.0), 1.0, np.maximum(*inside))
                most = np.where(least <= 0.0, np.clip(most, 0.0, 1.0), beyond)
                least = np.where(least <= 0.0, 0.0, np.minimum(*inside))
    enough, is_known = asked * (1.0 - ROUNDING), limit.known is not None
    rank = np.where(most >= enough, Verdict.UNDECIDED.rank, Verdict.FAIL.rank)
    rank = np.where(least >= enough, Verdict.PASS.rank, rank)
    return _OfMany(
        np.maximum(demand, 0.0) ** root,
        np.sign(capacity) * np.abs(capacity) ** root,
        found,
        np.full(found.shape, is_known),
        least,
        most,
        rank if is_known else np.full(rank.shape, Verdict.UNDECIDED.rank),
        (least if is_known else found) / asked,
    )


def span(limit: Limit) -> tuple[float, float] | None:
    """Return between which factors a limit lies by the error of its number, if that is known."""
    if limit.known is None:
        return None
    if any(map(is_of_many, (limit.demand, limit.capacity, *limit.known))):
        many = _of_many(limit)
        return Rows.of(many.least), Rows.of(many.most)
    demand, capacity = float(limit.demand), float(limit.capacity)
    plain = limit._replace(tolerance=None)
    found = factor(plain, demand, capacity)
    low, high = (max(1.0 + error, 0.0) for error in limit.known)
    if limit.in_capacity:
        ends = sorted((found * low, found * high))
    else:
        ends = sorted((found / high if high else inf, found / low if low else inf))
    least, most = ends
    if limit.tolerance is None:
        return least, most
    if least <= 0.0:
        return 0.0, min(max(most, 0.0), 1.0)
    inside = [min(end, 1.0 / end) for end in ends]
    return min(inside), 1.0 if least <= 1.0 <= most else max(inside)


def verdict(between: tuple[float, float] | None, asked: float) -> Verdict:
    """Return what a range of factors says of the one that is required."""
    if between is None:
        return Verdict.UNDECIDED
    least = asked * (1.0 - ROUNDING)
    if between[0] >= least:
        return Verdict.PASS
    return Verdict.UNDECIDED if between[1] >= least else Verdict.FAIL


def _order(check: Check) -> tuple[int, float, float]:
    """Return which of several limits decides a check: the worst verdict, then the least margin.

    Ranges that reach to the same end, but for rounding, leave it to the factors themselves.
    """
    between = check.factor_range
    margin = (check.factor if between is None else between[0]) / check.required
    return check.verdict.rank, float(f"{margin:.12g}"), check.factor


def factors(design: DesignSpec, **sizes: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """Return margins of many designs at once: factor over required factor, per check.

    Parameters
    ----------
    design : DesignSpec
        The design whose sizes vary.
    **sizes : array
        Sizes by symbol (h, l, b of blades) [m]; broadcast against each other, and the fixed ones
        that are not given against them.

    Returns
    -------
    dict of array
        For each check the factor over the required one, in the broadcast shape: a design passes
        where all are at least 1.

    """
    return margins(design.closed_limits, design.geometry, design.geometry.sized(sizes))


def margins(
    limits: Callable[[Sizes], list[Limit]], geometry: Geometry, sizes: Sizes
) -> dict[str, NDArray[np.float64]]:
    """Return for each check of limits its factor over the required one, at many sizes."""
    given = sizes._asdict()
    shape = np.broadcast_shapes(*(np.shape(x) for x in given.values()))
    flat = {
        name: np.broadcast_to(np.asarray(x, dtype=np.float64), shape).reshape(-1)
        for name, x in given.items()
    }
    size = int(np.prod(shape))
    found: dict[str, NDArray[np.float64]] = {}
    for start in range(0, size, CHUNK):
        part = slice(start, start + CHUNK)
        for limit in limits(geometry.sized({name: x[part] for name, x in flat.items()})):
            least = found.setdefault(limit.name, np.full(size, np.inf))
            np.minimum(least[part], _factors(limit) / required(limit), out=least[part])
    return {name: least.reshape(shape) for name, least in found.items()}


def _factors(limit: Limit) -> NDArray[np.float64]:
    """Return the factor of safety of many designs, as :func:`factor` does of one."""
    demand = np.asarray(limit.demand, dtype=np.float64)
    capacity = np.asarray(limit.capacity, dtype=np.float64)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.abs(capacity) / demand
        ratio = ratio if limit.power == 1 else ratio ** (1.0 / limit.power)
        ratio = np.where(demand <= 0.0, np.inf, np.copysign(ratio, capacity))
        if limit.tolerance is not None:
            ratio = np.where(ratio > 0.0, np.minimum(ratio, 1.0 / ratio), ratio)
    return ratio
