"""The frequency response of a blade between stops: up and down, where it touches, what jumps."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from math import inf, pi
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.stopping.excitation import sweep_pieces
from flexcli.engine.stopping.ratios import ratios
from flexcli.engine.stopping.scene import is_round, stop_scene
from flexcli.engine.stopping.simulation import Watch, with_time
from flexcli.engine.stopping.statics import task_of
from flexcli.errors import SolveError
from flexcli.mechanics.stopping.kick import least_kick
from flexcli.mechanics.stopping.laws import Stops
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.periodic import PeriodicMotion
from flexcli.mechanics.stopping.response import Step, SteppedMotion, stepped_motion
from flexcli.mechanics.stopping.result import MotionKind
from flexcli.mechanics.stopping.vibration import StoppedVibration
from flexcli.parts.case import Case
from flexcli.parts.design import DesignSpec
from flexcli.parts.excitation import Sweep
from flexcli.parts.geometries import Sizes
from flexcli.results import Note, Result, Status
from flexcli.results.stops import StopEnd, StopKick, StopSweep, SweepStep

__all__ = ["swept"]

STEPS = 61
ABOUT = (0.9, 1.3)
"""Ends of the response to a sine case, over the blade's own frequency."""
BEYOND = 1.05
"""Ratio of the frequencies at which contact is followed past the end of the response."""
LOOK_UP = 32
"""Pieces of a sweep between two reports on how far it is."""
KICKS = 5
"""Frequencies in the range of two motions at which the blow from one to the other is sought."""
FARTHEST = 4.0
"""Where it is left, over the blade's own frequency: the base has long left the first mode."""
PERIODIC = "periodic motions"
RUN = "event-driven simulation"


def swept(result: Result, design: DesignSpec, sizes: Sizes, watch: Watch) -> Result:
    """Return a sized stop with the frequency response of every sine or sweep.

    A sine is stepped from one steady motion to the next; a sweep runs at its own rate, then so, to
    show what its rate does. One that was interrupted keeps its steps; the status is then no pass.

    Raises
    ------
    SolveError
        ``no-sine`` when no case has a sine or a sweep.
    """
    assert result.stops is not None  # the caller's result
    assert design.stops is not None
    task = task_of(design, design.stops, sizes)
    found: list[StopSweep] = []
    cost = result.cost
    interrupted = False
    for name, case in design.cases.items():
        if case.sine is None and case.sweep is None:
            continue
        place = result.stops.chosen
        blade, stops, law = stop_scene(design, task, sizes, place, name, head=inf)
        if is_round(task.stops.contact):
            law += " (a ball gives too: stops --simulate shows what that changes)"
        for way in _responses(case, blade, stops):
            begun = perf_counter()
            pace = _Pace(name, way.planned, watch)
            for _ in way.steps(pace.goes_on):
                pace.count += 1
                if not pace.goes_on():
                    break
            if pace.is_stopped:
                way.how += f", interrupted after {pace.count} of {way.planned} steps"
            response = way.result(name, law)
            if isinstance(way, _Stepped) and not pace.is_stopped:
                found_there = ratios(design, task, sizes, name, way.acceleration, pace.goes_on)
                response = response._replace(ratios=tuple(found_there))
            interrupted = interrupted or pace.is_stopped
            seconds = perf_counter() - begun
            found.append(response._replace(seconds=seconds, is_complete=not pace.is_stopped))
            cost = with_time(cost, seconds, PERIODIC if isinstance(way, _Stepped) else RUN)
    if not found:
        raise SolveError(
            "no-sine", "no case has a sine or a sweep", "add sine: or sweep: to a case"
        )
    notes = tuple(
        Note(
            "interrupted", f"case '{sweep.case}': the response was interrupted; its steps are kept"
        )
        for sweep in found
        if not sweep.is_complete
    )
    status = result.status
    if interrupted and status is Status.PASS:
        status = Status.UNDECIDED
    return replace(
        result,
        status=status,
        warnings=(*result.warnings, *notes),
        cost=cost,
        stops=result.stops._replace(sweeps=tuple(found)),
    )


