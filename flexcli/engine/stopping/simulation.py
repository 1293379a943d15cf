"""Verify stops in time: every case run between them, peaks against what is allowed."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

from flexcli.engine import assess
from flexcli.engine.stopping.run import stop_runs
from flexcli.engine.stopping.statics import StopTask, task_of
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Limit
from flexcli.results import (
    Cost,
    Note,
    Result,
    Status,
    StopHistory,
    StopPlace,
    StopSimulation,
    Value,
)

__all__ = ["Watch", "simulated"]

Watch = Callable[[str, float], bool]
"""Told the case and the share that is done; answers whether to go on."""

MODEL = "event-driven simulation"
NOTABLE = 1.05
"""Travel over that of the operating line from which a note says so."""


def simulated(
    result: Result,
    design: DesignSpec,
    sizes: Sizes,
    watch: Watch,
    *,
    seed: int | None = None,
    keep_history: bool = False,
) -> Result:
    """Return a sized stop with every case of the design run in time, and judged.

    A seed takes the place of the spec's.

    Raises
    ------
    SolveError
        ``no-excitation`` when no case shakes the base.
    """
    assert result.stops is not None  # the caller's result
    assert design.stops is not None
    runs: list[StopSimulation] = []
    histories: list[StopHistory] = []
    task = task_of(design, design.stops, sizes)
    options = design.stops.simulation
    if seed is not None:
        options = options.model_copy(update={"seed": seed})
    place = result.stops.chosen
    for run in stop_runs(design, task, sizes, place, options=options, keep_history=keep_history):
        runs.append(run.told(partial(watch, run.case)))
        if (history := run.history()) is not None:
            histories.append(history)
    if not runs:
        raise SolveError(
            "no-excitation", "no case shakes the base", "give a case an asd, shock, sine or sweep"
        )
    checks = assess.checks(limit for run in runs for limit in _limits(task, run))
    passed = all(check.passed for check in checks)
    return replace(
        result,
        status=result.status if passed or result.status is Status.INFEASIBLE else Status.FAIL,
        values={**result.values, **_values(runs)},
        checks=(*result.checks, *checks),
        warnings=(*result.warnings, *_notes(design, place, runs)),
        cost=_with_time(result.cost, sum(run.seconds for run in runs)),
        stops=result.stops._replace(simulations=tuple(runs), histories=tuple(histories)),
    )


def _with_time(cost: Cost | None, seconds: float) -> Cost:
    """Return the cost of a result that was simulated too."""
    before = cost or Cost(0.0, "", None)
    return Cost(before.seconds + seconds, f"{before.model}; {MODEL}", before.estimated_error)


def _limits(task: StopTask, run: StopSimulation) -> Iterator[Limit]:
    """Yield what a simulated case must keep."""

    def limit(
        name: str, quantity: str, demand: float, capacity: float, unit: str, required: float = 1.0
    ) -> Limit:
        kind = f"{name} (simulated)"
        return Limit(kind, run.case, quantity, demand, capacity, unit, MODEL, required=required)

    yield limit("travel", "peak of the tip", run.travel, task.travel, "m")
    bending, shear = task.stops.bending, task.stops.shear
    if bending is not None and task.bending is not None:
        worst = max(run.sigma_base, run.sigma_contact)
        text = "peak bending stress, base or stop"
        yield limit("bending", text, worst, task.bending, "Pa", bending.factor)
    if shear is not None and task.shear is not None and run.tau_hertz is not None:
        text = "peak shear below the contact"
        yield limit("contact shear", text, run.tau_hertz, task.shear, "Pa", shear.factor)
    text = "time planned, time simulated"
    done = run.planned if run.is_complete else run.duration
    yield limit("completed", text, run.planned, done, "s")


def _values(runs: list[StopSimulation]) -> dict[str, Value]:
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
                found[key] = Value(value, unit, f"{label}, {run.case}, simulated", MODEL)
    return found


def _notes(design: DesignSpec, place: StopPlace, runs: list[StopSimulation]) -> Iterator[Note]:
    """Yield what the simulation leaves out, what ended early, and what the line did not foresee."""
    for run in runs:
        if run.outcome:
            yield Note("simulation-ended", f"case '{run.case}': {run.outcome}")
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
        if case.acceleration is not None and case.vibrates:
            text = f"case '{name}': the steady acceleration is left out of the simulation"
            yield Note("steady-left-out", text)
