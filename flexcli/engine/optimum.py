"""The best continuous design: an optimum with its certificate, or why there is none."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import log, log1p

import numpy as np

from flexcli.engine.program import SizingProgram
from flexcli.errors import SolveError
from flexcli.numerics.condensation import condense
from flexcli.numerics.convex_program import Status
from flexcli.numerics.geometric_program import Outcome, Solution
from flexcli.numerics.infeasibility import conflict
from flexcli.numerics.lexicographic import minimize_lexicographic
from flexcli.numerics.log_sum_exp import program as numerical
from flexcli.numerics.ratios import Equality, Ratio, Settled, at_most
from flexcli.numerics.signomial import Signomial, as_signomial, variables
from flexcli.results import Relaxation, Sensitivity

__all__ = [
    "active_rows",
    "certificate",
    "explain_conflict",
    "optimum",
    "refuse_undetermined",
    "refuse_unsolved",
    "sensitivities",
]

STEP = 1e-4
"""Relative change of a demand in the central difference of a sensitivity: its error is of order
1e-8, far below what is printed, and the solver's own 1e-12 divided by it is too."""


def optimum(
    program: SizingProgram,
    objectives: Sequence[Signomial],
    constraints: Sequence[Ratio | Settled],
    equalities: Sequence[Equality],
    starts: Sequence[Mapping[str, float]] = (),
) -> Solution:
    """Minimise the first objective, ties broken by the next ones.

    An objective with negative terms is minimised as its least upper bound t.
    """
    first, *rest = objectives
    if first.is_posynomial:
        return minimize_lexicographic(
            [first, *rest], constraints, equalities, program.names, starts
        )
    (t,) = variables("t")
    rows = [*constraints, at_most("objective", first, t)]
    return minimize_lexicographic([t, *rest], rows, equalities, (*program.names, "t"), starts)


def refuse_unsolved(solution: Solution, program: SizingProgram) -> None:
    """Raise :class:`SolveError` for outcomes that are neither a design nor a conflict."""
    if solution.outcome is Outcome.UNBOUNDED:
        names = ", ".join(n for n in solution.runaway if n in program.names) or "a dimension"
        raise SolveError(
            "unbounded",
            f"the objective falls without limit as {names} runs away: nothing holds it",
            f"bound {names} in the geometry, e.g. {{free: [0.1 mm, 10 mm]}}, or add a requirement",
        )
    if solution.outcome is Outcome.STALLED:
        raise SolveError("did-not-converge", "the sizing did not converge", solution.outcome.value)


def refuse_undetermined(
    goal: Signomial, solution: Solution, smallest: Solution, program: SizingProgram
) -> None:
    """Raise :class:`SolveError` when ties leave a dimension that not even the volume holds."""
    as_good = at_most("as good as the best", goal, solution.objective * (1.0 + STEP))
    rows = [*program.constraints, as_good]
    loose = [
        name
        for name in smallest.runaway
        if name in program.names
        for x in variables(name)
        if optimum(program, [x], rows, program.equalities).outcome is Outcome.UNBOUNDED
    ]
    names = ", ".join(loose or smallest.runaway)
    raise SolveError(
        "undetermined",
        f"nothing holds {names}: the objective does not depend on it, and the volume that would "
        "break the tie falls without limit",
        f"bound {names} in the geometry, e.g. {{free: [0.1 mm, 10 mm]}}, or add a requirement",
    )


def active_rows(solution: Solution, program: SizingProgram) -> tuple[str, ...]:
    """Return the names of what holds a solution: constraints at their limit, and all targets."""
    keys = (*solution.active, *(row.name for row in program.equalities))
    return tuple(program.rows[key].name for key in keys if key in program.rows)


def certificate(solution: Solution, program: SizingProgram) -> str:
    """Return how sure the optimum is, in words."""
    if solution.certificate == "global":
        return f"global optimum, duality gap {max(solution.gap, 0.0):.0e}"
    what = "; ".join(program.curved) or "the objective"
    found = f"best of {solution.optima} found" if solution.optima > 1 else "the only one found"
    return f"local optimum, {found} from many starts: not posynomial are {what}"


