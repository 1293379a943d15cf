"""Judge sizes by every requirement: one design into checks, or many at once into factors."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from flexcli.parts.design import DesignSpec
from flexcli.parts.requirements import Limit
from flexcli.results import Check

__all__ = ["CHUNK", "ROUNDING", "checks", "factor", "factors", "required"]

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
    worst: dict[str, Check] = {}
    for limit in limits:
        root = 1.0 / limit.power
        demand, capacity = float(limit.demand), float(limit.capacity)
        found, asked = factor(limit, demand, capacity), required(limit)
        check = Check(
            name=limit.title,
            case=limit.case,
            quantity=limit.quantity,
            demand=max(demand, 0.0) ** root,
            capacity=float(np.sign(capacity)) * abs(capacity) ** root,
            unit=limit.unit,
            factor=found,
            required=asked,
            passed=found >= asked * (1.0 - ROUNDING),
            source=limit.source,
        )
        if limit.name not in worst or check.margin < worst[limit.name].margin:
            worst[limit.name] = check
    return tuple(worst.values())


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
