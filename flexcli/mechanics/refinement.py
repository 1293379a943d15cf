"""An equilibrium followed from its start and refined, level by level, until it is accurate enough.

What is discretised plays no part: blades in the plane or in space, one design or a batch.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import Outcome
from flexcli.numerics.continuation import BENT, TRUST, March, march
from flexcli.numerics.newton import BENDS, NewtonResult, newton

__all__ = [
    "LEVELS",
    "Discretised",
    "Reached",
    "Refined",
    "by_steps",
    "difference",
    "refined",
]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

LEVELS = (8, 12, 18, 27, 40, 60, 90, 135)
"""Gauss nodes on a piece, level by level; each level tells the error of the one before."""

_NEAR = 0.23
"""Length of the unknowns up to which few nodes are tried: forces up to a third of a column's,
whose tangent they give too."""

_NOTHING = 1e-280
"""Size of the unknowns below which numbers have no digits left, and no error."""

_NEWTON = 1e-3
"""Newton's tolerance over the tolerance asked."""

_ROUGH = 30.0
"""The same on a level that may not be the last: where it is not, the next tells what Newton's
method left as well, and the step that it expects is some times longer than the one that comes."""

_DIGITS = 1e-7
"""Newton's tolerance on any such level at most: what is read off it beside the next has digits."""

_SURE = 10.0
"""How much more Newton's steps may bend on finer nodes than they did on few."""


class Discretised(Protocol):
    """A mechanism and its demand at one number of nodes; x are rows of unknowns, one a design."""

    @property
    def nodes(self) -> int:
        """Return the Gauss nodes on a piece."""

    def step(self, x: Floats, share: Floats, rows: Integers) -> Floats:
        """Return Newton's steps of the designs ``rows`` at the shares λ of the way."""

    def newton(
        self,
        x: Floats,
        share: Floats,
        rows: Integers,
        *,
        scale: Floats,
        tolerance: float,
        bends: Floats | None = None,
        trust: float = np.inf,
    ) -> NewtonResult:
        """Return where Newton's method leads from x (``flexcli.numerics.newton``)."""

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
    coarse: Discretised,
    x: Floats,
    tolerance: float,
    levels: Sequence[int] = LEVELS,
    few: Discretised | None = None,
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
    few : Discretised, optional
        The mechanism on fewer nodes, for paths from rest that are nearly straight and end near it.

    """
    designs = x.shape[0]
    scale = coarse.length_of(x, x)
    iterations, error = np.zeros(designs, dtype=np.intp), np.full(designs, np.inf)
    outcome, reached = [Outcome.CONVERGED] * designs, np.ones(designs)
    nodes = np.full(designs, levels[0], dtype=np.intp)
    parts: list[Reached] = []
    before: list[Reached] = []
    rows, bent, at = np.arange(0), np.arange(designs), coarse
    here, share, bends = x[:0], np.zeros(0), np.full(designs, BENDS)
    if few is not None:
        share = np.ones(designs)
        tried = few.newton(
            coarse.finer(few, x), share, bent,
            scale=scale, bends=bends, tolerance=_rough(tolerance, 1.0), trust=BENT,
        )  # fmt: skip
        iterations += tried.iterations
        near = tried.converged & (tried.length <= _NEAR)
        bends = np.where(near, np.clip(_SURE * tried.bends, 1.0, BENDS), BENDS)
        rows, bent, at = np.flatnonzero(near), np.flatnonzero(~near), few
        here, share = tried.x[rows], share[rows]
    for level in levels:
        fine = coarse if level == levels[0] else coarse.at_nodes(level)
        last = level == levels[-1]
        if rows.size:
            guess = at.finer(fine, here)
            found = fine.newton(
                guess, share, rows,
                scale=scale[rows], bends=bends[rows], tolerance=_rough(tolerance, _ROUGH),
            )  # fmt: skip
            change = at.changed(fine, here, found.x, scale[rows])
            small = change <= tolerance
            found = _ended(fine, found, small | last, share, rows, scale, tolerance)
            converged = found.converged
            iterations[rows] += found.iterations
            # what Newton's method did not finish is no equilibrium: the coarser stands in for it
            kept = np.where(converged[:, None], found.x, guess)
            error[rows] = np.where(converged, change, np.inf)
            nodes[rows] = level
            # a path that ended by turning ends where no digit is sure
            done = (converged & small) | (share < 1.0)
            _keep(parts, fine, done | last, kept, share, rows)
            _keep(before, at, done | last, here, share, rows)
            for i in rows[~done & (share == 1.0)] if last else ():
                outcome[i] = Outcome.INACCURATE
            rows, here, share = rows[~done], kept[~done], share[~done]
        if bent.size:
            path = _march(coarse, x[bent], bent, scale, tolerance)
            iterations[bent] += path.iterations
            reached[bent] = path.reached
            for i, design in enumerate(bent):
                outcome[design] = _outcome(path, i)
            came = path.reached > 0.0
            _keep(parts, coarse, ~came | last, path.x, path.reached, bent)
            here = np.concatenate([here if rows.size else x[:0], path.x[came]])
            rows = np.concatenate([rows, bent[came]])
            share, bent = np.concatenate([share, path.reached[came]]), bent[:0]
        at = fine
        if rows.size == 0:
            break
    return Refined(tuple(outcome), reached, iterations, error, nodes, tuple(parts), tuple(before))


def by_steps(at: Discretised, x: Floats, share: Floats, rows: Integers, **how: Any) -> NewtonResult:
    """Return where Newton's method leads by the steps of what is discretised."""
    return newton(lambda x_of, of: at.step(x_of, share[of], rows[of]), at.length_of, x, **how)


