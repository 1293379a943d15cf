"""A model that answers 1 to everything, to validate requirements before a model can judge them."""

from typing import TYPE_CHECKING

import numpy as np

from flexcli.formulas.quantity import Computed
from flexcli.parts.geometries.base import Critical
from flexcli.parts.requirements.ask import (
    Ask,
    CriticalShare,
    DriveEffort,
    EndStress,
    JointModel,
)
from flexcli.results import ErrorRange

if TYPE_CHECKING:
    from flexcli.mechanics.space.swept_box import SweptBox

__all__ = ["STAND_IN"]


class _StandIn(JointModel):
    """Answers of 1, so that only missing data of material and mechanism raise errors."""

    name = "stand-in"

    def stiffness(self, ask: Ask) -> Computed:
        """Return 1."""
        return 1.0

    def sag_stiffness(self, ask: Ask) -> Computed:
        """Return 1."""
        return 1.0

    def sag(self, ask: Ask) -> Computed:
        """Return 1 where a model in space gives it; else the base class says what is missing."""
        return 1.0 if ask.geometry.in_space and ask.geometry.has_masses else super().sag(ask)

    def frequency_squared(self, ask: Ask) -> Computed:
        """Return 1 where a model in space gives it; else the base class says what is missing."""
        known = ask.geometry.in_space and ask.geometry.has_masses
        return 1.0 if known else super().frequency_squared(ask)

    def effort(self, ask: Ask) -> tuple[DriveEffort, ...]:
        """Return 1 at a travel of 1."""
        return (DriveEffort(1.0, 1.0, None),)

    def support_at_stroke(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return 1."""
        return ((1.0, None),)

    def parasitic_frequency_at_stroke(
        self, ask: Ask
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return 1."""
        return ((1.0, None),)

    def envelope(self, ask: Ask) -> tuple["SweptBox", tuple[str, ...]]:
        """Return a box of 1 m, or raise where the joint has no layout in space."""
        from flexcli.mechanics.space.swept_box import SweptBox

        ask.geometry.space_layout(ask.material.elastic, ask.sizes)
        return SweptBox(np.ones(3), np.ones(3), np.ones(3), is_known=False), ()

    def critical_shares(self, ask: Ask) -> tuple[CriticalShare, ...]:
        """Return 1."""
        return (CriticalShare(1.0, "stand-in", None, 0.0),)

    def parasitic_shift(self, ask: Ask) -> Computed:
        """Return 1."""
        return 1.0

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return one place with a mean beside its amplitude where the stroke has one."""
        mean = 1.0 if ask.scene.mean_travel else 0.0
        return "stress", [EndStress("blade", 1.0, mean, 0.0)]

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return 1 N."""
        return (Critical("in the plane", 1.0, "stand-in"),)


STAND_IN = _StandIn()
