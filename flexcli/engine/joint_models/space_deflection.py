"""How far loads move a joint in space: exact beams under them, and tangents at a stroke."""

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from math import inf
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.dead_loads import loads_of, signed
from flexcli.engine.joint_models.posed_hinges import Pose, pose_of
from flexcli.engine.joint_models.space_errors import strain_error
from flexcli.engine.joint_models.space_stroke import (
    BEAMS,
    Blades,
    Loads,
    along_cases,
    at_travel,
    compliance_along_cases,
    driven_coordinate,
)
from flexcli.errors import SolveError
from flexcli.formulas.clamped_blade import WIDE
from flexcli.formulas.profile import NeckedDown
from flexcli.formulas.rigid_motion import motion_at
from flexcli.mechanics.space.exact.critical import critical_load
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.layout import SpaceBlade, SpaceLoad, SpaceRod
from flexcli.mechanics.space.second_order import SecondOrder
from flexcli.mechanics.space.states import Acting, SpaceState, action, combined, warmed
from flexcli.parts.elastic import Buckled, NotAvailable
from flexcli.parts.requirements import Ask, Told
from flexcli.parts.requirements.support import (
    CENTRE,
    DIRECTIONS,
    compliance_of,
    deflection_form,
    form_in,
)
from flexcli.parts.space_joint import Form, SpaceJoint, joint_in_space, joint_of
from flexcli.parts.space_states import acting_groups
from flexcli.parts.strained_compliance import beside_wrench, either_way, senses_beside
from flexcli.results import ErrorRange

__all__ = [
    "Springs",
    "deflections",
    "load_error",
    "sag_changes",
    "unsure_springs",
    "warm_sag_ratio",
]

Floats = NDArray[np.float64]

STROKE_ERROR, ASTRAY = 0.15, 0.05
"""Of what a stroke changes in a deflection, by beams, and of the largest change in any direction
that the mirror image of a joint leaves to it: what they may be off.

Against shells, at rest and at the stroke, 0.026 of the largest was left beside 0.15 of its own:
crossed and remote pivots and guides, b/l 0.1 to 2, h/l 0.0025 to 0.04, ν to 0.45, strokes of 1e-4
to 0.1 rad or lengths (``tests/benchmarks/changes_at_stroke.py``)."""

LOAD_ERROR, OF_SUPPORT = 0.05, 3.0
"""The same of what the size of a load changes, besides what beams are off at rest; and times the
error of a support stiffness by beams, which is less for narrow blades: that change is of the square
of their compliances. CalculiX's solids of cantilevers, b/l 0.03 and 0.05, under forces and torques
that move them by 0.03 l had what these change within 0.026 of beams."""

MOST = 1.0
"""Change over the number at rest beyond which that is not known any more."""

SURELY = 0.9
"""Share of its loads at which a joint buckles by beams, up to which it does so surely: shells were
within 2 % of them, or bear less, besides what springs are off."""

BEYOND, NEAR = 1.1, 0.5
"""Times its loads, besides what springs are off, at which a joint has to stand as well, or it may
not stand under them; from which share of what turns straight blades aside that is looked at."""

WALKED, GUIDED, FAR = 3.0, 4.0, 1.5
"""Times what turns straight blades aside, how far loads are followed to where they buckle; how much
more a guide lets them bear, which keeps them from turning (Euler: π² over π²/4); and from where on
that is done before their whole size is looked for."""

ROUGH = (12, 18, 27), 1e-2
"""Nodes and accuracy of the share of loads that buckles a joint."""

TURNED = 1.0
"""Turn of a blade by small motion beyond which loads are not followed [rad]."""

SMALL = 1e-3
"""Share of its loads under which a sag is of first order."""

IN, OUT = [0, 1, 5], [2, 3, 4]
"""Motions and loads in the plane of a joint, and out of it."""

SOLVED = 1e-6
"""Share of the whole motion that loads cause up to which beams tell the part along an axis."""

ROUNDING = 1e-9
"""Share of a compliance without units below which a direction is held."""


