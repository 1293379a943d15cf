"""Why a program has no solution: the smallest conflicting set of requirements."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.convex_program import FEASIBLE, SUPPORT, least_violation, middle
from flexcli.numerics.log_program import LogProgram, violation
from flexcli.numerics.many_starts import starts_among
from flexcli.numerics.signomial import Floats
from flexcli.numerics.successive import descend

__all__ = ["APART", "STARTS", "Conflict", "conflict"]

BUDGET = 400
"""Feasibility solves spent on proving that no smaller set exists, some 2 ms each."""
BRANCHES = 200_000
"""Branches of the hitting-set search per proof."""
STARTS, APART = 8, 3.0
"""Local runs that look for a point where rows that are not convex hold together, and how far in
logarithms they start from each other: most runs near each other end alike."""
SAME = 1e-12
"""Rows whose difference varies by less than this, in logarithms, differ by a constant."""


class Conflict(NamedTuple):
    """Requirements, by their places, that cannot hold together; none where all can.

    Dropping any one of them leaves the others satisfiable. ``smallest`` tells whether it was
    proved that no set with fewer members conflicts; ``violation`` is the least largest log
    violation of all rows together.
    """

    members: tuple[int, ...]
    smallest: bool
    violation: float


@dataclass(eq=False)
class _Oracle:
    """Decides whether requirements can hold together, and remembers those that a point violates."""

    program: LogProgram
    owners: NDArray[np.intp]
    points: Floats
    solves: int = 0
    violated: list[frozenset[int]] = field(default_factory=list)

    def __post_init__(self) -> None:
        values = self.program.rows(self.points)[1:]
        columns = np.unique(~(values <= FEASIBLE), axis=1).T
        for found in sorted((frozenset(self.owners[c].tolist()) for c in columns), key=len):
            if not any(known <= found for known in self.violated):
                self.violated.append(found)

    def __call__(self, chosen: Sequence[int]) -> tuple[float, dict[int, float]]:
        """Return the least largest violation, and the weights of the requirements in it."""
        if any(not some & set(chosen) for some in self.violated):
            return 0.0, {}
        self.solves += 1
        kept = np.flatnonzero(np.isin(self.owners, list(chosen)))
        y, weights = _least_violating(self.program.chosen(kept.tolist()), self.points)
        values = self.program.rows(y[:, None])[1:, 0]
        self.violated.append(frozenset(self.owners[~(values <= FEASIBLE)].tolist()))
        found: dict[int, float] = {}
        for owner, weight in zip(self.owners[kept].tolist(), weights.tolist(), strict=True):
            found[owner] = max(found.get(owner, 0.0), weight)
        return float(values[kept].max(initial=-np.inf)), found


def conflict(program: LogProgram, owners: Sequence[int], points: Floats) -> Conflict:
    """Find the smallest set of requirements that cannot hold together.

    Parameters
    ----------
    program : LogProgram
        A program without equalities, whose objective does not matter.
    owners : sequence of int
        The requirement, counted from 0, that each inequality belongs to: one that demands
        equality has two.
    points : array, shape (n, points)
        Points to start from, and to learn from what is violated there.

    Notes
    -----
    1. Phase I minimises the largest log violation. Rows with a multiplier conflict by
       themselves; by Helly's theorem n + 1 of them suffice for convex rows in n variables.
    2. A deletion filter makes the set irreducible (J. W. Chinneck (2008), Feasibility and
       Infeasibility in Optimization, §6.2).
    3. No smaller set exists when every set with fewer rows can hold. A conflicting set must
       contain a row violated at each point known, so only hitting sets of the rows violated at
       the points met so far need a solve (A. Ignatiev et al. (2015), Smallest MUS extraction
       with minimal hitting set dualization, CP 2015). Effort is bounded; `smallest` tells. Where
       rows are not convex nothing is proved, and this is left out.
    """
    oracle = _Oracle(program, np.array(owners, dtype=np.intp), points)
    whole, weights = oracle(sorted(set(owners)))
    if whole <= FEASIBLE:
        return Conflict((), False, whole)
    members = sorted(owner for owner, weight in weights.items() if weight > SUPPORT)
    candidates = _undominated(oracle)
    if not members or oracle(members)[0] <= FEASIBLE:
        members = sorted(candidates)
    for one in list(members):
        rest = [other for other in members if other != one]
        if rest and oracle(rest)[0] > FEASIBLE:
            members = rest
    if not program.is_convex:
        return Conflict(tuple(members), False, whole)
    found, proved = _smaller(oracle, len(members), candidates)
    return Conflict(tuple(sorted(found or members)), proved, whole)


def _least_violating(program: LogProgram, points: Floats) -> tuple[Floats, Floats]:
    """Return a point of least largest violation, and the weights of the rows there."""
    if program.is_convex:
        origin = np.zeros(len(program.names))
        rows = program.model(program.expand(origin), origin)
        point = least_violation(rows, middle(rows))
        return point.y[:-1], point.multipliers
    ends = []
    for start in starts_among(program, points, STARTS, apart=APART):
        ends.append(descend(program, start, penalties=(np.inf,)))
        if violation(program, ends[-1].values) <= FEASIBLE:
            break
    best = min(ends, key=lambda end: end.violation)
    return best.y, best.multipliers


def _smaller(
    oracle: _Oracle, size: int, candidates: frozenset[int]
) -> tuple[list[int] | None, bool]:
    """Return a conflicting set below `size` members, if any, and whether the answer is proved."""
    allowed = oracle.solves + BUDGET
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
            if oracle(chosen)[0] > FEASIBLE:
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


def _undominated(oracle: _Oracle) -> frozenset[int]:
    """Return the requirements without those of one row that another row implies everywhere.

    A row is implied by one that lies above it by a constant.
    """
    values = oracle.program.rows(oracle.points)[1:]
    single = [k for k, owner in enumerate(oracle.owners) if (oracle.owners == owner).sum() == 1]
    implied: set[int] = set()
    for k in single:
        for other in single:
            above = values[other] - values[k]
            if other == k or not np.isfinite(above).all() or np.ptp(above) > SAME:
                continue
            if above[0] > SAME or (abs(above[0]) <= SAME and other < k):
                implied.add(k)
    return frozenset(int(owner) for k, owner in enumerate(oracle.owners) if k not in implied)
