"""A requirement: a row of the report, a constraint of the sizing, a part of the exit code."""

from abc import abstractmethod
from collections.abc import Iterator
from enum import Enum
from typing import Any, ClassVar, Literal, NamedTuple

from pydantic import model_validator

from flexcli.formulas.quantity import Computed, Quantity
from flexcli.parts.base import Part, Ratio, Shorthand, spec_error
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import Check, ErrorRange, QuantityKind

__all__ = [
    "HELD_ACROSS",
    "Bound",
    "BoundAtStroke",
    "ErrorOf",
    "FactorRequirement",
    "Limit",
    "Requirement",
    "limit_of",
]


HELD_ACROSS = "held across"
"""Variant of a stress at clamps that keep blades from growing across."""


class ErrorOf(Enum):
    """Whose error a number has that brings none of its own."""

    MODEL = "model"


class Limit(NamedTuple):
    """``required · demand ≤ capacity``, or ``demand = capacity`` within a tolerance.

    ``quantity`` names what is compared; several limits of one requirement, case and variant (both
    ends of a blade, both signs) make one check, decided by the worst. ``power`` says that demand
    and capacity are given raised to it, so that roots stay out of the algebra. ``load`` marks the
    limits that a balanced design makes active together, in each ``joint`` that has sizes of its
    own; ``driver`` names what the demand grows with. ``kind`` is the kind of number that models
    compute, and ``in_capacity`` says that it is the capacity; ``error`` is the error of that
    number, None where it is unknown, its model's where it brings none, and ``is_directed`` says
    that it includes the direction of blades in a crystal or a sheet. ``strengths`` are those of the
    material that it is compared with. ``path`` is where the spec asks for it, where no requirement
    does.
    """

    requirement: str
    case: str
    quantity: str
    demand: Computed
    capacity: Computed
    unit: str
    source: str
    required: float = 1.0
    variant: str = ""
    power: int = 1
    load: bool = False
    joint: str = ""
    driver: str = ""
    tolerance: float | None = None
    kind: QuantityKind | None = None
    in_capacity: bool = False
    error: ErrorRange | ErrorOf | None = ErrorOf.MODEL
    is_directed: bool = False
    strengths: tuple[str, ...] = ()
    path: tuple[str | int, ...] = ()

    @property
    def known(self) -> ErrorRange | None:
        """Return its error as far as it is known without asking its model."""
        return self.error if isinstance(self.error, ErrorRange) else None

    @property
    def is_bound(self) -> bool:
        """Return whether the spec states the bound itself, not a factor."""
        return self.variant in ("min", "max", "equals")

    @property
    def name(self) -> str:
        """Return the name of the check that this limit belongs to."""
        return f"{self.title}, {self.case}" if self.case else self.title

    @property
    def title(self) -> str:
        """Return the name of the check without its case."""
        name = f"{self.requirement} of {self.joint}" if self.joint else self.requirement
        return f"{name} ({self.variant})" if self.variant else name

    def scaled(self, factor: Quantity) -> "Limit":
        """Return it with a multiplied utilisation, by the number that the spec does not state."""
        if self.in_capacity:
            return self._replace(capacity=self.capacity * factor ** (-self.power))
        return self._replace(demand=self.demand * factor**self.power)

    def narrowed(self, spread: float) -> "Limit":
        """Return it with a target's tolerance narrowed by an error, where it is wide enough."""
        if self.tolerance is None or not 0.0 < spread < self.tolerance:
            return self
        return self._replace(tolerance=(1.0 + self.tolerance) / (1.0 + spread) - 1.0)


def limit_of(check: Check, share: Quantity) -> Limit:
    """Return the limit of a check from its utilisation, known by value and slope."""
    name, _, variant = check.name.removesuffix(")").rpartition(" (")
    source = "by value and slope"
    if variant == "min":
        sides = check.demand, share ** (-1.0) * check.demand
    elif variant in ("max", "equals"):
        sides = share * check.capacity, check.capacity
    else:
        name, variant, sides = check.name, "", (share * (1.0 / check.required), 1.0)
    return Limit(
        name, check.case, check.quantity, *sides, check.unit, source,
        required=1.0 if variant else check.required, variant=variant,
        tolerance=1.0 / check.required - 1.0 if check.is_target else None,
    )  # fmt: skip


