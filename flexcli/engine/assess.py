"""Judge sizes by every requirement: one design into checks, or many at once into factors."""

from collections.abc import Iterable
from dataclasses import replace
from math import inf

import numpy as np
from numpy.typing import NDArray

from flexcli.parts.design import DesignSpec
from flexcli.parts.requirements import Limit
from flexcli.results import Check, Verdict

__all__ = [
    "CHUNK",
    "ROUNDING",
    "checks",
    "factor",
    "factors",
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

    For a target it is the ratio of the smaller to the larger, 1 when met exactly.
    """
    if demand <= 0.0:
        return np.inf
    ratio = float(np.sign(capacity) * (abs(capacity) / demand) ** (1.0 / limit.power))
    return min(ratio, 1.0 / ratio) if limit.tolerance is not None and ratio > 0.0 else ratio


def required(limit: Limit) -> float:
    """Return the factor that a limit asks for."""
    return limit.required if limit.tolerance is None else 1.0 / (1.0 + limit.tolerance)


def checks(limits: Iterable[Limit]) -> tuple[Check, ...]:
    """Return one check for each requirement, case and variant, decided by its worst limit."""
    return worst_of_each(map(_check, limits))


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


def span(limit: Limit) -> tuple[float, float] | None:
    """Return between which factors a limit lies by the error of its number, if that is known."""
    if limit.error is None:
        return None
    demand, capacity = float(limit.demand), float(limit.capacity)
    plain = replace(limit, tolerance=None)
    found = factor(plain, demand, capacity)
    low, high = (max(1.0 + error, 0.0) for error in limit.error)
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


def _order(check: Check) -> tuple[int, float]:
    """Return which of several limits decides a check: the worst verdict, then the least factor."""
    between = check.factor_range
    return check.verdict.rank, check.factor if between is None else between[0]


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
    given = design.geometry.sized(sizes)._asdict()
    shape = np.broadcast_shapes(*(np.shape(x) for x in given.values()))
    flat = {
        name: np.broadcast_to(np.asarray(x, dtype=np.float64), shape).reshape(-1)
        for name, x in given.items()
    }
    size = int(np.prod(shape))
    found: dict[str, NDArray[np.float64]] = {}
    for start in range(0, size, CHUNK):
        part = slice(start, start + CHUNK)
        for limit in design.closed_limits(
            design.geometry.sized({name: x[part] for name, x in flat.items()})
        ):
            margins = found.setdefault(limit.name, np.full(size, np.inf))
            np.minimum(margins[part], _margin(limit), out=margins[part])
    return {name: margins.reshape(shape) for name, margins in found.items()}


def _margin(limit: Limit) -> NDArray[np.float64]:
    demand = np.asarray(limit.demand, dtype=np.float64)
    capacity = np.asarray(limit.capacity, dtype=np.float64)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(demand > 0.0, np.abs(capacity) / demand, np.inf)
    ratio = np.copysign(ratio if limit.power == 1 else ratio ** (1.0 / limit.power), capacity)
    if limit.tolerance is not None:
        ratio = np.minimum(ratio, 1.0 / ratio)
    return np.asarray(ratio / required(limit))
