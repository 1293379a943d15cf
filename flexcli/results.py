"""What a command found out: frozen records that reports print and scripts read.

Rows are named tuples: making a dataclass costs several times as much at every start.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import NamedTuple

from flexcli.errors import Finding

__all__ = [
    "BalanceResult",
    "CaseResponse",
    "Check",
    "Cost",
    "CouplingTerm",
    "Design",
    "EffectRow",
    "GravityRow",
    "ModeResult",
    "Note",
    "OutputResult",
    "ProfileRow",
    "Property",
    "Relaxation",
    "Result",
    "Sensitivity",
    "SizingResult",
    "Status",
    "StrokeRow",
    "TransferRow",
    "UnknownResult",
    "Value",
    "WorstCaseRow",
]


class Status(Enum):
    """How a command ended; the exit code follows from it."""

    PASS = "pass"
    FAIL = "fail"
    INFEASIBLE = "infeasible"
    ERROR = "error"

    @property
    def exit_code(self) -> int:
        """Return 0 when the design passed, 1 when it fails or cannot be, 2 for bad input."""
        return {Status.PASS: 0, Status.FAIL: 1, Status.INFEASIBLE: 1, Status.ERROR: 2}[self]


class Value(NamedTuple):
    """One named number in SI, with the model that made it."""

    value: float
    unit: str
    label: str
    model: str = "closed-form"
    source: str = ""


class Check(NamedTuple):
    """One requirement of one case: demand against capacity.

    ``factor`` is the factor of safety capacity/demand (for a bound, how far inside it the
    design is), ``margin`` is factor/required − 1.
    """

    name: str
    case: str
    quantity: str
    demand: float
    capacity: float
    unit: str
    factor: float
    required: float
    passed: bool
    source: str

    @property
    def margin(self) -> float:
        """Return the margin of safety: 0 when the requirement is just met."""
        return self.factor / self.required - 1.0


class EffectRow(NamedTuple):
    """What a model leaves out: its dimensionless indicator and what that may change."""

    name: str
    on: bool
    indicator: float
    estimate: float
    reason: str


class Note(NamedTuple):
    """A warning: a stable code for scripts and a sentence for people."""

    code: str
    text: str


class Property(NamedTuple):
    """One number of a material with where it comes from."""

    name: str
    value: float
    unit: str
    detail: str
    status: str
    source: str


@dataclass(frozen=True, eq=False)
class Cost:
    """What the answer cost, and how far off its model may be."""

    seconds: float
    model: str
    estimated_error: float | None
    iterations: int = 0


@dataclass(frozen=True, eq=False)
class Result:
    """The answer of one command about one spec."""

    command: str
    spec: str
    status: Status
    title: str = ""
    values: Mapping[str, Value] = field(default_factory=dict)
    checks: tuple[Check, ...] = ()
    effects: tuple[EffectRow, ...] = ()
    warnings: tuple[Note, ...] = ()
    findings: tuple[Finding, ...] = ()
    cost: Cost | None = None
    sizing: "SizingResult | None" = None
    responses: "tuple[CaseResponse, ...]" = ()
    profiles: "tuple[ProfileRow, ...]" = ()
    breakpoints: "tuple[BreakpointRow, ...]" = ()
    worst_cases: "tuple[WorstCaseRow, ...]" = ()
    balance: "BalanceResult | None" = None


class ModeResult(NamedTuple):
    """One natural mode: frequency [Hz], share of the mass that it moves, rms of its responses.

    ``dynamic`` is false for a mode that the band can't excite or the base does not move.
    """

    frequency: float
    mass_share: float
    dynamic: bool
    rms: Mapping[str, float]


class OutputResult(NamedTuple):
    """One response: rms and its zero crossings (random only), peak, peak expected in the time."""

    name: str
    unit: str
    rms: float | None
    peak: float
    expected_peak: float | None
    crossing_rate: float | None


class CaseResponse(NamedTuple):
    """What the modes make of the vibration or the shock of one case; lives [s] by method."""

    case: str
    kind: str
    modes: tuple[ModeResult, ...]
    outputs: tuple[OutputResult, ...]
    lives: Mapping[str, Mapping[str, float]]
    duration: float | None


class Design(NamedTuple):
    """One set of sizes [m] by their symbols, and what it is."""

    label: str
    sizes: Mapping[str, float]
    volume: float


class Sensitivity(NamedTuple):
    """What 1 % more of one demand costs: d ln(name) / d ln(demand) for each quantity."""

    constraint: str
    driver: str
    on: Mapping[str, float]


class Relaxation(NamedTuple):
    """How far one requirement of a conflict must give way for a design to exist."""

    name: str
    factor: float | None
    text: str


@dataclass(frozen=True, eq=False)
class SizingResult:
    """How the dimensions were found, and what holds them there."""

    objective: str
    certificate: str
    designs: tuple[Design, ...] = ()
    active: tuple[str, ...] = ()
    sensitivities: tuple[Sensitivity, ...] = ()
    conflict: tuple[Relaxation, ...] = ()
    remarks: tuple[str, ...] = ()


class UnknownResult(NamedTuple):
    """What was free of a mechanism, and what was chosen within its bounds."""

    name: str
    value: float
    unit: str
    least: float | None
    most: float | None


class TransferRow(NamedTuple):
    """Displacement over acceleration of the base [s²] at a frequency, before and after balancing.

    Damped ones are complex: magnitude and phase. None where there is nothing to balance, no
    damping is stated, or the value is infinite (an undamped resonance).
    """

    frequency: float
    init: float | None
    final: float | None
    init_damped: complex | None = None
    final_damped: complex | None = None


class StrokeRow(NamedTuple):
    """A term of the equation of motion at rest and over the stroke.

    ``orders`` are the contributions of the first, second and third power of the coordinate at the
    end of the stroke; ``at_stroke`` is the exact value at the end that differs most from rest.
    """

    name: str
    unit: str
    at_rest: float
    orders: tuple[float, ...]
    at_stroke: float


class CouplingTerm(NamedTuple):
    """How the coupling depends on one number of the mechanism, and what its tolerance does."""

    name: str
    value: float
    unit: str
    slope: float
    tolerance: float
    effect: float


class GravityRow(NamedTuple):
    """What gravity along one axis does: torque (or force) on the freedom, sag, stiffness."""

    axis: str
    mounted: str
    unit: str
    at_rest: float
    at_stroke: float | None
    sag: float | None
    stiffness: float


class BalanceResult(NamedTuple):
    """The answer of ``flexure balance`` beside its values."""

    outcome: str
    motion: str
    output_unit: str
    reason: str = ""
    remedy: str = ""
    stroke: float | None = None
    quality: float | None = None
    unknowns: tuple[UnknownResult, ...] = ()
    transfer: tuple[TransferRow, ...] = ()
    over_stroke: tuple[StrokeRow, ...] = ()
    sensitivities: tuple[CouplingTerm, ...] = ()
    gravity: tuple[GravityRow, ...] = ()
    remarks: tuple[str, ...] = ()


class ProfileRow(NamedTuple):
    """A profile of acceleration density: its rms [m/s²], as computed and as published, sources."""

    name: str
    title: str
    g_rms: float
    published_grms: float | None
    status: str
    standard: str
    revision: str
    location: str
    note: str
    interpolation: str
    axis: str
    duration: float | None
    tolerance_above: float | None
    tolerance_below: float | None


class BreakpointRow(NamedTuple):
    """A corner of a profile [Hz, (m/s²)²/Hz] and the slope to the next one [dB/octave].

    The slope of a step is infinite; on linear axes, and at the last point, there is none.
    """

    frequency: float
    level: float
    slope: float | None


class WorstCaseRow(NamedTuple):
    """Miles over all frequencies beside the exact response, for one case and one Q; SI units.

    ``g_rms_worst`` is Miles' maximum, at ``f_worst``; ``g_rms_exact`` and ``g_rms_pseudo`` are the
    exact absolute acceleration and pseudo-acceleration there. ``g_rms_max`` is the greatest exact
    absolute acceleration in the band, at ``f_max``. ``miles_excess_there`` and ``miles_excess``
    tell how far Miles' maximum lies above these (a share of them), ``shortfall`` how far Miles
    lies below the exact response where it does most, at ``f_shortfall``. ``c_*`` are peaks over
    rms, ``a_*`` those times ``g_rms_worst``; they lack where the duration does.
    """

    case: str
    profile: str
    applied: str
    q: float
    f_worst: float
    g_rms_worst: float
    g_rms_exact: float
    g_rms_pseudo: float
    f_max: float
    g_rms_max: float
    miles_excess_there: float
    miles_excess: float
    shortfall: float
    f_shortfall: float | None
    duration: float | None
    c_sigma: float
    a_sigma: float
    c_peak: float | None
    a_peak: float | None
    c_davenport: float | None
    a_davenport: float | None