class _Tangent(NamedTuple):
    """The compliance along the axes of cases at a travel (6, 6), of beams and of what is finest.

    Without a travel it is that of a temperature alone, the drive free. ``unstrained`` is that of
    beams there without what acts besides. ``coarser`` is that on the level before; ``off`` is by
    what share of √(g·C g · f·C f) the motion g·C f may be off besides, if that is known. ``pose``
    is a joint of hinges as it stands there.
    """

    travel: float | None
    unstrained: Floats
    beams: Floats
    finest: Floats
    coarser: Floats
    off: float | None
    pose: Pose | None = None


class _Told(NamedTuple):
    """A motion and how far it may be off either way, in its own unit; infinite if unknown."""

    value: float
    low: float
    high: float

    @property
    def with_error(self) -> tuple[float, ErrorRange | None]:
        """Return the motion and its relative error; of one that cancels, the most it may be."""
        if not np.isfinite(self.high - self.low):
            return self.value, None
        if self.value == 0.0:
            return max(self.high, -self.low), ErrorRange(-1.0, 0.0)
        low, high = sorted((self.low / self.value, self.high / self.value))
        return self.value, ErrorRange(low, high)


class Springs(NamedTuple):
    """Of springs that are surer than beams': what beams may be off in what a stroke changes.

    A compliance is by a share of ``unlike`` from that of beams at most. At a stroke that turns each
    by ``turn`` [rad] it has the same ratio to beams, but for ``turned``. What it adds to a motion
    by turning with its hinge is no more than that of its angle.

    CalculiX's solids of three notches (e/r 0.1 to 0.3, b/e 4 to 10, ν 0.3 and 0.4, turned by 0.05
    to 0.16 rad, drive free): what the stroke changes of deflections along x, y and z was within
    0.12 of itself, 0.02 where it is a quarter of them, where springs are unlike by 0.1 to 0.2.
    """

    unlike: float
    turned: float
    turn: float

    def off(self, used: float, work: float) -> float:
        """Return what a change is off, ``used`` its size and ``work`` √(g·C g · f·C f) at rest."""
        return self.turned * (work + used) + self.unlike * (used + self.turn * work)


def deflections(
    ask: Ask,
    point: tuple[float, float, float],
    direction: str,
    blades: Blades = BEAMS,
    springs: Springs | None = None,
) -> tuple[tuple[float, ErrorRange | None], ...]:
    """Return how far the wrench of a case, either way, moves a point along an axis of cases.

    To the deflection of the joint at rest by its best springs, what the size of the wrench changes
    and what the stroke changes are added, both by exact beams; each is known to a share of itself.
    At a stroke the tangent there, by beams and by shells, is as sure as a support stiffness is;
    what is surest counts. A temperature and other loads of the case change it as a stroke does, and
    the wrench finds the joint as they leave it. Where the model has ``springs`` of its own, the
    deflection at rest is by these, and what is changed by beams as far as they are like them. No
    load in the plane of a joint that is its own mirror image there moves it out of it.

    Raises
    ------
    NotAvailable
        When there is no stable equilibrium.
    Buckled
        When the wrench surely buckles it.

    """
    scene, joint = ask.scene, joint_in_space(ask.geometry, ask.material, ask.sizes)
    assert scene.wrench is not None  # of a case that has one
    load, sought = np.array(scene.wrench), motion_at(point)[DIRECTIONS.index(direction)]
    beside = beside_wrench(ask)
    mirrored = joint.is_mirrored and not any(
        np.any(each.wrench[OUT]) or each.acceleration[2] for each in beside
    )
    if mirrored and not (np.any(load[OUT]) or np.any(sought[IN])):
        return ((0.0, ErrorRange(0.0, 0.0)),)
    assembly = joint_of(ask).assembly
    centre = joint.layout.body(joint.layout.drive.body).point
    state = action(assembly, Acting(0.0, along_cases(ask).T @ load, centre, np.zeros(3)))
    form = deflection_form(ask, sought, load)
    found, failed = list[tuple[float, ErrorRange | None]](), list[NotAvailable]()
    for signs in senses_beside(scene, beside):
        strained = _Strained.by(ask, beside, signs)
        try:
            at_rest = at_travel(ask, 0.0, warmth=0.0)
            rest = still = compliance_along_cases(ask, at_rest, CENTRE, locked=False)
            ends: Iterable[float | None] = dict.fromkeys(scene.stroke_ends)
            if strained.states:
                still = compliance_along_cases(ask, _left(strained), CENTRE, locked=False)
            if not scene.moves:
                ends = (None if strained.states else 0.0,)
            there = [_tangents(strained, travel, blades) for travel in ends]
        except SolveError as error:
            raise NotAvailable(f"has no deflection by exact beams: {error}") from error
        asked = _Asked(strained, (sought, load), (rest, still), form, springs, mirrored=mirrored)
        for sign, moved in _either_way(strained, state, sought):
            if isinstance(moved, NotAvailable):
                failed.append(moved)
                continue
            acting = combined([state], [sign])
            own = moved - sign * float(sought @ still @ load)
            for tangents in there:
                told = [asked.from_rest(sign, own, tangents[0])]
                for tangent in tangents:
                    if tangent.travel == 0.0:
                        continue
                    told.append(asked.by_tangent(sign, own, tangent, acting.loads))
                    if tangent.pose is not None:
                        told.append(asked.by_pose(sign, own, tangent, acting.loads))
                found.append(min(told, key=lambda each: each.high - each.low).with_error)
    if failed and not found:
        raise failed[0]
    # one sense may be more than is allowed, whatever the other is
    return (*found, *((form.found, None) for _ in failed))


