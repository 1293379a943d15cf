"""The exact model of a single notch, its stiffness and stresses those of solids.

At rest a notch is the solid: six compliances between its blocks, and the stresses all over its
surface under six unit loads. What a case bears is what exact beams say, in the plane and at a
stroke; the moment of the stroke itself is that of the solid.
"""

from collections.abc import Sequence
from functools import partial
from itertools import product
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.joint_models.remembered import Remembered
from flexcli.engine.joint_models.solid_at_rest import SolidAtRest
from flexcli.engine.joint_models.space_deflection import Springs, deflections
from flexcli.engine.joint_models.space_errors import AT_STROKE, HINGE_TURN
from flexcli.errors import SolveError
from flexcli.formulas.fillet import above_bars
from flexcli.formulas.quantity import Computed
from flexcli.formulas.rigid_motion import axes_about_z, motion_along
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.section_forces import flexible_pieces, section_forces
from flexcli.mechanics.solids.limb import RigidLimb
from flexcli.mechanics.solids.neck import Neck
from flexcli.mechanics.solids.unit_loads import (
    COARSE,
    FINE,
    NeckUnderLoads,
    equivalent,
    neck_under_loads,
    sides,
)
from flexcli.mechanics.space.springs import MemberSprings, springs_of
from flexcli.mechanics.state import Equilibrium
from flexcli.numerics.rows import number, one_alone
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import Buckled, NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements import Ask, Bent, DriveEffort, EndStress
from flexcli.parts.space_joint import joint_in_space
from flexcli.parts.stress_across import acting_across, changed_across
from flexcli.parts.worst_places import worst_places
from flexcli.results import ErrorRange, QuantityKind

__all__ = [
    "ALIKE",
    "MOMENT",
    "ExactWithSolids",
    "SolidUnderLoads",
    "Wrenches",
    "beside_throat",
    "compliance_ends",
    "either_way",
    "ends_and_middle",
    "meshed",
    "of_larger_bodies",
]

Floats = NDArray[np.float64]

WHOLE = frozenset(
    {
        EffectName.SHEAR,
        EffectName.AXIAL_EXTENSION,
        EffectName.PLATE_WIDENING,
        EffectName.WARPING,
        EffectName.CLAMP_STRESS,
        EffectName.CLAMP_COMPLIANCE,
        EffectName.THICK_NOTCH,
    }
)
"""What a solid has that beams lack or may leave out."""

TURN, MOMENT = 5, 5
"""Rotation and moment of the stroke, among six."""

ALONG, SWING = 0, 1
"""A force along a notch or a limb, and one across it in the plane, among six."""

AS_IN_PLANE = (ALONG, SWING, SWING, MOMENT, MOMENT, MOMENT)
"""Unit loads that stand for all six where nothing acts across the plane: a motion in it strains no
spring across it."""

SMALL_TURN = 0.087
"""Rotation [rad] up to which what a stroke adds to the error grows with it; there CalculiX's solids
had, with large motion, the ratio to beams that they have at rest, within 0.01."""

STIFFEST_NU = 0.49
"""Largest Poisson's ratio: beyond, solids lock."""

ALIKE = 3e-3
"""Of a stress, what two meshes may be off together besides: where both told as good as the same,
finer ones were within 0.0027 of them."""

CLEAR = 0.8
"""Largest nominal stress of a mouth that is clamped over that beside the throat, up to which the
latter surely is the larger, but for the edges of a rigid body."""

FEWEST = 1e-12
"""Share of the largest stress that is rounding."""


SLENDEREST = 350.0
"""Longest straight stretch over the thickness: beyond, rounding is more than the meshes tell,
at 700 a fifth of the stiffness."""


