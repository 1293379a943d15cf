"""How the blades of a joint bend, kind by kind: what each effect changes in its numbers."""

from flexcli.parts.bending.base import (
    FLOOR,
    UNKNOWN,
    Bending,
    Change,
    Changes,
    CompliantClamps,
    Factor,
    FilletedRoots,
    Thick,
    WideBlades,
    together,
    whole,
)

__all__ = [
    "FLOOR",
    "UNKNOWN",
    "Bending",
    "Change",
    "Changes",
    "CompliantClamps",
    "Factor",
    "FilletedRoots",
    "Thick",
    "WideBlades",
    "together",
    "whole",
]
