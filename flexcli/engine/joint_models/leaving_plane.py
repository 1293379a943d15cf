"""Buckling out of its plane of a drawn, necked, hinged or tilting joint, under a force in it.

Blades hardly wider than thick bend aside with the bodies between them before they buckle in their
plane, or turn over aside as they are pulled, and blades side by side pull at different heights.
Other joints have one blade's load across its width; of these the whole is looked at in space, as
nothing but blades holds a body with free ends there.
"""

from collections.abc import Iterator, Sequence
from math import cos, inf, sin

from flexcli.engine.joint_models.dead_loads import loads_of
from flexcli.engine.joint_models.soft_blocks import hinge_alone_off, with_soft_blocks
from flexcli.engine.joint_models.space_exact import SpaceExactModel
from flexcli.errors import SolveError
from flexcli.mechanics.space.exact.critical import straight_critical_factor
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.layout import SpaceLayout, SpaceLoad
from flexcli.numerics.rows import one_alone
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Critical
from flexcli.parts.requirements import Ask
from flexcli.parts.scene import Push, Scene
from flexcli.parts.space_joint import joint_of
from flexcli.parts.space_states import acting_groups, acting_together
from flexcli.results import ErrorRange

__all__ = ["leaving_plane"]

WAY = "out of its plane or in it"

IN_SPACE = "blades and bodies in space, exact beams"
STRAIGHT = "blades and bodies in space that stay straight"

SURELY = 0.8
"""Share of how far it is looked, from which on what stands there stands."""

BOWED = 0.1
"""By how much less a joint may bear than one whose blades stay straight: as plates or beams of
springs in space differ from it, beside what its hinges or its softest spring may lack."""

TILTED = 0.7
"""The same where forces at different heights tilt the body from the first on, far more than was
seen: of eight pivots exact beams in space bore 1.04 to 1.85 of it, and two stood at 0.75, where no
end of their path was found."""

FAR = 1e6
"""Times the force up to which the straight joint is looked at."""


def leaving_plane(ask: Ask, *, space: SpaceExactModel | None) -> Iterator[Critical]:
    """Yield the force at which such a joint buckles in space, in each of the senses it may have.

    Without a model in space that of blades which stay straight, at rest, as the lower end of a
    range; at a stroke nobody then knows.
    """
    scene = ask.scene
    if not scene.leaves_plane:
        return
    one_alone()
    for push in scene.pushes():
        pushed = ask._replace(scene=_pushed(scene, push))
        if space is None:
            yield from _straight(pushed)
            continue
        for found in space.critical_shares(pushed):
            unending = found.error is not None and found.error.high == inf
            if unending and found.least > SURELY * ask.most_share:
                continue  # nothing buckles it as far as anybody asks
            force = found.share * scene.force
            yield Critical(WAY, force, IN_SPACE, found.stress / force, found.error)


def _pushed(scene: Scene, push: Push) -> Scene:
    """Return a case with one resultant of its forces alone, its body free."""
    x, y = push.force * cos(push.direction), push.force * sin(push.direction)
    stated = (x, y, 0.0, 0.0, 0.0, 0.0)
    return scene._replace(stated=stated, inertial=(), accelerations=(), ends=None)


def _straight(ask: Ask) -> Iterator[Critical]:
    """Yield what buckles blades that stay straight, if anything: all that is known at rest."""
    joint = joint_of(ask)
    groups = acting_groups(joint, ask.scene)
    pattern = [load for each in groups for load in loads_of(joint, each)]
    factor = _of_straight(joint.layout, pattern)
    if factor < inf:
        low = 1.0 - (TILTED if ask.scene.tilts else BOWED)
        soft = with_soft_blocks(joint.layout)
        if soft is None:
            low *= 1.0 + float(joint.low.min())
        else:
            low *= _of_straight(soft, pattern) / factor * (1.0 - hinge_alone_off(joint.layout))
        known = None if ask.scene.moves or not joint.is_known else ErrorRange(low - 1.0, inf)
        (state,) = acting_together(joint, groups, [[1.0] * len(groups)], locked=False)
        stress = state.compression / ask.scene.force
        yield Critical(WAY, factor * ask.scene.force, STRAIGHT, stress, known)


def _of_straight(layout: SpaceLayout, pattern: Sequence[SpaceLoad]) -> float:
    """Return the factor on loads at which blades that stay straight buckle, up to ``FAR``."""
    try:
        return straight_critical_factor(
            layout, None, pattern, most=FAR, frames=drive_frame(layout.drive)
        )
    except SolveError as error:
        raise NotAvailable(f"has no buckling load in space: {error}") from error
