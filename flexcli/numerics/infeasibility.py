"""Why a geometric program has no solution: the smallest set of rows that disagree."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from flexcli.numerics.condensation import condense, starting_points
from flexcli.numerics.convex_program import (
    FEASIBLE,
    SUPPORT,
    Status,
    least_violation,
    middle,
)
from flexcli.numerics.geometric_program import Outcome, minimize, objective_ratio
from flexcli.numerics.log_sum_exp import Program, program
from flexcli.numerics.ratios import Equality, Ratio, Settled
from flexcli.numerics.signomial import Floats, as_signomial, variables

BUDGET = 400
"""Feasibility solves spent on proving that no smaller set exists, some 2 ms each."""
BRANCHES = 200_000
"""Branches of the hitting-set search per proof."""

Row = Ratio | Equality


@dataclass(frozen=True, eq=False)
class Conflict:
    """A smallest set of rows that cannot hold together.

    Parameters
    ----------
    violation
        Least largest log violation of all rows together: exp(violation) is the factor by which
        all rows must be relaxed at once. Not positive when there is no conflict.
    members
        Names of the conflicting rows; dropping any one of them leaves the others satisfiable.
        Empty when there is no conflict.
    smallest
        Whether it was proved that no set with fewer members conflicts.
    relaxations
        For each member the least factor by which it alone must be relaxed for all rows to hold,
        None where that does not help.
    certificate
        "global" when all rows are convex, else "local": infeasibility from many starts.
    solves
        Feasibility problems solved.
    """

    violation: float
    members: tuple[str, ...]
    smallest: bool
    relaxations: dict[str, float | None]
    certificate: Literal["global", "local"]
    solves: int


@dataclass(frozen=True, eq=False)
class _Trial:
    violation: float
    y: Floats
    weights: dict[int, float]


@dataclass(eq=False)
class _Oracle:
    """Answers whether a set of rows can hold together, and remembers the points it met."""

    exact: bool
    solve: Callable[[Sequence[int]], _Trial]
    values: Callable[[Floats], Floats]
    solves: int = 0
    violated: list[frozenset[int]] = field(default_factory=list)

    def __call__(self, chosen: Sequence[int]) -> _Trial:
        self.solves += 1
        trial = self.solve(chosen)
        self.violated.append(frozenset(np.flatnonzero(self.values(trial.y) > FEASIBLE).tolist()))
        return trial


def conflict(
    constraints: Sequence[Ratio | Settled],
    equalities: Sequence[Equality],
    names: Sequence[str],
    starts: Sequence[Mapping[str, float]] = (),
) -> Conflict:
    """Find the smallest set of rows that cannot hold together, and how far each is off.

    Notes
    -----
    1. Phase I minimises the largest log violation. Rows with a multiplier conflict by
       themselves; by Helly's theorem n + 1 of them suffice for convex rows in n variables.
    2. A deletion filter makes the set irreducible (J. W. Chinneck (2008), Feasibility and
       Infeasibility in Optimization, §6.2).
    3. No smaller set exists when every set with fewer rows can hold. A conflicting set must
       contain a row violated at each point known, so only hitting sets of the rows violated at
       the points met so far need a solve (A. Ignatiev et al. (2015), Smallest MUS extraction
       with minimal hitting set dualization, CP 2015). Effort is bounded; `smallest` tells.
    """
    names = tuple(names)
    for row in constraints:
        if isinstance(row, Settled) and not row.holds:
            return Conflict(np.inf, (row.name,), True, {row.name: None}, "global", 0)
    rows: list[Row] = [row for row in constraints if isinstance(row, Ratio)]
    rows += equalities
    is_convex = all(row.is_convex for row in rows)
    oracle = _oracle(rows, names, starts, is_convex)
    everything = list(range(len(rows)))
    whole = oracle(everything)
    certificate: Literal["global", "local"] = "global" if is_convex else "local"
    if whole.violation <= FEASIBLE:
        return Conflict(whole.violation, (), False, {}, certificate, oracle.solves)

    members = [i for i, weight in whole.weights.items() if weight > SUPPORT]
    candidates = _undominated(rows, names)
    if not members or oracle(members).violation <= FEASIBLE:
        members = sorted(candidates)
    for i in list(members):
        rest = [j for j in members if j != i]
        if oracle(rest).violation > FEASIBLE:
            members = rest
    found, proved = _smaller(oracle, len(members), candidates)
    members = sorted(found or members)
    return Conflict(
        whole.violation,
        tuple(rows[i].name for i in members),
        proved and is_convex,
        {rows[i].name: _relaxation(rows, i, names, starts) for i in members},
        certificate,
        oracle.solves,
    )


def _oracle(
    rows: Sequence[Row],
    names: tuple[str, ...],
    starts: Sequence[Mapping[str, float]],
    is_convex: bool,
) -> _Oracle:
    """Return the feasibility oracle; an equality is the pair of ratios that meet at one."""
    nothing = objective_ratio(as_signomial(1.0))
    pairs: list[Ratio] = []
    owner: list[int] = []
    for i, row in enumerate(rows):
        pairs.append(Ratio(row.name, row.numerator, row.denominator))
        owner.append(i)
        if isinstance(row, Equality):
            pairs.append(Ratio(row.name, row.denominator, row.numerator))
            owner.append(i)
    problem = program(nothing, pairs, [], names)
    owners = np.array(owner, dtype=np.intp)
    last = middle(problem.above)

    def values(y: Floats) -> Floats:
        largest = np.full(len(rows), -np.inf)
        np.maximum.at(largest, owners, problem.values(y)[1:])
        return largest

    def convex(chosen: Sequence[int]) -> _Trial:
        (picked,) = np.nonzero(np.isin(owners, list(chosen)))
        if not picked.size:
            return _Trial(-np.inf, last, {})
        point = least_violation(problem.above.rows([0, *(1 + picked).tolist()]), last)
        weights: dict[int, float] = {}
        for i, weight in zip(owners[picked].tolist(), point.multipliers.tolist(), strict=True):
            weights[i] = max(weights.get(i, 0.0), weight)
        return _Trial(float(point.y[-1]), point.y[:-1], weights)

    def condensed(chosen: Sequence[int]) -> _Trial:
        picked = [rows[i] for i in chosen]
        ratios = [row for row in picked if isinstance(row, Ratio)]
        equal = [row for row in picked if isinstance(row, Equality)]
        part: Program = program(nothing, ratios, equal, names)
        best = _Trial(np.inf, last, {})
        for start in starting_points(part, ratios, equal, starts):
            found = condense(part, start)
            reached = part.values(found.y)[1:]
            reached[len(ratios) :] = np.abs(reached[len(ratios) :])
            violation = float(reached.max(initial=-np.inf))
            if violation < best.violation:
                best = _Trial(violation, found.y, {})
            if found.status is Status.CONVERGED and violation <= FEASIBLE:
                break
        return best

    return _Oracle(is_convex, convex if is_convex else condensed, values)


def _smaller(
    oracle: _Oracle, size: int, candidates: frozenset[int]
) -> tuple[list[int] | None, bool]:
    """Return a conflicting set below `size` members, if any, and whether the answer is proved."""
    allowed = oracle.solves + (BUDGET if oracle.exact else 0)
    for smaller in range(1, size):
        while True:
            if oracle.solves >= allowed:
                return None, False
            branches = [BRANCHES]
            sets = [violated & candidates for violated in oracle.violated if violated]
            chosen = _hitting_set(sets, smaller, branches)
            if branches[0] <= 0:
                return None, False
            if chosen is None:
                break
            if oracle(chosen).violation > FEASIBLE:
                return chosen, True
    return None, True


def _hitting_set(
    sets: Sequence[frozenset[int]], size: int, branches: list[int]
) -> list[int] | None:
    """Return at most `size` elements that meet every set, or None."""
    if not sets:
        return []
    branches[0] -= 1
    if size == 0 or branches[0] <= 0:
        return None
    for element in min((sorted(s) for s in sets), key=len):
        rest = _hitting_set([s for s in sets if element not in s], size - 1, branches)
        if rest is not None:
            return [element, *rest]
    return None


def _undominated(rows: Sequence[Row], names: tuple[str, ...]) -> frozenset[int]:
    """Return the rows without monomials that a larger one with the same exponents implies."""
    strongest: dict[tuple[float, ...], tuple[float, int]] = {}
    kept: set[int] = set()
    for i, row in enumerate(rows):
        if isinstance(row, Equality) or not (
            row.numerator.is_monomial and row.denominator.is_monomial
        ):
            kept.add(i)
            continue
        term = row.numerator / row.denominator
        key = tuple(term.aligned(names)[0].tolist())
        size = float(term.coefficients[0])
        if key not in strongest or size > strongest[key][0]:
            strongest[key] = (size, i)
    return frozenset(kept | {i for _, i in strongest.values()})


def _relaxation(
    rows: Sequence[Row],
    member: int,
    names: tuple[str, ...],
    starts: Sequence[Mapping[str, float]],
) -> float | None:
    row = rows[member]
    others = [other for i, other in enumerate(rows) if i != member]
    ratios = [other for other in others if isinstance(other, Ratio)]
    equal = [other for other in others if isinstance(other, Equality)]
    if isinstance(row, Ratio):
        solution = minimize(row, ratios, equal, names, starts)
    else:
        (factor,) = variables("factor of relaxation")
        ratios += [
            Ratio(f"{row.name}, not above", row.numerator, row.denominator * factor),
            Ratio(f"{row.name}, not below", row.denominator, row.numerator * factor),
        ]
        solution = minimize(factor, ratios, equal, (*names, *factor.names), starts)
    return solution.objective if solution.outcome is Outcome.CONVERGED else None
