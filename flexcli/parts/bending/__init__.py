"""Bending of the blades of each kind of joint: the effects that its closed forms leave out."""

from flexcli.parts.bending.base import (
    FLOOR,
    UNKNOWN,
    Bending,
    Change,
    Changes,
    CompliantClamps,
    Factor,
    FilletedRoots,
    MovedAcross,
    Thick,
    WideAcross,
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
    "MovedAcross",
    "Thick",
    "WideAcross",
    "WideBlades",
    "together",
    "whole",
]
