"""Non-convex geometric programs: successive condensation from several starts."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from flexcli.numerics.convex_program import (
    FEASIBLE,
    Convex,
    ConvexOptimum,
    Status,
    middle,
    minimize_convex,
)
from flexcli.numerics.interior_point import kkt_residual, polish
from flexcli.numerics.log_sum_exp import Program
from flexcli.numerics.ratios import Equality, Ratio
from flexcli.numerics.signomial import Floats

CONDENSATIONS = 60
NEAR = 0.03
"""Steps shorter than this (3 % in each variable) are near enough for Newton to end the run."""
SETTLED = 1e-9
"""A condensation step shorter than this has arrived, should Newton not have ended the run."""
PROGRESS = 1e-5
"""A condensation that lowers the largest log violation by less than this has come to rest."""
SAME = 1e-7
"""Optima whose log objectives differ by less are one."""
KKT = 1e-10
"""Residual of the optimality conditions, in logarithms, at which Newton's end is accepted."""
TRUST = 1.0
"""First half width, in logarithms, of the box for steps along tangents of curved equalities."""
SPREAD = 12
"""Starts spread over the box, besides its centre and those given."""
OPEN_SIDE = float(np.log(1e4))
"""Assumed length, in logarithms, of a side of the box that the constraints leave open."""


def condense(problem: Program, y: Floats) -> ConvexOptimum:
    """Follow convex inner approximations from y to a point that satisfies the KKT conditions.

    Each approximation touches the true rows at the current point and lies above them, so the
    iterates stay feasible once they are and the objective never rises. Where the approximation
    is infeasible its phase I gives the next point. Condensation converges linearly; near the
    end Newton's method on the true rows takes over.

    Tangents of curved equalities are no inner approximation and hold nearby only: these
    problems move inside a box around the point, which shrinks when a step turns back.

    References
    ----------
    M. Avriel, A. C. Williams (1970), Complementary geometric programming; B. R. Marks,
    G. P. Wright (1978), A general inner approximation algorithm, Oper. Res. 26(4), for the
    convergence to KKT points.
    """
    least = np.inf
    iterations = 0
    box = np.vstack([np.eye(y.size), -np.eye(y.size)])
    reach, last_step = TRUST, np.zeros(y.size)
    for _ in range(CONDENSATIONS):
        rows, G, d = problem.condensed(y)
        if problem.bends:
            rows = rows.joined(box, np.concatenate([-y, y]) - reach)
        found = minimize_convex(Convex(rows, G, d), y)
        iterations += found.iterations
        multipliers = found.multipliers[: problem.inequalities]
        found = replace(found, iterations=iterations, multipliers=multipliers)
        if found.status is Status.UNBOUNDED:
            return found
        step = found.y - y
        move = float(np.abs(step).max(initial=0.0))
        if step @ last_step < 0.0:
            reach *= 0.5
        last_step = step
        y = found.y
        if found.status is not Status.CONVERGED:
            violation = largest_violation(problem, y)
            if violation > least - PROGRESS or found.status is Status.STALLED:
                return replace(found, violation=violation)
            least = violation
            continue
        if move <= NEAR:
            ended = _newton_end(problem, found)
            if ended is not None:
                return ended
        if move <= SETTLED:
            return found
    return replace(found, status=Status.STALLED)


def largest_violation(problem: Program, y: Floats) -> float:
    """Return the largest log violation of the true rows at y, −∞ when there are none."""
    values = problem.values(y)[1:]
    equal = np.abs(values[problem.inequalities :])
    return float(np.append(values[: problem.inequalities], equal).max(initial=-np.inf))


def _newton_end(problem: Program, found: ConvexOptimum) -> ConvexOptimum | None:
    both = np.concatenate([found.multipliers, found.equality_multipliers])
    y, both = polish(problem.expand, found.y, both, problem.inequalities)
    at = problem.expand(y)
    if kkt_residual(at, both, problem.inequalities) > KKT:
        return None
    if np.abs(y - found.y).max(initial=0.0) > 10 * NEAR:
        return None
    multipliers, equal = np.split(both, [problem.inequalities])
    return replace(found, y=y, multipliers=multipliers, equality_multipliers=equal)


def best_of(problem: Program, starts: Iterable[Floats]) -> tuple[ConvexOptimum, int]:
    """Return the best end of all starts, and how many distinct local optima they found.

    Ends whose objectives agree within `SAME` are one optimum: a flat set of optima counts once.
    A feasible end beats an infeasible one,
    among which the least violation is best; an unbounded one ends the search.
    """
    optima: list[tuple[float, ConvexOptimum]] = []
    failures: list[ConvexOptimum] = []
    for start in starts:
        found = condense(problem, start)
        if found.status is Status.UNBOUNDED:
            return found, 0
        values = problem.values(found.y)
        sound = largest_violation(problem, found.y) <= FEASIBLE
        if found.status is not Status.CONVERGED or not sound:
            failures.append(found)
        elif not any(abs(values[0] - other) <= SAME for other, _ in optima):
            optima.append((float(values[0]), found))
    if optima:
        return min(optima, key=lambda pair: pair[0])[1], len(optima)
    return min(failures, key=lambda end: (end.status is Status.STALLED, end.violation)), 0


def starting_points(
    problem: Program,
    constraints: Sequence[Ratio],
    equalities: Sequence[Equality],
    given: Sequence[Mapping[str, float]],
) -> list[Floats]:
    """Return the given starts, the centre of the box, and points spread evenly over it.

    The box comes from the constraints that bound one variable by itself. The spread is the
    additive sequence of the generalised golden ratio (M. Roberts, 2018), the same in each run.
    """
    names = problem.names
    low, high = np.full(len(names), -np.inf), np.full(len(names), np.inf)
    rows: list[Ratio | Equality] = [*constraints, *equalities]
    for row in rows:
        if not (row.numerator.is_monomial and row.denominator.is_monomial):
            continue
        term = row.numerator / row.denominator
        exponents = term.aligned(names)[0]
        (used,) = np.nonzero(exponents)
        if used.size != 1:
            continue
        i, a = int(used[0]), float(exponents[used[0]])
        bound = -float(np.log(term.coefficients[0])) / a
        if a > 0 or isinstance(row, Equality):
            high[i] = min(high[i], bound)
        if a < 0 or isinstance(row, Equality):
            low[i] = max(low[i], bound)
    centre = middle(problem.above)
    low_open, high_open = np.isinf(low), np.isinf(high)
    low = np.where(low_open, np.where(high_open, centre - OPEN_SIDE / 2, high - OPEN_SIDE), low)
    high = np.where(high_open, low + OPEN_SIDE, high)
    golden = 1.5
    for _ in range(60):
        golden = (1.0 + golden) ** (1.0 / (len(names) + 1))
    steps = golden ** -np.arange(1.0, len(names) + 1)
    shares = [np.full(len(names), 0.5)]
    shares += [(0.5 + k * steps) % 1.0 for k in range(1, SPREAD + 1)]
    return [start_point(names, start, centre) for start in given] + [
        low + share * (high - low) for share in shares
    ]


def start_point(names: tuple[str, ...], start: Mapping[str, float], otherwise: Floats) -> Floats:
    """Return a start in logarithms; variables it does not give come from `otherwise`."""
    return np.array(
        [
            np.log(start[name]) if name in start else other
            for name, other in zip(names, otherwise, strict=True)
        ],
        dtype=np.float64,
    )
