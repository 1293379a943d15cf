"""The smallest blow at the tip that takes a blade from the motion without contact to its stops."""

from collections.abc import Callable
from math import pi
from typing import NamedTuple

import numpy as np

from flexcli.errors import Outcome
from flexcli.mechanics.stopping.periodic import DrivenBlade, MotionPoint, PeriodicMotion
from flexcli.mechanics.stopping.vibration import StoppedVibration

__all__ = ["Kick", "least_kick"]

PHASES = 8
"""Phases of the base at which a blow is tried; of a half period where both stops are alike."""
LADDER = 1.4
"""Ratio of the blows tried one after another, until one does it."""
LARGEST = 40.0
"""Over the blow that can first reach a stop, where the search is left."""
FINE = 0.02
"""Ratio to which the smallest is found."""
BURST = 5
"""Periods between two looks at what a blow came to."""
BURSTS = 60
CAUGHT = 0.1
"""Share of a motion's own size within which the blade has been caught by it."""


class Kick(NamedTuple):
    """A blow at the tip [N·s] at one frequency [rad/s]: below ``none`` no stop is even reached.

    ``enough`` is the smallest found to lead to contact for good, at that phase [rad] of the base;
    of smaller ones only those that were tried are known to fail. It is not sought where damping
    is too light for a run to show what a blow comes to.
    """

    angular: float
    none: float
    enough: float | None
    phase: float = 0.0


def least_kick(
    driven: DrivenBlade, contact: PeriodicMotion, goes_on: Callable[[], bool]
) -> Kick | None:
    """Return the smallest blow found from the motion without contact to one with it.

    Runs from the linear motion with a jump ``φ_r(L) J`` of each mode's rate: J is a blow at the
    tip. Nothing is found where the linear motion meets a stop itself, or when told to end.
    """
    angular, blade = contact.angular, driven.blade
    room = driven.gap - driven.linear(angular).at_stop
    if room <= 0.0:
        return None
    swing = blade.angular * np.sqrt(np.maximum(1.0 - blade.damping**2, 1e-12))
    none = room / float(np.abs(blade.stop * blade.tip / swing).sum())

    slowest = float((blade.damping * blade.angular).min())
    if np.exp(-slowest * BURSTS * BURST * 2.0 * pi / angular) > CAUGHT:
        return Kick(angular, none, None)

    def leads(blow: float, phase: float) -> bool:
        steady = driven.steady(angular, phase)
        struck = MotionPoint(steady.q, steady.rate + blow * blade.tip, phase)
        return _is_caught(driven, contact, struck, goes_on)

    alike = driven.stops.above == driven.stops.below
    signs = (1.0,) if alike else (1.0, -1.0)
    best, at = LARGEST * none, None
    for phase in 2.0 * pi * np.arange(PHASES) / PHASES:
        for sign in signs:
            if not goes_on():
                return None
            low, high = none, none
            if at is None:
                while high < best and not leads(sign * high, float(phase)):
                    low, high = high, LADDER * high
                if high >= best:
                    continue
            elif leads(sign * (1.0 - FINE) * best, float(phase)):
                high = (1.0 - FINE) * best
            else:
                continue
            while high > (1.0 + FINE) * low:
                middle = (low * high) ** 0.5
                low, high = (low, middle) if leads(sign * middle, float(phase)) else (middle, high)
            best, at = high, float(phase)
    return Kick(angular, none, best if at is not None else None, at or 0.0)


def _is_caught(
    driven: DrivenBlade,
    contact: PeriodicMotion,
    start: MotionPoint,
    goes_on: Callable[[], bool],
) -> bool:
    """Return whether a run from a state ends at a motion with contact."""
    angular, phase = contact.angular, contact.start.phase
    engine = StoppedVibration(driven.blade, driven.stops, q=start.q, rate=start.rate)
    # first to the phase of the base at which the motion's start is given
    begun, periods = start.phase, ((phase - start.phase) / (2.0 * pi)) % 1.0
    aim = driven.scaled(contact.start)
    for _ in range(BURSTS):
        driven.shake(engine, angular, begun, periods)
        if engine.outcome is Outcome.CHATTER or not goes_on():
            return False
        point = MotionPoint(*engine.state, phase)
        if driven.dies_free(angular, point):
            return False
        if np.abs(driven.scaled(point) - aim).max() < CAUGHT * np.abs(aim).max():
            return True
        begun, periods = phase, float(BURST)
    return False
