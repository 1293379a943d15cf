"""What a design is judged by: values, checks, effects left out, notes."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

__all__ = ["Check", "EffectRow", "Note", "Property", "Value"]


class Value(NamedTuple):
    """One named number in SI, with the model that made it and its estimated relative error.

    Nothing stands for an error that nobody can estimate, zero for what is given or defined.
    """

    value: float
    unit: str
    label: str
    model: str = "closed-form"
    source: str = ""
    estimated_error: float | None = None


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
    """One number of a material with where it comes from."""

    name: str
    value: float
    unit: str
    detail: str
    status: str
    source: str
