"""What accuracy costs in time: a stopped blade's first periods by every method and tolerance."""

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from time import perf_counter
from typing import NamedTuple

import numpy as np

from flexcli.engine.comparing.compared import Reference, Timed, compared, relative_bound
from flexcli.engine.comparing.penalty_law import RIGID_PENALTY
from flexcli.engine.comparing.time_methods import Method, TimePeaks, event_driven, penalty_run
from flexcli.engine.comparing.time_motions import StoppedMotion, motions
from flexcli.mechanics.stopping.laws import RigidStop
from flexcli.numerics.signal_pieces import Piece
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.stops import Rigid
from flexcli.results import Note
from flexcli.results.accuracy import AccuracyResult

__all__ = ["TimeMethod", "TimeNumber", "accuracy_in_time", "bounded", "time_methods", "time_notes"]

METHODS: tuple[Method, ...] = ("Radau", "DOP853")
TOLERANCES = (1e-4, 1e-6, 1e-8, 1e-10)
CONTROLS = (1e-12, 1e-11)
"""Tolerances of the control run, finer than any of the series, and of the run that bounds it."""
ROUNDING = 1e-12
"""Least error of a finest value: what is left of sixteen digits after many events."""
CUT = 0.381966
"""Share of a piece at which the control of a rigid stop cuts it: no multiple of anything."""

NUMBERS = (
    ("tip_peak", "peak of the tip", "m"),
    ("F_peak", "peak force on a stop", "N"),
    ("t_contact", "start of the last contact", "s"),
)
"""The numbers of a run, in the order of its peaks."""


class TimeNumber(NamedTuple):
    """A number of a motion."""

    name: str
    label: str
    unit: str


class TimeMethod(NamedTuple):
    """A method by the name that reports give it."""

    name: str
    by: Callable[[StoppedMotion], TimePeaks]


def accuracy_in_time(
    design: DesignSpec, sizes: Sizes, runs: int, asked: float
) -> AccuracyResult | None:
    """Return what accuracy costs in time, for designs with stops that a sine or shock shakes."""
    shaken = list(motions(design, sizes))
    settled: list[Reference[TimeNumber]] = []
    unsettled: list[str] = []
    columns: list[tuple[int, int]] = []
    for i, motion in enumerate(shaken):
        for j, (number, value, bound) in enumerate(bounded(motion)):
            if bound is None:
                unsettled.append(number.name)
            else:
                settled.append(Reference(number, value, bound))
                columns.append((i, j))
    if not settled:
        return None
    models = time_methods()
    times = _timed(shaken, models, runs, columns)
    return compared(settled, models, times, asked, tuple(unsettled))


def time_methods() -> tuple[TimeMethod, ...]:
    """Return general integrators from coarse to fine, and the event-driven run."""
    general = [
        TimeMethod(
            f"{method} at {tolerance:.0e}",
            partial(penalty_run, method=method, tolerance=tolerance),
        )
        for method in METHODS
        for tolerance in TOLERANCES
    ]
    return (*general, TimeMethod("event-driven", lambda motion: event_driven(motion)[0]))


def bounded(motion: StoppedMotion) -> Iterator[tuple[TimeNumber, float, float | None]]:
    """Yield each number by the event-driven run and its bound, nothing where it is unsure.

    The bound is the distance to a control, that control's distance from a coarser one, and the
    share of the energy that the run lost account of. The controls are a general integrator under
    the same law: it steps over the kinks of the force, where its tolerance is kept by luck, so that
    either may be the farther off; but what they lose has nothing to do with what the run loses. A
    rigid stop has no other law: its control is the same run with every piece cut in two.
    """
    finest, residual = event_driven(motion)
    if isinstance(motion.stops.law, RigidStop):
        control, _ = event_driven(motion._replace(pieces=tuple(_cut(motion.pieces))))
        coarser = control
    else:
        control, coarser = (penalty_run(motion, "DOP853", tolerance) for tolerance in CONTROLS)
    for (name, label, unit), value, near, far in zip(
        NUMBERS, finest, control, coarser, strict=True
    ):
        number = TimeNumber(f"{name}_{motion.name}", f"{label}, {motion.label}", unit)
        own = abs(near - far) / abs(near) if near else 0.0
        yield number, value, relative_bound(value, near, own + residual + ROUNDING)


def _cut(pieces: Iterable[Piece]) -> Iterator[Piece]:
    for piece in pieces:
        yield piece._replace(duration=CUT * piece.duration)
        yield piece.after(CUT * piece.duration)


def _timed(
    shaken: list[StoppedMotion],
    models: tuple[TimeMethod, ...],
    runs: int,
    columns: list[tuple[int, int]],
) -> Timed:
    """Return the numbers of every method, and the seconds of the run that gives them.

    The methods take turns, so that a busy machine slows all of them alike.
    """
    seconds = np.empty((runs, len(models), len(shaken)))
    values = np.empty((len(models), len(shaken), len(NUMBERS)))
    for run in range(runs):
        for i, model in enumerate(models):
            for j, motion in enumerate(shaken):
                begun = perf_counter()
                values[i, j] = model.by(motion)
                seconds[run, i, j] = perf_counter() - begun
    of, which = np.array(columns).T
    return Timed(values[:, of, which], seconds[:, :, of], seconds.sum(axis=2))


def time_notes(design: DesignSpec) -> Iterator[Note]:
    """Yield what the penalty stands for where the stop has no law of force."""
    contact = design.stops.contact if design.stops is not None else None
    if isinstance(contact, Rigid) and contact.restitution is not None:
        text = (
            "in time a rigid stop with a restitution is an impulse; general integrators see a "
            f"spring {RIGID_PENALTY:g} times as stiff as the blade there: that is in their error"
        )
        yield Note("penalty-for-rigid", text)
