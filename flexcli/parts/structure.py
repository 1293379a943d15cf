"""A mechanism as a linear structure: rigid bodies on the springs of its joints, in one plane."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import cos, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Body", "Joint", "Spring", "Structure", "assemble"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Spring:
    """A joint in its own frame (x along its axis of symmetry): stiffness and stresses.

    ``stiffness`` (3, 3) about its centre; ``axial`` and ``faces`` rows of stress per deformation;
    ``holds_rotation`` says that the joint lets its body not turn at all.
    """

    stiffness: Floats
    axial: Floats
    faces: Floats
    holds_rotation: bool = False


class Body(NamedTuple):
    """A rigid body: mass [kg], inertia about its centre of mass [kg·m²], where that is [m].

    ``turns`` is false for a body that others keep from turning.
    """

    name: str
    mass: float
    inertia: float
    com: tuple[float, float] = (0.0, 0.0)
    turns: bool = True


@dataclass(frozen=True, eq=False)
class Joint:
    """A spring between two bodies (by name, or the ground) at a point [m], turned from x [rad]."""

    name: str
    first: str | None
    second: str
    point: tuple[float, float]
    orientation: float
    spring: Spring


@dataclass(frozen=True, eq=False)
class Structure:
    """Matrices of the free coordinates, base influence per axis, and rows of outputs.

    Coordinates are motions relative to the base. ``outputs`` holds rows (k, n): travel [m],
    per joint the force in its frame [N], axial stress and stress at the faces [Pa].
    """

    mass: Floats
    stiffness: Floats
    influence: Mapping[str, Floats]
    outputs: Mapping[str, Floats] = field(default_factory=dict)


def assemble(
    bodies: Sequence[Body], joints: Sequence[Joint], travel: tuple[str, str] | None
) -> Structure:
    """Return the structure of bodies and joints; a body that is not listed is the ground.

    ``travel`` names the body whose motion along x is the travel, and the output's name.
    """
    at = {body.name: 3 * index for index, body in enumerate(bodies)}
    size = 3 * len(bodies)
    mass, stiffness = np.zeros((size, size)), np.zeros((size, size))
    for body in bodies:
        motion = _motion(body.com)
        block = slice(at[body.name], at[body.name] + 3)
        mass[block, block] += motion.T @ np.diag([body.mass, body.mass, body.inertia]) @ motion
    outputs: dict[str, Floats] = {}
    held = [at[body.name] + 2 for body in bodies if not body.turns]
    for joint in joints:
        rows = np.zeros((3, size))
        for name, sign in ((joint.second, 1.0), (joint.first, -1.0)):
            if name in at:
                rows[:, at[name] : at[name] + 3] += sign * _motion(joint.point)
        rows = _turned(joint.orientation) @ rows
        stiffness += rows.T @ joint.spring.stiffness @ rows
        outputs[f"force {joint.name}"] = (joint.spring.stiffness @ rows)[:2]
        outputs[f"axial stress {joint.name}"] = joint.spring.axial @ rows
        outputs[f"stress {joint.name}"] = joint.spring.faces @ rows
        if joint.spring.holds_rotation:
            held += [at[name] + 2 for name in (joint.first, joint.second) if name in at]
    if travel is not None and travel[0] in at:
        row = np.zeros((1, size))
        row[0, at[travel[0]]] = 1.0
        outputs[travel[1]] = row
    free = np.setdiff1d(np.arange(size), held)
    influence = {
        axis: np.tile(unit, len(bodies))[free]
        for axis, unit in (("x", (1.0, 0.0, 0.0)), ("y", (0.0, 1.0, 0.0)))
    }
    return Structure(
        mass[np.ix_(free, free)],
        stiffness[np.ix_(free, free)],
        influence,
        {name: rows[:, free] for name, rows in outputs.items()},
    )


def _motion(point: tuple[float, float]) -> Floats:
    """Return the motion of a point per motion (x, y, φ) of its body at the origin."""
    x, y = point
    return np.array([[1.0, 0.0, -y], [0.0, 1.0, x], [0.0, 0.0, 1.0]])


def _turned(angle: float) -> Floats:
    """Return the turn from the plane's axes to those of a joint at an angle from x."""
    return np.array(
        [[cos(angle), sin(angle), 0.0], [-sin(angle), cos(angle), 0.0], [0.0, 0.0, 1.0]]
    )
