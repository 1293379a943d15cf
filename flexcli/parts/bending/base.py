"""Interface of a way of bending: the effects that closed forms leave out, as relative changes."""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from math import inf
from typing import ClassVar, NamedTuple, Protocol, TypeAlias

from flexcli.numerics.rows import larger, number, smaller
from flexcli.results import ErrorRange

__all__ = [
    "FLOOR",
    "NOTCH_PULLED",
    "PULLED",
    "SHORTEST",
    "UNEVEN",
    "UNKNOWN",
    "Bending",
    "Change",
    "Changes",
    "CompliantClamps",
    "Factor",
    "FilletedRoots",
    "MovedAcross",
    "Thick",
    "Turned",
    "WideAcross",
    "WideBlades",
    "WidePath",
    "hull",
    "together",
    "whole",
]


class Change(NamedTuple):
    """Relative change of a reported number: its estimate, if any, and a bound of its size.

    ``error`` is the relative error of 1 + value; ``sign`` says that the number can only rise (+1)
    or fall (−1). Without a value the change is unknown, and its bound is an order of magnitude by
    which nothing is judged. ``other`` is the relative error for any other deflected shape of the
    blades, as other effects may cause.
    """

    value: float | None
    bound: float
    error: float = 0.0
    sign: int = 0
    other: float = inf


Changes: TypeAlias = Mapping[str, Change]
"""Changes by the number that they affect: stiffness, stress, shift, buckling, sag, frequency."""

UNKNOWN = Change(None, inf)
"""A change that no formula gives."""


FLOOR = ErrorRange(-2e-6, 2e-6)
"""Error of any closed form: some ten times the difference of the finest model from exact solutions,
at sharp notches."""


PULLED = 0.25
"""Part of the change of a wide blade's stiffness by which its stress under forces may differ: solid
blades stretched by a force had 1 % more, at b/l = 0.6, where the stiffness has 9 %."""

NOTCH_PULLED = 1.3
"""Part of the change of stiffness by which the stress of a force along a notch may differ, largest
in the middle of its width: solids of e/r 0.03 to 0.35, b/e 1 to 40 and ν up to 0.45 had 0.4 to 1.2
of it, up to 0.088 of the stress in all."""


SHORTEST = 4.0
"""Equivalent width ratio: a blade in pure bending that many times wider is as flat as one bent in
any shape between clamps (guided 2.9 at most, buckled with any ends 2.6)."""


UNEVEN = 0.35
"""Share of what flattens sections, or of the plates' widening, by which blades that are curved
unevenly flatten so, of what each shortens."""


def whole(value: float, error: float = 0.0) -> Change:
    """Return a change that is known completely, but for an error."""
    return Change(number(value), abs(number(value)), number(error))


def together(one: Change, other: Change) -> Change:
    """Return two changes combined, unknown where either is."""
    known = one.value is not None and other.value is not None
    value = (1.0 + (one.value or 0.0)) * (1.0 + (other.value or 0.0)) - 1.0 if known else None
    return Change(
        value,
        one.bound + other.bound,
        one.error + other.error,
        one.sign if one.sign == other.sign else 0,
    )


class Factor(NamedTuple):
    """Factor of a plate's number over the beam's: the best value, and its range [-].

    ``other`` is the relative error of the value for blades that bend in any other shape.
    """

    value: float
    low: float
    high: float
    other: float = inf

    def change(self, nu_known: bool) -> Change:
        """Return it as a change; with an unknown ν, taken as ½, its value is a bound."""
        if not nu_known:
            return Change(None, self.high - 1.0, 0.0, 1)
        return Change(self.value - 1.0, self.high - 1.0, self.off, other=self.other)

    @property
    def off(self) -> float:
        """Return by how much the value may be off, to its farther end [-]."""
        return larger(self.high - self.value, self.value - self.low) / self.value


def hull(factors: Iterable[Factor], at: Factor | None = None) -> Factor:
    """Return the range that holds all factors, about its middle or a given value."""
    found: Sequence[Factor] = tuple(factors)
    low, high = smaller(f.low for f in found), larger(f.high for f in found)
    return Factor((low + high) / 2.0 if at is None else at.value, low, high)


class WidePath(Protocol):
    """The path of a joint's centre by its beams, and by its wide blades."""

    def change(self, ends: Sequence[float]) -> tuple[float, float] | None:
        """Return the relative change of the largest shift at travels, and its error [-].

        None where nobody can tell.
        """


class WideAcross(NamedTuple):
    """The motion of a centre across its bisector, of first order in the travel, by stretching.

    ``ratio`` is that of beams over their shift along it, both of a unit travel [rad]; ``unsure`` by
    how much the latter may be off, relative. Plates change it by ``change``, within ``error``.
    """

    ratio: float
    unsure: float
    change: float
    error: float


class WideBlades(NamedTuple):
    """Change of a joint's numbers by the width of its blades; ν is that of the material, or ½.

    ``shift`` and ``sag`` are relative changes with their errors; None where the shift is zero, or
    the sag follows from the stiffness.
    """

    ratio: float
    """Largest b/l."""
    stiffness: Factor
    stress: Factor
    buckling: Mapping[str, Factor]
    shift: tuple[float, float] | None = None
    sag: tuple[float, float] | None = None
    bends: tuple[float, float] | None = None
    """Curvatures at both ends of a blade of constant thickness, over the travel [1/m or 1/m²]."""
    bent: tuple[float, float, float] | None = None
    """Thickness, length and width of the blade with these curvatures, for joints of several shapes
    [m]."""
    pulled: float = PULLED
    """Part of the change of stiffness by which the stress of forces along them may differ."""
    stretched: Factor | None = None
    """The largest stress of a force along a throat over its mean, where that is known."""
    path: WidePath | None = None
    """The path of the centre of a drawn layout, which tells the change of its shift."""
    uneven: float = 1.0
    """Shortening of blades that are curved unevenly over the shift by ``shift``: 0 for an arc."""
    across: WideAcross | None = None
    """What beside ``shift``, which is then of that along a bisector, moves a centre across it."""