class Wrenches(NamedTuple):
    """What the solid bears about its middle in the states of a case, along its axes (states, 6).

    ``unsure`` (6,) [N, N·m] is what that may be off by, and what the amplitude of that may;
    ``across`` (states, 6) is the part that acts out of the plane, ``shares`` what a stroke may
    change of it, and what it may alternate by. ``sides`` (states,) tell which side of the middle
    bears it, 1 or −1, where what is between bears another: a limb that weighs something.
    """

    wrenches: Floats
    unsure: tuple[Floats, Floats]
    across: Floats
    shares: tuple[float, float]
    sides: Floats | None = None


SolidUnderLoads: TypeAlias = NeckUnderLoads | RigidLimb


class _Solids(NamedTuple):
    """The solids that a notch or a limb may be, by the shortest and the longest blocks beside it.

    ``turning`` are those that turn as far, and have the stresses.
    """

    blocks: tuple[SolidUnderLoads, ...]
    turning: tuple[SolidUnderLoads, ...]


class _Worst(NamedTuple):
    """The worst places of a notch, its largest stress and its largest amplitude [Pa]."""

    places: list[EndStress]
    largest: float
    amplitude: float


class ExactWithSolids(SolidAtRest):
    """Exact beams between which and its moving body a notch is a solid."""

    always = ExactModel.always | WHOLE
    weighs_blades = False
    at_rest = "solid of the notch and the blocks beside it, at rest"

    def __init__(self, effects: Effects | None = None) -> None:
        super().__init__(effects)
        self._known_solids: Remembered[_Solids] = Remembered()
        self._known_springs: Remembered[tuple[MemberSprings, ...]] = Remembered()

    def springs(self, ask: Ask, *, in_plane: bool) -> tuple[MemberSprings, ...]:
        """Return the six springs of the solid, or those that are strained in the plane."""
        loads = AS_IN_PLANE if in_plane else tuple(range(6))
        find = partial(self._springs_by, ask, loads)
        return self._known_springs.of("in plane" if in_plane else "springs", ask, find)

    def _springs_by(self, ask: Ask, loads: Sequence[int]) -> tuple[MemberSprings, ...]:
        """Return springs by the compliances to these unit loads, one for each of six."""
        one_alone()
        layout = joint_in_space(ask.geometry, ask.material, ask.sizes).layout
        member = springs_of(layout.blades[0])
        middle = np.asarray(member.l / 2.0)
        each = self._compliances(ask, loads)
        stiffness = np.array([1.0 / C for C, _ in each])
        off = np.array([error for _, error in each])
        springs = member.springs._replace(
            stiffness=stiffness, across_thickness=middle, across_width=middle
        )
        return (MemberSprings(springs, -off, off, member.axes, member.l, member.constrains),)

    def _settled_stiffness(self, ask: Ask) -> tuple[float, float]:
        if ask.scene.temperature is not None:
            raise NotAvailable("has no solid at a temperature")
        C, error = self._compliance(ask, TURN)
        return 1.0 / C, error

    def _compliance(self, ask: Ask, index: int) -> tuple[float, float]:
        """Return a compliance of the solid, and the relative error of one over it.

        It is between those with the shortest and the longest blocks that it may have.
        """
        least, most = self._least_and_most(ask, index)
        middle = 2.0 / (1.0 / least + 1.0 / most)
        return middle, middle / least - 1.0

    def _compliances(self, ask: Ask, loads: Sequence[int]) -> list[tuple[float, float]]:
        """Return compliances of the solid to several loads, and their errors."""
        found = self._solids(ask)
        for solid in found.blocks:
            solid.solve(index for index in loads if index != TURN)
        for solid in found.turning:
            solid.solve(index for index in loads if index == TURN)
        return [self._compliance(ask, index) for index in loads]

    def _least_and_most(self, ask: Ask, index: int) -> tuple[float, float]:
        blocks, turning = self._solids(ask)
        return compliance_ends(turning if index == TURN else blocks, index)

    def _judged(self, ask: Ask) -> tuple[list[EndStress], float]:
        try:
            return super()._judged(ask)
        except SolveError as error:
            raise NotAvailable(f"has no solid: {error}") from error

    def effort(self, ask: Ask) -> tuple[DriveEffort, ...]:
        """Return what holds the joint at both ends: that of beams, the stroke's as the solid's."""
        if ask.scene.across_by:
            raise NotAvailable("has no force at stroke by solids under loads out of its plane")
        found, (K, _) = [], self._stiffness(ask)
        beam = self._beam(ask)
        K_error = self.error(ask, QuantityKind.STIFFNESS)
        for travel, effort, error, load in super().effort(ask):
            more = (K - beam) * abs(travel)
            if error is None or K_error is None or effort + more == 0.0:
                found.append(DriveEffort(travel, effort + more, None, load))
                continue
            turned = self._turned(self._hinge_turn(ask, abs(travel)))
            off = K * abs(travel) * (K_error.largest + turned)
            off += abs(K / beam - 1.0) * abs(abs(effort) - beam * abs(travel))
            off = off / abs(effort + more) + error.largest
            found.append(DriveEffort(travel, effort + more, ErrorRange(-off, off), load))
        return tuple(found)

    def _judge_stress(self, ask: Ask) -> tuple[list[EndStress], float]:
        """Return the worst places of the surface, and by how much their stress may be off.

        Places are those with the shortest blocks on the finer mesh, their stress is in the middle
        of that with these and with the longest. The error is the rest, what the coarser mesh tells,
        an unsure moment, and what a stroke does to loads across it.
        """
        one_alone()
        if not ask.geometry.neck(ask.sizes).has_peaks:
            raise NotAvailable("is judged by its nominal stress, which is that of beams")
        if ask.scene.temperature is not None or ask.scene.on_bodies:
            raise NotAvailable("has no solid at a temperature, or among several joints")
        beam, off, found = self._beam(ask), 0.0, list[_Worst]()
        borne, higher = self._wrenches(ask, beam), of_larger_bodies(ask)
        for solid in self._solids(ask)[1]:
            fine, coarse = (self._worst(ask, solid, borne, orders) for orders in (FINE, COARSE))
            if fine.largest == 0.0:
                return fine.places, 0.0
            beside_throat(solid, borne.wrenches, fine.largest)
            whole, swing = np.abs(borne.wrenches).max(axis=0), np.zeros(6)
            if ask.scene.moves:
                swing = np.abs(borne.wrenches[::2] - borne.wrenches[1::2]).max(axis=0) / 2.0
            each = (fine.largest, coarse.largest, whole), (fine.amplitude, coarse.amplitude, swing)
            unsure = zip(borne.unsure, borne.shares, strict=True)
            for (one, other, wrench), (own, share) in zip(each, unsure, strict=True):
                if one > FEWEST * fine.largest:
                    by_mesh = max(abs(one - other), meshed(solid, wrench))
                    more = self._unsure(solid, borne, own + higher * wrench, share)
                    off = max(off, (more + by_mesh) / one)
            found.append(fine)
        first, ratios = found[0], [1.0]
        for worst in found[1:]:
            ratios.append(worst.largest / first.largest)
            if first.amplitude > FEWEST * first.largest:
                ratios.append(worst.amplitude / first.amplitude)
        middle = (min(ratios) + max(ratios)) / 2.0
        places = [
            each._replace(amplitude=middle * each.amplitude, mean=middle * each.mean)
            for each in first.places
        ]
        apart = max(ratios) / middle - 1.0
        return places, (1.0 + off + ALIKE) * (1.0 + apart) - 1.0

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stress at the surface where it is largest."""
        return "stress at the surface of solids, principal or von Mises", self._judged(ask)[0]

    def bent(self, ask: Ask) -> Bent:
        """Return what loads bend of beams, which the solid is stiffer or softer than."""
        found = super().bent(ask)
        if not np.any(found.share):
            return found
        return found._replace(unlike=abs(self._stiffness(ask)[0] / self._beam(ask) - 1.0))

    def _beam(self, ask: Ask) -> float:
        """Return the stiffness of beams."""
        find = partial(super()._settled_stiffness, ask)
        return self._known_pairs.of("stiffness of beams", ask, find)[0]

    def _hinge_turn(self, ask: Ask, travel: float) -> float:
        """Return by how much a hinge turns at most at a travel [rad]."""
        return travel

    def _wrenches(self, ask: Ask, beam: float) -> Wrenches:
        """Return what the notch bears in the states of a case, in each sense of what is across."""
        scene = ask.scene
        K, error = self._stiffness(ask)
        planar, unsure = np.zeros((2 if scene.moves else 1, 6)), (np.zeros(6), np.zeros(6))
        if scene.moves or scene.is_loaded:
            states = self.states(ask)
            middle, bowed = _in_the_middle(states)
            travels = np.zeros(len(middle))
            if scene.moves:
                travels = np.tile(scene.stroke_ends, len(middle) // 2)
            planar = np.zeros((len(middle), 6))
            planar[:, [0, 1, 5]] = middle
            planar[:, MOMENT] += (K - beam) * travels
            turned = states.motions[:, states.layout.index(MOVING), 2]
            rest = middle[:, 2] - beam * travels
            rest = np.minimum(np.abs(rest), np.abs(np.abs(rest) - scene.push))
            beside = bowed + abs(K / beam - 1.0) * float(rest.max())
            error += self._turned(float(np.abs(turned).max()))
            for off, travel in zip(unsure, (np.abs(travels).max(), scene.travel), strict=True):
                off[MOMENT] = beside + K * error * float(travel)
        groups = self._across(ask)
        each = either_way(groups)
        across = np.repeat(each, len(planar), axis=0)
        wrenches = np.tile(planar, (len(each), 1)) + across
        return Wrenches(wrenches, unsure, across, self._shares(ask) if groups else (0.0, 0.0))

    def _shares(self, ask: Ask) -> tuple[float, float]:
        """Return by what share a stroke changes what acts across it, and it alternates."""
        joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
        changed = changed_across(joint, ask.scene)
        if changed is None:
            raise NotAvailable("has no state at its stroke under what acts across it")
        return max(1.0 - changed.least, changed.most - 1.0, 0.0), changed.swings

    def _across(self, ask: Ask) -> list[Floats]:
        """Return what each load out of the plane is about the middle of the notch (6,)."""
        if not ask.scene.across_by:
            return []
        joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
        to_notch = motion_along(axes_about_z(ask.geometry.axes)).T
        found = []
        for acting in acting_across(joint, ask.scene):
            wrench = to_notch @ acting.wrench
            if acting.acceleration.any():
                # what the notch weighs itself, as if all of it were on the body
                if ask.material.density is None:
                    raise NotAvailable("needs material.density for the weight of the notch")
                mass = ask.material.density.value * number(ask.geometry.volume(ask.sizes))
                wrench[:3] += mass * (to_notch[:3, :3] @ acting.acceleration)
            found.append(wrench)
        return found

    def _turned(self, turn: float) -> float:
        """Return what a rotation adds to the relative error of a moment at rest."""
        if turn > HINGE_TURN:
            raise NotAvailable("turns farther than solids were compared with beams")
        return AT_STROKE * min(1.0, turn / SMALL_TURN)

    def _unsure(
        self, solid: SolidUnderLoads, borne: Wrenches, wrench: Floats, share: float
    ) -> float:
        """Return by how much a wrench and a share of what acts across change the stress [Pa].

        Each part of the wrench counts at the place that it stresses most.
        """
        found = 0.0
        for wrenches in (*(np.diag(wrench)[:, None]), share * borne.across):
            if np.any(wrenches):
                found += float(np.abs(equivalent(solid.stresses(wrenches, FINE)[0])).max())
        return found

    def _worst(
        self, ask: Ask, solid: SolidUnderLoads, borne: Wrenches, orders: tuple[int, int, int]
    ) -> _Worst:
        """Return the worst places of the surface, state by state or between both ends."""
        stress, is_last = solid.stresses(borne.wrenches, orders)
        if borne.sides is not None:
            there = borne.sides[:, None] == sides(len(is_last))
            stress = stress * there[..., None]
        scene, joint = ask.scene, ask.geometry.joint_of("hinge")
        reverses = scene.mean_travel == 0.0 and not (scene.is_loaded or scene.across_by)
        pairs = zip(stress[::2], stress[1::2], strict=True)
        if not scene.moves:
            pairs = zip(stress, stress, strict=True)
        found, largest, most = list[EndStress](), 0.0, 0.0
        for one, other in pairs:
            amplitude = np.abs(equivalent((one - other) / 2.0))
            whole = np.maximum(np.abs(equivalent(one)), np.abs(equivalent(other)))
            sign = np.sign(equivalent((one + other) / 2.0))
            mean = np.where(whole - amplitude > FEWEST * whole, sign * (whole - amplitude), 0.0)
            for place in dict.fromkeys(map(int, worst_places(amplitude, mean))):
                if is_last[place] and whole[place] >= (1.0 - FEWEST) * whole.max():
                    raise NotAvailable("has its largest stress where a rigid body begins")
                found.append(
                    EndStress(
                        "at the surface of the notch", float(amplitude[place]), float(mean[place]),
                        0.0, joint, is_at_face=True, reverses=reverses,
                    )
                )  # fmt: skip
            largest, most = max(largest, float(whole.max())), max(most, float(amplitude.max()))
        return _Worst(found, largest, most)

    def _solids(self, ask: Ask) -> _Solids:
        """Return the solids that the notch may be."""
        return self._known_solids.of("solids", ask, lambda: _solids(ask))

    def parasitic_shift(self, ask: Ask) -> Computed:
        """Refuse: solids at rest do not move off their path."""
        raise NotAvailable("has no shift by solids: take --model exact")

    def deflections(
        self, ask: Ask, point: tuple[float, float, float], direction: str
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return those at a stroke, whose changes are beams'; at rest they are of first order."""
        if not ask.scene.moves:
            raise NotAvailable("is a solid at rest")
        try:
            turn = self._hinge_turn(ask, max(abs(end) for end in ask.scene.stroke_ends))
            springs = Springs(self._unlike_beams(ask), self._turned(turn), turn)
            return deflections(ask, point, direction, springs=springs)
        except Buckled:
            raise
        except NotAvailable as reason:  # that at rest is none at a stroke
            raise SolveError("at-rest", f"the solid {reason}", "take --model exact") from reason

    def _unlike_beams(self, ask: Ask) -> float:
        """Return by what share a solid may differ from beams in any of its compliances."""
        most = 0.0
        beams = self._beams(ask)
        for beam, (C, off) in zip(beams, self._compliances(ask, range(6)), strict=True):
            most = max(most, (1.0 + off) * max(C / beam, beam / C) - 1.0)
        return most

    def _beams(self, ask: Ask) -> Floats:
        """Return the six compliances of beams about the middle, without the blocks beside them."""
        joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
        return np.asarray(1.0 / joint.assembly.members[0].springs.stiffness)


