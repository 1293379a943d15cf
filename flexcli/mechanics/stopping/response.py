"""Steady motions of a blade between stops, one frequency after another from the last motion."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import pi
from typing import NamedTuple

import numpy as np

from flexcli.errors import Outcome
from flexcli.mechanics.stopping.branch import Bifurcation, BranchEnd, branch_end
from flexcli.mechanics.stopping.laws import Stops
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.periodic import (
    DrivenBlade,
    LinearMotion,
    MotionPoint,
    PeriodicMotion,
)
from flexcli.mechanics.stopping.result import MotionKind, Peaks
from flexcli.mechanics.stopping.vibration import StoppedVibration

__all__ = [
    "Step",
    "SteppedMotion",
    "stepped_motion",
]

BURST = 10
"""Periods between two trials for a periodic motion while the blade settles."""
BURSTS = 30
"""Bursts after which a frequency is left unsettled; the last third gives its range of peaks."""
MOST_BURSTS = 300
"""The same for a motion that dies away, which takes some three thousand periods at Q = 1000."""
DYING = 0.995
"""Peaks of the last third over those of the third before, below which a motion dies away."""
ORDERS = (1, 2, 3)
"""Periods of the base after which a motion is sought to repeat."""
HIGHER_FROM = 10
"""Bursts from which motions of more than one period are sought too."""
FINEST = 1e-4
"""Share of the frequency to which the end of a branch is found."""
NEAR = 0.3
"""Share of the frequency from which a known motion is followed to another."""
PARTS = 16
"""Parts of a period in which the blade is looked for away from its stops."""


class Step(NamedTuple):
    """The motion at one frequency: peaks, contacts per period, what it came to.

    ``periods`` of the base after which it repeats and the largest Floquet multiplier; of what did
    not settle neither, but ``least``, the smallest peak of the tip in the bursts that ``peaks``
    has the largest of.
    """

    angular: float
    peaks: Peaks
    contacts: float
    outcome: MotionKind = MotionKind.PERIODIC
    periods: int = 1
    multiplier: float | None = None
    least: float | None = None

    @property
    def settled(self) -> bool:
        """Whether the motion is steady."""
        return self.outcome in (MotionKind.PERIODIC, MotionKind.SUBHARMONIC)


@dataclass(eq=False)
class SteppedMotion:
    """A blade whose base's frequency is stepped: ``follow`` goes on from the motion before.

    The first is the motion without contact where there is one; a blade that moves already, or has
    none, is run. ``known`` are periodic motions with contact, found on any way through the
    frequencies; ``end`` is where the motion of the step before gave way. ``goes_on`` is asked in
    the middle of a long run.
    """

    driven: DrivenBlade
    known: list[PeriodicMotion]
    point: MotionPoint
    motion: LinearMotion | PeriodicMotion | None = None
    angular: float = 0.0
    end: BranchEnd | None = None
    goes_on: Callable[[], bool] = lambda: True

    @property
    def touches(self) -> bool:
        """Whether the last motion was one with contact."""
        return isinstance(self.motion, PeriodicMotion)

    def follow(self, angular: float) -> Step:
        """Return the motion at a frequency that the one before leads to."""
        self.end = None
        before, self.angular = self.angular, angular
        if isinstance(self.motion, PeriodicMotion):
            last, arrived = self._continued(self.motion, angular)
            if arrived:
                return self._contact(last)
            self.end = self._end(last, angular)
            self.point = last.start
        elif isinstance(self.motion, LinearMotion):
            if self.driven.is_free(angular):
                return self._linear(angular)
            if before:
                touch = self.driven.grazing(before, angular)
                self.end = BranchEnd(touch or angular, Bifurcation.TOUCH)
            if (found := self._known_at(angular)) is not None:
                return self._contact(found)
        elif not before and not self.point.rate.any() and self.driven.is_free(angular):
            return self._linear(angular)
        return self._settled(angular)

    def again(self) -> "SteppedMotion":
        """Return the same blade before a first frequency, with the motions found so far."""
        return replace(self, motion=None, point=at_rest(self.driven.blade), angular=0.0)

    def _linear(self, angular: float) -> Step:
        self.motion = found = self.driven.linear(angular)
        self.point = found.start
        peaks = Peaks(found.tip, found.tip, found.at_stop, found.base_moment, 0.0, 0.0)
        blade = self.driven.blade
        slowest = float((blade.damping * blade.angular).min())
        return Step(angular, peaks, 0.0, multiplier=float(np.exp(-slowest * 2.0 * pi / angular)))

    def _contact(self, found: PeriodicMotion) -> Step:
        self.motion = found = self.driven.begun_free(found)
        self.point = found.start
        self.known.append(found)
        return Step(
            found.angular,
            self.driven.peaks(found),
            found.contacts / found.periods,
            MotionKind.PERIODIC if found.periods == 1 else MotionKind.SUBHARMONIC,
            found.periods,
            found.largest,
        )

    def _accepted(self, angular: float, guess: MotionPoint, periods: int) -> PeriodicMotion | None:
        """Return the stable motion with contact near a point, if there is one."""
        found = self.driven.periodic(angular, guess, periods)
        return found if found is not None and found.is_stable and found.contacts else None

    def _continued(self, motion: PeriodicMotion, angular: float) -> tuple[PeriodicMotion, bool]:
        """Return the motion followed to a frequency, or to where it ends."""
        step = angular - motion.angular
        previous: PeriodicMotion | None = None
        while motion.angular != angular:
            rest = angular - motion.angular
            tried = angular if abs(step) >= abs(rest) else motion.angular + step
            guess = motion.start
            if previous is not None and previous.start.phase == guess.phase:
                share = (tried - motion.angular) / (motion.angular - previous.angular)
                guess = replace(
                    guess,
                    q=guess.q + share * (guess.q - previous.start.q),
                    rate=guess.rate + share * (guess.rate - previous.start.rate),
                )
            found = self._accepted(tried, guess, motion.periods)
            if found is None:
                step /= 2.0
                if abs(step) < FINEST * motion.angular:
                    return motion, False
                continue
            previous, motion = motion, self.driven.begun_free(found)
        return motion, True

    def _known_at(self, angular: float) -> PeriodicMotion | None:
        """Return a motion with contact that is known from nearby, followed to a frequency."""
        near = min(self.known, key=lambda m: abs(m.angular - angular), default=None)
        if near is None or abs(near.angular / angular - 1.0) > NEAR:
            return None
        found, arrived = self._continued(near, angular)
        return found if arrived else None

    def _end(self, last: PeriodicMotion, angular: float) -> BranchEnd:
        """Return where a motion ends on the way to a frequency that it doesn't reach."""
        found = branch_end(self.driven, last, rising=angular > last.angular)
        low, high = sorted((last.angular, angular))
        if not low <= found.angular <= high:
            return BranchEnd(last.angular, Bifurcation.NOT_FOUND)
        return found

    def _settled(self, angular: float) -> Step:
        """Return what the blade comes to from where it is, by running it."""
        driven, start = self.driven, self.point
        engine = StoppedVibration(driven.blade, driven.stops, q=start.q, rate=start.rate)
        phase, free = start.phase, driven.is_free(angular)
        seen: list[Peaks] = []
        touched = 0
        outcome = MotionKind.APERIODIC
        while len(seen) < BURSTS or (free and len(seen) < MOST_BURSTS and _dies(seen)):
            touched = engine.contact_count
            phase = driven.shake(engine, angular, phase, BURST)
            seen.append(engine.take_peaks())
            touched = engine.contact_count - touched
            phase = self._away(engine, angular, phase)
            if engine.outcome is Outcome.CHATTER:
                outcome = MotionKind.CHATTER
                break
            if not self.goes_on():
                outcome = MotionKind.INTERRUPTED
                break
            point = MotionPoint(*engine.state, phase)
            if free and self.driven.dies_free(angular, point):
                return self._linear(angular)
            burst = len(seen)
            if not touched or burst > BURSTS:
                continue
            for order in ORDERS[: len(ORDERS) if burst > HIGHER_FROM else 1]:
                if (found := self._accepted(angular, point, order)) is not None:
                    return self._contact(found)
        if free and outcome is MotionKind.APERIODIC and _dies(seen):
            outcome = MotionKind.TRANSIENT
        self.motion = None
        self.point = MotionPoint(*engine.state, phase)
        last_third = seen[-max(len(seen) // 3, 1) :]
        return Step(
            angular,
            Peaks(*map(max, zip(*last_third, strict=True))),
            touched / BURST,
            outcome,
            least=min(peaks.travel for peaks in last_third),
        )

    def _away(self, engine: StoppedVibration, angular: float, phase: float) -> float:
        """Run on until the blade is away from its stops, two periods at most."""
        for _ in range(2 * PARTS):
            if self.driven.is_away(engine.state[0]):
                break
            phase = self.driven.shake(engine, angular, phase, 1.0 / PARTS)
        return phase


def _dies(seen: list[Peaks]) -> bool:
    """Return whether the peaks of the last bursts lie below those of as many before them."""
    third = max(len(seen) // 3, 1)
    ends = seen[-third:], seen[-2 * third : -third]
    late, early = (sum(peaks.travel for peaks in part) for part in ends)
    return late < DYING * early


def stepped_motion(blade: ModalBlade, stops: Stops, amplitude: float) -> SteppedMotion:
    """Return a blade at rest before its first frequency."""
    return SteppedMotion(DrivenBlade(blade, stops, amplitude), [], at_rest(blade))


def at_rest(blade: ModalBlade) -> MotionPoint:
    """Return the blade at rest."""
    return MotionPoint(np.zeros(blade.angular.size), np.zeros(blade.angular.size))
