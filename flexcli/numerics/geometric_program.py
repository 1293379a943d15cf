"""Geometric programs: minimise a posynomial subject to ratios of posynomials ≤ 1."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

from flexcli.errors import Outcome
from flexcli.numerics.many_starts import solve
from flexcli.numerics.ratios import Equality, Ratio, Settled
from flexcli.numerics.signomial import Floats, Signomial, as_signomial
from flexcli.numerics.signomial_program import SignomialProgram, signomial_program
from flexcli.numerics.solution import Solution

__all__ = ["minimize"]


def minimize(
    objectives: Sequence[Signomial | Ratio],
    constraints: Sequence[Ratio | Settled],
    equalities: Sequence[Equality],
    names: Sequence[str],
    starts: Callable[[SignomialProgram], Sequence[Floats]] | None = None,
    ends: tuple[Floats, Floats] | None = None,
) -> Solution:
    """Minimise a posynomial (or ratio of posynomials) over positive variables.

    Parameters
    ----------
    objectives
        What to minimise, then what breaks ties between equally good points.
    constraints
        Rows ≤ 1, and rows that `at_most` found settled.
    equalities
        Rows = 1.
    names
        The free variables. Any other variable in a row is a `ValueError`.
    starts
        Starting points in logarithms, asked for where some row is not convex.
    ends
        Logarithms between which a variable of such a program is looked for.

    Notes
    -----
    Convex rows: an interior-point run, global. Others: the best local optimum of all starts.
    """
    rows = [row for row in constraints if isinstance(row, Ratio)]
    programs = [
        signomial_program(_as_ratio(goal), rows, equalities, tuple(names), ends)
        for goal in objectives
    ]
    found = solve(
        programs,
        lambda: starts(programs[0]) if starts is not None else (),
        [row.name for row in rows],
        [row.name for row in equalities],
    )
    return _with_settled(found, [row for row in constraints if isinstance(row, Settled)])


def _as_ratio(objective: Signomial | Ratio) -> Ratio:
    if isinstance(objective, Ratio):
        return objective
    return Ratio("objective", objective, as_signomial(1.0))


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
