"""Parallel stage of rigid bodies as one degree of freedom: two levers and a platform."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import cos as number_cos
from math import sin as number_sin
from typing import NamedTuple

from flexcli.formulas.single_freedom import Body, Path, SingleFreedom, Spring
from flexcli.numerics.taylor import Scalar, Taylor, cos, sin

__all__ = ["NO_RIDER", "Lever", "Rider", "Stage", "Term", "system"]


@dataclass(frozen=True)
class Rider:
    """A body fixed to a lever: where its centre of mass is in the lever's own axes.

    ``along`` runs from the base pivot to the upper one, ``across`` along the stroke [m].
    """

    mass: float
    along: float
    across: float
    inertia: float

    @property
    def moment(self) -> float:
        """Return the static moment m s about the base pivot [kg·m]."""
        return self.mass * self.along


NO_RIDER = Rider(0.0, 0.0, 0.0, 0.0)
"""What a lever without a balancing mass carries."""


@dataclass(frozen=True)
class Lever:
    """Solid 1 or 3 with its balancing mass."""

    solid: Rider
    balance: Rider = NO_RIDER

    @property
    def riders(self) -> tuple[Rider, Rider]:
        """Return both bodies."""
        return self.solid, self.balance

    @property
    def mass(self) -> float:
        """Return the mass of both [kg]."""
        return self.solid.mass + self.balance.mass

    @property
    def moment(self) -> float:
        """Return their static moment about the base pivot [kg·m]."""
        return self.solid.moment + self.balance.moment


class Term(NamedTuple):
    """How the coupling depends on one number of the stage: ∂τ/∂p [kg per unit of p]."""

    name: str
    kind: str
    value: float
    unit: str
    slope: float


@dataclass(frozen=True)
class Stage:
    """The numbers of a parallel stage: lever height H, platform, levers on either side [SI].

    ``platform_com`` is the height of solid 2's centre of mass over the upper pivots.
    """

    height: float
    platform: float
    platform_com: float
    levers: tuple[Lever, Lever]

    @property
    def moment(self) -> float:
        """Return the static moment of all moving bodies about the base pivots [kg·m].

        τ_coupling = moment/H: it is balanced when this vanishes, and then at every angle.
        """
        return self.platform * self.height + sum(lever.moment for lever in self.levers)

    @property
    def added_mass(self) -> float:
        """Return the balancing masses together [kg]."""
        return sum(lever.balance.mass for lever in self.levers)

    def without_balance(self) -> "Stage":
        """Return the stage before its balancing masses are mounted."""
        first, third = (Lever(lever.solid) for lever in self.levers)
        return Stage(self.height, self.platform, self.platform_com, (first, third))

    def coupling_terms(self) -> Iterator[Term]:
        """Yield the derivative of τ = m_2 + Σ m s/H by each number, in closed form."""
        H = self.height
        yield Term("solid-2 mass", "mass", self.platform, "kg", 1.0)
        for number, lever in zip((1, 3), self.levers, strict=True):
            parts = [(f"solid-{number}", lever.solid, "com", 1.0)]
            if lever.balance != NO_RIDER:
                parts.append((f"balance-{number}", lever.balance, "arm", -1.0))
            for name, rider, key, sign in parts:
                yield Term(f"{name} mass", "mass", rider.mass, "kg", rider.along / H)
                yield Term(f"{name} {key}", key, sign * rider.along, "m", sign * rider.mass / H)
        levers = sum(lever.moment for lever in self.levers)
        yield Term("height", "height", H, "m", -levers / H**2)


def _rider_path(rider: Rider, base: "_Drift") -> Path:
    """Return the path of a body on a lever that leans by q towards x."""

    def path(q: Taylor) -> tuple[Scalar, Scalar, Scalar]:
        s, c = sin(q), cos(q)
        x = s * rider.along + c * rider.across
        y = c * rider.along - s * rider.across
        return x + base.x(q), y + base.y(q), -q

    return path


class _Drift(NamedTuple):
    """Parasitic shift of pivots: ``size`` θ² along a direction from x [m/rad², rad]."""

    size: float
    direction: float

    def x(self, q: Taylor) -> Taylor:
        return q * q * (self.size * number_cos(self.direction))

    def y(self, q: Taylor) -> Taylor:
        return q * q * (self.size * number_sin(self.direction))


def system(
    stage: Stage,
    stiffness: tuple[float, ...],
    *,
    shift: float = 0.0,
    direction: float = 0.0,
) -> SingleFreedom:
    """Return the stage as bodies and springs on the angle of its levers.

    Parameters
    ----------
    stage : Stage
        Masses and lengths.
    stiffness : tuple of float
        Stiffness of the four pivots, k_1 to k_4 [N·m/rad].
    shift : float
        Parasitic shift of a pivot per squared rotation [m/rad²], taken the same way at all four:
        the base pivots move everything, the upper ones solid 2 once more.
    direction : float
        Direction of that shift from x [rad].

    Returns
    -------
    SingleFreedom
        Coordinate: the angle θ by which the levers lean towards x, clockwise where y points from
        the base pivots to the upper ones; output: x of solid 2, H sin θ; origin: in the line of
        the base pivots, both levers in one place.

    Notes
    -----
    Both levers are equally long and lean by the same angle; solid 2 does not turn.

    References
    ----------
    Exercise 9 part I.

    """
    base, top = _Drift(shift, direction), _Drift(2.0 * shift, direction)

    def output(q: Taylor) -> Taylor:
        return sin(q) * stage.height + top.x(q)

    def platform(q: Taylor) -> tuple[Scalar, Scalar, Scalar]:
        return output(q), cos(q) * stage.height + stage.platform_com + top.y(q), 0.0

    bodies = [Body("solid-2", stage.platform, 0.0, platform)]
    for number, lever in zip((1, 3), stage.levers, strict=True):
        for name, rider in zip(("solid", "balance"), lever.riders, strict=True):
            path = _rider_path(rider, base)
            bodies.append(Body(f"{name}-{number}", rider.mass, rider.inertia, path))
    springs = [Spring(f"P{number}", k, lambda q: q) for number, k in enumerate(stiffness, start=1)]
    return SingleFreedom(bodies, springs, output)
