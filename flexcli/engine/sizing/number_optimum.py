"""The best design by limits that are numbers: a local optimum and its sensitivities."""

from collections.abc import Mapping, Sequence
from math import log, log1p

import numpy as np

from flexcli.engine.sizing.number_rows import NumberSizing, Term
from flexcli.engine.sizing.optimum import STEP, moved, undetermined
from flexcli.numerics.convex_program import Status
from flexcli.numerics.geometric_program import ACTIVE, Outcome, Solution
from flexcli.numerics.many_starts import best_of_starts
from flexcli.numerics.successive import RIM
from flexcli.results import Sensitivity

__all__ = ["STARTS", "optimum", "refuse_undetermined", "sensitivities"]

STARTS = 5
"""Local runs per optimum, from the best of many points."""

OUTCOMES = {
    Status.CONVERGED: Outcome.CONVERGED,
    Status.INFEASIBLE: Outcome.INFEASIBLE,
    Status.UNBOUNDED: Outcome.UNBOUNDED,
    Status.STALLED: Outcome.STALLED,
}


def optimum(
    sizing: NumberSizing,
    objectives: Sequence[Term] | None,
    limits: Sequence[Term],
    equal: Sequence[Term],
    near: Mapping[str, float] | None = None,
) -> Solution:
    """Minimise the first objective, ties broken by the next ones.

    Without objectives it is the least t that the eased rows ask for, which the solution gives as
    its size ``t``. ``near`` replaces the search for starts by one that is known.
    """
    goals: Sequence[Term | None] = objectives if objectives is not None else [None]
    programs = [sizing.program(goal, limits, equal) for goal in goals]
    names = programs[0].names
    if near is not None:
        starts = [np.array([log(near[name]) if name in near else 0.0 for name in names])]
    else:
        starts = sizing.starting_points(programs[0], STARTS)
    found = best_of_starts(programs, starts)
    end = found.end
    outcome = OUTCOMES[end.status]
    slack = end.values[1 : 1 + len(limits)].tolist()
    unequal, equalities = np.split(end.multipliers, [len(limits)])
    ends = np.minimum(end.y - programs[0].low, programs[0].high - end.y)
    x = dict(zip(sizing.names, np.exp(end.y[: len(sizing.names)]).tolist(), strict=True))
    if len(names) > len(sizing.names):
        x["t"] = float(np.exp(end.y[-1]))
    keys = [term.key for term in limits]
    return Solution(
        outcome=outcome,
        x=x,
        objective=float(np.exp(end.values[0])),
        multipliers=dict(zip(keys, unequal.tolist(), strict=True)),
        equality_multipliers={
            t.key: float(v) for t, v in zip(equal, equalities.tolist(), strict=True)
        },
        active=tuple(k for k, value in zip(keys, slack, strict=True) if abs(value) <= ACTIVE),
        slack=dict(zip(keys, slack, strict=True)),
        gap=float("inf"),
        kkt_residual=end.residual,
        iterations=end.iterations,
        certificate="local",
        unique=found.unique,
        optima=found.optima,
        violation=end.violation,
        runaway=tuple(
            name for name, rim in zip(names, ends, strict=True)
            if outcome is Outcome.UNBOUNDED and rim <= RIM
        ),
        tie_breakers=("next objective",) if found.tied else (),
    )  # fmt: skip


def sensitivities(
    sizing: NumberSizing, objectives: Sequence[Term], solution: Solution
) -> tuple[Sensitivity, ...]:
    """Return what 1 % more demand in each active row does to the objective and dimensions.

    A bound tightens by 1 %, a target grows by 1 %. The correction of a base model is held.
    """
    sizing = sizing.corrected_at(solution.x)
    found = []
    for key in (*solution.active, *sizing.targets):
        row = sizing.rows[key]
        ends = []
        for sign in (1.0, -1.0):
            more = sign * row.power * log1p(STEP)
            near = optimum(
                sizing,
                objectives,
                [t._replace(shift=more) if t.key == key else t for t in sizing.limits()],
                [t._replace(shift=-more) if t.key == key else t for t in sizing.equalities()],
                solution.x,
            )
            ends.append(near.x | {"objective": near.objective} if near.converged else None)
        high, low = ends
        if high is not None and low is not None:
            names = ("objective", *sizing.names)
            found.append(Sensitivity(row.name, row.driver, moved(high, low, names)))
    return tuple(found)


def refuse_undetermined(
    sizing: NumberSizing, goal: Term, solution: Solution, smallest: Solution
) -> None:
    """Raise :class:`SolveError` when ties leave a dimension that not even the volume holds."""
    as_good = goal._replace(shift=-log(solution.objective * (1.0 + STEP)))
    limits = [*sizing.limits(), as_good]
    loose = []
    for name in smallest.runaway:
        least = [Term(f"size {name}")]
        found = optimum(sizing, least, limits, sizing.equalities(), solution.x)
        if found.outcome is Outcome.UNBOUNDED:
            loose.append(name)
    raise undetermined(loose or smallest.runaway)
