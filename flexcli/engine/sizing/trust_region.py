"""The design at which the formulas, corrected there, choose what the models that judge choose.

From a first design the corrected formulas choose the next one within a region about it. It is
taken where the models that judge find the objective and the violations together less by a share
of what the formulas promised; the region grows where they keep their promise, and shrinks where
they do not. Where value and slope agree at the choice, it is one of the models that judge.
"""

from collections.abc import Callable, Mapping, Sequence
from math import inf, log
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.models import NamedModel
from flexcli.engine.sizing.balanced import Balanced, balanced
from flexcli.engine.sizing.decided import (
    Place,
    Slopes,
    corrections,
    judged_at,
    shares,
    updated_slopes,
)
from flexcli.engine.sizing.problem import SizingProblem
from flexcli.engine.sizing.program import SizingProgram, sizing_program
from flexcli.engine.sizing.rows import ONE, Row, Term
from flexcli.engine.sizing.runaway import refuse_runaway
from flexcli.numerics.solution import Solution
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.sizing import Correction
from flexcli.results import EXACT
from flexcli.results.activity import doing

__all__ = ["AGREED", "UNKNOWN", "Settled", "least_eased", "settled"]

Floats = NDArray[np.float64]

ROUNDS = 40
"""Choices judged at the most."""

MARGIN = 1e-6
"""Share by which a requirement is kept beyond what is asked: what the rounds leave is met."""

AGREED = 5e-7
"""Difference of a check by the models that judge and by the corrected formulas (relative) at which
they agree."""

WIDEST, FIRST_ALONE = 3.0, 0.7
"""Half-width of the first region, in logarithms: of formulas, and where some check has none."""

NARROWEST = 1e-6
"""Half-width of a region in which nothing better is looked for."""

UNKNOWN = "what no model knows the error of beside it"
"""What keeps rounds from going on where nothing else does."""

EDGE = 1e-4
"""Distance, in logarithms, at which a design is as near as need be to one that leaves a question
open which it does not."""

STALLED, PROGRESS = 7, 0.8
"""Rounds in which violations must fall to this share, where they alone count."""

FRESH = 0.03
"""Distance, in logarithms, up to which the slopes of a place hold."""

CLOSE = 0.3
"""Step, in logarithms, from which on slopes are worth their cost."""

PENALTY = 2.0
"""Weight of the largest violation against the objective, in sums of the multipliers: above one,
so that what is best together keeps what is asked."""

UNHELD = 1.0
"""Least price of a violation: of a choice that no limit holds, all that it breaks is unforeseen."""

POOR, GOOD = 0.05, 0.7
"""Share of the promised gain below which a choice is not taken, above which the region grows."""


class Settled(NamedTuple):
    """Where the rounds ended: the place, the corrections that hold there, what did not settle.

    ``starts`` are the designs that rounds started from to find it.
    """

    place: Place
    corrections: dict[str, Correction]
    slopes: Slopes
    agreed: float
    unsettled: tuple[str, ...] = ()
    starts: int = 1

    @property
    def is_kept(self) -> bool:
        """Return whether the place keeps what is asked, as nearly as the models agree."""
        if self.place.open:
            return False
        used = {name: each.share for name, each in self.place.used.items()}
        return _violation(used, self.place) <= MARGIN + 2.0 * self.agreed

    def at(self, design: DesignSpec, place: Place) -> "Settled":
        """Return the corrections moved to another place near by."""
        return self._replace(
            place=place, corrections=corrections(design, place, self.slopes, MARGIN)
        )


class _Trial(NamedTuple):
    """A choice: logarithms of its sizes, and what it is the best by.

    ``price`` is what the objective falls by per logarithm by which all limits give way; infinite
    where violations alone count. ``equal`` are the checks that a balanced design makes equal.
    """

    y: Floats
    price: float = inf
    equal: frozenset[str] = frozenset()


def settled(
    problem: SizingProblem,
    place: Place,
    models: tuple[NamedModel, ...],
    measure: Callable[[Place], Slopes],
    agreed: float = AGREED,
    slopes: Slopes | None = None,
) -> Settled:
    """Return the design near a first one that is best by the models that judge.

    Parameters
    ----------
    problem : SizingProblem
        The design, without corrections.
    place : Place
        What the models that judge say of the first one.
    models : tuple of NamedModel
        The models that judge, the cheapest first.
    measure : callable
        Slopes of the corrections at a place.
    agreed : float, optional
        Difference of a check at which the models and the corrected formulas agree.
    slopes : dict of array, optional
        Slopes of the corrections, of which not all need hold there.

    """
    design = problem.design
    fresh: Floats | None = None
    off: dict[str, float] = {}
    edge: Floats | None = None
    width = FIRST_ALONE if place.alone else WIDEST

    def ended(*unsettled: str) -> Settled:
        found = corrections(design, place, known, MARGIN)
        return Settled(place, found, known, agreed, unsettled)

    known: Slopes = slopes or {}
    if slopes is None and place.alone:
        known, fresh = measure(place), place.y
    before = inf
    for round_ in range(ROUNDS):
        doing(f"the optimum, round {round_ + 1}")
        corrected = problem.corrected(corrections(design, place, known, MARGIN))
        trial = _trial(corrected, place, width)
        if trial is None:
            return ended()
        if trial.price == inf and round_ % STALLED == STALLED - 1:
            left = _violation({n: used.share for n, used in place.used.items()}, place, trial.equal)
            if left > PROGRESS * before:
                break
            before = left
        step = float(np.abs(trial.y - place.y).max(initial=0.0))
        sizes = _sized(design, place.sizes, trial.y)
        refuse_runaway(design, sizes)
        there = judged_at(design, sizes, models, place) if step > 0.0 else place
        barred = bool(there.open - place.open)
        edge = trial.y if barred else edge
        plain = problem.corrected(corrections(design, place, known, 0.0))
        promised = shares(plain.limits(sizes))
        off = _differences(there, promised)
        agree = max(off.values(), default=0.0) <= agreed and step < 0.99 * width and not barred
        is_fresh = fresh is not None and float(np.abs(trial.y - fresh).max()) <= FRESH
        if agree and (is_fresh or not there.near):
            place = there
            return ended()
        gain, promise = _gains(problem, trial, place, there, promised)
        if agree or gain >= POOR * promise > 0.0:
            if not agree:
                known = updated_slopes(known, place, there, there.used.keys() & place.used.keys())
            if gain >= GOOD * promise and step > 0.8 * width:
                width *= 2.5
            elif gain < 0.25 * promise:
                width = max(0.5 * step, NARROWEST)
            place = there
            if not is_fresh and (agree or step <= CLOSE):
                known, fresh = known | measure(place), place.y
        elif fresh is None:
            known, fresh = known | measure(place), place.y
        else:
            known = updated_slopes(known, place, there, there.used.keys() & place.used.keys())
            width = 0.5 * step
            if width < NARROWEST:
                break
        if edge is not None:
            apart = float(np.abs(edge - place.y).max())
            if apart <= max(EDGE, agreed):
                return ended(UNKNOWN)
            width = min(width, 0.5 * apart)
    worst = sorted(off, key=lambda name: -off[name])
    return ended(*([name for name in worst if off[name] > agreed] or worst))


