"""The verb accuracy: every model's error and time on one design, and the cheapest that will do."""

from collections.abc import Sequence
from math import inf
from time import perf_counter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.ladder import (
    CONTROL_LEVELS,
    FINEST,
    Finest,
    Number,
    Rung,
    ladder,
    numbers,
)
from flexcli.engine.plan import ACCURACY
from flexcli.errors import SolveError
from flexcli.numerics.pareto import pareto
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.results import (
    AccuracyResult,
    Cost,
    ModelAccuracy,
    Note,
    QuantityAccuracy,
    Reading,
    Result,
    Status,
    Value,
)

__all__ = ["Settled", "Timed", "accuracy", "compared", "timed"]

Floats = NDArray[np.float64]

UNSURE = 0.1
"""Error of the finest value, relative, from which it is no more than rounding."""


class Settled(NamedTuple):
    """A number with the finest model's value and the bound on its relative error."""

    number: Number
    finest: float
    bound: float


class Timed(NamedTuple):
    """Numbers (models, quantities) and the seconds of each run (runs, models, quantities).

    Not a number where a model has no answer.
    """

    values: Floats
    seconds: Floats


def accuracy(
    design: DesignSpec, sizes: Sizes, spec: str, runs: int, asked: float | None = None
) -> Result:
    """Return what accuracy costs on a design, to the accuracy asked, else the spec's.

    Raises
    ------
    SolveError
        ``one-model`` when the joint has no exact model to compare with.

    """
    started = perf_counter()
    wanted = tuple(numbers(design, sizes))
    tolerance, settled, unsettled = _settled(wanted)
    if not settled:
        text = f"a {design.geometry.name} {_why_not(wanted[0])}: there is nothing to compare with"
        raise SolveError("one-model", text, "take a joint of which all blades are given")
    rungs = ladder(design.geometry, tolerance)
    target = asked or design.accuracy or ACCURACY
    found = compared(settled, rungs, timed(settled, rungs, runs), target, unsettled)
    return Result(
        command="accuracy",
        spec=spec,
        status=Status.PASS if found.recommended else Status.FAIL,
        title=design.title,
        values={q.name: Value(q.finest, q.unit, q.label, found.finest) for q in found.quantities},
        warnings=_notes(found),
        cost=Cost(perf_counter() - started, found.finest, max(q.bound for q in found.quantities)),
        accuracy=found,
    )


def _settled(asked: Sequence[Number]) -> tuple[float, list[Settled], tuple[str, ...]]:
    """Return the finest tolerance, the numbers that are sure to it, the names of the others.

    It is the first that leaves no number unsure, else the one that leaves fewest.
    """
    tried = []
    for tolerance in FINEST:
        found = [(number, _finest(number, tolerance)) for number in asked]
        unsure = tuple(number.name for number, settled in found if settled is None)
        tried.append((tolerance, [s for _, s in found if s is not None], unsure))
        if not unsure:
            break
    return min(tried, key=lambda each: len(each[2]))


def _finest(number: Number, tolerance: float) -> Settled | None:
    """Return a number by the finest model, whose error other nodes and the solver bound."""
    finest = number.tried(Finest(tolerance=tolerance))
    control = number.tried(Finest(tolerance=tolerance, levels=CONTROL_LEVELS))
    if finest is None or control is None:
        return None
    apart = abs(finest - control)
    if finest == 0.0 or apart > UNSURE * abs(finest):
        return None
    return Settled(number, finest, apart / abs(finest) + tolerance)


def _why_not(number: Number) -> str:
    """Return why the finest model has no sure value of a number."""
    try:
        number.by(Finest(tolerance=FINEST[-1]))
    except NotAvailable as error:
        return str(error)
    return f"is zero to rounding in its {number.label}"


