"""Programs whose rows are known only as numbers: convex models in a trust region."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from flexcli.numerics.black_box import BlackBox
from flexcli.numerics.convex_model import ModelStep, best_step
from flexcli.numerics.convex_program import FEASIBLE, Status
from flexcli.numerics.log_stencil import STEP, Taylor
from flexcli.numerics.signomial import Floats

__all__ = ["RIM", "Descent", "descend"]

MODELS = 80
"""Models at the most from one start."""
TRUST, WIDEST, NARROWEST = 1.0, 6.0, 1e-11
"""First, largest and least half width of the trust region, in logarithms."""
POOR, GOOD = 0.05, 0.5
"""Share of the predicted gain below which a step is taken back, above which the region grows."""
PENALTIES = (1e2, 1e4, np.inf)
"""Weight of the largest violation against the objective; infinite leaves only the violation."""
NEAR = 0.1
"""Steps shorter than this are near enough for Newton to end the run."""
KKT = 1e-9
"""Residual of the optimality conditions, in logarithms, at which a point is an optimum."""
NO_GAIN = 1e-9
"""A predicted gain below this, in logarithms, is none: the models are solved no closer. Within a
trust region that is not narrow it makes an optimum, though too flat for Newton's method."""
RIM = 1e-6
"""Distance from the end of the world, in logarithms, at which a variable has run away."""
NOISE = 1e-14
"""Rounding of the rows, in logarithms."""
NEWTON_STEPS = 8
SAME_RANK = 1e-9
"""Singular values below this share of the largest are zero in Newton's systems, whose curvatures
are differences."""


@dataclass(frozen=True, eq=False)
class Descent:
    """Where a run ended: multipliers of the rows, their optimality residual, models solved.

    For an infeasible program y is a point of least largest violation (a local one) and the
    multipliers, which sum to one, tell the rows that conflict there.
    """

    status: Status
    y: Floats
    values: Floats
    multipliers: Floats
    violation: float
    residual: float
    iterations: int


def descend(program: BlackBox, y: Floats, known: Sequence[Descent] = ()) -> Descent:
    """Follow convex models of the rows from y to a local optimum, or until it comes to a known one.

    Each model is a posynomial per row with the row's value, gradient and convex curvature. Its
    optimum within the trust region is taken when the objective plus a penalty on the largest
    violation falls as the model says; near the end Newton's method on the rows takes over. Where
    the violation comes to rest above zero the penalty rises, until only the violation counts:
    what is still violated then is infeasible.

    References
    ----------
    R. Fletcher (1987), Practical Methods of Optimization, §14.4.

    """
    y = np.clip(y, program.low, program.high)  # a start may have run away already
    at = program.taylor(y)
    none = np.zeros(at.values.size - 1)
    if not at.is_finite:
        return _ended(program, Status.STALLED, y, at, none, 0)
    if _is_at_rim(program, y):
        return _run_away(program, y, at, none, 0)
    penalty, *heavier = PENALTIES
    reach = TRUST
    multipliers = none
    for iteration in range(1, MODELS + 1):
        low, high = np.maximum(-reach, program.low - y), np.minimum(reach, program.high - y)
        step = best_step(at, program.inequalities, low, high, penalty=penalty)
        multipliers = step.multipliers
        move = float(np.abs(step.step).max())
        predicted = _gain(step.fall, program.violation(at.values) - step.violation, penalty)
        resting, wide = predicted <= NO_GAIN, reach >= NEAR
        trial = program.taylor(y + step.step)
        gained = _gained(program, at, trial, penalty)
        taken = trial.is_finite and gained >= POOR * predicted and not resting
        if taken:
            y, at = y + step.step, trial
            if gained >= GOOD * predicted and move > 0.9 * reach:
                reach = min(WIDEST, 3.0 * reach)
        else:
            reach = 0.25 * min(move, reach)
        if _is_at_rim(program, y):
            return _run_away(program, y, at, multipliers, iteration)
        if step.violation <= FEASIBLE and not np.isinf(penalty):
            for other in known:
                if np.abs(y - other.y).max() <= NEAR:
                    return replace(other, iterations=iteration)
            if resting or (taken and move <= NEAR):
                ended = _newton_end(program, y, at, step, iteration)
                if ended is not None:
                    return ended
        if resting or reach <= NARROWEST:
            violated = program.violation(at.values) > FEASIBLE
            if not (violated and heavier):
                status = Status.INFEASIBLE if violated else Status.STALLED
                if not violated and resting and wide and not np.isinf(penalty):
                    status = Status.CONVERGED
                return _ended(program, status, y, at, multipliers, iteration)
            penalty, *heavier = heavier
            reach = TRUST
    return _ended(program, Status.STALLED, y, at, multipliers, MODELS)


