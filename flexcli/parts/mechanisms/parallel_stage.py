"""Parallel stage of rigid bodies: two levers on the base carry a third body on four pivots."""

from collections.abc import Iterator, Sequence
from functools import cached_property
from math import inf
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from pydantic import BeforeValidator, Field, GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema

from flexcli.formulas.quantity import Computed, Quantity
from flexcli.formulas.transfer import natural_frequency
from flexcli.mechanics import parallel_stage as planar
from flexcli.mechanics.layout import Body, Layout
from flexcli.mechanics.single_freedom import Expansion, SingleFreedom, expand
from flexcli.numerics.rows import number
from flexcli.parts.base import Angle, Mass, QuantityOf, Shorthand, spec_error
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.base import GROUND, Geometry, Sizes
from flexcli.parts.mechanisms.base import Mechanism, MechanismError, Mode, OutOfPlane
from flexcli.parts.mechanisms.force_balance import Balancing, Unknown, balance
from flexcli.parts.mechanisms.free_value import Free, OrFree
from flexcli.parts.mechanisms.inertia_tensor import InertiaTensor
from flexcli.parts.mechanisms.stage_bodies import BalancingMass, Lever, Platform
from flexcli.parts.stroke import Stroke
from flexcli.parts.structure import OwnMotion, PlacedJoint, Structure, assemble, joined, on_joints
from flexcli.results import Note, QuantityKind, Value

__all__ = ["BalancingMass", "Coupling", "InertiaTensor", "Lever", "ParallelStage", "Platform"]

SOURCE = "exercise 9"

ROUNDING = 1e-9
"""Coupling, over that before balancing, that counts as zero."""

PIVOT = QuantityOf("rotational stiffness", at_least=0.0)

SOLID_2 = "solid 2"
"""Name of the body on both levers."""


class Coupling(Shorthand):
    """How much of the coupling to the base may be left; a plain ratio stands for {max: ratio}."""

    stands_for: ClassVar[str] = "max"

    max: Annotated[float, QuantityOf("ratio", at_least=0.0)]
    """Largest coupling that may be left, over that without balancing masses, e.g. ``1 %``."""


class _OneOrFour:
    """A type marker: in a spec one value may stand for all four pivots."""

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        four = {"type": "array", "items": {"anyOf": [PIVOT.json_schema(), {"type": "null"}]}}
        return {"anyOf": [PIVOT.json_schema(), {**four, "minItems": 4, "maxItems": 4}]}


def _four(data: Any) -> Any:
    """Take one stiffness for all pivots, or one for each of P1 to P4 (null: by the geometry)."""
    if not isinstance(data, list):
        return [data] * 4
    if len(data) != 4:
        raise spec_error("there are four pivots", "write one stiffness, or [k_1, k_2, k_3, k_4]")
    return data


