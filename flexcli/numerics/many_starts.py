"""The best of many local optima of rows known as numbers, and ties between equally good points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from flexcli.numerics.black_box import BlackBox
from flexcli.numerics.convex_program import FEASIBLE, Status
from flexcli.numerics.geometric_program import ACTIVE, Outcome, Solution
from flexcli.numerics.signomial import Floats
from flexcli.numerics.successive import RIM, Descent, descend

__all__ = ["BestOfStarts", "best_of_starts", "solve_black_boxes", "spread", "starts_among"]

SAME = 1e-7
"""Optima whose log objectives differ by less are one."""
APART = 1.0
"""Distance, in logarithms, that starts keep from each other."""
HELD = 1e-7
"""Multiplier above which a row holds the optimum."""
FLAT = 1e-6
"""Curvature below this share of the largest counts as none."""
MOVED = 1e-7
"""Distance, in logarithms, by which a broken tie has moved the point."""
AS_GOOD = 1e-8
"""Log objective that a broken tie may cost: rounding along a plane of equally good points."""


@dataclass(frozen=True, eq=False)
class BestOfStarts:
    """The best end, how many optima the starts found, whether the point is the only best one.

    ``end`` has the multipliers of the first objective, at the point that broke the ties.
    """

    end: Descent
    optima: int
    unique: bool
    tied: bool


def spread(low: Floats, high: Floats, count: int) -> Floats:
    """Return points spread evenly over a box, shape (n, count), the centre first.

    References
    ----------
    M. Roberts (2018), The unreasonable effectiveness of quasirandom sequences: the additive
    sequence of the generalised golden ratio.

    """
    golden = 1.5
    for _ in range(60):
        golden = (1.0 + golden) ** (1.0 / (low.size + 1))
    steps = golden ** -np.arange(1.0, low.size + 1)
    shares = (0.5 + np.arange(count) * steps[:, None]) % 1.0
    return np.asarray(low[:, None] + shares * (high - low)[:, None])


def starts_among(points: Floats, values: Floats, inequalities: int, count: int) -> list[Floats]:
    """Return the best of many points, some distance from each other, by the rows' values there.

    Points that keep all rows come first, by their objective; then those that violate them least.
    """
    unequal, equal = values[1 : 1 + inequalities], np.abs(values[1 + inequalities :])
    worst = np.vstack([np.zeros((1, points.shape[1])), unequal, equal]).max(axis=0)
    sound = np.isfinite(values).all(axis=0)
    order = np.lexsort((np.where(worst > 0.0, 0.0, values[0]), np.where(sound, worst, np.inf)))
    chosen: list[Floats] = []
    for i in order[: int(sound.sum())].tolist():
        if all(np.abs(points[:, i] - other).max() >= APART for other in chosen):
            chosen.append(points[:, i])
        if len(chosen) == count:
            break
    return chosen


def solve_black_boxes(
    programs: Sequence[BlackBox],
    starts: Sequence[Floats],
    limits: Sequence[str],
    equalities: Sequence[str],
) -> Solution:
    """Return the best end of all starts, ties broken by the further programs, by names of rows."""
    found = best_of_starts(programs, starts)
    program, end = programs[0], found.end
    slack = end.values[1 : 1 + len(limits)].tolist()
    unequal, equal = np.split(end.multipliers, [len(limits)])
    rim = np.minimum(end.y - program.low, program.high - end.y) <= RIM
    unbounded = end.status is Status.UNBOUNDED
    with np.errstate(over="ignore", under="ignore"):
        x, objective = np.exp(end.y), float(np.exp(end.values[0]))
    return Solution(
        outcome=Outcome[end.status.name],
        x=dict(zip(program.names, x.tolist(), strict=True)),
        objective=objective,
        multipliers=dict(zip(limits, unequal.tolist(), strict=True)),
        equality_multipliers=dict(zip(equalities, equal.tolist(), strict=True)),
        active=tuple(k for k, value in zip(limits, slack, strict=True) if abs(value) <= ACTIVE),
        slack=dict(zip(limits, slack, strict=True)),
        gap=float("inf"),
        kkt_residual=end.residual,
        iterations=end.iterations,
        certificate="local",
        unique=found.unique,
        optima=found.optima,
        violation=end.violation,
        runaway=tuple(n for n, at in zip(program.names, rim, strict=True) if unbounded and at),
        tie_breakers=("next objective",) if found.tied else (),
    )


def best_of_starts(programs: Sequence[BlackBox], starts: Sequence[Floats]) -> BestOfStarts:
    """Return the best end of all starts; where it is not unique, the best by the next objective.

    The programs differ in their row 0 only, the objective. Directions along which neither the
    objective nor a row that holds it changes to second order lead to equally good points; the
    next program is solved on the plane that they span. A point found there is kept when it is
    feasible and as good by the first objective.
    """
    first, optima = _best(programs[0], starts)
    if first.status is not Status.CONVERGED:
        return BestOfStarts(first, optima, False, False)
    y, held = first.y, first.multipliers
    kept = [i for i in range(programs[0].inequalities) if abs(held[i]) <= HELD]
    basis = _flat(programs[0], first)
    tied = False
    for program in programs[1:]:
        if not basis.shape[1]:
            break
        part = program.chosen(kept).along(y, basis)
        end = descend(part, np.zeros(basis.shape[1]))
        if end.status is not Status.CONVERGED:
            continue
        moved = y + basis @ end.y
        values = programs[0].rows(moved[:, None])[:, 0]
        if programs[0].violation(values) > FEASIBLE or abs(values[0] - first.values[0]) > AS_GOOD:
            continue
        tied |= bool(np.abs(moved - y).max() > MOVED)
        y, basis = moved, basis @ _flat(part, end)
        kept = [i for i, weight in zip(kept, end.multipliers, strict=True) if weight <= HELD]
    values = programs[0].rows(y[:, None])[:, 0]
    end = replace(first, y=y, values=values, violation=programs[0].violation(values))
    return BestOfStarts(end, optima, not basis.shape[1], tied)


def _best(program: BlackBox, starts: Sequence[Floats]) -> tuple[Descent, int]:
    """Return the best end with the steps of all, and how many distinct optima were found."""
    ends: list[Descent] = []
    for start in starts:
        known = [end for end in ends if end.status is Status.CONVERGED]
        ends.append(descend(program, start, known))
        if ends[-1].status is Status.UNBOUNDED:
            break
    order = (Status.UNBOUNDED, Status.CONVERGED, Status.STALLED, Status.INFEASIBLE)

    def rank(end: Descent) -> tuple[int, float]:
        infeasible = end.status is Status.INFEASIBLE
        return order.index(end.status), end.violation if infeasible else float(end.values[0])

    best = min(ends, key=rank)
    distinct: list[float] = []
    for end in ends:
        value = float(end.values[0])
        if end.status is Status.CONVERGED and all(abs(value - o) > SAME for o in distinct):
            distinct.append(value)
    total = sum(end.iterations for end in ends)
    return replace(best, iterations=total), len(distinct)


def _flat(program: BlackBox, end: Descent) -> Floats:
    """Return the directions, as orthonormal columns, that lead to equally good points."""
    at = program.taylor(end.y)
    unequal = end.multipliers[: program.inequalities]
    holding = np.append(unequal > HELD, np.ones(end.multipliers.size - unequal.size, dtype=bool))
    J = at.gradients[1:][holding]
    tangent = np.eye(end.y.size)
    size = max(1.0, float(np.abs(at.gradients).max()))
    if J.size:
        _, s, Vt = np.linalg.svd(J)
        tangent = Vt[int((s > FLAT * size).sum()) :].T
    H = np.tensordot(np.append(1.0, end.multipliers), at.curvatures, axes=1)
    bends, ways = np.linalg.eigh(tangent.T @ H @ tangent)
    return np.asarray(tangent @ ways[:, np.abs(bends) <= FLAT * size**2])