class _Strained(NamedTuple):
    """A joint as what acts beside a case's wrench leaves it: a temperature, and loads in a sense.

    ``states`` are these as linear ones.
    """

    ask: Ask
    loads: Loads
    states: tuple[SpaceState, ...]

    @classmethod
    def by(cls, ask: Ask, beside: Sequence[Acting], signs: Sequence[float]) -> "_Strained":
        """Return it under loads in their senses."""
        joint = joint_of(ask)
        groups = [loads_of(joint, each) for each in beside]
        heat = [warmed(joint.assembly, locked=False)] if joint.layout.grows else []
        states = [
            combined([action(joint.assembly, g)], [s]) for g, s in zip(beside, signs, strict=True)
        ]
        return cls(ask, tuple(signed(groups, signs)), (*heat, *states))

    def at(
        self,
        travel: float | None,
        blades: Blades | None = None,
        *,
        more: Loads = (),
        start: SpaceEquilibrium | None = None,
    ) -> SpaceEquilibrium:
        """Return it at a travel, under more loads; a stroke is from where its own leave it."""
        if self.loads and travel is not None:
            own = driven_coordinate(joint_of(self.ask).layout)
            under, free = (at_travel(self.ask, None, loads=each) for each in (self.loads, ()))
            travel += float((under.coordinates - free.coordinates).ravel()[own])
        return at_travel(self.ask, travel, blades, loads=(*more, *self.loads), start=start)

    def error(self) -> float:
        """Return by what share of itself beams may be off in what strains it changes.

        What a temperature does that nobody compared may be off by itself.
        """
        of_heat = of_loads = 0.0
        if self.ask.scene.temperature is not None:
            found = strain_error(self.at(None))
            of_heat = 1.0 if found is None else found
        if self.loads:
            of_loads = max(load_error(self.ask), unsure_springs(joint_of(self.ask)))
        return max(of_heat, of_loads)