def _gain(objective: float, violation: float, penalty: float) -> float:
    return violation if np.isinf(penalty) else objective + penalty * violation


def _gained(program: BlackBox, at: Taylor, trial: Taylor, penalty: float) -> float:
    if not trial.is_finite:
        return -np.inf
    less = program.violation(at.values) - program.violation(trial.values)
    return _gain(float(at.values[0] - trial.values[0]), less, penalty)


def _newton_end(
    program: BlackBox, y: Floats, at: Taylor, step: ModelStep, iterations: int
) -> Descent | None:
    """Return the optimum that Newton's method on the active rows comes to, if it is one near by.

    A row is active when its multiplier exceeds its slack. The system of the optimality conditions
    is solved for the smallest change, so redundant rows and flat directions do no harm.
    """
    m, n, start = program.inequalities, y.size, y
    unequal, equal = at.values[1 : 1 + m], np.ones(at.values.size - 1 - m, dtype=bool)
    chosen = np.flatnonzero(np.append(step.multipliers[:m] > -unequal, equal))
    multipliers = np.zeros(at.values.size - 1)
    multipliers[chosen] = step.multipliers[chosen]
    best = _residual(program, at, multipliers)
    done = NOISE / STEP
    for _ in range(NEWTON_STEPS):
        if best <= done:
            break
        J = at.gradients[1 + chosen]
        system = np.zeros((n + chosen.size, n + chosen.size))
        system[:n, :n] = np.tensordot(np.append(1.0, multipliers), at.curvatures, axes=1)
        system[:n, n:], system[n:, :n] = J.T, J
        slope = at.gradients[0] + multipliers[chosen] @ J
        wanted = -np.concatenate([slope, at.values[1 + chosen]])
        change = np.linalg.lstsq(system, wanted, rcond=SAME_RANK)[0]
        if np.abs(y + change[:n] - start).max() > 10.0 * NEAR:
            return None
        moved = multipliers.copy()
        moved[chosen] += change[n:]
        there = program.taylor(y + change[:n])
        residual = _residual(program, there, moved)
        if not residual < best:
            break
        y, at, multipliers, best = y + change[:n], there, moved, residual
    rounding = max(KKT, 8.0 * done) * (1.0 + np.abs(multipliers).max(initial=0.0))
    if not best <= rounding:
        return None
    violation = program.violation(at.values)
    return Descent(Status.CONVERGED, y, at.values, multipliers, violation, best, iterations)


def _residual(program: BlackBox, at: Taylor, multipliers: Floats) -> float:
    """Return the largest violation of the optimality conditions, in logarithms."""
    if not at.is_finite:
        return np.inf
    m = program.inequalities
    unequal = multipliers[:m]
    return max(
        float(np.abs(at.gradients[0] + multipliers @ at.gradients[1:]).max()),
        program.violation(at.values),
        float((-unequal).max(initial=0.0)),
        float(np.abs(unequal * at.values[1 : 1 + m]).max(initial=0.0)),
    )


def _is_at_rim(program: BlackBox, y: Floats) -> bool:
    """Return whether a variable has come to the ends between which it is looked for."""
    return bool((np.minimum(y - program.low, program.high - y) <= RIM).any())


def _run_away(
    program: BlackBox, y: Floats, at: Taylor, multipliers: Floats, iteration: int
) -> Descent:
    """Return the end of a descent at the rim: unbounded where it is feasible there."""
    ran = program.violation(at.values) <= FEASIBLE
    status = Status.UNBOUNDED if ran else Status.INFEASIBLE
    return _ended(program, status, y, at, multipliers, iteration)


def _ended(
    program: BlackBox, status: Status, y: Floats, at: Taylor, multipliers: Floats, iterations: int
) -> Descent:
    violation, residual = program.violation(at.values), np.inf
    if status is Status.CONVERGED:
        residual = _residual(program, at, multipliers)
    return Descent(status, y, at.values, multipliers, violation, residual, iterations)
