"""Ties between equally good designs: minimise further objectives over the optima of the first."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from flexcli.numerics.geometric_program import ACTIVE, Solution, minimize, objective_ratio
from flexcli.numerics.log_sum_exp import program
from flexcli.numerics.ratios import Equality, Ratio, Settled, monomial_below
from flexcli.numerics.signomial import Signomial, as_signomial


def minimize_lexicographic(
    objectives: Sequence[Signomial | Ratio],
    constraints: Sequence[Ratio | Settled],
    equalities: Sequence[Equality],
    names: Sequence[str],
    starts: Sequence[Mapping[str, float]] = (),
) -> Solution:
    """Minimise the first objective; where its optimum is not unique, the next over all optima.

    Notes
    -----
    Over the optima of a convex program every term of the objective, and of each constraint with
    a positive multiplier, is constant: the Lagrangian is convex and constant there. Fixing these
    terms holds the optimum to rounding, where a bound on the objective would leave a set without
    interior. For non-convex rows the condensed program at the optimum is held, which may be
    less than all of its optima. Multipliers are those of the first objective.
    """
    first = minimize(objectives[0], constraints, equalities, names, starts)
    result, used = first, []
    rows: list[Ratio | Settled] = list(constraints)
    held: list[Equality] = list(equalities)
    current: Signomial | Ratio = objectives[0]
    for k, following in enumerate(objectives[1:], start=2):
        if not result.converged or result.unique:
            break
        binding = [
            row
            for row in rows
            if isinstance(row, Ratio) and result.multipliers.get(row.name, 0.0) > ACTIVE
        ]
        for row in (objective_ratio(current), *binding):
            held += _held_terms(row, result.x)
        rows = [row for row in rows if row not in binding]
        attempt = minimize(following, rows, held, names, [result.x])
        if not attempt.converged:
            continue
        result, current = attempt, following
        used.append(following.name if isinstance(following, Ratio) else f"objective {k}")
    if not used:
        return first
    return _at_another_optimum(first, result, constraints, tuple(used), objectives[0])


def log_value(row: Ratio | Equality, x: Mapping[str, float]) -> float:
    """Return ln(numerator/denominator) at x, also where a product leaves the floating range."""
    names = tuple(x)
    y = np.log(list(x.values()))
    one = as_signomial(1.0)
    sides = [
        program(Ratio(row.name, side, one), [], [], names).values(y)[0]
        for side in (row.numerator, row.denominator)
    ]
    return float(sides[0] - sides[1])


def _held_terms(row: Ratio, x: Mapping[str, float]) -> list[Equality]:
    below = monomial_below(row.denominator, x)
    one = as_signomial(1.0)
    shares = [
        (term / below, log_value(Ratio(row.name, term, below), x)) for term in row.numerator.terms()
    ]
    return [
        Equality(f"{row.name} held, term {k}", share / math.exp(value), one)
        for k, (share, value) in enumerate(shares, start=1)
    ]


def _at_another_optimum(
    first: Solution,
    last: Solution,
    constraints: Sequence[Ratio | Settled],
    used: tuple[str, ...],
    objective: Signomial | Ratio,
) -> Solution:
    rows = [row for row in constraints if isinstance(row, Ratio)]
    slack = {row.name: log_value(row, last.x) for row in rows}
    return replace(
        first,
        x=last.x,
        objective=math.exp(log_value(objective_ratio(objective), last.x)),
        slack=first.slack | slack,
        active=tuple(name for name, value in slack.items() if abs(value) <= ACTIVE),
        gap=abs(sum(first.multipliers[name] * value for name, value in slack.items())),
        kkt_residual=max(first.kkt_residual, last.kkt_residual),
        iterations=first.iterations + last.iterations,
        unique=last.unique,
        violation=max(slack.values(), default=-math.inf),
        tie_breakers=used,
    )