def _rough(tolerance: float, times: float) -> float:
    """Return Newton's tolerance where finer nodes may follow."""
    return max(_NEWTON * tolerance, min(times * tolerance, _DIGITS))


def _newton(
    at: Discretised,
    x: Floats,
    share: Floats,
    rows: Integers,
    scale: Floats,
    tolerance: float,
    trust: float = np.inf,
) -> NewtonResult:
    return at.newton(x, share, rows, scale=scale, tolerance=_NEWTON * tolerance, trust=trust)


def _ended(
    at: Discretised,
    found: NewtonResult,
    last: NDArray[np.bool_],
    share: Floats,
    rows: Integers,
    scale: Floats,
    tolerance: float,
) -> NewtonResult:
    """Return what Newton's method found, gone on with where it is the ``last`` and still rough."""
    size = np.minimum(1.0, np.maximum(scale[rows], found.length))
    rough = found.bends * found.last_step**2 > _NEWTON * tolerance * size
    rough &= last & found.converged
    if not rough.any():
        return found
    more = _newton(at, found.x[rough], share[rough], rows[rough], scale[rows[rough]], tolerance)
    x, end, iterations = found.x.copy(), found.end.copy(), found.iterations.copy()
    x[rough], end[rough] = more.x, more.end
    iterations[rough] += more.iterations
    return found._replace(x=x, end=end, iterations=iterations)


def _march(at: Discretised, x: Floats, designs: Integers, scale: Floats, tolerance: float) -> March:
    """Return the path of some designs from x."""

    def correct(x_of: Floats, share: Floats, rows: Integers) -> NewtonResult:
        return _newton(at, x_of, share, designs[rows], scale[designs[rows]], tolerance, TRUST)

    return march(
        correct,
        lambda x_of, share, rows: at.step(x_of, share, designs[rows]),
        at.length_of,
        lambda x_of, share, rows: at.unstable(x_of, share, designs[rows]),
        x,
    )


def _outcome(path: March, design: int) -> Outcome:
    if path.reached[design] == 1.0:
        return Outcome.CONVERGED
    if path.reached[design] == 0.0 and path.end[design] is Outcome.SINGULAR:
        return Outcome.SINGULAR
    return Outcome.TURNED


def _keep(
    parts: list[Reached],
    at: Discretised,
    which: NDArray[np.bool_],
    x: Floats,
    share: Floats,
    rows: Integers,
) -> None:
    if which.all():
        parts.append(Reached(at, rows, x, share))
    elif which.any():
        parts.append(Reached(at, rows[which], x[which], share[which]))


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
    least = np.maximum(scale, _NOTHING)
    pull = np.maximum(least, np.maximum(pulled, moved))
    move = np.maximum(least, np.maximum(moved, stretch * pulled))
    return np.maximum(
        _largest(fine_forces - forces) / pull, _largest(fine_motions - motions) / move
    )


def _largest(values: Floats) -> Floats:
    flat = np.abs(values).reshape(values.shape[0], -1)
    return np.asarray(flat.max(axis=1, initial=0.0))
