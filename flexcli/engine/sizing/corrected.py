"""Sizing by a finer model: the closed forms, corrected until they say what it says.

Space mapping: a sizing needs thousands of designs judged, a finer model can judge a few. So the
closed forms choose, the finer model judges the choice, and each requirement is scaled by how far
the two differ there; the differences hardly move with the sizes, so that a few rounds settle.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from time import perf_counter

from flexcli.engine.check import judged_by
from flexcli.engine.size import size
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import CLOSED_FORM, Answers, Limit
from flexcli.results import Note, Result

__all__ = ["size_by_model"]

ROUNDS = 12
SETTLED = 1e-8
"""Change of every correction (relative) at which the rounds end; the rest is added to it, so that
the finer model finds the requirement met."""

LARGEST = 100.0
"""A finer model that differs by more than this factor is not corrected to but says so itself."""


def size_by_model(design: DesignSpec, spec: str, answers: Answers) -> Result:
    """Return the design sized so that a finer model finds its requirements met.

    Raises
    ------
    SolveError
        When the finer model has no answer where the closed forms lead, or the rounds do not
        settle.

    """
    started = perf_counter()
    corrections: dict[str, float] = {}
    for rounds in range(1, ROUNDS + 1):
        corrected = design.corrected(corrections)
        chosen = _ideal(design, size(corrected, spec))
        if chosen is None:
            return _timed(size(corrected, spec, answers), started, rounds)
        found = _corrections(design, chosen, answers)
        change = max((abs(found[n] / corrections.get(n, 1.0) - 1.0) for n in found), default=0.0)
        if change <= SETTLED:
            final = {name: factor * (1.0 + 2.0 * SETTLED) for name, factor in found.items()}
            result = size(design.corrected(final), spec, answers)
            return _told(_timed(result, started, rounds), final, answers)
        corrections = found
    raise SolveError(
        "did-not-settle",
        f"the sizing by the {answers.model} model did not settle in {ROUNDS} rounds",
        "size by the closed form, then check with this model",
    )


def _ideal(design: DesignSpec, result: Result) -> Sizes | None:
    """Return the continuous sizes of a result, before any rounding to a grid."""
    if result.sizing is None or not result.sizing.designs:
        return None
    return design.geometry.sized(result.sizing.designs[0].sizes)


def _corrections(design: DesignSpec, sizes: Sizes, answers: Answers) -> dict[str, float]:
    """Return how much more each check uses by the finer model than by the closed form."""
    fine = _used(judged_by(design, sizes, answers))
    coarse = _used(design.closed_limits(sizes))
    return {
        name: min(max(fine[name] / used, 1.0 / LARGEST), LARGEST)
        for name, used in coarse.items()
        if used > 0.0 and name in fine
    }


def _used(limits: Iterable[Limit]) -> dict[str, float]:
    """Return the largest share of what each check allows that is used."""
    found: dict[str, float] = {}
    for limit in limits:
        demand, capacity = float(limit.demand), float(limit.capacity)
        used = max(demand, 0.0) / capacity if capacity > 0.0 else float("inf")
        found[limit.name] = max(found.get(limit.name, 0.0), used ** (1.0 / limit.power))
    return found


def _timed(result: Result, started: float, rounds: int) -> Result:
    assert result.cost is not None  # size measures
    cost = replace(result.cost, seconds=perf_counter() - started, iterations=rounds)
    return replace(result, cost=cost)


def _told(result: Result, corrections: Mapping[str, float], answers: Answers) -> Result:
    """Return a result whose sizing says what the finer model changed."""
    if result.sizing is None or answers is CLOSED_FORM:
        return result
    worst = max(corrections, key=lambda name: abs(corrections[name] - 1.0), default="")
    if not worst:
        return result
    text = (
        f"sized by the closed forms, corrected to the {answers.model} model; the largest "
        f"correction is {corrections[worst] - 1.0:+.2%} on {worst}"
    )
    note = Note("corrected", text)
    return replace(result, warnings=(*result.warnings, note))
