"""Judge stops case by case: the operating line, then simulation, its contact finer each time.

Each check is decided by the first of them whose error does not reach its requirement. The error
of a simulation is what other runs of it show: a blade as stiff as a plate, one tuned to the sine,
more modes; and of a rigid or linear stop, how far a round one's indentation is from its own.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import partial
from math import inf, nan, pi, sqrt
from time import perf_counter
from typing import NamedTuple

from flexcli.engine import assess
from flexcli.engine.stopping.run import Enough, stop_runs
from flexcli.engine.stopping.scene import LINEAR, contact_series, is_round
from flexcli.engine.stopping.statics import (
    LINE,
    StopTask,
    force_at_travel,
    line_error,
    line_limit,
    root_error,
    static_limits,
)
from flexcli.errors import SolveError
from flexcli.formulas.contact import CHORD, chord_deviation, point_contact
from flexcli.formulas.stop_stiffness import bent_shape, free_stiffness
from flexcli.parts.case import Case
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Limit
from flexcli.parts.requirements.dynamic import DynamicYield
from flexcli.parts.scene import LoadKind
from flexcli.parts.stops import Ball, Cylinder
from flexcli.parts.stops.stops import Simulation
from flexcli.results import Check, ErrorRange, Verdict
from flexcli.results.stops import StopHistory, StopPlace, StopSimulation

__all__ = ["STATICS", "StopJudgement", "Watch", "judge_stops", "looked_at", "shakes"]

Watch = Callable[[str, float], bool]
"""Told the case and the share that is done; answers whether to go on."""

STATICS = "statics"
EXCEEDED = 1.02
"""Over what a random peak needs to exceed its limit by, for a run to have shown enough."""
SAMPLE = 80
"""Periods of the blade in which a random vibration shows what another blade would do."""
NOTABLE = 1e-3
"""Change of the blade's rigidity worth a run of its own."""
CONTACT_HISTORY = 2.0
"""Over the travel that a contact's indentation adds at rest: one contact after another adds to it.
Between rigid and Hertz contact 0.5 % was found where this has 1.2 % (examples/boundary-control)."""
MORE_MODES = 2


class StopJudgement(NamedTuple):
    """The checks of stops by what decided them, the runs behind them and their seconds by model.

    ``simulations`` has the run of each case by the last model that was asked, ``aside`` those
    that only tell its error.
    """

    checks: tuple[Check, ...]
    simulations: tuple[StopSimulation, ...]
    aside: tuple[StopSimulation, ...]
    histories: tuple[StopHistory, ...]
    by_model: dict[str, float]


class _Strength(NamedTuple):
    """What else a case asks of the greatest stress: a row's name, strength [Pa] and factor."""

    name: str
    case: str
    strength: float
    factor: float
    source: str
    path: tuple[str | int, ...]


class _Peaks(NamedTuple):
    """The greatest of a case's runs: travel [m], stresses at base and stop [Pa], push [N]."""

    travel: float
    sigma_base: float
    sigma_contact: float
    force: float

    @property
    def bending(self) -> float:
        return max(self.sigma_base, self.sigma_contact)


def shakes(case: Case) -> bool:
    """Return whether a case shakes the base along x; along the blade (y) nothing bends it."""
    return "x" in case.shaken_axes


def looked_at(case: Case) -> frozenset[LoadKind]:
    """Return which loads of a case stops are judged by: what shakes the base along x."""
    return frozenset(
        kind
        for kind, there in (
            (LoadKind.ASD, case.asd is not None and set(case.asd.axes) == {"x"}),
            (LoadKind.AXES, case.axes is not None and set(case.axes.each) == {"x"}),
            (LoadKind.SINES, {each.axis for each in case.sines} == {"x"}),
            (LoadKind.SHOCK, case.shock is not None and case.shock.axis == "x"),
            (LoadKind.SINE, case.sine is not None and case.sine.axis == "x"),
            (LoadKind.SWEEP, case.sweep is not None and case.sweep.axis == "x"),
        )
        if there
    )


