"""What buckles a joint in space: the shares of its loads at both ends of a stroke."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from math import inf, isfinite
from typing import NamedTuple, TypeAlias
from weakref import WeakKeyDictionary

import numpy as np

from flexcli.engine.joint_models.dead_loads import loads_of, signed
from flexcli.engine.joint_models.soft_blocks import hinge_alone_off, with_soft_blocks
from flexcli.engine.joint_models.space_errors import width_error
from flexcli.engine.joint_models.space_stroke import (
    BEAMS,
    Blades,
    Loads,
    at_travel,
    driven_coordinate,
)
from flexcli.errors import SolveError
from flexcli.mechanics.space.exact.critical import (
    SpaceCritical,
    critical_load,
    straight_critical_factor,
)
from flexcli.mechanics.space.exact.demand import Held, drive_frame
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium, solve
from flexcli.mechanics.space.inertia import blade_masses
from flexcli.mechanics.space.layout import SpaceLayout
from flexcli.mechanics.space.states import Acting, combined
from flexcli.parts.elastic import NotAvailable, buckled
from flexcli.parts.requirements import Ask, CriticalShare
from flexcli.parts.scene import Scene
from flexcli.parts.space_joint import SpaceJoint, joint_of
from flexcli.parts.space_states import acting_groups, acting_together, senses
from flexcli.results import ErrorRange

__all__ = ["critical_shares", "may_stand", "path_at", "travels_of"]

LOST_EARLY = 0.5
"""Share of the loads asked for, before which the end of a path that is lost is its own."""

_Asked: TypeAlias = tuple[str, float | None, Loads, bool, bool]

_KNOWN: WeakKeyDictionary[SpaceJoint, dict[_Asked, tuple[float, SpaceCritical | SolveError]]]
_KNOWN = WeakKeyDictionary()
"""Up to which share the path of loads was asked for, and what was found."""


def critical_shares(
    ask: Ask, blades: Blades, *, bows: bool = True, drive_holds: bool = False
) -> Iterator[CriticalShare]:
    """Yield what buckles it at rest and both ends of a stroke; what is no wrench acts either way.

    A drive keeps the motion of the case, and unless it ``drive_holds`` by an effort that keeps its
    size, which is no hold: then rest is looked at besides.

    Loads across make blades bow from the first on, and the path passes no critical point where
    they would buckle without: the share may be as little as that of beams which stay straight,
    which is below that of shells. What does not ``bow`` so, a mirrored joint whose plane its loads
    leave, has such a point.
    """
    scene = ask.scene
    joint = joint_of(ask)
    layout, drive = joint.layout, joint.layout.drive
    acting = acting_groups(joint, scene)
    groups = [loads_of(joint, each) for each in acting]
    each_sense = list(senses(scene, len(groups)))
    each_state = list(acting_together(joint, acting, each_sense, locked=scene.moves))
    unsure = max((_weight_of_blades(joint, each) for each in acting), default=0.0)
    most = ask.most_share
    for travel in travels_of(scene, drive_holds=drive_holds):
        known = blades.errors(at_travel(ask, travel, blades, warmth=0.0))
        beams = path_at(ask, travel, BEAMS, drive_holds=drive_holds)
        soft = _with_soft_blocks(layout, beams) if blades is BEAMS and known else None
        for signs, whole in zip(each_sense, each_state, strict=True):
            pattern = tuple(signed(groups, signs))
            spoken = scene.hold if drive_holds else scene.keeps
            try:
                found = _critical(ask, travel, blades, pattern, most, drive_holds=drive_holds)
            except SolveError as error:
                raise NotAvailable(f"has no buckling load: {error}") from error
            share, off = found.factor, found.estimated_error + unsure
            off = off + known.support if known else inf
            high = off
            if found.is_lost:
                high, spoken = inf, f"{spoken}: no more of its path is found, stable so far"
            if share > most:
                share, high, spoken = most, inf, f"{spoken}: none up to that"
            straight = share
            if bows:
                straight = straight_critical_factor(
                    layout, beams.held, pattern, most=share, released=beams.released,
                    frames=drive_frame(drive), start=beams.start,
                )  # fmt: skip
            low = min(1.0, straight / share) * (1.0 - off)
            if soft is not None:
                softest = straight_critical_factor(
                    soft.layout, beams.held, pattern, most=share, released=beams.released,
                    frames=drive_frame(drive), start=soft.start,
                )  # fmt: skip
                own = (1.0 - soft.off) * (1.0 - found.estimated_error - unsure)
                low = max(low, min(1.0, softest / share) * own)
            there = combined([whole], [share])
            if blades is BEAMS:
                low /= 1.0 + width_error(joint.assembly, there.moved.forces[:, 0])
            error_range = ErrorRange(low - 1.0, high) if isfinite(off) else None
            yield CriticalShare(share, spoken, error_range, there.compression)


def _critical(
    ask: Ask, travel: float, blades: Blades, loads: Loads, most: float, *, drive_holds: bool
) -> SpaceCritical:
    """Return where loads get a joint unstable at a travel of its drive, their path walked once.

    Who asks for larger loads goes on from where those that are known to be borne were.
    """
    joint = joint_of(ask)
    known = _KNOWN.setdefault(joint, {})
    at = travel if ask.scene.moves else None
    key = blades.name, at, loads, ask.near is not None, drive_holds
    before, answer = known.get(key, (0.0, None))
    found = None if answer is None else _answered(before, answer, most)
    if found is None:
        walked = answer.walked if isinstance(answer, SpaceCritical) else None
        path = path_at(ask, travel, blades, drive_holds=drive_holds)
        levels, tolerance = blades.critical
        try:
            found = critical_load(
                joint.layout, path.held, loads, most=most, released=path.released,
                frames=drive_frame(joint.layout.drive), start=path.start, levels=levels,
                tolerance=tolerance, made=blades.made, walked=walked,
            )  # fmt: skip
        except SolveError as error:
            found = error
        known[key] = most, found
    if isinstance(found, SolveError):
        raise found
    return found


def _answered(
    before: float, known: SpaceCritical | SolveError, most: float
) -> SpaceCritical | SolveError | None:
    """Return what is known of loads up to ``most`` of those up to ``before``; nothing if unknown.

    Steps are as long as the loads that are asked for: a path that is lost near the end of those may
    be found to larger ones, not one that is lost where it hardly grows with them.
    """
    if isinstance(known, SolveError):
        return known if most == before else None
    if isfinite(known.factor) and known.factor >= most:
        return replace(known, factor=inf, is_lost=False)
    ends = known.factor < (LOST_EARLY * before if known.is_lost else inf)
    return known if ends or most <= before else None


class _SoftBlocks(NamedTuple):
    """A joint drawn with its blocks at their softest, where loads start on it, and its error.

    By as much its hinges alone may be less stiff than beams.
    """

    layout: SpaceLayout
    start: SpaceEquilibrium | None
    off: float


def _with_soft_blocks(layout: SpaceLayout, path: "_Path") -> _SoftBlocks | None:
    """Return a joint with blocks beside its hinges, which its own beams have in their error."""
    soft = with_soft_blocks(layout)
    if soft is None:
        return None
    start = None
    if path.held is not None:
        start = solve(soft, path.held, frames=drive_frame(soft.drive)).checked()
    return _SoftBlocks(soft, start, hinge_alone_off(layout))


class _Path(NamedTuple):
    """What the drive holds while loads grow, and where they start: rest where it holds nothing.

    ``released`` are the coordinates that it keeps by an effort alone.
    """

    held: Held | None
    start: SpaceEquilibrium | None
    released: tuple[int, ...]


def path_at(ask: Ask, travel: float, blades: Blades, *, drive_holds: bool) -> _Path:
    """Return how loads grow at a travel of the drive; a guide is not among what is held."""
    if not ask.scene.moves:
        return _Path(None, None, ())
    state = at_travel(ask, travel, blades, warmth=0.0)
    driven = driven_coordinate(state.layout)
    held = [travel if i == driven % 6 else None for i in range(6)]
    released = () if drive_holds else (driven,)
    return _Path({state.layout.drive.body: held}, state, released)


def travels_of(scene: Scene, *, drive_holds: bool) -> Iterable[float]:
    """Return the travels at which a joint is looked at: rest counts where no drive holds it."""
    return dict.fromkeys(scene.stroke_ends) if drive_holds else scene.ends_and_rest


def may_stand(ask: Ask, blades: Blades, loads: Loads) -> bool:
    """Return that loads are not known to buckle the joint as they grow.

    Raises
    ------
    Buckled
        Where they are.

    """
    for travel in dict.fromkeys(ask.scene.stroke_ends):
        try:
            found = _critical(ask, travel, blades, loads, 1.0, drive_holds=True)
        except (NotAvailable, SolveError):
            continue
        if found.factor < 1.0 and not found.is_lost:
            known = blades.errors(at_travel(ask, travel, blades, warmth=0.0))
            off = found.estimated_error + (known.support if known else 0.0)
            raise buckled(found.factor, less=off, more=off)
    return True


def _weight_of_blades(joint: SpaceJoint, acting: Acting) -> float:
    """Return the share of what bodies weigh by which their blades may be off as half weights.

    The force along a blade that its own weight makes is between none and all of it at its end. What
    a mechanism weighs on its joint is in the wrench.
    """
    size = float(np.linalg.norm(acting.acceleration))
    if size == 0.0:
        return 0.0
    bodies = sum(body.mass for body in joint.layout.bodies)
    bodies += float(np.linalg.norm(acting.wrench[:3])) / size
    halves = float(np.sum(blade_masses(joint.assembly))) / 2.0
    return halves / bodies if bodies > 0.0 else inf
