"""Stops verified in time: what the line leaves undecided, or every case to its end."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from flexcli.engine.judge import status_of
from flexcli.engine.stopping.judge import StopJudgement, Watch, judge_stops
from flexcli.engine.stopping.statics import task_of
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.results import Cost, Note, Result, Status, Value, Verdict, with_seconds
from flexcli.results.stops import StopPlace, StopSimulation

__all__ = ["Watch", "decided", "simulated", "with_time"]

NOTABLE = 1.05
"""Travel over that of the operating line from which a note says so."""


def decided(
    result: Result, design: DesignSpec, sizes: Sizes, watch: Watch, *, seed: int | None = None
) -> Result:
    """Return a sized stop; checks that the operating line leaves undecided are simulated.

    A seed takes the place of the spec's.
    """
    if result.status is not Status.UNDECIDED:
        return result
    return _judged(result, design, sizes, watch, seed=seed, forced=False, keep_history=False)


def simulated(
    result: Result,
    design: DesignSpec,
    sizes: Sizes,
    watch: Watch,
    *,
    seed: int | None = None,
    keep_history: bool = False,
) -> Result:
    """Return a sized stop with every case of the design run in time to its end, and judged.

    A seed takes the place of the spec's.

    Raises
    ------
    SolveError
        ``no-excitation`` when no case shakes the base, ``no-time`` where one is no motion in time.
    """
    found = _judged(result, design, sizes, watch, seed=seed, forced=True, keep_history=keep_history)
    if found.stops is not None and not found.stops.simulations:
        raise SolveError(
            "no-excitation", "no case shakes the base", "give a case an asd, shock, sine or sweep"
        )
    return found


def _judged(
    result: Result,
    design: DesignSpec,
    sizes: Sizes,
    watch: Watch,
    *,
    seed: int | None,
    forced: bool,
    keep_history: bool,
) -> Result:
    assert result.stops is not None  # the caller's result
    assert design.stops is not None
    options = design.stops.simulation
    if seed is not None:
        options = options.model_copy(update={"seed": seed})
    task, place = task_of(design, design.stops, sizes), result.stops.chosen
    found = judge_stops(
        design, task, sizes, place,
        watch=watch, forced=forced, options=options, keep_history=keep_history,
    )  # fmt: skip
    infeasible = result.status is Status.INFEASIBLE
    cost = result.cost
    for model, seconds in found.by_model.items():
        cost = with_time(cost, seconds, model)
    return replace(
        result,
        status=Status.INFEASIBLE if infeasible else status_of(found.checks),
        values={**result.values, **_values(found.simulations)},
        checks=found.checks,
        warnings=(*result.warnings, *stop_notes(design, place, found)),
        cost=cost,
        stops=result.stops._replace(simulations=found.simulations, histories=found.histories),
    )


def with_time(cost: Cost | None, seconds: float, model: str) -> Cost:
    """Return the cost of a result for which a model ran as well, some seconds."""
    before = cost or Cost(0.0, "", None)
    names = [name for name in before.model.split(", ") if name]
    return replace(
        before,
        seconds=before.seconds + seconds,
        model=", ".join(dict.fromkeys((*names, model))),
        by_model=with_seconds(before.by_model, model, seconds),
    )


def _values(runs: Iterable[StopSimulation]) -> dict[str, Value]:
    """Return the peaks of each case, the highest where it was run twice."""
    found: dict[str, Value] = {}
    for run in runs:
        for name, value, unit, label in (
            ("travel", run.travel, "m", "peak of the tip"),
            ("pi_5", run.pi_5, "", "range of the tip over the gap (of a sine: steady)"),
            ("F_stop", run.force, "N", "peak force on a stop"),
            ("contacts", float(run.contacts), "", "number of contacts"),
            ("sigma_base", run.sigma_base, "Pa", "peak stress at the base"),
            ("sigma_contact", run.sigma_contact, "Pa", "peak stress at the stop"),
        ):
            key = f"{name}_{run.case}"
            if key not in found or value > found[key].value:
                least = ", at least" if run.has_decided else ""
                text = f"{label}, {run.case}, simulated{least}"
                found[key] = Value(value, unit, text, run.model)
    return found


def stop_notes(design: DesignSpec, place: StopPlace, found: StopJudgement) -> Iterator[Note]:
    """Yield what the simulation leaves out, what ended early, and what the line did not foresee."""
    for run in found.simulations:
        if run.outcome:
            yield Note("simulation-ended", f"case '{run.case}': {run.outcome}")
        elif run.has_decided:
            text = f"case '{run.case}': ended after {run.duration:.4g} s of {run.planned:.4g} s, "
            yield Note(
                "run-decided", f"{text}when a limit was exceeded; --simulate runs to the end"
            )
        elif not run.is_complete:
            text = f"case '{run.case}': interrupted after {run.duration:.4g} s of {run.planned:.4g}"
            yield Note("interrupted", f"{text} s; what was done is reported")
        if run.impulse > 0.0:
            text = f"case '{run.case}': impacts without duration have an impulse and no peak force"
            yield Note("impulse-only", text)
        line = place.pi_5 * place.delta_G / 2.0
        if run.contacts and run.travel > line * NOTABLE:
            text = f"case '{run.case}': the tip goes {run.travel / line - 1.0:.0%} farther than the"
            yield Note("beyond-the-line", f"{text} operating line has it")
    for name, case in design.cases.items():
        if not case.vibrates:
            continue
        beside = {"acceleration": case.acceleration, "stroke": case.stroke, "load": case.load}
        for key, load in (beside | {"wrench": case.wrench}).items():
            if load is not None:
                text = f"case '{name}': its {key} is left out of the simulation, which decides "
                yield Note("left-out-of-simulation", f"{text}nothing there")
    if found.simulations and design.material.density is None:
        text = "no density is given: the blade's own mass counts as part of the tip mass"
        yield Note("blade-mass-in-the-tip", text)
    slow = [check for check in found.checks if check.verdict is Verdict.UNDECIDED]
    if slow and design.material.poisson_ratio is None:
        text = "material.poisson_ratio is not given and was taken as anything from 0 to ½"
        yield Note("needs-poisson-ratio", f"{text}; giving it may decide {slow[0].name}")