def sensitivities(
    program: SizingProgram, objectives: Sequence[Signomial], solution: Solution
) -> tuple[Sensitivity, ...]:
    """Return what 1 % more demand in each active row does to the objective and dimensions.

    A bound tightens by 1 %, a target grows by 1 %.
    """
    found = []
    for name in (*solution.active, *(target.name for target in program.equalities)):
        if name not in program.rows:
            continue
        row = program.rows[name]
        ends = [
            _nearby(
                program,
                objectives,
                [
                    row.constraint(name, tighter=scale) if c.name == name else c
                    for c in program.constraints
                ],
                [
                    row.equality(name, more=scale**row.power) if e.name == name else e
                    for e in program.equalities
                ],
                solution,
            )
            for scale in (1.0 + STEP, 1.0 / (1.0 + STEP))
        ]
        high, low = ends
        if high is None or low is None:
            continue
        on = {name: _slope(high[name], low[name]) for name in ("objective", *program.names)}
        found.append(Sensitivity(row.name, row.driver, on))
    return tuple(found)


def _nearby(
    program: SizingProgram,
    objectives: Sequence[Signomial],
    constraints: Sequence[Ratio | Settled],
    equalities: Sequence[Equality],
    solution: Solution,
) -> dict[str, float] | None:
    """Return sizes and objective of the optimum that a slightly changed program has near by.

    A local optimum is followed from where it was: other starts could only find another one.
    """
    goal, names = objectives[0], program.names
    if solution.certificate == "global" or not solution.unique or solution.tie_breakers:
        found = optimum(program, objectives, constraints, equalities, [solution.x])
        if not found.converged:
            return None
        return found.x | {"objective": found.objective}
    rows = [row for row in constraints if isinstance(row, Ratio)]
    start = [log(solution.x[name]) for name in names]
    least = Ratio("objective", goal, as_signomial(1.0)) if goal.is_posynomial else None
    if least is None:
        (t,) = variables("t")
        rows.append(Ratio("bound", goal.positive_part(), goal.negative_part() + t))
        least = Ratio("objective", t, as_signomial(1.0))
        names, start = (*names, "t"), [*start, log(solution.objective)]
    near = condense(numerical(least, rows, equalities, names), np.array(start))
    if near.status is not Status.CONVERGED:
        return None
    x = dict(zip(names, np.exp(near.y).tolist(), strict=True))
    return x | {"objective": float(goal.at(**x))}


def _slope(high: float, low: float) -> float:
    """Return d ln(value) / d ln(demand) from both sides of the optimum."""
    return log(high / low) / (2.0 * log1p(STEP))


def explain_conflict(program: SizingProgram) -> tuple[tuple[Relaxation, ...], str]:
    """Return the smallest set of rows that conflict, each with its nearest relaxation."""
    found = conflict(program.constraints, program.equalities, program.names)
    together = {program.rows[name].requirement: name for name in reversed(found.members)}
    rows = [_relaxation(program, name, found.members) for name in reversed(together.values())]
    sure = "no smaller set conflicts" if found.smallest else "a smaller set may conflict"
    if found.certificate == "local":
        sure += "; found from many starts, not proved, as the problem is not convex"
    return tuple(rows), sure


def _relaxation(program: SizingProgram, name: str, members: Sequence[str]) -> Relaxation:
    """Return how far the requirement of one row must give way, alone, for all others to hold.

    Where that does not help, because others conflict as well, how far it must to end this one.
    """
    row = program.rows[name]
    found = _nearest_relaxation(program, name)
    if found is not None:
        return Relaxation(row.name, found[0], row.relaxed(found[0], upward=found[1]))
    alone = replace(
        program,
        constraints=tuple(c for c in program.constraints if c.name in members),
        equalities=tuple(e for e in program.equalities if e.name in members),
    )
    ended = _nearest_relaxation(alone, name)
    if ended is None:
        return Relaxation(row.name, None, "giving way alone does not help")
    text = row.relaxed(ended[0], upward=ended[1])
    return Relaxation(row.name, None, f"{text} ends this conflict, but others remain")


def _nearest_relaxation(program: SizingProgram, name: str) -> tuple[float, bool] | None:
    """Return the least factor by which a requirement must give way, and a target's direction."""
    row = program.rows[name]
    (t,) = variables("t")
    rows = [
        program.rows[c.name].constraint(c.name, ease=t)
        if program.rows[c.name].requirement == row.requirement
        else c
        for c in program.constraints
    ]
    targets = [e for e in program.equalities if e.name != name]
    wider = replace(program, names=(*program.names, "t"))
    found: list[tuple[float, bool]] = []
    if row.limit is not None and row.limit.tolerance is not None:
        outward = [*rows, at_most("no nearer", 1.0, t)]
        for upward, moved in (
            (True, row.equality(name, more=t)),
            (False, row.equality(name, less=t)),
        ):
            solution = optimum(wider, [t], outward, [*targets, moved])
            if solution.converged:
                found.append((solution.x["t"], upward))
    else:
        solution = optimum(wider, [t], rows, targets)
        if solution.converged:
            found.append((solution.x["t"], True))
    return min(found, default=None)
