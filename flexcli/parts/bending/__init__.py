"""How the blades of a joint bend, kind by kind: what each effect changes in its numbers."""

from flexcli.parts.bending.base import FLOOR, UNKNOWN, Bending, Change, Changes, together, whole
from flexcli.parts.bending.of import bending_of, is_known

__all__ = [
    "FLOOR",
    "UNKNOWN",
    "Bending",
    "Change",
    "Changes",
    "bending_of",
    "is_known",
    "together",
    "whole",
]
