"""The verb accuracy: every model's error and time on one design, and the cheapest that will do."""

from collections.abc import MutableMapping, Sequence
from time import perf_counter

import numpy as np

from flexcli.engine.comparing.compared import Reference, Timed, compared, relative_bound
from flexcli.engine.comparing.model_series import (
    CONTROL_LEVELS,
    FINEST,
    Finest,
    Number,
    SeriesModel,
    SolvedSeries,
    numbers,
    series,
)
from flexcli.engine.comparing.time_accuracy import accuracy_in_time, time_notes
from flexcli.engine.plan import ACCURACY
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.results import Cost, Note, Result, Status, Value
from flexcli.results.accuracy import AccuracyResult

__all__ = ["accuracy", "timed"]


def accuracy(
    design: DesignSpec,
    sizes: Sizes,
    spec: str,
    runs: int,
    asked: float | None = None,
    *,
    is_solid: bool = False,
    files: MutableMapping[str, str] | None = None,
) -> Result:
    """Return what accuracy costs on a design, to the accuracy asked, else the spec's.

    With solid elements (``is_solid``) those are the finest model, and the design's deciding model,
    with all its corrections, is compared too; ``files`` gets their decks by name.

    Raises
    ------
    SolveError
        ``one-model`` when the joint has no exact model to compare with.

    """
    started = perf_counter()
    target = asked or design.accuracy or ACCURACY
    solved, remarks = _solved(design, sizes, runs), list[Note]()
    models = solved.models
    if is_solid:
        from flexcli.engine.comparing.solid_series import with_solids

        solved, remarks = with_solids(design, sizes, solved, files)
    still = compared(solved.settled, solved.models, solved.times, target, solved.unsettled)
    is_solid = len(solved.models) > len(models)
    still = still._replace(is_solid=is_solid, is_shell=design.geometry.in_space and not is_solid)
    in_time = accuracy_in_time(design, sizes, runs, target)
    found = still._replace(in_time=in_time)
    every = [each for each in (still, in_time) if each is not None]
    notes = [*remarks, *_notes(still, "")]
    if in_time is not None:
        notes += [*_notes(in_time, ", in time"), *time_notes(design)]
    return Result(
        command="accuracy",
        spec=spec,
        status=Status.PASS if all(each.recommended for each in every) else Status.FAIL,
        title=design.title,
        values={
            q.name: Value(q.finest, q.unit, q.label, each.finest)
            for each in every
            for q in each.quantities
        },
        warnings=tuple(notes),
        cost=Cost(
            perf_counter() - started,
            "; ".join(each.finest for each in every),
            max(q.bound for each in every for q in each.quantities),
        ),
        accuracy=found,
    )


def _solved(design: DesignSpec, sizes: Sizes, runs: int) -> SolvedSeries:
    """Return the models that a design has, timed, and the numbers that they are compared in."""
    if design.geometry.in_space:
        from flexcli.engine.comparing.space_series import space_series

        in_space = space_series(design, sizes, runs)
        if in_space.settled:
            return in_space
        why = "has no reliable number by shells"
    else:
        wanted = tuple(numbers(design, sizes))
        tolerance, settled, unsettled = _settled(wanted)
        if settled:
            models = series(design.geometry, tolerance)
            return SolvedSeries(settled, models, timed(settled, models, runs), unsettled)
        why = _why_not(wanted[0])
    text = f"a {design.geometry.name} {why}: there is nothing to compare with"
    raise SolveError("one-model", text, "'flexure check' judges it by the model that it has")


def _settled(asked: Sequence[Number]) -> tuple[float, list[Reference[Number]], tuple[str, ...]]:
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


def _finest(number: Number, tolerance: float) -> Reference[Number] | None:
    """Return a number by the finest model, whose error other nodes and the solver bound."""
    finest = number.tried(Finest(tolerance=tolerance))
    control = number.tried(Finest(tolerance=tolerance, levels=CONTROL_LEVELS))
    if finest is None or control is None:
        return None
    bound = relative_bound(finest, control, tolerance)
    return None if bound is None else Reference(number, finest, bound)


def _why_not(number: Number) -> str:
    """Return why the finest model has no sure value of a number."""
    try:
        number.by(Finest(tolerance=FINEST[-1]))
    except NotAvailable as error:
        return str(error)
    return f"is zero to rounding in its {number.label}"


def timed(settled: Sequence[Reference[Number]], models: Sequence[SeriesModel], runs: int) -> Timed:
    """Return every number by every model, and the seconds that each took.

    The code is warm, the models are new each time: none remembers what it solved before. They take
    turns, so that a busy machine slows all of them alike.
    """
    values = np.full((len(models), len(settled)), np.nan)
    for i, model in enumerate(models):
        for j, each in enumerate(settled):
            value = each.number.tried(model.new())
            values[i, j] = np.nan if value is None else value
    seconds = np.full((runs, *values.shape), np.nan)
    for run in range(runs):
        for i, j in np.argwhere(np.isfinite(values)):
            by, joint_model = settled[j].number.by, models[i].new()
            begun = perf_counter()
            by(joint_model)
            seconds[run, i, j] = perf_counter() - begun
    return Timed(values, seconds)


def _notes(found: AccuracyResult, where: str) -> tuple[Note, ...]:
    notes = [
        Note("no-sure-value", f"{name} is left out: the finest model has no reliable value of it")
        for name in found.unsettled
    ]
    if not found.recommended:
        text = f"no model is within {found.accuracy:g} of the finest{where}"
        notes.append(Note("accuracy-not-met", text))
    return tuple(notes)
