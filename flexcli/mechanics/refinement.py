"""An equilibrium followed from its start and refined, level by level, until it is accurate enough.

What is discretised plays no part: blades in the plane or in space, one design or a batch.
"""

from collections.abc import Sequence
from enum import Enum
from typing import Any, NamedTuple, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.continuation import TRUST, March, march
from flexcli.numerics.newton import NewtonEnd, NewtonResult, newton

__all__ = ["LEVELS", "Discretised", "Outcome", "Reached", "Refined", "difference", "refined"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

LEVELS = (8, 12, 18, 27, 40, 60, 90, 135)
"""Gauss nodes on a piece, level by level; each level tells the error of the one before."""

_NOTHING = 1e-280
"""Size of the unknowns below which numbers have no digits left, and no error."""

_NEWTON = 1e-3
"""Newton's tolerance over the tolerance asked."""


class Outcome(Enum):
    """How the solution of one design ended, with the remedy."""

    CONVERGED = "converged"
    TURNED = (
        "the path from rest turns or branches before the demand is met: "
        "hold a motion in place of the load, or follow the path by arc length"
    )
    SINGULAR = (
        "the mechanism at rest has no unique answer: hold or support every body, and let blades "
        "extend where more of them than needed share a load"
    )
    INACCURATE = (
        "the finest nodes do not reach the tolerance: ask for less, or take out what makes the "
        "forces so large (blades held against stretching, boundary layers)"
    )


class Discretised(Protocol):
    """A mechanism and its demand at one number of nodes; x are rows of unknowns, one a design."""

    @property
    def nodes(self) -> int:
        """Return the Gauss nodes on a piece."""

    def step(self, x: Floats, share: Floats, rows: Integers) -> Floats:
        """Return Newton's steps of the designs ``rows`` at the shares λ of the way."""

    def length_of(self, x: Floats, step: Floats) -> Floats:
        """Return the lengths of steps [-]."""

    def unstable(self, x: Floats, share: Floats, rows: Integers) -> Integers:
        """Return in how many directions equilibria are unstable."""

    def at_nodes(self, nodes: int) -> Self:
        """Return the same at another number of nodes."""

    def finer(self, fine: Self, x: Floats) -> Floats:
        """Return unknowns interpolated to the nodes of a finer one."""

    def changed(self, fine: Self, x: Floats, y: Floats, scale: Floats) -> Floats:
        """Return by how much x differs from y, solved with finer nodes [-]."""


class Reached(NamedTuple):
    """Designs ``rows`` that ended at the same number of nodes: unknowns x at the share λ."""

    at: Any
    rows: Integers
    x: Floats
    share: Floats


class Refined(NamedTuple):
    """How each design ended: outcome, share reached, iterations, error, nodes; the unknowns.

    ``coarser`` are the unknowns on the level before.
    """

    outcome: tuple[Outcome, ...]
    reached: Floats
    iterations: Integers
    error: Floats
    nodes: Integers
    parts: tuple[Reached, ...]
    coarser: tuple[Reached, ...]


def refined(
    coarse: Discretised, x: Floats, tolerance: float, levels: Sequence[int] = LEVELS
) -> Refined:
    """Return where the path from x leads, solved on finer nodes until the error is small enough.

    Parameters
    ----------
    coarse : Discretised
        The mechanism on the first level.
    x : array, shape (designs, unknowns)
        Equilibria at the start of the path.
    tolerance : float
        Error [-], as ``changed`` measures it.
    levels : sequence of int
        Gauss nodes on a piece; a single one is taken as it is, its error unknown.

    """
    designs = x.shape[0]
    scale = coarse.length_of(x, x)
    path = _march(coarse, x, scale, tolerance)
    iterations, error = path.iterations.copy(), np.full(designs, np.inf)
    nodes = np.full(designs, levels[0], dtype=np.intp)
    came = path.reached > 0.0
    outcome = [_outcome(path, i) for i in range(designs)]
    parts: list[Reached] = []
    before: list[Reached] = []
    _keep(parts, coarse, ~came | (len(levels) == 1), path.x, path.reached)
    rows, x, share = np.flatnonzero(came), path.x[came], path.reached[came]
    for level in levels[1:]:
        if rows.size == 0:
            break
        fine = coarse.at_nodes(level)
        guess = coarse.finer(fine, x)
        found = _newton(fine, guess, share, rows, scale[rows], tolerance)
        iterations[rows] += found.iterations
        change = coarse.changed(fine, x, found.x, scale[rows])
        # what Newton's method did not finish is no equilibrium: the coarser one stands in for it
        kept = np.where(found.converged[:, None], found.x, guess)
        error[rows] = np.where(found.converged, change, np.inf)
        nodes[rows] = level
        # a path that ended by turning ends where no digit is sure
        done = (found.converged & (change <= tolerance)) | (share < 1.0)
        last = level == levels[-1]
        _keep(parts, fine, done | last, kept, share, rows)
        _keep(before, coarse, done | last, x, share, rows)
        for i in rows[~done & (share == 1.0)] if last else ():
            outcome[i] = Outcome.INACCURATE
        rows, x, share, coarse = rows[~done], kept[~done], share[~done], fine
        if last:
            break
    return Refined(
        tuple(outcome), path.reached, iterations, error, nodes, tuple(parts), tuple(before)
    )


def _newton(
    at: Discretised,
    x: Floats,
    share: Floats,
    rows: Integers,
    scale: Floats,
    tolerance: float,
    trust: float = np.inf,
) -> NewtonResult:
    return newton(
        lambda x_of, of: at.step(x_of, share[of], rows[of]),
        at.length_of,
        x,
        tolerance=_NEWTON * tolerance,
        scale=scale,
        trust=trust,
    )


def _march(at: Discretised, x: Floats, scale: Floats, tolerance: float) -> March:
    """Return the path from x."""

    def correct(x_of: Floats, share: Floats, rows: Integers) -> NewtonResult:
        return _newton(at, x_of, share, rows, scale[rows], tolerance, TRUST)

    return march(correct, at.step, at.length_of, at.unstable, x)


def _outcome(path: March, design: int) -> Outcome:
    if path.reached[design] == 1.0:
        return Outcome.CONVERGED
    if path.reached[design] == 0.0 and path.end[design] is NewtonEnd.SINGULAR:
        return Outcome.SINGULAR
    return Outcome.TURNED


def _keep(
    parts: list[Reached],
    at: Discretised,
    which: NDArray[np.bool_],
    x: Floats,
    share: Floats,
    rows: Integers | None = None,
) -> None:
    if np.any(which):
        index = np.flatnonzero(which) if rows is None else rows[which]
        parts.append(Reached(at, index, x[which], share[which]))


def difference(
    before: tuple[Floats, Floats], after: tuple[Floats, Floats], stretch: float, scale: Floats
) -> Floats:
    """Return by how much forces and motions at two levels differ, over the largest of each.

    Parameters
    ----------
    before, after : tuple of array, shape (designs, …)
        Scaled forces of the blades and motions of the bodies at both levels.
    stretch : float
        Stretch of the stiffest blade under a force that bends it by its length [-].
    scale : array, shape (designs,)
        Length of the unknowns at the start [-].

    Notes
    -----
    What stands still under forces is measured by how much they stretch a blade, and what bears
    nothing where it is by the forces that bend one as far: neither scale vanishes by itself.

    """
    (forces, motions), (fine_forces, fine_motions) = before, after
    pulled, moved = (_largest(each) for each in after)
    change = np.zeros(scale.shape)
    for a, b, size in (
        (forces, fine_forces, np.maximum(pulled, moved)),
        (motions, fine_motions, np.maximum(moved, stretch * pulled)),
    ):
        over = np.maximum(np.maximum(scale, size), _NOTHING)
        change = np.maximum(change, _largest(b - a) / over)
    return change


def _largest(values: Floats) -> Floats:
    flat = np.abs(values).reshape(values.shape[0], -1)
    return np.asarray(np.max(flat, axis=1, initial=0.0))