def timed(settled: Sequence[Settled], rungs: Sequence[Rung], runs: int) -> Timed:
    """Return every number by every model, warm, and the seconds that each took.

    The models take turns, so that a busy machine slows all of them alike.
    """
    values = np.full((len(rungs), len(settled)), np.nan)
    for i, rung in enumerate(rungs):
        for j, each in enumerate(settled):
            value = each.number.tried(rung.answers)
            values[i, j] = np.nan if value is None else value
    seconds = np.full((runs, *values.shape), np.nan)
    for run in range(runs):
        for i, j in np.argwhere(np.isfinite(values)):
            by, answers = settled[j].number.by, rungs[i].answers
            begun = perf_counter()
            by(answers)
            seconds[run, i, j] = perf_counter() - begun
    return Timed(values, seconds)


def compared(
    settled: Sequence[Settled],
    rungs: Sequence[Rung],
    times: Timed,
    asked: float,
    unsettled: tuple[str, ...] = (),
) -> AccuracyResult:
    """Return errors against the finest, the Pareto sets, and the cheapest within what is asked."""
    names = [rung.name for rung in rungs]
    finest = np.array([each.finest for each in settled])
    bound = np.array([each.bound for each in settled])
    missing = np.isnan(times.values)
    errors = np.where(missing, inf, np.abs(times.values - finest) / np.abs(finest))
    # below the finest's own error models cannot be told apart
    sure = np.maximum(errors, bound)
    seconds = np.where(missing, inf, times.seconds)
    quantities = tuple(
        _quantity(each, names, times.values[:, j], errors[:, j], seconds[:, :, j], asked)
        for j, each in enumerate(settled)
    )
    whole, worst = seconds.sum(axis=2), sure.max(axis=1)
    middle = np.median(whole, axis=0)
    front = pareto(worst.tolist(), middle.tolist())
    models = tuple(
        ModelAccuracy(
            name,
            float(errors[i].max()),
            float(middle[i]),
            float(whole[:, i].min()),
            float(whole[:, i].max()),
            front[i],
            tuple(each.number.name for each, gone in zip(settled, missing[i], strict=True) if gone),
        )
        for i, name in enumerate(names)
    )
    meets = np.all(errors + bound <= asked, axis=1)
    return AccuracyResult(
        accuracy=asked,
        runs=times.seconds.shape[0],
        finest=names[-1],
        quantities=quantities,
        models=models,
        recommended=_cheapest(names, meets, whole),
        unsettled=unsettled,
    )


def _quantity(
    each: Settled, names: Sequence[str], values: Floats, errors: Floats, seconds: Floats,
    asked: float,
) -> QuantityAccuracy:  # fmt: skip
    middle = np.median(seconds, axis=0)
    front = pareto(np.maximum(errors, each.bound).tolist(), middle.tolist())
    readings = tuple(
        Reading(
            name,
            float(values[i]),
            float(errors[i]),
            float(middle[i]),
            float(seconds[:, i].min()),
            float(seconds[:, i].max()),
            front[i],
        )
        for i, name in enumerate(names)
        if errors[i] < inf
    )
    number = each.number
    recommended = _cheapest(names, errors + each.bound <= asked, seconds)
    return QuantityAccuracy(
        number.name, number.label, number.unit, each.finest, each.bound, readings, recommended
    )


def _cheapest(names: Sequence[str], meets: NDArray[np.bool_], seconds: Floats) -> str:
    """Return the cheapest of the models that meet what is asked, by their seconds (runs, models).

    Of those whose times cannot be told apart it is the first: the coarsest.
    """
    if not meets.any():
        return ""
    least = np.min(np.median(seconds, axis=0)[meets])
    alike = meets & (seconds.min(axis=0) <= least)
    return names[int(np.flatnonzero(alike)[0])]


def _notes(found: AccuracyResult) -> tuple[Note, ...]:
    notes = [
        Note("no-sure-value", f"{name} takes no part: the finest model has no sure value of it")
        for name in found.unsettled
    ]
    if not found.recommended:
        text = f"no model is within {found.accuracy:g} of the finest"
        notes.append(Note("accuracy-not-met", text))
    return tuple(notes)
