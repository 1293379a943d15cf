"""Whether a linkage has exactly one degree of freedom, which its input drives."""

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.linkages.equations import loops
from flexcli.mechanics.linkages.linkage import Linkage

__all__ = ["require_one_freedom"]

Floats = NDArray[np.float64]

INDEPENDENT = 1e-9
"""Singular values below this share of the largest count as zero: coordinates are good to rounding,
and a linkage so near to a singular pose is of no use."""
TAKES_PART = 1e-6
"""Share of a null vector from which a link moves in it, or a joint repeats others."""


def require_one_freedom(linkage: Linkage) -> None:
    """Raise SolveError unless the assembled linkage has one degree of freedom and its input has it.

    The codes are ``under-constrained``, ``over-constrained``, ``singular-at-rest`` (constraints
    repeat each other in this pose) and ``dead-point-at-rest`` (the input cannot drive it).

    References
    ----------
    Gosselin & Angeles (1990), IEEE Trans. Robotics and Automation 6(3): the two kinds of
    singular pose.

    """
    equations = loops(linkage)
    driven = equations.jacobian(np.zeros(3 * equations.moving))
    C, count = driven[:-1], linkage.count
    free = 3 * len(linkage.moving) - _rank(C)
    if count > 1:
        raise SolveError(
            "under-constrained",
            f"the linkage has {free} degrees of freedom and one input",
            f"join or guide what moves with '{linkage.input}' held: {_loose(linkage, driven)}",
        )
    if count < 1 and free > 0:
        raise SolveError(
            "over-constrained",
            f"the linkage counts {count} degrees of freedom, yet has {free}: its joints repeat "
            f"each other ({_repeating(linkage, C)}) and it moves, if at all, for exact "
            "dimensions only",
            "leave out a link that only repeats the others, with its two joints",
        )
    if count < 1:
        raise SolveError(
            "over-constrained",
            f"the linkage counts {count} degrees of freedom: nothing in it can move",
            "take out a joint, or put a link with two joints in the place of one",
        )
    if free > 1:
        raise SolveError(
            "singular-at-rest",
            f"the linkage has {free} degrees of freedom as assembled, where it counts 1: "
            f"in this pose joints repeat each other ({_repeating(linkage, C)})",
            "assemble it in a pose in which its links do not line up, or move a joint",
        )
    if _rank(driven) < 3 * len(linkage.moving):
        raise SolveError(
            "dead-point-at-rest",
            f"the linkage moves with '{linkage.input}' at a standstill: a dead point",
            "drive another joint, or assemble it off the dead point",
        )


def _rank(matrix: Floats) -> int:
    s = np.linalg.svd(matrix, compute_uv=False)
    return int((s > INDEPENDENT * s.max(initial=0.0)).sum())


def _loose(linkage: Linkage, J: Floats) -> str:
    """Return the names of the links that move while the input is held."""
    motions = np.linalg.svd(J)[2][_rank(J) :]
    amount = np.abs(motions).reshape(-1, len(linkage.moving), 3).max(axis=(0, 2))
    return ", ".join(np.array(linkage.moving)[amount > TAKES_PART].tolist())


def _repeating(linkage: Linkage, C: Floats) -> str:
    """Return the names of the joints whose constraints depend on each other."""
    shares = np.linalg.svd(C)[0][:, _rank(C) :]
    amount = np.abs(shares).reshape(len(linkage.joints), -1).max(axis=1)
    names = np.array([joint.name for joint in linkage.joints])
    return ", ".join(names[amount > TAKES_PART].tolist())