class _Asked:
    """A motion under a load that is asked for, and what is known of it at rest.

    ``pair`` is the row of what is sought, and the load; ``rests`` are the compliances by beams
    unstrained, and as what acts besides leaves them.
    """

    def __init__(
        self,
        strained: _Strained,
        pair: tuple[Floats, Floats],
        rests: tuple[Floats, Floats],
        form: Form,
        springs: Springs | None,
        *,
        mirrored: bool,
    ) -> None:
        (sought, load), ask = pair, strained.ask
        joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
        self.strained, self.sought, self.load, self.form = strained, sought, load, form
        self.rest, self.still = rests
        self.turns = joint.layout.drive.turns
        # a stroke in the plane leaves what acts in it and across it apart
        self.kept = np.arange(6)
        if mirrored and not (np.any(load[IN]) and np.any(load[OUT])):
            self.kept = np.array(IN if np.any(sought[IN]) else OUT)
        # what varies in thickness is no surer than its springs
        self.unsure, self.springs = (
            unsure_springs(joint) if springs is None else springs.unlike,
            springs,
        )
        self.beams = max(load_error(ask), self.unsure)
        self.beams += _largest_share(compliance_of(ask) - self.rest, self.rest)
        self.of_strain = strained.error()

    def from_rest(self, sign: float, own: float, end: _Tangent) -> _Told:
        """Return it by what the stroke and the size of the load, ``own``, change at rest."""
        change, block = end.beams - self.rest, np.ix_(self.kept, self.kept)
        share, size = _changes(change[block], self.rest[block])
        (first, known, work), (g, f) = self.form, (self.sought[self.kept], self.load[self.kept])
        value = sign * first + own + sign * float(self.sought @ change @ self.load)
        own_axes = slice(0, 3) if self.sought[:3].any() else slice(3, 6)
        cancelled = SOLVED * float(np.linalg.norm((self.rest @ self.load)[own_axes]))
        if known is None or abs(own) + share * work > MOST * work:
            return _Told(value, -inf, inf)

        def used(size: Floats) -> float:
            return float(((g @ size @ g) * (f @ size @ f)) ** 0.5)

        # and what both do to each other
        off = self._grown(own, work)
        if self.springs is None:
            off += STROKE_ERROR * used(size) + max(ASTRAY, self.unsure) * share * work
            strain = end.beams[block] - end.unstrained[block]
            strained, of_it = _changes(strain, self.rest[block])
            # what is off of a stiffness by as much is more of a compliance that it raises
            of_strain = _of_strain(self.of_strain, strained) * (1.0 + strained)
            off += max(of_strain - STROKE_ERROR, 0.0) * used(of_it)
        elif end.travel != 0.0:
            off += self.springs.off(used(size), work)
        off += abs(own) * share + cancelled
        low, high = sorted(sign * end for end in known)
        return _Told(value, low - off, high + off)

    def by_tangent(self, sign: float, own: float, end: _Tangent, loads: Loads) -> _Told:
        """Return it by the tangent at the end of a stroke, and what the size of the load changes.

        ``own`` is that at rest; there it is looked for where the stroke may change it.
        """
        pair = np.stack([self.sought, self.load])
        (one, both), (_, other) = pair @ end.finest @ pair.T
        if end.off is None or one <= 0.0 or other <= 0.0:
            return _Told(sign * both + own, -inf, inf)
        work = float((one * other) ** 0.5)
        size = np.sqrt(np.outer((one, other), (one, other)))
        level = float(np.abs(pair @ (end.coarser - end.finest) @ pair.T / size).max())
        own, doubt = self._by_size(sign, own, end, loads, work)
        off = (end.off + level) * work + self._grown(own, work) + doubt
        return _Told(sign * float(both) + own, -off, off)

    def by_pose(self, sign: float, own: float, end: _Tangent, loads: Loads) -> _Told:
        """Return it by the springs of hinges where the stroke has brought them.

        Each counts as far as it gives way there under this load. What strains them there, and what
        the level changes, is by beams and may be off by itself.
        """
        assert end.pose is not None  # it is asked of joints that have one
        joint, beams, more = end.pose
        first, known, work = form_in(self.strained.ask, joint, self.sought, self.load)
        if known is None:
            return _Told(sign * first + own, -inf, inf)
        straight = form_in(self.strained.ask, beams, self.sought, self.load).found
        tangent, before = (float(self.sought @ C @ self.load) for C in (end.beams, end.coarser))
        own, doubt = self._by_size(sign, own, end, loads, work)
        off = (more + self.strained.ask.clamp_softening) * work + self._grown(own, work) + doubt
        off += abs(tangent - straight) + abs(tangent - before)
        low, high = sorted(sign * end for end in known)
        return _Told(sign * (first + tangent - straight) + own, low - off, high + off)

    def _by_size(
        self, sign: float, own: float, end: _Tangent, loads: Loads, work: float
    ) -> tuple[float, float]:
        """Return what the size of the load changes at the end of a stroke, and its doubt."""
        doubt = abs(own) * _largest_share(end.beams - self.still, self.still)
        # rotations about several axes do not add up
        turned = self.turns and bool(self.sought[3:].any())
        if end.travel is not None and doubt > ROUNDING * work and not turned:
            with suppress(NotAvailable, SolveError):
                moved = _moved_at(self.strained, end.travel, loads, self.sought)
                return moved - sign * float(self.sought @ end.beams @ self.load), 0.0
        return own, doubt

    def _grown(self, own: float, work: float) -> float:
        """Return how far what the size of the load changes is off, infinite where nobody knows."""
        if own == 0.0:
            return 0.0  # of what is held, too, on which nothing works
        if abs(own) > MOST * work:
            return inf
        # a load amplifies as 1/(1 − s), s its share of what buckles the joint
        return self.beams * abs(own) * (1.0 + abs(own) / work)