@dataclass
class _Pace:
    """How far a response is, and whether it shall end."""

    case: str
    planned: int
    watch: Watch
    count: int = 0
    is_stopped: bool = False

    def goes_on(self) -> bool:
        share = min(self.count / self.planned, 1.0)
        self.is_stopped = self.is_stopped or not self.watch(self.case, share)
        return not self.is_stopped


def _responses(case: Case, blade: ModalBlade, stops: Stops) -> "Iterator[_Stepped | _Running]":
    """Yield the response to a sine, or to a sweep at its own rate and at none."""
    if case.sweep is not None:
        sweep, rate = case.sweep, case.sweep.rate
        speed = f"{rate.speed:g} Hz/s" if rate.is_linear else f"{rate.speed * 60.0:g} oct/min"
        yield _Running(sweep, blade, stops, f"sweeping at {speed}")
        low, high = (2.0 * pi * f for f in sweep.band)
        if sweep.acceleration is not None:  # the steps are of one level
            yield _Stepped(sweep.acceleration, np.linspace(low, high, STEPS), blade, stops, high)
    if case.sine is not None:
        own = float(blade.angular[0])
        angular = own * np.linspace(*ABOUT, STEPS)
        yield _Stepped(case.sine.acceleration, angular, blade, stops, FARTHEST * own)


class _Stepped:
    """From one steady motion to the next, up and down; contact is followed to where it ends."""

    def __init__(
        self,
        acceleration: float,
        angular: NDArray[np.float64],
        blade: ModalBlade,
        stops: Stops,
        farthest: float,
    ) -> None:
        self.acceleration = acceleration
        self.motion = stepped_motion(blade, stops, acceleration)
        self.angular, self.farthest = angular, farthest
        self.planned = 2 * angular.size + KICKS
        self.how = "from one steady motion to the next"
        self.taken: list[SweepStep] = []
        self.ends: list[StopEnd] = []
        self.kicks: list[StopKick] = []

    def steps(self, goes_on: Callable[[], bool]) -> Iterator[SweepStep | StopKick]:
        """Yield every step and kick, and keep it with the frequencies at which a motion ends."""
        self.motion.goes_on = goes_on
        for angular in self.angular:
            yield self._step(self.motion, float(angular), up=True)
        angular = float(self.angular[-1])
        while self.motion.touches and angular < self.farthest:
            angular = min(angular * BEYOND, self.farthest)
            yield self._step(self.motion, angular, up=True)
        if self.motion.touches:
            self.ends.append(StopEnd(angular / (2.0 * pi), True, "followed no farther"))
        down = self.motion.again()
        for angular in self.angular[::-1]:
            yield self._step(down, float(angular), up=False)
        yield from self._kicked(down, goes_on)

    def _step(self, motion: SteppedMotion, angular: float, *, up: bool) -> SweepStep:
        found = motion.follow(angular)
        if motion.end is not None:
            self.ends.append(StopEnd(motion.end.angular / (2.0 * pi), up, motion.end.kind.value))
        self.taken.append(_sweep_step(found, up=up))
        return self.taken[-1]

    def _kicked(self, motion: SteppedMotion, goes_on: Callable[[], bool]) -> Iterator[StopKick]:
        """Yield what takes the blade from one motion to the other, across the range with both."""
        band = self.result("", "").metastable
        if band is None:
            return
        low, high = (2.0 * pi * end for end in band)
        known = [m for m in motion.known if low < m.angular < high and m.periods == 1]
        wanted = low + (high - low) * (np.arange(KICKS) + 0.5) / KICKS
        chosen = {id(m): m for w in wanted for m in [_nearest(known, w)] if m is not None}
        tip = motion.driven.blade.tip
        for contact in chosen.values():
            kick = least_kick(motion.driven, contact, goes_on)
            if kick is not None:
                speed = float(tip @ tip)
                self.kicks.append(
                    StopKick(
                        kick.angular / (2.0 * pi),
                        kick.none,
                        kick.enough,
                        speed * kick.none,
                        None if kick.enough is None else speed * kick.enough,
                    )
                )
                yield self.kicks[-1]

    def result(self, case: str, law: str) -> StopSweep:
        """Return the response with its contact bands, to where the motions gave way."""
        found = _response(case, self.how, self.taken, law)
        up, down = (
            _widened(band, [end.frequency for end in self.ends if end.up is way])
            for way, band in ((True, found.contact_up), (False, found.contact_down))
        )
        return found._replace(
            contact_up=up,
            contact_down=down,
            metastable=_range_of_both(up, down),
            ends=tuple(self.ends),
            kicks=tuple(self.kicks),
        )


