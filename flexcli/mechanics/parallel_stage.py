"""Parallel stage of rigid bodies as one degree of freedom: two levers and a platform."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import cos as number_cos
from math import sin as number_sin
from typing import NamedTuple

from flexcli.mechanics.layout import Body
from flexcli.mechanics.single_freedom import SingleFreedom
from flexcli.numerics.taylor import Scalar, Taylor, cos, sin

__all__ = ["NO_BALANCE", "Lever", "Stage", "Term", "system"]


NO_BALANCE = Body("none", (0.0, 0.0))
"""What a lever without a balancing mass carries."""


@dataclass(frozen=True)
class Lever:
    """Solid 1 or 3 with its balancing mass, both stated at its base pivot (0, 0).

    At rest the lever points along y from there to its upper pivot, and the stroke is along x.
    """

    solid: Body
    balance: Body = NO_BALANCE

    @property
    def bodies(self) -> tuple[Body, Body]:
        """Return both bodies."""
        return self.solid, self.balance

    @property
    def mass(self) -> float:
        """Return the mass of both [kg]."""
        return float(self.solid.mass + self.balance.mass)

    @property
    def moment(self) -> float:
        """Return their static moment about the base pivot [kg·m]."""
        moment: float = sum(body.mass * body.com[1] for body in self.bodies)
        return moment


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
        return float(sum(lever.balance.mass for lever in self.levers))

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
            if lever.balance != NO_BALANCE:
                parts.append((f"balance-{number}", lever.balance, "arm", -1.0))
            for name, body, key, sign in parts:
                along = body.com[1]
                yield Term(f"{name} mass", "mass", body.mass, "kg", along / H)
                yield Term(f"{name} {key}", key, sign * along, "m", sign * body.mass / H)
        levers = sum(lever.moment for lever in self.levers)
        yield Term("height", "height", H, "m", -levers / H**2)


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
    stiffness: Sequence[float],
    *,
    shift: float = 0.0,
    direction: float = 0.0,
) -> SingleFreedom:
    """Return the stage as bodies and one spring on the angle of its levers.

    Parameters
    ----------
    stage : Stage
        Masses and lengths.
    stiffness : sequence of float
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

    def upper_pivots(q: Taylor) -> tuple[Scalar, Scalar, Scalar]:
        return output(q), cos(q) * stage.height + top.y(q), 0.0

    def lever(q: Taylor) -> tuple[Scalar, Scalar, Scalar]:
        return base.x(q), base.y(q), -q

    platform = Body(
        "solid-2",
        (0.0, stage.height),
        stage.platform,
        com=(0.0, stage.height + stage.platform_com),
    )
    levers = [(body, lever) for each in stage.levers for body in each.bodies]
    return SingleFreedom([(platform, upper_pivots), *levers], sum(stiffness), output)
