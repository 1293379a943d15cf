"""The planned effects and models of a simulation, and the audit of the plan."""

from collections.abc import Mapping
from math import isfinite
from typing import NamedTuple

from flexcli.results.judgement import EffectRow, Note

__all__ = ["AuditRow", "ModelRow", "Plan", "ScenePlan"]


class ModelRow(NamedTuple):
    """A model that could be taken: its declared cost in closed forms, and its error.

    ``missing`` names the effects that are on and that it cannot carry.
    """

    name: str
    cost: float
    error: float
    missing: tuple[str, ...]


class ScenePlan(NamedTuple):
    """The models of what shakes the base in a case, as they judge in turn, and the one to take."""

    case: str
    models: tuple[ModelRow, ...]
    model: str
    cost: float
    estimated_error: float
    reason: str


class Plan(NamedTuple):
    """Effects on and off with their reasons, the models in question and the one that is taken.

    ``tolerance`` is that of the exact model. ``errors`` are the relative errors of the reported
    quantities: what is left out, and what the model itself is off by; ``estimated_error`` is the
    largest of them. ``scenes`` are the cases that shake the base.
    """

    accuracy: float
    reported: tuple[str, ...]
    effects: tuple[EffectRow, ...]
    models: tuple[ModelRow, ...]
    model: str
    cost: float
    estimated_error: float
    tolerance: float
    errors: Mapping[str, float]
    notes: tuple[Note, ...] = ()
    scenes: tuple[ScenePlan, ...] = ()

    @property
    def known_error(self) -> float | None:
        """Return the estimated error where there is one, that is where it is finite."""
        return self.estimated_error if isfinite(self.estimated_error) else None

    @property
    def on(self) -> tuple[str, ...]:
        """Return the names of the effects that are on."""
        return tuple(row.name for row in self.effects if row.on)


class AuditRow(NamedTuple):
    """True change by an effect of one reported number, beside its estimate; relative.

    ``right`` says whether the plan was: left out, its change must be below the accuracy. None
    stands for a change that no model gives.
    """

    effect: str
    on: bool
    quantity: str
    estimate: float
    true: float | None
    right: bool | None
    how: str
