"""Results of sizing an end stop, and of its simulation."""

from typing import NamedTuple

__all__ = [
    "StopHistory",
    "StopHold",
    "StopPlace",
    "StopSimulation",
    "StopSweep",
    "StopsResult",
    "SweepStep",
]


class StopPlace(NamedTuple):
    """A height and gap with the statics of the blade whose tip is at the end of its travel, SI.

    ``F`` holds the tip there; ``F_contact`` brings the blade to the stop, ``F_excess`` is the
    rest, ``R_stop`` pushes on the stop. ``sigma_onset`` is the stress at the base when it touches.
    """

    name: str
    L_a: float
    delta_G: float  # noqa: N815 - the source's symbol
    k_contact: float
    pi_1: float
    pi_5: float
    pi_5_threshold: float
    tip_at_contact: float
    F: float
    F_contact: float
    F_excess: float
    R_stop: float
    sigma_onset: float
    sigma_base: float
    sigma_contact: float
    p_hertz: float | None
    tau_hertz: float | None

    @property
    def bending(self) -> float:
        """Return the greatest bending stress on the way [Pa]."""
        return max(self.sigma_onset, abs(self.sigma_base), self.sigma_contact)


class StopHold(NamedTuple):
    """Ranges of heights [m] in which a limit holds on the operating line."""

    name: str
    ranges: tuple[tuple[float, float], ...]


class StopSimulation(NamedTuple):
    """Response of the blade between its stops in one case, SI.

    ``confidence`` is that one more exposure shows no higher peak (random only); ``pi_5`` the range
    of the tip over the gap (of a sine once steady, as it was measured); the residuals are the
    errors of the energy balance (as a share of the energy in motion) and of the momentum balance.
    ``model`` is that of the contact; ``has_decided`` says that the run was ended where its result
    was sufficient.
    """

    case: str
    kind: str
    law: str
    q: float
    modes: int
    seed: int | None
    planned: float
    duration: float
    outcome: str
    confidence: float | None
    travel: float
    pi_5: float
    force: float
    impulse: float
    contacts: int
    contact_share: float
    fastest: float
    sigma_base: float
    sigma_contact: float
    p_hertz: float | None
    tau_hertz: float | None
    energy_residual: float
    impulse_residual: float
    events: int
    seconds: float
    model: str = ""
    has_decided: bool = False

    @property
    def is_complete(self) -> bool:
        """Return whether all that was planned was run."""
        return self.duration >= self.planned * (1.0 - 1e-9)


class SweepStep(NamedTuple):
    """A step of a frequency response [Hz, m, N, 1 per period]; ``up`` is the way it came.

    A settled motion repeats after ``periods`` of the base, and a disturbance of it shrinks by
    ``multiplier`` in that time; one that did not settle has ``least``, the smallest of the tip's
    peaks that were seen while ``travel`` was the largest. ``outcome`` says what it came to.
    """

    up: bool
    frequency: float
    travel: float
    force: float
    contacts: float
    settled: bool
    periods: int = 1
    multiplier: float | None = None
    least: float | None = None
    outcome: str = ""


class StopEnd(NamedTuple):
    """A frequency [Hz] at which a steady motion ends on the way up or down, and why."""

    frequency: float
    up: bool
    why: str


class StopKick(NamedTuple):
    """The blow at the tip that brings a blade from the motion without contact to one with it.

    At a frequency [Hz] where both are possible: a blow of ``none`` [N·s] can't reach a stop,
    ``enough`` is the smallest that was found to lead there, at the worst phase tried. Beside them
    the jumps of the tip's speed [m/s] that they make.
    """

    frequency: float
    none: float
    enough: float | None
    speed_none: float
    speed_enough: float | None


class StopRatio(NamedTuple):
    """A stop on the operating line, height and gap [m], with the tip's range over the gap.

    ``line`` as the source measured it, ``threshold`` that below which a tip-loaded blade does not
    touch, ``simulated`` once steady at the free blade's frequency; none where it does not touch.
    """

    L_a: float
    delta_G: float  # noqa: N815 - the source's symbol
    pi_1: float
    line: float
    threshold: float
    simulated: float | None


class StopSweep(NamedTuple):
    """The frequency response with stops, up and down.

    ``contact_up`` and ``contact_down`` are the lowest and highest frequency of contact each way;
    between the ends of ``metastable`` the blade touches or not, depending on where it came from.
    ``law`` says how the stop pushes back, ``is_complete`` that nobody ended it before its end;
    ``ends`` are where steady motions end, ``kicks`` what takes the blade from one to the other,
    ``ratios`` the tip's range over the gap for other stops on the operating line.
    """

    case: str
    how: str
    steps: tuple[SweepStep, ...]
    contact_up: tuple[float, float] | None
    contact_down: tuple[float, float] | None
    metastable: tuple[float, float] | None
    law: str = ""
    seconds: float = 0.0
    is_complete: bool = True
    ends: tuple[StopEnd, ...] = ()
    kicks: tuple[StopKick, ...] = ()
    ratios: tuple[StopRatio, ...] = ()


class StopHistory(NamedTuple):
    """Samples of one case: time [s], tip and deflection at the stop [m], push of the stops [N]."""

    case: str
    time: tuple[float, ...]
    tip: tuple[float, ...]
    at_stop: tuple[float, ...]
    force: tuple[float, ...]


class StopsResult(NamedTuple):
    """The answer of ``flexure stops`` beside its values."""

    outcome: str
    chosen: StopPlace
    places: tuple[StopPlace, ...]
    reason: str = ""
    remedy: str = ""
    holds: tuple[StopHold, ...] = ()
    simulations: tuple[StopSimulation, ...] = ()
    sweeps: tuple[StopSweep, ...] = ()
    histories: tuple[StopHistory, ...] = ()
