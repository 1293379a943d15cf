"""A planar linkage as assembled: rigid links, revolute and prismatic joints, ground and input.

Links have neither mass nor elasticity, so that a name is all there is to one: what moves them is
the geometry of their joints, at any amplitude. Bodies with mass on springs are in
:mod:`flexcli.mechanics.layout`.

Numbers are floats in the assembled pose, in which every deflection is zero. A deflection is the
motion of a joint's second link relative to its first: an angle, anticlockwise [rad], or a travel
along the joint's direction [m].
"""

from dataclasses import dataclass
from math import hypot, isfinite
from typing import NamedTuple, TypeAlias

__all__ = ["Joint", "Linkage", "Prismatic", "Revolute"]


class Revolute(NamedTuple):
    """A pivot at a point [m] common to two links."""

    name: str
    first: str
    second: str
    point: tuple[float, float]


class Prismatic(NamedTuple):
    """A linear stage along a direction that is fixed to the first link; any length of it will do.

    Where the stage stands does not matter to the motion of rigid links.
    """

    name: str
    first: str
    second: str
    direction: tuple[float, float]


Joint: TypeAlias = Revolute | Prismatic


@dataclass(frozen=True)
class Linkage:
    """Joints between links, ``ground`` (the link at rest), ``input`` (the joint driven).

    Raises
    ------
    ValueError
        For joints named twice, an unknown ground or input, a joint of a link with itself, a
        direction of no length, and coordinates that are not finite: all of them in one message.

    Examples
    --------
    >>> Linkage((Revolute("hub", "base", "arm", (0.0, 0.0)),), ground="base", input="hubb")
    Traceback (most recent call last):
    ValueError: the input 'hubb' is no joint
    """

    joints: tuple[Joint, ...]
    ground: str
    input: str

    def __post_init__(self) -> None:
        joints = [joint.name for joint in self.joints]
        repeated = sorted({name for name in joints if joints.count(name) > 1})
        mistakes = [f"two joints are named '{name}'" for name in repeated]
        if self.ground not in self.links:
            mistakes.append(f"the ground '{self.ground}' is no link")
        if self.input not in joints:
            mistakes.append(f"the input '{self.input}' is no joint")
        for joint in self.joints:
            mistakes += [f"joint '{joint.name}' {what}" for what in _mistakes(joint)]
        if mistakes:
            raise ValueError("; ".join(mistakes))

    @property
    def links(self) -> tuple[str, ...]:
        """Return the names of all links, in the order in which the joints name them."""
        return tuple(dict.fromkeys(name for j in self.joints for name in (j.first, j.second)))

    @property
    def moving(self) -> tuple[str, ...]:
        """Return the names of the links that may move."""
        return tuple(name for name in self.links if name != self.ground)

    @property
    def count(self) -> int:
        """Return the degrees of freedom by count, 3 per moving link less 2 per joint [-]."""
        return 3 * len(self.moving) - 2 * len(self.joints)


def _mistakes(joint: Joint) -> list[str]:
    """Return what is wrong with one joint."""
    place = joint.point if isinstance(joint, Revolute) else joint.direction
    found = []
    if joint.first == joint.second:
        found.append(f"joins '{joint.first}' with itself")
    if not all(isfinite(coordinate) for coordinate in place):
        found.append("has a coordinate that is not finite")
    elif isinstance(joint, Prismatic) and hypot(*place) == 0.0:
        found.append("has a direction of no length")
    return found