def sag_changes(ask: Ask) -> Iterator[tuple[float, float]]:
    """Yield by what share of itself its size changes a sag, and how far that is off.

    That is by exact beams from rest, the drive free, for either sense of the acceleration. Stated
    loads beside it change a sag as well: it is from where they leave the joint.

    Raises
    ------
    NotAvailable
        When there is no stable equilibrium, or its change is not known.
    Buckled
        When what the body weighs surely buckles the joint, or turns it over.

    """
    scene, joint = ask.scene, joint_in_space(ask.geometry, ask.material, ask.sizes)
    if scene.temperature is not None:
        raise NotAvailable("has no sag by exact beams beside a temperature")
    sought = np.eye(6)["xyz".index(scene.axis)]
    groups = acting_groups(joint, scene._replace(stated=(0.0,) * 6))
    beside = acting_groups(joint, scene._replace(inertial=(), accelerations=()))
    state = combined([action(joint.assembly, each) for each in groups], [1.0] * len(groups))
    plain, either = _Strained(ask, (), ()), list[tuple[float, float | NotAvailable]]()
    for signs in senses_beside(either_way(scene), beside):
        either += _either_way(_Strained.by(ask, beside, signs), state, sought)
    try:
        rest = compliance_along_cases(ask, at_travel(ask, 0.0), CENTRE, locked=False)
        small = _moved(plain, combined([state], [SMALL]).loads, sought) / SMALL
    except SolveError as failed:
        raise NotAvailable(f"has no sag by exact beams: {failed}") from failed
    beams = max(load_error(ask), unsure_springs(joint)) + _largest_share(
        compliance_of(ask) - rest, rest
    )
    for sign, moved in either:
        if isinstance(moved, NotAvailable):
            raise moved
        more = sign * moved / small - 1.0
        if not abs(more) <= MOST:
            raise NotAvailable("sags far beyond small motion")
        yield more, beams * abs(more) * (1.0 + abs(more))


def warm_sag_ratio(ask: Ask) -> Told:
    """Return what a temperature strains makes of a small sag, by exact beams, the drive free [-].

    Raises
    ------
    NotAvailable
        When there is no stable equilibrium.

    """
    joint, axis = joint_in_space(ask.geometry, ask.material, ask.sizes), ask.scene.axis
    groups = acting_groups(joint, ask.scene._replace(stated=(0.0,) * 6))
    states = [action(joint.assembly, each) for each in groups]
    loads = combined(states, [SMALL] * len(states)).loads
    row = np.eye(6)["xyz".index(axis)] @ along_cases(ask)
    body = joint.layout.body(joint.layout.drive.body)
    try:
        cold, warm, left = (
            float(
                row @ at_travel(ask, None, loads=own, warmth=heat).motion_of(body.name, body.point)
            )
            for own, heat in ((loads, 0.0), (loads, 1.0), ((), 1.0))
        )
    except SolveError as failed:
        raise NotAvailable(f"has no sag by exact beams: {failed}") from failed
    ratio = (warm - left) / cold
    share = abs(ratio - 1.0)
    off = _of_strain(_Strained.by(ask, (), ()).error(), share) * share + SOLVED
    return Told(ratio, ErrorRange(-off, off) if off < inf else None)


def load_error(ask: Ask) -> float:
    """Return by what share of itself what the size of a load changes is off by beams, at most."""
    known = BEAMS.errors(at_travel(ask, 0.0, warmth=0.0))
    return LOAD_ERROR if known is None else min(LOAD_ERROR, OF_SUPPORT * known.support)


def unsure_springs(joint: SpaceJoint) -> float:
    """Return by how much the springs of what varies in thickness may be off, at most.

    What a stroke or a load changes of very wide blades, and of those that were compared with
    nothing, nobody knows: it may be off by itself.
    """
    if any(map(_is_very_wide, joint.layout.blades)):
        return 1.0
    if joint.is_uniform:
        return 0.0 if joint.is_known else 1.0
    members = joint.assembly.members
    return max(float(np.max(np.maximum(member.high, -member.low))) for member in members)


