"""Designs that use every ratio fully: n posynomial ratios equal to one in n unknowns."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from flexcli.numerics.condensation import start_point, starting_points
from flexcli.numerics.log_sum_exp import Program, program
from flexcli.numerics.ratios import Ratio
from flexcli.numerics.signomial import Floats, as_signomial

STEPS = 60
LONGEST_STEP = 5.0
"""Longest Newton step in the logarithms (a factor 150): beyond, the tangent says little."""
SHORTEST = 1e-6
"""Share of a Newton step below which the search has met a minimum of the residual, not a root."""
CLOSE = 1e-9
"""Log residual from which the refinement in direct products takes over."""
SOLVED = 1e-12
"""Log residual a root must reach; rounding leaves some 1e-15."""
SINGULAR = 1e13
"""Condition number of the Jacobian beyond which a point is no isolated root."""
SAME = 1e-7
"""Roots closer than this in every logarithm are one."""
BLUR = 64.0 * float(np.finfo(np.float64).eps)
"""Times the condition number: how far rounding alone moves a root."""
REFINEMENTS = 6


@dataclass(frozen=True, eq=False)
class Root:
    """One solution of a square system.

    Parameters
    ----------
    x
        The unknowns.
    residual
        Largest |ln(numerator/denominator)|.
    condition
        Condition number of the Jacobian ∂ ln ratio / ∂ ln x.
    sensitivity
        ∂ ln xⱼ / ∂ ln cᵢ, shape (n, n), row j for unknown j; cᵢ multiplies numerator i.
    iterations
        Newton steps from the start that led here.
    """

    x: dict[str, float]
    residual: float
    condition: float
    sensitivity: Floats
    iterations: int


def solve_square(
    ratios: Sequence[Ratio], names: Sequence[str], starts: Sequence[Mapping[str, float]] = ()
) -> list[Root]:
    """Return the distinct roots at which all ratios equal one; none is an empty list.

    Damped Newton in logarithms from the given starts and a deterministic spread, then Newton
    with residuals from direct products: sums of logarithms of the size of 50 would round at
    1e-14, products of the terms themselves round at 1e-16.

    Notes
    -----
    An empty list says that no start led to a root, which is a proof for no system in general.
    """
    names = tuple(names)
    if len(ratios) != len(names):
        raise ValueError(f"{len(ratios)} ratios for {len(names)} unknowns {names}")
    constant = Ratio("nothing to minimise", as_signomial(1.0), as_signomial(1.0))
    system = program(constant, ratios, [], names)
    roots: list[Root] = []
    logs: list[Floats] = []
    for start in starting_points(system, ratios, [], starts):
        y, iterations = _newton(system, start)
        if y is None:
            continue
        root = _refine(system, ratios, y, iterations)
        if root is None:
            continue
        y = start_point(names, root.x, y)
        apart = max(SAME, BLUR * root.condition)
        if not any(np.abs(y - other).max(initial=0.0) < apart for other in logs):
            roots.append(root)
            logs.append(y)
    return roots


def _newton(system: Program, y: Floats) -> tuple[Floats | None, int]:
    for iteration in range(STEPS):
        at = system.expand(y)
        f, J = at.values[1:], at.jacobian[1:]
        size = float(np.linalg.norm(f))
        if size <= CLOSE:
            return y, iteration
        try:
            step = -np.linalg.solve(J, f)
        except np.linalg.LinAlgError:
            step = -np.linalg.lstsq(J, f, rcond=None)[0]
        length = min(1.0, LONGEST_STEP / (float(np.abs(step).max()) + 1e-300))
        while True:
            trial = float(np.linalg.norm(system.values(y + length * step)[1:]))
            if trial <= (1.0 - 1e-4 * length) * size:
                break
            length *= 0.5
            if length < SHORTEST:
                return None, iteration
        y = y + length * step
    return None, STEPS


def _refine(system: Program, ratios: Sequence[Ratio], y: Floats, iterations: int) -> Root | None:
    J = system.expand(y).jacobian[1:]
    condition = float(np.linalg.cond(J)) if y.size else 1.0
    if not condition < SINGULAR:
        return None
    x, best = np.exp(y), np.inf
    kept = x
    for _ in range(REFINEMENTS):
        f = _log_ratios(ratios, dict(zip(system.names, x.tolist(), strict=True)))
        residual = float(np.abs(f).max(initial=0.0))
        if not residual < best:
            break
        kept, best = x, residual
        J = system.expand(np.log(x)).jacobian[1:]
        x = x * (1.0 - np.linalg.solve(J, f))
        iterations += 1
    if best > SOLVED:
        return None
    J = system.expand(np.log(kept)).jacobian[1:]
    return Root(
        dict(zip(system.names, kept.tolist(), strict=True)),
        best,
        condition,
        np.asarray(-np.linalg.inv(J), dtype=np.float64),
        iterations,
    )


def _log_ratios(ratios: Sequence[Ratio], x: dict[str, float]) -> Floats:
    above = np.array([ratio.numerator.at(**x) for ratio in ratios])
    below = np.array([ratio.denominator.at(**x) for ratio in ratios])
    return np.asarray(np.log1p((above - below) / below))
