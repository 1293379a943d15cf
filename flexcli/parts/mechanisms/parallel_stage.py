"""Parallel stage of rigid bodies: two levers on the base carry a third body on four pivots."""

from math import pi, sqrt
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, model_validator

from flexcli.formulas.quantity import Quantity
from flexcli.parts.base import Angle, Inertia, Length, Mass, Part, PositiveLength, spec_error
from flexcli.parts.geometries.base import Geometry
from flexcli.parts.mechanisms.base import Mechanism, MechanismError, Mode
from flexcli.parts.stroke import Stroke
from flexcli.results import Value

__all__ = ["BalancingMass", "InertiaTensor", "Lever", "ParallelStage", "Platform"]

SOURCE = "exercise 9"


class InertiaTensor(Part):
    """Moments of inertia about the body's own centre of mass; a plain value stands for zz."""

    xx: Inertia | None = None
    yy: Inertia | None = None
    zz: Inertia

    @model_validator(mode="before")
    @classmethod
    def _from_plain(cls, data: Any) -> Any:
        return data if isinstance(data, dict) else {"zz": data}


class Lever(Part):
    """Solid 1 or 3: it turns about its pivot on the base."""

    mass: Mass
    com: Length = Field(description="centre of mass from the base pivot, positive to solid 2")
    inertia: InertiaTensor


class Platform(Part):
    """Solid 2: it moves along x without turning."""

    mass: Mass


class BalancingMass(Part):
    """A mass on a lever beyond its base pivot, away from solid 2."""

    mass: Mass
    arm: Length = Field(description="from the base pivot, positive away from solid 2")
    inertia: InertiaTensor


class ParallelStage(Mechanism):
    """Solids 1 and 3 on base pivots P1 and P3 carry solid 2 on P2 and P4."""

    joints: ClassVar[int] = 4
    joint_motion: ClassVar[str | None] = "rotation"

    kind: Literal["parallel-stage"]
    height: PositiveLength = Field(description="H, from base pivot to upper pivot")
    bisector: Annotated[Angle, Field(description="axis of symmetry of the pivots from x")] = 0.0
    solid_1: Lever = Field(alias="solid-1")
    solid_2: Platform = Field(alias="solid-2")
    solid_3: Lever = Field(alias="solid-3")
    balance_1: BalancingMass | None = Field(None, alias="balance-1")
    balance_3: BalancingMass | None = Field(None, alias="balance-3")

    @model_validator(mode="after")
    def _has_mass(self) -> "ParallelStage":
        if self.equivalent_mass(balanced=True) <= 0.0:
            raise spec_error("nothing that moves has a mass", "give the masses of the solids")
        return self

    @property
    def _levers(self) -> tuple[tuple[Lever, BalancingMass | None], ...]:
        return ((self.solid_1, self.balance_1), (self.solid_3, self.balance_3))

    def equivalent_mass(self, *, balanced: bool) -> float:
        """Return m_eq [kg]: inertia of the levers about their pivots over H², and solid 2."""
        inertia = 0.0
        for lever, balance in self._levers:
            inertia += lever.inertia.zz + lever.mass * lever.com**2
            if balanced and balance is not None:
                inertia += balance.inertia.zz + balance.mass * balance.arm**2
        return inertia / self.height**2 + self.solid_2.mass

    def joint_travel(self, stroke: Stroke, geometry: Geometry) -> tuple[float, float]:
        """Return the rotation of each pivot: x/H for a translation x of solid 2."""
        if stroke.motion == "rotation":
            return stroke.amplitude, stroke.mean
        return stroke.amplitude / self.height, stroke.mean / self.height

    def mode(self, joint_stiffness: Quantity, geometry: Geometry) -> Mode:
        """Return k_eq = 4k/H² and m_eq with the balancing masses on."""
        return Mode(
            self.joints * joint_stiffness / self.height**2, self.equivalent_mass(balanced=True)
        )

    def _lever_sums(self) -> tuple[tuple[float, float], ...]:
        """Return mass and static moment about the base pivot (to solid 2) of each lever."""
        sums = []
        for lever, balance in self._levers:
            mass, moment = lever.mass, lever.mass * lever.com
            if balance is not None:
                mass += balance.mass
                moment -= balance.mass * balance.arm
            sums.append((mass, moment))
        return tuple(sums)

    def locked_forces(self, body: str, acceleration: float) -> dict[str, float]:
        """Return the forces along x at the four pivots with solid 2 held to the base.

        Each lever is a beam on two supports H apart: with its centre of mass at s from the base
        pivot, F (1 − s/H) acts at the base pivot and F s/H at the upper one.
        """
        if body != "solid-2":
            raise MechanismError("lock", f"'{body}' cannot be locked here", "lock solid-2")
        forces = {}
        for side, (mass, moment) in enumerate(self._lever_sums()):
            upper = moment / self.height * acceleration
            forces[f"F_{2 * side + 1}"] = abs(mass * acceleration - upper)
            forces[f"F_{2 * side + 2}"] = abs(upper)
        return forces

    def body_forces(self, acceleration: float) -> dict[str, tuple[float, str]]:
        """Return the inertial force at the centre of mass of each lever."""
        (first, _), (third, _) = self._lever_sums()
        forces = {"": (first * acceleration, "force at the centre of mass of solid 1")}
        if third != first:
            forces["_solid_3"] = (third * acceleration, "force at the centre of mass of solid 3")
        return forces

    def free_force(self, acceleration: float) -> float:
        """Refuse: without a lock the levers swing and the force follows from their motion."""
        raise MechanismError(
            "lock", "a free parallel stage swings under an acceleration", "add lock: solid-2"
        )

    def hanging_mass(self) -> float:
        """Refuse: the sag of a parallel stage depends on how it stands."""
        raise MechanismError("acceleration", "a parallel stage has no closed form for sag", "")

    def values(self, joint_stiffness: float, geometry: Geometry) -> dict[str, Value]:
        """Return equivalent stiffness, masses and frequencies before and after balancing."""
        k_eq = self.joints * joint_stiffness / self.height**2
        init, final = (self.equivalent_mass(balanced=on) for on in (False, True))
        found = {
            "k_eq": Value(k_eq, "N/m", "equivalent stiffness", source=SOURCE),
            "m_eq_init": Value(init, "kg", "equivalent mass before balancing", source=SOURCE),
            "m_eq_final": Value(final, "kg", "equivalent mass after balancing", source=SOURCE),
            "f_final": Value(
                sqrt(k_eq / final) / (2 * pi), "Hz", "frequency after balancing", source=SOURCE
            ),
        }
        if init > 0.0:
            f_init = sqrt(k_eq / init) / (2 * pi)
            found["f_init"] = Value(f_init, "Hz", "frequency before balancing", source=SOURCE)
        return found
