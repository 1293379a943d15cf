"""What a blade between stops did: travel, contacts, balances, and how the run ended."""

from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import Outcome

__all__ = [
    "Balance",
    "Contacts",
    "History",
    "MotionKind",
    "Peaks",
    "Progress",
    "RunCost",
    "StopResult",
]

Floats = NDArray[np.float64]


class MotionKind(Enum):
    """What the motion at one frequency came to."""

    PERIODIC = "repeats every period of the base"
    SUBHARMONIC = "repeats after several periods of the base"
    APERIODIC = "no periodic motion of one to three periods of the base was found"
    TRANSIENT = "still dying away to the motion without contact when its run ended"
    CHATTER = "contacts follow each other without the motion going on"
    INTERRUPTED = "ended before it settled"


class Progress(NamedTuple):
    """How far a run is: time [s] and contacts so far."""

    time: float
    contacts: int


class Peaks(NamedTuple):
    """Greatest values so far.

    Tip [m] on either side, blade at the stop [m], moment at the clamp [N·m], push of the stops
    [N]; a rigid stop's impulses [N·s] have no peak force.
    """

    tip_above: float
    tip_below: float
    at_stop: float
    base_moment: float
    force: float
    impulse: float

    @property
    def travel(self) -> float:
        """The greatest deflection of the tip to either side [m]."""
        return max(self.tip_above, self.tip_below)


@dataclass(frozen=True, eq=False)
class Contacts:
    """Each contact: when it began [s], side (±1), approach speed [m/s], impulse [N·s], length [s].

    The blade held after chatter counts as one contact, whose ``time`` is that at which the
    bounces would have come to their accumulation point; its ``duration`` is not zero.
    """

    time: Floats
    side: NDArray[np.int64]
    speed: Floats
    impulse: Floats
    duration: Floats


class Balance(NamedTuple):
    """Where energy [J] and momentum went.

    ``kinetic``, ``strain`` (blade) and ``stop`` (springs) at the end; ``start`` all of them at
    the start; ``base_work`` done by the base on the motion relative to it; ``damped`` in the
    blade, ``lost_at_stops`` in dashpots, impacts and heads. ``energy_residual`` is what is
    unaccounted for, ``impulse_residual`` the same of momentum as a share of the greatest term.
    """

    start: float
    kinetic: float
    strain: float
    stop: float
    base_work: float
    damped: float
    lost_at_stops: float
    energy_residual: float
    impulse_residual: float

    @property
    def energy_error(self) -> float:
        """The energy that is unaccounted for, as a share of all that was there or came [-]."""
        moved = self.start + abs(self.base_work) + self.damped + self.lost_at_stops
        return abs(self.energy_residual) / (moved or 1.0)


class History(NamedTuple):
    """Samples in time: tip [m], deflection at the stop [m], push of the stops [N]."""

    time: Floats
    tip: Floats
    at_stop: Floats
    force: Floats


class RunCost(NamedTuple):
    """What a run cost: events, evaluations in their search, linear segments, wall time [s]."""

    events: int
    evaluations: int
    segments: int
    seconds: float


@dataclass(frozen=True, eq=False)
class StopResult:
    """The answer of one run; ``q`` and ``rate`` are the modal state at its end."""

    outcome: Outcome
    duration: float
    q: Floats
    rate: Floats
    peaks: Peaks
    contacts: Contacts
    contact_time: float
    balance: Balance
    cost: RunCost
    history: History | None = None