def judge_stops(
    design: DesignSpec,
    task: StopTask,
    sizes: Sizes,
    place: StopPlace,
    *,
    watch: Watch = lambda *_: True,
    simulate: bool = True,
    forced: bool = False,
    options: Simulation | None = None,
    keep_history: bool = False,
    with_requirements: bool = False,
) -> StopJudgement:
    """Return the checks of stops, each by the first model that decides it.

    Parameters
    ----------
    design, task, sizes, place : DesignSpec, StopTask, named tuple, StopPlace
        The design, what it asks of its stops, and the stop to judge.
    watch : callable
        Told what runs and how far it is; answers whether to go on.
    simulate : bool
        Whether a simulation may decide what the line does not.
    forced : bool
        Run every case to its end with the contact as the spec has it, whatever decides.
    options : Simulation, optional
        Over those of the spec.
    keep_history : bool
        Whether to keep samples in time of the runs.
    with_requirements : bool
        Whether to judge the design's own requirement on the stress under vibration as well.

    Raises
    ------
    SolveError
        When forced, for a case that is no motion in time.
    """
    options = options or task.stops.simulation
    series = _Series(design, task, sizes, place, watch, options, keep_history, forced)
    begun = perf_counter()
    checks = [c._replace(model=STATICS) for c in assess.checks(static_limits(task, place))]
    series.spend(LINE, perf_counter() - begun)
    f_0 = _frequency(task)
    shaken = [name for name, case in design.cases.items() if shakes(case)]
    for name in shaken:
        error = line_error(task, place, design.cases[name], f_0)
        line = line_limit(task, place, name, error)
        (on_line,) = assess.checks([line])
        on_line = on_line._replace(model=LINE)
        strengths = _strengths(design, name) if with_requirements else []
        found = [on_line]
        if simulate:
            found = series.climbed(name, on_line, strengths, f_0)
        else:
            found.extend(_undecided(strength) for strength in strengths)
        checks.extend(found)
    if not shaken:
        (on_line,) = assess.checks([line_limit(task, place, "", None)])
        checks.append(on_line._replace(model=LINE))
    return StopJudgement(
        tuple(check if check.path else check._replace(path=("stops",)) for check in checks),
        tuple(series.runs),
        tuple(series.aside),
        tuple(series.histories),
        series.seconds,
    )


def _frequency(task: StopTask) -> float:
    """Return the natural frequency of the tip on its free blade [Hz]."""
    k = float(free_stiffness(E=task.elastic.E, I=task.I, L=task.L))
    return sqrt(k / task.mechanism.equivalent_mass(task.L)) / (2.0 * pi)


def _strengths(design: DesignSpec, case: str) -> list[_Strength]:
    found = []
    for path, asked in design.requirements.each():
        if isinstance(asked, DynamicYield) and asked.applies(design.scene(case)):
            strength = design.material.strength(asked.allowable.replace("-", "_"))
            source = f"allowable: {asked.allowable}"
            at = ("requirements", *path)
            found.append(_Strength(asked.label, case, strength, asked.factor, source, at))
    return found


def _undecided(strength: _Strength, reason: str = "only a simulation gives it") -> Check:
    """Return the check of a strength whose stress is not known."""
    text = f"peak bending stress between the stops; {reason}"
    return Check(
        strength.name, strength.case, text, nan, strength.strength, "Pa", nan, strength.factor,
        Verdict.UNDECIDED, strength.source, path=strength.path,
    )  # fmt: skip


