"""The parts of a verdict: values, checks, effects left out, notes."""

from collections.abc import Mapping
from enum import StrEnum
from types import MappingProxyType
from typing import NamedTuple

__all__ = [
    "EXACT",
    "Check",
    "EffectRow",
    "ErrorRange",
    "Note",
    "Place",
    "Property",
    "QuantityKind",
    "Value",
    "Verdict",
    "error_of_ratio",
]


class QuantityKind(StrEnum):
    """Kinds of numbers of a design, by which the errors of models and effects differ."""

    STIFFNESS = "stiffness"
    STRESS = "stress"
    SHIFT = "shift"
    BUCKLING = "buckling"
    SAG = "sag"
    FREQUENCY = "frequency"
    SUPPORT = "support"
    RESPONSE = "response"


class ErrorRange(NamedTuple):
    """The relative errors between which a number lies: true = number · (1 + error)."""

    low: float
    high: float

    @property
    def largest(self) -> float:
        """Return the largest magnitude."""
        return max(abs(self.low), abs(self.high))

    def __add__(self, other: object) -> "ErrorRange":
        """Return the range of two errors that add up."""
        if not isinstance(other, ErrorRange):
            return NotImplemented
        return ErrorRange(self.low + other.low, self.high + other.high)


EXACT = ErrorRange(0.0, 0.0)
"""Error of a number that the spec itself defines, such as a mass or a ratio of sizes."""


def error_of_ratio(one: ErrorRange | None, other: ErrorRange | None) -> ErrorRange | None:
    """Return the range of the error of a ratio; None where one is unknown."""
    if one is None or other is None or other.low <= -1.0:
        return None
    ends = [(1.0 + a) / (1.0 + b) - 1.0 for a in one for b in other]
    return ErrorRange(min(ends), max(ends))


class Verdict(StrEnum):
    """Verdict of a check, the worst first; a pass needs the whole range of its factor."""

    FAIL = "fail"
    UNDECIDED = "undecided"
    NOT_JUDGED = "not judged"
    PASS = "pass"

    @property
    def rank(self) -> int:
        """Return its rank from the worst, 0, on."""
        return list(Verdict).index(self)


class Value(NamedTuple):
    """One named number in SI, with the model that made it and its estimated relative error.

    Nothing stands for an error that nobody can estimate, zero for what is given or defined.
    ``kind`` says that the error is that of the model's numbers of this kind; without one the
    value tells its own.
    """

    value: float
    unit: str
    label: str
    model: str = "closed-form"
    source: str = ""
    estimated_error: float | None = None
    kind: QuantityKind | None = None


class Place(NamedTuple):
    """Where a spec says something: file, line and column from 1 on, and the path in the spec."""

    file: str
    line: int
    column: int
    path: str


class Check(NamedTuple):
    """One requirement of one case: demand against capacity.

    ``factor`` is the factor of safety capacity/demand (for a bound, how far inside it the
    design is), ``margin`` is factor/required − 1. ``factor_range`` is where the factor lies by
    the estimated error of ``model``, nothing where that error is unknown; ``seconds`` is what it
    took to decide, models asked in vain included. ``is_target`` says that the number has to equal
    what is asked, within a tolerance; ``kind`` is what kind of number it is. ``path`` is that of
    what asks for it in the spec, ``place`` where that stands, once somebody has looked it up.
    """

    name: str
    case: str
    quantity: str
    demand: float
    capacity: float
    unit: str
    factor: float
    required: float
    verdict: Verdict
    source: str
    factor_range: tuple[float, float] | None = None
    model: str = ""
    seconds: float = 0.0
    is_target: bool = False
    kind: QuantityKind | None = None
    path: tuple[str | int, ...] = ()
    place: Place | None = None

    @property
    def full_name(self) -> str:
        """Return the name with its case."""
        return f"{self.name}, {self.case}" if self.case else self.name

    @property
    def depends_on_mass(self) -> bool:
        """Return whether the mass of the blades and bodies changes the number."""
        return self.kind in (QuantityKind.FREQUENCY, QuantityKind.SAG, QuantityKind.RESPONSE)

    @property
    def passed(self) -> bool:
        """Return whether the requirement holds for sure."""
        return self.verdict is Verdict.PASS

    @property
    def margin(self) -> float:
        """Return the margin of safety: 0 when the requirement is just met."""
        return self.factor / self.required - 1.0


class EffectRow(NamedTuple):
    """An effect in the model or left out: its dimensionless indicator and what that may change.

    ``estimates`` are relative changes by what is reported, ``estimate`` the largest of them;
    ``asked`` is what the spec says of it, ``models`` which could carry it.
    """

    name: str
    on: bool
    indicator: float
    estimate: float
    reason: str
    estimates: Mapping[str, float] = MappingProxyType({})
    asked: str = "auto"
    models: tuple[str, ...] = ()


class Note(NamedTuple):
    """A warning: a stable code for scripts and a sentence for people."""

    code: str
    text: str


class Property(NamedTuple):
    """One number of a material with its source."""

    name: str
    value: float
    unit: str
    detail: str
    status: str
    source: str