def _nearest(known: list[PeriodicMotion], angular: float) -> PeriodicMotion | None:
    return min(known, key=lambda m: abs(m.angular - angular), default=None)


def _sweep_step(found: Step, *, up: bool) -> SweepStep:
    return SweepStep(
        up,
        found.angular / (2.0 * pi),
        found.peaks.travel,
        found.peaks.force,
        found.contacts,
        found.settled,
        found.periods,
        found.multiplier,
        found.least,
        found.outcome.value,
    )


def _widened(band: tuple[float, float] | None, edges: list[float]) -> tuple[float, float] | None:
    """Return a band of steps up to the frequencies at which a motion gave way beside it."""
    if band is None:
        return None
    return min((*edges, band[0])), max((*edges, band[1]))


@dataclass(eq=False)
class _Running:
    """A sweep at its own rate and its way back, peaks in equal parts of its time."""

    sweep: Sweep
    blade: ModalBlade
    stops: Stops
    how: str

    def __post_init__(self) -> None:
        self.planned = 2 * STEPS
        self.taken: list[SweepStep] = []

    def result(self, case: str, law: str) -> StopSweep:
        """Return the response with its contact bands."""
        return _response(case, self.how, self.taken, law)

    def steps(self, goes_on: Callable[[], bool]) -> Iterator[SweepStep]:
        """Yield the peaks in equal parts of the time of the sweep and of its way back."""
        sweep = self.sweep
        low, high = sorted((sweep.start, sweep.end))
        share = (np.arange(STEPS) + 0.5) / STEPS
        is_linear = sweep.rate.is_linear
        middles = low + (high - low) * share if is_linear else low * (high / low) ** share
        for backwards in (False, True):
            run = StoppedVibration(self.blade, self.stops)
            up = (sweep.start < sweep.end) is not backwards
            on_way = middles if up else middles[::-1]
            part, seen = 0, 0
            for count, progress in enumerate(run.run(sweep_pieces(sweep, backwards=backwards))):
                if count % LOOK_UP == 0 and not goes_on():
                    return
                done = progress.time / sweep.duration * STEPS
                if done < part + 1.0 - 1e-9:
                    continue
                peaks, frequency = run.take_peaks(), float(on_way[part])
                touched = (run.contact_count - seen) * STEPS / (frequency * sweep.duration)
                self.taken.append(
                    SweepStep(up, frequency, peaks.travel, peaks.force, touched, True)
                )
                yield self.taken[-1]
                part, seen = min(int(done + 1e-9), STEPS - 1), run.contact_count


def _response(case: str, how: str, steps: list[SweepStep], law: str) -> StopSweep:
    """Return a response with its contact bands and the range between them."""
    up, down = (_band([s for s in steps if s.up is way]) for way in (True, False))
    return StopSweep(case, how, tuple(steps), up, down, _range_of_both(up, down), law)


def _range_of_both(
    up: tuple[float, float] | None, down: tuple[float, float] | None
) -> tuple[float, float] | None:
    """Return where contact is a choice: both ways must have been gone."""
    return (down[1], up[1]) if up is not None and down is not None and up[1] > down[1] else None


def _band(steps: list[SweepStep]) -> tuple[float, float] | None:
    # what is dying away touches on its way, for a while
    lasting = [step for step in steps if step.outcome != MotionKind.TRANSIENT.value]
    touched = [step.frequency for step in lasting if step.force > 0.0 or step.contacts > 0.0]
    return (min(touched), max(touched)) if touched else None
