"""Convex rows with affine equalities: phase I, faces without interior, minimum, multipliers."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import Outcome
from flexcli.numerics.interior_point import Point, central_path, kkt_residual, polish
from flexcli.numerics.log_sum_exp import LogSumExp
from flexcli.numerics.signomial import Floats

FEASIBLE = 1e-9
"""Log violation below which a set counts as feasible, and log margin below which its interior
counts as empty: some 1e5 roundings of a logarithm of size 50, and far below any tolerance of a
workshop."""
DEEP_ENOUGH = 0.1
"""Phase I stops at this log margin: the path to the optimum starts well from there."""
FLOOR = 1.0
"""Log margin that bounds phase I."""
INDEPENDENT = 1e-11
"""Equality rows of singular value below this share of the largest repeat others."""
SUPPORT = 1e-6
"""Phase I multipliers (they sum to one) above this mark the rows that hold the margin at zero."""
CERTIFIED = 1e-9
"""Optimality residual that proves a phase I done, however its path ended."""
FALLS = 1e-7
"""Slope above which a row is considered rising in the recession test, where −1 is asked of row
0."""
WIDE = 100.0
"""Half width of the box of the recession test: exponents of the objective down to 0.01 are seen."""


@dataclass(frozen=True, eq=False)
class Convex:
    """Minimise row 0 of `rows` subject to the other rows ≤ 0 and G y = d."""

    rows: LogSumExp
    G: Floats
    d: Floats


@dataclass(frozen=True, eq=False)
class ConvexOptimum:
    """Result of a convex solve in y; `violation` is phase I's least largest log violation.

    For an infeasible problem y is the point of least violation and the multipliers are its
    certificate: they sum to one over the conflicting rows. For an unbounded one the objective falls
    without limit along `direction`. The columns of `free` span the directions that equalities and
    rows without interior leave.
    """

    outcome: Outcome
    y: Floats
    multipliers: Floats
    equality_multipliers: Floats
    violation: float
    iterations: int
    direction: Floats
    free: Floats


@dataclass(frozen=True, eq=False)
class Hull:
    """The affine set y = origin + basis z of the solutions of G y = d."""

    origin: Floats
    basis: Floats
    mismatch: float


def affine_hull(G: Floats, d: Floats, near: Floats) -> Hull:
    """Solve G y = d by singular values: redundant rows drop out, the origin is nearest `near`."""
    if not d.size:
        return Hull(near, np.eye(near.size), 0.0)
    U, s, Vt = np.linalg.svd(G)
    rank = int((s > INDEPENDENT * s.max(initial=0.0)).sum())
    gap = d - G @ near
    origin = near + Vt[:rank].T @ ((U[:, :rank].T @ gap) / s[:rank])
    mismatch = float(np.abs(G @ origin - d).max(initial=0.0))
    return Hull(origin, Vt[rank:].T, mismatch)


def middle(rows: LogSumExp) -> Floats:
    """Return the y for which the terms are closest to one, in least squares of logarithms.

    It does not depend on the units of the variables, and is a fair start from nowhere.
    """
    return np.asarray(np.linalg.lstsq(rows.exponents, -rows.logs, rcond=INDEPENDENT)[0])


def least_violation(rows: LogSumExp, z: Floats, *, to_the_end: bool = False) -> Point:
    """Minimise t subject to rows 1.. ≤ t: phase I, a geometric program with one more variable.

    Returns the point with t as its last coordinate and multipliers of rows 1... Unless asked to
    go on to the end it stops when there is margin enough.
    """
    inner = rows.rows(range(1, rows.first.size))
    terms, n = inner.exponents.shape
    exponents = np.zeros((terms + 2, n + 1))
    exponents[0, n] = 1.0
    exponents[1:-1, :n] = inner.exponents
    exponents[1:, n] = -1.0
    lifted = LogSumExp(
        exponents,
        np.concatenate([[0.0], inner.logs, [-FLOOR]]),
        np.concatenate([[0], 1 + inner.first, [terms + 1]]),
    )
    top = max(float(inner.values(z).max(initial=-FLOOR)), -FLOOR) + 1.0
    point = central_path(lifted, np.append(z, top), enough=-np.inf if to_the_end else -DEEP_ENOUGH)
    if point.y[-1] > -DEEP_ENOUGH or to_the_end:
        y, multipliers = polish(lifted.expand, point.y, point.multipliers, point.multipliers.size)
        converged = point.converged or (
            kkt_residual(lifted.expand(y), multipliers, multipliers.size) <= CERTIFIED
        )
        # Keep t an honest bound: the largest row at the point returned.
        y[-1] = max(float(inner.values(y[:-1]).max(initial=-FLOOR)), -FLOOR)
        point = replace(point, y=y, multipliers=multipliers, converged=converged)
    return replace(point, multipliers=point.multipliers[:-1])


def recession(rows: LogSumExp) -> Floats | None:
    """Return a direction along which row 0 falls without limit and no other row rises, or None.

    Exponents alone decide (Farkas: there is none exactly when the dual has a feasible point): all
    terms of row 0 must fall and no term of the others may rise. Found by minimising the largest of
    a₀·d + 1 and a·d, which reaches zero exactly then.
    """
    terms, n = rows.exponents.shape
    own = rows.row == 0
    lines = np.vstack([np.zeros((1, n)), rows.exponents, np.eye(n), -np.eye(n)])
    logs = np.concatenate([[0.0], np.where(own, 1.0, 0.0), np.full(2 * n, -WIDE)])
    pack = LogSumExp(lines, logs, np.arange(terms + 1 + 2 * n))
    point = least_violation(pack, np.zeros(n), to_the_end=True)
    return point.y[:-1] if point.y[-1] <= FALLS else None


def minimize_convex(problem: Convex, near: Floats) -> ConvexOptimum:
    """Minimise a convex program from any start.

    1. Solve the equalities; go on in the remaining directions.
    2. Phase I, unless the start lies inside.
    3. Where there is no interior, some rows hold with equality in every feasible point: those
       that carry phase I's multipliers, since their weighted sum is non-negative everywhere.
       Such a row is constant on the feasible set, so each of its terms is: add these as
       equalities, drop the rows, repeat. (Two bounds that meet are the plain case.)
    4. Follow the central path, polish, and give dropped rows and equalities their multipliers.
    """
    rows, G, d = problem.rows, problem.G, problem.d
    count = rows.first.size - 1
    kept = np.arange(count)
    iterations = 0
    none = np.zeros(count)

    def ended(
        outcome: Outcome, y: Floats, t: float, direction: Floats | None = None
    ) -> ConvexOptimum:
        return ConvexOptimum(
            outcome, y, none, np.zeros(problem.d.size), t, iterations,
            np.zeros(y.size) if direction is None else direction, hull.basis,
        )  # fmt: skip

    while True:
        hull = affine_hull(G, d, near)
        if hull.mismatch > FEASIBLE:
            return ended(Outcome.INFEASIBLE, hull.origin, hull.mismatch)
        here = rows.rows([0, *(1 + kept)]).along(hull.origin, hull.basis)
        z = np.zeros(hull.basis.shape[1])
        margin = -float(here.values(z)[1:].max(initial=-DEEP_ENOUGH))
        if margin >= DEEP_ENOUGH:
            break
        phase = least_violation(here, z)
        iterations += phase.iterations
        z, t = phase.y[:-1], float(phase.y[-1])
        margin = -t
        if t > FEASIBLE:
            none[kept] = phase.multipliers
            outcome = Outcome.INFEASIBLE if phase.converged else Outcome.STALLED
            return ended(outcome, hull.origin + hull.basis @ z, t)
        if t < -FEASIBLE:
            break
        near = hull.origin + hull.basis @ z
        meeting = kept[phase.multipliers > SUPPORT]
        if not meeting.size:
            return ended(Outcome.STALLED, near, t)
        fixed = rows.rows((1 + meeting).tolist()).exponents
        fixed = fixed[np.abs(fixed).max(axis=1, initial=0.0) > 0.0]
        kept = np.setdiff1d(kept, meeting)
        G, d = np.vstack([G, fixed]), np.concatenate([d, fixed @ near])

    point = Point(z, np.zeros(kept.size), True, 0)
    direction: Floats | None = None
    if z.size:

        def falls_forever() -> bool:
            nonlocal direction
            direction = recession(here)
            return direction is not None

        point = central_path(here, z, falls_forever=falls_forever)
        if not point.converged and direction is None:
            falls_forever()
        iterations += point.iterations
    y = hull.origin + hull.basis @ point.y
    if direction is not None:
        return ended(Outcome.UNBOUNDED, y, -margin, hull.basis @ direction)
    z, kept_multipliers = polish(here.expand, point.y, point.multipliers, kept.size)
    y = hull.origin + hull.basis @ z
    multipliers, equal = _all_multipliers(problem, y, kept, kept_multipliers)
    outcome = Outcome.CONVERGED if point.converged else Outcome.STALLED
    return ConvexOptimum(
        outcome, y, multipliers, equal, -margin, iterations, np.zeros(y.size), hull.basis
    )


def _all_multipliers(
    problem: Convex, y: Floats, kept: NDArray[np.intp], known: Floats
) -> tuple[Floats, Floats]:
    """Return multipliers of all rows and equalities, given those of the rows kept."""
    multipliers = np.zeros(problem.rows.first.size - 1)
    multipliers[kept] = known
    dropped = np.setdiff1d(np.arange(multipliers.size), kept)
    if not (dropped.size or problem.d.size):
        return multipliers, np.zeros(0)
    J = problem.rows.expand(y).jacobian
    target = -(J[0] + multipliers @ J[1:])
    G = problem.G
    if not dropped.size:
        return multipliers, np.linalg.lstsq(G.T, target, rcond=INDEPENDENT)[0]
    columns = np.hstack([J[1 + dropped].T, G.T, -G.T])
    solved = non_negative_least_squares(columns, target)
    multipliers[dropped] = solved[: dropped.size]
    plus, minus = np.split(solved[dropped.size :], 2)
    return multipliers, plus - minus


def non_negative_least_squares(A: Floats, b: Floats) -> Floats:
    """Minimise ‖A x − b‖ over x ≥ 0, by Lawson and Hanson's active set.

    Reference: C. L. Lawson, R. J. Hanson (1974), Solving Least Squares Problems, ch. 23.
    """
    x = np.zeros(A.shape[1])
    free = np.zeros(x.size, dtype=bool)
    tolerance = (
        1e-12
        * (1.0 + float(np.abs(A).max(initial=0.0)))
        * (1.0 + float(np.abs(b).max(initial=0.0)))
    )
    for _ in range(3 * x.size):
        pull = np.where(free, -np.inf, A.T @ (b - A @ x))
        if not pull.size or pull.max() <= tolerance:
            break
        free[int(pull.argmax())] = True
        while True:
            trial = np.zeros(x.size)
            trial[free] = np.linalg.lstsq(A[:, free], b, rcond=INDEPENDENT)[0]
            blocking = free & (trial <= 0.0)
            if not blocking.any():
                break
            steps = x[blocking] / np.maximum(x[blocking] - trial[blocking], 1e-300)
            x = x + float(steps.min()) * (trial - x)
            free &= x > tolerance
            x[~free] = 0.0
            if not free.any():
                break
        x = np.where(free, trial, 0.0)
    return x