def of_larger_bodies(ask: Ask) -> Floats:
    """Return what bodies higher than the mouth may add to the peak of each of six loads (6,) [-].

    Blocks of a length that is stated are as high as the mouth, and the solid has them.
    """
    sizes = ask.geometry.neck(ask.sizes)
    if len(sizes.blocks) == 1:
        return np.zeros(6)
    bent, along = above_bars(sizes.e / sizes.depth)
    return np.array([along, bent, along, along, along, bent])


def _solids(ask: Ask) -> _Solids:
    one_alone()
    elastic = ask.material.elastic
    if elastic.nu is None or elastic.nu > STIFFEST_NU:
        raise NotAvailable(f"has no solids without a Poisson's ratio up to {STIFFEST_NU:g}")
    sizes, known = ask.geometry.neck(ask.sizes), dict[float, SolidUnderLoads]()
    if sizes.straight > SLENDEREST * sizes.e:
        raise NotAvailable("is so slender that too few digits are left of a solid: beams know it")
    E, nu, limb = number(elastic.E), number(elastic.nu), sizes.limb
    for block in (*sizes.blocks, *sizes.turning):
        neck = Neck(sizes.e, sizes.depth, sizes.l, sizes.b, sizes.straight, block)
        if limb is not None and limb.may_be_rigid and block == min(sizes.blocks):
            known[block] = RigidLimb(neck_under_loads(neck, E, nu), limb.l)
        elif limb is not None:
            neck = neck._replace(bar=limb.l / 2.0 - neck.end)
        known.setdefault(block, neck_under_loads(neck, E, nu))
    return _Solids(
        *(tuple(known[block] for block in each) for each in (sizes.blocks, sizes.turning))
    )


