"""The best continuous design: an optimum with its certificate, or why there is none."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import log, log1p
from typing import TypeVar

from flexcli.engine.program import SizingProgram
from flexcli.errors import SolveError
from flexcli.numerics.geometric_program import Outcome, Solution
from flexcli.numerics.infeasibility import conflict
from flexcli.numerics.lexicographic import minimize_lexicographic
from flexcli.numerics.ratios import Equality, Ratio, Settled, at_most
from flexcli.numerics.signomial import Signomial, variables
from flexcli.results import Relaxation, Sensitivity

__all__ = ["certificate", "explain_conflict", "optimum", "sensitivities"]

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
    for name in (*solution.active, *(row.name for row in program.equalities)):
        if name not in program.rows:
            continue
        row = program.rows[name]
        high, low = (
            optimum(
                program,
                objectives,
                [_scaled(c, scale) if c.name == name else c for c in program.constraints],
                [_scaled(e, 1.0 / scale) if e.name == name else e for e in program.equalities],
                [solution.x],
            )
            for scale in (1.0 + STEP, 1.0 / (1.0 + STEP))
        )
        if not (high.converged and low.converged):
            continue
        power = row.limit.power if row.limit is not None else 1
        on = {"objective": power * _slope(high.objective, low.objective)}
        on |= {n: power * _slope(high.x[n], low.x[n]) for n in program.names}
        found.append(Sensitivity(row.name, row.driver, on))
    return tuple(found)


def _slope(high: float, low: float) -> float:
    """Return d ln(value) / d ln(scale of the row) from both sides of the optimum."""
    return log(high / low) / (2.0 * log1p(STEP))


RowKind = TypeVar("RowKind", Ratio | Settled, Equality)


def _scaled(row: RowKind, scale: float) -> RowKind:
    if isinstance(row, Settled):
        return row
    return replace(row, numerator=row.numerator * scale)


def explain_conflict(program: SizingProgram) -> tuple[tuple[Relaxation, ...], str]:
    """Return the smallest set of rows that conflict, each with its nearest relaxation."""
    found = conflict(program.constraints, program.equalities, program.names)
    rows = []
    for name in found.members:
        factor = found.relaxations[name]
        row = program.rows[name]
        text = "giving way alone does not help" if factor is None else row.relaxed(factor)
        rows.append(Relaxation(row.name, factor, text))
    sure = "no smaller set conflicts" if found.smallest else "a smaller set may conflict"
    if found.certificate == "local":
        sure += "; found from many starts, not proved, as the problem is not convex"
    return tuple(rows), sure
