"""Primal-dual interior-point method for convex rows, and the Newton step that ends it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.log_sum_exp import Expansion, LogSumExp
from flexcli.numerics.signomial import Floats

BARRIER_START = 0.1
"""First barrier weight: objectives are logarithms, so their natural scale is one."""
BARRIER_END = 1e-10
"""Last barrier weight; below it rounding in the Newton matrix grows, and `polish` takes over."""
CENTRED = 10.0
"""A centre is good enough when its residual is within this factor of the barrier weight."""
SHRINK, SUPERLINEAR = 0.1, 1.5
"""μ → min(0.1 μ, μ^1.5), the superlinear rule of Wächter and Biegler (2006), eq. (7)."""
TO_BOUNDARY = 0.99
"""Share of the way to the nearest constraint that one step may take."""
SUFFICIENT = 1e-4
"""Armijo's constant: share of the predicted fall a step must bring."""
DUAL_BAND = 1e8
"""Multipliers stay within this factor of μ/slack, which keeps the Newton matrix a descent one."""
LONGEST_STEP = 20.0
"""Longest first step in the logarithms (a factor 5e8); later steps may double the way made."""
TETHER = 0.01
"""Stiffness, times μ, of the pull towards the start: where slacks can grow without end the
barrier alone has no minimiser. The pull fades with μ, and so does not move the optimum."""
HORIZON = 300.0
"""Distance in logarithms (a factor 1e130) at which the recession test is made."""
ITERATIONS = 200
REGULAR = 1e-14
"""Relative increase of the Newton matrix's diagonal, which keeps flat directions bounded."""
SAME_RANK = 1e-11
"""Singular values below this share of the largest are zero in the last Newton systems."""
POLISH_STEPS = 8
POLISHED = 1e-12
"""KKT residual below which the guess of the active rows was right."""
ACTIVE_RATIOS = (1.0, 1e6)
"""Multiplier over slack that marks an active row, in the order tried."""
ROUNDING = 1e-13
"""Change of a barrier function, relative to its size, that rounding alone can cause."""


@dataclass(frozen=True, eq=False)
class Point:
    """Where a path ended: y, multipliers of rows 1.., the state of convergence."""

    y: Floats
    multipliers: Floats
    converged: bool
    iterations: int


def central_path(
    rows: LogSumExp,
    y: Floats,
    *,
    enough: float = -np.inf,
    falls_forever: Callable[[], bool] | None = None,
) -> Point:
    r"""Minimise row 0 subject to the other rows ≤ 0, from a point strictly inside.

    Newton's method on the primal-dual equations

    .. math:: \nabla f_0 + \sum \lambda_i \nabla f_i = 0, \quad -\lambda_i f_i = \mu

    with a line search on the barrier function :math:`f_0 - \mu \sum \ln(-f_i)`, plus
    a weak pull towards the start, for which the primal-dual direction is one of descent, while
    μ falls. Every iterate stays strictly inside.

    Parameters
    ----------
    rows
        The objective and the constraints.
    y
        A point with all constraints negative.
    enough
        Stop as soon as the objective is at most this.
    falls_forever
        Asked when the iterates pass the horizon; a true answer ends the run.

    References
    ----------
    A. Forsgren, P. E. Gill, M. H. Wright (2002), Interior methods for nonlinear optimization,
    SIAM Review 44(4), §5; A. Wächter, L. T. Biegler (2006), Math. Program. 106, §2.
    """
    start, horizon = y, HORIZON
    at = rows.expand(y)
    slack = -at.values[1:]
    mu = BARRIER_START
    multipliers = mu / slack
    for iteration in range(ITERATIONS):
        if at.values[0] <= enough:
            return Point(y, multipliers, True, iteration)
        gradient, J = at.jacobian[0], at.jacobian[1:]
        stationarity = gradient + multipliers @ J
        tether = TETHER * (y - start)
        products = multipliers * slack
        while _is_centre(stationarity + mu * tether, products - mu, mu):
            if mu <= BARRIER_END:
                return Point(y, multipliers, True, iteration)
            mu = max(BARRIER_END, min(SHRINK * mu, mu**SUPERLINEAR))
        stiffness = multipliers / slack
        H = at.curvature(np.concatenate([[1.0], multipliers])) + J.T @ (J * stiffness[:, None])
        H.flat[:: y.size + 1] += REGULAR * np.diagonal(H) + mu * TETHER
        slope = gradient + (mu / slack) @ J + mu * tether
        try:
            step = -np.linalg.solve(H, slope)
        except np.linalg.LinAlgError:
            step = -np.linalg.lstsq(H, slope, rcond=REGULAR)[0]
        moved = J @ step
        multiplier_step = mu / slack - multipliers + stiffness * moved

        way = max(LONGEST_STEP, float(np.abs(y - start).max()))
        length = min(
            1.0,
            way / (float(np.abs(step).max()) + 1e-300),
            TO_BOUNDARY / float((moved / slack).max(initial=TO_BOUNDARY)),
        )
        merit = at.values[0] + mu * (_pull(tether) - np.log(slack).sum())
        noise = ROUNDING * (1.0 + abs(at.values[0]) + mu * np.abs(np.log(slack)).sum())
        fall = SUFFICIENT * float(slope @ step)
        while True:
            trial = y + length * step
            values = rows.values(trial)
            inside = -values[1:]
            if (inside > (1.0 - TO_BOUNDARY) * 0.5 * slack).all():
                away = _pull(TETHER * (trial - start))
                new_merit = values[0] + mu * (away - np.log(inside).sum())
                if new_merit <= merit + length * fall + noise:
                    break
            length *= 0.5
            if length < 1e-14:
                return Point(y, multipliers, False, iteration)
        y = trial
        at = rows.expand(y)
        slack = -at.values[1:]
        shrinking = -multiplier_step / multipliers
        dual_length = min(1.0, TO_BOUNDARY / float(shrinking.max(initial=TO_BOUNDARY)))
        multipliers = np.clip(
            multipliers + dual_length * multiplier_step,
            mu / slack / DUAL_BAND,
            mu / slack * DUAL_BAND,
        )
        if falls_forever is not None and np.abs(y - start).max() > horizon:
            if falls_forever():
                return Point(y, multipliers, False, iteration + 1)
            horizon = np.inf
    return Point(y, multipliers, False, ITERATIONS)


