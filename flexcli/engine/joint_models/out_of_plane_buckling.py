"""Loads in the plane of a joint that buckle it out of it, whatever is asked of them.

Models of the plane hold its bodies there. Blades hardly wider than thick, and bodies that reach far
beyond their blades, bow or tip out of it under loads that the plane bears; how much stress they
have in it then says nothing.
"""

from collections.abc import Iterator

from flexcli.engine.joint_models.dead_loads import loads_of, signed
from flexcli.engine.joint_models.space_critical import critical_shares, path_at, travels_of
from flexcli.engine.joint_models.space_stroke import BEAMS
from flexcli.errors import SolveError
from flexcli.mechanics.space.exact.critical import straight_critical_factor
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.states import Acting
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask, CriticalShare
from flexcli.parts.scene import Scene
from flexcli.parts.space_joint import SpaceJoint, joint_of
from flexcli.parts.space_states import acting_groups, acting_together, senses

__all__ = ["out_of_plane_share"]

STANDS = 4.0
"""Factor on what is asked up to which straight blades bear loads where exact beams need not be
asked: of joints that tilt from the first on, these bore 0.75 of it at least."""


ROUGHLY = 2.5
"""By how much more the straight blades of small motion may bear than exact ones that stay straight:
hinges lie farthest off."""

CLOSE = 1e-8
"""How closely straight blades are known: a sizing follows what changes with its sizes."""

ENOUGH = 1.5
"""Factor on what is asked up to which exact beams are followed: what stands there stands."""


def out_of_plane_share(
    ask: Ask, bound: float, asked: float, *, buckling: bool
) -> CriticalShare | None:
    """Return the least share of a case's loads that buckles a joint in space, where it is near.

    Nothing but its blades holds it in its plane; nothing is returned where it surely stands at the
    share that is ``asked``.
    Where no model can follow the loads its error is unknown; ``bound`` is what is told then. A
    drive holds the joint at its stroke, and is free without one; a temperature grows with the
    loads. These act in either sense. For its ``buckling`` they do so as they are stated, where they
    are, and no drive holds it.
    """
    scene = ask.scene
    senses_of = _either_way(scene, only=buckling and scene.directed)
    each = (_least(ask, sense, bound, asked, drive_holds=not buckling) for sense in senses_of)
    found = [share for share in each if share]
    return min(found, key=lambda each: each.least, default=None)


def _either_way(scene: Scene, *, only: bool) -> Iterator[Scene]:
    """Yield a case with what is stated of its loads in the senses in which stress takes it."""
    yield scene
    if any(scene.stated) and not scene.has_one_sense and not only:
        x, y, z, about_x, about_y, about_z = scene.stated
        yield scene._replace(stated=(-x, -y, -z, -about_x, -about_y, -about_z))


def _least(
    ask: Ask, scene: Scene, bound: float, asked: float, *, drive_holds: bool
) -> CriticalShare | None:
    """Return the least share of loads that may buckle a joint, nothing where all are borne."""
    ask = ask._replace(scene=scene)
    try:
        joint = joint_of(ask)
        groups = acting_groups(joint, scene)
        if not groups and not joint.layout.grows:
            return None
        signs = senses(scene, len(groups))
        states = list(acting_together(joint, groups, signs, locked=scene.moves))
        after = [state.following() for state in states]
        near = asked * max(max(each.buckling, each.arms) for each in after)
        pushed = max(state.compression for state in states)
        # a stroke bends blades, which are softer across their width then
        if not scene.moves and near * ROUGHLY * STANDS < 1.0:
            return None
        straight = min(_of_straight_blades(ask, joint, groups, STANDS * asked, drive_holds))
    except (NotAvailable, SolveError):
        return CriticalShare(bound, scene.hold, None, 0.0)  # of no model in space
    if straight >= STANDS * asked:
        return None
    try:
        most = ENOUGH * asked
        further = ask._replace(most_share=most)
        bows = not joint.is_mirrored
        found = list(critical_shares(further, BEAMS, bows=bows, drive_holds=drive_holds))
    except (NotAvailable, SolveError):
        return CriticalShare(straight, scene.hold, None, straight * pushed)
    least = min(found, key=lambda each: each.least)
    if least.error is None or least.share < most:
        return least
    # what stands as far as it was followed stands the longer the more straight blades bear
    share = max(straight, most)
    return least._replace(share=share, stress=share * pushed)


def _of_straight_blades(
    ask: Ask, joint: SpaceJoint, groups: list[Acting], most: float, drive_holds: bool
) -> Iterator[float]:
    """Yield the factor on loads at which blades that move no further buckle, in each sense."""
    loads, frames = [loads_of(joint, each) for each in groups], drive_frame(joint.layout.drive)
    travels = travels_of(ask.scene, drive_holds=drive_holds)
    paths = [path_at(ask, travel, BEAMS, drive_holds=drive_holds) for travel in travels]
    for signs in senses(ask.scene, len(loads)):
        pattern = list(signed(loads, signs))
        for path in paths:
            yield straight_critical_factor(
                joint.layout,
                path.held,
                pattern,
                most=most,
                released=path.released,
                frames=frames,
                start=path.start,
                close=CLOSE,
            )
