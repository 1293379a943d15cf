"""Roots of square systems of smooth rows in logarithms, from many starts."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from flexcli.numerics.log_stencil import Field, differences
from flexcli.numerics.signomial import Floats

__all__ = ["Root", "roots"]

STEPS = 60
LONGEST_STEP = 5.0
"""Longest Newton step in logarithms (a factor 150), the reach of the linear model."""
SHORTEST = 1e-6
"""Share of a Newton step below which the search has met a minimum of the residual, not a root."""
SOLVED = 1e-11
"""Log residual a root must reach; rounding leaves some 1e-15."""
SINGULAR = 1e11
"""Condition number of the Jacobian beyond which a point is no isolated root."""
SAME = 1e-7
"""Roots closer than this in every logarithm are one."""
BLUR = 64.0 * float(np.finfo(np.float64).eps)
"""Rounding error of a root over its condition number."""


class Root(NamedTuple):
    """A root y (n,), the inverse of the Jacobian there (n, n), and its condition number."""

    y: Floats
    inverse: Floats
    condition: float


def roots(rows: Field, starts: Iterable[Floats]) -> list[Root]:
    """Return the distinct roots of as many rows as unknowns; none is an empty list.

    Damped Newton's method from each start, the Jacobian by differences.

    Notes
    -----
    An empty list says that no start led to a root, which is a proof for no system in general.
    """
    found: list[Root] = []
    for start in starts:
        root = _newton(rows, start)
        if root is None:
            continue
        apart = max(SAME, BLUR * root.condition)
        if not any(np.abs(root.y - other.y).max(initial=0.0) < apart for other in found):
            found.append(root)
    return found


def _newton(rows: Field, y: Floats) -> Root | None:
    for _ in range(STEPS):
        at = differences(rows, y)
        size = float(np.linalg.norm(at.values))
        if not at.is_finite:
            return None
        condition = float(np.linalg.cond(at.jacobian))
        if not condition < SINGULAR:
            return None
        inverse = np.linalg.inv(at.jacobian)
        if size == 0.0:
            return Root(y, np.asarray(inverse), condition)
        step = -inverse @ at.values
        length = min(1.0, LONGEST_STEP / (float(np.abs(step).max()) + 1e-300))
        while True:
            trial = float(np.linalg.norm(rows((y + length * step)[:, None])))
            if trial <= (1.0 - 1e-4 * length) * size:
                break
            length *= 0.5
            if length < SHORTEST or size <= SOLVED:
                # as near as rounding allows, or a minimum of the residual
                return Root(y, np.asarray(inverse), condition) if size <= SOLVED else None
        y = y + length * step
    return None
