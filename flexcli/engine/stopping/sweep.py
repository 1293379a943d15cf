"""The frequency response of a blade between stops: up and down, where it touches, what jumps."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import pi
from time import perf_counter

import numpy as np

from flexcli.engine.stopping.excitation import sweep_pieces
from flexcli.engine.stopping.scene import is_round, stop_scene
from flexcli.engine.stopping.simulation import Watch, with_time
from flexcli.engine.stopping.statics import task_of
from flexcli.errors import SolveError
from flexcli.mechanics.stopping.laws import Stops
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.response import Step, SteppedMotion, stepped_motion
from flexcli.mechanics.stopping.vibration import StoppedVibration
from flexcli.parts.case import Case
from flexcli.parts.design import DesignSpec
from flexcli.parts.excitation import Sine, Sweep
from flexcli.parts.geometries import Sizes
from flexcli.parts.mechanisms.tip_mass import TipMass
from flexcli.results import Note, Result, Status, StopSweep, SweepStep

__all__ = ["swept"]

STEPS = 61
ABOUT = (0.9, 1.3)
"""Ends of the response to a sine case, over the blade's own frequency."""
BEYOND = 1.05
"""Ratio of the frequencies at which contact is followed past the end of the response."""
FARTHEST = 4.0
"""Where it is left, over the blade's own frequency: the base has long left the first mode."""
PERIODIC = "periodic motions"
RUN = "event-driven simulation"


def swept(result: Result, design: DesignSpec, sizes: Sizes, watch: Watch) -> Result:
    """Return a sized stop with the frequency response of every sine or sweep.

    A sine is stepped from one steady motion to the next; a sweep runs at its own rate. A response
    that was interrupted keeps its steps, and the status cannot be a pass.

    Raises
    ------
    SolveError
        ``no-sine`` when no case has a sine or a sweep.
    """
    assert result.stops is not None  # the caller's result
    assert design.stops is not None
    mechanism = design.mechanism
    assert isinstance(mechanism, TipMass)  # the design refuses others
    task = task_of(design, design.stops, sizes)
    found = []
    for name, case in design.cases.items():
        if case.sine is None and case.sweep is None:
            continue
        begun = perf_counter()
        place = result.stops.chosen
        blade, stops, law = stop_scene(design, mechanism, task, sizes, place, name, rigid=True)
        if is_round(task.stops.contact):
            law += " (a ball gives too: stops --simulate shows what that changes)"
        way = _ways(case, blade, stops)
        complete = True
        for count, _ in enumerate(way.steps(), 1):
            if not watch(name, min(count / way.planned, 1.0)):
                way.how += f", interrupted after {count} of {way.planned} steps"
                complete = False
                break
        told = way.told(name, law)
        found.append(told._replace(seconds=perf_counter() - begun, is_complete=complete))
    if not found:
        raise SolveError(
            "no-sine", "no case has a sine or a sweep", "add sine: or sweep: to a case"
        )
    interrupted = [sweep.case for sweep in found if not sweep.is_complete]
    notes = tuple(
        Note("interrupted", f"case '{case}': the response was interrupted; its steps are kept")
        for case in interrupted
    )
    cost = result.cost
    for sweep in found:
        cost = with_time(cost, sweep.seconds, PERIODIC if design.cases[sweep.case].sine else RUN)
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


def _ways(case: Case, blade: ModalBlade, stops: Stops) -> "_Stepped | _Running":
    if case.sweep is not None:
        rate = case.sweep.rate
        speed = f"{rate.speed:g} Hz/s" if rate.is_linear else f"{rate.speed * 60.0:g} oct/min"
        return _Running(case.sweep, blade, stops, f"sweeping at {speed}")
    assert case.sine is not None  # the caller's case
    return _Stepped(case.sine, blade, stops)