class Requirement(Part):
    """A demand on the design; the subclass turns it into limits."""

    per_case: ClassVar[bool] = True
    closed_form: ClassVar[bool] = True
    """Whether it can be written on signomials; else it judges a design but cannot size one."""
    is_warmed: ClassVar[bool] = False
    """Whether it is asked at the temperatures of cases too, where it is not of a case."""
    adds_up: ClassVar[bool] = False
    """Whether its cases add up, as damage does."""
    is_of_buckling: ClassVar[bool] = False
    """Whether it asks for a factor on the loads of a case up to which they buckle nothing."""
    is_of_stress: ClassVar[bool] = False
    """Whether it compares the largest stress with a strength, whatever causes the stress."""
    by_shells: ClassVar[QuantityKind | None] = None
    """Its numbers of which shells tell more than beams in a joint of the plane too, if any."""
    by_solids: ClassVar[bool] = False
    """Whether solids of a joint's necks tell more of it than beams."""
    falls_with_mass: ClassVar[bool] = False
    """Whether its number has an end without the mass that nobody knows, which only lowers it."""
    of_the_drawing: ClassVar[bool] = False
    """Whether it concerns the shape alone, which needs no model."""
    label: ClassVar[str]

    @property
    def is_of_a_case(self) -> bool:
        """Return whether it applies to each case separately, or once to the joint."""
        return self.per_case

    def case_of(self, scene: Scene) -> str:
        """Return the case in the names of its checks: none for the joint at assembly."""
        return scene.case if self.is_of_a_case or scene.temperature is not None else ""

    def applies(self, scene: Scene) -> bool:
        """Return whether the requirement applies to this case."""
        return True

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the kinds of loads of a case that its limits take into account."""
        return frozenset()

    def weighs(self, scene: Scene) -> bool:
        """Return whether the mass of all that moves is in its number."""
        return self.is_of_stress and scene.is_accelerated

    def may_be_decided(self, ask: Ask) -> bool:
        """Return whether a model may decide it that others left open, as far as is known before."""
        return True

    @abstractmethod
    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the limits for one case (or for the design, where it is not per case)."""

    def formula(self, scene: Scene) -> str:
        """Return the name of a formula that is cheaper than any model, empty without one."""
        return ""

    def by_formula(self, ask: Ask) -> Iterator[Limit]:
        """Yield the limits by that formula, for the joint by the cheapest model."""
        raise NotImplementedError

    def judged(self, ask: Ask) -> Iterator[Limit]:
        """Yield the limits, or raise :class:`RequirementError` where the joint has no such number.

        A number that the geometry cannot give is a mistake of the spec, which asks for it.
        """
        try:
            yield from self.limits(ask)
        except NotAvailable as error:
            raise RequirementError(f"a {ask.geometry.name} {error}") from error


class FactorRequirement(Requirement, Shorthand):
    """A required factor of safety; a plain number stands for {factor: number}."""

    stands_for: ClassVar[str] = "factor"

    factor: Ratio
    """How many times the demand the design must bear, e.g. ``1.5``."""
    cases: tuple[str, ...] | None = None
    """Cases that it is asked of; all that it is about, if left out,
    e.g. ``cases: [operation], factor: 1.5``.
    """

    def covers(self, scene: Scene) -> bool:
        """Return whether the requirement is asked of this case."""
        return self.cases is None or scene.case in self.cases


class Bound(Requirement):
    """A quantity between bounds, or equal to a target within a tolerance."""

    per_case: ClassVar[bool] = False

    min: Any = None
    """The least that it may be."""
    max: Any = None
    """The most that it may be."""
    equals: Any = None
    """What it shall be, within the tolerance."""
    tolerance: Ratio = 0.01
    """How far from the target it may be, as a share, e.g. ``2 %``."""

    @model_validator(mode="before")
    @classmethod
    def _must_be_mapping(cls, data: Any) -> Any:
        if not isinstance(data, dict):
            raise spec_error(
                f"say on which side {data} is the bound", "write {max: …}, {min: …} or {equals: …}"
            )
        return data

    @model_validator(mode="after")
    def _some_bound(self) -> "Bound":
        if self.equals is not None and (self.min is not None or self.max is not None):
            raise spec_error("'equals' leaves no room for min or max", "keep one of them")
        if self.equals is None and self.min is None and self.max is None:
            raise spec_error("no bound is given", "give min, max or equals")
        if self.min is not None and self.max is not None and self.min >= self.max:
            raise spec_error("min is not below max", "check both values", at=("min",))
        return self

    def bounds(
        self,
        value: Quantity,
        *,
        case: str,
        quantity: str,
        unit: str,
        source: str,
        power: int = 1,
        kind: QuantityKind | None = None,
        error: ErrorRange | ErrorOf | None = ErrorOf.MODEL,
    ) -> Iterator[Limit]:
        """Yield a limit for each bound on a value given raised to ``power``."""

        def limit(demand: Quantity, capacity: Quantity, variant: str) -> Limit:
            return Limit(
                self.label, case, quantity, demand, capacity, unit, source,
                variant=variant, power=power,
                tolerance=self.tolerance if variant == "equals" else None,
                kind=kind, in_capacity=variant == "min", error=error,
            )  # fmt: skip

        if self.max is not None:
            yield limit(value, self.max**power, "max")
        if self.min is not None:
            yield limit(self.min**power, value, "min")
        if self.equals is not None:
            yield limit(value, self.equals**power, "equals")


class BoundAtStroke(Bound):
    """Bounds on a number at rest, or at both ends of each case's stroke."""

    at: Literal["rest", "full-stroke"] = "rest"
    """Where it is asked: at rest, or at both ends of each stroke, without the other loads of the
    case, e.g. ``full-stroke``.
    """

    @property
    def is_of_a_case(self) -> bool:
        """Return whether it is asked at the ends of each stroke."""
        return self.at == "full-stroke"

    def applies(self, scene: Scene) -> bool:
        """Return whether the case has a stroke, where that is asked about."""
        return self.at == "rest" or scene.moves

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the stroke, where it is asked there."""
        return frozenset() if self.at == "rest" else frozenset({LoadKind.STROKE})