def compliance_ends(solids: tuple[SolidUnderLoads, ...], index: int) -> tuple[float, float]:
    """Return the least and the greatest compliance of some solids to a unit load."""
    ends = []
    for solid in solids:
        try:
            found, error = solid.compliance(index)
        except SolveError as failed:
            raise NotAvailable(f"has no solid: {failed}") from failed
        if error >= 1.0:
            raise NotAvailable("has no solid: too few digits are left of one so slender")
        ends += [found * (1.0 - error), found * (1.0 + error)]
    return min(ends), max(ends)


def either_way(groups: list[Floats], shape: tuple[int, ...] = (6,)) -> Floats:
    """Return all sums of wrenches of a shape, each in either sense: zero where there are none."""
    signs = np.array(list(product((1.0, -1.0), repeat=len(groups))))
    return np.asarray(np.tensordot(signs, np.reshape(groups, (len(groups), *shape)), axes=1))


def beside_throat(solid: SolidUnderLoads, wrenches: Floats, largest: float) -> None:
    """Refuse a stress beside a throat [Pa] that may be less than that of a mouth that is clamped.

    Raises
    ------
    NotAvailable
        Where a beam as high as the mouth has nearly as much there.

    """
    if solid.neck.block == 0.0 and solid.at_mouth(wrenches) > CLEAR * largest:
        raise NotAvailable("may have its largest stress at its mouth, which is clamped")


