"""The frequency response of a blade between stops: up and down, where it touches, what jumps."""

from collections.abc import Iterator
from dataclasses import replace
from math import pi

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.stopping.excitation import sweep_pieces
from flexcli.engine.stopping.scene import stop_scene
from flexcli.engine.stopping.simulation import Watch
from flexcli.engine.stopping.statics import task_of
from flexcli.errors import SolveError
from flexcli.mechanics.stopping.laws import Stops
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.response import steady_steps
from flexcli.mechanics.stopping.vibration import StoppedVibration
from flexcli.parts.case import Case
from flexcli.parts.design import DesignSpec
from flexcli.parts.excitation import Sweep
from flexcli.parts.geometries import Sizes
from flexcli.parts.mechanisms.tip_mass import TipMass
from flexcli.results import Result, StopSweep, SweepStep

__all__ = ["swept"]

STEPS = 61
ABOUT = (0.9, 1.3)
"""Ends of the response to a sine case, over the blade's own frequency."""
MOST_WINDOWS = 20
"""Windows of 20 periods after which a step is left, settled or not."""


def swept(result: Result, design: DesignSpec, sizes: Sizes, watch: Watch) -> Result:
    """Return a sized stop with the frequency response of every sine or sweep.

    A sine is stepped from one steady motion to the next; a sweep runs at its own rate.

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
        place = result.stops.chosen
        blade, stops, _ = stop_scene(design, mechanism, task, sizes, place, name)
        steps: list[SweepStep] = []
        planned, how, source = _steps(case, blade, stops)
        for step in source:
            steps.append(step)
            if not watch(name, len(steps) / planned):
                how += f", interrupted after {len(steps)} of {planned} steps"
                break
        found.append(_told(name, how, steps))
    if not found:
        raise SolveError(
            "no-sine", "no case has a sine or a sweep", "add sine: or sweep: to a case"
        )
    return replace(result, stops=result.stops._replace(sweeps=tuple(found)))


def _steps(case: Case, blade: ModalBlade, stops: Stops) -> tuple[int, str, Iterator[SweepStep]]:
    """Return how many steps there are, how they are made, and the steps."""
    if case.sweep is not None:
        rate = case.sweep.rate
        speed = f"{rate.speed:g} Hz/s" if rate.is_linear else f"{rate.speed * 60.0:g} oct/min"
        return 2 * STEPS, f"sweeping at {speed}", _running(case.sweep, blade, stops)
    assert case.sine is not None  # the caller's case
    angular = float(blade.angular[0]) * np.linspace(*ABOUT, STEPS)
    amplitude = case.sine.acceleration
    return (
        2 * STEPS,
        "from one steady motion to the next",
        _steady(angular, amplitude, blade, stops),
    )


def _steady(
    angular: NDArray[np.float64], amplitude: float, blade: ModalBlade, stops: Stops
) -> Iterator[SweepStep]:
    for up in (True, False):
        for step in steady_steps(
            blade,
            stops,
            angular=angular if up else angular[::-1],
            amplitude=amplitude,
            most_windows=MOST_WINDOWS,
        ):
            yield SweepStep(
                up,
                step.angular / (2.0 * pi),
                step.peaks.travel,
                step.peaks.force,
                step.contacts,
                step.settled,
            )


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


def _told(case: str, how: str, steps: list[SweepStep]) -> StopSweep:
    """Return a response with its contact bands and the range between them."""
    up, down = (_band([s for s in steps if s.up is way]) for way in (True, False))
    metastable = None
    # both ways must have been gone: without contact on one of them, all of the other's is a choice
    if up is not None and down is not None and up[1] > down[1]:
        metastable = (down[1], up[1])
    return StopSweep(case, how, tuple(steps), up, down, metastable)


def _band(steps: list[SweepStep]) -> tuple[float, float] | None:
    touched = [step.frequency for step in steps if step.force > 0.0 or step.contacts > 0.0]
    return (min(touched), max(touched)) if touched else None
