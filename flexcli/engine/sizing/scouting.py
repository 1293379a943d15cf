"""Other designs to start from: where formulas are not convex, or some check has no formula.

The rounds of a sizing end at the best design near where they start. They start anew where the
corrected formulas hold another one for better, and, where some check has no formula, where the
cheapest model that judges likes best what it finds among points that keep the formulas.
"""

from collections.abc import Container, Iterator
from functools import partial
from math import inf, log

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.models import NamedModel
from flexcli.engine.sizing.decided import Place, cheap_slopes_at, judged_at, slopes_at
from flexcli.engine.sizing.problem import SizingProblem
from flexcli.engine.sizing.program import sizing_program
from flexcli.engine.sizing.trust_region import Settled, settled
from flexcli.parts.geometries import Sizes
from flexcli.results.activity import doing

__all__ = ["best_settled"]

Floats = NDArray[np.float64]

ROUGH = 1e-2
"""Difference of a check at which models and formulas agree enough to choose between designs."""

POINTS, MOST = 8, 64
"""Points looked at in one dimension, doubled in each further one, and at the most."""

BETTER = 0.005
"""What another design must save of the objective (relative) to be worth rounds of its own."""

STARTS = 3
"""Designs that rounds start from at the most, beside the first."""

UNKNOWN = 16
"""Drawings looked at that leave a question open, which rounds would not start from."""

APART = 0.2
"""Distance in some size, in logarithms, of starts that are not the same."""

ROOM = 0.1
"""Logarithm by which a point may exceed its formulas' limits: rounds from it mend that."""

HELD = 0.9
"""Share of what it allows from which on a check holds a design."""

NEARLY = 0.7
"""Logarithm by which a point may exceed what is asked to be worth rounds, where a design is known
that keeps it."""


def best_settled(
    problem: SizingProblem,
    start: Sizes,
    models: tuple[NamedModel, ...],
    agreed: float,
    *,
    alone: bool = False,
) -> Settled:
    """Return the best design that rounds from several starts lead to.

    Parameters
    ----------
    problem : SizingProblem
        The design, without corrections.
    start : named tuple
        Sizes to start from first [m].
    models : tuple of NamedModel
        The models that judge, the cheapest first.
    agreed : float
        Difference of a check at which the models and the corrected formulas agree.
    alone : bool
        Whether the first is known to be near the best, and no other start is looked for.

    """
    design = problem.design
    place = judged_at(design, start, models)
    measure = partial(slopes_at, design, models=models)
    if alone or not place.alone:
        best = settled(problem, place, models, measure, agreed)
    else:
        best = _rough(problem, place, models)
    if alone or (best.is_kept and design.sizing.objective == "balanced"):
        return best
    scout = _Scout(problem, best, models)
    tried, starts, skipped = [best.place.y], 1, 0
    for y in scout.elsewhere():
        is_new = all(float(np.abs(y - other).max()) > APART for other in tried)
        if not is_new or scout.merits(y[:, None])[0] > scout.least:
            continue
        tried.append(y)
        place = judged_at(design, scout.sizes(y), models)
        if place.open and not design.geometry.closed_forms and skipped < UNKNOWN:
            skipped += 1  # nobody knows enough of it to start there
            continue
        starts += 1
        other = _rough(problem, place, models)
        if other.is_kept and scout.merits(other.place.y[:, None])[0] < scout.least:
            best = scout.best = other
            tried.append(best.place.y)
        if len(tried) - skipped > STARTS:
            break
    if best.agreed > agreed:
        best = settled(problem, best.place, models, measure, agreed, best.slopes)
    return best._replace(starts=starts)


def _rough(problem: SizingProblem, place: Place, models: tuple[NamedModel, ...]) -> Settled:
    """Return about where the rounds from a design end, by slopes of the cheapest model."""
    return settled(
        problem, place, models, partial(cheap_slopes_at, problem.design, models=models), ROUGH
    )


class _Scout:
    """Looks for designs that may be better than the best one so far."""

    def __init__(
        self, problem: SizingProblem, best: Settled, models: tuple[NamedModel, ...]
    ) -> None:
        self.problem = problem
        self.best = best
        self.models = models
        self.program = sizing_program(problem.corrected(best.corrections))
        self.goals = self.program.objectives(problem.design.sizing.objective)

    @property
    def least(self) -> float:
        """Return the objective that another design must better, as a logarithm."""
        here = float(self.merits(self.best.place.y[:, None])[0])
        return here - BETTER if self.best.is_kept else inf

    def merits(self, y: Floats) -> Floats:
        """Return the logarithms of the objective at points, shape (n, points)."""
        return self.program.worth(self.goals[0], y)

    def sizes(self, y: Floats) -> Sizes:
        """Return the sizes of a point."""
        x = self.program.complete(dict(zip(self.program.names, np.exp(y), strict=True)))
        return x._make(float(each) for each in x)

    def elsewhere(self) -> Iterator[Floats]:
        """Yield points that may lead to a better design, the likeliest first."""
        program = self.program
        if program.curved or not self.best.is_kept:
            solved = program.least(self.goals, program.limits(self.goals), program.equalities())
            if solved.converged:
                yield np.log([solved.x[name] for name in program.names])
        alone, found = self.best.place.alone, []
        used = self.best.place.used
        if self.best.is_kept:  # what does not hold the best design hides no better one
            alone = frozenset(name for name in alone if used[name].share > HELD)
        questions = {used[name].question for name in alone} | self.best.place.open
        if not questions:
            return
        doing("designs to start from")
        for y in self._points(alone):
            place = judged_at(
                self.problem.design, self.sizes(y), self.models[:1], only=questions, rough=True
            )
            if not place.open:
                over = max(0.0, *(log(used.share) for used in place.used.values()))
                if over <= NEARLY or not self.best.is_kept:
                    found.append((over, float(self.merits(y[:, None])[0]), y))
        yield from (y for *_, y in sorted(found, key=lambda each: each[:2]))

    def _points(self, alone: Container[str]) -> Iterator[Floats]:
        """Yield points that all but keep the formulas and better the best design there is."""
        program = self.program
        limits = {key: program.rows[key].limit for key in (*program.constraints, *program.targets)}
        keys = [key for key, limit in limits.items() if limit is None or limit.name not in alone]
        points = program.samples()
        rows = np.nan_to_num(program.picked(keys)(points), nan=inf)
        targets = np.array([key in program.targets for key in keys], dtype=bool)
        rows[targets] = np.abs(rows[targets])
        over = np.maximum(rows.max(axis=0, initial=0.0) - ROOM, 0.0)
        order = np.argsort(over, kind="stable")
        order = order[self.merits(points)[order] < self.least]
        count = min(MOST, POINTS * 2 ** (len(program.names) - 1))
        yield from points[:, order[:count]].T