def meshed(solid: SolidUnderLoads, wrench: Floats) -> float:
    """Return by how much finer meshes may change the stresses of a wrench's parts [Pa]."""
    return float(sum(wrench[k] * solid.apart(int(k)) for k in np.flatnonzero(wrench)))


def _in_the_middle(states: Equilibrium) -> tuple[Floats, float]:
    """Return N, Q [N] and M [N·m] in the middle of the notch (states, 3), and how M is bowed.

    The latter is its most over the mean of both ends [N·m]: what the force along it bends it by.
    """
    found = ends_and_middle(states, 0)
    middle = found[:, 1, 1:]
    bowed = np.abs(middle[:, 2] - (found[:, 0, 3] + found[:, -1, 3]) / 2.0)
    return middle, float(bowed.max())


def ends_and_middle(states: Equilibrium, blade: int) -> Floats:
    """Return s [m], N, Q [N] and M [N·m] at the start, middle and end of a blade (states, 3, 4)."""
    values, u = [], np.array([[-1.0, 0.0, 1.0]])
    for part in states.parts:
        pieces = flexible_pieces(part, blade)
        each = [section_forces(states, part, blade, piece, u) for piece in pieces]
        sections = (np.concatenate([getattr(at, name) for at in each], axis=1) for name in "sNQM")
        values.append(np.stack(list(sections), axis=-1))
    found = states.scatter(values)
    s = found[0, :, 0]
    return found[:, [0, int(np.argmin(np.abs(s - (s[0] + s[-1]) / 2.0))), -1]]
