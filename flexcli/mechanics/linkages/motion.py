"""The motion of a linkage at values of its input: pose of every link, deflection of every joint."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.linkages.equations import Loops, loops
from flexcli.mechanics.linkages.linkage import Linkage
from flexcli.numerics.loop_closure import CurvePoints

__all__ = ["LinkageMotion", "motion_of"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class LinkageMotion:
    """Deflection of every joint [rad or m] at values of the input, from the assembled pose.

    ``ratios`` are the first derivatives of the deflections by the input, ``curvatures`` the
    second; each array has the shape of ``input``. ``shifts`` and ``turns`` hold the poses by link.
    """

    input: Floats
    deflections: Mapping[str, Floats]
    ratios: Mapping[str, Floats]
    curvatures: Mapping[str, Floats]
    shifts: Mapping[str, tuple[Floats, Floats]]
    turns: Mapping[str, Floats]

    def position(self, link: str, point: tuple[float, float]) -> tuple[Floats, Floats]:
        """Return where a point of a link, given in the assembled pose, is [m]."""
        x, y = point
        (u, v), phi = self.shifts[link], self.turns[link]
        c, s = np.asarray(np.cos(phi)), np.asarray(np.sin(phi))
        return u + x * c - y * s, v + x * s + y * c


def motion_of(linkage: Linkage, inputs: Floats, solution: CurvePoints) -> LinkageMotion:
    """Return the motion of links and joints from solutions of the loop equations, one per input."""
    equations = loops(linkage)
    unit = equations.units()
    per_input = unit / unit[equations.input]
    q, first, second = solution
    slopes = equations.slopes(q)[..., 2, :]
    ratio = np.einsum("njk,nk->nj", slopes, first)
    bend = np.einsum("njk,nk->nj", slopes, second) + equations.bends(q, first)[..., 2]
    names = [joint.name for joint in linkage.joints]

    def by_joint(columns: Floats) -> dict[str, Floats]:
        return {name: columns[:, i].reshape(inputs.shape) for i, name in enumerate(names)}

    shifts, turns = _poses(linkage, equations, q, inputs.shape)
    return LinkageMotion(
        inputs,
        by_joint(equations.rows(q)[..., 2] * unit),
        by_joint(ratio * per_input),
        by_joint(bend * per_input / unit[equations.input]),
        shifts,
        turns,
    )


def _poses(
    linkage: Linkage, equations: Loops, q: Floats, shape: tuple[int, ...]
) -> tuple[dict[str, tuple[Floats, Floats]], dict[str, Floats]]:
    """Return shift of the origin [m] and rotation [rad] of every link."""
    w, phi = equations.poses(q)
    shift = equations.middles * (1.0 - np.exp(1j * phi)) + equations.size * w
    names = (*linkage.moving, linkage.ground)
    shifts = {
        name: (shift[:, i].real.reshape(shape), shift[:, i].imag.reshape(shape))
        for i, name in enumerate(names)
    }
    return shifts, {name: phi[:, i].reshape(shape) for i, name in enumerate(names)}