class FilletedRoots(NamedTuple):
    """Change of a joint's closed forms by fillets at the roots of its blades.

    ``stiffness`` and ``stress`` are of small motions, with the peak of the stress, which may be
    ``off`` by a share; ``shift`` is the range of its change, ``arc`` the reduction of the rotation
    of a blade bent by a moment.
    """

    ratio: float
    """Largest r/l of a blade."""
    stiffness: float
    stress: float
    off: float
    shift: tuple[float, float]
    arc: float


class MovedAcross(NamedTuple):
    """Motion of a centre across its bisector, of first order in the travel, that clamps change.

    All are of a unit travel [m/rad], of its square along the bisector [m/rad²].
    """

    beams: tuple[float, float]
    solid: tuple[float, float]
    """Ranges of what beams have, and of what it is."""
    along: tuple[float, float]
    """Range of the shift along the bisector that beams have."""
    farthest: float
    """The largest shift along it, where its change is not known."""


class Turned(NamedTuple):
    """What a travel t adds to the change of a stress: from least t to (most + grows t²) t.

    Of travels up to the farthest; nobody knows beyond.
    """

    least: float = 0.0
    most: float = 0.0
    grows: float = 0.0
    farthest: float = inf


class CompliantClamps(NamedTuple):
    """Change of a joint's numbers by clamps that are not rigid.

    ``stress`` and ``shift`` are ranges of their change; ``softest`` is the largest increase of any
    compliance of the joint, across its motion and out of its plane too.
    """

    ratio: float
    """Largest h/l of a blade."""
    stiffness: Factor
    stress: tuple[float, float]
    loaded: float
    """Largest increase of the stress under loads beside the travel."""
    buckling: Factor
    shift: tuple[float, float]
    softest: float
    across: MovedAcross | None = None
    turned: Turned = Turned()


class Thick(NamedTuple):
    """Change of the stiffness of notch hinges by plane elasticity, which beams leave out.

    ``ratio`` is the largest e/radius; there is no factor where no such notch was compared.
    ``shift`` is the range of the hinges' shift over that of their beams, ``path`` the part of the
    joint's shift that comes from them. ``stress`` is the factor of the moments in the throats at a
    travel, ``loaded`` that of what loads bend, where they are not that of the stiffness. ``first``
    is the motion of first order beside the shift, over the second order of a unit travel
    [rad or m], and the range of its change. ``swaying`` are the ends of a case by which limbs sway
    as they buckle, by the stiffness of their hinges alone, ``bowing`` those by which a hinge bears
    the more moment as it buckles the nearer to its middle it is, to no more than ``bowed`` of what
    buckles its beam.
    """

    ratio: float
    factor: Factor | None
    shift: tuple[float, float] = (1.0, 1.0)
    path: float = 1.0
    stress: Factor | None = None
    loaded: Factor | None = None
    first: tuple[float, float, float] = (0.0, 1.0, 1.0)
    swaying: tuple[str, ...] = ()
    bowing: tuple[str, ...] = ()
    bowed: float = 1.0


class Bending(ABC):
    """Equal slender blades at the largest travel of a case."""

    is_estimate: ClassVar[bool] = True
    """Whether its changes are values with reliable errors, rather than unknown."""
    travel_most: ClassVar[float] = 0.0
    """Rotation [rad], or stroke over length, up to which the next order corrects the closed form;
    beyond it, and beyond the range of the formula itself, its error is unknown."""

    @property
    @abstractmethod
    def ratio(self) -> float:
        """Return the ratio of each further order of the travel to the one before [-]."""

    @property
    def hinge_reach(self) -> float | None:
        """Return the distance over which hinges bend about their centres, over the limb's."""
        return None

    def hinge_length(self) -> Changes:
        """Return the changes by the length of hinges, which closed forms take as points."""
        return {}

    @abstractmethod
    def shear(self, poisson_ratio: float) -> Changes:
        """Return the changes by shear at a Poisson's ratio."""

    @abstractmethod
    def extension(self) -> Changes:
        """Return the changes by the stretching of the blades."""

    def strain_law(self, poisson_ratio: float) -> float | None:
        """Return what the law of finite strain may change of the shift, relative.

        None where there is no closed form.
        """
        return None

    @abstractmethod
    def stretched(self, n: float, direction: float | None) -> Changes:
        """Return the change of stress as an axial force N = n EI/l² stretches the blades.

        The body moves as its blades stretch, which bends them, whatever the travel. The direction
        of the force [rad] is from the axis of symmetry, None where there are several.
        """

    def pulled(self, n: float) -> Changes:
        """Return the bending over the axial stress of a force n EI/l² where nothing else bends.

        Unknown unless the joint gives it: blades at an angle to the force bend as they stretch.
        """
        return {"stress": UNKNOWN}

    def amplified(self, n: float) -> Changes:
        """Return the amplification by the force of the bending in :meth:`pulled`."""
        return {"stress": UNKNOWN}

    @abstractmethod
    def rotation(self) -> Changes:
        """Return the changes by the terms of higher order in the travel."""

    @abstractmethod
    def tension(self) -> Changes:
        """Return the changes by the axial stress that the travel itself causes."""

    @abstractmethod
    def load(self, n: float) -> Changes:
        """Return the changes of the bending by an axial force N = ±n EI/l² in a blade."""
