"""The best continuous design: an optimum with its certificate, or why there is none."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from math import log, log1p
from typing import Protocol, TypeAlias

import numpy as np

from flexcli.engine.sizing.program import Row, SizingProgram
from flexcli.errors import NoSolution
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
    "moved",
    "optimum",
    "refuse_undetermined",
    "refuse_unsolved",
    "relaxations",
    "sensitivities",
    "undetermined",
]

STEP = 1e-4
"""Relative change of a demand in the central difference of a sensitivity: its error is of order
1e-8, far below what is printed, and the solver's own 1e-12 divided by it is too."""


class HasRows(Protocol):
    """Free dimensions, targets by their keys, and what each key stands for."""

    @property
    def names(self) -> tuple[str, ...]:
        """Return the free dimensions."""

    @property
    def targets(self) -> tuple[str, ...]:
        """Return the keys of the targets."""

    @property
    def rows(self) -> dict[str, Row]:
        """Return what each key stands for."""


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


def refuse_unsolved(solution: Solution, program: HasRows) -> None:
    """Raise :class:`NoSolution` for outcomes that are neither a design nor a conflict."""
    if solution.outcome is Outcome.UNBOUNDED:
        names = ", ".join(n for n in solution.runaway if n in program.names) or "a dimension"
        raise NoSolution(
            "unbounded",
            f"the objective falls without limit as {names} runs away: nothing holds it",
            f"bound {names} in the geometry, e.g. {{free: [0.1 mm, 10 mm]}}, or add a requirement",
        )
    if solution.outcome is Outcome.STALLED:
        raise NoSolution("did-not-converge", "the sizing did not converge", solution.outcome.value)


def refuse_undetermined(
    goal: Signomial, solution: Solution, smallest: Solution, program: SizingProgram
) -> None:
    """Raise :class:`NoSolution` when ties leave a dimension that not even the volume holds."""
    as_good = at_most("as good as the best", goal, solution.objective * (1.0 + STEP))
    rows = [*program.constraints, as_good]
    loose = [
        name
        for name in smallest.runaway
        if name in program.names
        for x in variables(name)
        if optimum(program, [x], rows, program.equalities).outcome is Outcome.UNBOUNDED
    ]
    raise undetermined(loose or smallest.runaway)


def undetermined(loose: Sequence[str]) -> NoSolution:
    """Return the error of dimensions that neither the objective nor the volume holds."""
    names = ", ".join(loose)
    return NoSolution(
        "undetermined",
        f"nothing holds {names}: the objective does not depend on it, and the volume that would "
        "break the tie falls without limit",
        f"bound {names} in the geometry, e.g. {{free: [0.1 mm, 10 mm]}}, or add a requirement",
    )


def active_rows(solution: Solution, program: HasRows) -> tuple[str, ...]:
    """Return the names of what holds a solution: constraints at their limit, and all targets."""
    keys = (*solution.active, *program.targets)
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
    for name in (*solution.active, *program.targets):
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
        found.append(
            Sensitivity(row.name, row.driver, moved(high, low, ("objective", *program.names)))
        )
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


def moved(
    high: Mapping[str, float], low: Mapping[str, float], names: Sequence[str]
) -> dict[str, float]:
    """Return d ln(value) / d ln(demand) of each value from both sides of the optimum."""
    return {name: log(high[name] / low[name]) / (2.0 * log1p(STEP)) for name in names}


def explain_conflict(program: SizingProgram) -> tuple[tuple[Relaxation, ...], str]:
    """Return the smallest set of rows that conflict, each with its nearest relaxation."""
    found = conflict(program.constraints, program.equalities, program.names)

    def nearest(name: str, among: Sequence[str] | None) -> tuple[float, bool] | None:
        return _nearest_relaxation(program if among is None else _only(program, among), name)

    sure = "no smaller set conflicts" if found.smallest else "a smaller set may conflict"
    if found.certificate == "local":
        sure += "; found from many starts, not proved, as the problem is not convex"
    return relaxations(program.rows, found.members, nearest), sure


Nearest: TypeAlias = Callable[[str, Sequence[str] | None], tuple[float, bool] | None]
"""The least factor by which the requirement of a row must give way, and a target's direction, for
all rows, or for those named, to hold; nothing where that does not help."""


def relaxations(
    rows: Mapping[str, Row], members: Sequence[str], nearest: Nearest
) -> tuple[Relaxation, ...]:
    """Return how far each requirement of a conflict must give way, alone, for all others to hold.

    Where that does not help, because others conflict as well, how far it must to end this one.
    """
    together = {rows[name].requirement: name for name in reversed(members)}
    found = []
    for name in reversed(together.values()):
        row = rows[name]
        alone = nearest(name, None)
        if alone is not None:
            text = row.relaxed(alone[0], upward=alone[1])
            found.append(Relaxation(row.name, alone[0], text))
            continue
        ended = nearest(name, members)
        text = "giving way alone does not help"
        if ended is not None:
            text = row.relaxed(ended[0], upward=ended[1])
            text = f"{text} ends this conflict, but others remain"
        found.append(Relaxation(row.name, None, text))
    return tuple(found)


def _only(program: SizingProgram, names: Sequence[str]) -> SizingProgram:
    return replace(
        program,
        constraints=tuple(c for c in program.constraints if c.name in names),
        equalities=tuple(e for e in program.equalities if e.name in names),
    )


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
        for upward, target in (
            (True, row.equality(name, more=t)),
            (False, row.equality(name, less=t)),
        ):
            solution = optimum(wider, [t], outward, [*targets, target])
            if solution.converged:
                found.append((solution.x["t"], upward))
    else:
        solution = optimum(wider, [t], rows, targets)
        if solution.converged:
            found.append((solution.x["t"], True))
    return min(found, default=None)
