"""Local optima of programs that are not convex: convex models in a trust region."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from flexcli.errors import Outcome
from flexcli.numerics.convex_model import ModelStep, best_step
from flexcli.numerics.convex_program import FEASIBLE
from flexcli.numerics.interior_point import kkt_residual, polish
from flexcli.numerics.log_program import LogProgram, violation
from flexcli.numerics.log_sum_exp import Expansion
from flexcli.numerics.signomial import Floats

__all__ = ["RIM", "Descent", "descend"]

MODELS = 80
"""Greatest number of convex models from one start."""
TRUST, WIDEST, NARROWEST = 1.0, 6.0, 1e-11
"""First, largest and least half width of the trust region, in logarithms."""
POOR, GOOD = 0.05, 0.5
"""Ratio of actual to predicted gain below which a step is rejected, above which the region
grows."""
PENALTIES = (1e2, 1e4, np.inf)
"""Weight of the largest violation against the objective; infinite leaves only the violation."""
NEAR = 0.1
"""Step length below which Newton's method is tried."""
KKT = 1e-9
"""Residual of the optimality conditions, in logarithms, at which a point is an optimum."""
NO_GAIN = 1e-9
"""A predicted gain below this, in logarithms, is none: the models are not solved closer. Within a
trust region that is not narrow it marks an optimum too flat for Newton's method."""
RIM = 1e-6
"""Distance, in logarithms, to its limits at which a variable counts as unbounded."""
RANK = 1e-9
"""Singular values below this share of the largest are zero in Newton's systems, whose curvatures
may be differences."""


@dataclass(frozen=True, eq=False)
class Descent:
    """Where a run ended: multipliers of the rows, their optimality residual, models solved.

    For an infeasible program y is a point of least largest violation (a local one), and the
    multipliers, which sum to one, mark the conflicting rows.
    """

    outcome: Outcome
    y: Floats
    values: Floats
    multipliers: Floats
    violation: float
    residual: float
    iterations: int


def descend(
    program: LogProgram,
    y: Floats,
    known: Sequence[Descent] = (),
    penalties: Sequence[float] = PENALTIES,
) -> Descent:
    """Follow convex models of the rows from y to a local optimum, or until it comes to a known one.

    Each model is a posynomial per row: it lies above a ratio of posynomials and touches it, or has
    the value, gradient and convex curvature of a row known as numbers. Its optimum within the
    trust region is taken when the objective plus a penalty on the largest violation falls as the
    model says; near the end Newton's method on the rows takes over. Where the violation comes to
    rest above zero the next heavier of the ``penalties`` takes its place; an infinite one leaves
    only the violation: what is still violated then is infeasible.

    References
    ----------
    R. Fletcher (1987), Practical Methods of Optimization, §14.4.

    """
    y = np.clip(y, program.low, program.high)  # a start may have run away already
    at = program.expand(y)
    none = np.zeros(at.values.size - 1)
    if not at.is_finite:
        return _ended(program, Outcome.STALLED, y, at, none, 0)
    feasible = bool(violation(program, at.values) <= FEASIBLE)
    if _is_at_rim(program, y):
        return _run_away(program, y, at, none, 0, feasible=feasible)
    penalty, *heavier = penalties
    reach = TRUST
    multipliers = none
    for iteration in range(1, MODELS + 1):
        low, high = np.maximum(-reach, program.low - y), np.minimum(reach, program.high - y)
        step = best_step(at, program.model(at, y), low, high, penalty=penalty)
        multipliers = step.multipliers
        move = float(np.abs(step.step).max())
        predicted = _gain(step.fall, float(violation(program, at.values)) - step.violation, penalty)
        resting, wide = predicted <= NO_GAIN, reach >= NEAR
        trial = program.expand(y + step.step)
        gained = _gained(program, at, trial, penalty)
        taken = trial.is_finite and gained >= POOR * predicted and not resting
        if taken:
            y, at = y + step.step, trial
            feasible |= bool(violation(program, at.values) <= FEASIBLE)
            if gained >= GOOD * predicted and move > 0.9 * reach:
                reach = min(WIDEST, 3.0 * reach)
        else:
            reach = 0.25 * min(move, reach)
        if _is_at_rim(program, y):
            return _run_away(program, y, at, multipliers, iteration, feasible=feasible)
        if step.violation <= FEASIBLE and not np.isinf(penalty):
            for other in known:
                if np.abs(y - other.y).max() <= NEAR:
                    return replace(other, iterations=iteration)
            if resting or (taken and move <= NEAR):
                ended = _newton_end(program, y, step, iteration)
                if ended is not None:
                    return ended
        if resting or reach <= NARROWEST:
            violated = violation(program, at.values) > FEASIBLE
            if not (violated and heavier):
                outcome = Outcome.INFEASIBLE if violated else Outcome.STALLED
                if not violated and resting and wide and not np.isinf(penalty):
                    outcome = Outcome.CONVERGED
                return _ended(program, outcome, y, at, multipliers, iteration)
            penalty, *heavier = heavier
            reach = TRUST
    return _ended(program, Outcome.STALLED, y, at, multipliers, MODELS)


def _gain(objective: float, less: float, penalty: float) -> float:
    return less if np.isinf(penalty) else objective + penalty * less


def _gained(program: LogProgram, at: Expansion, trial: Expansion, penalty: float) -> float:
    if not trial.is_finite:
        return -np.inf
    less = float(violation(program, at.values) - violation(program, trial.values))
    return _gain(float(at.values[0] - trial.values[0]), less, penalty)


def _newton_end(
    program: LogProgram, start: Floats, step: ModelStep, iterations: int
) -> Descent | None:
    """Return the nearby optimum found by Newton's method on the active rows, if any."""
    y, multipliers = polish(
        program.expand, start, step.multipliers, program.inequalities, rank=RANK, reach=10.0 * NEAR
    )
    at = program.expand(y)
    residual = kkt_residual(at, multipliers, program.inequalities)
    if not residual <= KKT * (1.0 + np.abs(multipliers).max(initial=0.0)):
        return None
    violated = float(violation(program, at.values))
    return Descent(Outcome.CONVERGED, y, at.values, multipliers, violated, residual, iterations)


def _is_at_rim(program: LogProgram, y: Floats) -> bool:
    """Return whether a variable has reached the limits of its search."""
    return bool((np.minimum(y - program.low, program.high - y) <= RIM).any())


def _run_away(
    program: LogProgram,
    y: Floats,
    at: Expansion,
    multipliers: Floats,
    iteration: int,
    *,
    feasible: bool,
) -> Descent:
    """Return the end of a descent at a variable's limit: unbounded if it was feasible before."""
    outcome = Outcome.UNBOUNDED if feasible else Outcome.INFEASIBLE
    return _ended(program, outcome, y, at, multipliers, iteration)


def _ended(
    program: LogProgram,
    outcome: Outcome,
    y: Floats,
    at: Expansion,
    multipliers: Floats,
    iterations: int,
) -> Descent:
    residual = np.inf
    if outcome is Outcome.CONVERGED:
        residual = kkt_residual(at, multipliers, program.inequalities)
    violated = float(violation(program, at.values))
    return Descent(outcome, y, at.values, multipliers, violated, residual, iterations)
