"""The exact model of a joint of limbs between two notches, their stiffness and stresses of solids.

A limb, its two notches and the blocks outside them are one solid that is its own mirror image in
three planes. What a case does to a joint of them is what exact beams say, in the plane and at a
stroke; what the stroke itself does is that of the solids, which share what acts across it.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.exact_with_solids import (
    ALIKE,
    ALONG,
    MOMENT,
    SWING,
    ExactWithSolids,
    SolidUnderLoads,
    Wrenches,
    beside_throat,
    compliance_ends,
    either_way,
    ends_and_middle,
    meshed,
    of_larger_bodies,
)
from flexcli.engine.joint_models.joint_states import at_rest, blades_of, solved
from flexcli.formulas.blade_spring import BladeSprings
from flexcli.mechanics.solids.limb import about
from flexcli.mechanics.solids.unit_loads import COARSE, FINE, equivalent
from flexcli.mechanics.space.linear import Moved, SpaceAssembly
from flexcli.mechanics.space.springs import STRIP_CONSTRAINTS, MemberSprings
from flexcli.mechanics.space.states import Acting, action, misfitted
from flexcli.numerics.rows import number, one_alone
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING, LimbSpan, NeckSizes
from flexcli.parts.requirements import Ask, MisfitStress, Told
from flexcli.parts.space_joint import SpaceJoint, joint_in_space
from flexcli.parts.space_misfits import guided_about
from flexcli.parts.spring_limits import changed_by_springs
from flexcli.parts.stress_across import acting_across
from flexcli.results import EXACT, ErrorRange

__all__ = ["ExactWithLimbs"]

Floats = NDArray[np.float64]

BENDS = ((SWING, MOMENT), (2, 4))
"""Forces across a limb, and the moments by which they bend its hinges."""

PLANAR = [ALONG, SWING, MOMENT]
"""What a limb bears in the plane, among six."""

THINNEST = 0.01
"""Least thickness of a throat over the depth of its notch: of thinner ones few digits are left,
and beams know them."""

SHORTEST = 0.02
"""Least share of a limb that is a bar: no shorter one was compared."""

SHEARED = 1.2
"""1/κ of a rectangle in shear."""

SMALL = 1e-4
"""Rotation of a hinge by which the forces of a small stroke are found [rad]: their square is lost
among the digits of the equilibrium."""

BARELY = 1e-6
"""Share of the largest moment in a throat below which it is of no account."""


class ExactWithLimbs(ExactWithSolids):
    """Exact beams, between whose bodies each limb is a solid."""

    at_rest = "solid of each limb, its notches and the blocks beside them, at rest"
    at_stroke = "solids of limbs, what size changes of them by exact beams in space"

    def _limb(self, ask: Ask) -> tuple[NeckSizes, LimbSpan]:
        """Return the sizes of a limb, where there are solids of such ones."""
        sizes = ask.geometry.neck(ask.sizes)
        limb = sizes.limb
        if limb is None:
            raise NotAvailable("has no limbs, of which there are solids")
        if sizes.e < THINNEST * sizes.depth:
            raise NotAvailable("has throats too thin for solids of limbs, which leave it to beams")
        if limb.l - sizes.l < SHORTEST * limb.l:
            raise NotAvailable("has limbs whose notches almost meet, of which there are no solids")
        return sizes, limb

    def _springs_by(self, ask: Ask, loads: Sequence[int]) -> tuple[MemberSprings, ...]:
        """Return springs by the compliances of a limb to these unit loads, one for each of six.

        They stand where two equal ones give way as the whole limb does. A force across a limb
        bends its hinges by the moment that it has there: they stand as far apart as makes it what
        the solid has, and shear as if they were stretched.
        """
        one_alone()
        sizes, limb = self._limb(ask)
        layout = joint_in_space(ask.geometry, ask.material, ask.sizes).layout
        each = self._compliances(ask, loads)
        C, off = np.array([C / 2.0 for C, _ in each]), np.array([error for _, error in each])
        arms = []
        for across, turn in BENDS:
            square = (C[across] - C[ALONG]) / C[turn]
            if square <= 0.0:
                raise NotAvailable("has no solid of limbs that shear more than they bend")
            arms.append(float(np.sqrt(square)))
            C[across] = C[ALONG]
            off[[across, turn]] = max(off[across], off[turn])
        found = []
        for index, blade in enumerate(layout.blades):
            # the middle of the limb lies beyond an inner hinge and before an outer one
            side = 1.0 if index % 2 == 0 else -1.0
            middle = sizes.l / 2.0 + side * limb.l / 2.0
            at = (np.asarray(middle - side * arm) for arm in arms)
            springs = BladeSprings(1.0 / C, *at)
            found.append(MemberSprings(springs, -off, off, blade.axes, sizes.l, STRIP_CONSTRAINTS))
        return tuple(found)

    def _least_and_most(self, ask: Ask, index: int) -> tuple[float, float]:
        """Return the ends of a compliance, of massive blocks those of bars that turn as far.

        A force across the limb moves the end of a bar farther than a mouth that turns as much.
        """
        sizes, limb = self._limb(ask)
        if index != SWING or sizes.turning == sizes.blocks:
            return super()._least_and_most(ask, index)
        least, most = compliance_ends(self._solids(ask).turning, index)
        E, nu = number(ask.material.elastic.E), number(ask.material.elastic.nu)
        L, H, x = min(sizes.turning), sizes.e + 2.0 * sizes.depth, (limb.l + sizes.l) / 2.0
        farther = ((x + L) ** 3 - x**3) / 3.0 - L * x**2
        beyond = 12.0 * farther / H**3 + SHEARED * 2.0 * (1.0 + nu) * L / H
        return least - 2.0 * beyond / (E * sizes.b), most

    def _joint(self, ask: Ask) -> SpaceJoint:
        """Return the joint in space with its solids."""
        layout = joint_in_space(ask.geometry, ask.material, ask.sizes).layout
        return SpaceJoint(layout, self.springs(ask, in_plane=False))

    def _beams(self, ask: Ask) -> Floats:
        """Return the six compliances of a limb of beams about its middle, of an inner hinge."""
        sizes, limb = self._limb(ask)
        joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
        springs, middle = joint.assembly.members[0].springs, (sizes.l + limb.l) / 2.0
        C = 2.0 / springs.stiffness
        places = springs.across_thickness, springs.across_width
        for (across, turn), place in zip(BENDS, places, strict=True):
            C[across] += C[turn] * (middle - float(place)) ** 2
        return np.asarray(C)

    def _joint_in_plane(self, ask: Ask) -> SpaceJoint:
        """Return it for what does not leave its plane."""
        layout = joint_in_space(ask.geometry, ask.material, ask.sizes).layout
        return SpaceJoint(layout, self.springs(ask, in_plane=True))

    def _settled_stiffness(self, ask: Ask) -> tuple[float, float]:
        if ask.scene.temperature is not None:
            raise NotAvailable("has no solid at a temperature")
        joint = self._joint_in_plane(ask)
        K, soft, stiff = (
            float(_driven(each).drive[0])
            for each in (joint.assembly, joint.softest, joint.stiffest)
        )
        return K, max(stiff / K - 1.0, 1.0 - soft / K)

    def _hinge_turn(self, ask: Ask, travel: float) -> float:
        return self._turn_per_travel(self._joint_in_plane(ask)) * travel

    def _turn_per_travel(self, joint: SpaceJoint) -> float:
        bent = _driven(joint.assembly).deformations[: 6 * len(joint.layout.blades), 0]
        return float(np.abs(bent.reshape(-1, 6)[:, MOMENT]).max())

    def _wrenches(self, ask: Ask, beam: float) -> Wrenches:
        """Return what each limb bears about its middle, as either of its hinges has it."""
        scene = ask.scene
        joint = self._joint(ask) if scene.across_by else self._joint_in_plane(ask)
        hinges = len(joint.layout.blades)
        planar = np.zeros((hinges, 2 if scene.moves else 1, 6))
        unsure = np.zeros(6), np.zeros(6)
        if scene.moves or scene.is_loaded:
            planar, unsure = self._in_plane(ask, joint)
        acting = acting_across(joint, scene)
        groups = [self._about_middles(ask, joint, _acted(each)(joint.assembly)) for each in acting]
        each = either_way(groups, (hinges, 6))
        wrenches = planar[None] + each[:, :, None]
        across = np.broadcast_to(each[:, :, None], wrenches.shape)
        shares = self._shares(ask) if groups else (0.0, 0.0)
        for load in acting:
            off = self._apart(ask, joint, _acted(load)).max(axis=0)
            unsure = unsure[0] + off, unsure[1] + shares[1] * off
        # the throat of an inner hinge lies before the middle of its limb
        ends = np.broadcast_to(-_sides(hinges)[:, None], wrenches.shape[:-1])
        return Wrenches(
            wrenches.reshape(-1, 6), unsure, across.reshape(-1, 6), shares, ends.ravel()
        )

    def misfit_stresses(
        self, ask: Ask, small: Sequence[MisfitStress]
    ) -> Iterator[tuple[Told, str]]:
        """Yield the largest stress of each missed seat by solids, what its size changes by beams.

        Restrained warping, of which beams are unsure, is that of the solids.
        """
        from flexcli.engine.joint_models.space_exact import SpaceExactModel
        from flexcli.engine.joint_models.space_misfit import StressModel, misfit_stresses

        self._limb(ask)
        for solid in self._solids(ask).turning:  # whose stresses are asked for besides
            solid.solve(range(6))
        joint, beams = self._joint(ask), SpaceExactModel()
        each = [self._misfit_stress(ask, joint, one) for one in small]
        return misfit_stresses(
            ask, each, StressModel(beams.blades, beams.largest_stress, lambda *_: EXACT)
        )

    def _misfit_stress(self, ask: Ask, joint: SpaceJoint, one: MisfitStress) -> MisfitStress:
        """Return the stress of a missed seat at the surface of limbs, by small motion.

        It is in the middle of what it is with the shortest blocks that they may have and with the
        longest. A seat is off as by a cut through its limb, which nothing else acts on: whatever
        bends there, it bears what the whole of it does at its middle.
        """
        if one.stress == 0.0:
            return one
        kept = guided_about(ask.geometry)

        def forces(assembly: SpaceAssembly) -> Floats:
            return np.asarray(misfitted(assembly, one.missed, kept=kept).moved.forces[:, 0])

        wrenches = self._about_middles(ask, joint, forces(joint.assembly))
        whole = np.abs(wrenches).max(axis=0)
        higher, none = of_larger_bodies(ask) * whole, np.zeros(6)
        borne = Wrenches(wrenches, (none, none), np.zeros_like(wrenches), (0.0, 0.0))
        springs = np.flatnonzero(whole > BARELY * whole.max()).tolist()
        found, off = list[float](), 0.0
        for solid in self._solids(ask).turning:
            fine, coarse = (_largest(solid, wrenches, orders) for orders in (FINE, COARSE))
            beside_throat(solid, wrenches, fine)
            by_mesh = max(abs(fine - coarse), meshed(solid, whole))
            unsure = (by_mesh + self._unsure(solid, borne, higher, 0.0)) / fine
            size = partial(self._stress_by, ask, joint, solid, forces)
            change = changed_by_springs(joint, springs, size)
            if change is None:
                raise NotAvailable("has limbs of more than one shape")
            off = max(off, unsure + change.largest)
            found.append(fine)
        middle = (min(found) + max(found)) / 2.0
        off = (1.0 + off + ALIKE) * max(found) / middle - 1.0
        name = joint.layout.blades[one.missed.blade].name
        error = ErrorRange(-off, off)
        return one._replace(
            stress=middle, where=f"surface of a limb, {name} being off", springs=error, error=error
        )

    def _stress_by(
        self,
        ask: Ask,
        joint: SpaceJoint,
        solid: SolidUnderLoads,
        forces: Callable[[SpaceAssembly], Floats],
        assembly: SpaceAssembly,
    ) -> float:
        """Return the largest stress of a limb by the forces in an assembly's springs [Pa]."""
        return _largest(solid, self._about_middles(ask, joint, forces(assembly)), COARSE)

    def _in_plane(self, ask: Ask, joint: SpaceJoint) -> tuple[Floats, tuple[Floats, Floats]]:
        """Return what the stroke and the loads in the plane do, (hinges, states, 6).

        With it comes what that, and the amplitude of it, may be off by (6,) [N, N·m].
        """
        scene, states = ask.scene, self.states(ask)
        sections = np.stack([ends_and_middle(states, k) for k in range(len(joint.layout.blades))])
        middle, bowed = self._transported(ask, sections)
        travels = np.zeros(middle.shape[1])
        if scene.moves:
            travels = np.tile(scene.stroke_ends, middle.shape[1] // 2)
        beams = self._beams_per_travel(ask, joint)
        solids = self._about_middles(ask, joint, _driven(joint.assembly).forces[:, 0])
        planar = np.zeros((*middle.shape[:2], 6))
        planar[..., PLANAR] = middle + (solids[:, PLANAR] - beams)[:, None] * travels[:, None]
        # what is not the stroke's small motion is as soft in solids, or as stiff, as that is
        throats, of_beams = self._in_throats(ask, solids[:, PLANAR]), self._in_throats(ask, beams)
        felt = np.abs(of_beams) > BARELY * np.abs(of_beams).max()
        ratio = float(np.abs(throats[felt] / of_beams[felt] - 1.0).max())
        rest = self._in_throats(ask, middle - beams[:, None] * travels[:, None])
        beside = bowed + ratio * float(np.abs(rest).max())
        turned = self._turned(self._turn_per_travel(joint) * float(np.abs(travels).max()))
        off = self._apart(ask, joint, lambda each: _driven(each).forces[:, 0])
        off = (off + turned * np.abs(solids)).max(axis=0)
        ends = (off * float(most) for most in (np.abs(travels).max(), scene.travel))
        whole, swing = (each + beside * (np.arange(6) == MOMENT) for each in ends)
        return planar, (whole, swing)

    def _transported(self, ask: Ask, sections: Floats) -> tuple[Floats, float]:
        """Return N, Q [N] and M [N·m] about the middle of the limb, as each hinge has them.

        The limb is straight between its hinges; by how much the moment in a throat is another one
        than that [N·m] comes with it.
        """
        sizes, limb = self._limb(ask)
        side = _sides(len(sections))[:, None]
        # from the limb's middle to the end of a hinge that is on the limb
        near = -side * (limb.l - sizes.l) / 2.0
        inner = (side > 0.0)[..., None]
        middle = np.where(inner, sections[:, :, -1, 1:], sections[:, :, 0, 1:])
        middle[..., 2] += near * middle[..., 1]
        bowed = np.abs(sections[:, :, 1, 3] - self._in_throats(ask, middle))
        return middle, float(bowed.max())

    def _in_throats(self, ask: Ask, planar: Floats) -> Floats:
        """Return the moments in the throats [N·m] of N, Q and M about the middles of limbs."""
        _, limb = self._limb(ask)
        side = _sides(len(planar)).reshape(-1, *(1,) * (planar.ndim - 2))
        return np.asarray(planar[..., 2] + side * limb.l / 2.0 * planar[..., 1])

    def _beams_per_travel(self, ask: Ask, joint: SpaceJoint) -> Floats:
        """Return N, Q and M about the middles of limbs by a small stroke of beams, per travel."""
        layout, _ = at_rest(ask, self.effects)
        travel = SMALL / self._turn_per_travel(joint)
        ends = []
        for way in (travel, -travel):
            held = {MOVING: ask.geometry.held(way)}
            effects = blades_of(layout, self.effects)
            state = solved(
                layout, held, effects=effects, tolerance=self.tolerance, levels=self.levels
            )
            hinges = range(len(joint.layout.blades))
            sections = np.stack([ends_and_middle(state, k) for k in hinges])
            ends.append(self._transported(ask, sections)[0][:, 0])
        return np.asarray((ends[0] - ends[1]) / (2.0 * travel))

    def _about_middles(self, ask: Ask, joint: SpaceJoint, forces: Floats) -> Floats:
        """Return forces of the hinges' springs about the middles of their limbs (hinges, 6)."""
        sizes, limb = self._limb(ask)
        each = forces[: 6 * len(joint.layout.blades)].reshape(-1, 6)
        middle = sizes.l / 2.0 + _sides(len(each)) * limb.l / 2.0
        at = [m.springs for m in joint.assembly.members]
        thick = np.array([float(springs.across_thickness) for springs in at])
        wide = np.array([float(springs.across_width) for springs in at])
        found = about(each, middle - thick)
        found[:, 4] = about(each, middle - wide)[:, 4]
        return found

    def _apart(
        self, ask: Ask, joint: SpaceJoint, forces: Callable[[SpaceAssembly], Floats]
    ) -> Floats:
        """Return by how much what limbs bear differs with the errors of their springs (hinges, 6).

        Springs of the same kind are at their limit together.
        """
        here = self._about_middles(ask, joint, forces(joint.assembly))
        found = np.zeros_like(here)
        for kind in range(6):
            each = []
            for limits in (joint.low, joint.high):
                factors = np.ones(len(joint.assembly.stiffness))
                factors[kind::6] += limits[kind::6]
                other = forces(joint.assembly.scaled(factors))
                each.append(np.abs(self._about_middles(ask, joint, other) - here))
            found += np.maximum(*each)
        return found


def _largest(solid: SolidUnderLoads, wrenches: Floats, orders: tuple[int, int, int]) -> float:
    """Return the largest stress at the surface of a solid that bears any of some wrenches [Pa]."""
    stress, is_last = solid.stresses(wrenches, orders)
    each = np.abs(equivalent(stress)).max(axis=0)
    if is_last[int(np.argmax(each))]:
        raise NotAvailable("has its largest stress where a rigid body begins")
    return float(each.max())


def _sides(hinges: int) -> Floats:
    """Return 1 for inner hinges, whose limb lies beyond them, and −1 for outer ones."""
    return np.where(np.arange(hinges) % 2 == 0, 1.0, -1.0)


def _driven(assembly: SpaceAssembly) -> Moved:
    """Return how a travel of one moves the joint."""
    return assembly.moved(travel=np.array([1.0]))


def _acted(acting: Acting) -> Callable[[SpaceAssembly], Floats]:
    """Return what finds the forces of the springs under a load."""
    return lambda assembly: action(assembly, acting).moved.forces[:, 0]