def _is_very_wide(blade: SpaceBlade | SpaceRod) -> bool:
    """Return whether a blade, or the hinges of one, were compared at rest alone."""
    if isinstance(blade, SpaceRod):
        return False
    l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
    if isinstance(blade.profile, NeckedDown):
        l = float(blade.profile.hinge)
    return blade.b > WIDE * l


def _tangents(strained: _Strained, travel: float | None, blades: Blades) -> list[_Tangent]:
    """Return the compliances at a travel by beams, and by what is finer where that takes them.

    Narrow blades are beams rather than thin shells.
    """
    found = [_tangent(strained, travel, BEAMS)]
    if blades is not BEAMS and travel != 0.0:
        with suppress(NotAvailable, SolveError):  # shells may not take them
            found.append(_tangent(strained, travel, blades))
    return found


def _tangent(strained: _Strained, travel: float | None, blades: Blades) -> _Tangent:
    """Return the compliances at a travel, by beams and by the blades that are given."""
    ask = strained.ask

    def compliance(state: SpaceEquilibrium) -> Floats:
        return compliance_along_cases(ask, state, CENTRE, locked=False)

    still, state = strained.at(travel), strained.at(travel, blades)
    unstrained = beams = compliance(still)
    if strained.states:
        unstrained = compliance(at_travel(ask, travel or 0.0, warmth=0.0))
    known = blades.errors(state)
    if known is None or state.coarser is None:
        return _Tangent(travel, unstrained, beams, beams, beams, None)
    pose = None if travel is None or strained.states or blades is not BEAMS else pose_of(ask, still)
    finest, coarser = compliance(state), compliance(state.coarser)
    if known.support >= 1.0:
        return _Tangent(travel, unstrained, beams, finest, coarser, None, pose)
    off = (1.0 + ask.clamp_softening) / (1.0 - known.support) - 1.0
    if strained.states:
        share = _largest_share(beams - unstrained, unstrained)
        off += _of_strain(strained.error(), share) * share
    return _Tangent(travel, unstrained, beams, finest, coarser, off, pose)


def _of_strain(unlike: float, share: float) -> float:
    """Return the error of what strain makes of a compliance, by that of what it takes of stiffness.

    ``share`` is what it makes of it; it is endless where the stiffness may be gone.
    """
    left = 1.0 - unlike * share
    return unlike / left if left > 0.0 else inf


def _either_way(
    strained: _Strained, state: SpaceState, sought: Floats
) -> Iterator[tuple[float, float | NotAvailable]]:
    """Yield either sense of loads, and how far they move what is sought [m or rad], or why not.

    That is from where what acts besides leaves the joint. The sense that is nearer to buckling it
    comes first, for it may be all that counts.
    """
    ask, besides = strained.ask, strained.states
    if besides:
        _left(strained)
    rest = _moved(strained, (), sought) if besides else 0.0
    together = {
        sign: combined([state, *besides], [sign, *(1.0 for _ in besides)]) for sign in (1.0, -1.0)
    }
    after = {sign: whole.following() for sign, whole in together.items()}
    for sign in sorted(after, key=lambda each: -after[each].buckling):
        acting, whole, second = combined([state], [sign]), together[sign], after[sign]
        if second.buckling > FAR:
            _prove_buckled(ask, whole, second)
        moved: float | NotAvailable
        try:
            moved = _moved_safely(strained, acting, second, sought) - rest
        except (NotAvailable, SolveError) as failed:
            _prove_buckled(ask, whole, second)
            moved = NotAvailable(f"has no deflection by exact beams: {failed}")
        yield sign, moved


def _left(strained: _Strained) -> SpaceEquilibrium:
    """Return the joint as what acts besides leaves it; raise where that surely buckles it."""
    try:
        return strained.at(None)
    except (NotAvailable, SolveError):
        whole = combined(list(strained.states), [1.0] * len(strained.states))
        _prove_buckled(strained.ask, whole, whole.following())
        raise