class ParallelStage(Mechanism):
    """Solids 1 and 3 on base pivots P1 and P3 carry solid 2 on P2 and P4.

    Arms and masses of balancing masses, or the height of the levers, may be free: they are then
    chosen so that an acceleration of the base leaves solid 2 at rest, for every verb.
    """

    joints: ClassVar[int] = 4
    joint_motion: ClassVar[str | None] = "rotation"

    kind: Literal["parallel-stage"]
    stated_height: Annotated[float | Free, OrFree("length", above=0.0)] = Field(alias="height")
    """Height H of the levers, from base pivot to upper pivot, e.g. ``20 mm``."""
    bisector: Angle = 0.0
    """Angle from x to the axis of symmetry of the pivots, e.g. ``90 deg``."""
    solid_1: Lever = Field(alias="solid-1")
    """Lever on the base pivot P1, e.g. ``{mass: 17.1 g, com: 10.4 mm, inertia: 5.4e-6 kg*m^2}``."""
    solid_2: Platform = Field(alias="solid-2")
    """Body on both levers, which moves along x without turning, e.g. ``{mass: 68 g}``."""
    solid_3: Lever = Field(alias="solid-3")
    """Lever on the base pivot P3, e.g. ``{mass: 17.1 g, com: 10.4 mm, inertia: 5.4e-6 kg*m^2}``."""
    balance_1: BalancingMass | None = Field(None, alias="balance-1")
    """Balancing mass on solid 1, beyond its base pivot,
    e.g. ``{mass: free, arm: 15 mm, inertia: 2e-6 kg*m^2}``.
    """
    balance_3: BalancingMass | None = Field(None, alias="balance-3")
    """Balancing mass on solid 3, beyond its base pivot,
    e.g. ``{mass: free, arm: 15 mm, inertia: 2e-6 kg*m^2}``.
    """
    added_mass: Mass | None = Field(None, alias="added-mass")
    """Sum of both balancing masses, where their split is free,
    e.g. ``added-mass: 120 g, balance-1: {mass: free, arm: 15 mm, inertia: 2e-6 kg*m^2}, balance-3:
    {mass: free, arm: 15 mm, inertia: 2e-6 kg*m^2}``.
    """
    coupling: Coupling | None = None
    """Largest coupling to the base, over that without balancing masses, e.g. ``1 %``."""
    pivot_stiffness: Annotated[
        tuple[Annotated[float, PIVOT] | None, ...] | None, BeforeValidator(_four), _OneOrFour()
    ] = Field(None, alias="pivot-stiffness")
    """Stiffness of the pivots in place of that of the blades: one for all, or one for each of P1
    to P4,
    e.g. ``0.5 N*m/rad``.
    """

    @model_validator(mode="after")
    def _can_be_solved(self) -> "ParallelStage":
        unknowns = tuple(self._unknowns())
        if self.added_mass is not None and not any(u.kind == "split" for u in unknowns):
            raise spec_error(
                "a total is for two balancing masses that are both free",
                "write mass: free in balance-1 and balance-3",
                at=("added-mass",),
            )
        if len(unknowns) > 2:
            raise spec_error(
                "more than two unknowns", "leave free at most two of arm, mass, height"
            )
        self._refuse_unbounded(unknowns)
        if self.equivalent_mass(balanced=True) <= 0.0:
            raise spec_error("nothing that moves has a mass", "give the masses of the solids")
        return self

    def _refuse_unbounded(self, unknowns: tuple[Unknown, ...]) -> None:
        """Refuse two unknowns of which no pair adds the least mass."""
        masses = {side for unknown in unknowns if unknown.kind == "mass" for side in unknown.sides}
        for unknown in unknowns if len(unknowns) == 2 else ():
            together = masses.intersection(unknown.sides)
            if unknown.kind == "arm" and together and unknown.bounds.most is None:
                raise spec_error(
                    "the longer the arm, the smaller the mass: there is no best one",
                    "bound the arm, e.g. {free: [0 mm, 30 mm]}",
                    at=(f"balance-{2 * min(together) + 1}", "arm"),
                )
            if unknown.kind == "height" and None in unknown.bounds:
                raise spec_error(
                    "beside another unknown the height needs bounds",
                    "write e.g. {free: [15 mm, 25 mm]}",
                    at=("height",),
                )

    @property
    def _balances(self) -> tuple[BalancingMass | None, BalancingMass | None]:
        return self.balance_1, self.balance_3

    def _unknowns(self) -> Iterator[Unknown]:
        """Yield the free numbers; a kind that is free on both sides is one common unknown."""
        for kind in ("arm", "mass"):
            free = {
                side: value
                for side, body in enumerate(self._balances)
                if body is not None and isinstance(value := getattr(body, kind), Free)
            }
            if kind == "mass" and len(free) == 2 and self.added_mass:
                bounds = _share(free[0], free[1], self.added_mass)
                yield Unknown("split", (0, 1), bounds, self.added_mass)
            elif free:
                yield Unknown(kind, tuple(free), _both(*free.values()))
        if isinstance(self.stated_height, Free):
            yield Unknown("height", (), self.stated_height)

    @cached_property
    def balancing(self) -> Balancing:
        """Return the stage with its free numbers chosen, and whether it is balanced."""
        height = 1.0 if isinstance(self.stated_height, Free) else self.stated_height
        first, third = (
            planar.Lever(lever.body, planar.NO_BALANCE if body is None else body.body)
            for lever, body in zip((self.solid_1, self.solid_3), self._balances, strict=True)
        )
        stage = planar.Stage(height, self.solid_2.mass, self.solid_2.com, (first, third))
        allowed = self.coupling.max if self.coupling else 0.0
        return balance(stage, tuple(self._unknowns()), allowed)

    def stage(self, *, balanced: bool = True) -> planar.Stage:
        """Return the numbers of the stage, with or without its balancing masses."""
        stage = self.balancing.stage
        return stage if balanced else stage.without_balance()

    @property
    def height(self) -> float:
        """Return H [m]."""
        return self.stage().height

    def at_rest(self, *, balanced: bool) -> Expansion:
        """Return the equation of motion about the rest position, without springs."""
        return expand(planar.system(self.stage(balanced=balanced), ()), order=1)

    def equivalent_mass(self, *, balanced: bool) -> float:
        """Return m_eq [kg]: inertia of the levers about their pivots over H², and solid 2."""
        return self.at_rest(balanced=balanced).mass.value

    def coupling_limit(self) -> tuple[float, float] | None:
        """Return |τ| and its upper limit [kg], where something is free or a bound is stated."""
        if self.coupling is None and not self.balancing.unknowns:
            return None
        allowed = max(self.coupling.max if self.coupling else 0.0, ROUNDING)
        init, final = (self.at_rest(balanced=on).coupling_x.value for on in (False, True))
        return abs(final), allowed * abs(init)

    def notes(self) -> tuple[Note, ...]:
        """Return the reason where the free numbers cannot balance it."""
        solved = self.balancing
        return () if solved.met else (Note("not-balanced", f"{solved.reason}: {solved.remedy}"),)

    def joint_travel(self, stroke: Stroke, geometry: Geometry) -> tuple[float, float]:
        """Return the rotation of each pivot: x/H for a translation x of solid 2."""
        if stroke.motion == "rotation":
            return stroke.amplitude, stroke.mean
        return stroke.amplitude / self.height, stroke.mean / self.height

    @property
    def joint_travel_per_motion(self) -> float:
        """Return 1/H: each pivot turns by x/H."""
        return 1.0 / self.height

    @property
    def states_stiffness(self) -> bool:
        """Return whether any pivot's stiffness is stated."""
        return self.pivot_stiffness is not None

    def stiffnesses(self, joint_stiffness: Quantity | None) -> tuple[Computed, ...]:
        """Return k_1 to k_4: as stated, else of the joint."""
        stated = self.pivot_stiffness or (None,) * self.joints
        return tuple(joint_stiffness if k is None else k for k in stated)

    def mode(self, joint_stiffness: Quantity, geometry: Geometry) -> Mode:
        """Return k_eq = Σk/H² and m_eq with the balancing masses on."""
        k_1, *others = self.stiffnesses(joint_stiffness)
        return Mode(sum(others, k_1) / self.height**2, self.equivalent_mass(balanced=True))

    def freedom(
        self,
        joint_stiffness: float,
        geometry: Geometry,
        *,
        balanced: bool = True,
        shift: float = 0.0,
    ) -> SingleFreedom:
        """Return the stage on the angle of its levers; all pivots shift along their bisector."""
        return planar.system(
            self.stage(balanced=balanced),
            self.stiffnesses(joint_stiffness),
            shift=shift,
            direction=self.bisector,
        )

    def locked_forces(self, body: str, acceleration: float) -> dict[str, float]:
        """Return the forces along x at the four pivots with solid 2 held to the base.

        Each lever is a beam on two supports H apart: with its centre of mass at s from the base
        pivot, F (1 − s/H) acts at the base pivot and F s/H at the upper one.
        """
        if body != "solid-2":
            raise MechanismError("lock", f"'{body}' cannot be locked here", "lock solid-2")
        forces = {}
        for side, lever in enumerate(self.stage().levers):
            upper = lever.moment / self.height * acceleration
            forces[f"F_{2 * side + 1}"] = abs(lever.mass * acceleration - upper)
            forces[f"F_{2 * side + 2}"] = abs(upper)
        return forces

    def body_forces(self, acceleration: float) -> dict[str, tuple[float, str]]:
        """Return the inertial force at the centre of mass of each lever."""
        first, third = (lever.mass for lever in self.stage().levers)
        forces = {"": (first * acceleration, "force at the centre of mass of solid 1")}
        if third != first:
            forces["_solid_3"] = (third * acceleration, "force at the centre of mass of solid 3")
        return forces

    def free_force(self, acceleration: float) -> float:
        """Refuse: without a lock the levers swing and the force follows from their motion."""
        raise MechanismError(
            "lock", "a free parallel stage swings under an acceleration", "add lock: solid-2"
        )

    def structure(
        self,
        geometry: Geometry,
        elastic: Elastic,
        sizes: Sizes,
        lock: str | None,
        density: float = 0.0,
        *,
        thick: bool = False,
    ) -> Structure:
        """Return the stage in its plane: levers along y, P1 and P3 on the base, x the stroke."""
        if lock not in (None, "solid-2"):
            raise MechanismError("lock", f"'{lock}' cannot be locked here", "lock solid-2")
        if self.pivot_stiffness is not None:
            raise MechanismError(
                "asd",
                "the modes are those of the blades, not of a stated pivot-stiffness",
                "take pivot-stiffness out, and give the blades",
            )
        return self._structure(geometry, elastic, sizes, lock, density, thick=thick)

    def _structure(
        self,
        geometry: Geometry,
        elastic: Elastic,
        sizes: Sizes,
        lock: str | None,
        density: float,
        *,
        thick: bool = False,
    ) -> Structure:
        """Return the stage on its blades, ignoring any stated stiffness."""
        bodies, joints = self.placed(lock)
        platform = bodies[-1].name
        return assemble(
            bodies,
            joints,
            geometry.blades_layout(elastic, sizes),
            None if lock else OwnMotion(platform, (1.0, 0.0, 0.0), "travel"),
            density=density,
            thick=thick,
            held=() if lock else [(platform, 2)],
        )

    def placed(self, lock: str | None, apart: float = 0.0) -> tuple[list[Body], list[PlacedJoint]]:
        """Return the bodies in the plane, solid 2 last unless it is locked, and their pivots.

        A lever with its balancing mass is one rigid body. The two levers stand as far apart as
        one likes: solid 2 is kept from turning by them, so that the distance does not matter.
        """
        bodies, joints = [], []
        platform = GROUND if lock else SOLID_2
        for side, lever in enumerate(self.stage().levers):
            name, x = f"solid {2 * side + 1}", side * apart
            body = joined(name, (0.0, 0.0), lever.bodies)
            bodies.append(body._replace(point=(x, 0.0), com=(x + body.com[0], body.com[1])))
            for joint, first, y in (
                (f"P{2 * side + 1}", GROUND, 0.0),
                (f"P{2 * side + 2}", platform, self.height),
            ):
                joints.append(PlacedJoint(joint, first, name, (x, y), self.bisector))
        if lock is None:
            com = (0.5 * apart, self.height)
            bodies.append(Body(platform, (0.0, 0.0), self.solid_2.mass, 0.0, com))
        return bodies, joints

    def layout(
        self, joint: Layout, lock: str | None, apart: float
    ) -> tuple[Layout, list[PlacedJoint]]:
        """Return the stage on copies of a joint, its levers so far apart [m], and the copies."""
        bodies, joints = self.placed(lock, apart)
        return on_joints(bodies, joints, joint), joints

    def out_of_plane(self, joint: Layout, lock: str | None) -> OutOfPlane:
        """Return both levers on their pivots, solid 2 held in every direction by its lock."""
        if lock is None:
            text = "is between levers whose distance out of their plane the spec does not state"
            raise NotAvailable(text)
        layout, _ = self.layout(joint, lock, 0.0)
        sides = zip((self.solid_1, self.solid_3), self._balances, self.stage().levers, strict=True)
        inertia = {}
        for body, (solid, added, lever) in zip(layout.bodies, sides, strict=False):
            tensors = [solid.inertia] if added is None else [solid.inertia, added.inertia]
            found = _tilting(tensors, lever.bodies, body)
            if found is not None:
                inertia[body.name] = found
        return OutOfPlane(layout, inertia, self.height)

    def blades_in_motion(
        self, geometry: Geometry, elastic: Elastic, sizes: Sizes, density: float
    ) -> float:
        """Return the mass that the blades add to m_eq, by their static shapes [kg].

        Raises
        ------
        NotAvailable
            When the pivots are not made of blades in a plane.

        """
        light, heavy = (
            self._structure(geometry, elastic, sizes, None, rho) for rho in (0.0, density)
        )
        # both levers turn by −1/H about their base pivots while solid 2 moves by one
        motion = np.zeros(heavy.mass.shape[0])
        motion[[2, 5]], motion[6] = -1.0 / self.height, 1.0
        size = light.mass.shape[0]
        motion[size:] = 0.0
        return number(motion @ heavy.mass @ motion - motion[:size] @ light.mass @ motion[:size])

    def hanging_mass(self) -> float:
        """Refuse: the sag of a parallel stage depends on how it stands."""
        raise MechanismError("acceleration", "a parallel stage has no closed form for sag", "")

    def values(self, joint_stiffness: float, geometry: Geometry) -> dict[str, Value]:
        """Return equivalent stiffness, masses and frequencies before and after balancing."""
        k_eq = number(self.mode(joint_stiffness, geometry).stiffness)
        init, final = (self.equivalent_mass(balanced=on) for on in (False, True))
        found = self.balance_values() if self.coupling_limit() is not None else {}
        found |= self.mass_values()
        found["k_eq"] = Value(
            k_eq, "N/m", "equivalent stiffness", source=SOURCE, kind=QuantityKind.STIFFNESS
        )
        f_final = natural_frequency(k_eq, final)
        found["f_final"] = Value(
            f_final, "Hz", "frequency after balancing", source=SOURCE, kind=QuantityKind.FREQUENCY
        )
        if init > 0.0:
            f_init = natural_frequency(k_eq, init)
            found["f_init"] = Value(
                f_init,
                "Hz",
                "frequency before balancing",
                source=SOURCE,
                kind=QuantityKind.FREQUENCY,
            )
        return found

    def mass_values(self) -> dict[str, Value]:
        """Return the equivalent masses."""
        init, final = (self.equivalent_mass(balanced=on) for on in (False, True))
        return {
            "m_eq_init": Value(init, "kg", "equivalent mass before balancing", source=SOURCE),
            "m_eq_final": Value(final, "kg", "equivalent mass after balancing", source=SOURCE),
        }

    def balance_values(self) -> dict[str, Value]:
        """Return arms and masses of the balancing masses, and the coupling they leave."""
        found: dict[str, Value] = {}
        masses = {
            number: lever.balance
            for number, lever in zip((1, 3), self.stage().levers, strict=True)
            if lever.balance != planar.NO_BALANCE
        }
        for symbol, unit, label, sizes in (
            ("l_bal", "m", "arm of", {n: -each.com[1] for n, each in masses.items()}),
            ("m_bal", "kg", "mass of", {n: each.mass for n, each in masses.items()}),
        ):
            if len(sizes) == 2 and len(set(sizes.values())) == 1:
                found[symbol] = Value(sizes[1], unit, f"{label} each balancing mass", source=SOURCE)
            else:
                found |= {
                    f"{symbol}_{n}": Value(size, unit, f"{label} balance-{n}", source=SOURCE)
                    for n, size in sizes.items()
                }
        if isinstance(self.stated_height, Free):
            found["H"] = Value(self.height, "m", "height of the levers", source=SOURCE)
        init, final = (self.at_rest(balanced=on).coupling_x.value for on in (False, True))
        text = "coupling to the base's acceleration"
        found["tau_coupling_init"] = Value(init, "kg", f"{text} before balancing", source=SOURCE)
        found["tau_coupling"] = Value(final, "kg", f"{text} after balancing", source=SOURCE)
        return found


def _tilting(
    tensors: Sequence[InertiaTensor], bodies: Sequence[Body], whole: Body
) -> tuple[float, float] | None:
    """Return the inertia of several bodies as one about x and y through its centre [kg·m²].

    There is none where one of them does not state its own.
    """
    about_x = about_y = 0.0
    for tensor, body in zip(tensors, bodies, strict=False):
        if tensor.xx is None or tensor.yy is None:
            return None
        about_x += tensor.xx + body.mass * (body.com[1] - whole.com[1]) ** 2
        about_y += tensor.yy + body.mass * (body.com[0] - whole.com[0]) ** 2
    return about_x, about_y


def _both(first: Free, *others: Free) -> Free:
    """Return the bounds that hold for all."""
    least = [free.least for free in (first, *others) if free.least is not None]
    most = [free.most for free in (first, *others) if free.most is not None]
    return Free(max(least, default=None), min(most, default=None))


def _share(first: Free, third: Free, total: float) -> Free:
    """Return the bounds on side 1's share of a total that leave both masses in theirs."""
    least = max(first.least or 0.0, total - (inf if third.most is None else third.most))
    most = min(inf if first.most is None else first.most, total - (third.least or 0.0))
    return Free(max(least / total, 0.0), min(most / total, 1.0))
