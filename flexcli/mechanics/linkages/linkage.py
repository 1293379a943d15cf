"""A planar linkage as assembled: rigid links, revolute and prismatic joints, ground and input.

Numbers are floats in the assembled pose, in which every deflection is zero. A deflection is the
motion of a joint's second link relative to its first: an angle, anticlockwise [rad], or a travel
along the joint's direction [m].
"""

from dataclasses import dataclass
from math import hypot, isfinite
from typing import NamedTuple, TypeAlias

__all__ = ["Joint", "Link", "Linkage", "Prismatic", "Revolute"]


class Link(NamedTuple):
    """A rigid link."""

    name: str


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
    """Links, the joints between them, ``ground`` (the link at rest), ``input`` (the joint driven).

    Raises
    ------
    ValueError
        For names given twice or unknown, a joint of a link with itself, a direction of no
        length, and coordinates that are not finite: all of them in one message.

    Examples
    --------
    >>> Linkage((Link("base"), Link("arm")), (Revolute("hub", "base", "arm", (0.0, 0.0)),),
    ...         ground="base", input="hubb")
    Traceback (most recent call last):
    ValueError: the input 'hubb' is no joint
    """

    links: tuple[Link, ...]
    joints: tuple[Joint, ...]
    ground: str
    input: str

    def __post_init__(self) -> None:
        links, joints = [link.name for link in self.links], [joint.name for joint in self.joints]
        mistakes = [f"two links are named '{name}'" for name in _repeated(links)]
        mistakes += [f"two joints are named '{name}'" for name in _repeated(joints)]
        if self.ground not in links:
            mistakes.append(f"the ground '{self.ground}' is no link")
        if self.input not in joints:
            mistakes.append(f"the input '{self.input}' is no joint")
        for joint in self.joints:
            mistakes += [f"joint '{joint.name}' {what}" for what in _mistakes(joint, links)]
        if mistakes:
            raise ValueError("; ".join(mistakes))

    @property
    def moving(self) -> tuple[str, ...]:
        """Return the names of the links that may move."""
        return tuple(link.name for link in self.links if link.name != self.ground)

    @property
    def count(self) -> int:
        """Return the degrees of freedom by count, 3 per moving link less 2 per joint [-]."""
        return 3 * len(self.moving) - 2 * len(self.joints)


def _repeated(names: list[str]) -> list[str]:
    return sorted({name for name in names if names.count(name) > 1})


def _mistakes(joint: Joint, links: list[str]) -> list[str]:
    """Return what is wrong with one joint."""
    place = joint.point if isinstance(joint, Revolute) else joint.direction
    ends = dict.fromkeys((joint.first, joint.second))
    found = [f"names the unknown link '{name}'" for name in ends if name not in links]
    if joint.first == joint.second:
        found.append(f"joins '{joint.first}' with itself")
    if not all(isfinite(coordinate) for coordinate in place):
        found.append("has a coordinate that is not finite")
    elif isinstance(joint, Prismatic) and hypot(*place) == 0.0:
        found.append("has a direction of no length")
    return found
