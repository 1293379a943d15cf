"""Linear systems for many designs at once, some of which may be singular."""

import numpy as np
from numpy.typing import NDArray

__all__ = ["PIVOT", "solve_across", "solve_stack"]

Floats = NDArray[np.float64]

_SMALL = 12
"""Unknowns up to which a stack is eliminated at once: one by one takes four times as long."""

_AT_ONCE = 1024
"""Systems that are eliminated together: so many fit in a core's cache."""

PIVOT = 0.3
"""Pivot of a matrix of order one below which rows are exchanged, by LAPACK: a smaller one loses
digits that a stiffness near buckling needs."""


def solve_stack(A: Floats, b: Floats) -> Floats:
    """Return x of ``A x = b`` for every matrix of a stack; NaN where a matrix is singular.

    Parameters
    ----------
    A : array, shape (..., n, n)
        Matrices.
    b : array, shape (..., n, m)
        Right-hand sides.

    Returns
    -------
    array, shape (..., n, m)
        Solutions; one singular matrix spoils no other.

    Examples
    --------
    >>> solve_stack(np.array([[[2.0]], [[0.0]]]), np.ones((2, 1, 1))).ravel().tolist()
    [0.5, nan]

    """
    try:
        return np.asarray(np.linalg.solve(A, b))
    except np.linalg.LinAlgError:
        x = np.full(np.broadcast_shapes((*A.shape[:-1], 1), b.shape), np.nan)
        for index in np.ndindex(A.shape[:-2]):
            try:
                x[index] = np.linalg.solve(A[index], b[index])
            except np.linalg.LinAlgError:
                continue
        return x


def solve_across(system: Floats) -> Floats:
    """Return x of ``A x = b`` for a stack whose last axis runs over the systems.

    Small systems are eliminated in many matrices at once, without exchanging rows; where a pivot
    is small, and where systems are large, LAPACK solves. The digits of a system hang on no other.

    Parameters
    ----------
    system : array, shape (p, n, n + m, designs)
        Matrices of order one with a large diagonal, mostly; behind them the right-hand sides.

    Returns
    -------
    array, shape (p, n, m, designs)
        Solutions; NaN where a matrix is singular.

    Examples
    --------
    >>> system = np.array([[2.0, 1.0, 5.0], [1.0, 3.0, 10.0]])[None, :, :, None]
    >>> solve_across(system).ravel().tolist()
    [1.0, 3.0]

    """
    n, designs = system.shape[1], system.shape[3]
    if n > _SMALL:
        stack = system.transpose(0, 3, 1, 2)
        return np.asarray(solve_stack(stack[..., :n], stack[..., n:]).transpose(0, 2, 3, 1))
    if designs <= _AT_ONCE:
        return _eliminated(system)
    x = np.empty((*system.shape[:2], system.shape[2] - n, designs))
    for first in range(0, designs, _AT_ONCE):
        some = slice(first, first + _AT_ONCE)
        x[..., some] = _eliminated(system[..., some])
    return x


def _eliminated(system: Floats) -> Floats:
    """Return x by Gauss's elimination of all systems at once."""
    T = system.copy()
    p, n, width, designs = T.shape
    x = T[:, :, n:]
    with np.errstate(all="ignore"):  # a pivot of zero spoils its own system, which LAPACK solves
        for k in range(n):
            row, below = T[:, k, k + 1 :], T[:, k + 1 :, k + 1 :]
            row /= T[:, k, k, None]
            below -= T[:, k + 1 :, k, None] * row[:, None]
        for k in range(n - 1, 0, -1):
            above = x[:, :k]
            above -= T[:, :k, k, None] * x[:, k, None]
    # the column of each pivot was left as it stood
    pivots = T.reshape(p, n * width, designs)[:, :: width + 1]
    small = ~(np.abs(pivots).min(axis=1) > PIVOT)
    if small.any():
        i, j = np.nonzero(small)
        left = system[i, :, :, j]
        x[i, :, :, j] = solve_stack(left[..., :n], left[..., n:])
    return x