@dataclass(eq=False)
class _Series:
    """Runs of each case by the models in turn, and the seconds that each took."""

    design: DesignSpec
    task: StopTask
    sizes: Sizes
    place: StopPlace
    watch: Watch
    options: Simulation
    keep_history: bool
    forced: bool
    runs: list[StopSimulation] = field(default_factory=list)
    aside: list[StopSimulation] = field(default_factory=list)
    histories: list[StopHistory] = field(default_factory=list)
    seconds: dict[str, float] = field(default_factory=dict)

    def spend(self, model: str, seconds: float) -> None:
        """Add to the time that a model took."""
        self.seconds[model] = self.seconds.get(model, 0.0) + seconds

    def climbed(
        self, case: str, on_line: Check, strengths: list[_Strength], f_0: float
    ) -> list[Check]:
        """Return the checks of a case, each by the first model that decides it."""
        best: dict[str, Check] = {on_line.full_name: on_line}
        begun = perf_counter()
        try:
            for limits, model in self._models(case, strengths, f_0):
                for check in assess.checks(limits):
                    key = check.full_name
                    decided = key in best and best[key].verdict is not Verdict.UNDECIDED
                    if self.forced or not decided:
                        took = perf_counter() - begun
                        best[key] = check._replace(model=model, seconds=took)
                verdicts = {check.verdict for check in best.values()}
                if not self.forced and Verdict.UNDECIDED not in verdicts:
                    break
        except SolveError as error:
            if self.forced:
                raise
            reason = f"no simulation: {error}"
            best[on_line.full_name] = on_line._replace(quantity=f"{on_line.quantity}; {reason}")
            for strength in strengths:
                check = _undecided(strength, reason)
                best[check.full_name] = check
        return list(best.values())

    def _models(
        self, case: str, strengths: list[_Strength], f_0: float
    ) -> Iterator[tuple[list[Limit], str]]:
        """Yield the limits of a case by simulation: a round head rigid, linear, then Hertz'."""
        contact = self.task.stops.contact
        series, force = contact_series(contact), 0.0
        known = self._is_alone(case)
        errors, whole = self._spread(case, f_0) if known else ({}, True)
        for model in series[-1:] if self.forced else series:
            if model == LINEAR and not force:
                continue
            head = inf if model == series[0] else None
            if model == LINEAR:
                head = force / (CHORD * self._indented(force))
            self.runs = [run for run in self.runs if run.case != case]
            enough = None if self.forced else self._enough(strengths, errors)
            runs = self._run(case, self.options, enough, head=head)
            self.runs.extend(runs)
            peaks = _greatest(runs)
            complete = whole and all(run.is_complete for run in runs)
            of_contact = self._contact_errors(peaks, head)
            error = partial(self._error, errors, of_contact, complete, known)
            yield list(self._limits(case, runs, peaks, strengths, error)), model
            force = peaks.force

    def _is_alone(self, case: str) -> bool:
        """Return whether each run of a case has all that acts in it.

        Sines run on a random vibration; all else that shakes the base runs by itself.
        """
        given = self.design.cases[case]
        random = given.vibration is not None or None
        by_itself = (random or given.sine, given.sweep, given.shock)
        beside = (given.acceleration, given.stroke, given.load, given.wrench)
        return sum(each is not None for each in by_itself) == 1 and not any(beside)

    def _run(
        self,
        case: str,
        options: Simulation,
        enough: Enough | None,
        *,
        design: DesignSpec | None = None,
        head: float | None = inf,
        stiffening: float = 0.0,
        more_modes: int = 0,
    ) -> list[StopSimulation]:
        """Run a case to its end, or to where a random one has shown enough."""
        found = []
        for run in stop_runs(
            design or self.design, self.task, self.sizes, self.place, case,
            options=options, keep_history=self.keep_history and design is None, head=head,
            stiffening=stiffening, more_modes=more_modes,
        ):  # fmt: skip
            simulation = run.driven(partial(self.watch, case), enough)
            self.spend(simulation.model, simulation.seconds)
            found.append(simulation)
            if (history := run.history()) is not None:
                self.histories.append(history)
        if not found:
            raise SolveError(
                "no-excitation",
                f"case '{case}' does not shake the blade",
                "give it a sine, sweep, shock or asd",
            )
        return found

    def _enough(self, strengths: list[_Strength], errors: dict[str, ErrorRange]) -> Enough:
        """Return what tells that a peak lies beyond its limit by more than its error."""
        task = self.task
        low = min((error.low for error in errors.values()), default=0.0)
        over = EXCEEDED / max(1.0 + low, 0.1)
        allowed = [s.strength / s.factor for s in strengths]
        if task.stops.bending is not None and task.bending is not None:
            allowed.append(task.bending / task.stops.bending.factor)
        most = min(allowed, default=inf)

        def enough(travel: float, base: float, at_stop: float) -> bool:
            return travel > over * task.travel or max(base, at_stop) > over * most

        return enough

    def _spread(self, case: str, f_0: float) -> tuple[dict[str, ErrorRange], bool]:
        """Return how far the peaks of other blades lie from those of the beam in its modes.

        All with a rigid contact, and one sample of a random vibration for each: what the seed
        changes in it is part of the range.
        """
        task, given = self.task, self.design.cases[case]
        high, low = task.rigidity.high, task.rigidity_at(self.place).low
        stiffer = [high] if high > NOTABLE else []
        tuned = (given.sine.frequency / f_0) ** 2 - 1.0 if given.sine is not None else 0.0
        stiffer += [tuned] if 0.0 < tuned < high else []
        has_more = self.design.material.density is not None or not task.mechanism.is_point
        if not stiffer and not has_more:
            return {name: ErrorRange(low, -low) for name in _Peaks._fields}, True
        options = self.options.model_copy(update={"confidence": 0.5})
        design = self._sampled(case, f_0)
        run = partial(self._run, case, options, None, design=design)
        base = run()
        all_runs, ends = list(base), {name: [0.0] for name in _Peaks._fields}
        steepest = dict.fromkeys(_Peaks._fields, 1.0)
        others = [(s, 0) for s in stiffer] + ([(0.0, MORE_MODES)] if has_more else [])
        for stiffening, more in others:
            runs = run(stiffening=stiffening, more_modes=more)
            all_runs += runs
            for name, mine, theirs in zip(
                _Peaks._fields, _greatest(base), _greatest(runs), strict=True
            ):
                change = theirs / mine - 1.0 if mine > 0.0 else (inf if theirs > 0.0 else 0.0)
                ends[name].append(change)
                if stiffening:
                    steepest[name] = max(steepest[name], abs(change) / stiffening)
        self.aside.extend(all_runs)
        found = {}
        for name, changes in ends.items():
            softer = steepest[name] * abs(low)
            found[name] = ErrorRange(max(min(changes) - softer, -1.0), max(changes) + softer)
        return found, all(simulation.is_complete for simulation in all_runs)

    def _sampled(self, case: str, f_0: float) -> DesignSpec:
        """Return the design with a random vibration no longer than a sample of it."""
        given = self.design.cases[case]
        if given.vibration is None or "x" not in given.vibration.axes:
            return self.design.model_copy()
        along_x = given.vibration.alone("x")
        if along_x.lasts is None:
            return self.design.model_copy()
        shorter = given.model_copy(
            update={
                "asd": along_x.model_copy(update={"duration": min(along_x.lasts, SAMPLE / f_0)}),
                "axes": None,
            }
        )
        return self.design.model_copy(update={"cases": {**self.design.cases, case: shorter}})

    def _error(
        self,
        errors: dict[str, ErrorRange],
        of_contact: dict[str, float],
        whole: bool,
        known: bool,
        name: str,
    ) -> ErrorRange | None:
        """Return the error of a peak: of the blade, of the contact, of a run cut short."""
        if not known:
            return None
        of_blade = errors.get(name, ErrorRange(0.0, 0.0))
        low, high = of_blade.low - of_contact[name], of_blade.high + of_contact[name]
        return ErrorRange(max(low, -1.0), high if whole else inf)

    def _indented(self, force: float) -> float:
        """Return how deep a round head goes into the blade [m], nothing for one that is not."""
        contact = self.task.stops.contact
        if not isinstance(contact, Ball | Cylinder):
            return 0.0
        # a ball gives more than a cylinder of its radius
        modulus = contact.modulus(self.task.elastic)
        return float(point_contact(F=force, R=contact.radius, E_star=modulus).approach)

    def _contact_errors(self, peaks: _Peaks, head: float | None) -> dict[str, float]:
        """Return by what share the indentation of a round head may change each peak of a run.

        Nothing of a run whose stop gives by Hertz' law itself.
        """
        task, place = self.task, self.place
        deep = self._indented(peaks.force)
        if is_round(task.stops.contact) and head is None:
            deep = 0.0
        if not deep or not peaks.travel:
            return dict.fromkeys(_Peaks._fields, 0.0)
        if head not in (None, inf):
            deep *= chord_deviation(peaks.force / (head * deep))
        added = CONTACT_HISTORY * deep / float(bent_shape(place.L_a / task.L))
        travel = added / peaks.travel
        loads = [
            force_at_travel(task, place, 0.0, peaks.travel * (1.0 + end)) for end in (0.0, travel)
        ]
        load = abs(loads[1] / loads[0] - 1.0) if loads[0] > 0.0 else inf
        return {"travel": travel, "sigma_base": load, "sigma_contact": load, "force": load}

    def _limits(
        self,
        case: str,
        runs: list[StopSimulation],
        peaks: _Peaks,
        strengths: list[_Strength],
        error: Callable[[str], ErrorRange | None],
    ) -> Iterator[Limit]:
        """Yield what a simulated case must keep."""
        task = self.task
        source = f"event-driven simulation, {runs[0].model}{_sureness(runs)}"
        worst = "sigma_base" if peaks.sigma_base > peaks.sigma_contact else "sigma_contact"
        least = "at least: the run had decided" if any(r.has_decided for r in runs) else ""
        least = f" ({least})" if least else ""
        yield Limit(
            "travel", case, f"peak of the tip{least}", peaks.travel, task.travel, "m", source,
            error=error("travel"),
        )  # fmt: skip
        bending, shear = task.stops.bending, task.stops.shear
        text = f"peak bending stress, base or stop{least}"
        if bending is not None and task.bending is not None:
            yield Limit(
                "bending", case, text, peaks.bending, task.bending, "Pa", source,
                required=bending.factor, error=error(worst),
            )  # fmt: skip
        for strength in strengths:
            yield Limit(
                strength.name, case, text, peaks.bending, strength.strength, "Pa",
                f"{source}; {strength.source}", required=strength.factor, error=error(worst),
                path=strength.path,
            )  # fmt: skip
        pressed = task.stops.contact.stress(peaks.force, task.elastic)
        if shear is not None and task.shear is not None and pressed is not None:
            of_force = error("force")
            yield Limit(
                "contact shear", case, f"peak shear below the contact{least}", pressed.shear,
                task.shear, "Pa", source, required=shear.factor,
                error=of_force and root_error(of_force),
            )  # fmt: skip


def _greatest(runs: Iterable[StopSimulation]) -> _Peaks:
    """Return the greatest peaks of several runs of a case."""
    rows = [(run.travel, run.sigma_base, run.sigma_contact, run.force) for run in runs]
    return _Peaks(*map(max, zip(*rows, strict=True)))


def _sureness(runs: Iterable[StopSimulation]) -> str:
    """Return with which confidence a random peak is no higher once more."""
    for run in runs:
        if run.confidence is not None:
            return f", confidence {run.confidence:.0%} that one more exposure has no higher peak"
    return ""
