"""The verb stops: height and gap of an end stop, and what blade and contact bear there."""

from collections.abc import Iterator
from math import pi
from time import perf_counter

from flexcli.engine import assess, omitted_effects
from flexcli.engine.judge import status_of
from flexcli.engine.stopping.choice import Choice, choose, on_line
from flexcli.engine.stopping.free_travel import free_travel
from flexcli.engine.stopping.judge import judge_stops
from flexcli.engine.stopping.simulation import with_time
from flexcli.engine.stopping.statics import (
    LINE,
    SOURCE,
    StopTask,
    contact_error,
    stop_place,
    task_of,
)
from flexcli.errors import SolveError
from flexcli.formulas.card import Range, outside
from flexcli.formulas.pi_law import FACTOR, MEASURED, SCATTER
from flexcli.formulas.stop_line import HARD_STOP, REACHED, line_height
from flexcli.formulas.stop_stiffness import free_stiffness
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.mechanisms.tip_mass import TipMass
from flexcli.results import Note, Result, Status, Value
from flexcli.results.stops import StopPlace, StopsResult
from flexcli.units import show

__all__ = ["stops"]


CHOSEN = {
    "L_a": ("m", "height of the stop over the clamp"),
    "delta_G": ("m", "gap on each side"),
    "k_contact": ("N/m", "stiffness of the tip on the stop"),
    "pi_1": ("", "k_contact/k_free"),
    "pi_5": ("", "range of the tip over the gap, on the operating line"),
    "pi_5_threshold": ("", "the same, below which a tip-loaded blade does not touch"),
    "tip_at_contact": ("m", "deflection of the tip when the blade touches"),
    "F": ("N", "force that holds the tip at the end of its travel"),
    "F_contact": ("N", "force that brings the blade to its stop, F′"),
    "F_excess": ("N", "the rest, F″"),
    "R_stop": ("N", "force on the stop then"),
    "sigma_onset": ("Pa", "stress at the base when the blade touches"),
    "sigma_base": ("Pa", "stress at the base at the end of the travel"),
    "sigma_contact": ("Pa", "stress at the stop at the end of the travel"),
    "p_hertz": ("Pa", "peak pressure of the contact"),
    "tau_hertz": ("Pa", "greatest shear below the contact"),
}
"""Units and labels of what a place has."""

STIFF = ("k_free", "k_contact", "F", "R_stop", "sigma_")
"""Starts of the names of what is proportional to the blade's rigidity at a given travel."""

BEAM = (
    Range("travel/L", most=0.1, why="small rotation"),
    Range("L_b/h", 2.0, why="shear of the overhang is left out"),
)
"""Where the statics hold."""

AT_ENDS = {
    "smallest gap": ("least_gap", ("L_a", "k_contact")),
    "hard stop": ("hard", ("delta_G", "k_contact", "pi_1", "pi_5", "tip_at_contact")),
}
"""What the source prints of the ends of the line, and the end of its names."""


def stops(design: DesignSpec, sizes: Sizes, spec: str) -> Result:
    """Return the stop that keeps the tip to its travel, with values, checks and warnings.

    Judged by operating line and statics alone, which take no time and decide little:
    `flexcli.engine.stopping.simulation` has what decides the rest.
    """
    started = perf_counter()
    if design.stops is None:
        raise SolveError(
            "no-stops", "the design has no stops", "add stops: with travel, and gap or height"
        )
    mechanism = design.mechanism
    assert isinstance(mechanism, TipMass)  # the design refuses others
    task = task_of(design, design.stops, sizes)
    free = free_travel(design, mechanism, sizes)
    choice = choose(task)
    ends = tuple(_ends(task))
    judged = judge_stops(design, task, sizes, choice.place, simulate=False)
    rows = omitted_effects.effects(design, sizes)
    return Result(
        command="stops",
        spec=spec,
        status=_status(choice, status_of(judged.checks)),
        title=design.title,
        values=_values(design, mechanism, task, choice.place, ends) | _free_values(free),
        checks=judged.checks,
        effects=rows,
        warnings=(
            *omitted_effects.warnings(design, sizes, rows),
            *_notes(design, task, choice.place, free),
        ),
        cost=with_time(None, perf_counter() - started, LINE),
        stops=StopsResult(
            outcome=choice.outcome,
            chosen=choice.place,
            places=(choice.place, *ends),
            reason=choice.reason,
            remedy=choice.remedy,
            holds=choice.holds,
        ),
    )


def _status(choice: Choice, judged: Status) -> Status:
    return Status.INFEASIBLE if choice.outcome == "infeasible" else judged


def _ends(task: StopTask) -> Iterator[StopPlace]:
    """Yield the ends of the operating line: smallest gap, what is reached, hard stop."""
    smallest = task.stops.smallest_gap
    # no stop stiffens so little that the line has a gap below that of the clamp
    if smallest is not None and smallest > 2.0 * task.travel / FACTOR:
        height = float(line_height(d=smallest, L=task.L, delta_O=2.0 * task.travel))
        yield stop_place(task, "smallest gap", height, smallest)
    for name, share in (
        ("lowest reached", REACHED.least),
        ("highest reached", REACHED.most),
        ("hard stop", HARD_STOP),
    ):
        yield on_line(task, name, share * task.L)


