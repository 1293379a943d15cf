"""Parts of a body whose inner motions are eliminated where they are known by those at its edge."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cholesky, solve_triangular

__all__ = ["Elimination", "Part", "joined", "without"]

Floats = NDArray[np.float64]
Numbers = NDArray[np.intp]


class Part(NamedTuple):
    """A part of a body: the numbers of its motions, and its stiffness to them (n, n)."""

    motions: Numbers
    K: Floats


class Elimination(NamedTuple):
    """Motions ``out`` of a part, which are those that are ``kept`` times −L⁻ᵀ ``by``."""

    out: Numbers
    kept: Numbers
    L: Floats
    by: Floats

    def recover(self, u: Floats) -> None:
        """Put them into all motions, in which those that are kept stand."""
        u[self.out] = solve_triangular(
            self.L, -self.by @ u[self.kept], lower=True, trans="T", check_finite=False
        )


def joined(parts: Sequence[Part]) -> Part:
    """Return parts that share some of their motions as one."""
    motions = np.unique(np.concatenate([part.motions for part in parts]))
    K = np.zeros((motions.size, motions.size))
    for part in parts:
        at = np.searchsorted(motions, part.motions)
        K[np.ix_(at, at)] += part.K
    return Part(motions, K)


def without(part: Part, out: Numbers) -> tuple[Part, Elimination]:
    """Return a part without some of its motions, which bear no forces, and what they are.

    Raises
    ------
    scipy.linalg.LinAlgError
        When nothing keeps these motions.

    """
    is_out = np.zeros(int(part.motions.max()) + 1, dtype=bool)
    is_out[out] = True
    gone, kept = np.flatnonzero(is_out[part.motions]), np.flatnonzero(~is_out[part.motions])
    L = cholesky(part.K[np.ix_(gone, gone)], lower=True, check_finite=False)
    by = solve_triangular(L, part.K[np.ix_(gone, kept)], lower=True, check_finite=False)
    rest = Part(part.motions[kept], part.K[np.ix_(kept, kept)] - by.T @ by)
    return rest, Elimination(part.motions[gone], rest.motions, L, by)