def _moved_safely(
    strained: _Strained, acting: SpaceState, second: SecondOrder, sought: Floats
) -> float:
    """Return how far loads and all besides move what is sought, if surely short of buckling."""
    ask = strained.ask
    if second.rotation > TURNED:
        raise NotAvailable("its blades turn too far")
    moved = _moved(strained, acting.loads, sought)
    more = BEYOND * (1.0 + unsure_springs(joint_in_space(ask.geometry, ask.material, ask.sizes)))
    if second.buckling > 0.0 and second.buckling * more > NEAR:
        # what a little more of it buckles may be buckled
        if more == inf:
            raise NotAvailable("nobody knows how near its blades are to buckling")
        all_of_it = tuple(load.times(more) for load in strained.loads)
        pushed = tuple(load.times(more) for load in acting.loads)
        _moved(strained._replace(loads=all_of_it), pushed, sought)
    return moved


def _moved(strained: _Strained, loads: Loads, sought: Floats) -> float:
    """Return how far loads and all besides move what is sought, the drive free [m or rad]."""
    ask = strained.ask._replace(near=None)
    state = strained._replace(ask=ask).at(None, more=loads)
    body = state.layout.body(state.layout.drive.body)
    return float(sought @ along_cases(ask) @ state.motion_of(body.name, body.point))


def _moved_at(strained: _Strained, travel: float, loads: Loads, sought: Floats) -> float:
    """Return how far loads move what is sought from a travel, what drives it there held.

    Pushed by that alone, the joint stays where it is, if it is stable there.
    """
    strained = strained._replace(ask=strained.ask._replace(near=None))
    along, held = along_cases(strained.ask), strained.at(travel)
    drive = held.layout.drive
    effort = float(held.reactions.ravel()[driven_coordinate(held.layout)])
    x, y, z = (effort * float(each) for each in drive.direction)
    push = SpaceLoad(drive.body, drive.point, (0.0, 0.0, 0.0), (x, y, z))
    if not drive.turns:
        push = SpaceLoad(drive.body, drive.point, (x, y, z))
    body = held.layout.body(drive.body)
    under, free = (strained.at(None, more=(push, *more), start=held) for more in (loads, ()))
    moved = (state.motion_of(body.name, body.point) for state in (under, free))
    return float(sought @ along @ np.subtract(*moved))


def _prove_buckled(ask: Ask, acting: SpaceState, second: SecondOrder) -> None:
    """Raise :class:`Buckled` where loads surely make a joint unstable long before they are whole.

    Whole loads may be thousands of times too large to be followed at once. A temperature beside
    them is not looked at.
    """
    if ask.scene.temperature is not None:
        return
    joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
    walked = WALKED * (GUIDED if ask.geometry.is_guided else 1.0)
    most = min(1.0, walked / second.buckling) if second.buckling > 0.0 else 1.0
    if not joint.is_known or most * second.rotation > TURNED:
        return
    body = joint.layout.drive.body
    held = {body: [None, None, None, None, None, 0.0]} if ask.geometry.is_guided else None
    try:
        found = critical_load(
            joint.layout, held, acting.loads, most=most, frames=drive_frame(joint.layout.drive),
            levels=ROUGH[0], tolerance=ROUGH[1],
        )  # fmt: skip
    except SolveError:
        return
    if not found.is_lost and found.factor * (1.0 + unsure_springs(joint)) < SURELY:
        raise Buckled(found.factor)


def _largest_share(change: Floats, C: Floats) -> float:
    """Return the largest share of a compliance that a change is, of any load in any direction."""
    return _changes(change, C)[0]


def _changes(change: Floats, C: Floats) -> tuple[float, Floats]:
    """Return the largest share of a compliance that a change is, and its size in any direction.

    That is the change with what it takes away as what it adds.
    """
    units = np.sqrt(_outer(C))
    values, axes = np.linalg.eigh(C / units)
    kept = values > ROUNDING * values[-1]
    root, inverse = axes[:, kept] * np.sqrt(values[kept]), axes[:, kept] / np.sqrt(values[kept])
    shares, ways = np.linalg.eigh(inverse.T @ (change / units) @ inverse)
    ways = root @ ways
    return float(np.abs(shares).max()), np.asarray(units * ((ways * np.abs(shares)) @ ways.T))


def _outer(C: Floats) -> Floats:
    """Return the products of the diagonal, which make a compliance free of units; 1 for none."""
    diagonal = np.where(np.diag(C) > 0.0, np.diag(C), 1.0)
    return np.asarray(np.outer(diagonal, diagonal))
