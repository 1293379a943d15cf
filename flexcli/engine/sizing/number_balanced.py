"""The balanced design by limits that are numbers: each kind of load requirement at its limit."""

from collections.abc import Iterator
from itertools import product

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.sizing.balanced import (
    ACTIVE,
    Balanced,
    NotBalanced,
    cannot_balance,
    kind_of,
    smallest_of,
)
from flexcli.engine.sizing.number_optimum import optimum
from flexcli.engine.sizing.number_rows import NumberSizing, Term
from flexcli.numerics.log_stencil import differences
from flexcli.numerics.newton import newton
from flexcli.results import Sensitivity

__all__ = ["balanced"]

Floats = NDArray[np.float64]

ROOTS_FROM = 24
"""Starts of Newton's method for each choice of governing rows."""
SOLVED = 1e-10
"""Log utilisation that a root must reach."""
SAME = 1e-7
"""Roots closer than this in every logarithm are one."""
TOLERANCE = 1e-12
"""Length, in logarithms, of the last step of Newton's method."""


def balanced(sizing: NumberSizing) -> Balanced | NotBalanced:
    """Return the balanced design of least volume among those that satisfy every other row.

    With as many kinds of load requirement as free dimensions it is a root of a square system;
    with fewer, the least volume on what they leave free. Every choice of one governing row in
    each kind is tried; a row that another of its kind exceeds at all of many points is left out.
    """
    groups = _load_rows(sizing)
    refusal = cannot_balance(groups, len(sizing.names))
    if refusal is not None:
        return refusal
    square = len(groups) == len(sizing.names)
    of = _roots if square else _least_volume
    candidates = [found for keys in product(*groups.values()) for found in of(sizing, keys)]
    volume = sizing.keys.index("volume")
    return smallest_of(
        candidates, groups, lambda x: _violated(sizing, x),
        lambda x: float(sizing.evaluate(_logs(sizing, x))[volume, 0]),
    )  # fmt: skip


def _logs(sizing: NumberSizing, x: dict[str, float]) -> Floats:
    return np.log([[x[name]] for name in sizing.names])


def _load_rows(sizing: NumberSizing) -> dict[str, list[str]]:
    """Return by kind the keys of the load rows that move with what is free and may govern."""
    points = sizing.samples()
    values = dict(zip(sizing.keys, sizing.evaluate(points), strict=True))
    groups: dict[str, list[str]] = {}
    for key in sizing.constraints:
        limit = sizing.rows[key].limit
        if limit is not None and limit.load and np.ptp(values[key]) > 0.0:
            groups.setdefault(kind_of(limit), []).append(key)
    return {
        kind: [k for i, k in enumerate(keys) if i in set(_largest([values[k] for k in keys]))]
        for kind, keys in groups.items()
    }


def _largest(values: list[Floats]) -> list[int]:
    found: list[int] = np.unique(np.argmax(np.array(values), axis=0)).tolist()
    return found


def _violated(sizing: NumberSizing, x: dict[str, float]) -> list[str]:
    values = dict(zip(sizing.keys, sizing.evaluate(_logs(sizing, x))[:, 0], strict=True))
    broken = [key for key in sizing.constraints if values[key] > ACTIVE]
    broken += [key for key in sizing.targets if abs(values[key]) > ACTIVE]
    return [sizing.rows[key].name for key in broken]


def _roots(sizing: NumberSizing, keys: tuple[str, ...]) -> Iterator[Balanced]:
    """Yield the designs at which as many rows as there are free dimensions are at their limit."""
    picked = [sizing.keys.index(key) for key in keys]

    def rows(y: Floats) -> Floats:
        return np.asarray(sizing.evaluate(y)[picked], dtype=np.float64)

    def step(y: Floats, _designs: NDArray[np.intp]) -> Floats:
        steps: Floats = np.full(y.shape, np.nan)
        for i, point in enumerate(y):
            if (point < sizing.low).any() or (point > sizing.high).any():
                continue  # run away
            values, J, _ = differences(rows, point)
            if np.isfinite(J).all() and np.linalg.cond(J) < 1.0 / np.finfo(float).eps:
                steps[i] = -np.linalg.solve(J, values)
        return steps

    points = sizing.samples()
    order = np.argsort(np.abs(rows(points)).max(axis=0), kind="stable")[:ROOTS_FROM]
    found = newton(
        step, lambda _, s: np.asarray(np.abs(s).max(axis=1)), points[:, order].T,
        tolerance=TOLERANCE,
    )  # fmt: skip
    seen: list[Floats] = []
    for y in found.x[found.converged]:
        f, J, _ = differences(rows, y)
        if np.abs(f).max() > SOLVED or any(np.abs(y - other).max() < SAME for other in seen):
            continue
        seen.append(y)
        x = dict(zip(sizing.names, np.exp(y).tolist(), strict=True))
        slopes = _sensitivities(sizing, keys, np.asarray(-np.linalg.inv(J), dtype=np.float64), y)
        names = tuple(sizing.rows[key].name for key in keys)
        yield Balanced(x, names, slopes, float(np.linalg.cond(J)), 0)


def _sensitivities(
    sizing: NumberSizing, keys: tuple[str, ...], slopes: Floats, y: Floats
) -> tuple[Sensitivity, ...]:
    """Return what 1 % more of each demand moves, from the inverse Jacobian of the rows."""
    volume = differences(lambda points: sizing.evaluate(points)[[sizing.keys.index("volume")]], y)
    found = []
    for index, key in enumerate(keys):
        row = sizing.rows[key]
        moved = slopes[:, index] * row.power
        on = dict(zip(sizing.names, moved.tolist(), strict=True))
        on["volume"] = float(volume.gradients[0] @ moved)
        found.append(Sensitivity(row.name, row.driver, on))
    return tuple(found)


def _least_volume(sizing: NumberSizing, keys: tuple[str, ...]) -> Iterator[Balanced]:
    """Yield the least volume at which fewer rows than free dimensions are at their limit."""
    limits = [term for term in sizing.limits() if term.key not in keys]
    equal = [*sizing.equalities(), *(Term(key) for key in keys)]
    found = optimum(sizing, [Term("volume")], limits, equal)
    if found.converged:
        names = tuple(sizing.rows[key].name for key in keys)
        yield Balanced(found.x, names, (), None, 0)
