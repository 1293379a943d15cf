"""Loads in the plane of a narrow joint that buckle it out of it, where its stress is asked for.

Models of the plane hold its bodies there. Blades hardly wider than thick let them bow or tip out of
it under loads that the plane bears; how much stress they have in it then says nothing.
"""

from collections.abc import Iterator

from flexcli.engine.joint_models.dead_loads import loads_of, signed
from flexcli.engine.joint_models.holds import FREE, hold_of
from flexcli.engine.joint_models.space_critical import critical_shares
from flexcli.engine.joint_models.space_stroke import BEAMS
from flexcli.errors import SolveError
from flexcli.mechanics.space.exact.critical import straight_critical_factor
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.states import Acting, SpaceState, action, combined
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask, CriticalShare
from flexcli.parts.scene import Scene
from flexcli.parts.space_joint import SpaceJoint, joint_of
from flexcli.parts.space_states import acting_groups, senses

__all__ = ["out_of_plane_share"]

STANDS = 4.0
"""Factor on its loads up to which straight blades bear them where exact beams need not be asked: of
joints that tilt from the first on, these bore 0.75 of it at least, and strokes change it by some.
"""

ROUGHLY = 2.5
"""By how much more the straight blades of small motion may bear than exact ones that stay straight:
hinges lie farthest off."""

ENOUGH = 1.5
"""Factor on its loads up to which exact beams are followed: what stands there stands."""


def out_of_plane_share(ask: Ask) -> CriticalShare | None:
    """Return the least share of a case's loads that buckles a joint in space, if it may be one.

    It is nothing where the joint surely stands; where no model can follow the loads its error is
    unknown. The drive is locked at its stroke, or free without one.
    """
    if not _is_free(ask.scene) or ask.geometry.is_guided:
        return None
    found = [share for scene in _either_way(ask.scene) if (share := _least(ask, scene))]
    return min(found, key=lambda each: each.share, default=None)


def _is_free(scene: Scene) -> bool:
    """Return whether loads are in the plane, and nothing but its blades holds the body there."""
    in_plane = not (scene.in_space or scene.across_by) and scene.has_plane
    apart = scene.lock is not None or scene.on_bodies or scene.temperature is not None
    return in_plane and not apart and hold_of(scene) == FREE


def _either_way(scene: Scene) -> Iterator[Scene]:
    """Yield a case with what is stated of its loads in the senses in which stress takes it."""
    yield scene
    if any(scene.stated) and not scene.has_one_sense:
        x, y, z, about_x, about_y, about_z = scene.stated
        yield scene._replace(stated=(-x, -y, -z, -about_x, -about_y, -about_z))


def _least(ask: Ask, scene: Scene) -> CriticalShare | None:
    """Return the least share of loads that may buckle a joint, nothing where all are borne."""
    try:
        joint = joint_of(ask)
        groups = acting_groups(joint, scene)
        if not groups:
            return None
        states = [action(joint.assembly, each) for each in groups]
        if _near_by_small_motion(states, scene) * ROUGHLY * STANDS < 1.0:
            return None
        straight = min(_of_straight_blades(joint, groups, scene))
    except (NotAvailable, SolveError):
        return None  # of no model in space, or not held in it: nobody has told more than the plane
    if straight >= STANDS:
        return None
    try:
        found = [
            each
            for each in critical_shares(ask._replace(scene=scene, most_share=ENOUGH), BEAMS)
            if each.error is None or each.share * (1.0 + each.error.low) < 1.0
        ]
    except (NotAvailable, SolveError):
        return CriticalShare(straight, scene.hold, None)
    return min(found, key=lambda each: each.share, default=None)


def _near_by_small_motion(states: list[SpaceState], scene: Scene) -> float:
    """Return the largest share that a case's loads have of what buckles straight blades [-]."""
    each = (combined(states, list(signs)).following() for signs in senses(scene, len(states)))
    return max(max(after.buckling, after.arms) for after in each)


def _of_straight_blades(joint: SpaceJoint, groups: list[Acting], scene: Scene) -> Iterator[float]:
    """Yield the factor on loads at which blades that stay straight buckle, in each sense."""
    loads, frames = [loads_of(joint, each) for each in groups], drive_frame(joint.layout.drive)
    for signs in senses(scene, len(loads)):
        pattern = list(signed(loads, signs))
        yield straight_critical_factor(joint.layout, None, pattern, most=STANDS, frames=frames)
