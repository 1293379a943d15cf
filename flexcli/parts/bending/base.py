"""What a way of bending tells of the effects that its closed forms leave out."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from math import inf
from typing import ClassVar, NamedTuple, TypeAlias

from flexcli.numerics.rows import larger, number
from flexcli.results import ErrorRange

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


class Change(NamedTuple):
    """Relative change of a reported number: its best value, if any, and a bound of its size.

    ``error`` is how far off 1 + value may be, as a share of it; ``sign`` tells that the number
    can but rise (+1) or fall (−1). Without a value the change is unknown: a bound without one is
    an order of magnitude, by which nothing is judged. ``other`` is how far off it may be, whatever
    shape the blades take beside other effects.
    """

    value: float | None
    bound: float
    error: float = 0.0
    sign: int = 0
    other: float = inf


Changes: TypeAlias = Mapping[str, Change]
"""Changes by what is reported: stiffness, stress, shift, buckling, sag, frequency."""

UNKNOWN = Change(None, inf)
"""What nobody has a formula for."""


FLOOR = ErrorRange(-2e-6, 2e-6)
"""Of any closed form: some ten times what the finest model differs by from those that are exact,
at sharp notches."""


def whole(value: float, error: float = 0.0) -> Change:
    """Return a change of which the value is all that there is, but for an error."""
    return Change(number(value), abs(number(value)), number(error))


def together(one: Change, other: Change) -> Change:
    """Return two changes as one, unknown where either is."""
    known = one.value is not None and other.value is not None
    value = (1.0 + (one.value or 0.0)) * (1.0 + (other.value or 0.0)) - 1.0 if known else None
    return Change(
        value,
        one.bound + other.bound,
        one.error + other.error,
        one.sign if one.sign == other.sign else 0,
    )


class Factor(NamedTuple):
    """A plate's number over the beam's: the best value, and the range it is in [-].

    ``other`` is how far off the value may be for blades that bend in any other shape, as a share.
    """

    value: float
    low: float
    high: float
    other: float = inf

    def change(self, nu_known: bool) -> Change:
        """Return it as a change; where ν is not known, it was taken as ½ and is a bound."""
        if not nu_known:
            return Change(None, self.high - 1.0, 0.0, 1)
        error = larger(self.high - self.value, self.value - self.low) / self.value
        return Change(self.value - 1.0, self.high - 1.0, error, other=self.other)


class WideBlades(NamedTuple):
    """What the width of its blades changes in a joint; ν is that of the material, or ½.

    ``shift`` and ``sag`` are relative changes with their errors; nothing where the first is zero
    or the second follows from the stiffness.
    """

    ratio: float
    """Largest b/l."""
    stiffness: Factor
    stress: Factor
    buckling: dict[str, Factor]
    shift: tuple[float, float] | None = None
    sag: tuple[float, float] | None = None
    bends: tuple[float, float] | None = None
    """Curvatures at both ends of a blade of constant thickness, over the travel [1/m or 1/m²]."""
    bent: tuple[float, float, float] | None = None
    """h, l and b of the blade that these are of, where the joint has more than one shape [m]."""
    first: tuple[float, float] = (0.0, 0.0)
    """What the centre moves to first order, over the second order of a unit travel [rad or m], and
    the largest change of that [-]."""


class FilletedRoots(NamedTuple):
    """What fillets at the roots of its blades change in a joint's closed forms.

    ``stiffness`` and ``stress`` are of small motions, with the peak of the stress; ``shift`` is
    between which the change lies, ``arc`` how much less a blade turns that a moment bends.
    """

    ratio: float
    """Largest r/l of a blade."""
    stiffness: float
    stress: float
    shift: tuple[float, float]
    arc: float


class CompliantClamps(NamedTuple):
    """What clamps that are not rigid change in a joint.

    ``stress`` and ``shift`` are between which the change lies; ``softest`` is by how much any
    compliance of the joint may rise, off its motion and out of its plane too.
    """

    ratio: float
    """Largest h/l of a blade."""
    stiffness: Factor
    stress: tuple[float, float]
    loaded: float
    """By how much the stress may rise under loads beside the travel."""
    buckling: Factor
    shift: tuple[float, float]
    softest: float


class Thick(NamedTuple):
    """What plane elasticity changes in the stiffness of notch hinges, of which beams know nothing.

    ``ratio`` is the largest e/radius; no factor where no such notch was compared. ``shift`` is
    between which the shift of the hinges lies over that of their beams, ``path`` the share of the
    joint's shift that they make.
    """

    ratio: float
    factor: Factor | None
    shift: tuple[float, float] = (1.0, 1.0)
    path: float = 1.0


class Bending(ABC):
    """Equal slender blades at the largest travel of a case."""

    is_estimate: ClassVar[bool] = True
    """Whether its changes are values with errors that hold, not unknown."""
    travel_most: ClassVar[float] = 0.0
    """Rotation [rad], or stroke over length, up to which the next order corrects the closed form;
    beyond it, and beyond the range of the formula itself, its error is unknown."""

    @property
    @abstractmethod
    def ratio(self) -> float:
        """Return what each further order of the travel is smaller by [-]."""

    @property
    def hinge_reach(self) -> float | None:
        """Return how far hinges bend about their centres over the limb, where it has hinges."""
        return None

    def hinge_length(self) -> Changes:
        """Return what the length of hinges changes, which closed forms take as points."""
        return {}

    @abstractmethod
    def shear(self, poisson_ratio: float) -> Changes:
        """Return what shear changes at a Poisson's ratio."""

    @abstractmethod
    def extension(self) -> Changes:
        """Return what the stretching of the blades changes."""

    @abstractmethod
    def stretched(self, n: float, direction: float | None) -> Changes:
        """Return what the stretching by an axial force N = n EI/l² in a blade adds to the stress.

        The body moves as its blades stretch, which bends them, whatever the travel. The direction
        of the force [rad] is from the axis of symmetry, nothing where there are several.
        """

    def pulled(self, n: float) -> Changes:
        """Return what bending adds to the axial stress of a force n EI/l² where nothing else bends.

        Unknown unless the joint says so: blades at an angle to the force bend as they stretch.
        """
        return {"stress": UNKNOWN}

    def amplified(self, n: float) -> Changes:
        """Return what the force makes more of the bending of :meth:`pulled`."""
        return {"stress": UNKNOWN}

    @abstractmethod
    def rotation(self) -> Changes:
        """Return what the terms of higher order in the travel change."""

    @abstractmethod
    def tension(self) -> Changes:
        """Return what the axial stress that the travel itself makes adds."""

    @abstractmethod
    def load(self, n: float) -> Changes:
        """Return what an axial force N = ±n EI/l² in a blade changes in the bending."""