def _differences(there: Place, promised: Mapping[str, float]) -> dict[str, float]:
    """Return by how far what is near its limit is off what was promised, as logarithms."""
    return {
        name: abs(log(there.used[name].share / promised[name])) if name in promised else inf
        for name in there.near
    }


def _gains(
    problem: SizingProblem,
    trial: _Trial,
    place: Place,
    there: Place,
    promised: Mapping[str, float],
) -> tuple[float, float]:
    """Return by how much a choice is better by the models that judge, and as was promised."""
    used = {name: each.share for name, each in there.used.items()}
    old = {name: each.share for name, each in place.used.items()}
    was = _violation(old, place, trial.equal)
    missing = (place.near | trial.equal) - there.used.keys()
    now = inf if missing or there.open - place.open else _violation(used, there, trial.equal)
    said = _violation(promised, place, trial.equal)
    if trial.price == inf:
        return was - now, was - said
    # a choice that no limit held may break one that no slope foresaw
    weight = PENALTY * max(trial.price, UNHELD)
    design = problem.design
    if design.pursued is not None:
        before, after, told = (
            _largest_share(place.pursued, shares) for shares in (old, used, promised)
        )
        return before - after + weight * (was - now), before - told + weight * (was - said)
    program = sizing_program(problem)
    goal = program.goal(design.sizing.objective)
    before, after = program.worth(goal, np.stack([place.y, there.y], axis=1))
    gain = float(before - after)
    return gain + weight * (was - now), gain + weight * (was - said)


def _largest_share(names: frozenset[str], used: Mapping[str, float]) -> float:
    """Return the logarithm of the largest share of some checks."""
    return log(max((used[name] for name in names & used.keys()), default=inf))


def _violation(
    used: Mapping[str, float], place: Place, equal: frozenset[str] = frozenset()
) -> float:
    """Return the largest logarithm by which a check exceeds its limit, or is off its target."""
    worst = 0.0
    for name, share in used.items():
        known = place.used.get(name)
        both = name in equal or (known is not None and known.is_target)
        worst = max(worst, abs(log(share)) if both else log(share))
    return worst


def _sized(design: DesignSpec, sizes: Sizes, y: Floats) -> Sizes:
    free = dict(zip(design.geometry.free, np.exp(y).tolist(), strict=True))
    return sizes._replace(**free)


def _trial(corrected: SizingProblem, place: Place, width: float) -> _Trial | None:
    """Return the best design within a region, else the one that exceeds its limits the least.

    Nothing where not even that helps.
    """
    program = sizing_program(corrected).about(place.sizes, width)
    objective = corrected.design.sizing.objective
    if objective == "balanced":
        found = balanced(program)
        if isinstance(found, Balanced):
            y = np.log([found.x[name] for name in program.names])
            long = float(np.abs(y - place.y).max(initial=0.0)) / width
            return _Trial(place.y + (y - place.y) / max(1.0, long), inf, frozenset(found.checks))
    goals = program.objectives(objective)
    solution = program.least(goals, program.limits(goals), program.equalities())
    weights = solution.multipliers | solution.equality_multipliers
    price = sum(abs(x) for key, x in weights.items() if _ease(program.rows[key]))
    if not solution.converged:
        solution, price = least_eased(program, goals), inf
    if not solution.converged:
        return None
    return _Trial(np.log([solution.x[name] for name in program.names]), price)


def least_eased(program: SizingProgram, goals: Sequence[Term]) -> Solution:
    """Return the design that exceeds what is asked by the least share, then by the next goals.

    The bounds on the sizes and the joint's own shape are kept.
    """
    limits = [
        Term(key, sign, 0.0, _ease(program.rows[key]))
        for key in (*program.constraints, *program.targets)
        for sign in program.senses(key)
    ]
    least = Term(ONE, 1.0, 0.0, (("ease", -1.0),))
    ties = [goal for goal in goals if not goal.eases]
    return program.least([least, *ties], [*limits, *program.region()])


def _ease(row: Row) -> tuple[tuple[str, float], ...]:
    """Return the unknown by which a row is eased, and its power; none for a bound or a shape."""
    is_asked = row.limit is not None and row.limit.error != EXACT
    return (("ease", float(row.power)),) if is_asked else ()