def _is_centre(stationarity: Floats, complementarity: Floats, mu: float) -> bool:
    largest = max(
        float(np.abs(stationarity).max(initial=0.0)),
        float(np.abs(complementarity).max(initial=0.0)),
    )
    return largest <= CENTRED * mu


def _pull(tether: Floats) -> float:
    return float(tether @ tether) / (2.0 * TETHER)


def kkt_residual(at: Expansion, multipliers: Floats, inequalities: int) -> float:
    """Return the largest violation of the Karush-Kuhn-Tucker conditions, all in logarithms.

    Stationarity, feasibility, sign of the multipliers of inequalities, complementarity.
    `multipliers` belong to rows 1..; the first `inequalities` of these are inequalities.
    Infinite where rows are no numbers.
    """
    if not at.is_finite:
        return np.inf
    f, g = at.values[1 : 1 + inequalities], at.values[1 + inequalities :]
    unequal = multipliers[:inequalities]
    return max(
        float(np.abs(at.jacobian[0] + multipliers @ at.jacobian[1:]).max(initial=0.0)),
        float(f.max(initial=0.0)),
        float(np.abs(g).max(initial=0.0)),
        float((-unequal).max(initial=0.0)),
        float(np.abs(unequal * f).max(initial=0.0)),
    )


def polish(
    expand: Callable[[Floats], Expansion],
    y: Floats,
    multipliers: Floats,
    inequalities: int,
    *,
    rank: float = SAME_RANK,
    reach: float = np.inf,
) -> tuple[Floats, Floats]:
    r"""Return y and multipliers to rounding, by Newton's method on the active rows.

    A row is active when its multiplier exceeds its slack, or exceeds it by far: the second
    guess is for slacks that are small themselves, where bounds almost meet. The system

    .. math:: \begin{pmatrix} \nabla^2 L & J_a^T \\ J_a & 0 \end{pmatrix}
              \begin{pmatrix} \Delta y \\ \lambda_a \end{pmatrix}
              = -\begin{pmatrix} \nabla f_0 \\ f_a \end{pmatrix}

    is solved in the least-squares sense of smallest change, so redundant rows and flat
    directions of the objective do no harm: singular values below the share ``rank`` of the
    largest count as zero. A step is kept only when it lowers the residual, and leads no farther
    than ``reach`` from where it began.
    """
    slack = -expand(y).values[1 : 1 + inequalities]
    equal = np.ones(multipliers.size - inequalities, dtype=bool)
    guess = multipliers[:inequalities]
    for exceeds in ACTIVE_RATIOS:
        active = np.append(guess > exceeds * slack, equal)
        y, multipliers = _newton_on(expand, y, multipliers, inequalities, active, rank, reach)
        if kkt_residual(expand(y), multipliers, inequalities) <= POLISHED:
            break
    return y, multipliers


def _newton_on(
    expand: Callable[[Floats], Expansion],
    y: Floats,
    multipliers: Floats,
    inequalities: int,
    active: NDArray[np.bool_],
    rank: float,
    reach: float,
) -> tuple[Floats, Floats]:
    at = expand(y)
    best = kkt_residual(at, multipliers, inequalities)
    chosen = np.flatnonzero(active)
    multipliers_now = np.where(active, multipliers, 0.0)
    n, start = y.size, y
    for _ in range(POLISH_STEPS):
        J = at.jacobian[1 + chosen]
        system = np.zeros((n + chosen.size, n + chosen.size))
        system[:n, :n] = at.curvature(np.concatenate([[1.0], multipliers_now]))
        system[:n, n:] = J.T
        system[n:, :n] = J
        stationarity = at.jacobian[0] + multipliers_now[chosen] @ J
        change = np.linalg.lstsq(
            system, -np.concatenate([stationarity, at.values[1 + chosen]]), rcond=rank
        )[0]
        y_next = y + change[:n]
        if np.abs(y_next - start).max(initial=0.0) > reach:
            break
        multipliers_next = multipliers_now.copy()
        multipliers_next[chosen] += change[n:]
        # Below zero by rounding only: zero is the better multiplier.
        tiny = ROUNDING * (1.0 + np.abs(multipliers_next).max(initial=0.0))
        unequal = multipliers_next[:inequalities]
        unequal[np.abs(unequal) <= tiny] = 0.0
        at_next = expand(y_next)
        residual = kkt_residual(at_next, multipliers_next, inequalities)
        if not residual < best:
            break
        y, multipliers, multipliers_now = y_next, multipliers_next, multipliers_next
        at, best = at_next, residual
    return y, multipliers
