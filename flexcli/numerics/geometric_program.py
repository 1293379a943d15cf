"""Geometric programs: minimise a posynomial subject to ratios of posynomials ≤ 1."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from typing import Literal

import numpy as np

from flexcli.numerics.condensation import best_of, start_point, starting_points
from flexcli.numerics.convex_program import (
    Convex,
    ConvexOptimum,
    Status,
    middle,
    minimize_convex,
)
from flexcli.numerics.interior_point import kkt_residual
from flexcli.numerics.log_sum_exp import Expansion, Program, program
from flexcli.numerics.ratios import Equality, Ratio, Settled
from flexcli.numerics.signomial import Floats, Signomial, as_signomial

ACTIVE = 1e-7
"""A constraint is active when its log utilisation is within this of zero: far above the solver's
residual, far below any tolerance of manufacture."""
FLAT = 1e-7
"""Singular values of gradients and curvature below this share of the largest count as zero; the
exponents that make them are of the order of one, the rounding of order 1e-13."""
RUNS_AWAY = 1e-6
"""Share of the largest component above which a variable takes part in a recession direction."""
ACCEPTED = 1e-9
"""Optimality residual at which a run that its path called stalled is a solution after all."""


class Outcome(Enum):
    """How a solve ended; the text states cause and remedy."""

    CONVERGED = "converged"
    INFEASIBLE = (
        "no values of the variables satisfy all constraints; relax one of the smallest "
        "conflicting set, which `conflict` finds"
    )
    UNBOUNDED = "the objective falls without limit; give bounds to the variables that run away"
    STALLED = (
        "did not converge; start nearer to the design, or look for coefficients or exponents "
        "that are out of proportion"
    )


@dataclass(frozen=True, eq=False)
class Solution:
    """Result of a geometric program.

    Parameters
    ----------
    outcome
        How the solve ended. Unless it converged, `x` is the last or the least violating point.
    x, objective
        The minimiser and the minimum.
    multipliers
        λ ≥ 0 of each constraint: ln objective falls by λ per unit by which ln(numerator /
        denominator) may exceed zero, to first order.
    equality_multipliers
        The same for equalities, of either sign.
    active
        Constraints whose log utilisation is within `ACTIVE` of zero.
    slack
        ln(numerator/denominator) of each constraint: negative inside.
    gap
        Duality gap of ln objective, so relative to the objective.
    kkt_residual
        Largest violation of the optimality conditions, in logarithms. A sum that just reaches one
        at a single point (x + 1/x ≤ 2) has no multiplier and leaves its part here.
    iterations
        Newton steps of the interior-point runs.
    certificate
        "global" when every row is convex in logarithms, else "local".
    unique
        Whether no direction leads to equally good points (of this optimum, when local).
    optima
        Local optima met that differ in their objective; 1 for a global certificate.
    violation
        Least largest log violation when infeasible, else the largest one at x.
    runaway
        Variables that run away when unbounded.
    tie_breakers
        Names of the further objectives that `minimize_lexicographic` put to use.
    """

    outcome: Outcome
    x: dict[str, float]
    objective: float
    multipliers: dict[str, float]
    equality_multipliers: dict[str, float]
    active: tuple[str, ...]
    slack: dict[str, float]
    gap: float
    kkt_residual: float
    iterations: int
    certificate: Literal["global", "local"]
    unique: bool
    optima: int
    violation: float
    runaway: tuple[str, ...] = ()
    tie_breakers: tuple[str, ...] = ()

    @property
    def converged(self) -> bool:
        """Whether x is a solution."""
        return self.outcome is Outcome.CONVERGED


def minimize(
    objective: Signomial | Ratio,
    constraints: Sequence[Ratio | Settled],
    equalities: Sequence[Equality],
    names: Sequence[str],
    starts: Sequence[Mapping[str, float]] = (),
) -> Solution:
    """Minimise a posynomial (or ratio of posynomials) over positive variables.

    Parameters
    ----------
    objective
        What to minimise.
    constraints
        Rows ≤ 1, and rows that `at_most` found settled.
    equalities
        Rows = 1.
    names
        The free variables. Any other variable in a row is a `ValueError`; fix it by
        `Signomial.substitute` first.
    starts
        Starting values; variables left out start at the middle of the terms. None are needed.
        Where all rows are convex only the first is used, else all are.

    Notes
    -----
    Convex rows: one interior-point run, global. Others: successive condensation from several
    starts, local.
    """
    names = tuple(names)
    goal = objective_ratio(objective)
    settled = [row for row in constraints if isinstance(row, Settled)]
    rows = [row for row in constraints if isinstance(row, Ratio)]
    problem = program(goal, rows, equalities, names)
    if problem.is_convex:
        near = start_point(names, starts[0] if starts else {}, middle(problem.above))
        found = minimize_convex(Convex(*problem.condensed(near)), near)
        optima = int(found.status is Status.CONVERGED)
    else:
        found, optima = best_of(problem, starting_points(problem, rows, equalities, starts))
    solution = _solution(problem, found, optima, rows, equalities)
    return _with_settled(solution, settled)


def objective_ratio(objective: Signomial | Ratio) -> Ratio:
    """Return the objective as a ratio."""
    if isinstance(objective, Ratio):
        return objective
    return Ratio("objective", objective, as_signomial(1.0))


def is_unique(at: Expansion, weights: Floats, active: Sequence[int], free: Floats) -> bool:
    """Tell whether a point is the only optimum, by first- and second-order change.

    T spans the directions tangent to all active rows (null space by singular values), among
    those that equalities and rows without interior leave `free`. Along
    them the Lagrangian's curvature TᵀHT must have full rank: a direction that it misses changes
    neither objective nor active constraints to second order. Central paths end in the middle of
    the set of optima, so a constraint active there is active on all of it and the test is not
    misled by corners. Singular values below `FLAT` times the largest count as zero.
    """
    n = free.shape[1]
    J = at.jacobian[list(active)] @ free
    rank = 0
    tangent = free
    if J.size:
        _, s, Vt = np.linalg.svd(J)
        rank = int((s > FLAT * np.abs(at.jacobian).max()).sum())
        tangent = free @ Vt[rank:].T
    if rank == n:
        return True
    H = at.curvature(weights)
    scale = max(float(np.abs(H).max()), float(np.abs(at.jacobian).max()) ** 2)
    values = np.linalg.svd(tangent.T @ H @ tangent, compute_uv=False)
    return bool(values.min() > FLAT * scale)


def _solution(
    problem: Program,
    found: ConvexOptimum,
    optima: int,
    rows: Sequence[Ratio],
    equalities: Sequence[Equality],
) -> Solution:
    at = problem.expand(found.y)
    slack = at.values[1 : 1 + problem.inequalities]
    both = np.concatenate([found.multipliers, found.equality_multipliers])
    residual = kkt_residual(at, both, problem.inequalities)
    outcome = {
        Status.CONVERGED: Outcome.CONVERGED,
        Status.INFEASIBLE: Outcome.INFEASIBLE,
        Status.UNBOUNDED: Outcome.UNBOUNDED,
        Status.STALLED: Outcome.CONVERGED if residual <= ACCEPTED else Outcome.STALLED,
    }[found.status]
    converged = outcome is Outcome.CONVERGED
    touching = np.flatnonzero(np.abs(slack) <= ACTIVE)
    equal = range(1 + problem.inequalities, at.values.size)
    away = np.abs(found.direction) > RUNS_AWAY * np.abs(found.direction).max(initial=0.0)
    largest = float(slack.max(initial=-math.inf))
    with np.errstate(over="ignore", under="ignore"):
        x = np.exp(found.y)
        objective = float(np.exp(at.values[0]))
    return Solution(
        outcome=outcome,
        x=dict(zip(problem.names, x.tolist(), strict=True)),
        objective=objective,
        multipliers=_by_name(rows, found.multipliers),
        equality_multipliers=_by_name(equalities, found.equality_multipliers),
        active=tuple(rows[i].name for i in touching.tolist()),
        slack=_by_name(rows, slack),
        gap=float(abs(found.multipliers @ slack)) if converged else math.inf,
        kkt_residual=residual if converged else math.inf,
        iterations=found.iterations,
        certificate="global" if problem.is_convex else "local",
        unique=converged
        and is_unique(at, np.concatenate([[1.0], both]), [*(1 + touching), *equal], found.free),
        optima=optima,
        violation=found.violation if outcome is Outcome.INFEASIBLE else largest,
        runaway=tuple(n for n, runs in zip(problem.names, away, strict=True) if runs),
    )


def _by_name(rows: Sequence[Ratio | Equality], values: Floats) -> dict[str, float]:
    return {row.name: value for row, value in zip(rows, values.tolist(), strict=True)}


def _with_settled(solution: Solution, settled: Sequence[Settled]) -> Solution:
    if not settled:
        return solution
    slack = {row.name: -math.inf if row.holds else math.inf for row in settled}
    solution = replace(
        solution,
        slack=solution.slack | slack,
        multipliers=solution.multipliers | dict.fromkeys(slack, 0.0),
    )
    if all(row.holds for row in settled):
        return solution
    return replace(
        solution,
        outcome=Outcome.INFEASIBLE,
        violation=math.inf,
        gap=math.inf,
        kkt_residual=math.inf,
        unique=False,
        optima=0,
    )
