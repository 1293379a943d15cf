"""Linear systems for many designs at once, of which some may be singular."""

import numpy as np
from numpy.typing import NDArray

__all__ = ["PIVOT", "solve_across", "solve_stack"]

Floats = NDArray[np.float64]

_SMALL = 12
"""Unknowns up to which a stack is eliminated at once: one by one takes four times as long."""

_AT_ONCE = 512
"""Systems that are eliminated together: so many stay in the cache of a core."""

PIVOT = 0.3
"""Pivot of a matrix of order one below which LAPACK exchanges rows: each that is smaller takes
digits, which a stiffness beside buckling does not have to spare."""


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


def solve_across(A: Floats, b: Floats) -> Floats:
    """Return x of ``A x = b`` for a stack whose last axis runs over the systems.

    Small systems are eliminated in many matrices at once, without exchanging rows; where a pivot
    is small, and where systems are large, LAPACK solves. The digits of a system hang on no other.

    Parameters
    ----------
    A : array, shape (p, n, n, designs)
        Matrices of order one with a large diagonal, mostly.
    b : array, shape (p, n, m, designs)
        Right-hand sides.

    Returns
    -------
    array, shape (p, n, m, designs)
        Solutions; NaN where a matrix is singular.

    Examples
    --------
    >>> A = np.array([[2.0, 1.0], [1.0, 3.0]])[None, :, :, None]
    >>> solve_across(A, np.array([[5.0], [10.0]])[None, :, :, None]).ravel().tolist()
    [1.0, 3.0]

    """
    n = A.shape[1]
    if n > _SMALL:
        x = solve_stack(A.transpose(0, 3, 1, 2), b.transpose(0, 3, 1, 2))
        return np.asarray(x.transpose(0, 2, 3, 1))
    x = np.empty(b.shape)
    for first in range(0, b.shape[3], _AT_ONCE):
        some = slice(first, first + _AT_ONCE)
        x[..., some] = _eliminated(A[..., some], b[..., some])
    return x


def _eliminated(A: Floats, b: Floats) -> Floats:
    """Return x by Gauss and Jordan's elimination of all systems at once."""
    n = A.shape[1]
    T = np.concatenate([A, b], axis=2)
    pivots = np.empty((n, A.shape[0], A.shape[3]))
    with np.errstate(all="ignore"):  # a pivot of zero spoils its own system, which LAPACK solves
        for k in range(n):
            pivots[k] = T[:, k, k]
            row = T[:, k, k + 1 :] / pivots[k][:, None]
            T[:, :, k + 1 :] -= T[:, :, k, None] * row[:, None]
            T[:, k, k + 1 :] = row
    x = T[:, :, n:]
    small = ~(np.abs(pivots).min(axis=0) > PIVOT)
    if small.any():
        i, j = np.nonzero(small)
        x[i, :, :, j] = solve_stack(A[i, :, :, j], b[i, :, :, j])
    return x
