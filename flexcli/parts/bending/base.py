"""What a way of bending tells of the effects that its closed forms leave out."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import ClassVar, NamedTuple, TypeAlias

__all__ = ["Bending", "Change", "Changes", "whole"]


class Change(NamedTuple):
    """Relative change of a reported number: its best value, if any, and a bound of its size.

    ``error`` is how far off the value may be, besides what is of its own square; ``sign`` tells,
    where only the bound is known, that the number can but rise (+1) or fall (−1).
    """

    value: float | None
    bound: float
    error: float = 0.0
    sign: int = 0


Changes: TypeAlias = Mapping[str, Change]
"""Changes by what is reported: stiffness, stress, shift, buckling, sag, frequency."""


def whole(value: float) -> Change:
    """Return a change of which the value is all that there is."""
    return Change(float(value), abs(float(value)))


class Bending(ABC):
    """Equal slender blades at the largest travel of a case."""

    is_estimate: ClassVar[bool] = True
    """Whether its changes are values or bounds that hold, not orders of magnitude."""

    @property
    @abstractmethod
    def ratio(self) -> float:
        """Return what each further order of the travel is smaller by [-]."""

    @abstractmethod
    def shear(self, Phi: float) -> Changes:
        """Return what shear changes, by Timoshenko's Φ of the blade."""

    @abstractmethod
    def extension(self) -> Changes:
        """Return what the stretching of the blades changes."""

    @abstractmethod
    def stretched(self, n: float) -> Changes:
        """Return what the stretching by an axial force N = n EI/l² in a blade adds to the bending.

        The body moves as its blades stretch, which bends them, whatever the travel.
        """

    def pulled(self, n: float) -> Changes:
        """Return what bending adds to the axial stress of a force n EI/l² where nothing else bends.

        Blades that are parallel stretch with their body, and do not bend.
        """
        return {}

    def amplified(self, n: float) -> Changes:
        """Return what the force makes more of the bending of :meth:`pulled`."""
        return {}

    @abstractmethod
    def rotation(self) -> Changes:
        """Return what the terms of higher order in the travel change."""

    @abstractmethod
    def tension(self) -> Changes:
        """Return what the axial stress that the travel itself makes adds."""

    @abstractmethod
    def load(self, n: float) -> Changes:
        """Return what an axial force N = ±n EI/l² in a blade changes in the bending."""
