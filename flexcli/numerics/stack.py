"""Linear systems for many designs at once, of which some may be singular."""

import numpy as np
from numpy.typing import NDArray

__all__ = ["solve_stack"]

Floats = NDArray[np.float64]


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
