"""The exact model of an unseparated cross, what is of small motion that of a solid.

What large motion and loads change beside small motion is what exact beams say; it is unsure by as
much as a solid and beams are unlike.
"""

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import product
from math import hypot, inf

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.crossed_states import (
    CrossedSmall,
    beams_of,
    in_space,
    small_states,
    solid_of,
)
from flexcli.engine.joint_models.exact import ExactModel, alone
from flexcli.engine.joint_models.face_stress import PlateStresses
from flexcli.engine.joint_models.joint_states import at_rest, blades_of, solved
from flexcli.engine.joint_models.remembered import Remembered
from flexcli.engine.joint_models.solid_at_rest import SolidAtRest
from flexcli.errors import SolveError
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.points import point_motion
from flexcli.mechanics.space.layout import SpaceLayout
from flexcli.mechanics.space.springs import MemberSprings
from flexcli.mechanics.state import Equilibrium
from flexcli.mechanics.stresses import blade_stress
from flexcli.parts.bending.solid_cross import turned_by
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING, CrossSizes
from flexcli.parts.requirements import (
    Ask,
    Bent,
    DriveEffort,
    JointModel,
    MisfitStress,
    Told,
)
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["ExactWithCross"]

Floats = NDArray[np.float64]

WHOLE = frozenset(
    {
        EffectName.SHEAR,
        EffectName.AXIAL_EXTENSION,
        EffectName.PLATE_WIDENING,
        EffectName.CLAMP_COMPLIANCE,
    }
)
"""What a solid has that beams lack or may leave out."""

OF_SOLIDS = frozenset(
    {
        QuantityKind.STIFFNESS,
        QuantityKind.FREQUENCY,
        QuantityKind.STRESS,
        QuantityKind.SHIFT,
        QuantityKind.SAG,
    }
)
"""The numbers that are told by it."""

TURN = 2

SMALL = 0.02
"""Rotation [rad] at which, and at twice which, beams tell what their shift is of second order."""


