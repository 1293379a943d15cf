"""The best of many local optima, or the global one; ties between equally good points."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import Outcome
from flexcli.numerics.convex_program import (
    FEASIBLE,
    Convex,
    middle,
    minimize_convex,
)
from flexcli.numerics.interior_point import kkt_residual
from flexcli.numerics.log_program import LogProgram, violation
from flexcli.numerics.log_sum_exp import LogSumExp
from flexcli.numerics.signomial import Floats
from flexcli.numerics.solution import ACTIVE, Solution
from flexcli.numerics.successive import RIM, Descent, descend

__all__ = ["solve", "spread", "starts_among"]

Starts = Callable[[], Sequence[Floats]]
"""Starting points, made only where they are needed."""

SAME = 1e-7
"""Optima whose log objectives differ by less are one."""
APART = 1.0
"""Distance, in logarithms, that starts keep from each other."""
HELD = 1e-7
"""Multiplier above which a row holds the optimum."""
FLAT = 1e-6
"""Relative curvature or slope that counts as none."""
MOVED = 1e-7
"""Distance, in logarithms, by which a tie-breaking objective has moved the point."""
AS_GOOD = 1e-8
"""Loss of log objective allowed to a tie-breaker: rounding along a plane of equal optima."""
RUNS_AWAY = 1e-6
"""Relative component from which a variable takes part in a recession direction."""
ACCEPTED = 1e-9
"""Optimality residual at which a run that stalled is accepted as a solution."""


@dataclass(frozen=True, eq=False)
class _End:
    """Where the solution of one program ended, and how many optima were met.

    The columns of ``free`` span the directions that equalities and rows without interior leave;
    ``runaway`` marks the variables that grow without limit.
    """

    descent: Descent
    optima: int
    free: Floats
    runaway: NDArray[np.bool_]


def spread(low: Floats, high: Floats, count: int) -> Floats:
    """Return points spread evenly over a box, shape (n, count), the centre first.

    References
    ----------
    M. Roberts (2018), The unreasonable effectiveness of quasirandom sequences: the additive
    sequence of the generalised golden ratio.

    """
    golden = 1.5
    for _ in range(60):
        golden = (1.0 + golden) ** (1.0 / (low.size + 1))
    steps = golden ** -np.arange(1.0, low.size + 1)
    shares = (0.5 + np.arange(count) * steps[:, None]) % 1.0
    return np.asarray(low[:, None] + shares * (high - low)[:, None])


def starts_among(
    program: LogProgram, points: Floats, count: int, *, apart: float = APART
) -> list[Floats]:
    """Return the best of many points, some distance from each other in some variable.

    Points that keep all rows come first, by their objective; then those that violate them least.
    """
    values = program.rows(points)
    worst = violation(program, values)
    sound = np.isfinite(values).all(axis=0)
    order = np.lexsort((np.where(worst > 0.0, 0.0, values[0]), np.where(sound, worst, np.inf)))
    chosen: list[Floats] = []
    for i in order[: int(sound.sum())].tolist():
        if all(np.abs(points[:, i] - other).max() >= apart for other in chosen):
            chosen.append(points[:, i])
        if len(chosen) == count:
            break
    return chosen or [points[:, 0]]


def solve(
    programs: Sequence[LogProgram], starts: Starts, limits: Sequence[str], equalities: Sequence[str]
) -> Solution:
    """Return the optimum of a program, equally good points decided by further objectives.

    Parameters
    ----------
    programs : sequence of LogProgram
        They differ in their row 0 only: the objective, then those that break ties.
    starts : callable
        Starting points, asked for where a program is not convex.
    limits, equalities : sequence of str
        Names of the rows.

    Notes
    -----
    Directions along which neither the objective nor a row that holds it changes to second order
    lead to equally good points; the next program is solved on the plane that they span. Over the
    optima of a convex program every term of the objective, and of each row with a multiplier, is
    constant, so that the plane is exact. A point found there is kept when it is feasible and as
    good by the first objective. Multipliers are those of the first.

    """
    program = programs[0]
    found = _end_of(program, starts)
    end = found.descent
    converged = end.outcome is Outcome.CONVERGED
    y, unique, steps = end.y, False, end.iterations
    if converged:
        y, unique, more = _best_of_equals(programs, found)
        steps += more
    values = program.rows(y[:, None])[:, 0]
    unequal, equal = np.split(end.multipliers, [len(limits)])
    slack = values[1 : 1 + len(limits)]
    runs = found.runaway if end.outcome is Outcome.UNBOUNDED else np.zeros(y.size, dtype=bool)
    is_global = converged and program.is_convex
    with np.errstate(over="ignore", under="ignore"):
        x, objective = np.exp(y), float(np.exp(values[0]))
    return Solution(
        outcome=end.outcome,
        x=dict(zip(program.names, x.tolist(), strict=True)),
        objective=objective,
        multipliers=dict(zip(limits, unequal.tolist(), strict=True)),
        equality_multipliers=dict(zip(equalities, equal.tolist(), strict=True)),
        active=tuple(n for n, at in zip(limits, slack, strict=True) if abs(at) <= ACTIVE),
        slack=dict(zip(limits, slack.tolist(), strict=True)),
        gap=float(abs(unequal @ slack)) if is_global else np.inf,
        kkt_residual=end.residual,
        iterations=steps,
        certificate="global" if program.is_convex else "local",
        unique=unique,
        optima=found.optima,
        violation=end.violation,
        runaway=tuple(n for n, away in zip(program.names, runs, strict=True) if away),
        tied=bool(np.abs(y - end.y).max(initial=0.0) > MOVED),
    )


def _best_of_equals(programs: Sequence[LogProgram], found: _End) -> tuple[Floats, bool, int]:
    """Return the best of equally good points, whether it is unique, and the steps taken."""
    program, end = programs[0], found.descent
    y, iterations = end.y, 0
    kept = [i for i in range(program.inequalities) if abs(end.multipliers[i]) <= HELD]
    basis = _flat(program, end, found.free)
    for other in programs[1:]:
        if not basis.shape[1]:
            break
        part = other.chosen(kept).along(y, basis)
        ended = _end_of(part, partial(_origin, part))
        iterations += ended.descent.iterations
        if ended.descent.outcome is not Outcome.CONVERGED:
            continue
        moved = y + basis @ ended.descent.y
        values = program.rows(moved[:, None])[:, 0]
        worse = abs(values[0] - end.values[0]) > AS_GOOD
        if violation(program, values) > FEASIBLE or worse:
            continue
        y, basis = moved, basis @ _flat(part, ended.descent, ended.free)
        held = ended.descent.multipliers
        kept = [i for i, weight in zip(kept, held, strict=True) if abs(weight) <= HELD]
    return y, not basis.shape[1], iterations


def _origin(program: LogProgram) -> list[Floats]:
    return [np.zeros(len(program.names))]


def _end_of(program: LogProgram, starts: Starts) -> _End:
    """Return the global optimum of a convex program, the best local one of any other."""
    if program.is_convex:
        return _global(program)
    descent, optima = _best(program, starts())
    rim = np.minimum(descent.y - program.low, program.high - descent.y) <= RIM
    return _End(descent, optima, np.eye(descent.y.size), rim)


def _global(program: LogProgram) -> _End:
    """Return the optimum of a convex program, which needs no start."""
    origin = np.zeros(len(program.names))
    at = program.expand(origin)
    keep = 1 + program.inequalities
    rows = program.model(at, origin)
    G, d = at.jacobian[keep:], -at.values[keep:]
    lines = rows.logs.size + np.arange(d.size)
    everything = LogSumExp(
        np.vstack([rows.exponents, G]),
        np.concatenate([rows.logs, -d]),
        np.concatenate([rows.first, lines]).astype(np.intp),
    )
    found = minimize_convex(Convex(rows, G, d), middle(everything))
    multipliers = np.concatenate([found.multipliers, found.equality_multipliers])
    at = program.expand(found.y)
    residual, outcome = np.inf, found.outcome
    if outcome in (Outcome.CONVERGED, Outcome.STALLED):
        residual = kkt_residual(at, multipliers, program.inequalities)
        if residual <= ACCEPTED:
            outcome = Outcome.CONVERGED
    worst = found.violation
    if outcome is not Outcome.INFEASIBLE:
        worst = float(at.values[1:keep].max(initial=-np.inf))
    descent = Descent(outcome, found.y, at.values, multipliers, worst, residual, found.iterations)
    away = np.abs(found.direction) > RUNS_AWAY * np.abs(found.direction).max(initial=0.0)
    return _End(descent, int(outcome is Outcome.CONVERGED), found.free, away)


def _best(program: LogProgram, starts: Sequence[Floats]) -> tuple[Descent, int]:
    """Return the best end with the steps of all, and how many distinct optima were found."""
    ends: list[Descent] = []
    for start in starts:
        known = [end for end in ends if end.outcome is Outcome.CONVERGED]
        ends.append(descend(program, start, known))
        if ends[-1].outcome is Outcome.UNBOUNDED:
            break
    order = (Outcome.UNBOUNDED, Outcome.CONVERGED, Outcome.STALLED, Outcome.INFEASIBLE)

    def rank(end: Descent) -> tuple[int, float]:
        infeasible = end.outcome is Outcome.INFEASIBLE
        return order.index(end.outcome), end.violation if infeasible else float(end.values[0])

    best = min(ends, key=rank)
    distinct: list[float] = []
    for end in ends:
        value = float(end.values[0])
        if end.outcome is Outcome.CONVERGED and all(abs(value - o) > SAME for o in distinct):
            distinct.append(value)
    total = sum(end.iterations for end in ends)
    return replace(best, iterations=total), len(distinct)


def _flat(program: LogProgram, end: Descent, free: Floats) -> Floats:
    """Return the directions, as orthonormal columns, that lead to equally good points."""
    at = program.expand(end.y)
    unequal = end.multipliers[: program.inequalities]
    holding = np.append(unequal > HELD, np.ones(end.multipliers.size - unequal.size, dtype=bool))
    J = at.jacobian[1:][holding] @ free
    tangent = free
    size = max(1.0, float(np.abs(at.jacobian).max(initial=0.0)))
    if J.size:
        _, s, Vt = np.linalg.svd(J)
        tangent = free @ Vt[int((s > FLAT * size).sum()) :].T
    H = at.curvature(np.append(1.0, end.multipliers))
    bends, ways = np.linalg.eigh(tangent.T @ H @ tangent)
    return np.asarray(tangent @ ways[:, np.abs(bends) <= FLAT * size**2])