class _Stepped:
    """From one steady motion to the next, up and down; contact is followed to where it ends."""

    def __init__(self, sine: Sine, blade: ModalBlade, stops: Stops) -> None:
        self.motion = stepped_motion(blade, stops, sine.acceleration)
        self.angular = float(blade.angular[0]) * np.linspace(*ABOUT, STEPS)
        self.planned, self.how = 2 * STEPS, "from one steady motion to the next"
        self.taken: list[SweepStep] = []
        self.edges: dict[bool, list[float]] = {True: [], False: []}

    def steps(self) -> Iterator[SweepStep]:
        """Yield every step, and keep it with the frequencies at which a motion gave way."""
        for angular in self.angular:
            yield self._step(self.motion, float(angular), up=True)
        angular, most = float(self.angular[-1]), FARTHEST * float(self.angular[0]) / ABOUT[0]
        while self.motion.touches and angular < most:
            angular *= BEYOND
            yield self._step(self.motion, angular, up=True)
        down = self.motion.again()
        for angular in self.angular[::-1]:
            yield self._step(down, float(angular), up=False)

    def _step(self, motion: SteppedMotion, angular: float, *, up: bool) -> SweepStep:
        found = motion.follow(angular)
        if motion.ends is not None:
            self.edges[up].append(motion.ends / (2.0 * pi))
        self.taken.append(_told_step(found, up=up))
        return self.taken[-1]

    def told(self, case: str, law: str) -> StopSweep:
        """Return the response with its contact bands, to where the motions gave way."""
        found = _told(case, self.how, self.taken, law)
        up, down = (
            _widened(band, self.edges[way])
            for way, band in ((True, found.contact_up), (False, found.contact_down))
        )
        return found._replace(contact_up=up, contact_down=down, metastable=_between(up, down))


def _told_step(found: Step, *, up: bool) -> SweepStep:
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

    def told(self, case: str, law: str) -> StopSweep:
        """Return the response with its contact bands."""
        return _told(case, self.how, self.taken, law)

    def steps(self) -> Iterator[SweepStep]:
        """Yield every part, and keep it."""
        for step in _running(self.sweep, self.blade, self.stops):
            self.taken.append(step)
            yield step


def _running(sweep: Sweep, blade: ModalBlade, stops: Stops) -> Iterator[SweepStep]:
    """Yield the peaks in equal parts of the time of a sweep and of its way back."""
    low, high = sorted((sweep.start, sweep.end))
    share = (np.arange(STEPS) + 0.5) / STEPS
    middles = low + (high - low) * share if sweep.rate.is_linear else low * (high / low) ** share
    for backwards in (False, True):
        run = StoppedVibration(blade, stops)
        up = (sweep.start < sweep.end) is not backwards
        on_way = middles if up else middles[::-1]
        part, seen = 0, 0
        for progress in run.run(sweep_pieces(sweep, backwards=backwards)):
            done = progress.time / sweep.duration * STEPS
            if done < part + 1.0 - 1e-9:
                continue
            peaks, frequency = run.take_peaks(), float(on_way[part])
            touched = (run.contact_count - seen) * STEPS / (frequency * sweep.duration)
            yield SweepStep(up, frequency, peaks.travel, peaks.force, touched, True)
            part, seen = min(int(done + 1e-9), STEPS - 1), run.contact_count


def _told(case: str, how: str, steps: list[SweepStep], law: str) -> StopSweep:
    """Return a response with its contact bands and the range between them."""
    up, down = (_band([s for s in steps if s.up is way]) for way in (True, False))
    return StopSweep(case, how, tuple(steps), up, down, _between(up, down), law)


def _between(
    up: tuple[float, float] | None, down: tuple[float, float] | None
) -> tuple[float, float] | None:
    """Return where contact is a choice: both ways must have been gone."""
    return (down[1], up[1]) if up is not None and down is not None and up[1] > down[1] else None


def _band(steps: list[SweepStep]) -> tuple[float, float] | None:
    touched = [step.frequency for step in steps if step.force > 0.0 or step.contacts > 0.0]
    return (min(touched), max(touched)) if touched else None
