"""What a command found out: frozen records that reports print and scripts read."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum

from flexcli.errors import Finding

__all__ = [
    "Check",
    "Cost",
    "Design",
    "EffectRow",
    "Note",
    "Property",
    "Relaxation",
    "Result",
    "Sensitivity",
    "SizingResult",
    "Status",
    "Value",
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


@dataclass(frozen=True)
class Value:
    """One named number in SI, with the model that made it."""

    value: float
    unit: str
    label: str
    model: str = "closed-form"
    source: str = ""


@dataclass(frozen=True)
class Check:
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


@dataclass(frozen=True)
class EffectRow:
    """What a model leaves out: its dimensionless indicator and what that may change."""

    name: str
    on: bool
    indicator: float
    estimate: float
    reason: str


@dataclass(frozen=True)
class Note:
    """A warning: a stable code for scripts and a sentence for people."""

    code: str
    text: str


@dataclass(frozen=True)
class Property:
    """One number of a material with where it comes from."""

    name: str
    value: float
    unit: str
    detail: str
    status: str
    source: str


@dataclass(frozen=True)
class Cost:
    """What the answer cost, and how far off its model may be."""

    seconds: float
    model: str
    estimated_error: float | None
    iterations: int = 0


@dataclass(frozen=True)
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


@dataclass(frozen=True)
class Design:
    """One set of blade dimensions and what it is."""

    label: str
    h: float
    l: float
    b: float
    volume: float


@dataclass(frozen=True)
class Sensitivity:
    """What 1 % more of one demand costs: d ln(name) / d ln(demand) for each quantity."""

    constraint: str
    driver: str
    on: Mapping[str, float]


@dataclass(frozen=True)
class Relaxation:
    """How far one requirement of a conflict must give way for a design to exist."""

    name: str
    factor: float | None
    text: str


@dataclass(frozen=True)
class SizingResult:
    """How the dimensions were found, and what holds them there."""

    objective: str
    certificate: str
    designs: tuple[Design, ...] = ()
    active: tuple[str, ...] = ()
    sensitivities: tuple[Sensitivity, ...] = ()
    conflict: tuple[Relaxation, ...] = ()
    remarks: tuple[str, ...] = ()