class ExactWithCross(SolidAtRest):
    """Exact beams, of which what is of first order is a solid's."""

    has_all_strain_laws = True
    at_rest = "solid of the whole joint between rigid bodies, at rest"

    def __init__(self) -> None:
        super().__init__(Effects())  # solids are whole
        self._known_stresses = Remembered("solid")
        self._known_pairs = Remembered("solid")
        self._known_solids: Remembered[CrossedSmall] = Remembered()
        self._known_beams: Remembered[CrossedSmall] = Remembered()
        self._known_more: Remembered[PlateStresses] = Remembered()
        self._known_joints: Remembered[tuple[SpaceLayout, tuple[MemberSprings, ...]]]
        self._known_joints = Remembered()

    def shares(self, other: JointModel) -> None:
        """Share the equilibria of beams that deform as these do, where nothing is switched off."""
        if isinstance(other, ExactModel) and other.effects == self.effects:
            super().shares(other)

    def may_carry(self, kind: QuantityKind) -> frozenset[EffectName]:
        """Return what solids have in the numbers that they tell."""
        return WHOLE if kind in OF_SOLIDS else frozenset()

    def carries(self, ask: Ask, kind: QuantityKind) -> frozenset[EffectName]:
        """Return what solids have in the numbers that they tell."""
        return self.may_carry(kind) | super().carries(ask, kind)

    def _solid(self, ask: Ask) -> CrossedSmall:
        """Return the solid, cold."""
        if ask.scene.temperature is not None:
            raise NotAvailable("has no solid at a temperature")
        return self._known_solids.of("solid", ask, partial(solid_of, ask))

    def _beams(self, ask: Ask) -> CrossedSmall:
        return self._known_beams.of("beams", ask, lambda: beams_of(ask, self.effects))

    def _unlike(self, ask: Ask) -> float:
        """Return by what share a solid may differ from beams in any compliance of the plane."""
        solid, beams = self._solid(ask), self._beams(ask)
        C, other = solid.compliance.diagonal(), beams.compliance.diagonal()
        off = solid.off.diagonal()
        return float(np.max([(C + off) / other, other / (C - off)])) - 1.0

    def _turned(self, ask: Ask) -> float:
        """Return what a stroke may change of what a crossing adds to moments, of all of them [-].

        By beams that begin beyond the crossing, which bend otherwise at a stroke.
        """
        if not ask.scene.moves:
            return 0.0
        K, off = self._stiffness(ask)
        ratio = K * float(self._beams(ask).compliance[TURN, TURN])
        half_angle = ask.geometry.solid_cross(ask.sizes).half_angle
        found = turned_by(ratio * (1.0 - off), ratio * (1.0 + off), half_angle)
        travel = max(map(abs, ask.scene.stroke_ends))
        if travel > found.farthest:
            raise NotAvailable("turns farther than crossings were compared with beams")
        return max(-found.least, found.most + found.grows * travel**2) * travel

    def own_joint(self, ask: Ask) -> tuple[SpaceLayout, tuple[MemberSprings, ...]]:
        """Return the joint at rest as its solid."""
        find = partial(in_space, ask, self._solid(ask))
        return self._known_joints.of("joint", ask, find)

    def _settled_stiffness(self, ask: Ask) -> tuple[float, float]:
        solid = self._solid(ask)
        C, off = solid.compliance[TURN, TURN], solid.off[TURN, TURN]
        return float(1.0 / C), float(off / (C - off))

    def _plates(self, ask: Ask) -> PlateStresses:
        """Return what a solid adds to the nominal stress of beams."""
        return self._known_more.of("solids", ask, partial(self._more, ask))

    def _more(self, ask: Ask) -> PlateStresses:
        """Return it, and by what share the largest stress and amplitude are unsure.

        That is by what small motion of the solid is, and of what beams have beside theirs as much
        as both are unlike.
        """
        cross = ask.geometry.solid_cross(ask.sizes)
        solid, beams = small_states(ask, self._solid(ask)), small_states(ask, self._beams(ask))
        states, unlike = self.states(ask), self._unlike(ask)
        own, small = (_at_ends(cross, each.borne) for each in (solid, beams))
        off, swing_off = (_off_at_ends(cross, x) for x in (solid.unsure, solid.swing_unsure))
        exact = np.stack([_ends_of(states, blade.name) for blade in states.layout.blades], axis=1)
        beside, whole = exact - small, exact + own - small
        share = _share(whole, off + unlike * np.abs(beside))
        if ask.scene.moves:  # states are pairs of both ends
            swings = [np.abs(each[::2] - each[1::2]) / 2.0 for each in (whole, beside)]
            share = max(share, _share(swings[0], swing_off + unlike * swings[1]))
        share += self._turned(ask)
        return PlateStresses((own - small)[..., 0], (own - small)[..., 1], share)

    def bent(self, ask: Ask) -> Bent:
        """Return what loads bend of beams, which the solid is stiffer or softer than."""
        found = super().bent(ask)
        if not np.any(found.share):
            return found
        return found._replace(unlike=found.unlike + self._unlike(ask))

    def effort(self, ask: Ask) -> tuple[DriveEffort, ...]:
        """Return what holds the joint at both ends: that of beams, the stroke's as the solid's."""
        (K, off), unlike, turned = self._stiffness(ask), self._unlike(ask), self._turned(ask)
        beam = 1.0 / float(self._beams(ask).compliance[TURN, TURN])
        found = []
        for travel, effort, error, load in super().effort(ask):
            whole = effort + (K - beam) * abs(travel)
            if error is None or whole == 0.0:
                found.append(DriveEffort(travel, whole, None, load))
                continue
            beside = unlike * (abs(effort - beam * abs(travel)) + load)
            more = (K * abs(travel) * (off + turned) + beside) / abs(whole) + error.largest
            found.append(DriveEffort(travel, whole, ErrorRange(-more, more), load))
        return tuple(found)

    def _settled_shift(self, ask: Ask) -> tuple[float, float]:
        """Return the middle of the range of the larger shift at both ends, and its error.

        What beams have beside the first orders is unsure by as much as both are unlike, and any
        next order by the square of the rotation: along of all, across by what a shift along has
        more than beams' on an axis that turns.
        """
        if not ask.scene.moves:
            raise NotAvailable("has no shift by solids but of a stroke: take --model exact")
        ask = alone(ask)
        solid, beams, unlike = self._solid(ask), self._beams(ask), self._unlike(ask)
        second, states = self._second(ask), self.states(ask)
        moved = -point_motion(states, MOVING, (0.0, 0.0))
        coupled, off = solid.coupled
        least = most = 0.0
        farther = max(abs(each) for each in solid.shift)
        turned = max(abs(each - second) for each in solid.shift) + abs(coupled)
        for travel, (x, y) in zip(ask.scene.stroke_ends, moved, strict=True):
            beside = x - second * travel**2, y + beams.coupled[0] * travel
            along = [
                each * travel**2
                + beside[0]
                + sign * (unlike * abs(beside[0]) + farther * travel**4)
                for each, sign in zip(solid.shift, (-1.0, 1.0), strict=True)
            ]
            across = -coupled * travel + beside[1]
            unsure = (off + turned * travel**2) * abs(travel) + unlike * abs(beside[1])
            near = 0.0 if along[0] <= 0.0 <= along[1] else min(map(abs, along))
            low = hypot(near, max(abs(across) - unsure, 0.0))
            least = max(least, low)
            most = max(most, hypot(max(map(abs, along)), abs(across) + unsure))
        middle, sign = (least + most) / 2.0, 1.0 if sum(solid.shift) >= 0.0 else -1.0
        if middle == 0.0:
            return 0.0, inf
        return sign * middle, (most - least) / 2.0 / middle

    def _second(self, ask: Ask) -> float:
        """Return the shift of beams of second order in a rotation, towards the base [m/rad²]."""
        layout, _ = at_rest(ask, self.effects)
        turns = SMALL * np.array([1.0, -1.0, 2.0, -2.0])
        held = {MOVING: (None, None, turns)}
        state = solved(
            layout, held, effects=blades_of(layout, self.effects),
            tolerance=self.tolerance, levels=self.levels,
        )  # fmt: skip
        x = -point_motion(state, MOVING, (0.0, 0.0))[:, 0] / turns**2
        one, two = x[:2].sum() / 2.0, x[2:].sum() / 2.0
        return float((4.0 * one - two) / 3.0)

    def sag_changes(self, ask: Ask) -> tuple[tuple[float, float], ...]:
        """Refuse: solids are at rest."""
        raise NotAvailable("has no sag at stroke by solids: take --model exact")

    def deflections(
        self, ask: Ask, point: tuple[float, float, float], direction: str
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Refuse: solids are at rest."""
        if ask.scene.moves:  # what there is at rest is none at a stroke
            hint = "take --model exact"
            raise SolveError("at-rest", "the solid is at rest", hint)
        raise NotAvailable("is a solid at rest")

    def misfit_stresses(
        self, ask: Ask, small: Sequence[MisfitStress]
    ) -> Iterator[tuple[Told, str]]:
        """Refuse: solids do not tell what arms bear out of the plane."""
        raise NotAvailable("has no missed seat by solids: take --model exact")


def _at_ends(cross: CrossSizes, borne: Floats) -> Floats:
    """Return the stress at start and end of part-blades by what arms bear (states, 4, 2, 2) [Pa].

    First that of bending, then the axial one.
    """
    of_bending, area = 6.0 / (cross.b * cross.h**2), cross.b * cross.h
    reaches = (1.0 - cross.crossing) * cross.l, cross.crossing * cross.l
    found = np.zeros((len(borne), 4, 2, 2))
    for index, (blade, arm) in enumerate(product((0, 1), (1, 0))):
        N, V, M = borne[:, blade, arm].T
        outer = M - reaches[arm] * V
        # towards the base a part-blade starts at its outer end
        ends = (M, outer) if arm == 0 else (-outer, -M)
        found[:, index, :, 0] = of_bending * np.stack(ends, axis=-1)
        found[:, index, :, 1] = (N / area)[:, None]
    return found


def _off_at_ends(cross: CrossSizes, unsure: Floats) -> Floats:
    """Return by how much stress may be off where forces and moments may be either way [Pa]."""
    signs = np.array(list(product((1.0, -1.0), repeat=2)))  # of V and M, N alone is axial
    each = [_at_ends(cross, unsure * np.array([1.0, *sign])) for sign in signs]
    return np.asarray(np.max(np.abs(each), axis=0))


def _ends_of(states: Equilibrium, name: str) -> Floats:
    """Return the stress of beams as :func:`_at_ends` has it (states, 2, 2) [Pa]."""
    found = blade_stress(states, name)
    return np.stack([x[:, [0, -1]] for x in (found.bending, found.axial)], axis=-1)


def _share(whole: Floats, unsure: Floats) -> float:
    """Return by what share the largest stress of all may be off."""
    most = float(np.abs(whole).sum(axis=-1).max())
    return float(unsure.sum(axis=-1).max()) / most if most else 0.0
