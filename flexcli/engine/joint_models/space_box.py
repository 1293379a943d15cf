"""The box around a joint in space: by small motion, and by exact beams at the ends of a stroke."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.space_errors import beam_errors
from flexcli.engine.joint_models.space_stroke import at_travel
from flexcli.errors import SolveError
from flexcli.formulas.rigid_motion import axes_about_z
from flexcli.mechanics.space.swept_box import SweptBox, swept_box
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask
from flexcli.parts.space_joint import joint_in_space
from flexcli.parts.space_states import poses

__all__ = ["exact_box", "linear_box"]

Floats = NDArray[np.float64]

Poses = tuple[Sequence[tuple[float, Floats]], float]


def linear_box(ask: Ask) -> tuple[SweptBox, tuple[str, ...]]:
    """Return the box by small motion to second order, and the bodies that have no outline."""
    joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
    return _box(ask, lambda: poses(joint, ask.scene))


def exact_box(ask: Ask) -> tuple[SweptBox, tuple[str, ...]]:
    """Return the box by exact beams, and the bodies that have no outline."""
    return _box(ask, lambda: _exact_poses(ask))


def _box(ask: Ask, moved: Callable[[], Poses]) -> tuple[SweptBox, tuple[str, ...]]:
    joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
    outlines = ask.geometry.outlines
    known, doubt = moved() if ask.scene.moves else ((), 0.0)
    found = swept_box(joint.layout, outlines, known, axes_about_z(ask.geometry.axes))
    bare = tuple(body.name for body in joint.layout.bodies if body.name not in outlines)
    return found._replace(doubt=found.doubt + doubt), bare


def _exact_poses(ask: Ask) -> Poses:
    """Return the motion of every body at the ends of the stroke, and how far off it is [m]."""
    scene, found, doubt = ask.scene, list[tuple[float, Floats]](), 0.0
    for travel in dict.fromkeys(scene.stroke_ends):
        if travel == 0.0:
            continue
        try:
            state = at_travel(ask, travel)
        except SolveError as error:
            raise NotAvailable(f"has no exact equilibrium: {error}") from error
        motion = np.array([state.motion_of(b.name, b.point) for b in state.layout.bodies])
        most = float(np.linalg.norm(motion[:, :3], axis=1).max())
        known = beam_errors(state)
        off = np.inf if known is None else known.shift * most + known.rest
        doubt = max(doubt, off)
        found.append((travel, motion))
    return found, doubt
