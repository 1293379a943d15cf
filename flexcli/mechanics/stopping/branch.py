"""A branch of periodic motions followed in frequency, round its folds, and where it ends."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from enum import Enum
from math import exp, log
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from flexcli.mechanics.stopping.periodic import DrivenBlade, PeriodicMotion

__all__ = ["Bifurcation", "BranchEnd", "branch_end", "branch_steps"]

Floats = NDArray[np.float64]

FIRST, LONGEST, SHORTEST = 0.02, 0.3, 1e-5
"""Arc lengths in (x, ln ω): of the first step, the longest by the size of x where that is above
1, and that at which it gives up."""
MOST_STEPS = 400
EASY = 7
"""Corrections within which a step was easy, and the next one is longer."""
CORRECTIONS = 12
CLOSED = 1e-9
"""Correction at which a point lies on the branch."""
UPRIGHT = 1e-5
"""Share of ln ω in a direction below which the branch is about to fold."""


class Bifurcation(Enum):
    """How a stable periodic motion ends, without contact (the first) or with it."""

    TOUCH = "it reaches the stop"
    FOLD = "it folds back, no such motion lies beyond"
    GRAZE = "it touches no longer"
    SYMMETRY_BREAKING = "it gives way to an unsymmetric one"
    PERIOD_DOUBLING = "it gives way to one of two periods"
    NEIMARK_SACKER = "it gives way to beats"
    NOT_FOUND = "it was not found beyond"


class BranchEnd(NamedTuple):
    """Where a stable motion ends [rad/s], and why."""

    angular: float
    kind: Bifurcation


class _Point(NamedTuple):
    """A motion, its derivative over (x, ln ω), and the direction in which its branch goes on."""

    motion: PeriodicMotion
    slope: Floats
    tangent: Floats


class BranchStep(NamedTuple):
    """From one motion of a branch to the next, over an arc of some length."""

    start: _Point
    end: _Point
    arc: float


def branch_steps(
    driven: DrivenBlade, motion: PeriodicMotion, *, rising: bool
) -> Iterator[BranchStep]:
    """Yield a branch from a motion on, stable or not, towards a higher or lower frequency.

    Pseudo-arclength: each motion is sought square to the direction of the one before, so that a
    fold, where two motions meet and none lies beyond, is passed like any other point. The last
    one is free of contact, or as far as it could be followed.
    """
    here = _branch_point(driven, motion)
    if here is None:
        return
    here = _facing(here, rising=rising)
    arc = FIRST
    for _ in range(MOST_STEPS):
        if abs(here.tangent[-1]) > UPRIGHT and not driven.is_away(here.motion.start.q):
            moved = _branch_point(driven, driven.begun_free(here.motion))
            if moved is not None:
                here = _facing(moved, rising=bool(here.tangent[-1] > 0.0))
        found, count = _stepped(driven, here, arc)
        while found is None:
            arc /= 2.0
            if arc < SHORTEST:
                return
            found, count = _stepped(driven, here, arc)
        yield BranchStep(here, found, arc)
        if not found.motion.contacts:
            return
        here = found
        if count <= EASY:
            size = float(np.abs(driven.scaled(found.motion.start)).max())
            arc = min(1.5 * arc, LONGEST * max(size, 1.0))


def branch_end(driven: DrivenBlade, motion: PeriodicMotion, *, rising: bool) -> BranchEnd:
    """Return where the stable motions from a given one on end.

    A fold is found where ω turns back, another loss of stability where the largest multiplier
    reaches 1.
    """
    last = motion.angular
    for step in branch_steps(driven, motion, rising=rising):
        ends = step.start, step.end
        if ends[0].tangent[-1] * ends[1].tangent[-1] < 0.0:
            angular = _frequency_of_zero(driven, step, lambda point: float(point.tangent[-1]))
            return BranchEnd(angular, Bifurcation.FOLD)
        if not step.end.motion.is_stable:
            angular = _frequency_of_zero(driven, step, lambda point: point.motion.largest - 1.0)
            return BranchEnd(angular, _kind(step.end.motion))
        if not step.end.motion.contacts:
            ways = step.start.motion.angular, step.end.motion.angular
            return BranchEnd(driven.grazing(*ways) or ways[0], Bifurcation.GRAZE)
        last = step.end.motion.angular
    return BranchEnd(last, Bifurcation.NOT_FOUND)


def _kind(motion: PeriodicMotion) -> Bifurcation:
    """Return how a motion lost its stability, by its largest multiplier."""
    worst = motion.multipliers[int(np.argmax(np.abs(motion.multipliers)))]
    if abs(worst.imag) > 1e-6 * abs(worst):
        return Bifurcation.NEIMARK_SACKER
    return Bifurcation.SYMMETRY_BREAKING if worst.real > 0.0 else Bifurcation.PERIOD_DOUBLING


def _frequency_of_zero(
    driven: DrivenBlade, step: BranchStep, function: Callable[[_Point], float]
) -> float:
    """Return the frequency within a step at which a function of its points is zero."""
    found = {0.0: step.start, step.arc: step.end}

    def value(arc: float) -> float:
        if arc not in found:
            point, _ = _stepped(driven, step.start, arc)
            found[arc] = point if point is not None else step.end
        return function(found[arc])

    if value(0.0) * value(step.arc) > 0.0:
        return step.end.motion.angular
    arc = brentq(value, 0.0, step.arc, xtol=1e-7 * step.arc, rtol=1e-12, maxiter=40)
    value(float(arc))
    return found[float(arc)].motion.angular


def _facing(point: _Point, *, rising: bool) -> _Point:
    """Return a point whose direction leads to higher, or to lower, frequencies."""
    sign = 1.0 if bool(point.tangent[-1] > 0.0) is rising else -1.0
    return point._replace(tangent=sign * point.tangent)


def _branch_point(
    driven: DrivenBlade, motion: PeriodicMotion, along: Floats | None = None
) -> _Point | None:
    """Return a motion as a point of its branch; its direction is less than 90° off another one."""
    start, periods = motion.start, motion.periods
    slope = driven.slope(motion.angular, start, periods)
    if slope is None:
        return None
    n = slope.shape[0]
    tangent = np.linalg.svd(slope - np.eye(n, n + 1))[2][-1]
    if along is not None and tangent @ along < 0.0:
        tangent = -tangent
    multipliers = np.linalg.eigvals(slope[:, :n]).astype(np.complex128)
    return _Point(replace(motion, multipliers=multipliers), slope, tangent)


def _stepped(driven: DrivenBlade, here: _Point, arc: float) -> tuple[_Point | None, int]:
    """Return the point of the branch an arc away, and after how many corrections."""
    motion, n = here.motion, here.slope.shape[0]
    phase, periods = motion.start.phase, motion.periods
    u = np.append(driven.scaled(motion.start), log(motion.angular)) + arc * here.tangent
    matrix = np.vstack([here.slope - np.eye(n, n + 1), here.tangent])
    before = np.inf
    for count in range(1, CORRECTIONS + 1):
        mapped = driven.mapped(exp(u[-1]), u[:n], phase, periods)
        if mapped is None:
            return None, count
        missed = mapped - u[:n]
        change = np.linalg.solve(matrix, -np.append(missed, 0.0))
        size = float(np.abs(change).max())
        if size > 2.0 * arc or (count > 2 and size > 0.9 * before):
            return None, count
        u, before = u + change, size
        if size <= CLOSED:
            break
    else:
        return None, CORRECTIONS
    angular = float(exp(u[-1]))
    found = replace(
        motion,
        angular=angular,
        start=driven.point(u[:n], phase),
        contacts=driven.run(angular, driven.point(u[:n], phase), periods).contact_count,
        residual=size,
    )
    return _branch_point(driven, found, here.tangent), count