def _values(
    design: DesignSpec,
    mechanism: TipMass,
    task: StopTask,
    place: StopPlace,
    ends: tuple[StopPlace, ...],
) -> dict[str, Value]:
    k_free = float(free_stiffness(E=task.elastic.E, I=task.I, L=task.L))
    found = {
        "travel": Value(task.travel, "m", "deflection of the tip allowed to each side"),
        "k_free": Value(k_free, "N/m", "stiffness of the free tip", source=SOURCE),
        **mechanism.values(k_free, design.geometry),
    }
    for name, (unit, label) in CHOSEN.items():
        value = getattr(place, name)
        if value is not None:
            found[name] = Value(value, unit, label, source=SOURCE)
    for end in ends:
        key, names = AT_ENDS.get(end.name, ("", ()))
        for name in names:
            unit, label = CHOSEN[name]
            text = f"{label}: {end.name}"
            found[f"{name}_{key}"] = Value(getattr(end, name), unit, text, source=SOURCE)
    found |= _estimate(task, found["f_0"].value, k_free)
    return {name: _with_error(name, value, task, place) for name, value in found.items()}


def _with_error(name: str, value: Value, task: StopTask, place: StopPlace) -> Value:
    """Return a value with the error of the statics that made it, where it has one.

    Widening, shear and rotation are left out of the numbers: they are those of a beam.
    """
    rigidity = task.rigidity_at(place).largest
    error = next((rigidity for start in STIFF if name.startswith(start)), None)
    if name in ("f_0", "V_max"):
        error = max(abs((1.0 + end) ** 0.5 - 1.0) for end in task.rigidity_at(place))
    if name == "tip_at_contact":
        error = contact_error(task, place).largest
    if name == "pi_5":
        error = SCATTER
    return value._replace(estimated_error=error) if error is not None else value


def _estimate(task: StopTask, f_0: float, k_free: float) -> dict[str, Value]:
    """Return the source's estimate of the shock: full speed at rest, stopped in a sixth cycle."""
    speed = task.travel * 2.0 * pi * f_0
    force = k_free / (2.0 * pi * f_0) ** 2 * speed * 6.0 * f_0
    source = "Monti (2014), section 9.1.3; 6/(2π) of k_free times the travel"
    return {
        "V_max": Value(speed, "m/s", "greatest speed of the tip on a free swing", source=source),
        "F_inertial": Value(force, "N", "force that stops it in a sixth cycle", source=source),
    }


def _free_values(free: dict[str, float]) -> dict[str, Value]:
    """Return how far the tip would go without stops."""
    return {
        f"travel_free_{case}": Value(
            travel, "m", f"tip without stops, {case}", model="linear modes", source="response"
        )
        for case, travel in free.items()
    }


def _notes(
    design: DesignSpec, task: StopTask, place: StopPlace, free: dict[str, float]
) -> Iterator[Note]:
    """Yield where the operating line is stretched, and what the statics leave out."""
    share = place.L_a / task.L
    at = {
        "pi_1": place.pi_1,
        "pi_5": place.pi_5,
        "L_a/L": share,
        "travel/L": task.travel / task.L,
        "L_b/h": (task.L - place.L_a) / task.h,
        "modes": float(task.stops.simulation.modes),
    }
    if free:
        at["gap/free range"] = place.delta_G / (2.0 * max(free.values()))
    for limits in outside((*MEASURED, REACHED, *BEAM), at):
        text = f"{limits.quantity} = {show(at[limits.quantity], limits.unit)} is outside "
        yield Note("outside-validity", f"{text}{limits.spoken}: {limits.why}")
    if share >= HARD_STOP * (1.0 - assess.ROUNDING):
        text = f"at {share:.3g} of the blade the source counts the stop as a hard one: mind the "
        yield Note("hard-stop", f"{text}contact's shock, flexure stops --simulate")
    if task.stops.sides == "one":
        yield Note("one-sided", "the operating line was measured between stops on both sides")
    others = [name for name, case in design.cases.items() if case.vibration or case.shock]
    if others:
        text = f"the operating line was measured with a sine; {', '.join(others)} is none: "
        yield Note("line-of-a-sine", f"{text}it is no bound there, simulation decides")
    if free and max(free.values()) <= task.travel:
        text = "no case takes the tip beyond its travel without stops: none is needed"
        yield Note("no-stop-needed", text)
    mechanism = design.mechanism
    if isinstance(mechanism, TipMass) and not mechanism.is_point:
        text = "statics and line take the tip's force at the end of the blade, not at the offset "
        yield Note("offset-left-out", f"{text}centre of mass; --simulate takes the body as it is")
