"""A joint of hinges where a stroke has brought it: its springs between bodies as they stand."""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.space_errors import hinges_more, springs_without_blocks
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.rotation import (
    conjugate,
    matrix_of,
    moved,
    product,
    quaternion_of,
    vector_of,
)
from flexcli.mechanics.space.layout import SpaceBlade, SpaceLayout, Vector, vector
from flexcli.mechanics.space.springs import MemberSprings
from flexcli.parts.requirements import Ask
from flexcli.parts.requirements.support import joint_of_model
from flexcli.parts.space_joint import SpaceJoint

__all__ = ["Pose", "pose_of", "posed"]

Floats = NDArray[np.float64]


class Pose(NamedTuple):
    """A joint of hinges as a stroke leaves it, by its best springs and by those of its beams.

    ``more`` is by how much more than at rest its springs may be off.
    """

    joint: SpaceJoint
    beams: SpaceJoint
    more: float


def pose_of(ask: Ask, state: SpaceEquilibrium) -> Pose | None:
    """Return a joint of hinges as it stands in a state of beams, None where it has other parts."""
    more = hinges_more(state)
    if more is None or state.layout.springs:
        return None
    roots = ask.geometry.root_springs(ask.sizes, ask.material.elastic.most_nu)
    blades = (blade for blade in state.layout.blades if isinstance(blade, SpaceBlade))
    best = posed(state, joint_of_model(ask).assembly.members)
    beams = posed(state, [springs_without_blocks(blade) for blade in blades])
    return Pose(SpaceJoint(*best, roots), SpaceJoint(*beams), more)


def posed(
    state: SpaceEquilibrium, members: Sequence[MemberSprings]
) -> tuple[SpaceLayout, tuple[MemberSprings, ...]]:
    """Return a joint as it stands in a state, unstrained there, and its springs.

    The springs of a blade are along the chord of its ends, in their middle as seen from either, and
    turned by half of what these turn against each other: where a hinge in its middle is, or a body
    between two hinges.

    Parameters
    ----------
    state : SpaceEquilibrium
        Of a layout of blades without growth.
    members : sequence of MemberSprings
        Their springs at rest.

    """
    layout = state.layout
    bodies = tuple(
        body._replace(point=_at(state, body.name, body.point), com=_at(state, body.name, body.com))
        for body in layout.bodies
    )
    blades, found = [], []
    for blade, member in zip(layout.blades, members, strict=True):
        assert isinstance(blade, SpaceBlade)  # hinges are
        first, second = state.quaternion(blade.first), state.quaternion(blade.second)
        half = quaternion_of(vector_of(product(conjugate(first), second)) / 2.0)
        turn = matrix_of(product(first, half))
        start, end = (
            np.array(_at(state, name, place))
            for name, place in ((blade.first, blade.start), (blade.second, blade.end))
        )
        reach = member.l / 2.0 * member.axes[0]
        middle = (start + end + moved(first, reach) - moved(second, reach)) / 2.0
        chord = (end - start) / np.linalg.norm(end - start)
        drawn = replace(
            blade,
            start=vector(middle - member.l / 2.0 * chord),
            end=vector(middle + member.l / 2.0 * chord),
            width=vector(turn @ np.asarray(blade.width)),
        )
        blades.append(drawn)
        found.append(member._replace(axes=drawn.axes))
    drive = layout.drive
    there = drive._replace(point=_at(state, drive.body, drive.point))
    return replace(layout, bodies=bodies, blades=tuple(blades), drive=there), tuple(found)


def _at(state: SpaceEquilibrium, body: str, point: Vector) -> Vector:
    """Return where a point of a body is."""
    return vector(np.asarray(point) + state.shift_of(body, point))
